//! At every tolerance the error is below it and below the reported bound, and looser tolerances
//! cost less: with compiled rules, and with the rules for any scale.

use std::collections::BTreeSet;

use asperity::{Case, Evaluation, Request, Sweep, Tolerance};

use crate::reference::{meaning, rows};
use crate::{is_long, one_of, scenes};

const RUNGS: [f64; 6] = [1e-3, 1e-11, 1e-13, 1e-5, 1e-7, 1e-9];

#[test]
fn every_tolerance_is_met() {
    let mut failures = vec![];
    let mut count = 0;
    let mut rungs = RUNGS[..if is_long() { 6 } else { 3 }].to_vec();
    rungs.sort_by(|a, b| b.total_cmp(a));
    let of_lateral = one_of(3, rows()).map(|(key, _)| key).collect::<BTreeSet<_>>();
    for ([case, id, words], rows) in rows() {
        let (model, quantity) = meaning(id, words);
        let lateral = model.validity().angles;
        if lateral && (case != "at-paper" || !of_lateral.contains(&[case, id, words])) {
            continue;
        }
        // The error of the references: 17 digits, or 13 for lateral models.
        let own = if lateral { 1e-12 } else { 5e-15 };
        let scene = scenes::named(case);
        let mut work = vec![];
        for tolerance in rungs.iter().copied().filter(|rung| !lateral || *rung >= 1e-11) {
            let compiled = scenes::compiled(&model, &scene, &[quantity], tolerance);
            let mut check = |how: &str, separation: f64, value: f64, found: Evaluation| {
                let error = (found.value() / value - 1.0).abs();
                let cancellation = (found.size / found.scaled).abs();
                let bound = found.relative_error();
                count += 1;
                if error.is_nan() || error > tolerance * cancellation + own || error > bound + own {
                    failures.push(format!(
                        "{case} {id} {words} {separation} {how} {tolerance:e}: {error:.1e} {bound:.1e}"
                    ));
                }
            };
            for (separation, value) in &rows {
                let found = compiled.evaluate(quantity, *separation).unwrap();
                check("compiled", *separation, *value, found);
            }
            let sweep = Sweep::new(&model, &[quantity], Tolerance::new(tolerance).unwrap());
            let cases: Vec<Case> =
                rows.iter().map(|(separation, _)| Case::new(scene.clone(), *separation)).collect();
            // In a sweep, laws recur and get rules for any scale.
            for ((separation, value), answer) in rows.iter().zip(sweep.evaluate_all(&cases)) {
                check("at any scale", *separation, *value, answer.unwrap()[0]);
            }
            // A few rows have no preparation; tabulated laws are slow, so two tolerances suffice.
            let few = !lateral || [1e-5, 1e-11].contains(&tolerance);
            for rows in rows.chunks(4).filter(|_| few) {
                let request = Request::new([quantity]).at(rows.iter().map(|(s, _)| *s));
                let request = request.within(Tolerance::new(tolerance).unwrap());
                let answer = model.solve(&scene, &request).unwrap();
                let column = answer.column(quantity).unwrap();
                for ((separation, value), found) in rows.iter().zip(&column.rows) {
                    check("alone", *separation, *value, *found.as_ref().unwrap());
                }
            }
            let separations = rows.iter().map(|(separation, _)| *separation);
            let plan = compiled.plan(&Request::new([quantity]).at(separations)).unwrap();
            work.push(plan.steps[0].terms.unwrap().1);
        }
        assert!(work.is_sorted() && work[0] < work[work.len() - 1], "{id} {words}: {work:?}");
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert!(count > 1000 * rungs.len(), "{count} values");
}
