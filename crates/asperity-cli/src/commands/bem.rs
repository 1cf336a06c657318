//! `asperity bem`: boundary elements on the scan of a scene.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::bem::{Bem, Continuation, LoadCase};
use asperity::{ContactModel, Findings, Quantity, Request};
use asperity_plot::{draw_map, map_png};
use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{ArgAction, Args};

use crate::input::args::{OutputArgs, is_png, npy_file, svg_or_png_file};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{length, load, pressure};
use crate::interrupt;
use crate::output::contact_map;
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{self, print_message};
use crate::pressed::{Row, Run};
use crate::scene::LoadedScene;

/// Boundary elements on the scan of a scene, pressed on an elastic half-space, without asperities
#[derive(Debug, Args)]
#[command(
    after_help = "The scene names a scan: [surface] file = \"scan.txt\". The scan represents the
whole nominal area, levelled and filtered by the scene's keys. The material is that of
the scene and yields where the pressure reaches the hardness.
Columns: load_N, pressure_Pa, area_fraction (corrected for the staircase edges of
pixels), area_fraction_pixels (as counted), plastic_fraction, mean_gap_m (of the mean
planes), patches, iterations, residual; then those of --quantity, with the names that
models have; with --refine the same on half the grid;
boundary (periodic, periodic-part or free).
After Ctrl-C the loads solved so far are written; the exit code is 130.

Examples:
  asperity bem scan.toml --pressure 1e7,1e8
  asperity bem scan.toml --load 1000 --elastic --boundary free --format json
  asperity bem scan.toml --pressure 1e7:1e9:5:log --refine --output bem.csv --format csv
  asperity bem scan.toml --pressure 1e7,1e8 --quantity unloading-stiffness
  asperity bem scan.toml --pressure 2e8 --map pressures.npy --picture contact.svg"
)]
pub struct BemCommand {
    /// Scene file that names a scan
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    places: Places,
    #[command(flatten)]
    way: Way,
    /// Add tangent (or stiffness, the same: the slope of first loading; where contacts yield the
    /// chord between pressures up to 5 % to either side, by two more solutions), quantities of
    /// joints (unloading-stiffness, tangential-stiffness, thermal-conductance,
    /// electrical-conductance,
    /// -per-area), or any other that follows from load and area
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    quantities: Vec<Quantity>,
    /// Add the results on every second pixel, to show their dependence on the grid
    #[arg(long)]
    refine: bool,
    /// Write the pressures in Pa as a NumPy matrix, stacked for several loads
    #[arg(long, value_name = "FILE.npy", value_parser = PathBufValueParser::new().try_map(npy_file))]
    map: Option<PathBuf>,
    /// Draw a map of the contact pressure at one load; png is the map without labels
    #[arg(long, value_name = "FILE.svg|png")]
    #[arg(value_parser = PathBufValueParser::new().try_map(svg_or_png_file))]
    picture: Option<PathBuf>,
    #[command(flatten)]
    output: OutputArgs,
}

/// The loads or gaps to solve.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct Places {
    /// Pressures on the nominal area, in Pa: N from A to B, in equal steps or (log) ratios, or
    /// v,v,...
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = all(pressure))]
    #[arg(action = ArgAction::Append)]
    pressures: Vec<Numbers>,
    /// Loads on the nominal area, in N
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = all(load))]
    #[arg(action = ArgAction::Append)]
    loads: Vec<Numbers>,
    /// Mean gaps above 0, in m; where the mean planes of a yielded contact have passed each other,
    /// give loads
    #[arg(long = "gap", value_name = "A:B:N[:log]|v,v", value_parser = all(length))]
    #[arg(action = ArgAction::Append)]
    gaps: Vec<Numbers>,
}

/// The material and the boundary.
#[derive(Debug, Args)]
pub struct Way {
    /// Ignore the hardness: elastic, with unlimited pressures
    #[arg(long)]
    pub elastic: bool,
    /// Beyond the edges of the scan: periodic (repeated as it is, with steps), periodic-part (its
    /// periodic component) or free [default: periodic if the scene says periodic = true or the
    /// edges match, otherwise periodic-part]
    #[arg(long, value_name = "WHAT", value_parser = continuation())]
    pub boundary: Option<Continuation>,
}

/// The values of `--boundary`.
fn continuation() -> impl TypedValueParser<Value = Continuation> {
    let names = PossibleValuesParser::new(Continuation::ALL.map(Continuation::name));
    names.try_map(|name| Continuation::from_name(&name).ok_or("another name was required"))
}

