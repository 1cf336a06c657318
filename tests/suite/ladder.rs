//! The tolerance is a contract: at every rung the error is below it and below the reported bound,
//! and looser rungs cost less. By compiled rules, and by the rules that serve any scale.

use asperity::{Evaluation, Request};

use crate::reference::{meaning, rows};
use crate::scenes;

const RUNGS: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

#[test]
fn every_rung_keeps_its_word() {
    let mut failures = vec![];
    let mut count = 0;
    for ([case, id, words], rows) in rows() {
        let (model, quantity) = meaning(id, words);
        let lateral = model.claims().angles;
        if lateral && case != "at-paper" {
            continue;
        }
        // The references' own: 17 digits, or 13 and three implementations for lateral models.
        let own = if lateral { 1e-12 } else { 5e-15 };
        let scene = scenes::named(case);
        let mut work = vec![];
        for tolerance in RUNGS.into_iter().filter(|rung| !lateral || *rung >= 1e-11) {
            let compiled = scenes::compiled(&model, &scene, &[quantity], tolerance);
            let mut check = |how: &str, separation: f64, value: f64, found: Evaluation| {
                let error = (found.value() / value - 1.0).abs();
                let cancellation = (found.size / found.scaled).abs();
                let bound = found.relative_error();
                count += 1;
                if error.is_nan() || error > tolerance * cancellation + own || error > bound + own {
                    failures.push(format!(
                        "{case} {id} {words} at {separation}, {how} to {tolerance:e}: error {error:.1e}, bound {bound:.1e}"
                    ));
                }
            };
            for (separation, value) in &rows {
                let found = compiled.evaluate(quantity, *separation).unwrap();
                check("compiled", *separation, *value, found);
                let found = compiled.evaluate_on(&scene, quantity, *separation).unwrap();
                check("at any scale", *separation, *value, found);
            }
            let separations = rows.iter().map(|(separation, _)| *separation);
            let plan = compiled.plan(&Request::new([quantity]).at(separations)).unwrap();
            work.push(plan.steps[0].nodes.unwrap().1);
        }
        assert!(work.is_sorted() && work[0] < work[work.len() - 1], "{id} {words}: {work:?}");
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert!(count > 6000, "{count} values");
}
