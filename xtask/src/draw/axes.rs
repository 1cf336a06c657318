//! The frame of a panel: grid, ticks, numbers, names of the axes, heading.

use anyhow::Result;

use super::canvas::{Side, Type};
use super::layout::{LABEL, MarkLabels, TICK, TICK_GAP, TICK_LENGTH};
use super::panel::Brush;
use super::style::Colour;
use super::text::{self, CAPITAL, LINE};

const GRID: Colour = Colour(222, 222, 222);

impl Brush<'_, '_, '_> {
    pub(crate) fn grid(&self) -> Result<()> {
        for tick in self.plot.x.ticks.ticks.iter().filter(|tick| tick.label.is_some()) {
            let x = self.frame.across(self.plot.x.share_of_shown(tick.at));
            self.canvas.line(&[(x, self.rect.top), (x, self.rect.bottom)], GRID, 2)?;
        }
        for tick in self.plot.y.ticks.ticks.iter().filter(|tick| tick.label.is_some()) {
            let y = self.frame.up(self.plot.y.share_of_shown(tick.at));
            self.canvas.line(&[(self.rect.left, y), (self.rect.right, y)], GRID, 2)?;
        }
        Ok(())
    }

    pub(crate) fn axes(&self, marks: &MarkLabels) -> Result<()> {
        let (canvas, rect, plot) = (self.canvas, self.rect, self.plot);
        canvas.outline(&rect, Colour::BLACK, 4)?;
        let length = |label: &Option<String>| {
            if label.is_some() { TICK_LENGTH } else { TICK_LENGTH * 0.55 }
        };
        for tick in &plot.x.ticks.ticks {
            let x = self.frame.across(plot.x.share_of_shown(tick.at));
            let end = rect.bottom + length(&tick.label);
            canvas.line(&[(x, rect.bottom), (x, end)], Colour::BLACK, 3)?;
            if let Some(label) = &tick.label {
                let baseline = rect.bottom + TICK_GAP + CAPITAL * TICK;
                canvas.text(label, (x, baseline), Type::new(TICK, Colour::BLACK, Side::Middle))?;
            }
        }
        for tick in &plot.y.ticks.ticks {
            let y = self.frame.up(plot.y.share_of_shown(tick.at));
            let end = rect.left - length(&tick.label);
            canvas.line(&[(rect.left, y), (end, y)], Colour::BLACK, 3)?;
            if let Some(label) = &tick.label {
                let baseline = (rect.left - TICK_GAP, y + CAPITAL * TICK / 2.0);
                canvas.text(label, baseline, Type::new(TICK, Colour::BLACK, Side::End))?;
            }
        }
        self.axis_names(marks)
    }

    fn axis_names(&self, marks: &MarkLabels) -> Result<()> {
        let (canvas, rect, plot) = (self.canvas, self.rect, self.plot);
        let face = Type::new(LABEL, Colour::BLACK, Side::Middle);
        let top = rect.bottom + TICK_GAP + TICK * LINE + 10.0;
        let middle = ((rect.left + rect.right) / 2.0, (rect.top + rect.bottom) / 2.0);
        canvas.lines(&plot.x_label(rect.width()), (middle.0, top), LABEL * LINE, face)?;
        let baseline = rect.left - plot.left() + 10.0 + CAPITAL * LABEL;
        for (index, line) in plot.y_label.iter().enumerate() {
            let across = baseline + index as f64 * LABEL * LINE;
            canvas.upward(line, (across, middle.1), face)?;
        }
        let factor = |exponent: i32| format!("×{}", text::power_of_ten(exponent));
        if let Some(exponent) = plot.x.ticks.factor {
            let place = (rect.right, top + CAPITAL * TICK);
            canvas.text(&factor(exponent), place, Type::new(TICK, Colour::BLACK, Side::End))?;
        }
        if let Some(exponent) = plot.y.ticks.factor {
            let place = (rect.left, rect.top - marks.height - 18.0);
            canvas.text(&factor(exponent), place, Type::new(TICK, Colour::BLACK, Side::Start))?;
        }
        Ok(())
    }

    pub(crate) fn heading(&self, marks: &MarkLabels) -> Result<()> {
        let top = self.rect.top - self.plot.above(marks) + 4.0;
        let face = Type { bold: true, ..Type::new(LABEL, Colour::BLACK, Side::Start) };
        if self.plot.heading.is_empty() {
            return Ok(());
        }
        self.canvas.text(&self.plot.heading, (self.rect.left, top + CAPITAL * LABEL), face)
    }
}
