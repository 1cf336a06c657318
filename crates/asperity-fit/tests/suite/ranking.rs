//! Models on the same data, in their order.

use asperity_core::{ContactModel, Finding, Quantity};
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
    twin.residuals[0].fitted *= 1.001;
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
fn a_model_whose_law_does_not_hold_ranks_last() {
    let data = data(&columns(&KogutEtsion, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.2), &scene).unwrap();
    let [gw, mut ke] = [&GreenwoodWilliamson as &dyn ContactModel, &KogutEtsion]
        .map(|model| fit.run(model).unwrap());
    assert!(ke.bic < gw.bic);
    ke.unusual.push(Finding::note("yields", "yielding_share", 0.03));
    assert_eq!(rank(vec![gw.clone(), ke.clone()]).models[0].model, "ke", "a note is no limit");
    ke.unusual.push(Finding::warning("fit-misses", "missed_share", 0.9));
    let ranking = rank(vec![gw.clone(), ke.clone()]);
    assert_eq!(ranking.models[0].model, "gw");
    let reason = "gw is the only model of the list that holds here; ke (fit-misses) ranks last, as its law does not hold here; ";
    assert!(ranking.summary.starts_with(reason), "{}", ranking.summary);
    let ranking = rank(vec![ke]);
    assert!(ranking.summary.starts_with("ke alone was fitted"), "{}", ranking.summary);
}

#[test]
fn models_of_the_same_values_are_one() {
    // Hard enough that no asperity yields.
    let hard = |numbers: &[f64]| Ok(crate::kit::scene([2e-4, 2e8, numbers[0], 3e10]));
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Area]));
    let fit = Fit::new(&data, parameters(&[2], 1.2), &hard).unwrap();
    let jg = JacksonGreen::default();
    let models: [&dyn ContactModel; 3] = [&KogutEtsion, &GreenwoodWilliamson, &jg];
    let ranking = rank(models.iter().map(|model| fit.run(*model).unwrap()).collect());
    let distinct: Vec<&str> = ranking.distinct().map(|one| one.model.as_str()).collect();
    assert_eq!((distinct, ranking.models.len()), (vec!["gw"], 3));
    assert!(ranking.summary.starts_with("nothing yields: "), "{}", ranking.summary);
    assert!(ranking.summary.ends_with(" are gw"), "{}", ranking.summary);
}
