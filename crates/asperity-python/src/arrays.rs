//! Long loops without the interpreter: on all cores, in order, and open to Ctrl-C.

use std::time::{Duration, Instant};

use pyo3::prelude::*;
use rayon::prelude::*;

/// Fewer values than this are evaluated on the calling thread: handing them out costs more.
const PARALLEL_FROM: usize = 2048;
/// Values handed to a thread at a time.
const TOGETHER: usize = 512;
/// Values before the first look at signals; twice as many from one look to the next, as long as
/// looks are this near to each other.
const FIRST_LOOK: usize = 8192;
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Runs `work` on ranges that cover 0..len, without the interpreter, and looks at signals between.
pub(crate) fn in_ranges(
    py: Python<'_>,
    len: usize,
    mut work: impl FnMut(std::ops::Range<usize>) -> PyResult<()>,
) -> PyResult<()> {
    let (mut start, mut size) = (0, FIRST_LOOK);
    while start < len {
        let end = len.min(start + size);
        let begun = Instant::now();
        work(start..end)?;
        py.check_signals()?;
        if begun.elapsed() < BETWEEN_LOOKS {
            size *= 2;
        }
        start = end;
    }
    Ok(())
}

/// `one` of every index, in order. The error is that of the first index that has one, whatever
/// the number of threads.
pub(crate) fn collect<T, E>(
    py: Python<'_>,
    len: usize,
    one: impl Fn(usize) -> Result<T, E> + Sync,
    raise: impl Fn(usize, E) -> PyErr,
) -> PyResult<Vec<T>>
where
    T: Copy + Default + Send,
    E: Send,
{
    let mut out = vec![T::default(); len];
    in_ranges(py, len, |range| {
        let first = range.start;
        let part = &mut out[range];
        let fill = |(k, chunk): (usize, &mut [T])| {
            let first = first + k * TOGETHER;
            for (j, place) in chunk.iter_mut().enumerate() {
                *place = one(first + j).map_err(|error| (first + j, error))?;
            }
            Ok(())
        };
        let found = py.detach(|| {
            if part.len() < PARALLEL_FROM {
                return part.chunks_mut(TOGETHER).enumerate().try_for_each(fill);
            }
            // Every chunk goes to its end or to its first error; then the first of those counts.
            let errors = part.par_chunks_mut(TOGETHER).enumerate().map(fill);
            errors.filter_map(Result::err).min_by_key(|(k, _)| *k).map_or(Ok(()), Err)
        });
        found.map_err(|(k, error)| raise(k, error))
    })?;
    Ok(out)
}
