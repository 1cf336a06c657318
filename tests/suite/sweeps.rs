//! Sweeps over scenes: the values of scenes compiled one by one, in order, with any threads.

use asperity::{Case, ContactError, HeightDistribution, Model, Quantity, Sweep, Tolerance};

use crate::is_long;
use crate::scenes::{compiled, model, named};

const ASKED: [Quantity; 4] =
    [Quantity::Area, Quantity::Tangent, Quantity::Force, Quantity::Stiffness];

/// Scenes that differ in every input of a law, w_c/σ_z from 1e-5 to 1e3.
fn cases(count: usize, materials: bool) -> Vec<Case> {
    // Multiples of an irrational number fill [0, 1) evenly, and repeat for every run.
    let share = |k: usize, step: f64| (k as f64 * step).fract();
    (0..count)
        .map(|k| {
            let mut scene = named("mild");
            scene.surface.asperity_height_std *= 1e4f64.powf(2.0 * share(k, 0.618_034) - 1.0);
            scene.surface.asperity_density *= 0.5 + share(k, 0.414_214);
            scene.nominal_area *= 0.5 + share(k, 0.732_051);
            if materials {
                scene.surface.asperity_radius *= 0.5 + share(k, 0.236_068);
                scene.interface.equivalent_modulus *= 0.7 + 0.6 * share(k, 0.645_751);
                scene.interface.hardness =
                    scene.interface.hardness.map(|h| h * (0.8 + 0.4 * share(k, 0.162_278)));
                scene.interface.pressure_factor = Some(0.5 + 0.2 * share(k, 0.316_625));
            }
            Case::new(scene, -3.0 + 12.0 * share(k, 0.605_551))
        })
        .collect()
}

#[test]
fn a_sweep_equals_scenes_compiled_one_by_one() {
    let tolerance = Tolerance::new(1e-12).unwrap();
    for model in Model::of_asperities() {
        let lateral = model.validity().angles;
        // Compiled one by one: laws over angles take a tenth of a second to build.
        let laterals = if is_long() { 4 } else { 1 };
        let cases = cases(if lateral { laterals } else { 40 }, true);
        let sweep = Sweep::new(&model, &ASKED, tolerance);
        for (case, answer) in cases.iter().zip(sweep.evaluate_all(&cases)) {
            let alone = compiled(&model, &case.scene, &ASKED, 1e-12);
            for (quantity, swept) in ASKED.into_iter().zip(answer.unwrap()) {
                let alone = alone.evaluate(quantity, case.at).unwrap();
                assert!(swept.ln_scale.to_bits() == alone.ln_scale.to_bits());
                let error = (swept.scaled - alone.scaled).abs() / alone.size;
                assert!(error <= swept.error + alone.error, "{model} {quantity}: {error:e}");
                let allowed = if lateral { 2e-11 } else { 2e-12 };
                assert!(swept.error < allowed, "{model} {quantity}: {:e}", swept.error);
            }
        }
    }
}

#[test]
fn digits_and_order_depend_neither_on_threads_nor_on_earlier_scenes() {
    let mut cases = cases(3000, true);
    cases[1234].at = f64::NAN.into();
    cases[77].scene.heights = HeightDistribution::Exponential;
    for id in ["ke", "zmc"] {
        let model = model(id);
        let asked = [Quantity::Force, Quantity::Tangent];
        let digits = |answer: Result<Vec<asperity::Evaluation>, ContactError>| match answer {
            Ok(row) => row.iter().map(|e| e.value().to_bits()).collect(),
            Err(error) => {
                assert!(error.to_string().starts_with("separation is NaN"), "{error}");
                vec![]
            }
        };
        let all: Vec<Vec<u64>> = Sweep::new(&model, &asked, Tolerance::default())
            .evaluate_all(&cases)
            .into_iter()
            .map(digits)
            .collect();
        assert!(all[1234].is_empty() && all.iter().filter(|row| row.is_empty()).count() == 1);
        let backwards: Vec<_> = cases.iter().rev().cloned().collect();
        let sweep = Sweep::new(&model, &asked, Tolerance::default());
        let backwards = sweep.evaluate_all(&backwards).into_iter().map(digits);
        assert!(backwards.rev().eq(all), "{id}");
    }
}
