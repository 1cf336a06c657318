//! Makes the plan of a request.

use asperity_quadrature::reach;

use crate::engine::averages::separation_at;
use crate::engine::prepared::{Channel, Prepared};
use crate::error::integral_failed;
use crate::{ContactError, HeightDistribution, Part, Plan, PlannedPart, Quantity, Request, Step};

/// The plan for a request; builds what its rows need.
pub(crate) fn plan(prepared: &Prepared, request: &Request) -> Result<Plan, ContactError> {
    let mut averages = prepared;
    let places = request.at.iter().map(|at| Ok(separation_at(&mut averages, at)?.s));
    let places: Vec<f64> = places.collect::<Result<_, ContactError>>()?;
    let steps = prepared.channels.iter().map(|channel| step(prepared, channel, &places));
    let rows = || places.iter().zip(&request.at);
    let first = rows().min_by(|a, b| a.0.total_cmp(b.0));
    let last = rows().max_by(|a, b| a.0.total_cmp(b.0));
    Ok(Plan {
        model: prepared.facts.model.clone(),
        heights: prepared.scene.heights.name().into(),
        tolerance: prepared.facts.laws.tolerance.relative(),
        rows: places.len(),
        range: first.zip(last).map(|((_, first), (_, last))| (*first, *last)),
        steps: steps.collect::<Result<_, _>>()?,
    })
}

fn step(prepared: &Prepared, channel: &Channel, places: &[f64]) -> Result<Step, ContactError> {
    let law = channel.base;
    let needs_law = |q: &Quantity| prepared.laws_of(*q).any(|base| base == law);
    let quantities = prepared.facts.quantities.iter().copied().filter(needs_law).collect();
    let mut terms: Option<(usize, usize)> = None;
    let mut farthest: f64 = 0.0;
    for &s in places {
        let at = s.into();
        let failed = integral_failed(law, &at);
        channel.total.value(s).map_err(&failed)?;
        if let Some(n) = channel.total.terms(s).map_err(&failed)? {
            terms = Some(terms.map_or((n, n), |(least, most)| (least.min(n), most.max(n))));
        }
        farthest = farthest.max(reach(channel.units.onset.shifted(s)));
    }
    let method = match prepared.scene.heights {
        HeightDistribution::Gaussian => "polynomials in the separation",
        HeightDistribution::Exponential => {
            "one integral for all separations above 0, as exp(-d) is a factor"
        }
        HeightDistribution::Weibull(_) | HeightDistribution::Other(_) => {
            "panels that follow the heights; series in the separation between kinks, made where asked"
        }
    };
    let gaussian = matches!(prepared.scene.heights, HeightDistribution::Gaussian);
    // Beyond the reach, the Gaussian is below 1e-20 of its largest value.
    let out_of_reach = |part: &Part| gaussian && part.range.start * channel.units.scale > farthest;
    let planned = |part: &Part| PlannedPart {
        name: part.name.to_string(),
        form: part.form.describe().into(),
        dropped: out_of_reach(part).then_some(1e-20),
    };
    let parts = channel.law.parts.iter().map(planned).collect();
    Ok(Step { law, quantities, method, parts, terms, samples: channel.total.samples() })
}
