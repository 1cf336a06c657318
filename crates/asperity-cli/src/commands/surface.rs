//! `asperity surface`: from a scan to asperities, and to a scene.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use asperity_scene::ModelOptions;
use asperity_topography::{Estimator, LengthUnit, Level, ReadOptions, Statistics, Topography};
use clap::error::ErrorKind;
use clap::{Args, ValueEnum};

use crate::numbers::{number, positive_number};
use crate::output;
use crate::progress::Progress;
use crate::table::{Format, Table};

/// What a measured surface is like, and a scene made of it
#[derive(Debug, Args)]
#[command(
    after_help = "Files: ASCII matrix, XYZ points, CSV profile, NumPy .npy, X3P, Digital Surf SUR.
What a file does not say of its units and pixels must be said here; nothing is
guessed. A scan of n points at a distance dx is n dx wide.
With two files, their moments add: two rough surfaces in contact.

Examples:
  asperity surface scan.txt --unit um --pixel-size 0.5
  asperity surface scan.txt --unit um --pixel-size 0.5,0.5 --estimator summits --format json
  asperity surface scan.txt --unit um --pixel-size 0.5 --heights pdf.csv --scene rough.toml
  asperity surface scan.txt scan.txt --unit um --pixel-size 0.5 --scene measured.toml"
)]
pub struct Surface {
    /// One measured surface, or the two that touch
    #[arg(value_name = "FILE", num_args = 1..=2, required = true)]
    files: Vec<PathBuf>,
    /// Unit of the heights, and of the pixel size: m, cm, mm, um, nm, angstrom, pm
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<LengthUnit>,
    /// Distance of neighbouring points, in the unit of the heights
    #[arg(long, value_name = "DX[,DY]", value_parser = pixel_size)]
    pixel_size: Option<PixelSize>,
    /// How asperities are found
    #[arg(long, value_name = "NAME", default_value = "moments")]
    estimator: EstimatorName,
    /// What is taken away before
    #[arg(long, value_name = "NAME", default_value = "plane")]
    level: LevelName,
    /// Keep the roughness below this wavelength, in m (Gaussian filter, ISO 16610)
    #[arg(long, value_name = "CUTOFF", value_parser = positive_number)]
    filter: Option<f64>,
    /// Take waves shorter than this away, noise above all, in m (Gaussian filter)
    #[arg(long, value_name = "CUTOFF", value_parser = positive_number)]
    smooth: Option<f64>,
    /// The surface goes on periodically beyond its edges
    #[arg(long)]
    periodic: bool,
    /// Largest share of missing points that is accepted
    #[arg(long, value_name = "SHARE", value_parser = share, default_value = "0.1")]
    max_missing: f64,
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "table")]
    format: SurfaceFormat,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write a scene with this surface, ready to run: put your materials into it
    #[arg(long, value_name = "OUT.toml")]
    scene: Option<PathBuf>,
    /// Write the measured density of the summits' heights, which the scene then uses
    #[arg(long, value_name = "OUT.csv")]
    heights: Option<PathBuf>,
    /// Replace the scene and heights files if they exist
    #[arg(long)]
    force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum EstimatorName {
    /// From the spectral moments of profiles, after McCool.
    Moments,
    /// From the summits: points above their eight neighbours.
    Summits,
}

