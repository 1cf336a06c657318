//! `asperity surface`: statistics and asperities of a scan, and a scene of it.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use asperity::{Code, Findings};
use asperity_answer::{Cell, Sheet};
use asperity_plot::{draw_material_ratio, draw_surface};
use asperity_scene::MeasuredKeys;
use asperity_topography::{
    Alignment, Distance, Estimator, Glance, HeaderLine, LengthUnit, Level, ReadOptions, Reported,
    Statistics, Topography, TopographyError, report,
};
use clap::Args;
use serde::Serialize;
use toml::{Table, Value};

use crate::commands::scales;
use crate::input::args::DrawnArgs;
use crate::input::lists::{Numbers, all, sizes};
use crate::input::numbers::{length, share};
use crate::input::refuse;
use crate::output::table::Format;
use crate::output::{self, progress};

const PLOT: &str = "Plot the scan: map, histogram, spectra, slope and curvature against scale; with --report, the material ratio curve; with --scales, its table";

/// Measure a scan: roughness, spectral moments and asperities; optionally write a scene of it
#[derive(Debug, Args)]
#[command(
    mut_arg("plot", |arg| arg.help(PLOT)),
    after_help = include_str!("../help/surface.txt")
)]
pub struct Surface {
    /// One measured surface, or the two surfaces in contact
    #[arg(value_name = "FILE", num_args = 1..=2, required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    scan: ScanArgs,
    /// Add the heights of two scans point by point: of equal row and column (as-read), or with the
    /// rows of the second reversed (mirrored), as of two scans taken from above
    #[arg(long, value_name = "HOW", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "as-read")]
    aligned: Option<Alignment>,
    /// Functional parameters by the material ratio curve instead: Sk, Spk, Svk, Smr1, Smr2, Vmp,
    /// Vmc, Vvc, Vvv; of a profile Rk, Rpk, Rvk, Rmr1, Rmr2, Rz, RSm, Rdq
    #[arg(long, conflicts_with = "scales")]
    report: bool,
    #[command(flatten)]
    output: DrawnArgs,
    /// Write a scene that reads the files in the same way; its materials are examples, replace
    /// them; an existing file is kept
    #[arg(long, value_name = "OUT.toml")]
    scene: Option<PathBuf>,
    /// Tabulate the asperities against the short-wavelength cut-off: N cut-offs from A to B, in m,
    /// or with a unit
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(length))]
    #[arg(conflicts_with_all = ["smooth", "scene"])]
    scales: Option<Numbers>,
}

/// How scans are read and prepared: keys of a scene.
#[derive(Debug, Args, Serialize)]
struct ScanArgs {
    /// Unit of the heights and of the pixel size: m, cm, mm, um, nm, angstrom, pm
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<String>,
    /// Distance between neighbouring points, along a row and along a column, in the unit of the
    /// heights or with a unit: 10nm
    #[arg(long, value_name = "DX[xDY]", value_parser = pixel_size)]
    pixel_size: Option<Value>,
    /// Surface of a file with several (.gwy, .sur): its name or its number, from 1 [default: the
    /// first one with heights]
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    /// Units of a text that states none: of lengths and heights, or of x, y and heights: mm,um
    #[arg(long, value_name = "UNITS", value_delimiter = ',', value_parser = unit)]
    units: Option<Vec<String>>,
    /// Columns of a text: x,y,z or -,z,- by name, the number of the column of heights, matrix, or
    /// axes (the first row or column are positions)
    #[arg(long, allow_hyphen_values = true)]
    columns: Option<String>,
    /// Lines at the beginning of a text that are not read
    #[arg(long, value_name = "COUNT", default_value_t)]
    skip_lines: usize,
    /// The number that marks missing points; nan if none does
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    missing: Option<f64>,
    /// From the numbers in the file to heights in their unit
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    factor: Option<f64>,
    /// Separator of the fields of a text
    #[arg(long, value_name = "CHARACTER")]
    delimiter: Option<char>,
    /// Only list what the header of a text says, and how it is understood
    #[arg(long)]
    #[serde(skip)]
    header: bool,
    /// Asperities from: moments (spectral moments of profiles, after McCool) or summits (points
    /// above their eight neighbours)
    #[arg(long, value_name = "NAME", default_value = "moments")]
    estimator: Estimator,
    /// Form removed by least squares: none, mean, plane or quadratic [default: plane; mean with
    /// --periodic]
    #[arg(long, value_name = "NAME")]
    level: Option<Level>,
    /// Long-wavelength cut-off in m, or with a unit: remove waviness (Gaussian filter, ISO 16610)
    #[arg(long, value_name = "CUTOFF", value_parser = length)]
    filter: Option<f64>,
    /// Short-wavelength cut-off in m, or with a unit: remove noise (Gaussian filter)
    #[arg(long, value_name = "CUTOFF", value_parser = length)]
    smooth: Option<f64>,
    /// Treat the surface as periodic beyond its edges
    #[arg(long)]
    periodic: bool,
    /// Largest accepted share of missing points, for example 0.2
    #[arg(long, value_name = "SHARE", value_parser = share, default_value = "0.1")]
    max_missing: f64,
    /// Fill missing points, up to 5 % of all, from their surroundings (harmonic: each point is the
    /// mean of its neighbours)
    #[arg(long)]
    fill_missing: bool,
    /// Replace outliers, points far above or below their surroundings, as missing points are filled
    #[arg(long)]
    despike: bool,
}

