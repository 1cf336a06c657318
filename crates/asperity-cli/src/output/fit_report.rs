//! Fitted models as notes, warnings, a table and a picture.

use anyhow::Result;
use asperity::fit::{Data, Fitted, Ranking};
use asperity_answer::{Cell, Sheet};
use asperity_inputs::Free;

use crate::output::{fit_plot, print_message};
use crate::scene::{LoadedScene, NamedModel};

/// Models fitted to data of a scene.
pub struct Report<'r> {
    pub scene: &'r LoadedScene,
    pub data: &'r Data,
    pub models: &'r [NamedModel],
    pub ranking: &'r Ranking,
}

impl Report<'_> {
    /// Notes on bounds that are not given, and remarks on each model; the misfit of the first one
    /// is left to the error where no model describes the data.
    pub fn print_notes(&self, free: &[Free]) {
        let all = &self.ranking.models;
        let usual = all.first().map(|one| self.scene.file.notes_on_bounds(free, one));
        usual.iter().flatten().for_each(|note| print_message("note", note));
        let hopeless = all.iter().all(|one| one.misfit().is_some());
        let found = all.iter().flat_map(Fitted::findings);
        for found in found.filter(|one| !hopeless || one.code != "misfit") {
            print_message(&found.severity.to_string(), &found.message());
        }
        let is_ranked = all.iter().any(|one| one.bic.is_some());
        if !hopeless && (is_ranked || all.len() > 1) {
            print_message("note", &self.ranking.summary);
        }
    }

    /// Reports what is unusual about the answers of models that describe the data.
    pub fn print_findings(&self) -> Result<()> {
        let mut found = vec![];
        let all = self.ranking.models.iter();
        for fitted in all.filter(|one: &&Fitted| one.describes_data()) {
            let model = self.models.iter().find(|(id, _)| *id == fitted.model);
            if let Some((_, model)) = model {
                found.extend(self.scene.file.findings_of_fit(model, fitted, self.data)?);
            }
        }
        self.scene.report(found.into_iter().collect());
        Ok(())
    }

    /// The picture of data and fitted models.
    pub fn svg(&self) -> Result<String> {
        fit_plot::svg(&self.scene.file, self.data, self.models, self.ranking)
    }

    /// One row for each model and parameter.
    pub fn table(&self) -> Sheet {
        let head = ["model", "parameter", "value", "lower", "upper", "unit", "rms", "bic"];
        let mut table = Sheet::new(&head);
        for one in &self.ranking.models {
            for found in &one.parameters {
                let number = Cell::from;
                table.rows.push(vec![
                    one.model.as_str().into(),
                    found.name.as_str().into(),
                    number(Some(found.value)),
                    number(found.lower),
                    number(found.upper),
                    found.unit.as_str().into(),
                    number(one.rms),
                    number(one.bic),
                ]);
            }
        }
        table
    }
}
