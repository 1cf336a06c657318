//! Lines that the other lines contradict.

use asperity_core::{Datum, Quantity, Severity};
use asperity_fit::{Data, Fit, Fitted, MeasuredTable};
use asperity_ke::KogutEtsion;

use crate::kit::{LOADS, columns, data, is_long, normal, parameters, varied};

fn outlier_of(fitted: &Fitted) -> Option<String> {
    fitted.doubts.texts("outlier").pop()
}

#[test]
fn one_line_that_the_others_contradict_is_named_and_kept() {
    let columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    let scene = varied(&[2]);
    let fitted = |factors: [f64; 5], lines: Vec<usize>| {
        let mut columns = columns.clone();
        for (value, factor) in columns[1].1.iter_mut().flatten().zip(factors) {
            *value *= factor;
        }
        let table = MeasuredTable { columns, lines };
        let data = Data::from_table(&table, Datum::AsperityMean).unwrap();
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    let off = [1.03, 0.97, 1.03, 100.0, 0.97];
    let found = fitted(off, vec![2, 3, 5, 6, 7]);
    let outlier = outlier_of(&found).unwrap();
    assert!(
        outlier.starts_with("line 6 (tangent_N_per_m = ")
            && outlier.contains(" at load_N = 300) deviates by a factor of 100 from a fit"),
        "{outlier}"
    );
    let others =
        " to the other lines, which agree within 3 % (root mean square); check or remove it";
    assert!(outlier.ends_with(others), "{outlier}");
    let misfit = found.misfit().unwrap();
    let size =
        "no values within the bounds describe the data: fitted values deviate by a factor of 6";
    assert!(misfit.starts_with(size) && misfit.ends_with(others), "{misfit}");
    assert_eq!(found.residuals.len(), 5);
    // Of arrays the row; a smaller error leaves data that are described.
    let found = fitted([1.01, 0.99, 2.0, 1.01, 0.99], vec![]);
    let outlier = outlier_of(&found).unwrap();
    let wanted = " deviates by a factor of 2 from a fit to the other rows";
    assert!(outlier.starts_with("row 3 (") && outlier.contains(wanted), "{outlier}");
    assert_eq!(found.misfit(), None);
    // Scatter is no outlier.
    assert_eq!(outlier_of(&fitted([1.3, 0.8, 1.1, 0.7, 1.2], vec![])), None);
}

#[test]
fn one_line_is_named_among_three() {
    let mut columns = columns(&KogutEtsion, &LOADS[..3], &[Quantity::Area]);
    columns[1].1[1] = columns[1].1[1].map(|area| 1e6 * area);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
        outlier_of(&fit.run(&KogutEtsion).unwrap())
    };
    let outlier = fitted(&columns).unwrap();
    assert!(outlier.starts_with("row 2 (area_m2 = "), "{outlier}");
    // Three values that scatter contradict no line.
    columns[1].1 = vec![Some(5e-9), Some(3e-8), Some(7e-7)];
    assert_eq!(fitted(&columns), None);
}

#[test]
fn a_share_deviates_by_a_difference() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::ElasticShare]);
    columns[1].1[2] = columns[1].1[2].map(|share| share + 0.5);
    let data = data(&columns);
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.1), &scene).unwrap();
    let outlier = outlier_of(&fit.run(&KogutEtsion).unwrap()).unwrap();
    let wanted = "deviates by 0.5 from a fit to the other rows, which agree within 1e-8 (root";
    assert!(outlier.contains(wanted), "{outlier}");
}

/// Tangents of KE whose first is twice the true one, with a standard deviation for each.
fn doubled(std: impl Fn(f64) -> f64) -> Fitted {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    columns[1].1[0] = columns[1].1[0].map(|value| 2.0 * value);
    let std = columns[1].1.iter().map(|value| value.map(&std)).collect();
    columns.push((format!("{}_std", columns[1].0), std));
    let data = data(&columns);
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
    fit.run(&KogutEtsion).unwrap()
}

#[test]
fn a_line_many_standard_deviations_off_is_named() {
    for (share, far) in [(0.001, "500"), (0.01, "50"), (0.03, "17")] {
        let found = doubled(|value| share * value);
        let outlier = outlier_of(&found).unwrap();
        let wanted = format!(" deviates by {far} standard deviations from a fit to the other rows");
        assert!(outlier.starts_with("row 1 (") && outlier.contains(&wanted), "{outlier}");
        // One reason is enough: the line, or the standard deviations.
        let [only] = &found.doubts[..] else { panic!("{found:?}") };
        assert_eq!((only.code, only.severity), ("outlier", Severity::Warning));
    }
}

