//! The classical methods at their best: scaled against underflow, split at the kinks of the law.

use std::sync::Arc;

use anyhow::{Result, bail};
use asperity_quadrature::{TanhSinh, gauss_kronrod, legendre};

use super::{Failure, Job, Kind, Method, Outcome, Setting, tolerance};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHODS: [Method; 3] = [
    Method {
        name: "gauss-kronrod",
        what: "adaptive, 21 points, scaled, split at the kinks",
        kind: Kind::Adaptive,
        prepare: kronrod,
        count: None,
    },
    Method {
        name: "tanh-sinh",
        what: "levels until they agree, scaled, split at the kinks",
        kind: Kind::Adaptive,
        prepare: tanh_sinh,
        count: None,
    },
    Method {
        name: "gauss-legendre-split",
        what: "16 to 128 points between kinks, scaled",
        kind: Kind::Panels,
        prepare: split,
        count: None,
    },
];

/// More evaluations than this for one integral are no method.
const LIMIT: usize = 20_000;

/// Parts of different sign are integrated by themselves, so that a tolerance relative to each can
/// be met where they cancel.
fn kronrod(_: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
    let (problem, tolerance) = (problem.clone(), tolerance(setting)?);
    let signs = problem.signs();
    Ok(Box::new(move || {
        let (breaks, scale) = (problem.breaks(), problem.scale());
        let (mut value, mut evaluations) = (0.0, 0);
        for sign in &signs {
            let only = (signs.len() > 1).then_some(*sign);
            let integrand = |t: f64| problem.law_at(t / scale, only) * problem.weight(t);
            let found =
                gauss_kronrod(integrand, &breaks, tolerance, LIMIT).map_err(Failure::from)?;
            value += found.value;
            evaluations += found.evaluations;
        }
        Ok(Outcome { value: problem.in_units(value), scaled: true, evaluations: Some(evaluations) })
    }))
}

fn tanh_sinh(_: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
    let (problem, tolerance) = (problem.clone(), tolerance(setting)?);
    Ok(Box::new(move || {
        let (breaks, scale) = (problem.breaks(), problem.scale());
        let rules = TanhSinh::shared();
        let (mut value, mut evaluations) = (0.0, 0);
        for ends in breaks.windows(2).filter(|ends| ends[1] > ends[0]) {
            let integrand = |t: f64| problem.law_at(t / scale, None) * problem.weight(t);
            let found = rules.integrate(ends[0], ends[1], tolerance, |point| integrand(point.x));
            value += found.value;
            evaluations += found.evaluations;
        }
        Ok(Outcome { value: problem.in_units(value), scaled: true, evaluations: Some(evaluations) })
    }))
}

fn split(_: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
    let Setting::Points(points) = setting else { bail!("{setting:?} is no number of points") };
    let (problem, rule) = (problem.clone(), legendre(points));
    Ok(Box::new(move || {
        let (breaks, scale) = (problem.breaks(), problem.scale());
        let (mut value, mut evaluations) = (0.0, 0);
        for ends in breaks.windows(2).filter(|ends| ends[1] > ends[0]) {
            let width = ends[1] - ends[0];
            for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                let t = ends[0] + width * node;
                value += width * weight * problem.law_at(t / scale, None) * problem.weight(t);
            }
            evaluations += points;
        }
        Ok(Outcome { value: problem.in_units(value), scaled: true, evaluations: Some(evaluations) })
    }))
}
