//! `asperity unload`: opening from the closest approach.

use anyhow::{Context, Result, bail};
use asperity::bem::Bem;
use asperity::joints::{Joint, Unloading, UnloadingLaw};
use asperity::{At, ContactError, Evaluation, SeparationUnit, Tolerance, linspace};
use asperity_plot::{Axis, Curve};
use clap::Args;
use clap::error::ErrorKind;

use crate::commands::{history, unload_bem};
use crate::input::args::{Closed, DrawnArgs, separation_unit, tolerance};
use crate::input::distances::{Distances, turning_separations, warn_unit};
use crate::input::lists::{Numbers, turning_loads};
use crate::joints::{COLUMNS, READ_0, marked, named, picture, warn_energy_gain};
use crate::output::number::rounded;
use crate::output::plot;
use crate::output::table::{Cell, Table};
use crate::output::{once, print_message};
use crate::scene::{LoadedScene, NamedModel};

/// Number of default retreats, and the least number of points in a plot.
const POINTS: usize = 101;

/// Force, area and stiffness as a joint opens again, or through a history of loads
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "The joint has been closed for the first time up to --closest, --load or
--pressure, and opens by the retreats (default: to the end of contact).
Columns: model, law, retreat_m, separation_over_sigma, force_N, pressure_Pa, area_m2
(not by etsion), stiffness_N_per_m (-dF/dd), contacts (asperities that still touch;
below 1 most surfaces have parted, and values are averages over many surfaces).
hertz: as a Hertzian contact with the force and area at the closest approach; brake:
Brake 2015, whose area jumps at the start (at retreat 0 the columns have the values after
the jump); etsion: Etsion, Kligerman & Kadin 2005.
Coming closer again retraces these curves, and then follows the virgin one: the energy is
dissipated in the first cycle only. The loss factor is the energy dissipated over 2 pi
times the work of closing; that of slip is another one, per cycle.
--history takes a new joint through turning points instead, from the first;
columns: model, law, way, separation_over_sigma, separation_m, force_N, pressure_Pa,
stiffness_N_per_m; a note gives the work of each way.
bem opens the scan along its own path: contact shrinks on the surface that yielding has
left, and the stiffness is that at fixed contact (columns without contacts; law is own).
Otherwise models of equal, upright asperities with circular contacts only, without adhesion;
to open a joint with jkr adhesion, use the model jkr-separation.

