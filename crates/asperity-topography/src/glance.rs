//! What decides how far a scan is to be trusted, and its parameters by ISO 25178-2.

use serde::Serialize;

use crate::{Level, PowerLaw, Spectra, Topography, TopographyError};

/// A scan at a glance, in SI units. `None` where a number does not exist: areal ones of a profile,
/// spectra with many missing points.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Glance {
    /// Form and filters applied before all other numbers.
    pub filter: String,
    /// Slope along rows of the plane removed.
    pub tilt_x: f64,
    /// Slope along columns of the plane removed.
    pub tilt_y: f64,
    /// Range of heights of the form removed, tilt included \[m\].
    pub form_height: f64,
    /// Rms slope across the lay over that along it.
    pub slope_ratio: Option<f64>,
    /// Direction of the lay \[degrees\] from rows towards columns.
    pub lay_direction: Option<f64>,
    /// Rms slope along the lay.
    pub slope_along_lay: Option<f64>,
    /// Rms slope across the lay.
    pub slope_across_lay: Option<f64>,
    /// The wavelength above which half of Sq² lies \[m\].
    pub long_wavelength: Option<f64>,
    /// How many of these wavelengths fit on the shorter side: 10 or more are wanted.
    pub long_waves: Option<f64>,
    /// m₂ over that of every second point.
    pub m2_over_half: Option<f64>,
    /// m₄ over that of every second point: 16 for noise, 1 where the pixel is small enough.
    pub m4_over_half: Option<f64>,
    /// Sa \[m\].
    pub sa: f64,
    /// Sz \[m\].
    pub sz: f64,
    /// Sp \[m\].
    pub sp: f64,
    /// Sv \[m\].
    pub sv: f64,
    /// Sdq.
    pub sdq: f64,
    /// Sdr, a ratio.
    pub sdr: Option<f64>,
    /// Sal \[m\].
    pub sal: Option<f64>,
    /// Str.
    pub str: Option<f64>,
    /// Spd \[1/m²\].
    pub spd: Option<f64>,
    /// Spc \[1/m\].
    pub spc: Option<f64>,
    /// Hurst exponent of the power law fitted to the radial spectrum.
    pub hurst: Option<f64>,
    /// The reason why there is none.
    pub hurst_missing: Option<String>,
    /// Its roll-off wavelength \[m\].
    pub roll_off: Option<f64>,
    /// The wavelength below which the spectrum leaves it \[m\].
    pub cut_off: Option<f64>,
    /// The spectra.
    #[serde(skip)]
    pub spectra: Option<Spectra>,
    /// The power law.
    #[serde(skip)]
    pub power_law: Option<PowerLaw>,
}

impl Glance {
    /// The report of a surface that was levelled, filled and filtered, and of the raw scan it was
    /// made from. `cutoffs` are those of the Gaussian filters \[m\]: short (S) and long (L).
    ///
    /// # Errors
    /// Those of [`Topography::parameters`], and of [`Topography::level`] for the raw scan.
    pub fn new(
        raw: &Topography,
        level: Level,
        cutoffs: [Option<f64>; 2],
        surface: &Topography,
    ) -> Result<Self, TopographyError> {
        let parameters = surface.parameters()?;
        let ([tilt_x, tilt_y], form_height) = raw.removed(level)?;
        let texture = surface.texture();
        let spectra = surface.spectra();
        let power_law = match &spectra {
            Ok(Spectra { radial: Some(radial), .. }) => {
                PowerLaw::fit(radial).map_err(|reason| reason.to_string())
            }
            Ok(_) => Err("a profile has no radial spectrum".into()),
            Err(reason) => Err(reason.to_string()),
        };
        let (power_law, hurst_missing) = match power_law {
            Ok(law) => (Some(law), None),
            Err(reason) => (None, Some(reason)),
        };
        let spectra = spectra.ok();
        let [dx, dy] = surface.pixel_size();
        let [width, height] = [surface.columns() as f64 * dx, surface.rows() as f64 * dy];
        let side = if surface.is_profile() { width } else { width.min(height) };
        let long_wavelength = spectra.as_ref().map(|spectra| spectra.median_wavelength);
        let [one, two] = [1, 2].map(|step| surface.at_distance(step));
        let ratio = |one: [Option<f64>; 2], two: [Option<f64>; 2]| {
            let square = |each: [Option<f64>; 2]| {
                each.into_iter().flatten().map(|rms| rms * rms).sum::<f64>()
            };
            Some(square(one) / square(two)).filter(|ratio| ratio.is_finite())
        };
        let slopes = [one, two].map(|at| [at.slope_rows, at.slope_columns]);
        let curvatures = [one, two].map(|at| [at.curvature_rows, at.curvature_columns]);
        let decay = surface.decay();
        let peaks = surface.peaks().ok();
        Ok(Self {
            filter: named(level, cutoffs),
            tilt_x,
            tilt_y,
            form_height,
            slope_ratio: texture.and_then(|texture| texture.ratio()),
            lay_direction: texture.map(|texture| texture.direction),
            slope_along_lay: texture.map(|texture| texture.slope_along),
            slope_across_lay: texture.map(|texture| texture.slope_across),
            long_wavelength,
            long_waves: long_wavelength.map(|length| side / length),
            m2_over_half: ratio(slopes[0], slopes[1]),
            m4_over_half: ratio(curvatures[0], curvatures[1]),
            sa: parameters.sa,
            sz: parameters.sz,
            sp: parameters.sp,
            sv: parameters.sv,
            sdq: parameters.sdq,
            sdr: parameters.sdr,
            sal: decay.map(|decay| decay.sal),
            str: decay.and_then(|decay| decay.str),
            spd: peaks.map(|peaks| peaks.spd),
            spc: peaks.and_then(|peaks| peaks.spc),
            hurst: power_law.map(|law| law.hurst),
            hurst_missing,
            roll_off: power_law.and_then(|law| law.roll_off),
            cut_off: power_law.and_then(|law| law.cut_off),
            spectra,
            power_law,
        })
    }
}