/// A unit by its usual name.
fn unit(text: &str) -> Result<String, TopographyError> {
    text.parse().map(|unit: LengthUnit| unit.to_string())
}

/// One distance, of square pixels, or two, as a scene has them.
fn pixel_size(text: &str) -> Result<Value, String> {
    let [across, down]: [Distance; 2] =
        sizes(text, |size| size.parse().map_err(|error: TopographyError| error.to_string()))?;
    let distance = |given: Distance| {
        let text = given.to_string();
        text.parse::<f64>().map_or(Value::from(text), Value::from)
    };
    Ok(match across == down {
        true => distance(across),
        false => vec![distance(across), distance(down)].into(),
    })
}

/// All numbers of a scan; of two scans their statistics alone.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    statistics: &'a Statistics,
    #[serde(flatten)]
    glance: Option<Glance>,
}

impl Surface {
    pub fn run(self) -> Result<()> {
        self.check();
        self.scene.as_deref().map_or(Ok(()), output::refuse_to_replace)?;
        output::show(&self.scan.level.and_then(|level| level.tilts(self.scan.periodic)));
        if self.scan.header {
            return self.header();
        }
        let (working, keys) = (progress("surface"), self.keys()?);
        if let Some(Numbers(cutoffs)) = &self.scales {
            let path = self.files.first().context("a file was required")?;
            let table = scales::table(cutoffs, &read(path, &keys)?, &keys)?;
            drop(working);
            return self.output.write(&table, || scales::picture(&table));
        }
        let (mut each, mut found) = (vec![], Findings::default());
        let (mut glance, mut picture) = (None, None);
        let mut functional = vec![];
        let scans = self.scans(&keys)?;
        for (name, raw, surface) in &scans {
            let of = || name.clone();
            let statistics = surface.statistics(self.scan.estimator).with_context(of)?;
            let seam = asperity_scene::open_seam(surface).into_iter();
            let [dx, dy] = surface.pixel_size();
            let slope = statistics.unusual_slope(dx.max(dy));
            let size = slope.or_else(|| asperity::unusual("sq", statistics.sq));
            let size = size.into_iter().chain(statistics.unusual_kurtosis());
            let of_scan = seam.chain(size).chain(statistics.warnings.iter().cloned());
            found.extend(of_scan.map(|found| found.from_origin(of())));
            each.push(statistics);
            if scans.len() == 1 {
                let level = self.scan.level.unwrap_or(Level::usual(self.scan.periodic));
                let cutoffs = [self.scan.smooth, self.scan.filter];
                let found = Glance::new(raw, level, cutoffs, surface).with_context(of)?;
                picture = self.output.picture(|| {
                    let title = self.names(|path| path.file_name().unwrap_or_default());
                    if !self.report {
                        return Ok(draw_surface(surface, &found, Some(&title))?);
                    }
                    let curve = surface.material_ratio()?;
                    Ok(draw_material_ratio(&curve, surface.is_profile(), &title)?)
                })?;
                functional = surface.functional().with_context(of)?;
                glance = Some(found);
            }
        }
        if let [first, second] = &each[..] {
            let both = Statistics::combined(first, second);
            let both = both.with_context(|| self.names(Path::as_os_str))?;
            let of_both = both.warnings.iter().cloned();
            found.extend(of_both.map(|found| found.from_origin("both together")));
            each.push(both);
        }
        drop(working);
        output::show(&found);
        let statistics = each.last().context("a file was required")?;
        if let Some(path) = &self.scene {
            output::write_text(Some(path), &self.scene_text(path, statistics)?)?;
            let text = "materials and nominal area are examples (steel on steel); replace them";
            output::note(Code::ExampleValues, format!("{}: {text}", path.display()));
        }
        let output = &self.output.output;
        if output.format() == Format::Json && !self.report {
            let all = Report { statistics, glance };
            let text = serde_json::to_string_pretty(&all)? + "\n";
            return self.output.write_beside(picture, || output.write_text(&text));
        }
        let mut table = Sheet::new(&["name", "value", "unit", "meaning"]);
        let row = |Reported { name, value, unit, meaning }| {
            vec![name.into(), Cell::from(value), unit.into(), meaning.as_ref().into()]
        };
        let rows = if self.report { functional } else { report(statistics, glance.as_ref()) };
        table.rows = rows.into_iter().map(row).collect();
        self.output.write_beside(picture, || output.write(&table))
    }

    /// The lines of the headers of the files.
    fn header(&self) -> Result<()> {
        let (keys, mut table) = (self.keys()?, Sheet::new(&["line", "text", "understood_as"]));
        for path in &self.files {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let bytes = std::fs::read(path).with_context(|| path.display().to_string())?;
            let lines = asperity_topography::read_header(&name, &bytes, &keys.options);
            for HeaderLine { line, text, meaning, .. } in lines.map_err(with_option)? {
                table.add(
                    &[&line.to_string(), &text, meaning.unwrap_or_default()],
                    [Cell::BLANK; 0],
                );
            }
        }
        self.output.output.write(&table)
    }

