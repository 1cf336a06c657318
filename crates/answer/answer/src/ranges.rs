//! Answers on a surface that is known within ranges: every number with its lower and upper end.

use asperity::{Code, Quantity, map_runs};
use asperity_scene::{AT_AN_END, SceneFile, Unknown, worst_at_ends};

use crate::inquiry::{ENDS, column_of_end};
use crate::{AnswerError, Cell, Sheet};

/// Stiffnesses, which waviness beyond the cut-off of the profile lowers.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::TangentialStiffness];

/// Fills a sheet for a scene. Where numbers of its surface are known within ranges, it is filled in
/// the middle of the ranges and at every combination of their ends; each answer, and each place
/// that differs there, gets the smallest and the largest of these as columns with `_lower` and
/// `_upper`, and is blank if it is missing at an end. Results say which unknown makes the ranges
/// wide.
///
/// # Errors
/// The errors of `fill`, in the middle or at an end.
pub fn with_ranges<T, E: From<AnswerError> + Send>(
    file: &SceneFile,
    sheet: &mut Sheet,
    fill: impl Fn(&SceneFile, &mut Sheet) -> Result<T, E> + Sync,
) -> Result<T, E> {
    if file.spreads().is_empty() {
        return fill(file, sheet);
    }
    let (middle, corners) = file.corners().map_err(AnswerError::from)?;
    let found = fill(&middle, sheet)?;
    let filled = |corner: &SceneFile| {
        let mut at_corner = Sheet::default();
        fill(corner, &mut at_corner)?;
        if at_corner.rows.len() != sheet.rows.len() {
            let text = "the number of rows differs between the ends of the ranges of the surface";
            return Err(AnswerError::from(text).into());
        }
        Ok(at_corner)
    };
    let sheets = map_runs(&corners, 1, |one| one.iter().map(filled).collect());
    let ends = Ends { file, sheets: sheets.into_iter().collect::<Result<_, E>>()? };
    ends.add_findings(sheet);
    ends.add_columns(sheet);
    Ok(found)
}

/// The sheets at the ends of the ranges.
struct Ends<'a> {
    file: &'a SceneFile,
    sheets: Vec<Sheet>,
}

/// How a value answers to the unknowns: the ratio of its ends, and that due to each unknown.
#[derive(Clone, Default)]
struct Width {
    total: f64,
    /// Logarithms.
    of_unknowns: Vec<f64>,
}

impl Ends<'_> {
    /// The numbers of a cell at the ends and in the middle; none if one of them is missing.
    fn numbers(&self, sheet: &Sheet, row: usize, column: usize) -> Option<Vec<f64>> {
        let all = self.sheets.iter().chain([sheet]);
        all.map(|sheet| sheet.rows[row].get(column)?.number()).collect()
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
                let ends = self.numbers(sheet, row, column).map(|all| [least(&all), most(&all)]);
                let cell = &mut sheet.rows[row][column];
                if let Some(end) = of_interval(&sheet.heads[column]) {
                    *cell = ends.map(|ends| ends[end]).into();
                    continue;
                }
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

    /// The widest value of a column of positive numbers.
    fn width(&self, sheet: &Sheet, column: usize) -> Option<Width> {
        let unknowns = self.file.spreads().len();
        let of_row = |row: usize| {
            let numbers = self.numbers(sheet, row, column)?;
            let logs: Vec<f64> = numbers.into_iter().map(f64::ln).collect();
            let corners = logs.get(..logs.len() - 1)?;
            let effect = |unknown: usize| {
                let side = |k: usize| if (k >> unknown) & 1 == 1 { 1.0 } else { -1.0 };
                let sum: f64 = corners.iter().enumerate().map(|(k, log)| side(k) * log).sum();
                (2.0 * sum / corners.len() as f64).abs()
            };
            let of_unknowns = (0..unknowns).map(effect).collect();
            let width = Width { total: most(&logs) - least(&logs), of_unknowns };
            // Places are the same at all ends.
            Some(width).filter(|of| of.total.is_finite() && of.total > SAME)
        };
        let rows = (0..sheet.rows.len()).filter_map(of_row);
        rows.max_by(|a, b| a.total.total_cmp(&b.total))
    }

    /// Says which unknown makes the ranges wide, and the shares of all; passes on warnings that the
    /// middle does not have.
    fn add_findings(&self, sheet: &mut Sheet) {
        let at_ends = self.sheets.iter().flat_map(|end| &end.findings);
        let new = worst_at_ends(&sheet.findings, at_ends);
        sheet.findings.extend(new);
        // The first result is the verdict of a recommendation.
        let own = sheet.results.first().cloned();
        let mut others = self.sheets.iter().filter_map(|end| end.results.first());
        if let Some(other) = others.find(|other| Some(*other) != own.as_ref()) {
            sheet.result(format!("{AT_AN_END}: {other}"));
        }
        let spreads = self.file.spreads();
        let columns =
            sheet.heads.iter().enumerate().filter_map(|(column, head)| {
                Some((quantity_of(head)?, self.width(sheet, column)?))
            });
        let widths: Vec<(Quantity, Width)> = columns.collect();
        let sum = |k: usize| widths.iter().map(|(_, width)| width.of_unknowns[k]).sum::<f64>();
        let widest = (0..spreads.len()).max_by(|a, b| sum(*a).total_cmp(&sum(*b)));
        let Some(k) = widest.filter(|_| !widths.is_empty()) else { return };
        let (name, spread) = spreads[k];
        let ratio = |log: f64| match log.exp() {
            narrow @ ..2.0 => format!("{narrow:.2}"),
            wide => format!("{wide:.1}"),
        };
        let within = |(quantity, width): &(Quantity, Width)| {
            format!("{quantity} within {}", ratio(width.of_unknowns[k]))
        };
        let each = widths.iter().map(within).collect::<Vec<_>>().join(", ");
        let of_faces =
            self.file.unknowns().into_iter().map(|(_, one)| one).filter(|one| one.name == name);
        let width = |one: &Unknown| one.range[2] / one.range[0];
        let widest = of_faces.max_by(|a, b| width(a).total_cmp(&width(b)));
        let narrowed = widest.map_or("", |one| one.narrowed);
        let spread = ratio(spread.ln());
        let text = format!(
            "{name} is unknown within a factor of {spread}, and with it {each}; {narrowed} would narrow it"
        );
        sheet.result(text);
        let shares = widths.iter().map(|(quantity, Width { total, of_unknowns })| {
            let all: f64 = of_unknowns.iter().sum();
            let share =
                |((name, _), of): (&(&str, f64), &f64)| format!("{name} {:.0} %", 100.0 * of / all);
            let shares = spreads.iter().zip(of_unknowns).map(share).collect::<Vec<_>>().join(", ");
            format!("{quantity} {} ({shares})", ratio(*total))
        });
        let shares = shares.collect::<Vec<_>>().join("; ");
        let text = format!(
            "upper over lower end, at most, and the shares of the unknowns in this: {shares}"
        );
        sheet.result(text);
        if widths.iter().any(|(quantity, _)| STIFFNESSES.contains(quantity)) {
            let text = "waviness longer than lambda_c is not in the roughness and can only make the joint softer than these stiffnesses";
            sheet.note(Code::Waviness, text);
        }
        sheet.findings.extend(self.file.smooth_counterface());
    }
}

/// Ends of the names of columns about models, beside the columns of quantities.
const ANSWERS: [&str; 1] = ["_deviation"];
/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;
/// Why a number has no value where it is missing at an end.
pub const NO_RANGE: &str = "there is no value at an end of the ranges of the surface";

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
