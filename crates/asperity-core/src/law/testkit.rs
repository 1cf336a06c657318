//! Checks that any model's laws must pass: for the models of this project, and for yours.

use std::fmt;

use asperity_quadrature::{Sampler, legendre};

use crate::{Asperity, AsperityModel, ContactError, ContactModel, Law, Part, Quantity, Tolerance};

/// Something wrong with a law.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Finding {
    /// The law does not vanish with the interference, although adhesion is not claimed.
    NotZeroAtZero {
        /// Which law.
        quantity: Quantity,
        /// Its value at a vanishing interference, over that at the interference unit.
        ratio: f64,
    },
    /// A part is negative or not a number.
    BadValue {
        /// Which law.
        quantity: Quantity,
        /// Name of the part.
        part: String,
        /// Interference over its unit.
        at: f64,
        /// The part's value, in value units.
        value: f64,
    },
    /// The force falls although the model claims that it does not.
    NotMonotone {
        /// Interference over its unit.
        at: f64,
    },
    /// The force does not tend to the claimed multiple of Hertz' law.
    NotHertz {
        /// The multiple found.
        found: f64,
        /// The multiple claimed.
        claimed: f64,
    },
    /// The law begins where it may not: elsewhere than at no interference although adhesion is not
    /// claimed, or elsewhere than the law of the force.
    Begins {
        /// Which law.
        quantity: Quantity,
        /// Where, over the interference unit.
        at: f64,
    },
    /// The law has a kink or jump that it does not declare: results stay right, but are slow.
    UndeclaredKink {
        /// Which law.
        quantity: Quantity,
        /// Name of the part.
        part: String,
        /// Interference over its unit.
        at: f64,
    },
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotZeroAtZero { quantity, ratio } => {
                write!(f, "{quantity}: {ratio:.3e} of its value at x = 1 is left at x = 0")
            }
            Self::BadValue { quantity, part, at, value } => write!(
                f,
                "{quantity}, {part} part: {value} at x = {at:e}, a finite number of at least 0 was required"
            ),
            Self::NotMonotone { at } => write!(f, "force: falls at x = {at:e}"),
            Self::NotHertz { found, claimed } => {
                write!(f, "force: tends to {found} of Hertz' law, {claimed} was claimed")
            }
            Self::Begins { quantity, at } => write!(
                f,
                "{quantity}: begins at x = {at}, 0 or, with adhesion, where the force begins was required"
            ),
            Self::UndeclaredKink { quantity, part, at } => {
                write!(f, "{quantity}, {part} part: undeclared kink near x = {at:.6}")
            }
        }
    }
}

/// Range of x = w/unit that is looked at.
const RANGE: (f64, f64) = (1e-8, 1e6);
/// Points in that range.
const POINTS: i32 = 1400;

/// Checks the laws of a model on one asperity; no finding is good news.
///
/// Force, area and, where the model has its own, stiffness: zero at zero, parts finite and not
/// negative, and smooth between declared kinks; the force monotone and Hertzian where claimed.
///
/// # Errors
/// What the model itself refuses, as for an asperity outside its range.
pub fn check(
    model: &(impl ContactModel + ?Sized),
    asperity: &Asperity,
) -> Result<Vec<Finding>, ContactError> {
    let Some(model) = model.asperity_model() else {
        let (model, quantity) = (model.name().into(), Quantity::Force);
        return Err(ContactError::NoLaw { model, quantity });
    };
    let tolerance = Tolerance::new(1e-10)?;
    let (mut findings, mut first) = (vec![], None);
    let adhesive = model.validity().adhesive;
    for quantity in [Quantity::Force, Quantity::Area, Quantity::Stiffness] {
        let Some(law) = model.law(asperity, quantity, tolerance)? else { continue };
        let begins = law.begins * law.interference_unit;
        let wanted = *first.get_or_insert(if adhesive { begins } else { 0.0 });
        if begins.total_cmp(&wanted).is_ne() {
            findings.push(Finding::Begins { quantity, at: law.begins });
        }
        // Adhesion makes contacts jump into being.
        if quantity != Quantity::Stiffness && !adhesive {
            vanishes(quantity, &law, &mut findings);
        }
        for part in &law.parts {
            bad_values(quantity, part, &mut findings);
            undeclared_kinks(quantity, part, &mut findings);
        }
        if quantity == Quantity::Force {
            validity(model, asperity, &law, &mut findings);
        }
    }
    Ok(findings)
}

