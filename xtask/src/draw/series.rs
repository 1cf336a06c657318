//! The points of each curve of a panel, taken from the table and split at gaps.

use std::collections::BTreeSet;

use anyhow::{Result, bail};

use super::figure::{Figure, Panel, Scale};
use super::style::CurveStyle;
use super::table::Table;

/// A pair of numbers: in the units of the CSV or in pixels.
pub(crate) type Point = (f64, f64);

/// One curve: its pieces between gaps, in the units of the CSV.
pub(crate) struct Series<'a> {
    pub(crate) style: &'a CurveStyle,
    pub(crate) pieces: Vec<Vec<Point>>,
    /// For stacked curves the lower edge of the area, point by point.
    pub(crate) base: Option<Vec<Point>>,
}

/// Takes the curves of a panel from the table.
pub(crate) fn of_panel<'a>(panel: &'a Panel, table: &Table) -> Result<Vec<Series<'a>>> {
    let x = table.column(&panel.x.column)?;
    let y = table.column(&panel.y.column)?;
    let key = table.column(&panel.curve_column)?;
    let only = match &panel.only {
        Some((column, value)) => Some((table.column(column)?, value.as_str())),
        None => None,
    };
    let mut all = Vec::new();
    for style in &panel.curves {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        let mut piece = Vec::new();
        let mut found = false;
        let mut within = false;
        for row in table.rows() {
            if row.is_gap() {
                if within {
                    pieces.push(std::mem::take(&mut piece));
                }
                continue;
            }
            within = row.text(key) == style.key
                && only.is_none_or(|(column, value)| row.text(column) == value);
            if !within {
                continue;
            }
            found = true;
            match (row.number(x)?, row.number(y)?) {
                (Some(across), Some(up)) => piece.push((across, up)),
                _ => pieces.push(std::mem::take(&mut piece)),
            }
        }
        if !found {
            bail!("curve `{}` is not in column `{}` of the CSV", style.key, panel.curve_column);
        }
        pieces.push(piece);
        pieces.retain(|piece| !piece.is_empty());
        all.push(Series { style, pieces, base: None });
    }
    if panel.stacked {
        stack(panel, &mut all)?;
    }
    Ok(all)
}

/// Adds every curve to those before it; all must have the same x and no gaps.
fn stack(panel: &Panel, all: &mut [Series]) -> Result<()> {
    if panel.y.scale == Scale::Log {
        bail!("stacked curves need a linear vertical axis");
    }
    let mut below: Option<Vec<Point>> = None;
    for series in all {
        let [piece] = series.pieces.as_mut_slice() else {
            bail!("stacked curve `{}` has a gap or no points", series.style.key);
        };
        let base = below.unwrap_or_else(|| piece.iter().map(|point| (point.0, 0.0)).collect());
        let same = base.len() == piece.len()
            && base.iter().zip(piece.iter()).all(|(low, up)| low.0.total_cmp(&up.0).is_eq());
        if !same {
            bail!("stacked curve `{}` has other x values than the first", series.style.key);
        }
        for (point, low) in piece.iter_mut().zip(&base) {
            point.1 += low.1;
        }
        below = Some(piece.clone());
        series.base = Some(base);
    }
    Ok(())
}

/// Refuses a CSV with a curve that no panel draws, so that none is lost unseen.
pub(crate) fn check_all_drawn(figure: &Figure, table: &Table) -> Result<()> {
    if figure.allow_undrawn {
        return Ok(());
    }
    let mut columns = BTreeSet::new();
    for panel in &figure.panels {
        columns.insert(panel.curve_column.as_str());
    }
    for name in columns {
        let column = table.column(name)?;
        for row in table.rows().iter().filter(|row| !row.is_gap()) {
            let key = row.text(column);
            let drawn = figure
                .panels
                .iter()
                .filter(|panel| panel.curve_column == name)
                .any(|panel| panel.curves.iter().any(|style| style.key == key));
            if !drawn {
                bail!("curve `{key}` of column `{name}` is drawn by no panel");
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::figure::Axis;
    use super::*;

    fn panel(keys: &[&str]) -> Panel {
        let mut panel = Panel::new(Axis::new("x", "x"), Axis::new("y", "y"));
        panel.curves =
            keys.iter().enumerate().map(|(i, key)| CurveStyle::numbered(i, key, key)).collect();
        panel
    }

    #[test]
    fn empty_values_and_empty_lines_split_a_curve() -> anyhow::Result<()> {
        let table =
            Table::read("curve,x,y\na,0,1\na,1,\na,2,3\n\na,3,4\nb,0,1\n\nb,1,NaN\nb,2,2\n");
        let panel = panel(&["a", "b"]);
        let all = of_panel(&panel, &table?)?;
        assert_eq!(all[0].pieces.len(), 3);
        assert_eq!(all[1].pieces, [vec![(0.0, 1.0)], vec![(2.0, 2.0)]]);
        Ok(())
    }

    #[test]
    fn stacked_curves_add_up() -> anyhow::Result<()> {
        let table = Table::read("curve,x,y\na,0,1\na,1,2\nb,0,3\nb,1,4\n")?;
        let mut panel = panel(&["a", "b"]);
        panel.stacked = true;
        let all = of_panel(&panel, &table)?;
        assert_eq!(all[1].pieces, [vec![(0.0, 4.0), (1.0, 6.0)]]);
        Ok(())
    }
}
