//! Answers on a scene whose numbers are known within ranges: every number with its lower and upper
//! end.

use asperity::{Code, Quantity, map_runs};
use asperity_scene::{Description, Points, SceneFile, Unknown};

use crate::inquiry::{ENDS, column_of_end};
use crate::{AnswerError, Cell, Sheet};

/// Stiffnesses, which waviness beyond the cut-off of the profile lowers.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::TangentialStiffness];

/// Fills a sheet for a scene. Where numbers of the scene are known within ranges, it is filled in
/// the middle of the ranges and at [points](SceneFile::points) of them; each answer, and each place
/// that differs there, gets the smallest and the largest of these as columns with `_lower` and
/// `_upper`, and is blank if it is missing at a point. The ends of an interval that an answer has
/// already are the smallest and the largest of the points. Curved bodies are solved at the first
/// eight points between the combinations of ends, and at the others where a number there exceeds
/// those of the ends. Results say which unknown makes the
/// ranges wide.
///
/// # Errors
/// The errors of `fill`, in the middle or at a point.
pub fn with_ranges<T, E: From<AnswerError> + Send>(
    file: &SceneFile,
    sheet: &mut Sheet,
    fill: impl Fn(&SceneFile, &mut Sheet) -> Result<T, E> + Sync,
) -> Result<T, E> {
    let points = file.points().map_err(AnswerError::from)?;
    let found = fill(&points.middle, sheet)?;
    if points.all.is_empty() {
        return Ok(found);
    }
    let filled = |point: &SceneFile| {
        let mut at_point = Sheet::default();
        fill(point, &mut at_point)?;
        if at_point.rows.len() != sheet.rows.len() {
            let text = "the number of rows differs within the ranges of the scene";
            return Err(AnswerError::from(text).into());
        }
        Ok(at_point)
    };
    let fill_all = |points: &[SceneFile]| {
        let sheets = map_runs(points, 1, |one| one.iter().map(filled).collect());
        sheets.into_iter().collect::<Result<Vec<Sheet>, E>>()
    };
    // Each point of curved bodies is a solution.
    let corners = points.corners().count();
    let few = if file.shape().is_some() { corners + FEW } else { points.all.len() };
    let mut sheets = fill_all(&points.all[..few])?;
    if few < points.all.len() && !are_between(&sheets[..corners], &sheets[corners..]) {
        sheets.extend(fill_all(&points.all[few..])?);
    }
    let ends = Ends { file, points, sheets };
    ends.add_findings(sheet);
    ends.add_columns(sheet);
    Ok(found)
}

/// Whether all numbers of some sheets lie between those of others, but for errors of solutions.
fn are_between(outer: &[Sheet], inner: &[Sheet]) -> bool {
    let cells = |sheet: &Sheet| sheet.rows.concat();
    let outer: Vec<Vec<Cell>> = outer.iter().map(cells).collect();
    let is_between = |(k, cell): (usize, &Cell)| {
        let ends: Vec<f64> = outer.iter().filter_map(|cells| cells[k].number()).collect();
        let error = FLAT * least(&ends).abs().max(most(&ends).abs());
        let is_within = |x| (least(&ends) - error..=most(&ends) + error).contains(&x);
        cell.number().is_none_or(is_within)
    };
    inner.iter().all(|sheet| cells(sheet).iter().enumerate().all(is_between))
}

/// The sheets at the points of the ranges.
struct Ends<'a> {
    file: &'a SceneFile,
    points: Points,
    sheets: Vec<Sheet>,
}

/// How a value answers to the unknowns: the distance of its ends, and that due to each unknown.
struct Width {
    total: f64,
    of_unknowns: Vec<f64>,
    /// Whether these are logarithms of ratios.
    is_ratio: bool,
}

