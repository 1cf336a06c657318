//! The report of a scan: what decides how far it is to be trusted, parameters by ISO 25178-2,
//! moments and asperities.

use std::borrow::Cow;

use asperity_core::{ProfileMoments, Surface};
use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::topography::extremes;
use crate::{
    Level, Outliers, Parameters, PowerLaw, Spectra, Statistics, Texture, Topography,
    TopographyError,
};

/// A number of the report of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Reported {
    /// The name: `sq`.
    pub name: &'static str,
    /// The number in its unit; `None` where it does not exist: areal ones of a profile, spectra
    /// with many missing points.
    pub value: Option<f64>,
    /// The SI unit, or `deg`; empty for none.
    pub unit: &'static str,
    /// Its meaning, or the reason why there is none.
    pub meaning: Cow<'static, str>,
}

/// Name, value, unit and meaning.
pub(crate) type Number = (&'static str, Option<f64>, &'static str, &'static str);

pub(crate) fn reported((name, value, unit, meaning): Number) -> Reported {
    Reported { name, value, unit, meaning: meaning.into() }
}

/// A scan at a glance, in SI units.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Glance {
    /// The number of points, with their rows, columns and distances.
    pub points: Reported,
    /// Form and filters applied before all other numbers.
    pub filter: String,
    /// What decides how far the scan is to be trusted, from `tilt_x` to `m4_over_half`; what ISO
    /// 25178-2 defines, and the power law, from `sa` to `cut_off`.
    pub numbers: [Reported; 24],
    /// Height and hybrid parameters.
    pub parameters: Parameters,
    /// Direction of the lay.
    pub texture: Option<Texture>,
    /// The spectra.
    pub spectra: Option<Spectra>,
    /// The power law fitted to the radial spectrum, or the reason why there is none.
    pub power_law: Result<PowerLaw, String>,
}

/// An object of all numbers, with `hurst_exponent_missing`, the reason where there is no power law.
impl Serialize for Glance {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("points", &self.points.value)?;
        map.serialize_entry("filtered", &self.filter)?;
        for number in &self.numbers {
            map.serialize_entry(number.name, &number.value)?;
            if number.name == "hurst_exponent" {
                map.serialize_entry("hurst_exponent_missing", &self.power_law.as_ref().err())?;
            }
        }
        map.end()
    }
}

