//! How a compiled scene answers: what is integrated, with how many nodes, and what is left out.

use std::fmt;

use asperity_quadrature::reach;

use crate::{Compiled, ContactError, HeightDistribution, Part, Quantity, Request};

/// How an integral over the heights is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Gaussian heights: Gauss rules with the law as their weight, one for each range of separations.
    GaussRules,
    /// Exponential heights: one integral for all separations ≥ 0, one for each below.
    OneIntegral,
    /// Other heights: adaptive panels at each separation.
    Panels,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::GaussRules => "Gauss rules with the law as weight",
            Self::OneIntegral => "one integral for all separations above 0, as exp(-d) is a factor",
            Self::Panels => {
                "adaptive panels at each separation, as nothing is known of the heights"
            }
        })
    }
}

/// One part of a law in a plan.
#[derive(Debug, Clone, PartialEq)]
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
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Which law is integrated: that of the force for the tangent.
    pub law: Quantity,
    /// The asked quantities that come of it.
    pub quantities: Vec<Quantity>,
    /// How.
    pub method: Method,
    /// The law's parts.
    pub parts: Vec<PlannedPart>,
    /// Nodes of the smallest and the largest rule: exponentials for each evaluation.
    pub nodes: Option<(usize, usize)>,
    /// How often the law has been sampled to build what the separations need.
    pub samples: usize,
}

/// What a compiled scene does for a request.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The model's name.
    pub model: String,
    /// Name of the heights.
    pub heights: String,
    /// Relative tolerance.
    pub tolerance: f64,
    /// Number of separations, and their range.
    pub separations: (usize, f64, f64),
    /// The integrals.
    pub steps: Vec<Step>,
}

impl Compiled {
    /// What is done for a request, in numbers; builds what its separations need.
    ///
    /// # Errors
    /// Those of [`evaluate`](Compiled::evaluate).
    pub fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        let mut steps = vec![];
        for law in [Quantity::Force, Quantity::Area, Quantity::Stiffness] {
            if let Some(step) = self.step(law, request)? {
                steps.push(step);
            }
        }
        let range =
            |start: f64, f: fn(f64, f64) -> f64| request.separations.iter().copied().fold(start, f);
        Ok(Plan {
            model: self.model().into(),
            heights: self.heights().name().into(),
            tolerance: request.tolerance.relative(),
            separations: (
                request.separations.len(),
                range(f64::INFINITY, f64::min),
                range(f64::NEG_INFINITY, f64::max),
            ),
            steps,
        })
    }

    fn step(&self, law: Quantity, request: &Request) -> Result<Option<Step>, ContactError> {
        let asked = |q: &Quantity| self.law_behind(*q) == Some(law);
        let quantities: Vec<Quantity> = self.quantities().iter().copied().filter(asked).collect();
        let Some(&first) = quantities.first() else { return Ok(None) };
        let mut nodes: Option<(usize, usize)> = None;
        let mut farthest: f64 = 0.0;
        for &s in &request.separations {
            self.evaluate(first, s)?;
            if let Some(n) = self.nodes(first, s)? {
                let (least, most) = nodes.unwrap_or((n, n));
                nodes = Some((least.min(n), most.max(n)));
            }
            farthest = farthest.max(reach(s));
        }
        let method = match self.heights() {
            HeightDistribution::Gaussian => Method::GaussRules,
            HeightDistribution::Exponential => Method::OneIntegral,
            HeightDistribution::Other(_) => Method::Panels,
        };
        let scale = self.scale(first)?;
        // Beyond the reach, the Gaussian is below 1e-20 of its largest value.
        let out_of_reach =
            |part: &Part| method == Method::GaussRules && part.range.start * scale > farthest;
        let planned = |part: &Part| PlannedPart {
            name: part.name.to_string(),
            form: part.form.describe().into(),
            dropped: out_of_reach(part).then_some(1e-20),
        };
        let parts = self.law(first)?.parts.iter().map(planned).collect();
        let samples = self.samples(first)?;
        Ok(Some(Step { law, quantities, method, parts, nodes, samples }))
    }
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (count, low, high) = self.separations;
        write!(f, "{}, {} heights, {count} separations", self.model, self.heights)?;
        if count > 0 {
            write!(f, " from {low} to {high}")?;
        }
        writeln!(f, ", relative tolerance {:e}", self.tolerance)?;
        for step in &self.steps {
            let names: Vec<String> = step.quantities.iter().map(ToString::to_string).collect();
            writeln!(f, "  {} from the {} law: {}", names.join(", "), step.law, step.method)?;
            if let Some((least, most)) = step.nodes {
                let nodes =
                    if least == most { least.to_string() } else { format!("{least} to {most}") };
                let samples = step.samples;
                writeln!(
                    f,
                    "    {nodes} nodes: exponentials a value; {samples} samples of the law, once"
                )?;
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
