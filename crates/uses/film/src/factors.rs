//! The tables and fits of Patir and Cheng: H (`film`) is the film over σ, γ the Peklenik number.

use asperity_core::{ContactError, require};

/// The coefficients of both papers for one γ.
struct Fit {
    gamma: f64,
    /// C and r of φ_x.
    pressure: [f64; 2],
    /// A₁, α₁, α₂, α₃ and A₂ of Φ_s.
    shear: [f64; 5],
    /// A₃, α₄, α₅ and α₆ of Φ_fs.
    friction: [f64; 4],
}

/// φ_x and Φ_s of Patir & Cheng 1978 and 1979, Φ_fs of 1979. \[seen\]
#[rustfmt::skip]
const FITS: [Fit; 7] = [
    Fit { gamma: 1.0 / 9.0, pressure: [1.48, 0.42], shear: [2.046, 1.12, 0.78, 0.03, 1.856], friction: [14.1, 2.45, 2.30, 0.10] },
    Fit { gamma: 1.0 / 6.0, pressure: [1.38, 0.42], shear: [1.962, 1.08, 0.77, 0.03, 1.754], friction: [13.4, 2.42, 2.30, 0.10] },
    Fit { gamma: 1.0 / 3.0, pressure: [1.18, 0.42], shear: [1.858, 1.01, 0.76, 0.03, 1.561], friction: [12.3, 2.32, 2.30, 0.10] },
    Fit { gamma: 1.0, pressure: [0.90, 0.56], shear: [1.899, 0.98, 0.92, 0.05, 1.126], friction: [11.1, 2.31, 2.38, 0.11] },
    Fit { gamma: 3.0, pressure: [0.225, 1.5], shear: [1.560, 0.85, 1.13, 0.08, 0.556], friction: [9.8, 2.25, 2.80, 0.18] },
    Fit { gamma: 6.0, pressure: [0.520, 1.5], shear: [1.290, 0.62, 1.09, 0.08, 0.388], friction: [10.1, 2.25, 2.90, 0.18] },
    Fit { gamma: 9.0, pressure: [0.870, 1.5], shear: [1.011, 0.54, 1.07, 0.08, 0.295], friction: [8.7, 2.15, 2.97, 0.18] },
];

/// The largest H of the fits of Φ_s and of Φ_fs by one formula.
const SHEAR_TO: f64 = 5.0;
const FRICTION_TO: f64 = 7.0;

/// φ_x, the pressure flow factor along the direction in which γ is measured, at H = `film`, the
/// film over σ.
///
/// # Errors
/// [`ContactError::OutOfRange`] for H below 0.5 (below 1 for γ below 1), and for γ outside 1/9
/// to 9.
pub fn pressure_flow_factor(film: f64, gamma: f64) -> Result<f64, ContactError> {
    let least = if gamma < 1.0 { FROM_1 } else { FROM_HALF };
    between(film, gamma, least, |Fit { gamma, pressure: [c, r], .. }| match *gamma > 1.0 {
        true => 1.0 + c * film.powf(-r),
        false => 1.0 - c * (-r * film).exp(),
    })
}

/// Φ_s, the shear flow factor of one surface at H = `film`; φ_s is the weighted difference of both.
///
/// # Errors
/// [`ContactError::OutOfRange`] for H below 0.5, and for γ outside 1/9 to 9.
pub fn shear_flow_factor(film: f64, gamma: f64) -> Result<f64, ContactError> {
    between(film, gamma, FROM_HALF, |Fit { shear: [a, one, two, three, tail], .. }| {
        match film > SHEAR_TO {
            true => tail * (-0.25 * film).exp(),
            false => a * film.powf(*one) * (three * film * film - two * film).exp(),
        }
    })
}

/// Φ_fs of one surface, what roughness adds to the friction of sliding at H = `film`; φ_fs is the
/// weighted difference of both. At H = 7 it falls to 0 by 0.004 to 0.023, for the largest and the
/// smallest γ.
///
/// # Errors
/// The errors of [`shear_flow_factor`].
pub fn friction_shear_factor(film: f64, gamma: f64) -> Result<f64, ContactError> {
    between(film, gamma, FROM_HALF, |Fit { friction: [a, four, five, six], .. }| {
        match film < FRICTION_TO {
            true => a * film.powf(*four) * (six * film * film - five * film).exp(),
            false => 0.0,
        }
    })
}

