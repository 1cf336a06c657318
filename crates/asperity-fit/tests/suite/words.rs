//! What data do not determine, and what they cannot be.

use std::ops::ControlFlow;

use asperity_core::{At, ContactModel, Datum, Quantity, Request, Severity};
use asperity_fit::{Data, Fit, FitError, MeasuredTable, Parameter, rank};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;

use crate::kit::{NAMES, TRUTH, columns, data, parameters, varied};

const LOADS: [f64; 5] = [1.0, 10.0, 100.0, 300.0, 1000.0];

#[test]
fn stiffness_against_load_fixes_one_group_of_gw() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[0, 1]);
    let fit = Fit::new(&data, parameters(&[0, 1], 1.7), &scene).unwrap();
    let fitted = fit.run(&GreenwoodWilliamson).unwrap();
    let wanted = "only asperity_density x asperity_radius^0.5 is determined";
    assert_eq!(fitted.undetermined, [wanted]);
    assert!(fitted.condition.is_none() && fitted.converged, "{fitted:?}");
    assert_eq!(fitted.correlation[0][1], None);
    let [radius, density] = [0, 1].map(|k| fitted.parameters[k].value);
    let group = density * radius.sqrt() / (TRUTH[1] * TRUTH[0].sqrt());
    assert!((group - 1.0).abs() < 1e-8, "{group}");
    assert!(fitted.parameters.iter().all(|p| p.lower.is_none() && p.upper.is_none()));
    // Of the values that fit, those nearest to the start: 1.7 times the truth, less the part that
    // the data do not allow, which is shared by the exponents 1/2 and 1.
    let excess = 1.7f64.ln() * 1.5 / 1.25;
    for (found, exponent) in [(radius / TRUTH[0], 0.5), (density / TRUTH[1], 1.0)] {
        let wanted = 1.7 * (-excess * exponent).exp();
        assert!((found / wanted - 1.0).abs() < 1e-5, "{found} {wanted}");
    }
}

#[test]
fn a_number_without_effect_is_named() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2, 3]);
    let fit = Fit::new(&data, parameters(&[2, 3], 1.7), &scene).unwrap();
    let fitted = fit.run(&GreenwoodWilliamson).unwrap();
    assert_eq!(fitted.undetermined, ["hardness is not determined: it does not change the data"]);
    let std = fitted.parameters[0].value;
    assert!((std / TRUTH[2] - 1.0).abs() < 1e-8, "{std}");
}

