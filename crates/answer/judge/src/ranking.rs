//! The models nearest to boundary elements, a sentence for each quantity.

use crate::Compared;

/// Number of models listed.
const MOST_LISTED: usize = 3;

impl Compared {
    /// The quantities in which models are ranked.
    pub const RANKED: [Self; 3] = [Self::Area, Self::Stiffness, Self::UnloadingStiffness];
}

/// The models nearest to boundary elements in a quantity of this name, each with its largest
/// deviation, in one sentence; `None` if none has the quantity everywhere. Each model comes with
/// its deviations from boundary elements.
fn nearest<'m>(
    quantity: &str,
    models: impl Iterator<Item = (&'m str, Vec<Option<f64>>)>,
) -> Option<String> {
    let known = |(id, off): (&'m str, Vec<Option<f64>>)| {
        Some((off.into_iter().collect::<Option<Vec<f64>>>()?, id))
    };
    let mut ranked: Vec<(Vec<f64>, &str)> = models.filter_map(known).collect();
    ranked.sort_by(|a, b| largest(&a.0).total_cmp(&largest(&b.0)));
    let listed = ranked.iter().take(MOST_LISTED).map(|(off, id)| format!("{id} ({})", words(off)));
    let listed: Vec<String> = listed.collect();
    let verb = if listed.len() == 1 { "is" } else { "are" };
    let sentence =
        format!("nearest to boundary elements in {quantity} {verb} {}", listed.join(", "));
    (!listed.is_empty()).then_some(sentence)
}

/// The models nearest to boundary elements in each of these quantities, a sentence with the three
/// nearest for each, or one that no model is known everywhere in any. `off` returns the deviations
/// of a model in a quantity (0.1: 10 % high), one a load, `None` where one is missing.
///
/// ```
/// use asperity::{Compared, nearest_in_each};
///
/// let off = |id: &str, _| vec![match id {
///     "gw" => Some(-0.4),
///     "ke" => Some(-0.13),
///     _ => None,
/// }];
/// let found = nearest_in_each(["gw", "ke", "gao"], off, &[Compared::Area]);
/// assert_eq!(found, ["nearest to boundary elements in real area are ke (13 % low), gw (40 % low)"]);
/// ```
#[must_use]
pub fn nearest_in_each<'m>(
    models: impl IntoIterator<Item = &'m str>,
    off: impl Fn(&str, Compared) -> Vec<Option<f64>>,
    quantities: &[Compared],
) -> Vec<String> {
    let ids: Vec<&str> = models.into_iter().collect();
    let of = |quantity: &Compared| {
        nearest(quantity.label(), ids.iter().map(|id| (*id, off(id, *quantity))))
    };
    let found: Vec<String> = quantities.iter().filter_map(of).collect();
    match found.is_empty() {
        true => {
            let names: Vec<&str> = quantities.iter().map(|of| of.label()).collect();
            vec![format!(
                "no model can be compared with boundary elements in {} everywhere",
                names.join(" or ")
            )]
        }
        false => found,
    }
}

fn largest(off: &[f64]) -> f64 {
    off.iter().fold(0.0, |most: f64, off| most.max(off.abs()))
}

/// The deviations in words: `13 % low`, or `at most 13 % low` at several loads.
pub(crate) fn words(off: &[f64]) -> String {
    let percent = (100.0 * largest(off)).round();
    let at_most = if off.len() > 1 { "at most " } else { "" };
    let side = match off {
        low if low.iter().all(|off| *off < 0.0) => "low",
        high if high.iter().all(|off| *off > 0.0) => "high",
        _ => "off",
    };
    match percent < 1.0 {
        true => "less than 1 % off".into(),
        false => format!("{at_most}{percent:.0} % {side}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_are_named_with_their_largest_deviation() {
        let off = |id: &str, quantity: Compared| {
            let places = match id {
                "a" => vec![[Some(0.1), Some(-0.3)], [Some(-0.2), Some(0.1)]],
                "b" => vec![[Some(0.004), None], [Some(0.001), Some(0.1)]],
                "c" => vec![[None, Some(0.0)], [Some(0.1), Some(0.25)]],
                _ => vec![[Some(0.5), Some(-0.5)]; 2],
            };
            places.iter().map(|place| place[usize::from(quantity != Compared::Area)]).collect()
        };
        let said = [
            nearest_in_each(["d", "a", "b", "c"], off, &Compared::RANKED[..2]),
            nearest_in_each(["b"], off, &Compared::RANKED[..2]),
            // Only what is asked for.
            nearest_in_each(["b"], off, &Compared::RANKED[1..2]),
        ];
        insta::assert_snapshot!(said.concat().join("\n"));
    }
}
