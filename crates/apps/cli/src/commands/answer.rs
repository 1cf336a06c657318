//! `asperity answer`: what is known best at a load, with what stands behind it.

use std::path::PathBuf;

use anyhow::Result;
use asperity::{At, Code, Quantity, Severity, Tolerance};
use asperity_answer::{Sheet, Watch, lines, scene_findings, title, with_ranges};
use clap::Args;

use crate::input::args::{OutputArgs, approaches, check_approaches, loads};
use crate::input::distances::metre;
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{load_or_tension, pressure_or_tension};
use crate::interrupt::Terminal;
use crate::output::table::{self, Format};
use crate::scene::LoadedScene;

/// Most findings that are printed without --all.
const MOST_FINDINGS: usize = 3;

/// Real area, stiffnesses, conductance and mean gap at a load, between limits
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/answer.txt"))]
pub struct Answer {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    place: Loads,
    /// Quantities, as listed by `asperity list quantities` [default: area, tangent and unloading
    /// stiffness; with shear moduli tangential stiffness, with conductivities conductance per area]
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    quantities: Vec<Quantity>,
    /// Every model with its deviation from the answer, in the middle of ranges, and all findings
    #[arg(long)]
    all: bool,
    /// Solve the scan of the scene at these loads by boundary elements, and answer with that
    #[arg(long)]
    solve: bool,
    #[command(flatten)]
    output: OutputArgs,
}

/// Loads, pressures or approaches.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Loads {
    /// Loads, as a range or a list: in N, or with a unit, for example 20kN
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = all(load_or_tension))]
    loads: Vec<Numbers>,
    /// Loads as pressures on the nominal area: in Pa, or with a unit, for example 5MPa
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = all(pressure_or_tension))]
    pressures: Vec<Numbers>,
    /// Approaches of curved bodies: in m, or with a unit, for example 5um
    #[arg(long = "approach", value_name = "A:B:N[:log]|v,v", value_parser = all(metre))]
    approaches: Vec<Numbers>,
}

impl Answer {
    pub fn run(self) -> Result<()> {
        let mut scene = LoadedScene::open(&self.scene)?;
        check_approaches(scene.file.shape().is_some(), &self.place.approaches);
        let at = loads(&self.place.loads, &self.place.pressures);
        let at: Vec<At> = at.chain(approaches(&self.place.approaches)).collect();
        if self.solve {
            scene.solve(&at)?;
        }
        let file = &scene.file;
        let asked = asperity_answer::Answer::new(file, &self.quantities, at, Tolerance::default());
        let fill = |sheet: &mut Sheet, watch: &Terminal| {
            watch.progress("models");
            sheet.extend(scene_findings(file, true));
            if self.all {
                // Every model at every point of ranges takes minutes.
                let (file, note) = file.taken_at("middle")?;
                sheet.findings.extend(note.map(|note| note.from_origin("--all")));
                let fill = |file: &_, sheet: &mut _| asked.all(file, sheet, &Terminal::default());
                return with_ranges(&file, sheet, fill).map(|()| None);
            }
            let basis = asked.answer(file, sheet)?;
            // The most severe first, of these a value without ends.
            let found = std::mem::take(&mut sheet.findings);
            let found = found.into_iter().filter(|one| one.severity < Severity::Note);
            sheet.findings = found.collect();
            sheet.findings.sort_by_key(|one| (one.severity, one.code != Code::NoValue));
            let more = sheet.findings.len().saturating_sub(MOST_FINDINGS);
            sheet.findings.truncate(MOST_FINDINGS);
            match more {
                0 => {}
                1 => sheet.result("one more warning: --all prints it"),
                more => sheet.result(format!("{more} more warnings: --all prints them")),
            }
            Ok(Some(basis))
        };
        let (sheet, basis) = scene.answer(fill)?;
        let (Format::Table, Some(basis)) = (self.output.format(), basis) else {
            return self.output.write(&sheet);
        };
        let mut text = vec![];
        let one = asked.request.at.first().filter(|_| sheet.rows.len() == 1);
        text.extend(one.iter().flat_map(|at| format!("{}\n", title(file, **at)).into_bytes()));
        table::write(&lines(file, &sheet), Format::Table, &mut text)?;
        for (name, said) in [("by", basis.by), ("widest", basis.widest), ("also", basis.also)] {
            if !said.is_empty() {
                text.extend(format!("{name:<8}{said}\n").into_bytes());
            }
        }
        self.output.write_text(&String::from_utf8_lossy(&text))
    }
}
