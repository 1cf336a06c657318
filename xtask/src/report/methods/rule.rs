//! Our plan without a compiled scene: rules of the law alone, which serve every scene.

use std::sync::Arc;

use anyhow::{Result, bail};

use super::{Failure, Job, Kind, Method, Outcome, Setting};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHOD: Method = Method {
    name: "rule",
    what: "ours, law built, scene not compiled: rules that serve any w_c/σ_z; Gaussian heights",
    kind: Kind::Adaptive,
    prepare,
};

fn prepare(laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Option<Job>> {
    let Setting::Tolerance(tolerance) = setting else { bail!("{setting:?} is no tolerance") };
    if problem.exponential() {
        return Ok(None);
    }
    let Problem { model, quantity, scene, .. } = &**problem;
    let rules = laws.rules(model, *quantity, scene, tolerance)?;
    let evaluations = match rules.nodes(problem.separation, problem.scale())? {
        0 => {
            // No rule serves this point, which is integrated anew: what counts is the law's samples.
            let before = rules.evaluations();
            rules.value(problem.separation, problem.scale())?;
            rules.evaluations() - before
        }
        nodes => nodes,
    };
    let (problem, slope) = (problem.clone(), problem.slope());
    Ok(Some(Box::new(move || {
        let (s, scale) = (problem.separation, problem.scale());
        let integral = if slope { rules.at(s, scale)?.slope } else { rules.value(s, scale)?.value };
        Ok::<_, Failure>(Outcome { value: problem.in_units(integral), scaled: true, evaluations })
    })))
}
