//! `asperity bem`: boundary elements on the scan of a scene.

use std::path::PathBuf;

use anyhow::Result;
use asperity::Quantity;
use asperity::bem::{Bem, BemOptions, Continuation, LoadCase, Solution};
use asperity_answer::{Press, sealing};
use asperity_plot::draw_map;
use clap::{ArgAction, Args};

use crate::input::args::{EndArgs, OutputArgs, continuation, file_ending, loads, svg_file};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{load, pressure};
use crate::input::refuse;
use crate::interrupt;
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
    /// Beyond the edges of the scan that bem presses: periodic (repeated as it is, with steps),
    /// periodic-part (its periodic component) or free (a single body) [default: periodic if the
    /// scene says periodic = true; otherwise periodic-part if the edges do not match, free if they
    /// do but the slopes there do not, as of a ball, and periodic if both do]
    #[arg(long, value_name = "WHAT", value_parser = continuation())]
    boundary: Option<Continuation>,
    /// Press the scan by bem without the hardness: elastic, with unlimited pressures
    #[arg(long)]
    elastic: bool,
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

impl BemCommand {
    pub fn run(self) -> Result<()> {
        let given = BemOptions { boundary: self.boundary, elastic: self.elastic };
        let scene = LoadedScene::load_scan(&self.scene, given)?.taken_at(&self.end)?;
        let places = loads(&self.places.loads, &self.places.pressures);
        let pressures = places.filter_map(|at| at.pressure(&scene.file.scene));
        let given: Vec<LoadCase> = pressures.map(LoadCase::MeanPressure).collect();
        let (count, is_seal) = (given.len(), self.places.sealing_pressure);
        let one = |name: &str| format!("{name} draws one load, not {count}");
        refuse([
            (self.picture.is_some() && count > 1, one("--picture")),
            (self.flow_picture.is_some() && count > 1, one("--flow-picture")),
            (self.samples.is_some() && !is_seal, "--samples needs --sealing-pressure".into()),
        ]);
        let bem = scene.bem()?;
        show(&bem.note());
        interrupt::listen()?;
        if is_seal {
            return self.seal(&scene, &bem);
        }
        let press = Press {
            refine: self.refine,
            keep: [&self.map, &self.picture, &self.flow_picture].into_iter().any(Option::is_some),
            ..Press::new(&scene.file, &bem, &given, &self.quantities)
        };
        let (sheet, solutions) = scene.answer(|sheet, watch| press.solve(sheet, watch))?;
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
            interrupt::end_with(&format!("{} of {count} loads are solved", sheet.rows.len()));
        }
        Ok(())
    }

    /// Sealing pressures of samples of the scan.
    fn seal(&self, scene: &LoadedScene, bem: &Bem) -> Result<()> {
        let (of, samples) = ((&scene.file, bem), self.samples.unwrap_or(SAMPLES).into());
        let (sheet, heaviest) = scene.answer(|sheet, watch| sealing(of, samples, sheet, watch))?;
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
