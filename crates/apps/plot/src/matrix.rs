//! A matrix of shaded cells with a number or a text in each.

use crate::canvas::{Canvas, Rect, Type, picture};
use crate::error::PlotError;
use crate::layout::{caption_lines, draw_caption, draw_title, lines_height};
use crate::size::{EDGE, SMALL, TITLE, WIDTH};
use crate::style::{BLACK, INDIGO, WHITE};
use crate::text::{CAPITAL, LINE, widest, width, wrap};

/// A matrix to be drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Matrix {
    /// A line above.
    pub title: String,
    /// Paragraphs below; each is wrapped.
    pub caption: Vec<String>,
    /// Names of the columns; they may break after hyphens.
    pub columns: Vec<String>,
    /// The rows: their names and their cells.
    pub rows: Vec<(String, Vec<MatrixCell>)>,
}

/// One cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MatrixCell {
    /// A number or a text.
    pub text: String,
    /// A smaller line below it.
    pub note: String,
    /// From 0, white, to 1, dark.
    pub shade: f64,
}

const ROW: f64 = 28.0;
const NOTE: f64 = 9.0;
const HEAD: f64 = 11.0;
/// From this shade on text is white.
const DARK: f64 = 0.55;

/// Draws a matrix; returns the text of an svg.
///
/// # Errors
/// When there are no cells, or another number than rows times columns.
pub fn draw_matrix(matrix: &Matrix) -> Result<String, PlotError> {
    let (rows, columns) = (matrix.rows.len(), matrix.columns.len());
    if rows == 0 || columns == 0 || matrix.rows.iter().any(|(_, row)| row.len() != columns) {
        return Err(PlotError::Cells { rows, columns });
    }
    let left = EDGE + widest(matrix.rows.iter().map(|(name, _)| name), SMALL) + 10.0;
    let wide = (WIDTH - EDGE - left) / columns as f64;
    let head = |name: &String| -> Vec<String> {
        let lines = wrap(&name.replace('-', "- "), HEAD, wide - 4.0);
        lines.into_iter().map(|line| line.replace("- ", "-")).collect()
    };
    let heads: Vec<Vec<String>> = matrix.columns.iter().map(head).collect();
    let tallest = heads.iter().map(Vec::len).max().unwrap_or(1) as f64;
    let top = EDGE + (TITLE + tallest * HEAD) * LINE + 10.0;
    let foot = top + ROW * rows as f64;
    let caption = caption_lines(&matrix.caption);
    let height = foot + 8.0 + lines_height(&caption) + EDGE;
    picture(&matrix.title, (WIDTH, height), |canvas| {
        draw_title(canvas, std::slice::from_ref(&matrix.title));
        draw_caption(canvas, &caption, foot + 8.0);
        for (k, lines) in heads.iter().enumerate() {
            let place =
                (left + (k as f64 + 0.5) * wide, top - 3.0 - lines.len() as f64 * HEAD * LINE);
            canvas.lines(lines, place, Type::new(HEAD, BLACK, "middle"));
        }
        for (k, (name, cells)) in matrix.rows.iter().enumerate() {
            let y = top + k as f64 * ROW;
            let baseline = (left - 7.0, y + 0.5 * (ROW + CAPITAL * SMALL));
            canvas.text(name, baseline, Type::new(SMALL, BLACK, "end"));
            for (k, cell) in cells.iter().enumerate() {
                let rect = Rect::sized(left + k as f64 * wide, y, wide, ROW);
                draw_cell(canvas, cell, &rect.grown(-1.0));
            }
        }
        Ok(())
    })
}

fn draw_cell(canvas: &Canvas, cell: &MatrixCell, rect: &Rect) {
    canvas.polygon(&rect.corners(), INDIGO, cell.shade.clamp(0.0, 1.0));
    let colour = if cell.shade >= DARK { WHITE } else { BLACK };
    let size = SMALL.min(SMALL * (rect.width() - 4.0) / width(&cell.text, SMALL).max(1.0));
    let up = if cell.note.is_empty() { 0.5 * (ROW + CAPITAL * SMALL) } else { 0.47 * ROW };
    for (text, size, baseline) in [(&cell.text, size, up), (&cell.note, NOTE, 0.84 * ROW)] {
        let place = (0.5 * (rect.left + rect.right), rect.top - 1.0 + baseline);
        canvas.text(text, place, Type::new(size, colour, "middle"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(shade: f64) -> Matrix {
        let cell = MatrixCell { text: "10⁻¹³".into(), note: "1 of 7".into(), shade };
        Matrix {
            title: "a < b".into(),
            caption: vec!["One.".into(), "Two.".into()],
            columns: vec!["gauss-legendre-64".into(), "ours".into()],
            rows: vec![("far-tail".into(), vec![cell.clone(), cell])],
        }
    }

    #[test]
    fn cells_that_do_not_fit_the_heads_are_refused() {
        let mut wrong = matrix(0.0);
        wrong.rows[0].1.pop();
        assert!(draw_matrix(&wrong).is_err() && draw_matrix(&Matrix::default()).is_err());
    }
}