fn grid() -> impl Iterator<Item = f64> {
    let (low, high) = (RANGE.0.ln(), RANGE.1.ln());
    (0..=POINTS).map(move |k| (low + (high - low) * f64::from(k) / f64::from(POINTS)).exp())
}

/// NaN where the law refuses: that is then reported as a bad value.
fn shape(law: &Law, x: f64) -> f64 {
    law.shape(x).unwrap_or(f64::NAN)
}

fn vanishes(quantity: Quantity, law: &Law, findings: &mut Vec<Finding>) {
    let ratio = shape(law, 1e-30) / shape(law, 1.0);
    if ratio.is_nan() || ratio.abs() > 1e-6 {
        findings.push(Finding::NotZeroAtZero { quantity, ratio });
    }
}

fn bad_values(quantity: Quantity, part: &Part, findings: &mut Vec<Finding>) {
    for at in grid().filter(|x| part.range.contains(x)) {
        let mut value = [f64::NAN];
        let refused = part.form.sample(&[at], &mut value).is_err();
        if refused || !(value[0] >= 0.0 && value[0].is_finite()) {
            let (part, value) = (part.name.to_string(), value[0]);
            findings.push(Finding::BadValue { quantity, part, at, value });
            return;
        }
    }
}

fn validity(
    model: &dyn AsperityModel,
    asperity: &Asperity,
    law: &Law,
    findings: &mut Vec<Finding>,
) {
    let validity = model.validity();
    if validity.force_monotone {
        // A law may be flat; rounding may not count as falling.
        let falls = |pair: &(f64, f64)| shape(law, pair.1) < shape(law, pair.0) * (1.0 - 1e-12);
        let mut points: Vec<f64> = grid().collect();
        let kinks = law.kinks().into_iter().map(|k| k - law.begins);
        points.extend(kinks.flat_map(|k| [k * (1.0 - 1e-9), k]));
        points.sort_by(f64::total_cmp);
        let mut pairs = points.windows(2).map(|pair| (pair[0], pair[1]));
        findings.extend(pairs.find(falls).map(|(_, at)| Finding::NotMonotone { at }));
    }
    if let Some(claimed) = validity.hertz_limit {
        let w = 1e-7 * law.interference_unit;
        let hertz = 4.0 / 3.0 * asperity.equivalent_modulus * (asperity.radius * w).sqrt() * w;
        let found = law.value_unit * shape(law, 1e-7) / hertz;
        if found.is_nan() || (found / claimed - 1.0).abs() > 1e-9 {
            findings.push(Finding::NotHertz { found, claimed });
        }
    }
}

/// Between declared kinks, a part must be resolved by polynomials in ln x on ever smaller pieces;
/// only at a declared end may that fail (a fractional power of the distance to it).
fn undeclared_kinks(quantity: Quantity, part: &Part, findings: &mut Vec<Finding>) {
    let mut ends: Vec<f64> = part.kinks.clone();
    ends.extend([part.range.start.max(RANGE.0), part.range.end.min(RANGE.1)]);
    ends.sort_by(f64::total_cmp);
    for pair in ends.windows(2).filter(|pair| pair[1] > pair[0]) {
        // A hair inside, so that the formula on the other side of a kink is not looked at.
        let ends = ((pair[0] * (1.0 + 1e-9)).ln(), (pair[1] * (1.0 - 1e-9)).ln());
        let pieces = ((ends.1 - ends.0) / 2.0).ceil().max(1.0);
        for k in 0..pieces as u32 {
            let low = ends.0 + (ends.1 - ends.0) * f64::from(k) / pieces;
            let high = ends.0 + (ends.1 - ends.0) * f64::from(k + 1) / pieces;
            if let Some(at) = unresolved(part, (low, high), ends, 0) {
                let part = part.name.to_string();
                findings.push(Finding::UndeclaredKink { quantity, part, at });
                return;
            }
        }
    }
}

