//! How a compiled scene answers: what is integrated, with how many terms, and what is left out.

use std::fmt;

use asperity_quadrature::reach;

use serde::Serialize;

use crate::engine::channel::{Channel, failed};
use crate::engine::compiled::Compiled;
use crate::{At, Contact, ContactError, HeightDistribution, Part, Quantity, Request};

/// How an integral over the heights is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Method {
    /// Gaussian heights: polynomials, one for each range of separations.
    Polynomials,
    /// Exponential heights: one integral for all separations ≥ 0, one for each below.
    OneIntegral,
    /// Other heights: adaptive panels, and from those series in the separation.
    Panels,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Polynomials => "polynomials in the separation",
            Self::OneIntegral => "one integral for all separations above 0, as exp(-d) is a factor",
            Self::Panels => {
                "panels that follow the heights; series in the separation between kinks, made where asked"
            }
        })
    }
}

/// One part of a law in a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlannedPart {
    /// Name of the part.
    pub name: String,
    /// What its formula is, in words: a sum of powers, an angle average in closed form or
    /// tabulated, another function.
    pub form: String,
    /// `None` where the part is integrated; otherwise the share of the whole, at most, that is
    /// dropped with it because no asperity reaches it.
    pub dropped: Option<f64>,
}

/// One integral of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Step {
    /// Which law is integrated: that of the force for the tangent.
    pub law: Quantity,
    /// The asked quantities that come of it.
    pub quantities: Vec<Quantity>,
    /// How.
    pub method: Method,
    /// The law's parts.
    pub parts: Vec<PlannedPart>,
    /// Terms of the shortest and the longest polynomial: products for each evaluation.
    pub terms: Option<(usize, usize)>,
    /// How often the law has been sampled to build what the separations need.
    pub samples: usize,
}

/// What a compiled scene does for a request.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Plan {
    /// The model's name.
    pub model: String,
    /// Name of the heights.
    pub heights: String,
    /// Relative tolerance.
    pub tolerance: f64,
    /// How many separations or loads were asked about.
    pub rows: usize,
    /// The smallest separation and the largest, as they were asked for.
    pub range: Option<(At, At)>,
    /// The integrals.
    pub steps: Vec<Step>,
}

impl Compiled {
    /// What is done for a request, in numbers; builds what its rows need.
    pub(crate) fn planned(&self, request: &Request) -> Result<Plan, ContactError> {
        let places: Vec<f64> = request
            .at
            .iter()
            .map(|at| Ok(self.place(*at)?.s))
            .collect::<Result<_, ContactError>>()?;
        let steps = self.channels().iter().map(|channel| self.step(channel, &places));
        let first = places.iter().zip(&request.at).min_by(|a, b| a.0.total_cmp(b.0));
        let last = places.iter().zip(&request.at).max_by(|a, b| a.0.total_cmp(b.0));
        Ok(Plan {
            model: self.model().into(),
            heights: self.scene().heights.name().into(),
            tolerance: request.tolerance.relative(),
            rows: places.len(),
            range: first.zip(last).map(|((_, first), (_, last))| (*first, *last)),
            steps: steps.collect::<Result<_, _>>()?,
        })
    }

    fn step(&self, channel: &Channel, places: &[f64]) -> Result<Step, ContactError> {
        let law = channel.base;
        let comes_of = |q: &Quantity| self.bases(*q).contains(&law);
        let quantities = self.quantities().iter().copied().filter(comes_of).collect();
        let mut terms: Option<(usize, usize)> = None;
        let mut farthest: f64 = 0.0;
        for &s in places {
            let failed = failed(law, s.into());
            channel.total.value(s).map_err(&failed)?;
            if let Some(n) = channel.total.terms(s).map_err(&failed)? {
                let (least, most) = terms.unwrap_or((n, n));
                terms = Some((least.min(n), most.max(n)));
            }
            farthest = farthest.max(reach(channel.units.begins.seen(s)));
        }
        let method = match self.scene().heights {
            HeightDistribution::Gaussian => Method::Polynomials,
            HeightDistribution::Exponential => Method::OneIntegral,
            HeightDistribution::Weibull(_) | HeightDistribution::Other(_) => Method::Panels,
        };
        // Beyond the reach, the Gaussian is below 1e-20 of its largest value.
        let out_of_reach = |part: &Part| {
            method == Method::Polynomials && part.range.start * channel.units.scale > farthest
        };
        let planned = |part: &Part| PlannedPart {
            name: part.name.to_string(),
            form: part.form.describe().into(),
            dropped: out_of_reach(part).then_some(1e-20),
        };
        let parts = channel.law.parts.iter().map(planned).collect();
        Ok(Step { law, quantities, method, parts, terms, samples: channel.total.samples() })
    }
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {} heights, ", self.model, self.heights)?;
        match self.range {
            Some((only, last)) if only == last => write!(f, "{only}")?,
            Some((first, last)) => write!(f, "{} rows from {first} to {last}", self.rows)?,
            None => f.write_str("no rows")?,
        }
        writeln!(f, ", relative tolerance {:e}", self.tolerance)?;
        for step in &self.steps {
            let names: Vec<String> = step.quantities.iter().map(ToString::to_string).collect();
            writeln!(f, "  {} from the {} law: {}", names.join(", "), step.law, step.method)?;
            if let Some((least, most)) = step.terms {
                let terms =
                    if least == most { least.to_string() } else { format!("{least} to {most}") };
                let samples = step.samples;
                writeln!(f, "    {terms} terms a value; {samples} samples of the law, once")?;
            }
            for part in &step.parts {
                match part.dropped {
                    None => writeln!(f, "    {}: {}", part.name, part.form)?,
                    Some(bound) => writeln!(
                        f,
                        "    {}: out of reach, below {bound:e} of the whole",
                        part.name
                    )?,
                }
            }
        }
        Ok(())
    }
}
