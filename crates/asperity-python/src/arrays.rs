//! Long loops without the interpreter: on all cores, in order, and open to Ctrl-C.

use std::time::{Duration, Instant};

use pyo3::prelude::*;
use rayon::prelude::*;

use crate::pool::on_all_cores;

/// How many values are handed to a thread at a time: single evaluations, or whole scenes.
#[derive(Clone, Copy)]
pub(crate) enum Grain {
    Values,
    Scenes,
}

impl Grain {
    fn together(self) -> usize {
        match self {
            Self::Values => 512,
            Self::Scenes => 8,
        }
    }

    /// Fewer than this are evaluated on the calling thread: handing them out costs more.
    fn parallel_from(self) -> usize {
        4 * self.together()
    }

    /// Values before the first look at signals.
    fn first_look(self) -> usize {
        16 * self.together()
    }
}

/// Between two looks twice as many values are computed, as long as looks are this near.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Runs `work` on ranges that cover 0..len, without the interpreter, and looks at signals between.
pub(crate) fn in_ranges(
    py: Python<'_>,
    len: usize,
    grain: Grain,
    mut work: impl FnMut(std::ops::Range<usize>) -> PyResult<()>,
) -> PyResult<()> {
    let (mut start, mut size) = (0, grain.first_look());
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
    grain: Grain,
    one: impl Fn(usize) -> Result<T, E> + Sync,
    raise: impl Fn(usize, E) -> PyErr,
) -> PyResult<Vec<T>>
where
    T: Clone + Default + Send,
    E: Send,
{
    let mut out = vec![T::default(); len];
    let together = grain.together();
    in_ranges(py, len, grain, |range| {
        let first = range.start;
        let part = &mut out[range];
        let fill = |(k, chunk): (usize, &mut [T])| {
            let first = first + k * together;
            for (j, place) in chunk.iter_mut().enumerate() {
                *place = one(first + j).map_err(|error| (first + j, error))?;
            }
            Ok(())
        };
        let found = py.detach(|| {
            if part.len() < grain.parallel_from() {
                return part.chunks_mut(together).enumerate().try_for_each(fill);
            }
            // Every chunk goes to its end or to its first error; then the first of those counts.
            on_all_cores(|| {
                let errors = part.par_chunks_mut(together).enumerate().map(fill);
                errors.filter_map(Result::err).min_by_key(|(k, _)| *k).map_or(Ok(()), Err)
            })
        });
        found.map_err(|(k, error)| raise(k, error))
    })?;
    Ok(out)
}
