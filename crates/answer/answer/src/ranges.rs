//! Answers on a scene whose numbers are known within ranges: every number with its lower and upper
//! end.

use asperity::{Code, Quantity, map_runs};
use asperity_scene::{Description, Points, SceneFile, Unknown};

use crate::inquiry::{ENDS, column_of_end};
use crate::search::{NoEnds, Numbers, Search};
use crate::{AnswerError, Cell, Sheet};

/// Stiffnesses, which waviness beyond the cut-off of the profile lowers.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::TangentialStiffness];

/// Fills a sheet for a scene. Where numbers of the scene are known within ranges, it is filled in
/// the middle of the ranges, at [points](SceneFile::points) of them, and about those at which an
/// answer is smallest or largest; each answer, and each place that differs there, gets the smallest
/// and the largest of these as columns with `_lower` and `_upper`, and is blank if it is missing at
/// a point or has no ends, as beside a pole. The ends of an interval that an answer has already are
/// the smallest and the largest of the points. Curved bodies are solved at the first eight points
/// between the combinations of ends, and at others only where a number exceeds those at the ends.
/// Results say which unknown makes the ranges wide.
///
/// # Errors
/// The errors of `fill`, in the middle or at a point.
pub fn with_ranges<T, E: From<AnswerError> + Send>(
    file: &SceneFile,
    sheet: &mut Sheet,
    fill: impl Fn(&SceneFile, &mut Sheet) -> Result<T, E> + Sync,
) -> Result<T, E> {
    let points = file.points().map_err(AnswerError::from)?;
    let answered = fill(&points.middle, sheet)?;
    if points.all.is_empty() {
        return Ok(answered);
    }
    let rows = sheet.rows.len();
    let filled = |point: &SceneFile| {
        let mut at_point = Sheet::default();
        fill(point, &mut at_point)?;
        if at_point.rows.len() != rows {
            let text = "the number of rows differs within the ranges of the scene";
            return Err(AnswerError::from(text).into());
        }
        Ok(at_point)
    };
    let fill_all = |scenes: &[SceneFile]| {
        let sheets = map_runs(scenes, 1, |one| one.iter().map(filled).collect());
        sheets.into_iter().collect::<Result<Vec<Sheet>, E>>()
    };
    let search = Search::over(&points, file.shape().is_some());
    let mut sheets = fill_all(&points.all[..search.first()])?;
    let answers = answers(&sheet.heads);
    let numbers = |sheet: &Sheet| numbers(sheet, &answers);
    let first = sheets.iter().map(numbers).collect();
    let found = search.ends(&numbers(sheet), first, &sought(sheet), |shares| {
        let scenes = shares.iter().map(|shares| file.at(shares)).collect::<Result<Vec<_>, _>>();
        let new = fill_all(&scenes.map_err(AnswerError::from)?)?;
        let numbers = new.iter().map(numbers).collect();
        sheets.extend(new);
        Ok::<_, E>(numbers)
    })?;
    let ends = Ends { file, points, sheets, found };
    ends.add_findings(sheet);
    ends.add_columns(sheet);
    Ok(answered)
}

/// Of each column with an end of an interval the column of its answer.
fn answers(heads: &[String]) -> Vec<Option<usize>> {
    let of_end = |end: &str| heads.iter().map(|head| column_of_end(head, end)).collect();
    let ends: [Vec<String>; 2] = ENDS.map(of_end);
    let own = |head: &String| {
        let end = of_interval(head)?;
        ends[end].iter().position(|of_end| of_end == head)
    };
    heads.iter().map(own).collect()
}

/// The numbers of a sheet, row by row; of an interval that an answer does not have, the answer.
fn numbers(sheet: &Sheet, answers: &[Option<usize>]) -> Numbers {
    let of_row = |row: &Vec<Cell>| {
        let number = |column: usize| row.get(column).and_then(Cell::number);
        let columns = answers.iter().enumerate();
        columns
            .map(|(column, answer)| number(column).or_else(|| number((*answer)?)))
            .collect::<Numbers>()
    };
    sheet.rows.iter().flat_map(of_row).collect()
}

/// Which ends of the numbers of a sheet are sought: of an interval those of its ends.
fn sought(sheet: &Sheet) -> Vec<[bool; 2]> {
    let of_head = |head: &String| match of_interval(head) {
        _ if ANSWERS.iter().any(|end| head.ends_with(end)) => [false; 2],
        Some(end) => [end == 0, end == 1],
        None => [sheet.column(&column_of_end(head, ENDS[0])).is_none(); 2],
    };
    let of_row: Vec<[bool; 2]> = sheet.heads.iter().map(of_head).collect();
    of_row.repeat(sheet.rows.len())
}