impl From<EstimatorName> for Estimator {
    fn from(name: EstimatorName) -> Self {
        match name {
            EstimatorName::Moments => Self::Moments,
            EstimatorName::Summits => Self::Summits,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LevelName {
    /// Nothing.
    None,
    /// The least-squares plane.
    Plane,
    /// The least-squares quadric.
    Quadratic,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum SurfaceFormat {
    /// Aligned, six digits, with units.
    Table,
    /// One object, SI units, every digit.
    Json,
}

#[derive(Debug, Clone, Copy)]
struct PixelSize([f64; 2]);

fn unit(name: &str) -> Result<LengthUnit, String> {
    name.parse().map_err(|e: asperity_topography::TopographyError| e.to_string())
}

fn pixel_size(text: &str) -> Result<PixelSize, String> {
    let sizes: Vec<f64> = text.split(',').map(positive_number).collect::<Result<_, _>>()?;
    match sizes[..] {
        [both] => Ok(PixelSize([both; 2])),
        [across, down] => Ok(PixelSize([across, down])),
        _ => Err(format!("{} numbers: DX or DX,DY was expected", sizes.len())),
    }
}

fn share(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if (0.0..=1.0).contains(&value) => Ok(value),
        value => Err(format!("{value} is no share: a number from 0 to 1 was expected")),
    }
}

impl Surface {
    pub fn run(self) -> Result<()> {
        for path in self.scene.iter().chain(&self.heights) {
            output::refuse_to_replace(path, self.force)?;
        }
        if self.heights.is_some() && self.files.len() > 1 {
            let text = "--heights takes one FILE: the heights of two surfaces do not add";
            crate::usage_error("surface", ErrorKind::ArgumentConflict, text);
        }
        if let (Some(smooth), Some(filter)) = (self.smooth, self.filter)
            && smooth >= filter
        {
            let text = format!(
                "--smooth {smooth} takes away what --filter {filter} keeps: a smaller cut-off was expected of --smooth"
            );
            crate::usage_error("surface", ErrorKind::ArgumentConflict, &text);
        }
        let progress = Progress::new("surface", 0);
        let (mut each, mut densities) = (vec![], vec![]);
        for path in &self.files {
            let surface = self.prepared(path)?;
            let of = || path.display().to_string();
            each.push(surface.statistics(self.estimator.into()).with_context(of)?);
            if self.heights.is_some() {
                densities.push(surface.height_density().with_context(of)?);
            }
        }
        let statistics = match &each[..] {
            [first, second] => {
                let both =
                    || format!("{} and {}", self.files[0].display(), self.files[1].display());
                Statistics::combined(first, second).with_context(both)?
            }
            _ => each[0].clone(),
        };
        drop(progress);
        let mut said: Vec<String> = vec![];
        for (path, one) in self.files.iter().zip(&each) {
            let words = one.warnings.iter().map(|w| format!("{}: {w}", path.display()));
            said.extend(words);
        }
        if each.len() == 2 {
            said.extend(statistics.warnings.iter().map(|w| format!("both together: {w}")));
        }
        for text in crate::args::once(&said) {
            output::say("warning", &text);
        }
        if let (Some(path), Some(density)) = (&self.heights, densities.first()) {
            let (heights, values) = (&density.heights_m, &density.density_per_m);
            let points: Vec<(f64, f64)> =
                heights.iter().copied().zip(values.iter().copied()).collect();
            let text = asperity_scene::write_heights(&points);
            output::write(Some(path), |out| out.write_all(text.as_bytes()))?;
        }
        if let Some(path) = &self.scene {
            let text = self.scene_text(path, &statistics)?;
            output::write(Some(path), |out| out.write_all(text.as_bytes()))?;
            let said =
                "its materials and nominal area are the template's, steel on steel: put yours";
            output::say("note", &format!("{}: {said}", path.display()));
        }
        output::write(self.output.as_deref(), |out| match self.format {
            SurfaceFormat::Table => table(&statistics).write(Format::Table, out),
            SurfaceFormat::Json => {
                serde_json::to_writer_pretty(&mut *out, &statistics)?;
                writeln!(out)
            }
        })
    }

    /// Read, levelled and filtered.
    fn prepared(&self, path: &Path) -> Result<Topography> {
        let options = ReadOptions {
            unit: self.unit,
            pixel_size: self.pixel_size.map(|size| size.0),
            max_missing: self.max_missing,
        };
        let level = match self.level {
            LevelName::None => Level::None,
            LevelName::Plane => Level::Plane,
            LevelName::Quadratic => Level::Quadratic,
        };
        let read = asperity_topography::read(path, &options)?;
        let mut surface = read.with_periodic(self.periodic).level(level);
        if let Some(cutoff) = self.smooth {
            surface = surface.and_then(|surface| surface.smooth(cutoff));
        }
        if let Some(cutoff) = self.filter {
            surface = surface.and_then(|surface| surface.filter(cutoff));
        }
        surface.with_context(|| path.display().to_string())
    }

    /// The template's scene on this surface.
    fn scene_text(&self, path: &Path, statistics: &Statistics) -> Result<String> {
        let template = asperity_scene::parse(asperity_scene::template(), Path::new("."))?;
        let mut scene = template.scene;
        scene.surface = statistics.surface();
        let names: Vec<String> = self.files.iter().map(|path| path.display().to_string()).collect();
        let mut comments = [
            format!("Surface of {} (asperity surface)", names.join(" and ")),
            format!("estimator {:?}, level {:?}", self.estimator, self.level).to_lowercase(),
            "Materials and nominal area are placeholders, steel on steel: put yours.".into(),
        ];
        for (what, cutoff) in [("smooth", self.smooth), ("filter", self.filter)] {
            if let Some(cutoff) = cutoff {
                comments[1].push_str(&format!(", {what} {cutoff} m"));
            }
        }
        let heights = self.heights.as_deref().map(|file| beside(path, file)).transpose()?;
        let comments: Vec<&str> = comments.iter().map(String::as_str).collect();
        Ok(asperity_scene::write(&scene, &ModelOptions::default(), heights.as_deref(), &comments))
    }
}

/// The path of a file as a scene file at `scene` names it: from the scene's own folder where the
/// file is there or below, so that both can be moved together.
fn beside(scene: &Path, file: &Path) -> Result<String> {
    let scene = std::path::absolute(scene)?;
    let file = std::path::absolute(file)?;
    let folder = scene.parent().unwrap_or(Path::new(""));
    let named = file.strip_prefix(folder).unwrap_or(&file).to_path_buf();
    let text = named.into_os_string().into_string();
    text.map_err(|name| anyhow!("{} is no text, which a scene file needs", name.display()))
}

fn table(statistics: &Statistics) -> Table {
    let rows = [
        ("sq", statistics.sq, "m", "standard deviation of the heights"),
        ("ssk", statistics.ssk, "", "skewness of the heights"),
        ("sku", statistics.sku, "", "kurtosis of the heights, 3 for a Gaussian surface"),
        ("m0", statistics.m0, "m2", "profile moment <z^2>"),
        ("m2", statistics.m2, "", "profile moment <z'^2>"),
        ("m4", statistics.m4, "1/m2", "profile moment <z''^2>"),
        ("alpha", statistics.alpha, "", "bandwidth m0 m4/m2^2"),
        ("asperity_density", statistics.asperity_density, "1/m2", "eta"),
        ("asperity_radius", statistics.asperity_radius, "m", "R"),
        ("asperity_height_std", statistics.asperity_height_std, "m", "sigma_z"),
        ("beta", statistics.beta, "", "eta R sq"),
        ("beta_z", statistics.beta_z, "", "eta R sigma_z"),
        ("missing_share", statistics.missing_share, "", "share of missing points"),
    ];
    let mut table = Table::default();
    table.words("name", rows.iter().map(|row| row.0.into()).collect());
    table.numbers("value", "", rows.iter().map(|row| Some(row.1)).collect());
    table.words("unit", rows.iter().map(|row| row.2.into()).collect());
    table.words("meaning", rows.iter().map(|row| row.3.into()).collect());
    table
}
