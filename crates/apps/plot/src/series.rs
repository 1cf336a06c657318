//! The curves of a panel, taken from the text of the csv and split at gaps.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::error::PlotError;
use crate::figure::{Panel, Scale};
use crate::style::{Colour, Curve};

/// A pair of numbers: in the units of the csv, in fractions of a frame, or in pixels.
pub(crate) type Point = (f64, f64);

/// The csv: a head, then rows of as many cells.
pub(crate) struct CsvTable {
    head: StringRecord,
    rows: Vec<StringRecord>,
    /// The curves that panels have taken, by the column that names them.
    drawn: RefCell<BTreeMap<usize, BTreeSet<String>>>,
}

impl CsvTable {
    pub(crate) fn read(csv: &str) -> Result<Self, PlotError> {
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(csv.as_bytes());
        Ok(Self {
            head: reader.headers()?.clone(),
            rows: reader.records().collect::<Result<_, _>>()?,
            drawn: RefCell::default(),
        })
    }

    /// Refuses a table with a curve that no panel has taken.
    pub(crate) fn check_all_drawn(&self) -> Result<(), PlotError> {
        for (&place, keys) in self.drawn.borrow().iter() {
            if let Some(row) = self.rows.iter().find(|row| !keys.contains(&row[place])) {
                let (curve, column) = (row[place].into(), self.head[place].into());
                return Err(PlotError::Undrawn { curve, column });
            }
        }
        Ok(())
    }

    /// The columns of the lower and the upper end of another: `area_lower_m2` of `area_m2`.
    fn ends(&self, name: &str) -> Option<[usize; 2]> {
        let is_end = |head: &str, end| head != name && head.replacen(end, "", 1) == name;
        let column = |end| self.head.iter().position(|head| is_end(head, end));
        Some([column("_lower")?, column("_upper")?])
    }

    fn column(&self, name: &str) -> Result<usize, PlotError> {
        self.head.iter().position(|head| head == name).ok_or_else(|| PlotError::MissingColumn {
            column: name.into(),
            has: self.head.iter().collect::<Vec<_>>().join(", "),
        })
    }

    /// The number in a cell; `None` when the cell is empty or holds no finite number.
    fn number(&self, row: &StringRecord, column: usize) -> Result<Option<f64>, PlotError> {
        let text = &row[column];
        if text.is_empty() {
            return Ok(None);
        }
        let value: f64 = text.parse().map_err(|_| PlotError::NotANumber {
            line: row.position().map_or(0, csv::Position::line),
            column: self.head[column].into(),
            text: text.into(),
        })?;
        Ok(value.is_finite().then_some(value))
    }
}

/// One curve: its pieces between gaps, in the units of the csv.
pub(crate) struct Series<'a> {
    pub(crate) curve: &'a Curve,
    pub(crate) pieces: Vec<Vec<Point>>,
    /// The lower and the upper ends of its values, if the table has columns for them: its band.
    pub(crate) band: Vec<[Vec<Point>; 2]>,
}

/// The area between two curves with the same x.
pub(crate) struct Area<'a> {
    pub(crate) lower: Vec<Point>,
    pub(crate) upper: Vec<Point>,
    pub(crate) colour: Colour,
    /// Written inside; may be empty.
    pub(crate) label: &'a str,
}

/// Takes the curves of a panel from the table.
pub(crate) fn curves<'a>(panel: &'a Panel, table: &CsvTable) -> Result<Vec<Series<'a>>, PlotError> {
    let (x, y) = (table.column(&panel.x.column)?, table.column(&panel.y.column)?);
    let take = |curve: &'a Curve| {
        let of = |column| pieces(panel, table, &curve.key, [x, column]);
        let (own, mut band) = (of(y)?, vec![]);
        if let Some([lower, upper]) = table.ends(&panel.y.column) {
            let both = of(lower)?.into_iter().zip(of(upper)?);
            band.extend(both.filter(|(a, b)| a.len() > 1 && same_x(a, b)).map(<[_; 2]>::from));
        }
        Ok(Series { curve, pieces: own, band })
    };
    panel.curves.iter().map(take).collect()
}

/// The numbers of a curve in two columns, split at rows that lack one.
fn pieces(
    panel: &Panel,
    table: &CsvTable,
    key: &str,
    [x, y]: [usize; 2],
) -> Result<Vec<Vec<Point>>, PlotError> {
    let keys = table.column(&panel.curve_column)?;
    table.drawn.borrow_mut().entry(keys).or_default().insert(key.into());
    let only = panel.only.as_ref();
    let only = only.map(|(column, value)| table.column(column).map(|place| (place, value)));
    let only = only.transpose()?;
    let wanted = |row: &&StringRecord| {
        &row[keys] == key && only.is_none_or(|(column, value)| row[column] == **value)
    };
    let mut rows = table.rows.iter().filter(wanted).peekable();
    if rows.peek().is_none() {
        let (curve, column) = (key.into(), panel.curve_column.clone());
        return Err(PlotError::MissingCurve { curve, column });
    }
    let (mut pieces, mut piece) = (vec![], vec![]);
    for row in rows {
        match (table.number(row, x)?, table.number(row, y)?) {
            (Some(x), Some(y)) => piece.push((x, y)),
            _ => pieces.push(std::mem::take(&mut piece)),
        }
    }
    pieces.push(piece);
    pieces.retain(|piece| !piece.is_empty());
    Ok(pieces)
}

