//! Our plan without a compiled scene: the law is built, and its rules serve every scene.

use std::sync::Arc;

use anyhow::Result;
use asperity_quadrature::AnyScale;

use super::{Failure, Job, Kind, Method, Outcome, Setting, tolerance};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHOD: Method = Method {
    name: "rule",
    what: "ours, law built, scene not compiled (`Compiled::evaluate_on`)",
    kind: Kind::Adaptive,
    prepare,
    count: Some(count),
};

fn prepare(laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
    let Problem { model, quantity, scene, separation, .. } = &**problem;
    let law = laws.law(model, *quantity, scene, tolerance(setting)?)?;
    let (problem, quantity, separation) = (problem.clone(), *quantity, *separation);
    Ok(Box::new(move || match law.evaluate_on(&problem.scene, quantity, separation) {
        Ok(found) => Ok(Outcome { value: found.scaled, scaled: true, evaluations: None }),
        Err(_) => Err(Failure::NotConverged),
    }))
}

/// Nodes of the rule, from rules of our own that are the same; samples of the law where none
/// serves and the point is integrated anew.
fn count(laws: &Laws, problem: &Problem, setting: Setting) -> Result<usize> {
    let Problem { model, quantity, scene, separation, .. } = problem;
    let tolerance = tolerance(setting)?;
    let law = laws.law(model, *quantity, scene, tolerance)?;
    let rules = AnyScale::new(law.law(*quantity)?.density(), tolerance);
    match rules.nodes(*separation, problem.scale())? {
        0 => {
            let before = rules.evaluations();
            rules.value(*separation, problem.scale())?;
            Ok(rules.evaluations() - before)
        }
        nodes => Ok(nodes),
    }
}
