//! `asperity slip`: tangential force against shift.

use anyhow::{Context, Result, bail};
use asperity::joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity::{At, ContactError, Model, Tolerance, linspace, shortest_digits};
use asperity_plot::{Axis, Curve};
use clap::Args;

use crate::input::args::{Closed, DrawnArgs, tolerance};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{count_up_to, friction, length, load};
use crate::joints::amplitude_at;
use crate::output::number::{rounded, within};
use crate::output::plot;
use crate::output::print_message;
use crate::output::table::{Cell, Table};
use crate::scene::LoadedScene;

/// Share of μ F that defines the start of gross slip.
pub(super) const SLIDING: f64 = 0.99;
/// Larger coefficients of friction are unlikely.
const LARGEST_FRICTION: f64 = 2.0;
/// Shifts of a loop by default.
const POINTS: usize = 101;

/// Amplitudes above this multiple of the shift of gross slip are probably in another unit.
const FAR: f64 = 1000.0;
/// Amplitudes above this multiple of asperity_height_std are refused: other asperities would meet
/// in every cycle.
const FARTHEST: f64 = 1e6;

/// Tangential force against shift: first loading, and a steady cycle
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "Slip assumes a constant separation. Columns: model, shift_m, force_N at a first shift
(blank below 0), back_N and forth_N in a steady cycle between -amplitude and
+amplitude (Masing); loss_J and loss_factor of a cycle whose amplitude is this shift:
energy dissipated per cycle, and loss factor = energy / (pi x force x shift), 4/pi in gross
slip. A note gives the shift of gross slip, at which 99 % of mu F is reached.
With several loads, pressures or closest approaches (100:1e4:20:log, v,v): one row for each
and a cycle of the amplitude, with columns model, load_N, pressure_Pa,
separation_over_sigma, force_N at the amplitude, secant_stiffness_N_per_m (that over the
amplitude), loss_J, loss_factor, sliding_m (the shift of gross slip). Rows without a result
are blank; the reason is printed.
With --tangential-force the amplitude is that of the force: one force at one preload gives
the loop, several of either one row for each, with columns tangential_force_N, amplitude_m,
secant_stiffness_N_per_m, loss_J and loss_factor; beyond mu F the joint slides.
Partial slip of every asperity (Cattaneo, Mindlin), which answers as elastically as in
unloading by --law: exact for gw; for models that yield, at constant normal load on each.
Needs equivalent_shear_modulus, or the bodies. Models of equal, upright asperities only.

Examples:
  asperity slip scene.toml --model gw --friction 0.2 --pressure 5e6 --amplitude 1e-7
  asperity slip scene.toml --model ke --friction 0.3 --closest 2 --amplitude 1e-6 --points 11 --format table
  asperity slip scene.toml --model ke --friction 0.3 --load 100:1e4:20:log --amplitude 100nm
  asperity slip scene.toml --model ke --friction 0.3 --load 100 --amplitude 2e-7 --output loop.csv --plot loop.svg
  asperity slip scene.toml --model ke --friction 0.3 --load 100N,1kN --tangential-force 1N:25N:20:log"
)]
pub struct Slip {
    #[command(flatten)]
    closed: Closed,
    /// Unloading law of the asperities: hertz, brake or etsion
    #[arg(long, value_name = "LAW", default_value = "hertz")]
    law: UnloadingLaw,
    /// Coefficient of friction, for example 0.2 or 20%
    #[arg(long, alias = "mu", value_name = "MU", value_parser = friction)]
    friction: f64,
    #[command(flatten)]
    cycle: Cycle,
    /// Number of shifts from -amplitude to +amplitude of one cycle [default: 101]
    #[arg(long, value_name = "N", value_parser = count_up_to(100_000))]
    points: Option<usize>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    tolerance: Tolerance,
    #[command(flatten)]
    pub(super) output: DrawnArgs,
}

