//! Checks that any model's laws must pass: for the models of this project, and for yours.

use asperity_quadrature::{Sampler, legendre};

use crate::finding::short;
use crate::{
    Asperity, Code, ContactError, ContactModel, Finding, Findings, Law, Part, Quantity, Tolerance,
    Validity,
};

/// Range of x = w/unit that is checked.
const RANGE: (f64, f64) = (1e-8, 1e6);
/// Points in that range.
const POINTS: i32 = 1400;

/// Checks the laws of a model on one asperity; empty if they pass.
///
/// Force, area and, where the model has its own, stiffness: zero at zero, parts finite and not
/// negative, and smooth between declared kinks; the force monotone and Hertzian where claimed. A
/// positive force that falls is noted where monotony is not claimed: several separations may carry
/// one load.
///
/// # Errors
/// What the model itself refuses, as for an asperity outside its range.
pub fn check(
    model: &(impl ContactModel + ?Sized),
    asperity: &Asperity,
) -> Result<Findings, ContactError> {
    let tolerance = Tolerance::new(1e-10)?;
    let (mut findings, mut first) = (Findings::default(), None);
    let adhesive = model.validity().adhesive;
    for quantity in [Quantity::Force, Quantity::Area, Quantity::Stiffness] {
        let law = match model.law(asperity, quantity, tolerance) {
            Err(ContactError::NoLaw { .. }) if quantity == Quantity::Stiffness => continue,
            law => law?,
        };
        let onset = law.onset * law.interference_unit;
        let wanted = *first.get_or_insert(if adhesive { onset } else { 0.0 });
        if onset.total_cmp(&wanted).is_ne() {
            let advice = "start it at 0 or, with adhesion, where the force starts";
            let finding = fault(Code::LawStart, "begins", law.onset, quantity);
            let fact = format!("the law of {quantity} starts at x = {}", short(law.onset));
            findings.push(finding.fact(fact).advice(advice));
        }
        // Adhesion makes contacts jump into being.
        if quantity != Quantity::Stiffness && !adhesive {
            vanishes(quantity, &law, &mut findings);
        }
        for part in &law.parts {
            bad_values(quantity, &law, part, &mut findings);
            undeclared_kinks(quantity, &law, part, &mut findings);
        }
        if quantity == Quantity::Force {
            validity(model.validity(), asperity, &law, &mut findings);
        }
    }
    Ok(findings)
}

fn fault(code: Code, field: &'static str, value: f64, quantity: Quantity) -> Finding {
    Finding::warning(code, field, value).of_quantity(quantity)
}

fn grid() -> impl Iterator<Item = f64> {
    let (low, high) = (RANGE.0.ln(), RANGE.1.ln());
    (0..=POINTS).map(move |k| (low + (high - low) * f64::from(k) / f64::from(POINTS)).exp())
}

/// NaN where the law fails, which is reported as a bad value.
fn shape(law: &Law, x: f64) -> f64 {
    law.shape(x).unwrap_or(f64::NAN)
}

fn vanishes(quantity: Quantity, law: &Law, findings: &mut Findings) {
    let ratio = shape(law, 1e-30) / shape(law, 1.0);
    if ratio.is_nan() || ratio.abs() > 1e-6 {
        let fact = format!("the law of {quantity} keeps {} of its value at x = 1", short(ratio));
        let advice = "at x = 0 it must vanish unless the model claims adhesion";
        let found = fault(Code::LawStart, "ratio", ratio, quantity);
        findings.push(found.fact(fact).advice(advice));
    }
}

fn bad_values(quantity: Quantity, law: &Law, part: &Part, findings: &mut Findings) {
    for at in grid().filter(|x| part.range.contains(x)) {
        let mut value = [f64::NAN];
        let refused = part.form.sample(&[at], &mut value).is_err();
        if refused || !(value[0] >= 0.0 && value[0].is_finite()) {
            let fact = format!(
                "the {} part of {quantity} is {} at {}",
                part.name,
                short(value[0]),
                place(law, at)
            );
            let found =
                fault(Code::BadValue, "value", value[0], quantity).of_law(part.name.to_string());
            findings.push(found.fact(fact).advice("parts must be finite and at least 0"));
            return;
        }
    }
}

