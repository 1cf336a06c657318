//! Our plan: the law is the weight of a Gauss rule, built once a scene.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Request, Tolerance};

use super::{Failure, Job, Kind, Method, Outcome, Setting, tolerance};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHOD: Method = Method {
    name: "compiled",
    what: "ours, scene compiled: per evaluation",
    kind: Kind::Adaptive,
    prepare,
    count: Some(count),
};

fn prepare(laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
    let (quantity, separation) = (problem.quantity, problem.separation);
    let compiled = laws.compiled(&problem.model, quantity, &problem.scene, tolerance(setting)?)?;
    Ok(Box::new(move || match compiled.evaluate(quantity, separation) {
        Ok(found) => Ok(Outcome { value: found.scaled, scaled: true, evaluations: None }),
        Err(_) => Err(Failure::NotConverged),
    }))
}

/// Nodes of the rule; exponential heights have one integral for all separations.
fn count(laws: &Laws, problem: &Problem, setting: Setting) -> Result<usize> {
    let (tolerance, quantity) = (tolerance(setting)?, problem.quantity);
    let compiled = laws.compiled(&problem.model, quantity, &problem.scene, tolerance)?;
    let request = Request::new([quantity]).within(Tolerance::new(tolerance)?);
    let plan = compiled.plan(&request.at([problem.separation]))?;
    let step = plan.steps.iter().find(|step| step.quantities.contains(&quantity));
    Ok(step.and_then(|step| step.nodes).map_or(1, |(_, most)| most))
}
