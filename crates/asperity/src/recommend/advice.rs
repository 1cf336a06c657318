//! A recommendation as text.

use std::fmt;

use crate::{
    At, Comparison, ContactError, Described, EvidenceAt, Expectation, Nearest, Recommendation,
    Separation, evidence::NONE, ranking,
};

impl Recommendation {
    /// The evidence in lines, one for each solved case: which of these models were nearest to
    /// boundary elements in area and in stiffness; and the separations or loads without evidence.
    #[must_use]
    pub fn summary(&self) -> Vec<String> {
        let mut groups: Vec<Vec<&EvidenceAt>> = vec![];
        for place in &self.evidence {
            match groups.iter_mut().find(|group| alike(&group[0].nearest, &place.nearest)) {
                Some(group) => group.push(place),
                None => groups.push(vec![place]),
            }
        }
        let mut lines: Vec<String> = groups.iter().map(|group| self.group_summary(group)).collect();
        let near: Vec<_> =
            self.evidence.iter().filter_map(|place| place.nearest.as_ref().ok()).collect();
        if groups.iter().filter(|group| group[0].nearest.is_ok()).count() > 1 {
            lines.push(format!("over these {} places, {}", near.len(), self.nearest(&near)));
        }
        lines
    }

    /// How far the reference and the recommended model are expected to be from boundary elements, a
    /// line for each quantity: `KE underestimates the area by 5 to 12 % here (boundary elements on
    /// 16 surfaces)`. Of several places the widest interval.
    #[must_use]
    pub fn expectations(&self) -> Vec<String> {
        let mut all: Vec<(Expectation, usize)> = vec![];
        for found in self.evidence.iter().flat_map(|place| &place.expected) {
            let same = |(known, _): &&mut (Expectation, usize)| {
                known.model == found.model && known.quantity == found.quantity
            };
            match all.iter_mut().find(same) {
                Some((known, places)) => {
                    let (known, new) = (&mut known.expected, found.expected);
                    known.low = known.low.min(new.low);
                    known.high = known.high.max(new.high);
                    known.surfaces = known.surfaces.min(new.surfaces);
                    known.extrapolated |= new.extrapolated;
                    *places += 1;
                }
                None => all.push((found.clone(), 1)),
            }
        }
        let line =
            |(Expectation { model, quantity, expected, .. }, places): &(Expectation, usize)| {
                let name = self.comparisons.iter().find(|c| c.model.id() == model);
                let name = name.map_or(model.as_str(), |c| c.model.name());
                let here = match *places {
                    1 => "here".into(),
                    some => format!("at {some} places"),
                };
                let lighter = match expected.extrapolated {
                    true => ", extrapolated to lighter loads",
                    false => "",
                };
                let (words, surfaces) = (expected.words(*quantity), expected.surfaces);
                format!("{name} {words} {here} (boundary elements on {surfaces} surfaces{lighter})")
            };
        all.iter().map(line).collect()
    }

    /// The models nearest to boundary elements in all of these cases.
    fn nearest(&self, near: &[&Nearest<'_>]) -> String {
        let off = |id: &str| {
            let of = |near: &&Nearest<'_>| {
                near.deviation(id).map_or([None; 2], |off| [off.area, off.stiffness])
            };
            near.iter().map(of).collect()
        };
        ranking::nearest(self.comparisons.iter().map(|c| c.model.id()), off)
    }

    /// The line for rows that are nearest to the same case, or have none for the same reason.
    fn group_summary(&self, group: &[&EvidenceAt]) -> String {
        let [first, last] = [0, group.len() - 1].map(|k| short(group[k].at));
        let places = match (group.len(), self.evidence.len()) {
            (some, all) if some == all => String::new(),
            (1, _) => format!(" at {first}"),
            (some, _) => format!(" at {some} places from {first} to {last}"),
        };
        let away = |place: &&&EvidenceAt| place.nearest.as_ref().map_or(0.0, |near| near.away);
        let far = group.iter().max_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(&group[0]);
        match &far.nearest {
            Err(reason) if places.is_empty() => reason.to_string(),
            Err(reason) => {
                let reason = reason.to_string();
                format!("{NONE}{places}{}", reason.trim_start_matches(NONE))
            }
            Ok(far) => {
                let nearest = self.nearest(&[far]);
                format!("boundary elements on surfaces like this one{places}, {far}: {nearest}")
            }
        }
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

/// True if two rows have the same case, or none for the same reason.
fn alike(
    one: &Result<Nearest<'_>, ContactError>,
    other: &Result<Nearest<'_>, ContactError>,
) -> bool {
    let reason = |error: &ContactError| {
        let text = error.to_string();
        // Up to the numbers, which are each place's own.
        text.split(|c: char| c.is_ascii_digit()).next().map(str::to_string)
    };
    match (one, other) {
        (Ok(one), Ok(other)) => one.case == other.case,
        (Err(one), Err(other)) => reason(one) == reason(other),
        _ => false,
    }
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
                        write!(f, ", area off boundary elements {area:+.0} +- {spread:.0} %")?;
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