/// The amplitude of a cycle: a shift, or tangential forces.
#[derive(Debug, Args)]
#[group(id = "cycle", required = true, multiple = false)]
struct Cycle {
    /// Largest shift, in m, or with a unit, for example 100nm
    #[arg(long, value_name = "M", value_parser = length)]
    amplitude: Option<f64>,
    /// Amplitudes of the tangential force instead of the shift: in N, or with a unit, for example
    /// 10N:500N:20:log
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(load))]
    tangential_force: Option<Numbers>,
}

impl Cycle {
    fn amplitude(&self) -> Amplitude<'_> {
        match (self.amplitude, &self.tangential_force) {
            (Some(shift), _) => Amplitude::Shift(shift),
            (None, forces) => Amplitude::Forces(forces.as_ref().map_or(&[], |list| &list.0)),
        }
    }
}

/// What a cycle is given by.
enum Amplitude<'c> {
    /// A shift \[m\].
    Shift(f64),
    /// Tangential forces \[N\].
    Forces(&'c [f64]),
}

impl Slip {
    pub fn run(self) -> Result<()> {
        self.output.check("slip");
        let (scene, named) = self.closed.open()?;
        self.check_limit(&scene)?;
        self.check_friction();
        let context = || format!("{}: {}", scene.name, named.0);
        let places = self.closed.places(&scene, &named);
        match (&places[..], self.cycle.amplitude()) {
            ([place], Amplitude::Shift(shift)) => {
                let joint = self.joint(&scene, &named.1, *place).with_context(context)?;
                self.loops(&scene, &named.0, &joint, shift)
            }
            ([place], Amplitude::Forces([force])) => {
                let joint = self.joint(&scene, &named.1, *place).with_context(context)?;
                let shift = amplitude_at(&joint.1, *force).with_context(context)?;
                self.loops(&scene, &named.0, &joint, shift)
            }
            (places, Amplitude::Shift(shift)) => {
                self.note_points();
                self.preloads(&scene, &named, places, shift)
            }
            (places, Amplitude::Forces(forces)) => {
                self.note_points();
                self.forces(&scene, &named, places, forces)
            }
        }
        .with_context(context)
    }

    /// Notes that several cycles have one row each.
    fn note_points(&self) {
        if let Some(points) = self.points {
            let text = format!("--points {points} is not used: several cycles have one row each");
            print_message("note", &text);
        }
    }

    /// Warns of a coefficient of friction that is probably in per cent.
    fn check_friction(&self) {
        if self.friction > LARGEST_FRICTION {
            let given = rounded(self.friction);
            let text = format!(
                "--friction is {given}, and dry contacts have at most about 1.5; {given} % is written {given}%"
            );
            print_message("warning", &text);
        }
    }

    /// Refuses an amplitude that is no partial slip.
    fn check_limit(&self, scene: &LoadedScene) -> Result<()> {
        let most = FARTHEST * scene.file.scene.surface.asperity_height_std;
        if let Some(amplitude) = self.cycle.amplitude.filter(|amplitude| *amplitude > most) {
            bail!(
                "--amplitude is {} m: at most {} m, 1e6 asperity_height_std, were required, as partial slip is far smaller; write it with its unit, for example 100nm",
                shortest_digits(amplitude),
                rounded(most)
            )
        }
        Ok(())
    }

    /// A result with the digits of the tolerance.
    pub(super) fn digits(&self, x: f64) -> f64 {
        within(x, self.tolerance)
    }

    pub(super) fn joint(
        &self,
        scene: &LoadedScene,
        model: &Model,
        place: At,
    ) -> Result<(Unloading, PartialSlip), ContactError> {
        let joint = Unloading::new(model, &scene.file.scene, place, self.law, self.tolerance)?;
        let slip = PartialSlip::new(&joint, self.friction)?;
        Ok((joint, slip))
    }

