//! `asperity generate`: a random surface with a given spectrum.

use asperity::{Code, unusual};
use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::bem::RandomSurface;
use asperity_answer::rounded;
use asperity_topography::Topography;
use clap::Args;

use crate::input::args::file_ending;
use crate::input::lists::sizes;
use crate::input::numbers::{length, number, positive_number, whole};
use crate::input::valid;
use crate::output::{self, contact_map};

/// Make a random rough surface: Hurst exponent, cut-offs, lay, skewness; as a scan
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../help/generate.txt")
)]
pub struct Generate {
    /// Hurst exponent, 0 to 1
    #[arg(long, value_name = "H", value_parser = number, default_value = "0.8")]
    hurst: f64,
    /// Longest wave, in m or with a unit
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    long: f64,
    /// Wave above which the spectrum is flat, in m or with a unit [default: the longest]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    roll_off: Option<f64>,
    /// Shortest wave, in m or with a unit; more than two pixels
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    short: f64,
    /// Points along a row and along a column, for example 512x512
    #[arg(long, value_name = "NXxNY", value_parser = size)]
    size: [usize; 2],
    /// Distance between neighbouring points along a row (and along a column), in m or with a unit
    #[arg(long, value_name = "DX[xDY]", value_parser = pixel)]
    pixel: [f64; 2],
    /// Sq, the standard deviation of the heights, in m or with a unit
    #[arg(long, value_name = "LENGTH", value_parser = length, required_unless_present = "gradient")]
    sq: Option<f64>,
    /// The rms gradient instead
    #[arg(long, value_name = "G", value_parser = positive_number, conflicts_with = "sq")]
    gradient: Option<f64>,
    /// Skewness of the heights, -5 to 5 [default: near 0, of random phases]
    #[arg(long, value_name = "SSK", value_parser = number)]
    skewness: Option<f64>,
    /// Rms slope across the lay over that along it
    #[arg(long, value_name = "RATIO", value_parser = number, default_value = "1")]
    anisotropy: f64,
    /// Direction of the lay in degrees, from the rows (x) towards the columns (y)
    #[arg(long, value_name = "DEGREES", value_parser = number, default_value = "0")]
    direction: f64,
    /// Another surface of the same spectrum
    #[arg(long, value_name = "N", value_parser = whole, default_value = "0")]
    seed: u64,
    /// File of the heights: .npy (heights in m, without pixel size) or .x3p
    #[arg(long, value_name = "FILE")]
    #[arg(value_parser = file_ending(&["npy", "x3p"], "surfaces are written as npy or x3p"))]
    output: PathBuf,
}

impl Generate {
    pub fn run(self) -> Result<()> {
        let surface = valid(self.surface());
        let [columns, rows] = self.size;
        let [dx, dy] = self.pixel;
        let side = (columns as f64 * dx).max(rows as f64 * dy);
        let gradient = (2.0 * surface.moments().m2).sqrt();
        if gradient > 1.0 {
            let gradient = rounded(gradient);
            let text = "half-space contact assumes slopes well below 1; reduce --sq or --gradient, or lengthen --short";
            let found = format!("the rms gradient is {gradient} (usual: at most 1): {text}");
            output::warn(Code::UnusualSize, found);
        }
        if self.long > side {
            let made = format!("surface of {} m; those up to its side are made", rounded(side));
            output::warn(Code::LongWaves, format!("waves up to --long do not fit on the {made}"));
        }
        for (option, key, value) in [
            ("--long", "wavelength", Some(self.long)),
            ("--short", "wavelength", Some(self.short)),
            ("--pixel", "wavelength", Some(dx)),
            ("--roll-off", "wavelength", self.roll_off),
            ("--sq", "sq", self.sq),
        ] {
            if let Some(mut found) = value.and_then(|value| unusual(key, value)) {
                found.field = option.into();
                output::show([&found]);
            }
        }
        let map = valid(surface.map([rows, columns]));
        let shape = map.shape();
        if self.output.extension().is_some_and(|end| end.eq_ignore_ascii_case("x3p")) {
            let surface = Topography::new(map.heights().to_vec(), shape[1], self.pixel)?;
            let bytes = surface.x3p()?;
            return output::write(Some(&self.output), |out| out.write_all(&bytes));
        }
        contact_map::write(&self.output, &[map.heights()], shape)?;
        let text = format!("read it with --unit m --pixel-size {dx:e}x{dy:e} --periodic");
        output::print_results(&[format!("{}: heights in m; {text}", self.output.display())]);
        Ok(())
    }

    fn surface(&self) -> Result<RandomSurface> {
        let Self { hurst, long, short, size: [columns, rows], pixel: [dx, dy], .. } = *self;
        let lengths = [long, self.roll_off.unwrap_or(long), short];
        let size = [columns as f64 * dx, rows as f64 * dy];
        let surface = RandomSurface::of_wavelengths(lengths, size)?.hurst(hurst)?.seed(self.seed);
        let mut surface = match (self.sq, self.gradient) {
            (Some(sq), _) => surface.rms_height(sq)?,
            (None, gradient) => surface.gradient(gradient.context("--sq or --gradient")?)?,
        };
        surface = surface.lay(self.anisotropy, self.direction)?;
        if let Some(skewness) = self.skewness {
            surface = surface.skewness(skewness)?;
        }
        Ok(surface)
    }
}

fn size(text: &str) -> Result<[usize; 2], String> {
    let most = asperity_topography::MAX_POINTS;
    let sides = text.split_once('x').and_then(|(nx, ny)| Some([whole(nx).ok()?, whole(ny).ok()?]));
    let fits = |[nx, ny]: &[u64; 2]| (1..=most as u64).contains(&nx.saturating_mul(*ny));
    let sides = sides.filter(fits).map(|sides| sides.map(|n| n as usize));
    let required = || format!("NXxNY was required, for example 512x512, of at most {most} points");
    sides.ok_or_else(required)
}

fn pixel(text: &str) -> Result<[f64; 2], String> {
    sizes(text, length)
}
