//! Plain arrays of values: equal to single values within both bounds, for every model and place.

use asperity::{
    Contact, ContactError, FillReport, HeightDistribution, Model, Quantity, Request, Tolerance,
    WeibullHeights,
};

use crate::is_long;
use crate::scenes::{named, with_index};

/// Multiples of integrals, and one that is not, which is filled value by value.
const ASKED: [Quantity; 7] = [
    Quantity::Force,
    Quantity::Tangent,
    Quantity::Area,
    Quantity::Contacts,
    Quantity::Pressure,
    Quantity::AreaFraction,
    Quantity::MeanPressure,
];

fn filled(
    contact: &dyn Contact,
    asked: &[Quantity],
    s: &[f64],
) -> Result<(Vec<Vec<f64>>, FillReport), ContactError> {
    let mut columns = vec![vec![f64::NAN; s.len()]; asked.len()];
    let mut out: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let known = contact.fill(asked, s, &mut out)?;
    Ok((columns, known))
}

#[test]
fn arrays_hold_the_single_values() {
    // More than two chunks, scrambled, with the far tail and separations far below 0.
    let near: Vec<f64> = (0..300).map(|k| -1.0 + 6.0 * f64::from(k * 619 % 300) / 300.0).collect();
    let far: Vec<f64> = (0..40).map(|k| -40.0 + 2.03 * f64::from(k)).collect();
    let skewed = HeightDistribution::Weibull(WeibullHeights::new(-0.4).unwrap());
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential, skewed] {
        // The last three laws do not begin at an interference of 0.
        for id in ["gw", "ke", "jg", "at", "dmt", "jkr-separation", "gw-random"] {
            let is_slow = matches!(id, "jg" | "at" | "jkr-separation" | "gw-random");
            if is_slow && !is_long() && !matches!(heights, HeightDistribution::Gaussian) {
                continue;
            }
            let model: Model = id.parse().unwrap();
            let mut scene = with_index(2.0);
            scene.interface.work_of_adhesion = Some(300.0);
            if id.ends_with("-random") {
                scene.surface.asperity_density *= 10.0; // a surface that exists
            } else {
                scene.heights = heights.clone();
            }
            let request = Request::new(ASKED).within(Tolerance::new(1e-10).unwrap());
            let contact = model.compile(&scene, &request).unwrap();
            let both = |s| [(&ASKED[..6], s), (&ASKED[6..], s)];
            for (asked, s) in [both(&near), both(&far)].concat() {
                let Ok((columns, known)) = filled(&*contact, asked, s) else {
                    // A single value is then refused too.
                    let refused =
                        |q: &Quantity| s.iter().any(|s| contact.evaluate(*q, *s).is_err());
                    assert!(asked.iter().any(refused), "{id}");
                    assert!(!std::ptr::eq(s, &near), "{id}");
                    continue;
                };
                let (mut largest, mut condition) = (0.0_f64, 1.0_f64);
                for (quantity, column) in asked.iter().zip(&columns) {
                    for (s, value) in s.iter().zip(column) {
                        let wanted = contact.evaluate(*quantity, *s).unwrap();
                        largest = largest.max(wanted.bound(*quantity));
                        condition = condition.max(wanted.condition());
                        // An array has its own exponential and one product with the factor: the
                        // last digits differ, within both bounds.
                        let allowed =
                            (known.bound + wanted.bound(*quantity)) * wanted.value().abs();
                        let off = (value - wanted.value()).abs();
                        // Values that underflow are computed one at a time.
                        let same = value.to_bits() == wanted.value().to_bits();
                        assert!(same || off <= allowed, "{id} {quantity} {s}: {value} {wanted:?}");
                    }
                }
                // The bound is no smaller and not much larger; the cancellation belongs to the step
                // in s where the worst value is, or of the value by itself where steps vary more.
                let FillReport { bound, .. } = known;
                assert!(
                    bound >= 0.999 * largest && bound <= 3.0 * largest,
                    "{id}: {bound:e} {largest:e}"
                );
                assert!(
                    (1.0 - 1e-12..1.5).contains(&(known.condition / condition)),
                    "{id}: {known:?} {condition}"
                );
            }
        }
    }
}

#[test]
fn refused_arrays_name_the_separation() {
    let scene = named("at-paper");
    let request = Request::new([Quantity::Force]);
    let contact = "ke".parse::<Model>().unwrap().compile(&scene, &request).unwrap();
    let fill = |quantities: &[Quantity], s: &[f64], lengths: &[usize]| {
        let mut columns: Vec<Vec<f64>> = lengths.iter().map(|n| vec![0.0; *n]).collect();
        let mut out: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        contact.fill(quantities, s, &mut out).unwrap_err().to_string()
    };
    let force = Quantity::Force;
    for (found, wanted) in [
        (fill(&[force], &[1.0], &[]), "columns is 0"),
        (fill(&[force], &[1.0], &[2]), "column is 2"),
        (fill(&[force], &[1.0, f64::NAN], &[2]), "NaN"),
        (fill(&[Quantity::Area], &[1.0], &[1]), "area"),
    ] {
        assert!(found.contains(wanted), "{found}");
    }
}

#[test]
fn arrays_refuse_the_separations_that_single_values_refuse() {
    let scene = with_index(2.0);
    for id in ["gw", "ke", "gao"] {
        let model: Model = id.parse().unwrap();
        let contact = model.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        for wrong in [-1.000_000_1e6, -1e9, f64::NAN, f64::NEG_INFINITY, 2e9] {
            for length in [1, 16, 2000] {
                let mut s = vec![1.0; length];
                s[length / 2] = wrong;
                let refused = filled(&*contact, &[Quantity::Force], &s);
                assert!(refused.is_err(), "{id} {wrong} in {length}");
            }
        }
        let (columns, _) = filled(&*contact, &[Quantity::Force], &[-1e6; 16]).unwrap();
        assert!(columns[0].iter().all(|force| *force > 0.0), "{id}");
    }
}