/// φ_f = h ⟨1/h_T⟩, the friction factor of sliding at H = `film`, over the local gaps h_T above
/// `cut_off` (over σ). Gaussian heights z (over σ) have the polynomial density (35/96)
/// (1 - (z/3)²)³; up to H = 3 terms of the order of the cut-off are left out, as printed: up to
/// 0.2 % at 0.01.
///
/// # Errors
/// [`ContactError::OutOfRange`] for H below 0.5, and for a cut-off outside 1e-6 to 0.1.
pub fn friction_factor(film: f64, cut_off: f64) -> Result<f64, ContactError> {
    require((1e-6..=0.1).contains(&cut_off), CUT_OFF, cut_off, "1e-6 to 0.1")?;
    at_least(film, FROM_HALF)?;
    let z = film / 3.0;
    let quartic = (1.0 - z * z).powi(3);
    let sum = match z <= 1.0 {
        true => {
            let powers = [-55.0, 132.0, 345.0, -160.0, -405.0, 60.0, 147.0];
            let polynomial = powers.iter().rev().fold(0.0, |sum, power| sum * z + power);
            quartic * (3.0 * (z + 1.0) / cut_off).ln() + polynomial / 60.0
        }
        // Both parts of the closed form below grow with z and cancel.
        false if z > FAR => return Ok(far(z)),
        false => {
            let rest = 66.0 + z * z * (30.0 * z * z - 80.0);
            quartic * ((z + 1.0) / (z - 1.0)).ln() + z / 15.0 * rest
        }
    };
    Ok(35.0 / 32.0 * z * sum)
}

/// The H/3 from which the series is more accurate than the closed form.
const FAR: f64 = 2.0;

/// ⟨z/(z + u)⟩ = Σ ⟨u²ⁿ⟩/z²ⁿ, with ⟨u²ⁿ⟩ of (35/32) (1 - u²)³ on -1 to 1; 20 terms leave 1e-16.
fn far(z: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 1.0);
    for n in 0..20_u32 {
        let n = f64::from(n);
        term *= (2.0 * n + 1.0) / (2.0 * n + 9.0) / (z * z);
        sum += term;
    }
    sum
}

/// φ_fp, the friction factor of the pressure gradient at H = `film`, of isotropic surfaces.
///
/// # Errors
/// [`ContactError::OutOfRange`] for H below 0.75, and for γ outside 0.9 to 1.1.
pub fn friction_pressure_factor(film: f64, gamma: f64) -> Result<f64, ContactError> {
    let required = "0.9 to 1.1, as of isotropic surfaces, for friction-pressure-factor,";
    require((0.9..=1.1).contains(&gamma), GAMMA, gamma, required)?;
    at_least(film, (0.75, "at least 0.75, the range of the fit of friction-pressure-factor,"))?;
    Ok(1.0 - 1.40 * (-0.66 * film).exp())
}

const GAMMA: &str = "peklenik_number";
pub(crate) const CUT_OFF: &str = "friction_cut_off";
const FILM: &str = "film over surface_height_std";
/// The least H of a fit, and its range.
const FROM_HALF: (f64, &str) = (0.5, "at least 0.5, the range of the fits,");
const FROM_1: (f64, &str) = (1.0, "at least 1, the range of the fits for a lay across the flow,");

