//! A matrix of words on shades: rows down, columns across, one number or word in each cell.

use anyhow::{Result, ensure};

use super::canvas::{Canvas, Side, Type};
use super::clip::Rect;
use super::layout::{SMALL, TITLE, WIDTH};
use super::style::Colour;
use super::text::{self, CAPITAL, LINE};

/// A matrix to be drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Matrix {
    /// A line above.
    pub title: String,
    /// Paragraphs below; each is wrapped.
    pub caption: Vec<String>,
    /// Names of the columns; they may break after hyphens.
    pub columns: Vec<String>,
    /// Names of the rows.
    pub rows: Vec<String>,
    /// The cells, row by row.
    pub cells: Vec<Vec<Cell>>,
}

/// One cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cell {
    /// A number or a word.
    pub text: String,
    /// A smaller line below it.
    pub note: String,
    /// From 0, white, to 1, dark.
    pub shade: f64,
}

const EDGE: f64 = 36.0;
const ROW: f64 = 84.0;
const NOTE: f64 = 27.0;
const HEAD: f64 = 33.0;
/// From this shade on text is white.
const DARK: f64 = 0.55;

/// Draws a matrix; gives the text of an SVG.
///
/// # Errors
/// When there are no cells, or not as many as rows and columns ask for.
pub fn draw_matrix(matrix: &Matrix) -> Result<String> {
    let count = matrix.columns.len();
    ensure!(count > 0 && !matrix.rows.is_empty(), "a matrix without cells");
    ensure!(
        matrix.cells.len() == matrix.rows.len() && matrix.cells.iter().all(|r| r.len() == count),
        "{} rows and {count} columns, and other cells",
        matrix.rows.len()
    );
    let left = EDGE + text::widest(&matrix.rows, SMALL) + 30.0;
    let width = (WIDTH - EDGE - left) / count as f64;
    let heads: Vec<Vec<String>> = matrix
        .columns
        .iter()
        .map(|name| {
            let lines = text::wrap(&name.replace('-', "- "), HEAD, width - 12.0);
            lines.into_iter().map(|line| line.replace("- ", "-")).collect()
        })
        .collect();
    let tallest = heads.iter().map(Vec::len).max().unwrap_or(1) as f64;
    let top = EDGE + TITLE * LINE + 30.0 + tallest * HEAD * LINE;
    let foot = top + ROW * matrix.rows.len() as f64;
    let caption: Vec<String> =
        matrix.caption.iter().flat_map(|p| text::wrap(p, SMALL, WIDTH - 4.0 * EDGE)).collect();
    let height = foot + 24.0 + caption.len() as f64 * SMALL * 1.35 + EDGE;
    let height = ((height / 3.0).ceil() * 3.0) as u32;

    let mut svg = String::new();
    let canvas = Canvas::new(&mut svg, WIDTH as u32, height)?;
    let face = Type { bold: true, ..Type::new(TITLE, Colour::BLACK, Side::Middle) };
    canvas.lines(std::slice::from_ref(&matrix.title), (WIDTH / 2.0, 40.0), TITLE * LINE, face)?;
    for (k, lines) in heads.iter().enumerate() {
        let x = left + (k as f64 + 0.5) * width;
        let first = top - 10.0 - lines.len() as f64 * HEAD * LINE;
        let face = Type::new(HEAD, Colour::BLACK, Side::Middle);
        canvas.lines(lines, (x, first), HEAD * LINE, face)?;
    }
    for (k, (name, cells)) in matrix.rows.iter().zip(&matrix.cells).enumerate() {
        let y = top + k as f64 * ROW;
        let baseline = y + 0.5 * (ROW + CAPITAL * SMALL);
        let face = Type::new(SMALL, Colour::BLACK, Side::End);
        canvas.text(name, (left - 20.0, baseline), face)?;
        for (k, cell) in cells.iter().enumerate() {
            let rect = Rect::sized(left + k as f64 * width, y, width, ROW);
            draw_cell(&canvas, cell, &rect.grown(-3.0))?;
        }
    }
    let face = Type::new(SMALL, Colour::DARK_GREY, Side::Start);
    canvas.lines(&caption, (2.0 * EDGE, foot + 24.0), SMALL * 1.35, face)?;
    canvas.finish()?;
    super::dressed(&svg, &matrix.title, height)
}

fn draw_cell(canvas: &Canvas, cell: &Cell, rect: &Rect) -> Result<()> {
    canvas.rect(rect, Colour::INDIGO.tint(1.0 - cell.shade), 1.0)?;
    let colour = if cell.shade >= DARK { Colour::WHITE } else { Colour::BLACK };
    let middle = 0.5 * (rect.left + rect.right);
    let room = rect.width() - 12.0;
    let size = SMALL.min(SMALL * room / text::width(&cell.text, SMALL).max(1.0));
    let up = if cell.note.is_empty() { 0.5 * (ROW + CAPITAL * SMALL) } else { 0.47 * ROW };
    let face = Type::new(size, colour, Side::Middle);
    canvas.text(&cell.text, (middle, rect.top - 3.0 + up), face)?;
    let face = Type::new(NOTE, colour, Side::Middle);
    canvas.text(&cell.note, (middle, rect.top + 0.84 * ROW), face)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(shade: f64) -> Matrix {
        let cell = Cell { text: "10⁻¹³".into(), note: "1 of 7".into(), shade };
        Matrix {
            title: "a < b".into(),
            caption: vec!["One.".into(), "Two.".into()],
            columns: vec!["gauss-legendre-64".into(), "ours".into()],
            rows: vec!["far-tail".into()],
            cells: vec![vec![cell.clone(), cell]],
        }
    }

    #[test]
    fn every_word_is_drawn_and_dark_cells_have_white_text() -> Result<()> {
        let svg = draw_matrix(&matrix(0.0))?;
        for word in ["gauss", "64", "ours", "far-tail", "10⁻¹³", "1 of 7", "One.", "a &lt; b"] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(!svg.contains("fill=\"#FFFFFF\" font") && !svg.contains("NaN"));
        let texts = |svg: &str| {
            let white = |line: &&str| line.starts_with("<text") && line.contains("#FFFFFF");
            svg.lines().filter(white).count()
        };
        assert_eq!((texts(&svg), texts(&draw_matrix(&matrix(1.0))?)), (0, 4));
        Ok(())
    }

    #[test]
    fn cells_that_do_not_fit_the_heads_are_refused() {
        let mut wrong = matrix(0.0);
        wrong.cells[0].pop();
        assert!(draw_matrix(&wrong).is_err() && draw_matrix(&Matrix::default()).is_err());
    }
}
