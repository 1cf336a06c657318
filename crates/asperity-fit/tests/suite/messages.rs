//! The column or the standard deviations that explain a misfit.

use asperity_core::Quantity;
use asperity_fit::Fit;
use asperity_ke::KogutEtsion;

use crate::kit::{LOADS, columns, data, is_long, normal, parameters, varied};

#[test]
fn data_in_another_unit_are_not_described() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    let good = fitted(&columns);
    assert!(good.doubts.is_empty(), "{good:?}");
    columns[0].1.iter_mut().flatten().for_each(|load| *load *= 1e-3);
    let found = fitted(&columns);
    let check = "check the columns and their units, and the other numbers of the scene";
    assert!(found.misfit().is_some_and(|text| text.ends_with(check)), "{found:?}");
    let [misfit, limit] = &found.doubts[..] else { panic!("{found:?}") };
    assert_eq!([misfit.code, limit.code], ["misfit", "limits"]);
    assert_eq!(limit.field, "asperity_height_std");
    // The misfit hides the limit.
    assert_eq!(found.findings().count(), 1);
    // No line is left out where all are far.
    assert!(found.evaluations < 500, "{}", found.evaluations);
}

#[test]
fn a_stiffness_in_the_column_of_another_is_named() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::UnloadingStiffness]);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    assert!(fitted(&columns).doubts.is_empty());
    columns[1].0 = Quantity::Tangent.column();
    let found = fitted(&columns);
    let other = found.findings().next().unwrap();
    assert_eq!((other.code, &*other.field), ("other-column", "tangent_N_per_m"));
    let text = other.message();
    assert!(text.contains(" if it is unloading_stiffness_N_per_m; name the column by"), "{text}");
}

#[test]
fn a_stiffness_of_another_column_is_named_among_noise_and_no_other_is() {
    let loads: Vec<f64> = (0..24).map(|k| 4.0 * 10f64.powf(0.1 * f64::from(k))).collect();
    let [unloading, stiffness] = [Quantity::UnloadingStiffness, Quantity::Stiffness];
    let clean = columns(&KogutEtsion, &loads, &[unloading]);
    let scene = varied(&[2]);
    for draw in 0..if is_long() { 10 } else { 2 } {
        let mut columns = clean.clone();
        let mut state = 100 * draw;
        columns[1].1.iter_mut().flatten().for_each(|k| *k *= 1.0 + 0.03 * normal(&mut state));
        for (column, is_other) in [(unloading, false), (stiffness, true)] {
            columns[1].0 = column.column();
            let data = data(&columns);
            let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
            let found = fit.run(&KogutEtsion).unwrap();
            // The misfit itself is no larger than errors of measurements are.
            assert!(found.rms < Some(0.12), "{:?}", found.rms);
            let other = found.doubts.texts("other-column").concat();
            let wanted = " if it is unloading_stiffness_N_per_m; name the column by";
            assert_eq!(other.contains(wanted), is_other, "{draw} {column}: {other}");
        }
    }
}

#[test]
fn standard_deviations_far_below_the_residuals_are_named() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    let off = [1.05, 0.96, 1.03, 0.98, 1.04];
    for (value, off) in columns[1].1.iter_mut().flatten().zip(off) {
        *value *= off;
    }
    let scene = varied(&[2]);
    let fitted = |deviation: &dyn Fn(f64) -> f64| {
        let mut columns = columns.clone();
        let std = columns[1].1.iter().map(|value| value.map(deviation)).collect();
        columns.push((format!("{}_std", columns[1].0), std));
        let data = data(&columns);
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    let good = fitted(&|value| 0.04 * value);
    assert!(good.doubts.is_empty(), "{good:?}");
    let small = fitted(&|value| 0.004 * value);
    let notes = small.doubts.texts("notes").concat();
    assert!(small.misfit().is_none() && notes.contains("intervals are too narrow"), "{small:?}");
}
