//! A law q(w): the response of one asperity to an interference w, as a sum of parts.

pub(crate) mod contact_radii;
pub(crate) mod formula;
pub mod testkit;

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use asperity_quadrature::{Density, Piece, QuadratureError, Sampler};
use serde::Serialize;

use crate::law::formula::{Formula, Power};

/// The kind of deformation that a part describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// Reversible.
    Elastic,
    /// Yielding has begun but is contained.
    ElasticPlastic,
    /// Yielding has spread over the whole contact.
    Plastic,
}

impl Regime {
    fn name(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::ElasticPlastic => "elastic-plastic",
            Self::Plastic => "plastic",
        }
    }
}

impl fmt::Display for Regime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One part of a law: one regime, on one range of x.
#[derive(Debug, Clone)]
pub struct Part {
    /// Name of the part: the regime, with a number if the law has several parts of one regime.
    pub name: Cow<'static, str>,
    /// The regime it belongs to.
    pub regime: Regime,
    /// Factor in the sum; negative only if the model subtracts the part.
    pub sign: f64,
    /// Range of x in which the part holds.
    pub range: Range<f64>,
    /// Known kinks strictly inside the range. An undeclared kink costs time, and the error stays
    /// below the tolerance; an undeclared jump may escape the bound, which is then too small.
    pub kinks: Vec<f64>,
    /// The formula, in value units.
    pub form: Formula,
}

/// The response of one asperity to an interference w: q(w) = `value_unit` · Σ sign · part(x), with
/// x = w/`interference_unit` - `onset`.
#[derive(Debug, Clone)]
pub struct Law {
    /// The unit of interferences \[m\].
    pub interference_unit: f64,
    /// The unit of values: \[N\], \[m²\] or \[N/m\].
    pub value_unit: f64,
    /// Interference at which x = 0, in interference units: 0 for most laws, below 0 if adhesion
    /// keeps an asperity in contact while it is pulled away.
    pub onset: f64,
    /// The parts; their ranges may overlap, as in lateral models.
    pub parts: Vec<Part>,
    /// How shares of regimes are counted, where not by `parts`.
    pub shares: Option<ShareParts>,
}

/// Parts that sum to a law and are made where shares are asked for; those of one name that follow
/// each other are one share.
#[derive(Debug, Clone)]
pub struct ShareParts {
    /// The law that they are made of.
    pub of: Arc<Law>,
    /// What makes them, in the units of the law that has them.
    pub parts: fn(&Law) -> Vec<Part>,
}

impl Law {
    /// A law without parts, in these units (both positive).
    #[must_use]
    pub fn in_units(interference_unit: f64, value_unit: f64) -> Self {
        // Most laws have at most four.
        let parts = Vec::with_capacity(4);
        Self { interference_unit, value_unit, onset: 0.0, parts, shares: None }
    }

    /// Measures x from this interference, in interference units; the law is 0 below it.
    #[must_use]
    pub fn with_onset(self, onset: f64) -> Self {
        Self { onset, ..self }
    }

    /// Adds an elastic part.
    #[must_use]
    pub fn elastic(self, range: Range<f64>, form: impl Into<Formula>) -> Self {
        self.with(Regime::Elastic, range, form)
    }

    /// Adds an elastic-plastic part.
    #[must_use]
    pub fn elastic_plastic(self, range: Range<f64>, form: impl Into<Formula>) -> Self {
        self.with(Regime::ElasticPlastic, range, form)
    }

    /// Adds a plastic part.
    #[must_use]
    pub fn plastic(self, range: Range<f64>, form: impl Into<Formula>) -> Self {
        self.with(Regime::Plastic, range, form)
    }

    /// Subtracts the force of adhesion from the elastic force.
    #[must_use]
    pub fn less_adhesion(mut self, range: Range<f64>, form: impl Into<Formula>) -> Self {
        self = self.with(Regime::Elastic, range, form);
        if let Some(part) = self.parts.last_mut() {
            (part.name, part.sign) = ("adhesion".into(), -1.0);
        }
        self
    }

    /// The number of contacts: 1 for every interference, in units of this length \[m\].
    #[must_use]
    pub(crate) fn counting(interference_unit: f64) -> Self {
        let one = [Power::new(1.0, 0.0)];
        Self::in_units(interference_unit, 1.0).elastic(0.0..f64::INFINITY, one)
    }

    fn with(mut self, regime: Regime, range: Range<f64>, form: impl Into<Formula>) -> Self {
        let before = self.parts.iter().filter(|p| p.regime == regime).count();
        // Sweeps build laws for every scene: these names need no allocation.
        let name = match (regime, before) {
            (_, 0) => regime.name().into(),
            (Regime::ElasticPlastic, 1) => "elastic-plastic 2".into(),
            (_, n) => format!("{regime} {}", n + 1).into(),
        };
        let (kinks, form) = (vec![], form.into());
        self.parts.push(Part { name, regime, sign: 1.0, range, kinks, form });
        self
    }