impl Glance {
    /// The report of a surface that was levelled, filled and filtered, and of the raw scan it was
    /// made from. `cutoffs` are those of the Gaussian filters \[m\]: short (S) and long (L).
    ///
    /// # Errors
    /// The errors of [`Topography::parameters`], and of [`Topography::level`] for the raw scan.
    pub fn new(
        raw: &Topography,
        level: Level,
        cutoffs: [Option<f64>; 2],
        surface: &Topography,
    ) -> Result<Self, TopographyError> {
        let parameters = surface.parameters()?;
        let ([tilt_x, tilt_y], form_height) = raw.removed(level)?;
        let texture = surface.moments()?.texture();
        let spectra = surface.spectra();
        let power_law = match &spectra {
            Ok(Spectra { radial: Some(radial), .. }) => PowerLaw::fit(radial),
            Ok(_) => Err("a profile has no radial spectrum".into()),
            Err(reason) => Err(reason.to_string()),
        };
        let (spectra, law) = (spectra.ok(), power_law.as_ref().ok());
        let [dx, dy] = surface.pixel_size();
        let [width, height] = [surface.columns() as f64 * dx, surface.rows() as f64 * dy];
        let side = if surface.is_profile() { width } else { width.min(height) };
        let long = spectra.as_ref().map(|spectra| spectra.median_wavelength);
        let [one, two] = [1, 2].map(|step| surface.at_distance(step));
        let [m2_over_half, m4_over_half] = [0, 1].map(|of| {
            let square =
                |at: [Option<f64>; 2]| at.into_iter().flatten().map(|x| x * x).sum::<f64>();
            Some(square(one[of]) / square(two[of])).filter(|ratio| ratio.is_finite())
        });
        let decay = surface.decay();
        let peaks = surface.peaks().ok();
        let of_lay = |of: fn(Texture) -> f64| texture.map(of);
        let (slope_ratio, lay) = (texture.and_then(|lay| lay.ratio()), of_lay(|lay| lay.direction));
        let waves = long.map(|length| side / length);
        let Parameters { sa, sz, sp, sv, sdq, sdr, .. } = parameters;
        let (sal, str) = (decay.map(|decay| decay.sal), decay.and_then(|decay| decay.str));
        let (spd, spc) = (peaks.map(|peaks| peaks.spd), peaks.and_then(|peaks| peaks.spc));
        let (hurst, ends) = (law.map(|law| law.hurst), law.map(|law| [law.roll_off, law.cut_off]));
        let [roll_off, cut_off] = ends.unwrap_or_default();
        let numbers: [Number; 24] = [
            ("tilt_x", Some(tilt_x), "", "slope along rows of the plane removed"),
            ("tilt_y", Some(tilt_y), "", "slope along columns of the plane removed"),
            ("form_height", Some(form_height), "m", "height of the form removed, with its tilt"),
            ("slope_ratio", slope_ratio, "", "rms slope across the lay over that along it"),
            ("lay_direction", lay, "deg", "lay, from rows (x) towards columns (y)"),
            (ALONG, of_lay(|lay| lay.slope_along), "", "rms slope along the lay"),
            (ACROSS, of_lay(|lay| lay.slope_across), "", "rms slope across the lay"),
            ("long_wavelength", long, "m", "half of Sq^2 is in longer waves"),
            ("long_waves", waves, "", "of them on the shorter side: 10 or more are wanted"),
            ("m2_over_half", m2_over_half, "", "m2 over that of every second point"),
            ("m4_over_half", m4_over_half, "", "likewise m4: 1 if resolved, 16 for noise"),
            ("sa", Some(sa), "m", "mean distance from the mean"),
            ("sz", Some(sz), "m", "from the lowest to the highest point"),
            ("sp", Some(sp), "m", "highest point above the mean"),
            ("sv", Some(sv), "m", "lowest point below the mean"),
            ("sdq", Some(sdq), "", "rms gradient"),
            ("sdr", sdr, "", "developed area over the nominal one, less 1"),
            ("sal", sal, "m", "shortest length of decay of the autocorrelation to 0.2"),
            ("str", str, "", "shortest over longest: 1 for an isotropic surface"),
            ("spd", spd, "1/m2", "density of peaks; hills below 5 % of sz pruned"),
            ("spc", spc, "1/m", "mean curvature of these peaks"),
            ("hurst_exponent", hurst, "", "Hurst exponent fitted to the radial spectrum"),
            ("roll_off", roll_off, "m", "wavelength above which the spectrum is flat"),
            ("cut_off", cut_off, "m", "wavelength below which it leaves the power law"),
        ];
        let mut numbers = numbers.map(reported);
        if let Err(reason) = &power_law {
            numbers[TRUST + 10].meaning = reason.clone().into();
        }
        let filter = named(level, cutoffs);
        let (rows, columns) = (surface.rows(), surface.columns());
        let [x, y] = [dx, dy].map(|step| asperity_core::short(step / 1e-6));
        let points = Reported {
            meaning: format!("{columns} along rows x {rows}, {x} um x {y} um apart").into(),
            ..reported(("points", Some((rows * columns) as f64), "", ""))
        };
        Ok(Self { points, filter, numbers, parameters, texture, spectra, power_law })
    }
}

/// Numbers that decide trust.
const TRUST: usize = 11;
/// Slopes that stand in data, but not in a table, which has their ratio.
const ALONG: &str = "slope_along_lay";
const ACROSS: &str = "slope_across_lay";

/// What decides trust, parameters of ISO 25178-2, moments and asperities, in this order; of two
/// surfaces in contact the statistics alone.
#[must_use]
pub fn report(statistics: &Statistics, glance: Option<&Glance>) -> Vec<Reported> {
    let [sq, ssk, sku, moments @ .., missing, _, count, largest, share] = statistics.numbers();
    let mut all = vec![missing, count, largest, share];
    let Some(Glance { points, filter, numbers, .. }) = glance else {
        all.extend([ssk, sku, sq].into_iter().chain(moments));
        return all;
    };
    all.insert(0, points.clone());
    let (trust, parameters) = numbers.split_at(TRUST);
    let shown = |number: &&Reported| ![ALONG, ACROSS].contains(&number.name);
    all.extend(trust.iter().filter(shown).cloned());
    let filter =
        Reported { meaning: filter.clone().into(), ..reported(("filtered", None, "", "")) };
    all.extend([ssk, sku, filter, sq]);
    all.extend(parameters.iter().cloned().chain(moments));
    all
}

