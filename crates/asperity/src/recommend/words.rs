//! A recommendation as text.

use std::fmt;

use crate::{
    At, Compared, Comparison, ContactError, Described, EvidenceAt, ExpectedContact, Ratio,
    Recommendation, Separation, evidence::NONE, ranking,
};

impl Recommendation {
    /// The evidence in lines: the separations or loads without any, and which of these models are
    /// expected to be nearest to boundary elements in area and in stiffness.
    #[must_use]
    pub fn summary(&self) -> Vec<String> {
        let mut groups: Vec<Vec<&EvidenceAt>> = vec![];
        for place in self.evidence.iter().filter(|place| place.expected.is_err()) {
            let same = |group: &&mut Vec<&EvidenceAt>| {
                reason(&group[0].expected) == reason(&place.expected)
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.push(place),
                None => groups.push(vec![place]),
            }
        }
        let mut lines: Vec<String> = groups.iter().map(|group| self.without(group)).collect();
        let known = self.evidence.iter().filter(|place| place.expected.is_ok());
        let known: Vec<&EvidenceAt> = known.collect();
        if let [first, ..] = known[..] {
            let off = |id: &str| {
                let of = |place: &&EvidenceAt| {
                    [Compared::Area, Compared::Stiffness].map(|quantity| {
                        place.ratio(id, quantity).map(|ratio| ratio.deviation(quantity))
                    })
                };
                known.iter().map(of).collect()
            };
            let nearest = ranking::nearest(self.comparisons.iter().map(|c| c.model.id()), off);
            let basis = first.expected.as_ref().map_or_else(|_| String::new(), |e| e.basis());
            let here = match (known.len(), self.evidence.len()) {
                (1, 1) => String::new(),
                (1, _) => format!("at {}, ", short(first.at)),
                (some, _) => format!("over these {some} places, "),
            };
            lines.push(format!("{here}{nearest} ({basis})"));
        }
        lines
    }

    /// How far the reference and the recommended model are expected to be from boundary elements, a
    /// line for each quantity: `KE underestimates the area by 5 to 12 % here (alpha 8, psi 2;
    /// boundary elements on 16 surfaces)`. Of several places the widest interval.
    #[must_use]
    pub fn expectations(&self) -> Vec<String> {
        let mut lines = vec![];
        let mut named = vec![&self.reference];
        named.extend(self.simplest.iter().filter(|model| model.id() != self.reference.id()));
        for (model, quantity) in
            named.into_iter().flat_map(|model| Compared::ALL.map(|quantity| (model, quantity)))
        {
            let known = self.evidence.iter().filter_map(|place| {
                Some((place.ratio(model.id(), quantity)?, place.expected.as_ref().ok()?))
            });
            let known: Vec<(Ratio, &ExpectedContact)> = known.collect();
            let both = known.iter().map(|(ratio, _)| *ratio);
            let Some(ratio) = both.reduce(|a, b| a.with(b, quantity)) else { continue };
            let here = match known.len() {
                1 => "here".into(),
                some => format!("at {some} places"),
            };
            let lighter = match known.iter().any(|(_, expected)| expected.extrapolated) {
                true => ", extrapolated to lighter loads",
                false => "",
            };
            let basis = known[0].1.basis();
            let words = ratio.words(quantity);
            lines.push(format!("{} {words} {here} ({basis}{lighter})", model.name()));
        }
        lines
    }

    /// The line for places without evidence, for the same reason.
    fn without(&self, group: &[&EvidenceAt]) -> String {
        let [first, last] = [0, group.len() - 1].map(|k| short(group[k].at));
        let reason = group[0].expected.as_ref().err().map_or_else(String::new, |e| e.to_string());
        let places = match (group.len(), self.evidence.len()) {
            (some, all) if some == all => return reason,
            (1, _) => format!(" at {first}"),
            (some, _) => format!(" at {some} places from {first} to {last}"),
        };
        format!("{NONE}{places}{}", reason.trim_start_matches(NONE))
    }
}

/// A share in per cent, to three decimals.
fn percent(share: f64) -> f64 {
    (1e5 * share).round() / 1e3
}

/// The separation or load to four digits.
fn short(at: At) -> At {
    let four = |x: f64| format!("{x:.3e}").parse().unwrap_or(x);
    match at {
        At::Separation(place) => Separation { value: four(place.value), ..place }.into(),
        At::Load(load) => At::Load(four(load)),
        At::Pressure(pressure) => At::Pressure(four(pressure)),
        other => other,
    }
}

/// The reason for no evidence, up to the numbers, which are each place's own.
fn reason(expected: &Result<ExpectedContact, ContactError>) -> Option<String> {
    let text = expected.as_ref().err()?.to_string();
    text.split(|c: char| c.is_ascii_digit()).next().map(str::to_string)
}

impl fmt::Display for Recommendation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (within, reference) = (percent(self.within), self.reference.name());
        match &self.simplest {
            Some(simplest) => {
                let simplest = simplest.name();
                writeln!(
                    f,
                    "{simplest} is the simplest valid model within {within} % of {reference}"
                )?;
            }
            None => writeln!(f, "no valid model is within {within} % of {reference}")?,
        }
        let lines = [self.summary(), self.expectations()].concat();
        lines.iter().try_for_each(|line| writeln!(f, "{line}"))?;
        let width =
            self.comparisons.iter().map(|c| c.model.name().len()).max().unwrap_or(0).max(12);
        for Comparison { model, deviations, outside, off, .. } in &self.comparisons {
            write!(f, "  {:width$}", model.name())?;
            match deviations {
                Ok(all) => {
                    for (quantity, deviation) in all {
                        write!(f, " {quantity} {} %", percent(*deviation))?;
                    }
                    if let Some((area, spread)) = off.and_then(|o| o.area.zip(o.area_spread)) {
                        let [area, spread] = [area, spread].map(|x| 100.0 * x);
                        write!(
                            f,
                            ", area {area:+.0} % relative to boundary elements (half interval {spread:.0} %)"
                        )?;
                    }
                    if let Some(outside) = outside {
                        write!(f, "; not valid: {} {}", outside.field, outside.value)?;
                    }
                    writeln!(f)?;
                }
                Err(error) => writeln!(f, " {error}")?,
            }
        }
        Ok(())
    }
}
