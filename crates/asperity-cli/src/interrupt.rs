//! Ctrl-C: a long run stops and keeps the results so far; pressed twice, the program ends.

use std::ops::ControlFlow;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};
use asperity::bem::Progress;

use crate::output::print_message;

static ASKED: AtomicBool = AtomicBool::new(false);
/// The exit code of a program that Ctrl-C has ended.
const ENDED: i32 = 130;

/// Whether the user has asked to stop.
pub fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Ends the program after an interrupted list, whose results so far are written.
pub fn end(done: usize, all: usize) -> ! {
    print_message("error", &format!("interrupted: {done} of {all} loads are solved"));
    process::exit(ENDED)
}

/// Reports progress until the user asks to stop.
pub fn watch(
    mut report: impl FnMut(&Progress),
) -> Result<impl FnMut(&Progress) -> ControlFlow<()>> {
    let handler = || {
        if ASKED.swap(true, Ordering::Relaxed) {
            process::exit(ENDED);
        }
    };
    match ctrlc::set_handler(handler) {
        // It is set already: by the list before.
        Ok(()) | Err(ctrlc::Error::MultipleHandlers) => {}
        Err(error) => return Err(error).context("Ctrl-C cannot be watched"),
    }
    Ok(move |progress: &Progress| {
        report(progress);
        if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
}
