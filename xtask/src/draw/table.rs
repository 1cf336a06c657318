//! The CSV text as a table of cells, with the line numbers kept for messages.

use anyhow::{Context, Result, bail};

/// The rows of a CSV text below its header.
pub(crate) struct Table {
    header: Vec<String>,
    rows: Vec<Row>,
}

/// One line of the CSV; no cells stand for an empty line.
pub(crate) struct Row {
    line: usize,
    cells: Vec<String>,
}

impl Table {
    /// Reads a CSV text: a header, then rows of as many cells; `"` quotes a cell.
    pub(crate) fn read(csv: &str) -> Result<Self> {
        let mut header = Vec::new();
        let mut rows = Vec::new();
        for (index, text) in csv.trim_start_matches('\u{feff}').lines().enumerate() {
            let line = index + 1;
            let cells = if text.trim().is_empty() {
                Vec::new()
            } else {
                split(text).with_context(|| format!("line {line} of the CSV"))?
            };
            if header.is_empty() {
                header = cells;
                continue;
            }
            if !cells.is_empty() && cells.len() != header.len() {
                bail!(
                    "line {line} of the CSV has {} cells, its header has {}",
                    cells.len(),
                    header.len()
                );
            }
            rows.push(Row { line, cells });
        }
        Ok(Self { header, rows })
    }

    /// The place of a column, or an error that names it.
    pub(crate) fn column(&self, name: &str) -> Result<usize> {
        if self.header.is_empty() {
            bail!("the CSV is empty: column `{name}` is missing");
        }
        match self.header.iter().position(|known| known == name) {
            Some(place) => Ok(place),
            None => bail!(
                "column `{name}` is missing from the CSV, which has: {}",
                self.header.join(", ")
            ),
        }
    }

    /// The rows below the header.
    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }
}

impl Row {
    /// Whether the line held nothing at all.
    pub(crate) fn is_gap(&self) -> bool {
        self.cells.is_empty()
    }

    /// The text of a cell, without the blanks around it.
    pub(crate) fn text(&self, column: usize) -> &str {
        self.cells.get(column).map_or("", String::as_str)
    }

    /// The number in a cell; `None` when the cell is empty or holds no finite number.
    pub(crate) fn number(&self, column: usize) -> Result<Option<f64>> {
        let text = self.text(column);
        if text.is_empty() {
            return Ok(None);
        }
        let value: f64 = text
            .parse()
            .with_context(|| format!("line {} of the CSV: `{text}` is not a number", self.line))?;
        Ok(value.is_finite().then_some(value))
    }
}

fn split(text: &str) -> Result<Vec<String>> {
    let mut cells = Vec::new();
    let mut cell = String::new();
    let mut quoted = false;
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                cell.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell).trim().to_owned()),
            other => cell.push(other),
        }
    }
    if quoted {
        bail!("a quoted cell is not closed");
    }
    cells.push(cell.trim().to_owned());
    Ok(cells)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_gaps_and_missing_values_are_read() -> anyhow::Result<()> {
        let table = Table::read("curve,x\n\"a, \"\"b\"\"\",1\n\na,\na,NaN\na,-2e-3\n")?;
        let rows = table.rows();
        assert_eq!(rows[0].text(0), "a, \"b\"");
        assert!(rows[1].is_gap());
        assert_eq!(rows[2].number(1)?, None);
        assert_eq!(rows[3].number(1)?, None);
        assert_eq!(rows[4].number(1)?, Some(-2e-3));
        Ok(())
    }

    #[test]
    fn a_word_in_a_number_column_is_named_with_its_line() -> anyhow::Result<()> {
        let table = Table::read("curve,x\na,abc\n")?;
        let error = table.rows()[0].number(1).err().map(|error| format!("{error:#}"));
        let message = error.unwrap_or_default();
        assert!(message.contains("line 2") && message.contains("abc"), "{message}");
        Ok(())
    }

    #[test]
    fn a_row_of_another_length_is_refused() {
        assert!(Table::read("curve,x\na,1,2\n").is_err());
    }
}