/// The outlier of tangents of KE under twelve loads, scattered by 1 %, with some rows multiplied.
fn outlier_of_twelve(off: &[(usize, f64)], std: Option<f64>) -> Option<String> {
    let loads: Vec<f64> = (0..12).map(|k| 2f64.powi(k)).collect();
    let mut columns = columns(&KogutEtsion, &loads, &[Quantity::Tangent]);
    let clean = columns[1].1.clone();
    for (k, value) in columns[1].1.iter_mut().flatten().enumerate() {
        *value *= 1.0 + 0.01 * (2.4 * k as f64).cos();
    }
    for (row, factor) in off {
        columns[1].1[row - 1] = clean[row - 1].map(|value| factor * value);
    }
    if let Some(share) = std {
        let std = clean.iter().map(|value| value.map(|value| share * value)).collect();
        columns.push((format!("{}_std", columns[1].0), std));
    }
    let data = data(&columns);
    let scene = varied(&[2]);
    outlier_of(&Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap())
}

#[test]
fn two_lines_that_the_others_contradict_are_named_together() {
    let outlier = outlier_of_twelve(&[(3, 10.0), (9, 0.1)], None).unwrap();
    assert!(outlier.starts_with("row 3 (") && outlier.contains(" and row 9 ("), "{outlier}");
    let sizes = " deviate by a factor of 10 and a factor of 10 from a fit to the other rows, which";
    assert!(outlier.contains(sizes) && outlier.ends_with("; check or remove them"), "{outlier}");
    // A second line is named beside a first that is much farther.
    let outlier = outlier_of_twelve(&[(3, 1000.0), (9, 2.0)], None).unwrap();
    assert!(outlier.starts_with("row 3 (") && outlier.contains(" and row 9 ("), "{outlier}");
    // One line is named alone.
    let outlier = outlier_of_twelve(&[(4, 3.0)], None).unwrap();
    assert!(outlier.starts_with("row 4 (") && !outlier.contains(" and row"), "{outlier}");
    assert_eq!(outlier_of_twelve(&[], None), None);
}

#[test]
fn a_line_sixteen_standard_deviations_off_is_named_among_many() {
    let outlier = outlier_of_twelve(&[(4, 1.16)], Some(0.01)).unwrap();
    assert!(outlier.starts_with("row 4 ("), "{outlier}");
    assert!(outlier.contains(" deviates by 16 standard deviations from a fit to the"), "{outlier}");
    assert_eq!(outlier_of_twelve(&[(4, 1.05)], Some(0.01)), None);
}

/// The outlier of unloading stiffnesses of KE with normal errors of 3 %, some of them multiplied.
fn outlier_of_noisy(count: usize, draw: u64, off: &[(usize, f64)]) -> Option<String> {
    let loads: Vec<f64> = (0..count).map(|k| 10f64.powf(3.0 * k as f64 / count as f64)).collect();
    let mut columns = columns(&KogutEtsion, &loads, &[Quantity::UnloadingStiffness]);
    let mut state = 1000 * draw;
    columns[1].1.iter_mut().flatten().for_each(|value| *value *= 1.0 + 0.03 * normal(&mut state));
    for (row, factor) in off {
        columns[1].1[row - 1] = columns[1].1[row - 1].map(|value| factor * value);
    }
    let data = data(&columns);
    let scene = varied(&[2]);
    let mut fit = Fit::new(&data, parameters(&[2], 1.2), &scene).unwrap();
    fit.more_starts = 0;
    outlier_of(&fit.run(&KogutEtsion).unwrap())
}

#[test]
fn lines_beyond_the_scatter_of_the_others_are_named() {
    for draw in 1..=if is_long() { 5 } else { 1 } {
        for (off, wanted) in [
            (&[(14, 1.5)][..], "row 14 ("),
            (&[(14, 1.3)], "row 14 ("),
            (&[(7, 1.5), (18, 0.7)], "row 7 ("),
            (&[(10, 1.25), (11, 1.25)], "row 10 ("),
        ] {
            let outlier = outlier_of_noisy(24, draw, off).unwrap_or_default();
            assert!(outlier.starts_with(wanted), "{draw} {off:?}: {outlier}");
            assert_eq!(outlier.contains(" and row "), off.len() == 2, "{outlier}");
        }
    }
}

/// Of 200 draws, none of 12 lines and one of 24 named a line.
#[test]
fn normal_errors_hardly_ever_name_a_line() {
    for count in [12, 24] {
        let draws = if is_long() { 25 } else { 8 };
        let is_named = |draw: &u64| outlier_of_noisy(count, *draw, &[]).is_some();
        let named = (1..=draws).filter(is_named).count();
        assert!(named <= 1, "{named} of {draws} draws of {count} lines");
    }
}
