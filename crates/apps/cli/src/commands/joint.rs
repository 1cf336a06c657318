//! `asperity joint`: a closed joint that opens, follows a history of loads, or slips.

use std::path::PathBuf;

use anyhow::Result;
use asperity::bem::Bem;
use asperity::joints::UnloadingLaw;
use asperity::{At, Described, Model, SeparationUnit, Tolerance};
use asperity_answer::{Amplitude, Sheet, Slip, history, of_joint, unloading};
use asperity_plot::draw_map;
use clap::Args;

use crate::input::args::{DrawnArgs, EndArgs, file_ending, loads, model_id};
use crate::input::distances::{Distances, warn_unit};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{count_up_to, friction, length, load, pressure};
use crate::input::{refuse, usage_error};
use crate::interrupt::listen;
use crate::output::plot::Plot;
use crate::output::{self, contact_map, once};
use crate::scene::LoadedScene;

/// Shifts of a loop by default, and on a scan, where each is solved.
const POINTS: [usize; 2] = [101, 21];

/// A joint that opens, follows a history of loads or, with --friction, slips
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/joint.txt"))]
pub struct Joint {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Model by id, as listed by `asperity list models` [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    model: Option<String>,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    place: Closed,
    /// Take a new joint through the separations, loads or pressures as turning points
    #[arg(long, conflicts_with = "retreat")]
    history: bool,
    /// Unloading laws of the asperities: hertz, brake, etsion, or several
    #[arg(long = "law", value_name = "LAW", default_value = "hertz", value_delimiter = ',')]
    laws: Vec<UnloadingLaw>,
    /// Retreats from the closest approach, in units of asperity_height_std (sigma), or with a unit,
    /// for example 0:100nm:11
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = retreats)]
    retreat: Option<Distances>,
    /// Coefficient of friction, for example 0.2: the joint slips
    #[arg(long, value_name = "MU", value_parser = friction, requires = "cycle")]
    #[arg(conflicts_with_all = ["retreat", "history"])]
    friction: Option<f64>,
    #[command(flatten)]
    cycle: Cycle,
    /// Number of shifts from -amplitude to +amplitude of one cycle [default: 101; 21 by bem]
    #[arg(long, value_name = "N", value_parser = count_up_to(100_000), requires = "friction")]
    points: Option<usize>,
    /// Write which pixels stick (2) and slip (1) at the amplitude of one cycle, by bem; npy is a
    /// NumPy matrix
    #[arg(long, value_name = "FILE.npy|svg", requires = "amplitude")]
    #[arg(value_parser = file_ending(&["npy", "svg"], "maps are written as npy or svg"))]
    stick_map: Option<PathBuf>,
    #[command(flatten)]
    output: DrawnArgs,
}

/// The closest approach or the largest load; several with --friction and --history.
#[derive(Debug, Args)]
#[group(id = "place", required = true, multiple = false)]
struct Closed {
    /// Closest approach, in units of asperity_height_std (sigma), or with a unit, for example 2um
    #[arg(long, value_name = "D[,D]")]
    closest: Option<Distances>,
    /// Largest load, in N, or with a unit, for example 2kN
    #[arg(long, value_name = "P[,P]", value_parser = all(load))]
    load: Option<Numbers>,
    /// Largest load as a pressure on the nominal area, in Pa, or with a unit, for example 5MPa
    #[arg(long, value_name = "P[,P]", value_parser = all(pressure))]
    pressure: Option<Numbers>,
}

/// The amplitude of a cycle: a shift, or tangential forces.
#[derive(Debug, Args)]
#[group(id = "cycle", multiple = false, requires = "friction")]
struct Cycle {
    /// Largest shift, in m, or with a unit, for example 100nm
    #[arg(long, value_name = "M", value_parser = length)]
    amplitude: Option<f64>,
    /// Amplitudes of the tangential force instead of the shift: in N, or with a unit, for example
    /// 10N:500N:20:log
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(load))]
    tangential_force: Option<Numbers>,
}

/// Distances back from the closest approach.
fn retreats(text: &str) -> Result<Distances, String> {
    let found: Distances = text.parse()?;
    let closer = found.value.iter().find(|retreat| **retreat < 0.0);
    closer.map_or(Ok(found.clone()), |closer| Err(format!("{closer} is below 0")))
}

impl Closed {
    /// The closest approaches, largest loads or turning points; prints the findings there.
    fn all(&self, scene: &LoadedScene, model: &Model) -> Vec<At> {
        let mut places: Vec<At> = loads(&self.load, &self.pressure).collect();
        if let Some(list) = &self.closest {
            let height_std = scene.file.scene.surface.asperity_height_std;
            warn_unit("closest", &list.value, list.unit, height_std);
            let place = |value: &f64| At::from(scene.file.separation(*value, list.unit));
            places.extend(list.value.iter().map(place));
        }
        scene.report(scene.file.judge(model, None, &places));
        places
    }
}