    /// The first shift and a steady cycle at one preload.
    fn loops(
        &self,
        scene: &LoadedScene,
        id: &str,
        (joint, slip): &(Unloading, PartialSlip),
        amplitude: f64,
    ) -> Result<()> {
        // First, so that the error for a tiny amplitude names the amplitude.
        let loss = rounded(slip.loss(amplitude)?.value());
        let factor = rounded(slip.loss_factor(amplitude)?);
        let mut table = Table::new(&[
            "model",
            "shift_m",
            "force_N",
            "back_N",
            "forth_N",
            "loss_J",
            "loss_factor",
        ]);
        for shift in linspace(-amplitude, amplitude, self.points.unwrap_or(POINTS)) {
            let first = |of: &dyn Fn() -> Result<f64, ContactError>| -> Result<_, ContactError> {
                if shift < 0.0 { Ok(None) } else { of().map(Some) }
            };
            let [back, forth] = [false, true].map(|f| slip.loop_force(shift, amplitude, f));
            let factor = || if shift > 0.0 { slip.loss_factor(shift) } else { Ok(0.0) };
            let numbers = [
                Some(shift),
                first(&|| Ok(slip.force(shift)?.value()))?,
                Some(back?),
                Some(forth?),
                first(&|| Ok(slip.loss(shift)?.value()))?,
                first(&factor)?,
            ];
            let mut row = vec![Cell::from(id)];
            row.extend(numbers.map(|number| Cell::Number(number.map(|x| self.digits(x)))));
            table.rows.push(row);
        }
        print_message(
            "note",
            &format!("{id}: a cycle of this amplitude dissipates {loss} J (loss factor {factor})"),
        );
        let sliding = slip.shift_at(SLIDING)?;
        check_amplitude(scene, amplitude, sliding);
        let limit = self.friction * joint.force(0.0)?.value();
        let (percent, sliding, limit) = (100.0 * SLIDING, rounded(sliding), rounded(limit));
        let text = format!(
            "{id}: gross slip begins at a shift of {sliding} m, where {percent} % of mu F = {limit} N is reached"
        );
        print_message("note", &text);
        self.output.write(&table, || picture(&table))
    }
}

/// Warns of an amplitude far beyond the shift of gross slip or the heights of the asperities.
pub(super) fn check_amplitude(scene: &LoadedScene, amplitude: f64, sliding: f64) {
    let height_std = scene.file.scene.surface.asperity_height_std;
    let beyond = [(sliding, "the shift of gross slip"), (height_std, "asperity_height_std")];
    let beyond = beyond.iter().filter(|(length, _)| amplitude > FAR * length);
    let times = |(length, name): &(f64, &str)| format!("{:.0e} times {name}", amplitude / length);
    let beyond: Vec<String> = beyond.map(times).collect();
    if !beyond.is_empty() {
        print_message(
            "warning",
            &format!(
                "amplitude is {} m, {}; write lengths with their unit, for example 100nm",
                shortest_digits(amplitude),
                beyond.join(" and ")
            ),
        );
    }
}

/// The plot of the first shift and the whole loop.
fn picture(table: &Table) -> Result<String> {
    let mut long = Table::new(&["curve", "shift_m", "force_N"]);
    // The loop: forth from the left, back from the right.
    let forth = table.rows.iter().map(|row| ("loop", &row[1], &row[4]));
    let back = table.rows.iter().rev().map(|row| ("loop", &row[1], &row[3]));
    let first = table.rows.iter().map(|row| ("first", &row[1], &row[2]));
    for (curve, shift, force) in first.chain(forth).chain(back) {
        if *force != Cell::Number(None) {
            long.rows.push(vec![curve.into(), shift.clone(), force.clone()]);
        }
    }
    let x = Axis::new("shift_m", "shift (nm)").times(1e9);
    let curves = [Curve::new(0, "first", "first shift"), Curve::new(2, "loop", "steady cycle")];
    plot::against(&long, &x, &[("force_N", "tangential force (N)")], &curves)
}