Examples:
  asperity unload scene.toml --model ke --closest 1 --retreat 0:0.5:6 --format table
  asperity unload scene.toml --model zmc --law hertz,brake,etsion --load 100 --retreat 0:100nm:11
  asperity unload scene.toml --model ke --pressure 5MPa --output back.csv --plot back.svg
  asperity unload scan.toml --model bem --pressure 50MPa --retreat 0:100nm:11
  asperity unload scene.toml --model ke --history-load 10,2000,500,3000,10 --output cycle.csv"
)]
pub struct Unload {
    #[command(flatten)]
    closed: Closed,
    /// Unloading laws of the asperities: hertz, brake, etsion, or several
    #[arg(long = "law", value_name = "LAW", default_value = "hertz", value_delimiter = ',')]
    laws: Vec<UnloadingLaw>,
    /// Retreats from the closest approach, in units of asperity_height_std (sigma), or with a unit,
    /// for example 0:100nm:11
    #[arg(long, value_name = "A:B:N[:log]|v,v")]
    retreat: Option<Distances>,
    /// Unit of retreats and turning points given without one: sigma (asperity_height_std) or m
    #[arg(long = "retreat-unit", value_name = "UNIT", value_parser = separation_unit)]
    #[arg(default_value = "sigma")]
    unit: SeparationUnit,
    /// Turning points as separations, in sigma, or with a unit, for example 2um
    #[arg(long, value_name = "v,v", group = "place", conflicts_with = "retreat")]
    #[arg(value_parser = turning_separations)]
    history: Option<Distances>,
    /// Turning points as loads in N, or with a unit, for example 2kN
    #[arg(long, value_name = "v,v", group = "place", conflicts_with = "retreat")]
    #[arg(value_parser = turning_loads)]
    history_load: Option<Numbers>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    tolerance: Tolerance,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Unload {
    pub fn run(self) -> Result<()> {
        self.output.check("unload");
        let (scene, model) = self.closed.open()?;
        if model.0 == Bem::ID {
            return self.back_by_elements(&scene, &model);
        }
        let turns = self.turns(&scene);
        let place = match turns {
            None => Some(self.place(&scene, &model)),
            Some(_) => None,
        };
        let mut joints = vec![];
        for law in once(&self.laws) {
            let joint = Joint::new(&model.1, &scene.file.scene, law, self.tolerance);
            joints.push(joint.with_context(|| named(&scene, &model))?);
        }
        match (turns, place) {
            (Some(turns), _) => {
                scene.report_answers(&[&model], &turns);
                history::write(&scene, &model, &joints, &turns, &self.output)
            }
            (None, Some(place)) => self.back(&scene, &model, &joints, place),
            (None, None) => Ok(()),
        }
    }

    /// Writes the opening of a scan along its own path.
    fn back_by_elements(&self, scene: &LoadedScene, model: &NamedModel) -> Result<()> {
        let refuse =
            |text: &str| crate::input::usage_error("unload", ErrorKind::ArgumentConflict, text);
        if self.laws != [UnloadingLaw::Hertz] {
            refuse("bem follows the contact itself; leave out --law");
        }
        if self.history.is_some() || self.history_load.is_some() {
            refuse("bem opens from one load; use --load, --pressure or --closest");
        }
        let place = self.place(scene, model);
        let retreats = match &self.retreat {
            Some(_) => Some(self.retreats(scene, None)?),
            None => None,
        };
        let table = unload_bem::table(scene, place, retreats)?;
        self.output.write(&table, || {
            let x = Axis::new("retreat_m", "retreat (µm)").times(1e6);
            let mut by_law = table.clone();
            by_law.head.remove(0);
            by_law.rows.iter_mut().for_each(|row| drop(row.remove(0)));
            plot::against(&by_law, &x, &COLUMNS, &[Curve::new(0, "own", "bem, back")])
        })
    }

    /// The closest approach; several are a usage error.
    fn place(&self, scene: &LoadedScene, model: &NamedModel) -> At {
        let [place] = self.closed.places(scene, model)[..] else {
            let text = "give one closest approach, --load or --pressure; --history and --history-load take several";
            crate::input::usage_error("unload", ErrorKind::TooManyValues, text)
        };
        place
    }

    fn turns(&self, scene: &LoadedScene) -> Option<Vec<At>> {
        let separations = self.history.as_ref().map(|list| {
            let unit = list.unit(self.unit);
            let height_std = scene.file.scene.surface.asperity_height_std;
            warn_unit("history", &list.values, unit, height_std);
            list.values.iter().map(|value| scene.file.separation(*value, unit).into()).collect()
        });
        let loads =
            || Some(self.history_load.as_ref()?.0.iter().map(|load| At::Load(*load)).collect());
        separations.or_else(loads)
    }

    /// Writes the opening from one closest approach by each law.
    fn back(
        &self,
        scene: &LoadedScene,
        model: &NamedModel,
        joints: &[Joint],
        place: At,
    ) -> Result<()> {
        let context = || named(scene, model);
        let (mut ways, mut ends) = (vec![], vec![]);
        for joint in joints {
            let way = joint.unloading(place).with_context(context)?;
            if way.force(0.0).with_context(context)?.value() == 0.0 {
                let (joint, at) = (context(), way.closest());
                bail!("{joint}: nothing touches at a separation of {at}; choose a smaller one");
            }
            let end = way.last_contact();
            report_work((scene, &model.0), joint, place, &end);
            // Only a default depends on the end of contact.
            ends.extend(end.ok());
            ways.push(way);
        }
        let laws: Vec<_> = joints.iter().map(Joint::law).collect();
        if laws.contains(&UnloadingLaw::Brake) {
            let text = "brake: the area jumps at the start; the row of retreat 0 has the area after the jump";
            print_message("note", text);
        }
        if laws.len() > 1 && laws.contains(&UnloadingLaw::Etsion) {
            print_message("note", "etsion: area_m2 is blank, as this law gives no area");
        }
        let retreats = self.retreats(scene, ends.iter().copied().reduce(f64::max))?;
        let of = |retreats: &[f64]| tabulate(scene, model, &ways, retreats).with_context(context);
        let (table, warnings) = of(&retreats)?;
        warnings
            .iter()
            .for_each(|text| print_message("warning", &format!("{}: {text}", scene.name)));
        self.output.write(&table, || {
            let [least, most] = [f64::min, f64::max]
                .map(|pick| retreats.iter().copied().reduce(pick).unwrap_or_default());
            let mut dense = if least < most { linspace(least, most, 2 * POINTS) } else { vec![] };
            dense.extend(&retreats);
            dense.sort_by(f64::total_cmp);
            dense.dedup();
            let x = Axis::new("retreat_m", "retreat (µm)").times(1e6);
            let mut drawn = of(&dense)?.0;
            if retreats.len() <= plot::MARKED {
                drawn.rows.extend(table.rows.iter().map(|row| marked(row)));
            }
            picture(&drawn, &x, &model.0, joints)
        })
    }

    /// The retreats in metres, by default up to the end of contact.
    fn retreats(&self, scene: &LoadedScene, end: Option<f64>) -> Result<Vec<f64>> {
        let Some(given) = &self.retreat else {
            let end = end.context("the end of contact was not found; give --retreat")?;
            return Ok(if end > 0.0 { linspace(0.0, end, POINTS) } else { vec![0.0] });
        };
        let sigma = scene.file.scene.surface.asperity_height_std;
        let unit = given.unit(self.unit);
        warn_unit("retreat", &given.values, unit, sigma);
        let metres = if unit == SeparationUnit::Sigma { sigma } else { 1.0 };
        Ok(given.values.iter().map(|value| metres * value).collect())
    }
}

/// Reports the work of closing and opening, and the end of contact.
fn report_work(
    (scene, id): (&LoadedScene, &str),
    joint: &Joint,
    place: At,
    end: &Result<f64, ContactError>,
) {
    let law = joint.law();
    let works = || -> Result<[f64; 3], ContactError> {
        let work = joint.work(place)?;
        warn_energy_gain(scene, joint, place, &work)?;
        let lost = work.lost();
        // A loss below its error is 0.
        Ok(match lost.relative_error() < 1.0 {
            true => [work.spent.value(), lost.value(), work.loss_factor()?],
            false => [work.spent.value(), 0.0, 0.0],
        })
    };
    match works() {
        Ok(works) => {
            let [spent, lost, factor] = works.map(rounded);
            print_message(
                "note",
                &format!(
                    "{id} by {law}: closing takes {spent} J, of which {lost} J are dissipated in the first cycle (loss factor {factor})"
                ),
            );
        }
        Err(error) => {
            print_message("warning", &format!("{id} by {law}: the work is unavailable: {error}"))
        }
    }
    let end = match end {
        Ok(end) => *end,
        Err(error) => {
            let text = "the end of contact was not found";
            return print_message("note", &format!("{id} by {law}: {text}: {error}"));
        }
    };
    if end == 0.0 {
        let text = "even at the closest approach, fewer than one asperity touches on average";
        return print_message("warning", &format!("{id} by {law}: {text}"));
    }
    let end = rounded(end);
    print_message(
        "note",
        &format!(
            "{id} by {law}: contact ends at a retreat of {end} m, beyond which fewer than one asperity touches on average"
        ),
    );
}

/// The table, with warnings of blanks and zeros for each law.
fn tabulate(
    scene: &LoadedScene,
    (id, _): &NamedModel,
    ways: &[Unloading],
    retreats: &[f64],
) -> Result<(Table, Vec<String>), ContactError> {
    let (contact, from) = (&scene.file.scene, scene.file.separation_from);
    let sigma = contact.surface.asperity_height_std;
    let has_area = |way: &Unloading| way.law() != UnloadingLaw::Etsion;
    let with_area = ways.iter().any(has_area);
    let head = ["model", "law", "retreat_m", "separation_over_sigma", "force_N", "pressure_Pa"];
    let area: &[&str] = if with_area { &["area_m2"] } else { &[] };
    let mut table = Table::new(&[&head[..], area, &["stiffness_N_per_m", "contacts"]].concat());
    let mut warnings = vec![];
    for way in ways {
        let (mut reason, mut zero) = (None, None::<f64>);
        let closest = way.closest().measured_in(SeparationUnit::Sigma, from, contact)?.value;
        for &retreat in retreats {
            let mut value = |found: Result<Evaluation, ContactError>| match found {
                Ok(found) => Ok(Some(found.value())),
                Err(error @ ContactError::Integral { .. }) => {
                    reason.get_or_insert(error);
                    Ok(None)
                }
                Err(error) => Err(error),
            };
            let force = value(way.force(retreat))?;
            let mut numbers = vec![
                Some(retreat),
                Some(closest + retreat / sigma),
                force,
                force.map(|force| force / contact.nominal_area),
            ];
            if with_area {
                numbers.push(if has_area(way) { value(way.area(retreat))? } else { None });
            }
            numbers.extend([value(way.stiffness(retreat))?, value(way.contacts(retreat))?]);
            if numbers[2..].contains(&Some(0.0)) {
                zero = Some(zero.map_or(retreat, |least| least.min(retreat)));
            }
            let mut row = vec![Cell::from(&**id), Cell::from(&*way.law().to_string())];
            row.extend(numbers.into_iter().map(Cell::Number));
            table.rows.push(row);
        }
        let context = format!("{id} by {}", way.law());
        warnings.extend(reason.map(|error| format!("{context}: a value is blank: {error}")));
        warnings.extend(zero.map(|from| {
            let from = rounded(from);
            format!("{context}: from a retreat of {from} m on, values {READ_0}")
        }));
    }
    Ok((table, warnings))
}