/// The areas of a panel. Stacked curves are lifted, each by those before it.
pub(crate) fn areas<'a>(
    panel: &'a Panel,
    table: &CsvTable,
    all: &mut [Series<'a>],
) -> Result<Vec<Area<'a>>, PlotError> {
    let whole = |mut pieces: Vec<Vec<Point>>, curve: &str, x: Option<&[Point]>| {
        let same = |piece: &Vec<Point>| x.is_none_or(|x| same_x(piece, x));
        let piece = pieces.pop().filter(|piece| pieces.is_empty() && same(piece));
        piece.ok_or_else(|| PlotError::Area { curve: curve.into() })
    };
    let mut areas = vec![];
    for between in &panel.between {
        let (x, y) = (table.column(&panel.x.column)?, table.column(&panel.y.column)?);
        let of = |key| pieces(panel, table, key, [x, y]);
        let lower = whole(of(&between.lower)?, &between.lower, None)?;
        let upper = whole(of(&between.upper)?, &between.upper, Some(&lower))?;
        let colour = Curve::new(between.look, "", "").colour();
        areas.push(Area { lower, upper, colour, label: "" });
    }
    let mut below: Option<Vec<Point>> = None;
    for Series { curve, pieces, .. } in all.iter_mut().filter(|_| panel.stacked) {
        if panel.y.scale == Scale::Log {
            return Err(PlotError::Stacked { curve: curve.key.clone() });
        }
        let mut upper = whole(std::mem::take(pieces), &curve.key, below.as_deref())?;
        let lower = below.unwrap_or_else(|| upper.iter().map(|point| (point.0, 0.0)).collect());
        upper.iter_mut().zip(&lower).for_each(|(up, low)| up.1 += low.1);
        *pieces = vec![upper.clone()];
        below = Some(upper.clone());
        areas.push(Area { lower, upper, colour: curve.colour(), label: &curve.label });
    }
    Ok(areas)
}

fn same_x(a: &[Point], b: &[Point]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0.total_cmp(&b.0).is_eq())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Between};

    fn panel(keys: &[&str]) -> Panel {
        let mut panel = Panel::new(Axis::new("x", "x"), Axis::new("y", "y"));
        panel.curves = keys.iter().enumerate().map(|(i, key)| Curve::new(i, key, key)).collect();
        panel
    }

    #[test]
    fn empty_and_infinite_cells_split_a_curve_and_quotes_are_read() {
        let csv = "curve,x,y\n\"a, b\",0,1\n\"a, b\",1,\n\"a, b\",2,3\nc,0,1\nc,1,NaN\nc,2,2\n";
        let table = CsvTable::read(csv).unwrap();
        let panel = panel(&["a, b", "c"]);
        let all = curves(&panel, &table).unwrap();
        assert_eq!(all[0].pieces, [vec![(0.0, 1.0)], vec![(2.0, 3.0)]]);
        assert_eq!(all[1].pieces, [vec![(0.0, 1.0)], vec![(2.0, 2.0)]]);
    }

    #[test]
    fn a_text_in_a_column_of_numbers_is_refused_with_its_line() {
        let table = CsvTable::read("curve,x,y\na,abc,1\n").unwrap();
        let panel = panel(&["a"]);
        let refused = curves(&panel, &table).err().map(|error| error.to_string()).unwrap();
        assert!(refused.starts_with("line 2 of the csv: `abc`"), "{refused}");
        assert!(CsvTable::read("curve,x\na,1,2\n").is_err());
    }

    #[test]
    fn stacked_curves_add_up_and_areas_lie_between_curves_with_the_same_x() {
        let table = CsvTable::read("curve,x,y\na,0,1\na,1,2\nb,0,3\nb,1,4\nc,0,1\n").unwrap();
        let mut panel = panel(&["a", "b"]);
        panel.stacked = true;
        let mut all = curves(&panel, &table).unwrap();
        assert_eq!(areas(&panel, &table, &mut all).unwrap()[1].lower, [(0.0, 1.0), (1.0, 2.0)]);
        assert_eq!(all[1].pieces, [vec![(0.0, 4.0), (1.0, 6.0)]]);
        panel.y.scale = Scale::Log;
        let mut all = curves(&panel, &table).unwrap();
        assert!(matches!(areas(&panel, &table, &mut all), Err(PlotError::Stacked { .. })));
        panel.stacked = false;
        for (upper, fits) in [("b", true), ("c", false)] {
            panel.between = vec![Between {
                lower: "a".into(),
                upper: upper.into(),
                look: 2,
                label: String::new(),
            }];
            assert_eq!(areas(&panel, &table, &mut []).is_ok(), fits);
        }
    }
}