    /// The interferences at which the formula changes, in interference units, ascending, without
    /// the onset of the law.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        let mut kinks = self.density().breaks(0.0, f64::INFINITY);
        kinks.iter_mut().for_each(|x| *x += self.onset);
        kinks
    }

    /// The value \[N, m² or N/m\] at interference w \[m\]; 0 up to the onset of the law. At a jump,
    /// the value above it.
    ///
    /// # Errors
    /// Any error of a part's function.
    pub fn value(&self, interference: f64) -> Result<f64, QuadratureError> {
        let x = interference / self.interference_unit - self.onset;
        if x <= 0.0 {
            return Ok(0.0);
        }
        Ok(self.value_unit * self.shape(x)?)
    }

    /// The value over the value unit at x.
    pub(crate) fn shape(&self, x: f64) -> Result<f64, QuadratureError> {
        let mut total = 0.0;
        for part in self.parts.iter().filter(|p| p.range.contains(&x)) {
            let mut value = [0.0];
            part.form.sample(&[x], &mut value)?;
            total += part.sign * value[0];
        }
        Ok(total)
    }

    /// The parts by which shares of regimes are counted.
    pub(crate) fn share_parts(&self) -> Cow<'_, [Part]> {
        match &self.shares {
            Some(ShareParts { of, parts }) => Cow::Owned(parts(of)),
            None => Cow::Borrowed(&self.parts),
        }
    }

    /// True if a part is subtracted.
    #[must_use]
    pub fn is_signed(&self) -> bool {
        self.parts.iter().any(|part| part.sign < 0.0)
    }

    /// The whole law as a density of x.
    #[must_use]
    pub fn density(&self) -> Density {
        Density { pieces: self.parts.iter().map(Part::piece).collect() }
    }
}

impl Part {
    /// The part alone, with its sign.
    fn piece(&self) -> Piece {
        Piece {
            from: self.range.start,
            to: self.range.end,
            sign: self.sign,
            kinks: self.kinks.clone(),
            origin: self.origin(),
            sampler: Arc::new(self.form.clone()),
        }
    }

    /// The part alone as a density of x.
    pub(crate) fn density(&self) -> Density {
        Density { pieces: vec![self.piece()] }
    }

    /// The common origin of the fractional powers, if there is one.
    fn origin(&self) -> Option<f64> {
        let Formula::Powers(powers) = &self.form else {
            return None;
        };
        let mut origins = powers.iter().filter(|p| p.exponent.fract() != 0.0).map(|p| p.origin);
        let first = origins.next().unwrap_or(0.0);
        origins.all(|o| o.total_cmp(&first).is_eq()).then_some(first)
    }

    /// The sign, times the first coefficient of a sum of powers.
    pub(crate) fn factor(&self) -> f64 {
        match &self.form {
            Formula::Powers(powers) => self.sign * leading(powers),
            Formula::Function { .. } => self.sign,
        }
    }

    /// The part over its factor.
    pub(crate) fn without_factor(&self) -> Self {
        let mut part = Self { sign: 1.0, ..self.clone() };
        if let Formula::Powers(powers) = &mut part.form {
            let first = leading(powers);
            powers.iter_mut().for_each(|p| p.coefficient /= first);
        }
        part
    }

    /// Whether the other part is a multiple of this one, which has no factor.
    pub(crate) fn recurs_in(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        let forms = match (&self.form, &other.form) {
            (Formula::Powers(a), Formula::Powers(b)) => {
                let first = leading(b);
                a.len() == b.len()
                    && a.iter().zip(b).all(|(a, b)| {
                        same(a.exponent, b.exponent)
                            && same(a.origin, b.origin)
                            && same(a.coefficient, b.coefficient / first)
                    })
            }
            (Formula::Function { key: Some(a), .. }, Formula::Function { key: Some(b), .. }) => {
                a == b
            }
            _ => false,
        };
        forms
            && same(self.range.start, other.range.start)
            && same(self.range.end, other.range.end)
            && self.kinks == other.kinks
    }
}

/// The first coefficient that is not 0.
fn leading(powers: &[Power]) -> f64 {
    powers.iter().map(|p| p.coefficient).find(|c| c.abs() > 0.0).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> Law {
        Law::in_units(2.0, 10.0)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .elastic_plastic(1.0..6.0, [Power::new(1.0, 0.0), Power::from_origin(2.0, 1.0, 1.27)])
            .elastic_plastic(6.0..f64::INFINITY, Formula::function(|x| 3.0 * x))
    }

    #[test]
    fn value_and_kinks_follow_the_parts() {
        let law = law();
        assert_eq!(law.kinks(), [1.0, 6.0]);
        assert!(law.value(-1.0).unwrap().abs() < f64::MIN_POSITIVE);
        assert!((law.value(0.5).unwrap() - 1.25).abs() < 1e-15);
        assert!((law.value(4.0).unwrap() - 30.0).abs() < 1e-14);
        assert!((law.value(20.0).unwrap() - 300.0).abs() < 1e-12);
        assert_eq!(law.parts[2].name, "elastic-plastic 2");
    }

    #[test]
    fn the_origin_of_fractional_powers_is_found() {
        let origins: Vec<_> = law().parts.iter().map(Part::origin).collect();
        assert_eq!(origins, [Some(0.0), Some(1.0), None]);
    }
}
