//! Long work without the interpreter: on all cores, in order, and interruptible by Ctrl-C.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use asperity_answer::Watch;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::convert::value_error;

/// Time between two checks for signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);

/// The pool of this process, and the process it belongs to.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// A pool of one thread for every core (or `RAYON_NUM_THREADS`).
///
/// Not rayon's global pool: a forked process, as of `multiprocessing`, inherits that pool without
/// its threads, and would wait for them forever.
fn pool() -> PyResult<Arc<ThreadPool>> {
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    match &*held {
        Some((owner, pool)) if *owner == process => Ok(pool.clone()),
        _ => {
            let pool = ThreadPoolBuilder::new().build().map(Arc::new).map_err(value_error)?;
            // The threads of the previous pool belong to another process: dropping it would wait
            // for them.
            std::mem::forget(held.replace((process, pool.clone())));
            Ok(pool)
        }
    }
}

/// Long work that Ctrl-C ends.
#[derive(Default)]
pub(crate) struct Interrupt(AtomicBool);

impl Watch for Interrupt {
    fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Runs `work` on the threads of this process, while this thread, which gets the signals, checks
/// for them; a signal stops `work`.
pub(crate) fn run_interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&Interrupt) -> T + Send,
) -> PyResult<T> {
    let stop = Interrupt::default();
    if rayon::current_thread_index().is_some() {
        // The law of a user asks: waiting would block the thread that is to work.
        return Ok(py.detach(|| work(&stop)));
    }
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
                    stop.0.store(raised.is_some(), Ordering::Relaxed);
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    };
    let pool = pool()?;
    py.detach(|| {
        pool.in_place_scope(|scope| {
            let (done, answer) = channel();
            // The receiver waits until the work ends.
            let stop = &stop;
            scope.spawn(move |_| drop(done.send(work(stop))));
            wait(answer)
        })
    })
}

/// Runs stretches of `together` rows on all threads; the results are in order, to the first that
/// `ends` the run. The bounds of stretches do not depend on time or threads.
pub(crate) fn run_stretches<S: Send>(
    py: Python<'_>,
    (len, together): (usize, usize),
    run: impl Fn(Range<usize>) -> S + Sync,
    ends: impl Fn(&S) -> bool + Sync,
) -> PyResult<Vec<S>> {
    let stretch = |k: usize| run(k * together..len.min((k + 1) * together));
    if len <= together {
        // Waking threads takes longer than a few rows.
        return Ok(py.detach(|| vec![stretch(0)]));
    }
    let last = AtomicUsize::new(usize::MAX);
    run_interruptible(py, |stop| {
        let one = |k: usize| {
            if stop.is_stopped() || k > last.load(Ordering::Relaxed) {
                return None;
            }
            let found = stretch(k);
            if ends(&found) {
                last.fetch_min(k, Ordering::Relaxed);
            }
            Some(found)
        };
        let all: Vec<_> = (0..len.div_ceil(together)).into_par_iter().map(one).collect();
        let last = last.load(Ordering::Relaxed);
        all.into_iter().take(last.saturating_add(1)).flatten().collect()
    })
}
