//! Work on all cores, in order, where there are threads.

/// Fewer rows than this are answered on the calling thread: handing them out costs more.
#[cfg(feature = "rayon")]
const FROM: usize = 2048;

/// What `f` makes of each item, in order.
#[cfg(feature = "rayon")]
pub(crate) fn map<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::prelude::*;
    if items.len() < FROM {
        return items.iter().map(f).collect();
    }
    items.par_iter().with_min_len(512).map(f).collect()
}

/// What `f` makes of each run of `length` items, joined in order.
#[cfg(feature = "rayon")]
pub(crate) fn map_runs<T: Sync, R: Send>(
    items: &[T],
    length: usize,
    f: impl Fn(&[T]) -> Vec<R> + Sync + Send,
) -> Vec<R> {
    use rayon::prelude::*;
    items.par_chunks(length).flat_map_iter(f).collect()
}

/// Both, at the same time where there are threads.
#[cfg(feature = "rayon")]
pub(crate) fn both<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    rayon::join(a, b)
}

#[cfg(not(feature = "rayon"))]
pub(crate) fn map<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    items.iter().map(f).collect()
}

#[cfg(not(feature = "rayon"))]
pub(crate) fn map_runs<T: Sync, R: Send>(
    items: &[T],
    length: usize,
    f: impl Fn(&[T]) -> Vec<R> + Sync + Send,
) -> Vec<R> {
    items.chunks(length).flat_map(f).collect()
}

#[cfg(not(feature = "rayon"))]
pub(crate) fn both<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    (a(), b())
}