fn named(level: Level, [short, long]: [Option<f64>; 2]) -> String {
    let form = match level {
        Level::None => "no form removed".into(),
        level => format!("{level} removed"),
    };
    let filter = |name: &str, length: Option<f64>| match length {
        Some(length) => format!("Gaussian {name}-filter of {length:e} m"),
        None => format!("no {name}-filter"),
    };
    format!("{form}; {}; {}", filter("S", short), filter("L", long))
}

impl Topography {
    /// The slopes along rows and columns of the plane that levelling removes, and the range of
    /// heights of all that it removes \[m\].
    fn removed(&self, level: Level) -> Result<([f64; 2], f64), TopographyError> {
        if matches!(level, Level::None | Level::Mean) {
            return Ok(([0.0; 2], 0.0));
        }
        let [dx, dy] = self.pixel_size();
        let [last, foot] = [self.columns() - 1, self.rows() - 1];
        let plane = self.form(Level::Plane)?;
        let [near, far] = [plane.along_row(0), plane.along_row(foot)];
        let slope = |rise: f64, steps: usize, step: f64| match steps {
            0 => 0.0,
            steps => rise / (steps as f64 * step),
        };
        let tilt = [slope(near(last) - near(0), last, dx), slope(far(0) - near(0), foot, dy)];
        let form = self.form(level)?;
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for y in 0..=foot {
            let row = form.along_row(y);
            for height in (0..=last).map(row) {
                (low, high) = (low.min(height), high.max(height));
            }
        }
        Ok((tilt, high - low))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// Waves of 10 and 16 points on a tilted and bent form.
    fn scan() -> Topography {
        let height = |k: usize| {
            let (x, y) = ((k % 160) as f64, (k / 160) as f64);
            let waves = (TAU * x / 10.0).cos() + 0.1 * (TAU * y / 16.0).cos();
            1e-7 * waves + 2e-9 * x - 1e-9 * y
        };
        Topography::new((0..160 * 128).map(height).collect(), 160, [1e-6, 2e-6]).unwrap()
    }

    #[test]
    fn what_was_removed_and_what_is_left_are_reported() {
        let raw = scan();
        let level = raw.clone().level(Level::Plane).unwrap();
        let found = Glance::new(&raw, Level::Plane, [None, Some(8e-5)], &level).unwrap();
        // Whole waves of cosines have a small plane of their own.
        assert!((found.tilt_x / 2e-3 - 1.0).abs() < 2e-2, "{found:?}");
        assert!((found.tilt_y / -0.5e-3 - 1.0).abs() < 1e-2, "{found:?}");
        assert!((found.form_height / (159.0 * 2e-9 + 127e-9) - 1.0).abs() < 2e-2);
        assert_eq!(found.filter, "plane removed; no S-filter; Gaussian L-filter of 8e-5 m");
        let ratio = (10.0 * 32e-6 / 10e-6) * 0.99;
        assert!((found.slope_ratio.unwrap() / ratio - 1.0).abs() < 0.05, "{found:?}");
        assert!((found.lay_direction.unwrap().abs() - 90.0).abs() < 0.5, "{found:?}");
        assert!((found.long_wavelength.unwrap() / 10e-6 - 1.0).abs() < 0.05, "{found:?}");
        assert!((found.long_waves.unwrap() / 16.0 - 1.0).abs() < 0.05, "{found:?}");
        // Differences over two pixels see less of a wave of ten: cos²(π/10), and its square.
        let gain = (TAU / 20.0).cos().powi(-2);
        assert!((found.m2_over_half.unwrap() / gain - 1.0).abs() < 0.02, "{found:?}");
        assert!((found.m4_over_half.unwrap() / gain.powi(2) - 1.0).abs() < 0.02, "{found:?}");
        let json = serde_json::to_value(&found).unwrap();
        assert!(json["filter"].is_string() && json["sal"].is_number() && json["spectra"].is_null());
    }

    #[test]
    fn profiles_have_what_profiles_have() {
        let profile = Topography::new(scan().heights()[..160].to_vec(), 160, [1e-6; 2]).unwrap();
        let found = Glance::new(&profile, Level::None, [None; 2], &profile).unwrap();
        assert!(found.slope_ratio.is_none() && found.spd.is_none() && found.str.is_none());
        assert!(found.long_waves.is_some() && found.sal.is_some() && found.hurst.is_none());
        assert_eq!(found.hurst_missing.as_deref(), Some("a profile has no radial spectrum"));
        assert_eq!(found.filter, "no form removed; no S-filter; no L-filter");
    }
}
