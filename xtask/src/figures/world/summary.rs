//! `figures/world.md`: what each model was held against, and how far off it was.

use std::collections::BTreeMap;

use anyhow::Result;
use asperity::{Compared, Described, Evidence};

use super::{gfmd, sphere};
use crate::figures::compared::{NOTHING, is_plain, models};
use crate::table::{markdown_head, markdown_row, rows as drawn};

const PREFACE: &str = "\
# What each model was held against

Root mean square deviations in per cent of what a column names: force and area of one sphere from
finite elements, by interference over w_c; areas of an elastic surface (p/(E g) from 4e-4 to 1.8)
and its mean gaps (up to 0.1) from Green's function molecular dynamics; areas of yielding isotropic
Gaussian surfaces from the boundary elements of this project, which `bem` is here. Sources and
figures are named in the [chapter](../crates/apps/web/guide/world.md).

";
/// Mean gaps are compared up to this p/(E g), where a fifth of the surface touches.
const HEAVIEST: f64 = 0.1;
/// Ranges of interference of the force, then of the area.
const FORCE: [[f64; 2]; 4] = [[0.1, 1.0], [1.0, 6.0], [6.0, 50.0], [50.0, 170.0]];
const AREA: [[f64; 2]; 2] = [[1.0, 50.0], [50.0, 170.0]];

/// A row of a figure's csv: panel, curve, and two numbers.
type Row = (String, String, f64, f64);

/// The root mean square deviation of the ratios of a model, in per cent.
fn off<'r>(ratios: impl Iterator<Item = &'r f64>) -> String {
    let (count, sum) =
        ratios.fold((0, 0.0), |(n, sum), ratio| (n + 1, sum + (ratio - 1.0).powi(2)));
    match count {
        0 => NOTHING.into(),
        count => format!("{:.0}", 100.0 * (sum / f64::from(count)).sqrt()),
    }
}

/// Ratios of the areas of a model to boundary elements, where isotropic Gaussian surfaces yield.
fn yielding(evidence: &Evidence) -> BTreeMap<&str, Vec<f64>> {
    let cases = evidence.cases().iter();
    let mut all: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for case in cases.filter(|case| is_plain(case) && case.plasticity_index > 0.0) {
        for (id, found) in &case.models {
            let both = found.value(Compared::Area).zip(case.bem.value(Compared::Area));
            all.entry(id).or_default().extend(both.map(|(own, bem)| own / bem));
        }
    }
    all
}

/// The table, from the csv of each figure by its name.
///
/// # Errors
/// A csv that is missing, or is another.
pub fn table<'t>(csv: impl Fn(&str) -> Result<&'t str>, evidence: &Evidence) -> Result<String> {
    let (sphere, elastic) = (drawn(csv("world-sphere")?)?, drawn(csv("world-elastic")?)?);
    let yielding = yielding(evidence);
    let range = |what: &str, [from, to]: &[f64; 2]| format!("{what}, {from} to {to}");
    let mut heads = vec!["model".to_owned()];
    heads.extend(FORCE.iter().map(|ends| range("force", ends)));
    heads.extend(AREA.iter().map(|ends| range("area", ends)));
    heads.extend(["elastic area", "elastic mean gap", "area, yielding"].map(String::from));
    let mut out = PREFACE.to_owned() + &markdown_head(&heads, heads.len() - 1);
    let mut ids: Vec<String> = models().iter().map(|model| model.id().to_owned()).collect();
    ids.extend(["ghaednia", "bem"].map(String::from));
    for id in ids {
        let of = |rows: &[Row], panel: &str, [from, to]: [f64; 2]| {
            let own = |row: &&Row| row.0 == panel && row.1 == id && row.2 >= from && row.2 <= to;
            off(rows.iter().filter(own).map(|row| &row.3))
        };
        let mut row = vec![format!("`{id}`")];
        row.extend(FORCE.map(|ends| of(&sphere, sphere::PANELS[0], ends)));
        row.extend(AREA.map(|ends| of(&sphere, sphere::PANELS[1], ends)));
        row.push(of(&elastic, gfmd::PANELS[0], [0.0, f64::INFINITY]));
        row.push(of(&elastic, gfmd::PANELS[1], [0.0, HEAVIEST]));
        row.push(off(yielding.get(id.as_str()).into_iter().flatten()));
        out += &markdown_row(&row);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviations_are_taken_within_each_range() -> Result<()> {
        let csv = |name: &str| {
            Ok(match name {
                "world-sphere" => {
                    "panel,curve,x,value\nforce,ke,0.5,1.1\nforce,ke,3,0.8\nforce,ke,4,1.1\n"
                }
                _ => "panel,curve,x,value\ngap,gw,0.01,1.5\ngap,gw,0.5,9\n",
            })
        };
        let found = table(csv, &Evidence::with_models()?)?;
        let line = |start: &str| found.lines().find(|line| line.starts_with(start));
        // Of 0.8 and 1.1, √(0.05/2).
        assert!(line("| `ke` | 10 | 16 | – |").is_some(), "{found}");
        assert!(line("| `gw` |").is_some_and(|gw| gw.contains("| – | 50 |")), "{found}");
        Ok(())
    }
}