fn unresolved(part: &Part, (low, high): (f64, f64), ends: (f64, f64), depth: u32) -> Option<f64> {
    let rule = legendre(20);
    let x: Vec<f64> = rule.nodes.iter().map(|v| (low + (high - low) * v).exp()).collect();
    let mut values = vec![0.0; x.len()];
    part.form.sample(&x, &mut values).ok()?;
    let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if rule.tail(&values) <= 1e-7 * largest {
        return None;
    }
    let middle = 0.5 * (low + high);
    if depth >= 14 {
        let at_an_end = low - ends.0 < 1e-3 || ends.1 - high < 1e-3;
        return (!at_an_end).then(|| middle.exp());
    }
    unresolved(part, (low, middle), ends, depth + 1)
        .or_else(|| unresolved(part, (middle, high), ends, depth + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Citation, Described, Formula, Interface, Power, Provenance};

    const SOURCE: Citation = Citation {
        id: "mine",
        name: "mine",
        authors: "nobody",
        year: 2026,
        title: "",
        provenance: Provenance::Derived,
    };

    #[derive(Debug)]
    struct Mine(fn() -> Law);

    impl Described for Mine {
        fn citation(&self) -> &Citation {
            &SOURCE
        }
    }

    impl AsperityModel for Mine {
        fn law(
            &self,
            asperity: &Asperity,
            quantity: Quantity,
            _: Tolerance,
        ) -> Result<Option<Law>, ContactError> {
            let unit = match quantity {
                Quantity::Force => {
                    4.0 / 3.0 * asperity.equivalent_modulus * asperity.radius.powi(2)
                }
                _ => 1.0,
            };
            Ok(Some(Law { interference_unit: asperity.radius, value_unit: unit, ..(self.0)() }))
        }
    }

    fn findings(law: fn() -> Law) -> String {
        let asperity = Asperity::new(&Interface::new(1e11, 0.3, 1e9), 1e-4).unwrap();
        let found = check(&Mine(law), &asperity).unwrap();
        found.iter().map(|f| f.to_string() + "\n").collect()
    }

    fn hertz() -> Law {
        Law::in_units(1.0, 1.0).elastic(0.0..1.0, [Power::new(1.0, 1.5)])
    }

    #[test]
    fn a_good_law_passes_and_each_defect_is_found() {
        assert_eq!(findings(|| hertz().plastic(1.0..f64::INFINITY, [Power::new(2.0, 1.0)])), "");
        let falls = findings(|| hertz().plastic(1.0..f64::INFINITY, [Power::new(0.9, 1.0)]));
        assert!(falls.starts_with("force: falls at x = 1e0"), "{falls}");
        let kinked = findings(|| {
            hertz().plastic(
                1.0..f64::INFINITY,
                Formula::function(|x| if x < 3.3 { 2.0 * x } else { 3.0 * x }),
            )
        });
        assert!(kinked.contains("plastic part: undeclared kink near x = 3.3"), "{kinked}");
        let soft = findings(|| Law::in_units(1.0, 1.0).elastic(0.0..1e9, [Power::new(0.5, 1.5)]));
        assert!(soft.contains("tends to 0.5"), "{soft}");
        let offset = findings(|| Law::in_units(1.0, 1.0).elastic(0.0..1e9, [Power::new(1.0, 0.0)]));
        assert!(offset.contains("is left at x = 0"), "{offset}");
        let early = findings(|| hertz().beginning_at(-1.0));
        assert!(
            early.contains("force: begins at x = -1") && early.contains("area: begins"),
            "{early}"
        );
        let negative = findings(|| hertz().plastic(1.0..f64::INFINITY, [Power::new(-1.0, 1.0)]));
        assert!(negative.contains("-1") && negative.contains("at least 0"), "{negative}");
    }
}
