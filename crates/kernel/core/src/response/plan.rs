//! The plan of a request: integrals, terms of their polynomials, and parts that are left out.

use std::fmt;

use serde::Serialize;

use crate::{At, Quantity};

/// One part of a law in a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlannedPart {
    /// Name of the part.
    pub name: String,
    /// Kind of its formula: a sum of powers, an angle average in closed form or tabulated, another
    /// function.
    pub form: String,
    /// `None` for a part that is integrated; otherwise a bound on its share of the whole, for a
    /// part that no asperity reaches.
    pub dropped: Option<f64>,
}

/// One integral of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Step {
    /// The quantity of the law that is integrated: the force for the tangent.
    pub law: Quantity,
    /// The requested quantities that follow from it.
    pub quantities: Vec<Quantity>,
    /// How it is integrated.
    pub method: &'static str,
    /// The law's parts.
    pub parts: Vec<PlannedPart>,
    /// Terms of the shortest and the longest polynomial: products for each evaluation.
    pub terms: Option<(usize, usize)>,
    /// Number of samples of the law for the polynomials of these separations.
    pub samples: usize,
}

/// The work of a compiled scene for a request.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Plan {
    /// The model's name.
    pub model: String,
    /// Name of the heights.
    pub heights: String,
    /// Relative tolerance.
    pub tolerance: f64,
    /// Number of separations or loads.
    pub rows: usize,
    /// The smallest and the largest separation, in the caller's units.
    pub range: Option<(At, At)>,
    /// The integrals.
    pub steps: Vec<Step>,
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
