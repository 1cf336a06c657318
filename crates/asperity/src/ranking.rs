//! The models nearest to boundary elements, as a sentence.

/// Number of models named.
const NAMED: usize = 3;

/// The models nearest in area and in stiffness, each with its largest deviation. `off` returns the
/// deviations of a model in area and stiffness at each load; models with a missing deviation are
/// not named.
pub(crate) fn nearest<'m>(
    models: impl IntoIterator<Item = &'m str>,
    off: impl Fn(&str) -> Vec<[Option<f64>; 2]>,
) -> String {
    let all: Vec<(&str, Vec<[Option<f64>; 2]>)> =
        models.into_iter().map(|id| (id, off(id))).collect();
    let of = |k: usize| -> Option<String> {
        let largest = |places: &[[Option<f64>; 2]]| {
            places.iter().try_fold(0.0, |most: f64, place| Some(most.max(place[k]?.abs())))
        };
        let mut ranked: Vec<(f64, &str)> =
            all.iter().filter_map(|(id, places)| Some((largest(places)?, *id))).collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        let named = ranked.iter().take(NAMED).map(|(off, id)| match (100.0 * off).round() {
            percent if percent < 1.0 => format!("{id} (less than 1 % off)"),
            percent => format!("{id} (at most {percent:.0} % off)"),
        });
        let named: Vec<String> = named.collect();
        (!named.is_empty()).then(|| named.join(", "))
    };
    match [of(0), of(1)] {
        [Some(area), Some(stiffness)] => {
            format!("nearest in area were {area}; in stiffness {stiffness}")
        }
        [Some(area), None] => format!("nearest in area were {area}"),
        [None, Some(stiffness)] => format!("nearest in stiffness were {stiffness}"),
        [None, None] => "no model has an area or a stiffness at every load".into(),
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
            _ => vec![[Some(0.5), Some(0.5)]; 2],
        };
        let found = nearest(["d", "a", "b", "c"], off);
        let area = "b (less than 1 % off), a (at most 20 % off), d (at most 50 % off)";
        let stiffness = "c (at most 25 % off), a (at most 30 % off), d (at most 50 % off)";
        assert_eq!(found, format!("nearest in area were {area}; in stiffness {stiffness}"));
        assert!(nearest(["b"], off).ends_with("were b (less than 1 % off)"));
        assert!(nearest([], off).starts_with("no model has"));
    }
}
