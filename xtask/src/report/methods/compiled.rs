//! Our plan: the law is the weight of a Gauss rule, built once a scene.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Request, Tolerance};

use super::{Failure, Job, Kind, Method, Outcome, Setting};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHOD: Method = Method {
    name: "compiled",
    what: "ours, scene compiled: per evaluation",
    kind: Kind::Adaptive,
    prepare,
};

fn prepare(laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Option<Job>> {
    let Setting::Tolerance(tolerance) = setting else {
        anyhow::bail!("{setting:?} is no tolerance")
    };
    let (quantity, separation) = (problem.quantity, problem.separation);
    let compiled = laws.compiled(&problem.model, quantity, &problem.scene, tolerance)?;
    let request = Request::new([quantity]).within(Tolerance::new(tolerance)?).at([separation]);
    let plan = compiled.plan(&request)?;
    // Exponential heights have one integral and no nodes.
    let evaluations = plan.steps.first().and_then(|step| step.nodes).map_or(1, |(_, most)| most);
    Ok(Some(Box::new(move || match compiled.evaluate(quantity, separation) {
        Ok(found) => Ok(Outcome { value: found.scaled, scaled: true, evaluations }),
        Err(_) => Err(Failure::NotConverged),
    })))
}