impl Places {
    /// The loads and gaps in the order of the command line; the pressure on the scan is that on the
    /// nominal area.
    fn given(&self, nominal_area: f64) -> Vec<LoadCase> {
        let all = |lists: &[Numbers], given: &dyn Fn(f64) -> LoadCase| {
            lists.iter().flat_map(|list| &list.0).map(|value| given(*value)).collect::<Vec<_>>()
        };
        let mut given = all(&self.pressures, &LoadCase::MeanPressure);
        given.extend(all(&self.loads, &|load| LoadCase::MeanPressure(load / nominal_area)));
        given.extend(all(&self.gaps, &LoadCase::MeanGap));
        given
    }
}

impl Way {
    /// Whether the scan is declared periodic.
    pub fn periodic(&self) -> bool {
        self.boundary == Some(Continuation::Periodic)
    }

    /// The model of the scene's scan, with a note if its periodic component is used by default.
    pub fn bem(&self, scene: &LoadedScene) -> Result<Bem> {
        let bem = match scene.file.bem(self.boundary, self.elastic) {
            Ok(bem) => bem,
            Err(error) => bail!("{}: {error}", scene.name),
        };
        crate::output::report(&bem.note().into_iter().collect());
        Ok(bem)
    }
}

impl BemCommand {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load_scan(&self.scene, self.way.periodic())?;
        let given = self.places.given(scene.file.scene.nominal_area);
        self.check(&given);
        let bem = self.way.bem(&scene)?;
        let quantities = added(&self.quantities);
        // Refuses what boundary elements or the scene lack before anything is solved.
        bem.compile(&scene.file.scene, &Request::new(quantities.iter().copied()))?;
        let mut run = Run {
            scene: &scene,
            quantities: &quantities,
            given: &given,
            maps: vec![],
            errors: vec![],
            found: Findings::default(),
        };
        // Before the hours of the whole grid.
        let half_grid = self.refine.then(|| bem.half_grid()).transpose();
        let half_grid = half_grid.context(match bem.continuation() {
            Continuation::Periodic => REFINE_PERIODIC,
            _ => REFINE,
        })?;
        let keep = self.map.is_some() || self.picture.is_some();
        let mut whole = run.solve(&bem, keep)?;
        let mut half = match half_grid.filter(|_| !interrupt::requested()) {
            Some(half) => Some(run.solve(&half, false)?),
            None => None,
        };
        if interrupt::requested() {
            // Loads without a result are left out, not blank.
            let mut solved = whole.iter().map(Option::is_some).collect::<Vec<_>>().into_iter();
            half = half.map(|half| {
                let rows = half.into_iter().zip(solved.clone());
                rows.filter(|(_, solved)| *solved).map(|(row, _)| row).collect()
            });
            whole.retain(|_| solved.next().unwrap_or(false));
        }
        let maps = std::mem::take(&mut run.maps);
        run.errors.iter().for_each(|text| print_message("warning", text));
        scene.report(std::mem::take(&mut run.found));
        if !whole.iter().any(Option::is_some) {
            if interrupt::requested() {
                interrupt::end(0, given.len());
            }
            bail!("{}: no load was solved", scene.name);
        }
        // A contact that has yielded may unload stiffer.
        let is_elastic = whole.iter().flatten().any(|row| row.plastic <= 0.0);
        let free = bem.continuation() == Continuation::Free;
        if free && is_elastic && has_both_stiffnesses(&quantities) {
            print_message("note", FREE_STIFFNESSES);
        }
        let nominal_area = scene.file.scene.nominal_area;
        let mut table = table(&whole, half.as_deref(), nominal_area, &quantities);
        table.head.push("boundary".into());
        table.rows.iter_mut().for_each(|row| row.push(bem.continuation().name().into()));
        self.output.write(&table)?;
        if let Some(path) = &self.map {
            contact_map::write(path, &maps, bem.map().shape())?;
        }
        if let (Some(path), [pressures], Some(Some(row))) =
            (&self.picture, &maps[..], whole.first())
        {
            let hardness = scene.file.scene.interface.check()?.0;
            let hardness = hardness.filter(|_| !self.way.elastic);
            let map = contact_map::picture(&bem, pressures, row, hardness, &scene.name);
            if is_png(path) {
                let png = map_png(&map)?;
                output::write(Some(path), |out| out.write_all(&png))?;
                let (label, top) = (&map.label, rounded(map.top));
                print_message(
                    "note",
                    &format!("{}: {label} from yellow to black at {top}", path.display()),
                );
            } else {
                output::write_text(Some(path), &draw_map(&map)?)?;
            }
        }
        if interrupt::requested() {
            interrupt::end(whole.len(), given.len());
        }
        Ok(())
    }

    /// Refuses options that exclude each other.
    fn check(&self, given: &[LoadCase]) {
        let refuse =
            |text: &str| crate::input::usage_error("bem", ErrorKind::ArgumentConflict, text);
        if self.picture.is_some() && given.len() > 1 {
            refuse(&format!("--picture draws one load, not {}", given.len()));
        }
        let outputs = [self.output.output.as_deref(), self.picture.as_deref(), self.map.as_deref()];
        let given = [true, self.picture.is_some(), self.map.is_some()];
        let named: Vec<_> = outputs.iter().copied().flatten().collect();
        let twice = |k: usize| named[..k].iter().any(|path| output::is_same(path, named[k]));
        if (0..named.len()).any(|k| !output::is_standard(Some(named[k])) && twice(k)) {
            refuse("--output, --picture and --map name the same file; choose different names");
        }
        let standard =
            outputs.iter().zip(given).filter(|(path, given)| *given && output::is_standard(**path));
        if standard.count() > 1 {
            refuse(
                "--map - and --picture - use standard output; name a file for the data with --output",
            );
        }
    }
}