/// What is found at the points of the ranges.
struct Ends<'a> {
    file: &'a SceneFile,
    points: Points,
    /// The sheets at the points, first at the combinations of ends.
    sheets: Vec<Sheet>,
    /// The ends of each number, row by row.
    found: Vec<Result<[f64; 2], NoEnds>>,
}

/// How a value answers to the unknowns: the distance of its ends, and that due to each unknown.
struct Width {
    total: f64,
    of_unknowns: Vec<f64>,
    /// Whether these are logarithms of ratios.
    is_ratio: bool,
}

impl Ends<'_> {
    /// The ends of a number.
    fn ends(&self, sheet: &Sheet, row: usize, column: usize) -> Result<[f64; 2], NoEnds> {
        self.found[row * sheet.heads.len() + column]
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
        let is_end = |column: &usize| of_interval(&sheet.heads[*column]).is_some();
        let is_shown = |column: &usize| is_answer(column) || is_end(column) || differs(column);
        let columns = columns.filter(is_shown);
        let columns: Vec<usize> = columns.collect();
        let ends = |row: usize, column: usize| self.ends(sheet, row, column);
        let ends: Vec<Vec<Result<[f64; 2], NoEnds>>> = (0..sheet.rows.len())
            .map(|row| columns.iter().map(|column| ends(row, *column)).collect())
            .collect();
        let answers = answers(&sheet.heads);
        let mut found = [NoEnds::Missing, NoEnds::Growing].map(|why| (why, [0; 2]));
        let mut count = |why: Option<NoEnds>, kind: usize| {
            let counts = found.iter_mut().filter(|(of, _)| Some(*of) == why);
            counts.for_each(|(_, counts)| counts[kind] += 1);
        };
        // From the last, so that the places of the others stay.
        for (k, column) in columns.into_iter().enumerate().rev() {
            let interval = of_interval(&sheet.heads[column]);
            for (row, ends) in sheet.rows.iter_mut().zip(&ends) {
                let ends = ends[k];
                let number = |column: usize| row[column].number();
                if let Some(end) = interval {
                    let is_answer = end == 0 && answers[column].and_then(number).is_some();
                    count(ends.err().filter(|_| is_answer), 1);
                    row[column] = ends.ok().map(|ends| ends[end]).into();
                    continue;
                }
                if ends.is_err() && number(column).is_some() {
                    count(ends.err(), 0);
                    row[column] = Cell::BLANK;
                }
                let ends = [0, 1].map(|end| Cell::from(ends.ok().map(|ends| ends[end])));
                row.splice(column + 1..column + 1, ends);
            }
            if interval.is_none() {
                let heads = ENDS.map(|end| column_of_end(&sheet.heads[column], end));
                sheet.heads.splice(column + 1..column + 1, heads);
            }
        }
        for (why, [blank, open]) in found {
            for (count, [one, many]) in [
                (blank, ["one value is blank", "values are blank"]),
                (open, ["one value has no ends", "values have no ends"]),
            ] {
                let text = match count {
                    0 => continue,
                    1 => format!("{one}: {}", why.text()),
                    _ => format!("{count} {many}: {}", why.text()),
                };
                sheet.warn(Code::NoValue, text);
            }
        }
    }

    /// The widest value of a column: in logarithms where all its numbers are positive.
    fn width(&self, sheet: &Sheet, column: usize) -> Option<Width> {
        let of_row = |row: usize| {
            let ends = self.ends(sheet, row, column).ok()?;
            let is_ratio = ends[0] > 0.0;
            let scaled = |number: f64| if is_ratio { number.ln() } else { number };
            let size = if is_ratio { 1.0 } else { ends[1].max(-ends[0]) };
            let total = scaled(ends[1]) - scaled(ends[0]);
            let number = |sheet: &Sheet| Some(scaled(sheet.rows[row].get(column)?.number()?));
            let all: Vec<f64> = self.sheets.iter().map_while(number).collect();
            let width = Width { total, of_unknowns: self.points.effects(&all), is_ratio };
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
/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;
/// Which end of an interval a column is.
pub(crate) fn of_interval(head: &str) -> Option<usize> {
    ENDS.iter().position(|end| head.contains(&format!("_{end}")))
}

/// The quantity of a column.
fn quantity_of(head: &str) -> Option<Quantity> {
    Quantity::ALL.into_iter().find(|quantity| quantity.column() == head)
}
