//! Long loops without the interpreter: on all cores, in order, and interruptible by Ctrl-C.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::convert::error::value_error;

/// Approximate time between two checks for signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);
/// Most rows in memory between two checks for signals.
const MOST_ROWS: usize = 1 << 18;

/// Runs `work` on ranges that cover 0..len until it returns false, and checks for signals between
/// them. The first range has `first` rows.
pub(crate) fn in_blocks(
    py: Python<'_>,
    len: usize,
    first: usize,
    mut work: impl FnMut(Range<usize>) -> PyResult<bool>,
) -> PyResult<()> {
    let (mut start, mut size) = (0, first);
    while start < len {
        let end = len.min(start + size);
        let begun = Instant::now();
        let go_on = work(start..end)?;
        py.check_signals()?;
        if !go_on {
            break;
        }
        start = end;
        match begun.elapsed() {
            short if short < SIGNAL_INTERVAL => size = MOST_ROWS.min(2 * size),
            long if long > 4 * SIGNAL_INTERVAL => size = first.max(size / 2),
            _ => {}
        }
    }
    Ok(())
}

/// The pool of this process, and the process it belongs to.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// A pool of `threads`, or of one thread for every core (or `RAYON_NUM_THREADS`).
///
/// Not rayon's global pool: a forked process, as of `multiprocessing`, inherits that pool without
/// its threads, and would wait for them forever.
pub(crate) fn pool(threads: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    let build = |threads| {
        let built = ThreadPoolBuilder::new().num_threads(threads).build();
        built.map(Arc::new).map_err(value_error)
    };
    if let Some(threads) = threads {
        return build(threads);
    }
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    match &*held {
        Some((owner, pool)) if *owner == process => Ok(pool.clone()),
        _ => {
            let pool = build(0)?;
            // The threads of the previous pool belong to another process: dropping it would wait
            // for them.
            std::mem::forget(held.replace((process, pool.clone())));
            Ok(pool)
        }
    }
}

/// Runs stretches of `together` rows on all threads of a pool; `take` gets the results in order,
/// until it returns false. The bounds of stretches do not depend on time or threads.
pub(crate) fn run_stretches<S: Send>(
    py: Python<'_>,
    pool: &ThreadPool,
    len: usize,
    together: usize,
    run: impl Fn(Range<usize>) -> S + Sync,
    mut take: impl FnMut(S) -> PyResult<bool>,
) -> PyResult<()> {
    in_blocks(py, len, 2 * together, |range| {
        let starts: Vec<usize> = range.clone().step_by(together).collect();
        let stretch = |start: &usize| run(*start..range.end.min(start + together));
        let found: Vec<S> = py.detach(|| pool.install(|| starts.par_iter().map(stretch).collect()));
        for one in found {
            if !take(one)? {
                return Ok(false);
            }
        }
        Ok(true)
    })
}

/// Runs `work` on the threads of this process while this thread, which gets the signals, checks for
/// them; a signal sets the flag that stops `work`.
pub(crate) fn run_interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    let (stop, threads) = (AtomicBool::new(false), pool(None)?);
    let run = |done: Sender<T>| {
        // The receiver waits until the work ends.
        let _ = done.send(threads.install(|| work(&stop)));
    };
    let wait = |answer: Receiver<T>| {
        let mut raised = None;
        loop {
            match answer.recv_timeout(SIGNAL_INTERVAL) {
                Ok(answer) => return raised.map_or(Ok(answer), Err),
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the solver has panicked"));
                }
                Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                    raised = Python::attach(|py| py.check_signals()).err();
                    stop.store(raised.is_some(), Ordering::Relaxed);
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    };
    py.detach(|| {
        std::thread::scope(|scope| {
            let (done, answer) = channel();
            scope.spawn(|| run(done));
            wait(answer)
        })
    })
}

/// Continues until the flag is set.
pub(crate) fn continue_unless(stop: &AtomicBool) -> ControlFlow<()> {
    if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}
