//! The integral of a law from its onset.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::{Formula, FunctionKey, Law, Part, Power, ShareParts};

use crate::antiderivative::Antiderivative;

/// Antiderivatives that are kept.
const KEPT: usize = 16;

/// ∫ q dw from the onset of a law, in its units: on the range of each part its own integral, plus
/// the whole integrals of the parts before it. Shares are the integrals of the parts alone.
pub(crate) fn integral(law: Law) -> Law {
    let follows = |pair: &[Part]| pair[0].range.end.total_cmp(&pair[1].range.start).is_eq();
    let ends = law.parts.last().is_none_or(|part| part.range.end == f64::INFINITY);
    let parts = if ends && law.parts.windows(2).all(follows) && !law.is_signed() {
        let mut before = 0.0;
        let add = |part: &Part| {
            let (form, whole) = integrate(part, before);
            before += whole;
            Part { form, ..part.clone() }
        };
        law.parts.iter().map(add).collect()
    } else {
        separate(&law)
    };
    Law {
        interference_unit: law.interference_unit,
        value_unit: law.value_unit * law.interference_unit,
        onset: law.onset,
        parts,
        shares: Some(ShareParts { of: Arc::new(law), parts: separate }),
    }
}

/// The integral of each part, which keeps its value beyond the end of the part.
fn separate(law: &Law) -> Vec<Part> {
    let both = |part: &Part| {
        let (form, whole) = integrate(part, 0.0);
        let end = part.range.end;
        let kept = Part {
            range: end..f64::INFINITY,
            kinks: vec![],
            form: [Power::new(whole, 0.0)].into(),
            ..part.clone()
        };
        [Some(Part { form, ..part.clone() }), end.is_finite().then_some(kept)]
    };
    law.parts.iter().flat_map(both).flatten().collect()
}

/// The integral of a part from the start of its range, where it has the value `before`, and its
/// rise over the range.
fn integrate(part: &Part, before: f64) -> (Formula, f64) {
    let (start, end) = (part.range.start, part.range.end);
    match &part.form {
        Formula::Powers(powers) => {
            let integral = |power: &Power| {
                let exponent = power.exponent + 1.0;
                Power { coefficient: power.coefficient / exponent, exponent, ..*power }
            };
            let mut terms: Vec<Power> = powers.iter().map(integral).collect();
            let at = |x: f64| terms.iter().map(|power| power.value(x)).sum::<f64>();
            let (first, last) = (at(start), at(end));
            let rest = before - first;
            if rest.is_nan() || rest.abs() > 0.0 {
                terms.push(Power::new(rest, 0.0));
            }
            (Formula::Powers(terms), last - first)
        }
        Formula::Function { key, .. } => {
            let key = key.as_ref().map(|key| FunctionKey {
                name: format!("integral of {}", key.name).into(),
                of: format!("{key:?}"),
                parameters: [&[start, end, before], &*part.kinks].concat(),
            });
            let new = || Arc::new(Antiderivative::new(part, before));
            let integral = key.as_ref().map_or_else(new, |key| recall(key, new));
            let whole = if end.is_finite() { integral.rise(end) } else { end };
            let form = Formula::sampled(integral);
            (key.into_iter().fold(form, Formula::with_key), whole)
        }
    }
}

/// The antiderivative with this key, from the last [`KEPT`] or new: in a sweep whose functions do
/// not change, making it takes several times as long as a value.
fn recall(key: &FunctionKey, new: impl FnOnce() -> Arc<Antiderivative>) -> Arc<Antiderivative> {
    static LAST: Mutex<VecDeque<(FunctionKey, Arc<Antiderivative>)>> = Mutex::new(VecDeque::new());
    let mut all = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, integral)) = all.iter().find(|(known, _)| known == key) {
        return integral.clone();
    }
    let integral = new();
    all.truncate(KEPT - 1);
    all.push_front((key.clone(), integral.clone()));
    integral
}
