//! The looks of models by their ids: one colour a model in every picture.

/// Ids in the order of their looks.
const LOOKS: &str = "gw ceb zmc ke etsion jg af gao at jg-cosine ghaednia at-overlap persson \
    persson-fudge persson-plastic cmy dmt jkr jkr-separation mikic";
/// Ids with looks of their own behind those.
const OTHERS: [(&str, usize); 2] = [("at-additive", 34), ("best", 45)];
/// Endings of ids, and what they add: the colour stays, dash and marker change. None is a black
/// cross.
const ENDINGS: [(&str, usize); 2] = [("-random", 20), ("-pairs", 50)];

/// The look of measured points and of boundary elements, which no model has: black crosses.
pub const MEASURED: usize = 100;

/// The look of a model of this project; `None` for another name.
///
/// ```
/// use asperity_plot::look_of;
///
/// assert_eq!((look_of("gw"), look_of("ke-random"), look_of("mine")), (Some(0), Some(23), None));
/// ```
#[must_use]
pub fn look_of(id: &str) -> Option<usize> {
    let ending = ENDINGS.iter().find_map(|(end, more)| Some((id.strip_suffix(end)?, *more)));
    if let Some((stem, more)) = ending {
        return look_of(stem).map(|look| look + more);
    }
    let looks = LOOKS.split(' ').zip(0..).chain(OTHERS);
    looks.into_iter().find(|(known, _)| *known == id).map(|(_, look)| look)
}