    /// Refuses options that exclude each other.
    fn check(&self) {
        let two = self.files.len() > 1;
        let separate = two && self.aligned.is_none();
        let nothing_left =
            self.scan.smooth.zip(self.scan.filter).is_some_and(|(smooth, filter)| smooth >= filter);
        refuse([
            (self.aligned.is_some() && !two, "--aligned takes two FILEs"),
            (self.scales.is_some() && two, "--scales takes one FILE"),
            (self.report && separate, "--report takes one FILE or --aligned"),
            (self.output.plot.is_some() && separate, "--plot takes one FILE or --aligned"),
            (nothing_left, "choose --smooth below --filter, which keeps some wavelengths"),
        ]);
    }

    fn names(&self, part: impl Fn(&Path) -> &OsStr) -> String {
        let names = self.files.iter().map(|path| part(path).to_string_lossy().into_owned());
        names.collect::<Vec<_>>().join(" and ")
    }

    /// The options as the keys of a scene, but those that change nothing.
    fn given(&self) -> Result<Table> {
        let mut given = Table::try_from(&self.scan)?;
        given.retain(|key, value| match value {
            Value::Boolean(asked) => *asked,
            Value::Integer(lines) => *lines > 0,
            Value::Float(share) if key == "max_missing" => {
                share.total_cmp(&ReadOptions::MAX_MISSING).is_ne()
            }
            _ => true,
        });
        Ok(given)
    }

    /// The same as a scene reads them.
    fn keys(&self) -> Result<MeasuredKeys> {
        Ok(self.given()?.try_into()?)
    }

    /// The scans, or the sum of two that are aligned: names, as read, and prepared.
    fn scans(&self, keys: &MeasuredKeys) -> Result<Vec<(String, Topography, Topography)>> {
        let scan = |path: &PathBuf| {
            let (name, raw) = (path.display().to_string(), read(path, keys)?);
            let surface = keys.prepare(raw.clone()).with_context(|| name.clone())?;
            Ok((name, raw, surface))
        };
        let scans = self.files.iter().map(scan).collect::<Result<Vec<_>>>()?;
        let (Some(alignment), [one, two]) = (self.aligned, &scans[..]) else { return Ok(scans) };
        let name = self.names(Path::as_os_str);
        let raw = one.1.facing(&two.1, alignment).with_context(|| name.clone())?;
        let surface = one.2.facing(&two.2, alignment).with_context(|| name.clone())?;
        Ok(vec![(name, raw, surface)])
    }

    /// The template's scene on this surface, with the same reading options.
    fn scene_text(&self, path: &Path, statistics: &Statistics) -> Result<String> {
        let files = self.files.iter().map(|file| {
            let mut keys = self.given()?;
            keys.insert("file".into(), beside(path, file)?.into());
            Ok(keys)
        });
        let mut files = files.collect::<Result<Vec<Table>>>()?.into_iter();
        let mut keys = files.next().unwrap_or_default();
        keys.extend(files.next().map(|second| ("counterface".into(), second.into())));
        let aligned = |alignment| match alignment {
            Alignment::AsRead => Value::from(true),
            Alignment::Mirrored => "mirrored".into(),
        };
        keys.extend(self.aligned.map(|alignment| ("aligned".into(), aligned(alignment))));
        let keys: Vec<(&str, Value)> = keys.iter().map(|(key, x)| (&**key, x.clone())).collect();
        Ok(asperity_scene::template_on(statistics.surface().ok().as_ref(), &keys))
    }
}

/// A scan as read, and despiked.
fn read(path: &Path, keys: &MeasuredKeys) -> Result<Topography> {
    let read = asperity_topography::read(path, &keys.options).map_err(with_option)?;
    keys.clean(read).with_context(|| path.display().to_string())
}

/// The error of a reader, with the option that states what the file does not.
fn with_option(error: TopographyError) -> anyhow::Error {
    let TopographyError::File { source, .. } = &error else { return error.into() };
    let option = match **source {
        TopographyError::UnitMissing => "--unit",
        TopographyError::PixelSizeMissing => "--pixel-size",
        TopographyError::TooManyMissing { .. } => "--max-missing",
        TopographyError::Undecided { option, .. } => option,
        _ => return error.into(),
    };
    anyhow!("{error} (--{})", option.trim_start_matches('-').replace('_', "-"))
}

/// The path of a file in a scene file at `scene`: relative where the file is in the folder of the
/// scene or below, so that both can be moved together.
fn beside(scene: &Path, file: &Path) -> Result<String> {
    let [scene, file] = [std::path::absolute(scene)?, std::path::absolute(file)?];
    let named = scene.parent().and_then(|folder| file.strip_prefix(folder).ok()).unwrap_or(&file);
    let text = named.to_str().map(Into::into);
    text.ok_or_else(|| {
        anyhow!("{} is not valid UTF-8, so that no scene file can name it", named.display())
    })
}
