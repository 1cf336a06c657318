//! Work on all cores, in order, on platforms with threads.

#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// From 2048 rows on, threads get runs of 512; fewer rows cost more in threads than alone.
pub(crate) const MANY: (usize, usize) = (2048, 512);

/// The columns that `f` returns for runs of items, joined in order: `least` items or more are
/// handed out in runs of `length`, fewer are left to the calling thread.
pub(crate) fn columns<T: Sync, R: Send>(
    items: &[T],
    (least, length): (usize, usize),
    f: impl Fn(&[T]) -> Vec<Vec<R>> + Sync + Send,
) -> Vec<Vec<R>> {
    if items.len() < least {
        return f(items);
    }
    let join = |mut all: Vec<Vec<R>>, run: Vec<Vec<R>>| {
        all.iter_mut().zip(run).for_each(|(column, more)| column.extend(more));
        all
    };
    map_runs(items, length, |run| vec![f(run)]).into_iter().reduce(join).unwrap_or_default()
}

/// The results of `f` for runs of `length` items, joined in order.
pub fn map_runs<T: Sync, R: Send>(
    items: &[T],
    length: usize,
    f: impl Fn(&[T]) -> Vec<R> + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    return items.par_chunks(length).flat_map_iter(f).collect();
    #[cfg(not(feature = "rayon"))]
    items.chunks(length).flat_map(f).collect()
}
