//! Answers on a scene whose numbers are known within ranges: every number with its lower and upper
//! end.

use asperity::{Code, Finding, Quantity, map_runs};
use asperity_scene::{Description, Points, SceneFile, Unknown};

use crate::models::grouped;
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
        sheet.spread();
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
    let first = sheets.iter().map(numbers).collect();
    let found = search.ends(&numbers(sheet), first, &sought(sheet), |shares| {
        let scenes = shares.iter().map(|shares| file.point(shares)).collect::<Result<Vec<_>, _>>();
        let new = fill_all(&scenes.map_err(AnswerError::from)?)?;
        let numbers = new.iter().map(numbers).collect();
        sheets.extend(new);
        Ok::<_, E>(numbers)
    })?;
    let ends = Ends { file, points, sheets, found };
    ends.add_findings(sheet);
    ends.set(sheet);
    sheet.spread();
    Ok(answered)
}

/// The numbers of each cell: its own and the ends of its interval, for which it stands without one.
const OF_CELL: usize = 3;

/// The numbers of a sheet, cell by cell.
fn numbers(sheet: &Sheet) -> Numbers {
    let of_cell = |cell: &Cell| {
        let (own, [lower, upper]) = (cell.number(), cell.ends());
        [own, lower.or(own), upper.or(own)]
    };
    sheet.rows.iter().flatten().flat_map(of_cell).collect()
}

/// Which ends of the numbers of a sheet are sought: of an interval those of its ends.
fn sought(sheet: &Sheet) -> Vec<[bool; 2]> {
    let of_head = |head: &String| match sheet.with_ends.contains(head) {
        true => [[false; 2], [true, false], [false, true]],
        false => [[!is_deviation(head); 2], [false; 2], [false; 2]],
    };
    let of_row: Vec<[bool; 2]> = sheet.heads.iter().flat_map(of_head).collect();
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
    /// The ends of a number of a cell.
    fn ends(&self, sheet: &Sheet, row: usize, column: usize, k: usize) -> Result<[f64; 2], NoEnds> {
        self.found[OF_CELL * (row * sheet.heads.len() + column) + k]
    }

    /// Sets the ends of all answers, and of places whose numbers differ.
    fn set(&self, sheet: &mut Sheet) {
        let differs = |column: usize| {
            (0..sheet.rows.len()).any(|row| {
                let own = sheet.rows[row][column].number();
                self.sheets.iter().any(|end| match (own, end.rows[row][column].number()) {
                    (Some(own), Some(other)) => (own - other).abs() > SAME * own.abs(),
                    (own, other) => own.is_some() != other.is_some(),
                })
            })
        };
        let is_answer = |head: &String| match quantity_of(head) {
            Some(Quantity::Pressure) => sheet.column("load_N").is_none(),
            quantity => quantity.is_some() || is_deviation(head),
        };
        // The separation in another unit.
        let is_twice = |head: &String| head == "separation_over_sigma";
        let is_shown = |(column, head): (usize, &String)| {
            let has_interval = sheet.with_ends.contains(head);
            let is_shown = has_interval || is_answer(head) || differs(column) && !is_twice(head);
            is_shown.then_some((column, has_interval))
        };
        let shown: Vec<(usize, bool)> =
            sheet.heads.iter().enumerate().filter_map(is_shown).collect();
        self.report_presumed(sheet);
        let mut found = [NoEnds::Missing, NoEnds::Growing].map(|why| (why, [0; 2]));
        for (column, has_interval) in shown {
            for row in 0..sheet.rows.len() {
                let Some(value) = sheet.rows[row][column].number() else { continue };
                let of = if has_interval { [1, 2] } else { [0, 0] };
                let [lower, upper] = of.map(|k| self.ends(sheet, row, column, k));
                let ends = [lower.map(|ends| ends[0]), upper.map(|ends| ends[1])];
                let counts = found.iter_mut().filter(|(why, _)| ends[0].err() == Some(*why));
                counts.for_each(|(_, counts)| counts[usize::from(has_interval)] += 1);
                sheet.rows[row][column] = match ends[0] {
                    Err(_) if !has_interval => Cell::BLANK,
                    _ => Cell::Between(value, ends.map(Result::ok)),
                };
            }
            if !has_interval {
                sheet.with_ends.push(sheet.heads[column].clone());
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

    /// Says where ends take an interval that is not known, or lack it.
    fn report_presumed(&self, sheet: &mut Sheet) {
        let is_load = |found: &Finding| found.field == "load" || found.field == "curvature";
        for (code, text) in [
            (
                Code::Extrapolated,
                "in part of the ranges the interval of best is not known, and the ends take it from the nearest solved surfaces",
            ),
            (Code::NoEvidence, "in part of the ranges a model answers, whose error the ends lack"),
        ] {
            let is_found = |found: &Finding| found.code == code && !is_load(found);
            let has = |sheet: &Sheet| sheet.findings.iter().any(is_found);
            if has(sheet) || self.sheets.iter().any(has) {
                sheet.result(text);
            }
        }
    }

    /// The widest value of a column: in logarithms where all its numbers are positive.
    fn width(&self, sheet: &Sheet, column: usize) -> Option<Width> {
        let of_row = |row: usize| {
            let ends = self.ends(sheet, row, column, 0).ok()?;
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
        let shares = |(quantity, Width { of_unknowns, .. }): &(Quantity, Width)| {
            let all: f64 = of_unknowns.iter().sum();
            let share = |(one, of): (&Unknown, &f64)| {
                Some(format!("{} {:.0} %", one.name, 100.0 * of / all))
                    .filter(|_| *of > 0.005 * all)
            };
            let shares: Vec<_> = unknowns.iter().zip(of_unknowns).filter_map(share).collect();
            (shares.join(", "), quantity.to_string())
        };
        let groups = grouped(widths.iter().map(shares));
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

/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;

/// Whether a column is about a model, beside the column of a quantity.
fn is_deviation(head: &str) -> bool {
    head.ends_with("_deviation")
}

/// The quantity of a column.
fn quantity_of(head: &str) -> Option<Quantity> {
    Quantity::ALL.into_iter().find(|quantity| quantity.column() == head)
}