impl Statistics {
    /// The numbers, in the order of the fields.
    #[must_use]
    pub fn numbers(&self) -> [Reported; 17] {
        let Outliers { count, largest, m4_share, .. } = self.outliers;
        let ProfileMoments { m0, m2, m4 } = self.moments.profile;
        let of = |number: fn(&Surface) -> f64| self.asperities.as_ref().ok().map(number);
        let all: [Number; 17] = [
            ("sq", Some(self.sq), "m", "standard deviation of the heights"),
            ("ssk", Some(self.ssk), "", "skewness of the heights"),
            ("sku", Some(self.sku), "", "kurtosis of the heights, 3 for a Gaussian surface"),
            ("m0", Some(m0), "m2", "profile moment <z^2>"),
            ("m2", Some(m2), "", "profile moment <z'^2>"),
            ("m4", Some(m4), "1/m2", "profile moment <z''^2>"),
            ("alpha", Some(self.moments.profile.bandwidth()), "", "bandwidth m0 m4/m2^2"),
            ("asperity_density", of(|one| one.asperity_density), "1/m2", "eta"),
            ("asperity_radius", of(|one| one.asperity_radius), "m", "R"),
            ("asperity_height_std", of(|one| one.asperity_height_std), "m", "sigma_z"),
            ("beta", self.beta(), "", "eta R sq"),
            ("beta_z", of(Surface::roughness_parameter), "", "eta R sigma_z"),
            ("missing_share", Some(self.missing_share), "", "share of missing points"),
            ("despiked", Some(self.despiked as f64), "", "replaced outliers"),
            ("outliers", Some(count as f64), "", "points far outside their neighbours"),
            ("outlier_largest", Some(largest), "m", "the furthest, above (+) or below (-)"),
            ("outlier_m4_share", Some(m4_share), "", "share of m4 due to outliers"),
        ];
        all.map(reported)
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
        let rows = (0..=foot).flat_map(|y| (0..=last).map(form.along_row(y)));
        let [low, high] = extremes(&rows.collect::<Vec<_>>());
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
        let number = |name: &str| {
            found.numbers.iter().find(|number| number.name == name).and_then(|number| number.value)
        };
        let of = |name: &str| number(name).unwrap();
        assert!((of("tilt_x") / 2e-3 - 1.0).abs() < 2e-2, "{found:?}");
        assert!((of("tilt_y") / -0.5e-3 - 1.0).abs() < 1e-2, "{found:?}");
        assert!((of("form_height") / (159.0 * 2e-9 + 127e-9) - 1.0).abs() < 2e-2);
        assert!(found.filter.contains("plane") && found.filter.contains("8e-5 m"));
        let ratio = (10.0 * 32e-6 / 10e-6) * 0.99;
        assert!((of("slope_ratio") / ratio - 1.0).abs() < 0.05, "{found:?}");
        assert!((of("lay_direction").abs() - 90.0).abs() < 0.5, "{found:?}");
        assert!((of("long_wavelength") / 10e-6 - 1.0).abs() < 0.05, "{found:?}");
        assert!((of("long_waves") / 16.0 - 1.0).abs() < 0.05, "{found:?}");
        // Differences over two pixels see less of a wave of ten: cos²(π/10), and its square.
        let gain = (TAU / 20.0).cos().powi(-2);
        assert!((of("m2_over_half") / gain - 1.0).abs() < 0.02, "{found:?}");
        assert!((of("m4_over_half") / gain.powi(2) - 1.0).abs() < 0.02, "{found:?}");
        let json = serde_json::to_value(&found).unwrap();
        assert!(
            json["filtered"].is_string() && json["sal"].is_number() && json["spectra"].is_null()
        );
    }

    #[test]
    fn profiles_have_what_profiles_have() {
        let profile = Topography::new(scan().heights()[..160].to_vec(), 160, [1e-6; 2]).unwrap();
        let found = Glance::new(&profile, Level::None, [None; 2], &profile).unwrap();
        let has = |name: &str| found.numbers.iter().any(|n| n.name == name && n.value.is_some());
        assert!(["long_waves", "sal"].map(has).iter().all(|has| *has));
        assert!(!["slope_ratio", "spd", "str", "hurst"].map(has).contains(&true));
        assert!(found.power_law.is_err());
    }
}