/// The quantities without a column of their own, each once.
fn added(quantities: &[Quantity]) -> Vec<Quantity> {
    let mut all: Vec<Quantity> = vec![];
    for quantity in quantities {
        if !COLUMNS.contains(&&*quantity.column()) && !all.contains(quantity) {
            all.push(*quantity);
        }
    }
    all
}

/// Whether the slope of loading and the stiffness of a joint are asked for.
fn has_both_stiffnesses(quantities: &[Quantity]) -> bool {
    let slope = |quantity: &Quantity| matches!(quantity, Quantity::Tangent | Quantity::Stiffness);
    quantities.iter().any(slope) && quantities.contains(&Quantity::UnloadingStiffness)
}

fn table(
    rows: &[Option<Row>],
    half: Option<&[Option<Row>]>,
    nominal_area: f64,
    quantities: &[Quantity],
) -> Table {
    let cells = |row: Option<&Row>| -> Vec<Cell> {
        let Some(row) = row else {
            return vec![Cell::Number(None); COLUMNS.len() + quantities.len()];
        };
        let all = [
            row.pressure * nominal_area,
            row.pressure,
            row.area,
            row.pixel_area,
            row.plastic,
            row.gap,
            row.patches as f64,
            row.iterations as f64,
            row.residual,
        ];
        all.map(Some).iter().chain(&row.values).map(|value| Cell::Number(*value)).collect()
    };
    let mut table = Table::new(&COLUMNS);
    table.head.extend(quantities.iter().map(|quantity| quantity.column()));
    if half.is_some() {
        let names: Vec<String> =
            table.head[2..].iter().map(|name| format!("{name}_half_grid")).collect();
        table.head.extend(names);
    }
    for (k, row) in rows.iter().enumerate() {
        let mut all = cells(row.as_ref());
        if let Some(half) = half {
            all.extend(cells(half[k].as_ref()).split_off(2));
        }
        table.rows.push(all);
    }
    table
}

/// Why the stiffnesses of an elastic contact differ.
const FREE_STIFFNESSES: &str = "with a free boundary the tangent exceeds the unloading stiffness of the same elastic contact, the more the larger the contact: the tangent is the slope against the mean gap under the scan, the unloading stiffness that against the approach of distant points";

/// Why a grid cannot be halved.
const REFINE: &str =
    "--refine needs an even number of rows and columns; crop the scan, or leave --refine out";

/// The same for a scan whose crop would not be periodic.
const REFINE_PERIODIC: &str = "--refine needs an even number of rows and columns; resample the period to such a grid (a crop is not periodic), or leave --refine out";

const COLUMNS: [&str; 9] = [
    "load_N",
    "pressure_Pa",
    "area_fraction",
    "area_fraction_pixels",
    "plastic_fraction",
    "mean_gap_m",
    "patches",
    "iterations",
    "residual",
];
