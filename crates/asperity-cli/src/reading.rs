//! What several commands read from a model, with the words it deserves.

use asperity::{ContactError, Output, Readout};

use crate::number::exact;
use crate::output;
use crate::table::Table;

/// Words for the standard error, each said once.
#[derive(Debug, Default)]
pub struct Words(Vec<String>);

impl Words {
    pub fn add(&mut self, text: String) {
        if !self.0.contains(&text) {
            self.0.push(text);
        }
    }

    pub fn say(&self) {
        for text in &self.0 {
            output::say("warning", text);
        }
    }
}

/// A column of values, one for each separation.
pub type Values = Vec<Option<f64>>;

/// The separations that carry a load; that there are several is said.
pub fn crossings(
    id: &str,
    readout: &Readout,
    load: f64,
    words: &mut Words,
) -> Result<Vec<f64>, ContactError> {
    let found = readout.compiled().separations_at(load)?;
    if found.len() > 1 {
        words.add(format!(
            "{id}: the force is not monotone: {} separations carry {} N, each is a row",
            found.len(),
            exact(load)
        ));
    }
    Ok(found)
}

/// Outputs at separations; what deserves a word goes to the words.
pub fn values(
    readout: &Readout,
    outputs: &[Output],
    separations: &[f64],
    words: &mut Words,
) -> Result<Vec<Values>, ContactError> {
    let mut all = vec![];
    for &output in outputs {
        let column = readout.column(output, separations, || ())?;
        column.warnings.iter().for_each(|warning| words.add(warning.to_string()));
        all.push(column.values.iter().map(|v| v.value).collect());
    }
    Ok(all)
}

/// The name of an output's column.
pub fn column_name(output: Output) -> String {
    output.to_string().replace('-', "_")
}

/// Adds a column for each output.
pub fn columns(table: &mut Table, outputs: &[Output], values: Vec<Values>) {
    for (&output, values) in outputs.iter().zip(values) {
        table.numbers(&column_name(output), output.unit(), values);
    }
}
