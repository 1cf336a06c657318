//! The models nearest to boundary elements, as a sentence.

/// Number of models listed.
const MOST_LISTED: usize = 3;

/// The models nearest in area and in stiffness, each with its largest deviation. `off` returns the
/// deviations of a model in area and stiffness at each load; models with a missing deviation are
/// not listed.
pub(crate) fn nearest<'m>(
    models: impl IntoIterator<Item = &'m str>,
    off: impl Fn(&str) -> Vec<[Option<f64>; 2]>,
) -> String {
    let all: Vec<(&str, Vec<[Option<f64>; 2]>)> =
        models.into_iter().map(|id| (id, off(id))).collect();
    let of = |k: usize| -> Option<String> {
        let known = |places: &[[Option<f64>; 2]]| -> Option<Vec<f64>> {
            places.iter().map(|place| place[k]).collect()
        };
        let mut ranked: Vec<(Vec<f64>, &str)> =
            all.iter().filter_map(|(id, places)| Some((known(places)?, *id))).collect();
        ranked.sort_by(|a, b| largest(&a.0).total_cmp(&largest(&b.0)));
        let listed =
            ranked.iter().take(MOST_LISTED).map(|(off, id)| format!("{id} ({})", words(off)));
        let listed: Vec<String> = listed.collect();
        (!listed.is_empty()).then(|| listed.join(", "))
    };
    match [of(0), of(1)] {
        [Some(area), Some(stiffness)] => {
            format!("nearest to boundary elements in area are {area}; in stiffness {stiffness}")
        }
        [Some(area), None] => format!("nearest to boundary elements in area are {area}"),
        [None, Some(stiffness)] => {
            format!("nearest to boundary elements in stiffness are {stiffness}")
        }
        [None, None] => "no model has an area or a stiffness at every load".into(),
    }
}

fn largest(off: &[f64]) -> f64 {
    off.iter().fold(0.0, |most: f64, off| most.max(off.abs()))
}

/// The deviations in words: `13 % low`, or `at most 13 % low` at several loads.
fn words(off: &[f64]) -> String {
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
        let off = |id: &str| match id {
            "a" => vec![[Some(0.1), Some(-0.3)], [Some(-0.2), Some(0.1)]],
            "b" => vec![[Some(0.004), None], [Some(0.001), Some(0.1)]],
            "c" => vec![[None, Some(0.0)], [Some(0.1), Some(0.25)]],
            _ => vec![[Some(0.5), Some(-0.5)]; 2],
        };
        let found = nearest(["d", "a", "b", "c"], off);
        let area = "b (less than 1 % off), a (at most 20 % off), d (at most 50 % high)";
        let stiffness = "c (at most 25 % off), a (at most 30 % off), d (at most 50 % low)";
        assert_eq!(
            found,
            format!("nearest to boundary elements in area are {area}; in stiffness {stiffness}")
        );
        assert!(nearest(["b"], off).ends_with("are b (less than 1 % off)"));
        assert!(nearest([], off).starts_with("no model has"));
        let one = nearest(["x"], |_| vec![[Some(-0.13), None]]);
        assert!(one.ends_with("in area are x (13 % low)"), "{one}");
    }
}
