//! Fitted models as a table.

use asperity::fit::Fitted;
use asperity_answer::{Cell, Sheet};

/// One row for each model and parameter.
pub fn table(ranked: &[Fitted]) -> Sheet {
    let mut table =
        Sheet::new(&["model", "parameter", "value", "lower", "upper", "unit", "rms", "bic"]);
    for one in ranked {
        for found in &one.parameters {
            let [value, lower, upper] =
                [Some(found.value), found.lower, found.upper].map(Cell::from);
            let others =
                [value, lower, upper, (&*found.unit).into(), one.rms.into(), one.bic.into()];
            table.add(&[&one.model, &found.name], others);
        }
    }
    table
}