impl Ends<'_> {
    /// The numbers of a cell at the points and in the middle; none if one of them is missing.
    fn numbers(&self, sheet: &Sheet, row: usize, column: usize) -> Option<Vec<f64>> {
        let all = self.sheets.iter().chain([sheet]);
        all.map(|sheet| sheet.rows[row].get(column)?.number()).collect()
    }

    /// An end of what is known: of the interval of an answer at each point and, where it has none,
    /// of the answer.
    fn end(&self, sheet: &Sheet, (row, column): (usize, usize), end: usize) -> Option<f64> {
        let is_own = |head: &String| column_of_end(head, ENDS[end]) == sheet.heads[column];
        let value = sheet.heads.iter().position(is_own)?;
        let number = |sheet: &Sheet| {
            let cells = &sheet.rows[row];
            cells.get(column)?.number().or(cells.get(value)?.number())
        };
        let all: Option<Vec<f64>> = self.sheets.iter().chain([sheet]).map(number).collect();
        all.map(|all| if end == 0 { least(&all) } else { most(&all) })
    }

    /// Adds the ends of every column of answers, and of places whose numbers differ.
    fn add_columns(&self, sheet: &mut Sheet) {
        let differs = |column: &usize| {
            (0..sheet.rows.len()).any(|row| {
                let own = sheet.rows[row][*column].number();
                self.sheets.iter().any(|end| match (own, end.rows[row][*column].number()) {
                    (Some(own), Some(other)) => (own - other).abs() > SAME * own.abs(),
                    (own, other) => own.is_some() != other.is_some(),
                })
            })
        };
        let is_answer = |column: &usize| match quantity_of(&sheet.heads[*column]) {
            Some(Quantity::Pressure) => sheet.column("load_N").is_none(),
            Some(_) => true,
            None => ANSWERS.iter().any(|end| sheet.heads[*column].ends_with(end)),
        };
        let has_own =
            |column: &usize| sheet.column(&column_of_end(&sheet.heads[*column], ENDS[0])).is_some();
        let columns = (0..sheet.heads.len()).filter(|column| !has_own(column));
        let columns = columns.filter(|column| is_answer(column) || differs(column));
        let columns: Vec<usize> = columns.collect();
        let mut blank = 0;
        // From the last, so that the places of the others stay.
        for column in columns.into_iter().rev() {
            for row in 0..sheet.rows.len() {
                if let Some(end) = of_interval(&sheet.heads[column]) {
                    sheet.rows[row][column] = self.end(sheet, (row, column), end).into();
                    continue;
                }
                let ends = self.numbers(sheet, row, column).map(|all| [least(&all), most(&all)]);
                let cell = &mut sheet.rows[row][column];
                if ends.is_none() && cell.number().is_some() {
                    *cell = Cell::BLANK;
                    blank += 1;
                }
                let ends = [0, 1].map(|end| Cell::from(ends.map(|ends| ends[end])));
                sheet.rows[row].splice(column + 1..column + 1, ends);
            }
            if of_interval(&sheet.heads[column]).is_some() {
                continue;
            }
            let heads = ENDS.map(|end| column_of_end(&sheet.heads[column], end));
            sheet.heads.splice(column + 1..column + 1, heads);
        }
        if blank > 0 {
            sheet.warn(Code::NoValue, format!("{blank} values are blank: {NO_RANGE}"));
        }
    }

    /// The widest value of a column: in logarithms where all its numbers are positive.
    fn width(&self, sheet: &Sheet, column: usize) -> Option<Width> {
        let of_row = |row: usize| {
            let mut numbers = self.numbers(sheet, row, column)?;
            let is_ratio = least(&numbers) > 0.0;
            let size = if is_ratio { 1.0 } else { most(&numbers).max(-least(&numbers)) };
            if is_ratio {
                numbers.iter_mut().for_each(|number| *number = number.ln());
            }
            let total = most(&numbers) - least(&numbers);
            let width = Width { total, of_unknowns: self.points.effects(&numbers), is_ratio };
            // Places are the same at all points.
            (total.is_finite() && total > SAME * size).then_some(width)
        };
        let rows = (0..sheet.rows.len()).filter_map(of_row);
        rows.max_by(|a, b| a.total.total_cmp(&b.total))
    }

    /// Says which unknown makes the ranges wide, and the shares of all; passes on warnings that the
    /// middle does not have.
    fn add_findings(&self, sheet: &mut Sheet) {
        let found = self.sheets.iter().flat_map(|one| &one.findings);
        let new = Points::worst(&sheet.findings, found);
        sheet.findings.extend(new);
        let unknowns = &self.points.unknowns;
        let columns =
            sheet.heads.iter().enumerate().filter_map(|(column, head)| {
                Some((quantity_of(head)?, self.width(sheet, column)?))
            });
        let widths: Vec<(Quantity, Width)> = columns.collect();
        let ratios = || widths.iter().filter(|(_, width)| width.is_ratio);
        let sum = |k: usize| ratios().map(|(_, width)| width.of_unknowns[k]).sum::<f64>();
        // Of like ones the first.
        let widest =
            (0..unknowns.len()).reduce(|a, b| if sum(b) > sum(a) * (1.0 + SAME) { b } else { a });
        let Some(k) = widest.filter(|_| !widths.is_empty()) else { return };
        // Quantities with the same shares together.
        let mut groups: Vec<(String, Vec<String>)> = vec![];
        for (quantity, Width { of_unknowns, .. }) in &widths {
            let all: f64 = of_unknowns.iter().sum();
            let share = |(one, of): (&Unknown, &f64)| {
                Some(format!("{} {:.0} %", one.name, 100.0 * of / all))
                    .filter(|_| *of > 0.005 * all)
            };
            let shares: Vec<_> = unknowns.iter().zip(of_unknowns).filter_map(share).collect();
            let shares = shares.join(", ");
            match groups.iter_mut().find(|(known, _)| *known == shares) {
                Some((_, quantities)) => quantities.push(quantity.to_string()),
                None => groups.push((shares, vec![quantity.to_string()])),
            }
        }
        let Unknown { name, narrowed, .. } = &unknowns[k];
        let text = |(shares, of): &(String, Vec<String>)| format!("of {}: {shares}", of.join(", "));
        sheet.result(match &unknowns[..] {
            [_] => format!("all ranges come from {name}: {narrowed} would narrow them"),
            _ => {
                let shares = groups.iter().map(text).collect::<Vec<_>>().join("; ");
                format!("shares in the ranges {shares}; {narrowed} would narrow {name}")
            }
        });
        let spec = &self.file.spec;
        let mut surfaces = [Some(&spec.surface), spec.counterface.as_ref()].into_iter().flatten();
        let is_drawn = surfaces.any(|one| matches!(one.by, Description::Drawing(_)));
        if is_drawn && widths.iter().any(|(quantity, _)| STIFFNESSES.contains(quantity)) {
            let text = "waviness longer than lambda_c is not in the roughness and can only make the joint softer than these stiffnesses";
            sheet.note(Code::Waviness, text);
        }
    }
}

/// Ends of the names of columns about models, beside the columns of quantities.
const ANSWERS: [&str; 1] = ["_deviation"];
/// The number of points between the combinations of ends at which curved bodies are solved first,
/// and how far numbers there may exceed those of the ends.
const FEW: usize = 8;
const FLAT: f64 = 1e-5;
/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;
/// Why a number has no value where it is missing at an end.
pub const NO_RANGE: &str = "there is no value at a point of the ranges";

fn least(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(f64::INFINITY, f64::min)
}

fn most(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Which end of an interval a column is.
fn of_interval(head: &str) -> Option<usize> {
    ENDS.iter().position(|end| head.contains(&format!("_{end}")))
}

/// The quantity of a column.
fn quantity_of(head: &str) -> Option<Quantity> {
    Quantity::ALL.into_iter().find(|quantity| quantity.column() == head)
}