impl Joint {
    pub fn run(self) -> Result<()> {
        let ids = self.model.as_slice();
        let scene = LoadedScene::load(&self.scene, ids)?.taken_at(&self.end)?;
        let model = scene.one_or_usual(self.model.as_deref())?;
        let (laws, is_scan) = (once(&self.laws), model.id() == Bem::ID);
        let has_law = laws != [UnloadingLaw::Hertz];
        refuse([
            (is_scan && has_law, "bem follows the contact itself; leave out --law"),
            (is_scan && self.history, "bem opens from one load; leave out --history"),
            (self.friction.is_some() && laws.len() > 1, "slip follows one law; give one --law"),
        ]);
        let places = self.place.all(&scene, &model);
        let at = places.first().copied().unwrap_or(At::from(2.0));
        let model = scene.answer(|sheet, _| of_joint(&scene.file, model, at, sheet))?.1;
        let is_map_of_none = self.stick_map.is_some() && (!is_scan || places.len() > 1);
        refuse([(is_map_of_none, "--stick-map needs --model bem and one load")]);
        let subject = scene.subject(&model, Tolerance::default());
        if let Some(friction) = self.friction {
            return self.slip(&scene, &Slip { subject, law: laws[0], friction }, &places);
        }
        if self.history {
            let (sheet, ()) = scene.answer(|sheet, _| history(&subject, &laws, &places, sheet))?;
            let from = scene.file.plane();
            let columns = ["force_N", "stiffness_N_per_m"];
            let plot = Plot::new(&["model", "law"], "separation_m", &columns).from(from);
            return self.output.write(&sheet, || plot.svg(&sheet));
        }
        let [closest] = places[..] else {
            usage_error("give one closest approach, --load or --pressure; --history takes several")
        };
        let retreats = self.retreat.as_ref().map(|list| (&list.value[..], list.unit));
        listen()?;
        let (sheet, ()) = scene
            .answer(|sheet, watch| unloading(&subject, &laws, closest, retreats, sheet, watch))?;
        let columns = ["force_N", "area_m2", "stiffness_N_per_m"];
        let plot = Plot::new(&["model", "law"], "retreat_m", &columns);
        self.output.write(&sheet, || plot.svg(&sheet))
    }

    fn slip(&self, scene: &LoadedScene, slip: &Slip<'_>, preloads: &[At]) -> Result<()> {
        let height_std = scene.file.scene.surface.asperity_height_std;
        let (shift, metres) = (self.cycle.amplitude.as_slice(), SeparationUnit::Metres);
        warn_unit("amplitude", shift, metres, height_std);
        let forces = self.cycle.tangential_force.iter().flat_map(|list| &list.0);
        let forces = forces.copied().map(Amplitude::Force);
        let amplitudes = self.cycle.amplitude.map(Amplitude::Shift).into_iter().chain(forces);
        let amplitudes: Vec<Amplitude> = amplitudes.collect();
        let is_scan = slip.subject.id() == Bem::ID;
        let points = self.points.unwrap_or(POINTS[usize::from(is_scan)]);
        listen()?;
        let (sheet, states) = scene
            .answer(|sheet, watch| slip.answer(preloads, &amplitudes, points, sheet, watch))?;
        if let Some(path) = &self.stick_map {
            let scan = scene.bem()?;
            if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("npy")) {
                contact_map::write(path, &[&states], scan.map().shape())?;
            } else {
                let map = contact_map::stick_picture(&scan, &states, &scene.name);
                output::write_text(Some(path), &draw_map(&map)?)?;
            }
        }
        self.output.write(&sheet, || {
            if sheet.column("shift_m").is_some() {
                let plot = Plot::new(&["path"], "shift_m", &["tangential_force_N"]);
                return plot.svg(&paths(&sheet));
            }
            let columns = ["secant_stiffness_N_per_m", "loss_J", "loss_factor"];
            match self.cycle.amplitude {
                Some(_) => Plot::new(&["model"], "load_N", &columns),
                None => Plot::new(&["model", "load_N"], "tangential_force_N", &columns),
            }
            .svg(&sheet)
        })
    }
}

/// The first shift and both ways of a loop below each other.
fn paths(sheet: &Sheet) -> Sheet {
    let mut long = Sheet::new(&["path", "shift_m", "tangential_force_N"]);
    for (k, path) in [(2, "first shift"), (3, "back"), (4, "forth")] {
        let rows = sheet.rows.iter().map(|row| vec![path.into(), row[1].clone(), row[k].clone()]);
        long.rows.extend(rows);
    }
    long
}
