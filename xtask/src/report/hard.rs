//! The table of the hard cases: `hard-cases.csv`, a row for each case, a column for each method.

use anyhow::Result;
use rayon::prelude::*;

use super::accuracy::Worst;
use super::cases::Case;
use super::external::{self, External, Group};
use super::laws::Laws;
use super::methods::{self, HARD_TOLERANCE};
use super::speed::error_text;
use crate::table::{Field, Table};

/// What stands before the columns of the methods.
pub const BEFORE: [&str; 6] =
    ["family", "case", "heights", "model", "quantity", "separation_over_sigma"];

/// What stands for a case that a method was not given.
pub const NOT_GIVEN: &str = "";

/// One method's column; `None` where it was not given the case.
struct Column {
    name: &'static str,
    errors: Vec<Option<Worst>>,
}

/// The csv: relative errors (to the sum of sizes), or the word of a failure.
///
/// # Errors
/// When the library refuses a case, or another library's process fails.
pub fn csv(laws: &Laws, cases: &[Case], libraries: &[External]) -> Result<String> {
    let mut columns = vec![];
    for method in methods::all() {
        let error = |case: &Case| -> Result<Option<Worst>> {
            let job = method.prepare(laws, &case.problem, method.on_hard_cases())?;
            Ok(Some(case.error(job())))
        };
        let errors = cases.par_iter().map(error).collect::<Result<_>>()?;
        columns.push(Column { name: method.name, errors });
    }
    for library in libraries {
        columns.push(Column { name: library.name, errors: from(library, cases)? });
    }
    let mut names = BEFORE.to_vec();
    names.extend(columns.iter().map(|column| column.name));
    let mut table = Table::new(&names);
    for (k, case) in cases.iter().enumerate() {
        let problem = &case.problem;
        let (quantity, separation) =
            (problem.quantity.to_string(), format!("{}", problem.separation));
        let errors: Vec<String> = columns
            .iter()
            .map(|column| column.errors[k].map_or_else(|| NOT_GIVEN.into(), error_text))
            .collect();
        let mut fields = vec![
            Field::Word(&case.family),
            Field::Word(&case.name),
            Field::Word(problem.scene.heights.name()),
            Field::Word(problem.model.id()),
            Field::Word(&quantity),
            Field::Word(&separation),
        ];
        fields.extend(errors.iter().map(|error| Field::Word(error)));
        table.push(&fields)?;
    }
    Ok(table.into_text())
}

fn from(library: &External, cases: &[Case]) -> Result<Vec<Option<Worst>>> {
    let given: Vec<&Case> = cases.iter().filter(|case| external::can_take(&case.problem)).collect();
    let problems = given.iter().map(|case| case.problem.clone()).collect();
    let answers = library.run(&[Group { tolerance: HARD_TOLERANCE, repeats: 0, problems }])?;
    let outcomes = answers.into_iter().flat_map(|answers| answers.outcomes);
    let mut errors = given.into_iter().zip(outcomes).map(|(case, found)| case.error(found));
    let one = |case: &Case| {
        if external::can_take(&case.problem) { errors.next() } else { None }
    };
    Ok(cases.iter().map(one).collect())
}
