//! The table of times against errors: `speed-vs-error.csv`.

use anyhow::{Result, ensure};
use asperity::{Model, Quantity};

use super::accuracy::{Worst, evaluations, hard_grid, mean, worse, worst};
use super::builds;
use super::cases::Case;
use super::external::{self, External, Group};
use super::laws::Laws;
use super::methods::{self, Failure, Job, Setting};
use super::scope::{Scope, points};
use crate::table::{Field, Table};

/// The columns, as the csv has them.
const COLUMNS: [&str; 7] =
    ["model", "quantity", "method", "tolerance", "median_ns", "max_relative_error", "evaluations"];

/// One row.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The model's id.
    pub model: String,
    /// The quantity.
    pub quantity: Quantity,
    /// The method.
    pub method: &'static str,
    /// What it was asked for, if it can be asked.
    pub tolerance: Option<f64>,
    /// Median time of one evaluation or of one build \[ns\], if it was taken.
    pub median_ns: Option<f64>,
    /// Worst error on the hard grid; nothing for a build.
    pub worst: Option<Worst>,
    /// Mean number of evaluations.
    pub evaluations: Option<f64>,
}

/// All that a run needs.
pub struct Run<'a> {
    /// How much is measured.
    pub scope: Scope,
    /// Laws that were built.
    pub laws: &'a Laws,
    /// References.
    pub cases: &'a [Case],
    /// Says that one more row is done.
    pub tick: &'a dyn Fn(&str),
}

impl Run<'_> {
    /// The pairs of model and quantity.
    ///
    /// # Errors
    /// None, as long as the names of models are right.
    pub fn pairs(&self) -> Result<Vec<(Model, Quantity)>> {
        let quantities = self.scope.quantities();
        let pairs =
            |model: Model| quantities.iter().map(move |quantity| (model.clone(), *quantity));
        Ok(self.scope.models()?.into_iter().flat_map(pairs).collect())
    }

    /// Errors and evaluations of our own methods; times only if asked for.
    ///
    /// # Errors
    /// When the library refuses a case.
    pub fn own(&self, model: &Model, quantity: Quantity, timed: bool) -> Result<Vec<Row>> {
        let (points, hard) = (points(model, quantity)?, hard_grid(self.cases, model, quantity));
        ensure!(!hard.is_empty(), "no hard case of {model} {quantity}");
        let mut rows = vec![];
        for method in methods::all() {
            for setting in self.scope.settings(&method, model) {
                let jobs = points
                    .iter()
                    .map(|point| method.prepare(self.laws, point, setting))
                    .collect::<Result<Vec<Job>>>()?;
                rows.push(Row {
                    model: model.id().into(),
                    quantity,
                    method: method.name,
                    tolerance: match setting {
                        Setting::Tolerance(tolerance) => Some(tolerance),
                        _ => None,
                    },
                    median_ns: timed.then(|| self.scope.effort().of_jobs(&jobs)),
                    worst: Some(worst(self.laws, &method, setting, &hard)?),
                    evaluations: evaluations(self.laws, &method, setting, &points)?,
                });
                (self.tick)(method.name);
            }
        }
        Ok(rows)
    }

    /// What building costs.
    ///
    /// # Errors
    /// When the model refuses the scene.
    pub fn builds(&self, model: &Model, quantity: Quantity) -> Result<Vec<Row>> {
        let mut rows = vec![];
        for tolerance in self.scope.tolerances(model) {
            let effort = self.scope.effort();
            for (method, (time, evaluations)) in [
                ("build-law", builds::law(model, quantity, tolerance, effort)?),
                ("build-scene", builds::scene(model, quantity, tolerance, effort)?),
            ] {
                rows.push(Row {
                    model: model.id().into(),
                    quantity,
                    method,
                    tolerance: Some(tolerance),
                    median_ns: Some(time),
                    worst: None,
                    evaluations,
                });
                (self.tick)(method);
            }
        }
        Ok(rows)
    }

    /// The rows of another library, for the laws it can be given.
    ///
    /// # Errors
    /// When its process fails.
    pub fn external(&self, library: &External) -> Result<Vec<Row>> {
        let (mut groups, mut asked, mut grids) = (vec![], vec![], vec![]);
        for (model, quantity) in self.pairs()? {
            let points = points(&model, quantity)?;
            if !points.iter().all(|point| external::can_take(point)) {
                continue;
            }
            let hard = hard_grid(self.cases, &model, quantity);
            for tolerance in self.scope.tolerances(&model) {
                groups.push(Group { tolerance, repeats: 5, problems: points.clone() });
                let problems = hard.iter().map(|case| case.problem.clone()).collect();
                groups.push(Group { tolerance, repeats: 0, problems });
                asked.push((model.clone(), quantity, tolerance));
                grids.push(hard.clone());
            }
        }
        let answers = library.run(&groups)?;
        let mut rows = vec![];
        for (((model, quantity, tolerance), hard), pair) in
            asked.into_iter().zip(grids).zip(answers.chunks(2))
        {
            let [timed, errors] = pair else { continue };
            let counts = timed.outcomes.iter().flatten().filter_map(|found| found.evaluations);
            let errors = hard.iter().zip(&errors.outcomes).map(|(case, found)| case.error(*found));
            rows.push(Row {
                model: model.id().into(),
                quantity,
                method: library.name,
                tolerance: Some(tolerance),
                median_ns: timed.median_ns,
                worst: Some(errors.fold(Ok(0.0), worse)),
                evaluations: mean(counts),
            });
            (self.tick)(library.name);
        }
        Ok(rows)
    }
}

/// The csv. Rows stand by model and quantity in the order of the models, then as they came.
///
/// # Errors
/// None, as long as rows have as many fields as columns.
pub fn csv(rows: &[Row]) -> Result<String> {
    let mut table = Table::new(&COLUMNS);
    let mut order: Vec<&Row> = rows.iter().collect();
    let place = |row: &Row| {
        let models = rows.iter().map(|other| &other.model);
        (models.clone().position(|model| *model == row.model), row.quantity)
    };
    order.sort_by_key(|row| place(row));
    for row in order {
        let quantity = row.quantity.to_string();
        let cells = [
            row.tolerance.map(|tolerance| format!("{tolerance:e}")),
            row.median_ns.map(significant),
            row.worst.map(error_text),
            row.evaluations.map(|count| format!("{count:.1}")),
        ];
        let mut fields =
            vec![Field::Word(&row.model), Field::Word(&quantity), Field::Word(row.method)];
        fields.extend(cells.iter().map(|cell| cell.as_deref().map_or(Field::Gap, Field::Word)));
        table.push(&fields)?;
    }
    Ok(table.into_text())
}

/// Three significant digits: more would be noise.
#[must_use]
pub fn significant(number: f64) -> String {
    let decimals = (2.0 - number.abs().max(1e-2).log10().floor()).max(0.0) as usize;
    format!("{number:.decimals$}")
}

/// Two digits, or the word of a failure.
#[must_use]
pub fn error_text(error: Result<f64, Failure>) -> String {
    error.map_or_else(|failure| failure.word().into(), |error| format!("{error:.1e}"))
}
