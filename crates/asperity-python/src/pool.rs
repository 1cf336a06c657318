//! The threads that share out long loops.

use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The pool, and the process it belongs to.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Runs work whose loops are then shared out to all cores (or to `RAYON_NUM_THREADS`).
///
/// Not on rayon's global pool: a process that was forked, as by `multiprocessing`, has its pool but
/// not its threads, and would wait for them forever.
pub(crate) fn on_all_cores<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match pool() {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// None where no threads can be made.
fn pool() -> Option<Arc<ThreadPool>> {
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    match &*held {
        Some((owner, pool)) if *owner == process => Some(pool.clone()),
        _ => {
            let pool = Arc::new(ThreadPoolBuilder::new().build().ok()?);
            let before = held.replace((process, pool.clone()));
            // Its threads are in another process: there is nobody to be told to end.
            std::mem::forget(before);
            Some(pool)
        }
    }
}
