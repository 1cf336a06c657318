//! Ctrl-C: a long run stops and keeps the results so far; pressed twice, the program ends.

use std::cell::RefCell;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};
use asperity_answer::Watch;
use indicatif::ProgressBar;

use crate::output::{print_error, progress};

static REQUESTED: AtomicBool = AtomicBool::new(false);
/// The exit code of a program that Ctrl-C has ended.
const ENDED: i32 = 130;

/// Whether the user has requested to stop.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}

/// Ends the program after an interrupted list, whose results so far are written; `state` describes
/// the rows that are done.
pub fn end_with(state: &str) -> ! {
    print_error(&format!("interrupted: {state}"));
    process::exit(ENDED)
}

/// Makes Ctrl-C a request to stop; pressed twice, it ends the program.
pub fn listen() -> Result<()> {
    let handler = || {
        if REQUESTED.swap(true, Ordering::Relaxed) {
            process::exit(ENDED);
        }
    };
    match ctrlc::set_handler(handler) {
        // The handler is already set by an earlier list.
        Ok(()) | Err(ctrlc::Error::MultipleHandlers) => Ok(()),
        Err(error) => Err(error).context("Ctrl-C cannot be watched"),
    }
}

/// Shows the progress of an answer on a terminal, and ends it on Ctrl-C.
#[derive(Default)]
pub struct Terminal(RefCell<Option<ProgressBar>>);

impl Watch for Terminal {
    fn progress(&self, doing: &str) {
        match &mut *self.0.borrow_mut() {
            Some(bar) => bar.set_message(doing.to_string()),
            hidden => *hidden = Some(progress(doing)),
        }
    }

    fn is_stopped(&self) -> bool {
        requested()
    }
}
