//! Models on the same data, in their order.

use asperity_core::{Code, ContactModel, Finding, Quantity};
use asperity_fit::{Fit, rank};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;

use crate::kit::{LOADS, columns, data, parameters, varied};

#[test]
fn models_are_ranked_by_their_misfit() {
    let quantities = [Quantity::Area, Quantity::Tangent];
    let data = data(&columns(&KogutEtsion, &LOADS, &quantities));
    let scene = varied(&[0, 2]);
    let jg = JacksonGreen::default();
    let models: [&dyn ContactModel; 3] = [&GreenwoodWilliamson, &jg, &KogutEtsion];
    let fit = Fit::new(&data, parameters(&[0, 2], 1.2), &scene).unwrap();
    let ranked = rank(models.iter().map(|model| fit.run(*model).unwrap()).collect());
    assert_eq!(ranked[0].model, "ke");
    let bics: Vec<_> = ranked.iter().map(|fitted| fitted.bic).collect();
    assert!(bics.is_sorted(), "{bics:?}");
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
    let ranked = rank(vec![gw, fit.run(&KogutEtsion).unwrap()]);
    assert_eq!(ranked[0].model, "ke");
}

#[test]
fn a_model_whose_law_does_not_hold_ranks_last() {
    let data = data(&columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.2), &scene).unwrap();
    let [gw, mut ke] = [&GreenwoodWilliamson as &dyn ContactModel, &KogutEtsion]
        .map(|model| fit.run(model).unwrap());
    assert!(ke.bic < gw.bic);
    ke.findings.push(Finding::note(Code::Yields, "yielding_share", 0.03));
    assert_eq!(rank(vec![gw.clone(), ke.clone()])[0].model, "ke");
    ke.findings.push(Finding::warning(Code::FitMisses, "missed_share", 0.9));
    assert_eq!(rank(vec![gw, ke])[0].model, "gw");
}
