//! The figures: models over boundary elements against the load, a panel for each case.

use anyhow::Result;
use asperity::{Compared, Evidence, EvidenceCase};
use asperity_plot::{Axis, Between, Curve, Figure, Mark, Panel};

use super::compared::{is_plain, material};
use super::models::{self, beside, of, panel};
use crate::table::Table;

/// A figure: the name of its files, what it compares, its axis, and the ends of that.
pub type Shown = (&'static str, Compared, &'static str, [f64; 2]);

/// The figures.
pub const SHOWN: [Shown; 3] = [
    ("truth-area", Compared::Area, "area/BEM", [0.4, 1.6]),
    ("truth-stiffness", Compared::Stiffness, "stiffness/BEM", [0.0, 1.6]),
    ("truth-unloading", Compared::UnloadingStiffness, "unloading stiffness/BEM", [0.0, 2.0]),
];

/// Plasticity indices with panels.
const SHOWN_INDICES: [f64; 3] = [0.0, 2.0, 4.0];
/// The models drawn in colour; the others are grey.
const DRAWN: &str = "gw zmc ke jg gao gw-random jg-random persson persson-fudge persson-plastic";
/// Models that have a colour in elastic panels alone: at most six curves of a panel have one.
const ELASTIC_ONLY: [&str; 4] = ["gw", "gw-random", "persson", "persson-fudge"];
/// Edges of the band.
const BAND: [&str; 2] = ["error-low", "error-high"];

/// The numbers of a figure.
///
/// # Errors
/// A number that is not finite.
pub fn table(evidence: &Evidence, (_, quantity, ..): &Shown) -> Result<Table> {
    let mut table = Table::new(&["case", "curve", "p_over_Eg", "model_over_bem"]);
    let in_panel =
        |case: &&EvidenceCase| is_plain(case) && SHOWN_INDICES.contains(&case.plasticity_index);
    let mut cases: Vec<&EvidenceCase> = evidence.cases().iter().filter(in_panel).collect();
    cases.sort_by(|a, b| {
        let index = a.plasticity_index.total_cmp(&b.plasticity_index);
        a.alpha.total_cmp(&b.alpha).then(index).then(a.load.total_cmp(&b.load))
    });
    for found in cases {
        let case = format!("α = {:.1}; {}", found.alpha, material(found.plasticity_index));
        let Some(truth) = found.bem.value(*quantity) else { continue };
        let error = found.bem.error(*quantity).unwrap_or(0.0) / truth;
        table.push(&[&case, BAND[0]], [found.load, 1.0 - error])?;
        table.push(&[&case, BAND[1]], [found.load, 1.0 + error])?;
        for (id, row) in &found.models {
            if let Some(value) = row.value(*quantity) {
                table.push(&[&case, id], [found.load, value / truth])?;
            }
        }
    }
    Ok(table)
}

/// The picture.
///
/// # Errors
/// The csv of another figure.
pub fn style(csv: &str, (_, _, label, [low, high]): &Shown) -> Result<Figure> {
    let fields = |line| -> Vec<&str> { str::split(line, ',').collect() };
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(fields).collect();
    let picture = |rows: &[Vec<&str>]| -> Result<Panel> {
        let mut ids: Vec<&str> = vec![];
        for row in rows.iter().filter(|row| !BAND.contains(&row[1])) {
            if !ids.contains(&row[1]) {
                ids.push(row[1]);
            }
        }
        let case = rows[0][0];
        let coloured = |id: &str| case.ends_with("elastic") || !ELASTIC_ONLY.contains(&id);
        let drawn = DRAWN.split(' ').filter(|id| ids.contains(id) && coloured(id));
        let mut curves = models::curves(&drawn.collect::<Vec<_>>())?;
        ids.retain(|id| !curves.iter().any(|curve| curve.key == *id));
        curves.extend(ids.into_iter().map(|id| Curve::faint(id, "other models")));
        let x = Axis::new("p_over_Eg", "p/(E g)").log().range(1e-5, 0.3);
        let y = Axis::new("model_over_bem", label).range(*low, *high);
        let mut panel = of("case", case, case, panel(&x, y, &curves));
        let [lower, upper] = BAND.map(Into::into);
        panel.between = vec![Between { lower, upper, look: 9, label: String::new() }];
        panel.horizontals = vec![Mark::new(1.0, "")];
        Ok(panel)
    };
    let panels = rows.chunk_by(|a, b| a[0] == b[0]).map(picture);
    Ok(beside(3, panels.collect::<Result<Vec<_>>>()?))
}
