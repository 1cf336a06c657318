//! `asperity materials`: the materials of scene files.

use anyhow::{Result, ensure};
use clap::Args;

use crate::input::args::OutputArgs;
use crate::output::table::{Cell, Format, Table};

/// The materials that a scene file may name, with their sources
#[derive(Debug, Args)]
#[command(
    after_help = "Write material = \"steel-100cr6\" in [[body]] instead of the numbers. The numbers are
typical ones at room temperature, for orientation; measured ones are better. Blank
where no value was found. csv and json also hold the source of each material.

Examples:
  asperity materials
  asperity materials steel
  asperity materials --format csv --output materials.csv"
)]
pub struct Materials {
    /// Only the materials with this word in their name, or the nearest ones
    word: Option<String>,
    #[command(flatten)]
    output: OutputArgs,
}

const COLUMNS: [&str; 9] = [
    "material",
    "youngs_modulus_Pa",
    "poissons_ratio",
    "hardness_Pa",
    "yield_strength_Pa",
    "thermal_conductivity_W_per_m_K",
    "electrical_resistivity_ohm_m",
    "name",
    "source",
];

impl Materials {
    pub fn run(self) -> Result<()> {
        // Sources are too wide for a terminal.
        let shown = COLUMNS.len() - usize::from(self.output.format == Format::Table);
        let mut table = Table::new(&COLUMNS[..shown]);
        let word = self.word.unwrap_or_default();
        let found = asperity_inputs::materials_like(&word);
        ensure!(!found.is_empty(), "no material is like {word:?}; `asperity materials` lists all");
        for material in found {
            let body = &material.body;
            let numbers = [
                Some(body.youngs_modulus),
                Some(body.poissons_ratio),
                body.hardness,
                body.yield_strength,
                body.thermal_conductivity,
                body.electrical_resistivity,
            ];
            let mut row = vec![Cell::from(&*material.id)];
            row.extend(numbers.map(Cell::Number));
            row.extend([Cell::from(&*material.name), Cell::from(&*material.source)]);
            row.truncate(shown);
            table.rows.push(row);
        }
        self.output.write(&table)
    }
}
