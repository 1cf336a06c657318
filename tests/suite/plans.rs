//! Plans list the integrals with their numbers of terms and samples, which are snapshots.

use asperity::{HeightDistribution, Model, Quantity, Request, Tolerance, linspace};

use crate::scenes;

fn plan(id: &str, quantities: &[Quantity], heights: HeightDistribution, tolerance: f64) -> String {
    let mut scene = scenes::named("at-paper");
    scene.heights = heights;
    let request = Request::new(quantities.iter().copied())
        .at(linspace(0.0, 4.0, 9))
        .within(Tolerance::new(tolerance).unwrap());
    let compiled = id.parse::<Model>().unwrap().compile(&scene, &request).unwrap();
    compiled.plan(&request).unwrap().to_string()
}

#[test]
fn plans_equal_their_snapshots() {
    let gaussian = HeightDistribution::Gaussian;
    let all = [Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::Tangent];
    insta::assert_snapshot!("plan-ke", plan("ke", &all, gaussian.clone(), 1e-10));
    insta::assert_snapshot!("plan-ke-loose", plan("ke", &[Quantity::Area], gaussian.clone(), 1e-4));
    insta::assert_snapshot!("plan-at", plan("at", &[Quantity::Area], gaussian.clone(), 1e-10));
    let paper = [Quantity::Force, Quantity::Stiffness, Quantity::Tangent];
    insta::assert_snapshot!("plan-gao", plan("gao", &paper, gaussian, 1e-6));
    let exponential = HeightDistribution::Exponential;
    insta::assert_snapshot!(
        "plan-exponential",
        plan("zmc", &[Quantity::Force], exponential, 1e-10)
    );
}

#[test]
fn plans_list_the_regimes_that_no_asperity_reaches() {
    // w_c is a hundred σ_z here.
    let mut scene = scenes::named("at-paper");
    let critical = scene.asperity().unwrap().critical_interference().unwrap();
    scene.surface.asperity_height_std = critical / 100.0;
    let request = Request::new([Quantity::Force]).at([0.0, 3.0]);
    let compiled = "ke".parse::<Model>().unwrap().compile(&scene, &request).unwrap();
    let plan = compiled.plan(&request).unwrap();
    let dropped: Vec<bool> = plan.steps[0].parts.iter().map(|p| p.dropped.is_some()).collect();
    assert_eq!(dropped, [false, true, true, true]);
    assert!(plan.to_string().contains("plastic: out of reach"), "{plan}");
}
