//! `asperity bem`: boundary elements on the scan of a scene.

use std::path::PathBuf;

use anyhow::Result;
use asperity::Quantity;
use asperity::bem::{Bem, LoadCase, Solution};
use asperity_answer::{Press, sealing};
use asperity_plot::draw_map;
use clap::error::ErrorKind;
use clap::{ArgAction, Args};

use crate::input::args::{EndArgs, OutputArgs, PressArgs, file_ending, svg_file};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{load, pressure};
use crate::input::usage_error;
use crate::interrupt::{self, terminal};
use crate::output::{self, contact_map, show};
use crate::scene::LoadedScene;

/// Boundary elements on the scan of a scene, without asperities: contacts, leaks, sealing pressures
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../help/bem.txt")
)]
pub struct BemCommand {
    /// Scene file that names a scan
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    places: Places,
    #[command(flatten)]
    press: PressArgs,
    /// Add tangent (or stiffness, the same: the slope of first loading; where contacts yield the
    /// chord between pressures up to 5 % to either side, by two more solutions), quantities of
    /// joints (unloading-stiffness, tangential-stiffness, thermal-conductance,
    /// electrical-conductance, each also with -per-area at its end), flows through the gap
    /// (hydraulic-gap-x, hydraulic-gap-y, effective-medium-gap), the leak of a liquid or gas
    /// through [seal] of the scene (leak), or any other that follows from load and area
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    quantities: Vec<Quantity>,
    /// Samples of --sealing-pressure, the scan and surfaces of its spectrum and heights [default:
    /// 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=1000))]
    samples: Option<u16>,
    /// Add the results on every second pixel, to show their dependence on the grid
    #[arg(long)]
    refine: bool,
    /// Write the pressures in Pa as a NumPy matrix, stacked for several loads
    #[arg(long, value_name = "FILE.npy", value_parser = file_ending(&["npy"], NPY))]
    map: Option<PathBuf>,
    /// Draw a map of the contact pressure at one load
    #[arg(long, value_name = "FILE.svg", value_parser = svg_file())]
    picture: Option<PathBuf>,
    /// Draw the flow along x through the gap at one load
    #[arg(long, value_name = "FILE.svg", value_parser = svg_file())]
    flow_picture: Option<PathBuf>,
    #[command(flatten)]
    output: OutputArgs,
}

/// Samples of a sealing pressure.
const SAMPLES: u16 = 8;
/// How maps are written.
const NPY: &str = "matrices are written in NumPy format";

/// The loads to solve.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Places {
    /// Pressures on the nominal area, in Pa: N from A to B, in equal steps or (log) ratios, or
    /// v,v,...
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = all(pressure))]
    #[arg(action = ArgAction::Append)]
    pressures: Vec<Numbers>,
    /// Pressures at which the last open path along x and along y closes, over several samples of
    /// the surface: lowest, middle and highest, since one scan is one of many
    #[arg(long, conflicts_with_all = ["quantities", "refine", "map", "flow_picture"])]
    sealing_pressure: bool,
    /// Loads on the nominal area, in N
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = all(load))]
    #[arg(action = ArgAction::Append)]
    loads: Vec<Numbers>,
}

impl Places {
    /// The pressures on the nominal area, and so on the scan.
    fn pressures(&self, nominal_area: f64) -> Vec<f64> {
        let pressures = self.pressures.iter().flat_map(|list| &list.0).copied();
        let loads = self.loads.iter().flat_map(|list| &list.0);
        pressures.chain(loads.map(|load| load / nominal_area)).collect()
    }
}

impl BemCommand {
    pub fn run(self) -> Result<()> {
        let scene =
            LoadedScene::load_scan(&self.scene, self.press.options())?.taken_at(&self.end)?;
        let pressures = self.places.pressures(scene.file.scene.nominal_area);
        for (name, path) in [("--picture", &self.picture), ("--flow-picture", &self.flow_picture)] {
            if path.is_some() && pressures.len() > 1 {
                let text = format!("{name} draws one load, not {}", pressures.len());
                usage_error("bem", ErrorKind::ArgumentConflict, &text);
            }
        }
        if self.samples.is_some() && !self.places.sealing_pressure {
            let text = "--samples needs --sealing-pressure";
            usage_error("bem", ErrorKind::ArgumentConflict, text);
        }
        let bem = scene.bem()?;
        show(&bem.note());
        if self.places.sealing_pressure {
            return self.seal(&scene, &bem);
        }
        let given: Vec<LoadCase> = pressures.iter().copied().map(LoadCase::MeanPressure).collect();
        let press = Press {
            refine: self.refine,
            keep: [&self.map, &self.picture, &self.flow_picture].into_iter().any(Option::is_some),
            ..Press::new(&scene.file, &bem, &given, &self.quantities)
        };
        let watch = terminal()?;
        let (sheet, solutions) = scene.answer(|sheet| press.solve(sheet, &watch))?;
        drop(watch);
        if !sheet.rows.is_empty() {
            self.output.write(&sheet)?;
            if let Some(path) = &self.map {
                let maps: Vec<&[f64]> =
                    solutions.iter().map(|found| &found.pressures[..]).collect();
                contact_map::write(path, &maps, bem.map().shape())?;
            }
            if let [solution] = &solutions[..] {
                self.draw(&scene, &bem, solution)?;
            }
        }
        if sheet.rows.is_empty() || interrupt::requested() {
            let (done, all) = (sheet.rows.len(), pressures.len());
            interrupt::end_with(&format!("{done} of {all} loads are solved"));
        }
        Ok(())
    }

    /// Sealing pressures of samples of the scan.
    fn seal(&self, scene: &LoadedScene, bem: &Bem) -> Result<()> {
        let (watch, samples) = (terminal()?, self.samples.unwrap_or(SAMPLES).into());
        let fill = |sheet: &mut _| sealing((&scene.file, bem), samples, sheet, &watch);
        let (sheet, heaviest) = scene.answer(fill)?;
        drop(watch);
        if sheet.rows.is_empty() {
            interrupt::end_with("fewer than two samples are solved");
        }
        self.output.write(&sheet)?;
        heaviest.map_or(Ok(()), |solution| self.draw(scene, bem, &solution))
    }

    /// Draws the maps of a solved contact.
    fn draw(&self, scene: &LoadedScene, bem: &Bem, solution: &Solution) -> Result<()> {
        let interface = &scene.file.scene.interface;
        let elements = bem.elements(interface)?;
        if let Some(path) = &self.picture {
            let hardness = bem.hardness(interface)?;
            let leaks = self.places.sealing_pressure || self.quantities.contains(&Quantity::Leak);
            let leaks = leaks.then_some(&elements);
            let map = contact_map::picture(bem, solution, hardness, leaks, &scene.name)?;
            output::write_text(Some(path), &draw_map(&map)?)?;
        }
        if let Some(path) = &self.flow_picture {
            let map = contact_map::flow(bem, &elements, solution, &scene.name)?;
            output::write_text(Some(path), &draw_map(&map)?)?;
        }
        Ok(())
    }
}
