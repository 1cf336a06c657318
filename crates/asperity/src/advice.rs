//! A recommendation in words.

use std::fmt;

use crate::{
    At, Comparison, ContactError, Described, EvidenceAt, Nearest, Recommendation, Separation,
    ranking,
};

impl Recommendation {
    /// What the evidence says, a sentence for each case that places are near to: where it is from, and
    /// which of these models were nearest to boundary elements there, in area and in stiffness; and
    /// where there is none.
    #[must_use]
    pub fn told(&self) -> Vec<String> {
        let mut groups: Vec<Vec<&EvidenceAt>> = vec![];
        for place in &self.evidence {
            match groups.iter_mut().find(|group| alike(&group[0].nearest, &place.nearest)) {
                Some(group) => group.push(place),
                None => groups.push(vec![place]),
            }
        }
        let mut told: Vec<String> = groups.iter().map(|group| self.told_of(group)).collect();
        let near: Vec<_> =
            self.evidence.iter().filter_map(|place| place.nearest.as_ref().ok()).collect();
        if groups.iter().filter(|group| group[0].nearest.is_ok()).count() > 1 {
            told.push(format!("over these {} places, {}", near.len(), self.nearest(&near)));
        }
        told
    }

    /// Which of the models were nearest to boundary elements in all of these cases.
    fn nearest(&self, near: &[&Nearest<'_>]) -> String {
        let off = |id: &str| {
            let of = |near: &&Nearest<'_>| {
                near.deviation(id).map_or([None; 2], |off| [off.area, off.stiffness])
            };
            near.iter().map(of).collect()
        };
        ranking::nearest(self.comparisons.iter().map(|c| c.model.id()), off)
    }

    /// Of places that are near to the same case, or have none for the same reason.
    fn told_of(&self, group: &[&EvidenceAt]) -> String {
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
                format!("no evidence{places}{}", reason.trim_start_matches("no evidence here"))
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

/// The place to four digits, for a sentence.
fn short(at: At) -> At {
    let four = |x: f64| format!("{x:.3e}").parse().unwrap_or(x);
    match at {
        At::Separation(place) => Separation { value: four(place.value), ..place }.into(),
        At::Load(load) => At::Load(four(load)),
        At::Pressure(pressure) => At::Pressure(four(pressure)),
        other => other,
    }
}

/// Whether two places have the same case, or none for the same reason.
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
                writeln!(f, "{simplest} is the simplest model within {within} % of {reference}")?;
            }
            None => writeln!(f, "no model that holds is within {within} % of {reference}")?,
        }
        self.told().iter().try_for_each(|told| writeln!(f, "{told}"))?;
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
                        write!(f, "; does not hold: {} {}", outside.field, outside.value)?;
                    }
                    writeln!(f)?;
                }
                Err(error) => writeln!(f, " {error}")?,
            }
        }
        Ok(())
    }
}
