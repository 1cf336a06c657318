//! The looks of models by their ids: one colour a model in every picture.

/// Ids with the numbers of their looks.
const LOOKS: [(&str, usize); 22] = [
    ("gw", 0),
    ("ceb", 1),
    ("zmc", 2),
    ("ke", 3),
    ("etsion", 4),
    ("jg", 5),
    ("af", 6),
    ("gao", 7),
    ("at", 8),
    ("jg-cosine", 9),
    ("ghaednia", 10),
    ("at-overlap", 11),
    ("persson", 12),
    ("persson-fudge", 13),
    ("persson-plastic", 14),
    ("cmy", 15),
    ("dmt", 16),
    ("jkr", 17),
    ("jkr-separation", 18),
    ("mikic", 19),
    ("at-additive", 34),
    ("best", 45),
];
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
    LOOKS.iter().find(|(known, _)| *known == id).map(|(_, look)| *look)
}
