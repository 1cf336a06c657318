//! Data without noise return the scene that they are made from.

use asperity_core::{At, ContactModel, Quantity, Request, linspace};
use asperity_fit::{Data, DataColumn, Fit, Fitted, Parameter};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;

use crate::kit::{TRUTH, columns, data, parameters, scene, varied};

const LOADS: [f64; 8] = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0];

fn assert_recovered(fitted: &Fitted, truth: &[f64]) {
    assert!(fitted.findings.is_empty(), "{fitted:?}");
    for (found, wanted) in fitted.parameters.iter().zip(truth) {
        let off = (found.value / wanted - 1.0).abs();
        assert!(off < 1e-8, "{}: {} is off by {off:e}", fitted.model, found.name);
    }
}

#[test]
fn every_number_of_the_surface_comes_back_to_1e_8() {
    let (gw, ke, jg) = (GreenwoodWilliamson, KogutEtsion, JacksonGreen::default());
    let quantities = [Quantity::Area, Quantity::UnloadingStiffness];
    let cases: [(&dyn ContactModel, &[usize]); 4] =
        [(&gw, &[0, 1, 2]), (&ke, &[2, 3]), (&ke, &[0, 1, 2]), (&jg, &[2, 3])];
    for (model, free) in cases {
        let data = data(&columns(model, &LOADS, &quantities));
        let scene = varied(free);
        for off in [0.3, 2.5] {
            let fit = Fit::new(&data, parameters(free, off), &scene).unwrap();
            let fitted = fit.run(model).unwrap();
            assert_recovered(&fitted, &free.iter().map(|place| TRUTH[*place]).collect::<Vec<_>>());
            assert!(fitted.rms < Some(1e-9), "{fitted:?}");
        }
    }
}

#[test]
fn standard_deviations_weight_and_rows_may_have_gaps() {
    let mut columns =
        columns(&KogutEtsion, &LOADS, &[Quantity::Area, Quantity::ThermalConductance]);
    for k in [1, 2] {
        let (name, values) = columns[k].clone();
        let std = values.iter().map(|value| value.map(|value| 0.01 * value)).collect();
        columns.push((format!("{name}_std"), std));
    }
    columns[1].1[3] = None;
    columns[2].1[5] = None;
    let data = data(&columns);
    assert_eq!(data.len(), 14);
    let scene = varied(&[0, 2]);
    let fitted = Fit::new(&data, parameters(&[0, 2], 2.0), &scene).unwrap().run(&KogutEtsion);
    let fitted = fitted.unwrap();
    assert_recovered(&fitted, &[TRUTH[0], TRUTH[2]]);
    // One per cent of every value: intervals do not shrink with the misfit.
    let radius = &fitted.parameters[0];
    assert!(radius.upper.unwrap() / radius.lower.unwrap() > 1.005, "{radius:?}");
    assert!(fitted.reduced_chi_squared.unwrap() < 1e-12);
}

/// A force-separation curve and its stiffness, as a rig with an offset and a compliance reads them.
fn of_rig(offset: f64, compliance: f64, at_loads: bool) -> Vec<DataColumn> {
    let separations = linspace(0.5, 3.0, 9);
    let request = Request::new([Quantity::Force, Quantity::Tangent]);
    let answer =
        KogutEtsion.solve(&scene(TRUTH), &request.at(separations.iter().copied())).unwrap();
    let forces = answer.values(Quantity::Force).unwrap();
    let tangents = answer.values(Quantity::Tangent).unwrap();
    let readings = separations.iter().zip(&forces);
    let readings = readings.map(|(s, force)| Some(s * TRUTH[2] + offset - compliance * force));
    let stiffness = tangents.iter().map(|tangent| Some(1.0 / (1.0 / tangent + compliance)));
    let load = if at_loads { "load_N" } else { "force_N" };
    vec![
        ("separation_m".into(), readings.collect()),
        (load.into(), forces.iter().copied().map(Some).collect()),
        ("tangent_N_per_m".into(), stiffness.collect()),
    ]
}

#[test]
fn a_rig_adds_an_offset_of_either_sign_and_a_compliance() {
    for (offset, at_loads) in [(3e-6, false), (-2e-6, false), (-2e-6, true)] {
        let data = data(&of_rig(offset, 2e-10, at_loads));
        let mut free = parameters(&[2], 1.5);
        free.push(Parameter::new("separation_offset", "m", 0.0, [-3e-5, 3e-5], TRUTH[2]).unwrap());
        let compliance = [1e-12, 1e-8];
        free.push(Parameter::new("series_compliance", "m/N", 1e-9, compliance, 1.0).unwrap());
        let scene = varied(&[2]);
        let fitted = Fit::new(&data, free, &scene).unwrap().run(&KogutEtsion).unwrap();
        assert_recovered(&fitted, &[TRUTH[2], offset, 2e-10]);
    }
}

#[test]
fn separations_with_a_standard_deviation_are_measured_under_loads() {
    let mut columns = of_rig(1e-6, 0.0, true);
    columns.truncate(2);
    let count = columns[0].1.len();
    columns.push(("separation_m_std".into(), vec![Some(1e-8); count]));
    let data = data(&columns);
    assert!(matches!(data[0].at, At::Load(_)) && data.len() == count);
    let mut free = parameters(&[2], 0.5);
    free.push(Parameter::new("separation_offset", "m", 0.0, [-3e-5, 3e-5], TRUTH[2]).unwrap());
    let scene = varied(&[2]);
    let fitted = Fit::new(&data, free, &scene).unwrap().run(&KogutEtsion).unwrap();
    assert_recovered(&fitted, &[TRUTH[2], 1e-6]);
    assert_eq!(fitted.rms, None);
}

#[test]
fn a_fit_is_the_same_in_every_run() {
    let data: Data = data(&columns(&KogutEtsion, &LOADS, &[Quantity::Area]));
    let scene = varied(&[0, 2]);
    let run =
        || Fit::new(&data, parameters(&[0, 2], 2.0), &scene).unwrap().run(&GreenwoodWilliamson);
    assert_eq!(run().unwrap(), run().unwrap());
}

#[test]
fn a_start_in_the_middle_of_the_bounds_is_left() {
    let data = data(&columns(&KogutEtsion, &[1.0, 10.0, 100.0], &[Quantity::Tangent]));
    let scene = varied(&[2]);
    for off in [1.5, 3.0, 0.4] {
        let mut fit = Fit::new(&data, parameters(&[2], off), &scene).unwrap();
        fit.more_starts = 0;
        let found = fit.run(&KogutEtsion).unwrap().parameters[0].value;
        assert!((found / TRUTH[2] - 1.0).abs() < 1e-8, "from {off}: {found}");
    }
}