fn inverse(value: f64, model: &dyn ContactModel, free: &[usize]) -> asperity_fit::Fitted {
    let columns = [("pressure_Pa", 5e6), ("area_fraction", value)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    let data = data(&columns);
    let scene = varied(free);
    Fit::new(&data, parameters(free, 1.0), &scene).unwrap().run(model).unwrap()
}

#[test]
fn an_area_below_load_over_hardness_is_refused_with_the_hardness_it_needs() {
    let found = inverse(0.001, &KogutEtsion, &[2]);
    let wanted = "an area fraction of 0.001 at a pressure of 5e6 Pa cannot be reached: contacts carry at most the hardness, so it is at least p/H = 0.0025; the hardness would have to be at least 5e9 Pa";
    assert_eq!(found.unreachable, [wanted]);
    // Those of JG as well, within 2 %.
    let found = inverse(0.001, &JacksonGreen::default(), &[2]);
    assert_eq!(found.unreachable, [wanted]);
    // The bound of a free hardness counts.
    let found = inverse(0.002, &KogutEtsion, &[3]);
    assert!(found.unreachable.is_empty(), "{found:?}");
    let hardness = found.parameters[0].value;
    assert!(hardness > 2.5e9 && hardness < 60e9, "{hardness:e}");
    // GW has no hardness: the nearest value is at a bound.
    let found = inverse(0.9, &GreenwoodWilliamson, &[2]);
    assert!(
        found.unreachable[0].starts_with("an area fraction of 0.9 at a pressure of 5e6 Pa cannot be reached within the bounds: the nearest is ")
            && found.unreachable[0].contains(" at asperity_height_std = "),
        "{found:?}"
    );
}

#[test]
fn one_value_and_one_parameter_answer_the_inverse_question() {
    let found = inverse(0.004, &KogutEtsion, &[2]);
    assert!(found.converged && found.unreachable.is_empty(), "{found:?}");
    assert!((found.residuals[0].fitted / 0.004 - 1.0).abs() < 1e-9, "{found:?}");
    assert_eq!((found.bic, found.parameters[0].lower), (None, None));
    assert!(found.notes.iter().any(|note| note.starts_with("no intervals: as many")), "{found:?}");
}

#[test]
fn data_in_another_unit_are_not_described_and_the_unit_is_named() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    let good = fitted(&columns);
    assert_eq!((good.misfit, good.limits), (None, vec![]));
    columns[0].1.iter_mut().flatten().for_each(|load| *load *= 1e-3);
    let found = fitted(&columns);
    let unit = "load_N = 1 (row 5) looks like kN; 1 kN is 1000 N";
    assert!(found.misfit.as_ref().is_some_and(|text| text.ends_with(unit)), "{found:?}");
    assert_eq!(found.limits, ["asperity_height_std is at its lower bound of 5e-8"]);
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
    let outlier = found.outlier.unwrap();
    assert!(
        outlier.starts_with("line 6 (tangent_N_per_m = ")
            && outlier.contains(" at load_N = 300) deviates by a factor of 100 from a fit"),
        "{outlier}"
    );
    let others =
        " to the other lines, which agree within 3 % (root mean square); check or remove it";
    assert!(outlier.ends_with(others), "{outlier}");
    let misfit = found.misfit.unwrap();
    let size =
        "no values within the bounds describe the data: fitted values deviate by a factor of 6";
    assert!(misfit.starts_with(size) && misfit.ends_with(others), "{misfit}");
    assert_eq!(found.residuals.len(), 5);
    // Of arrays the row; a smaller error leaves data that are described.
    let found = fitted([1.01, 0.99, 2.0, 1.01, 0.99], vec![]);
    let outlier = found.outlier.unwrap();
    let wanted = " deviates by a factor of 2 from a fit to the other rows";
    assert!(outlier.starts_with("row 3 (") && outlier.contains(wanted), "{outlier}");
    assert_eq!(found.misfit, None);
    // Scatter is no outlier.
    assert_eq!(fitted([1.3, 0.8, 1.1, 0.7, 1.2], vec![]).outlier, None);
}

/// Tangents of KE whose first is twice the true one, with a standard deviation for each.
fn doubled(std: impl Fn(f64) -> f64) -> asperity_fit::Fitted {
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
    for (share, far) in [(0.01, "50"), (0.03, "17")] {
        let found = doubled(|value| share * value);
        let outlier = found.outlier.as_deref().unwrap();
        let wanted = format!(" deviates by {far} standard deviations from a fit to the other rows");
        assert!(outlier.starts_with("row 1 (") && outlier.contains(&wanted), "{outlier}");
        // One reason is enough: the line, or the standard deviations.
        assert!(found.notes.is_empty() && found.misfit.is_none(), "{found:?}");
        assert_eq!(found.remarks(), [(Severity::Warning, outlier)]);
    }
    let found = doubled(|value| 1e-3 * value);
    let [outlier, misfit] = [found.outlier.as_deref(), found.misfit.as_deref()].map(Option::unwrap);
    assert!(misfit.contains("times the standard deviations") && misfit.ends_with(outlier));
    assert_eq!(found.remarks(), [(Severity::Warning, misfit)]);
}

#[test]
fn a_stiffness_in_the_column_of_another_is_named() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::UnloadingStiffness]);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap().run(&KogutEtsion).unwrap()
    };
    assert_eq!(fitted(&columns).other_column, None);
    columns[1].0 = Quantity::Tangent.column();
    let found = fitted(&columns);
    let other = found.other_column.as_deref().unwrap();
    assert!(
        other.starts_with("tangent_N_per_m deviates by ")
            && other.contains(" if it is unloading_stiffness_N_per_m; name the column by"),
        "{other}"
    );
    assert!(found.remarks().contains(&(Severity::Warning, other)), "{found:?}");
}

#[test]
fn one_line_in_another_unit_is_named_among_three() {
    let mut columns = columns(&KogutEtsion, &LOADS[..3], &[Quantity::Area]);
    columns[1].1[1] = columns[1].1[1].map(|area| 1e6 * area);
    let scene = varied(&[2]);
    let fitted = |columns: &[asperity_fit::DataColumn]| {
        let data = data(columns);
        let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
        fit.run(&KogutEtsion).unwrap().outlier
    };
    let outlier = fitted(&columns).unwrap();
    assert!(outlier.starts_with("row 2 (area_m2 = "), "{outlier}");
    assert!(outlier.contains(" looks like mm2; ") && outlier.ends_with(" m2"), "{outlier}");
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
    let outlier = fit.run(&KogutEtsion).unwrap().outlier.unwrap();
    let wanted = "deviates by 0.5 from a fit to the other rows, which agree within 1e-8 (root";
    assert!(outlier.contains(wanted), "{outlier}");
}