fn validity(validity: Validity, asperity: &Asperity, law: &Law, findings: &mut Findings) {
    if !validity.adhesive {
        findings.extend(falls(law, validity.force_monotone));
    }
    if let Some(claimed) = validity.hertz_limit {
        let w = 1e-7 * law.interference_unit;
        let hertz = 4.0 / 3.0 * asperity.equivalent_modulus * (asperity.radius * w).sqrt() * w;
        let found = law.value_unit * shape(law, 1e-7) / hertz;
        if found.is_nan() || (found / claimed - 1.0).abs() > 1e-9 {
            let fact = format!("force tends to {found} times Hertz' law");
            let off = fault(Code::LawStart, "hertz_limit", found, Quantity::Force);
            findings.push(off.fact(fact).advice(format!("the model claims {claimed}")));
        }
    }
}

/// Where the force of a positive law first falls as the interference grows: a warning if the model
/// claims that it does not.
fn falls(law: &Law, claimed: bool) -> Option<Finding> {
    // A law may be flat; rounding may not count as falling.
    let falls = |pair: &(f64, f64)| shape(law, pair.1) < shape(law, pair.0) * (1.0 - 1e-12);
    let mut points: Vec<f64> = grid().collect();
    let kinks = law.kinks().into_iter().map(|k| k - law.onset);
    points.extend(kinks.flat_map(|k| [k * (1.0 - 1e-9), k]));
    points.sort_by(f64::total_cmp);
    let mut pairs = points.windows(2).map(|pair| (pair[0], pair[1]));
    let (_, at) = pairs.find(falls).filter(|_| claimed || !law.is_signed())?;
    let found = match claimed {
        true => Finding::warning(Code::NotMonotone, "x", at)
            .advice("the model claims a monotone force; withdraw the claim or correct the law"),
        false => Finding::note(Code::NotMonotone, "x", at)
            .advice("several separations may carry one load"),
    };
    let fact = format!("force falls at {} as the interference grows", place(law, at));
    Some(found.of_quantity(Quantity::Force).fact(fact))
}

/// An interference of a law, in its unit and in metres.
fn place(law: &Law, x: f64) -> String {
    let metres = (x + law.onset) * law.interference_unit;
    format!("x = {} (w = {} m)", short(x), short(metres))
}

/// Between declared kinks, a part must be resolved by polynomials in ln x on ever smaller pieces;
/// only at a declared end may that fail (a fractional power of the distance to it).
fn undeclared_kinks(quantity: Quantity, law: &Law, part: &Part, findings: &mut Findings) {
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
                let found = Finding::warning(Code::UndeclaredKink, "x", at)
                    .of_quantity(quantity)
                    .of_law(part.name.to_string())
                    .fact(format!(
                        "the {} part of {quantity} has an undeclared kink near {}",
                        part.name,
                        place(law, at)
                    ))
                    .advice("declare it; results remain correct but take longer");
                findings.push(found);
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
    use crate::{AsperityModel, Citation, Described, Formula, Interface, Power, Provenance};

    const SOURCE: Citation = Citation {
        id: "mine",
        name: "mine",
        authors: "nobody",
        year: 2026,
        title: "",
        provenance: Provenance::Derived,
        published: &[],
    };

    #[derive(Debug)]
    struct Mine(fn() -> Law);

    impl Described for Mine {
        fn citation(&self) -> &Citation {
            &SOURCE
        }
    }

    impl AsperityModel for Mine {
        fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
            let value_unit = 4.0 / 3.0 * asperity.equivalent_modulus * asperity.radius.powi(2);
            Ok(Law { interference_unit: asperity.radius, value_unit, ..(self.0)() })
        }

        fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
            Ok(Law { interference_unit: asperity.radius, ..(self.0)() })
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
        assert!(falls.starts_with("force falls at x = 1 (w = 1e-4 m)"), "{falls}");
        let kinked = findings(|| {
            hertz().plastic(
                1.0..f64::INFINITY,
                Formula::function(|x| if x < 3.3 { 2.0 * x } else { 3.0 * x }),
            )
        });
        assert!(kinked.contains("undeclared kink near x = 3.3 (w = 3.3e-4 m)"), "{kinked}");
        let soft = findings(|| Law::in_units(1.0, 1.0).elastic(0.0..1e9, [Power::new(0.5, 1.5)]));
        assert!(soft.contains("tends to 0.5"), "{soft}");
        let offset = findings(|| Law::in_units(1.0, 1.0).elastic(0.0..1e9, [Power::new(1.0, 0.0)]));
        assert!(offset.contains("at x = 0"), "{offset}");
        let early = findings(|| hertz().with_onset(-1.0));
        assert!(
            early.contains("force starts at x = -1") && early.contains("area starts"),
            "{early}"
        );
        let negative = findings(|| hertz().plastic(1.0..f64::INFINITY, [Power::new(-1.0, 1.0)]));
        assert!(negative.contains("-1") && negative.contains("at least 0"), "{negative}");
    }
}
