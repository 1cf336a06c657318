//! Progress of long work, and the wish to end it.

use std::ops::ControlFlow;

/// Watches long work: a terminal, a notebook or a worker of the page.
pub trait Watch {
    /// What is done now: a model, a load of many.
    fn progress(&self, doing: &str) {
        let _ = doing;
    }

    /// Whether the work is to end; what is done by then is returned.
    fn is_stopped(&self) -> bool {
        false
    }

    /// One step of the work: whether to go on.
    fn step(&self, doing: &str) -> ControlFlow<()> {
        self.progress(doing);
        if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Shows nothing and never ends the work.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Watch for Silent {}