#[test]
fn forces_and_pounds_in_a_column_of_pressures_are_named() {
    let mut columns = columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]);
    let scene = varied(&[2]);
    columns[0].0 = "pressure_Pa".into();
    for (factor, unit) in [
        (
            1e-4,
            "pressure_Pa = 1000 (row 5) looks like N; 1000 N on the nominal area of 1e-4 m2 is 1e7 Pa",
        ),
        (1.0 / 6_894.757_293, "pressure_Pa = 1450 (row 5) looks like psi; 1450 psi is 1e7 Pa"),
    ] {
        let pressures = LOADS.map(|load| Some(factor * load / 1e-4));
        columns[0].1 = pressures.to_vec();
        let data = data(&columns);
        let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
        let misfit = fit.run(&KogutEtsion).unwrap().misfit.unwrap();
        assert!(misfit.ends_with(unit), "{misfit}");
    }
}

#[test]
fn loads_and_pressures_of_a_row_must_agree() {
    let columns = [("load_N", 100.0), ("pressure_Pa", 1e6), ("area_m2", 4e-8)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    let data = data(&columns);
    assert_eq!(data.check_loads(1e-4), Ok(()));
    assert_eq!(data.check_loads(1.004e-4), Ok(()), "rounded");
    let refused = data.check_loads(5e-5).unwrap_err().to_string();
    let wanted = "row 1: load_N = 100 and pressure_Pa = 1e6 contradict each other: on the nominal area of 5e-5 m2 this pressure is a load of 50 N; leave one of the two columns out, or correct the area";
    assert_eq!(refused, wanted);
}

#[test]
fn separations_in_another_unit_are_not_described_and_the_unit_is_named() {
    let separations = [2.5e-6, 2e-6, 1.5e-6, 1e-6, 0.5e-6];
    let request = Request::new([Quantity::Force]).at(separations.map(At::metres));
    let answer = KogutEtsion.solve(&crate::kit::scene(TRUTH), &request).unwrap();
    let loads: Vec<f64> = answer.values(Quantity::Force).unwrap();
    let scene = varied(&[2]);
    for (unit, factor) in [("um", 1e6), ("nm", 1e9), ("mm", 1e3)] {
        let some = |values: &[f64], factor: f64| values.iter().map(|v| Some(v * factor)).collect();
        let mut columns = vec![
            ("load_N".to_string(), some(&loads, 1.0)),
            ("separation_m".to_string(), some(&separations, factor)),
        ];
        for std in [false, true] {
            if std {
                let deviations = vec![Some(1e-8 * factor); LOADS.len()];
                columns.push(("separation_m_std".into(), deviations));
            }
            let data = data(&columns);
            let fit = Fit::new(&data, parameters(&[2], 1.5), &scene).unwrap();
            let message = match fit.run(&KogutEtsion) {
                Ok(fitted) => fitted.misfit.unwrap_or_default(),
                Err(error) => error.to_string(),
            };
            assert!(message.contains(&format!(") looks like {unit}; ")), "{unit}: {message}");
            assert!(message.contains("separation_m = "), "{unit}: {message}");
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
    let misfit = fitted(&|_| 3.0).misfit.unwrap();
    assert!(misfit.contains(" times the standard deviations (reduced chi squared "), "{misfit}");
    assert!(misfit.contains("tangent_N_per_m_std = 3 looks like per cent of the value; 3 % of "));
    assert_eq!(fitted(&|_| 3.0).outlier, None);
    let good = fitted(&|value| 0.04 * value);
    assert!(good.misfit.is_none() && good.notes.is_empty(), "{good:?}");
    let small = fitted(&|value| 0.004 * value);
    assert!(small.misfit.is_none() && small.notes[0].contains("intervals are too narrow"));
}

#[test]
fn models_are_ranked_by_their_misfit() {
    let quantities = [Quantity::Area, Quantity::Tangent];
    let data = data(&columns(&KogutEtsion, &LOADS, &quantities));
    let scene = varied(&[0, 2]);
    let jg = JacksonGreen::default();
    let models: [&dyn ContactModel; 3] = [&GreenwoodWilliamson, &jg, &KogutEtsion];
    let fit = Fit::new(&data, parameters(&[0, 2], 1.2), &scene).unwrap();
    let ranking = rank(models.iter().map(|model| fit.run(*model).unwrap()).collect());
    assert_eq!(ranking.models[0].model, "ke");
    assert!(
        ranking.summary.starts_with("ke fits best by BIC, clearly before the others; a low BIC")
    );
    let bics: Vec<_> = ranking.models.iter().map(|fitted| fitted.bic).collect();
    assert!(bics.is_sorted(), "{bics:?}");
}

#[test]
fn models_that_fit_alike_and_a_single_value_choose_no_model() {
    let quantities = [Quantity::Tangent];
    let free = |start: f64| parameters(&[2], start);
    let scene = varied(&[2]);
    let data = data(&columns(&KogutEtsion, &LOADS, &quantities));
    let fit = Fit::new(&data, free(1.2), &scene).unwrap();
    let mut twin = fit.run(&KogutEtsion).unwrap();
    twin.model = "twin".into();
    let ranking = rank(vec![fit.run(&KogutEtsion).unwrap(), twin]);
    let plain =
        "ke fits best by BIC, but these data do not distinguish it from twin (BIC within 6); a low";
    assert!(ranking.summary.starts_with(plain), "{}", ranking.summary);
    // The hardness changes no value of GW, so that one value would leave one degree of freedom.
    let one = crate::kit::data(&columns(&KogutEtsion, &LOADS[..1], &quantities));
    let scene = varied(&[3]);
    let fit = Fit::new(&one, parameters(&[3], 1.2), &scene).unwrap();
    let models: [&dyn ContactModel; 2] = [&GreenwoodWilliamson, &KogutEtsion];
    let ranking = rank(models.iter().map(|model| fit.run(*model).unwrap()).collect());
    assert!(ranking.models.iter().all(|fitted| fitted.bic.is_none()), "{ranking:?}");
    assert_eq!(ranking.models[0].model, "ke", "by the misfit");
    assert_eq!(ranking.summary, "one measured value cannot choose between models");
}

#[test]
fn criteria_are_not_compared_with_misfits() {
    let quantities = [Quantity::Tangent];
    let data = data(&columns(&KogutEtsion, &LOADS[..2], &quantities));
    let scene = varied(&[2, 3]);
    let fit = Fit::new(&data, parameters(&[2, 3], 1.2), &scene).unwrap();
    // GW has a BIC here, as hardness does not change its values; KE, which fits exactly, has none.
    let gw = fit.run(&GreenwoodWilliamson).unwrap();
    assert!(gw.bic.is_some());
    let ranking = rank(vec![gw, fit.run(&KogutEtsion).unwrap()]);
    assert_eq!(ranking.models[0].model, "ke");
    assert!(ranking.summary.starts_with("as many parameters"), "{}", ranking.summary);
}

#[test]
fn a_fit_ends_where_its_caller_says() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.7), &scene).unwrap();
    let mut last = 0;
    let ended = fit.run_with(&GreenwoodWilliamson, &mut |progress| {
        last = progress.evaluations;
        if last < 7 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert_eq!((ended, last), (Err(FitError::Interrupted), 7));
}

#[test]
fn parameters_and_data_that_make_no_fit_are_refused() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS[..2], &[Quantity::Tangent]));
    let scene = varied(&[0, 1, 2]);
    let refused = |free: Vec<Parameter>| Fit::new(&data, free, &scene).err().unwrap().to_string();
    assert_eq!(refused(vec![]), "free parameters: at least one was required");
    assert!(refused(parameters(&[1, 1], 1.0)).ends_with("asperity_density: it is given twice"));
    assert!(refused(parameters(&[0, 1, 2], 1.0)).starts_with("2 measured values for 3 free param"));
    for (bounds, scale) in [([2.0, 1.0], 1.0), ([1.0, f64::NAN], 1.0), ([-1.0, 1.0], 0.0)] {
        assert!(Parameter::new(NAMES[0], "m", 1.0, bounds, scale).is_err(), "{bounds:?}");
    }
    assert!(Parameter::new("series_compliance", "m/N", 0.0, [-1e-9, 1e-9], 1e-9).is_err());
}
