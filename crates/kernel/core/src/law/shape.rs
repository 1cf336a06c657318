//! The shape of a part of a law, its factor apart: parts of one shape share an integral.

use crate::{Formula, Part, Power};

impl Part {
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