fn at_least(film: f64, (least, required): (f64, &'static str)) -> Result<(), ContactError> {
    require(film >= least && film.is_finite(), FILM, film, required).map(drop)
}

/// The value of a fit at H and γ: between two γ of the tables, values are linear in ln γ.
fn between(
    film: f64,
    gamma: f64,
    least: (f64, &'static str),
    value: impl Fn(&Fit) -> f64,
) -> Result<f64, ContactError> {
    let [first, .., last] = &FITS;
    let holds = gamma >= first.gamma * (1.0 - 1e-9) && gamma <= last.gamma * (1.0 + 1e-9);
    require(holds, GAMMA, gamma, "1/9 to 9, the range of the tables,")?;
    at_least(film, least)?;
    let upper = FITS.iter().position(|fit| fit.gamma >= gamma).unwrap_or(FITS.len() - 1).max(1);
    let (below, beyond) = (&FITS[upper - 1], &FITS[upper]);
    let share = ((gamma / below.gamma).ln() / (beyond.gamma / below.gamma).ln()).clamp(0.0, 1.0);
    Ok((1.0 - share) * value(below) + share * value(beyond))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference: γ, H, and each value that it has.
    fn reference() -> Vec<[Option<f64>; 8]> {
        let text = include_str!("../../../../tests/reference/patir_cheng.csv");
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let row = |row: csv::StringRecord| std::array::from_fn(|k| row[k].parse().ok());
        reader.records().map(|record| row(record.unwrap())).collect()
    }

    #[test]
    fn values_at_and_between_the_tables_are_those_of_the_reference() {
        let rows = reference();
        assert_eq!(rows.len(), 12 * 16);
        for [gamma, film, wanted @ ..] in rows {
            let (gamma, film) = (gamma.unwrap(), film.unwrap());
            let found = [
                pressure_flow_factor(film, gamma),
                pressure_flow_factor(film, 1.0 / gamma),
                shear_flow_factor(film, gamma),
                friction_shear_factor(film, gamma),
                friction_factor(film, 0.01),
                friction_pressure_factor(film, gamma),
            ];
            for (k, (found, wanted)) in found.into_iter().zip(wanted).enumerate() {
                assert_eq!(found.is_ok(), wanted.is_some(), "{gamma} {film} {k}: {found:?}");
                let Some(wanted) = wanted else { continue };
                let off = (found.unwrap() - wanted).abs();
                // Up to H = 3 the printed φ_f leaves terms of the order of the cut-off out, and
                // just above it the cut-off still leaves out a few gaps.
                let close = match (k, film) {
                    (4, ..=2.99) => 0.35 * 0.01,
                    (4, ..=3.1) => 2e-7,
                    _ => 2e-14 * wanted.abs().max(1.0),
                };
                assert!(off <= close, "{gamma} {film} {k}: {wanted} {off:e}");
            }
        }
    }

    #[test]
    fn thick_films_are_smooth_and_a_lay_along_the_flow_helps_it() {
        for gamma in [1.0 / 9.0, 0.5, 1.0, 2.0, 9.0] {
            assert!((pressure_flow_factor(1e3, gamma).unwrap() - 1.0).abs() < 1e-3);
            assert!(shear_flow_factor(1e3, gamma).unwrap() < 1e-99);
            assert!(friction_shear_factor(1e3, gamma).unwrap() <= 0.0);
        }
        // ⟨1/(1 + z/H)⟩ = 1 + ⟨z²⟩/H², and the variance of the density is 1 as 9/9.
        assert!(((friction_factor(1e3, 0.01).unwrap() - 1.0) * 1e6 - 1.0).abs() < 1e-5);
        for film in [1.0, 2.0, 4.0, 6.0] {
            let gammas = (0..=200).map(|k| (f64::from(k) / 100.0 - 1.0) * 9f64.ln()).map(f64::exp);
            let values: Vec<f64> = gammas.map(|g| pressure_flow_factor(film, g).unwrap()).collect();
            assert!(values.windows(2).all(|pair| pair[1] >= pair[0]), "{film} {values:?}");
        }
    }

    #[test]
    fn a_cut_off_moves_the_friction_by_its_logarithm() {
        let z: f64 = 0.5;
        let fall = 35.0 / 32.0 * z * (1.0 - z * z).powi(3) * 10f64.ln();
        let found = friction_factor(1.5, 1e-3).unwrap() - friction_factor(1.5, 1e-2).unwrap();
        assert!((found - fall).abs() < 1e-13, "{found} {fall}");
    }

    #[test]
    fn films_and_lays_beyond_the_tables_are_refused() {
        let text = |found: Result<f64, ContactError>| found.unwrap_err().to_string();
        let thin = text(pressure_flow_factor(0.49, 1.0));
        assert!(thin.contains("is 0.49: at least 0.5"), "{thin}");
        assert!(text(pressure_flow_factor(0.9, 0.5)).contains("at least 1, "));
        assert!(pressure_flow_factor(0.9, 2.0).is_ok());
        for gamma in [0.1, 9.1, -1.0, f64::NAN] {
            assert!(text(shear_flow_factor(2.0, gamma)).starts_with("peklenik_number is "));
        }
        assert!(text(friction_pressure_factor(2.0, 3.0)).contains("0.9 to 1.1, "));
        for film in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(friction_factor(film, 0.01).is_err() && shear_flow_factor(film, 1.0).is_err());
        }
        assert!(text(friction_factor(2.0, 0.0)).starts_with("friction_cut_off is 0"));
    }
}
