//! The rows of several scenes, or of several values of a number of one, below each other.

use asperity::{Finding, shortest_digits};
use asperity_scene::{SceneFile, column_of};

use crate::subject::Outcome;
use crate::{AnswerError, Cell, Sheet, scene_findings, with_ranges};

/// Fills a sheet for each of some values of a number of the scene, by its name, in a column that
/// follows the model.
///
/// # Errors
/// An unknown name, values that no scene has, and the errors of `fill`, each with the value.
pub fn at_values(
    file: &SceneFile,
    (name, values): (&str, &[f64]),
    sheet: &mut Sheet,
    fill: impl Fn(&SceneFile, &mut Sheet) -> Outcome + Sync,
) -> Outcome {
    let input = file.inputs([name])?[0];
    let known: Vec<_> = scene_findings(file, true).into_iter().map(|f| (f.code, f.field)).collect();
    for &value in values {
        let mut part = Sheet::default();
        let varied = file.with_inputs([(input, value)]).map_err(AnswerError::from);
        let filled = varied.and_then(|varied| {
            let is_new = |found: &Finding| !known.contains(&(found.code, found.field.clone()));
            part.extend(scene_findings(&varied, true).into_iter().filter(is_new).collect());
            with_ranges(&varied, &mut part, &fill)
        });
        if let Err(error) = filled {
            sheet.findings.extend(part.findings);
            return Err(error.of_model(&format!("{name} = {}", shortest_digits(value))));
        }
        sheet.append(part, &column_of(name), &value.into());
    }
    Ok(())
}

impl Sheet {
    /// Adds the rows of another sheet, told apart by a cell in a column that follows the first one;
    /// columns that only one of them has are blank in the other. Of findings, one of each code and
    /// field stays.
    pub fn append(&mut self, mut part: Self, column: &str, cell: &Cell) {
        let second = part.heads.len().min(1);
        part.heads.insert(second, column.into());
        part.rows.iter_mut().for_each(|row| row.insert(second, cell.clone()));
        for (k, head) in part.heads.iter().enumerate() {
            if self.column(head).is_none() {
                // Behind the column that it follows there.
                let before = part.heads[..k].last().and_then(|head| self.column(head));
                let place = before.map_or(0, |before| before + 1);
                self.heads.insert(place, head.clone());
                self.rows.iter_mut().for_each(|row| row.insert(place, Cell::BLANK));
            }
        }
        let places: Vec<_> = self.heads.iter().map(|head| part.column(head)).collect();
        let cell = |row: &[Cell], place: &Option<usize>| {
            place.map_or(Cell::BLANK, |place| row[place].clone())
        };
        let rows = part.rows.iter().map(|row| places.iter().map(|one| cell(row, one)).collect());
        self.rows.extend(rows);
        self.results.extend(part.results);
        for found in part.findings {
            let is_known = |one: &Finding| one.code == found.code && one.field == found.field;
            if !self.findings.iter().any(is_known) {
                self.findings.push(found);
            }
        }
    }
}
