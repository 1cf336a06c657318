//! Passes over arrays on all cores whose digits do not depend on how many there are.
//!
//! An array is cut into chunks of one fixed length; a chunk is summed by one thread, and the sums
//! of the chunks are added in their order.

use std::ops::Range;

use rayon::prelude::*;

/// Numbers in a chunk: large against the price of a task, small against the second-level cache.
const CHUNK: usize = 4096;

/// `part` of every chunk of `0..len`, joined in order.
pub(crate) fn reduce<T: Send>(
    len: usize,
    part: impl Fn(Range<usize>) -> T + Sync,
    join: impl Fn(T, T) -> T,
) -> Option<T> {
    let parts: Vec<T> = (0..len.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| part(chunk * CHUNK..len.min((chunk + 1) * CHUNK)))
        .collect();
    parts.into_iter().reduce(join)
}

/// The sums over `0..len` of the `K` numbers that `term` makes of an index.
pub(crate) fn sum<const K: usize>(len: usize, term: impl Fn(usize) -> [f64; K] + Sync) -> [f64; K] {
    let part = |range: Range<usize>| add_up(range.map(&term));
    reduce(len, part, add).unwrap_or([0.0; K])
}

/// Sets every number of `array`: `each` gets its index and the number, and returns `K` terms, which
/// are summed.
pub(crate) fn update<const K: usize>(
    array: &mut [f64],
    each: impl Fn(usize, &mut f64) -> [f64; K] + Sync,
) -> [f64; K] {
    let parts: Vec<[f64; K]> = array
        .par_chunks_mut(CHUNK)
        .enumerate()
        .map(|(chunk, numbers)| {
            let numbered = (chunk * CHUNK..).zip(numbers);
            add_up(numbered.map(|(i, number)| each(i, number)))
        })
        .collect();
    parts.into_iter().fold([0.0; K], add)
}

fn add_up<const K: usize>(terms: impl Iterator<Item = [f64; K]>) -> [f64; K] {
    terms.fold([0.0; K], add)
}

fn add<const K: usize>(mut sum: [f64; K], term: [f64; K]) -> [f64; K] {
    for (sum, term) in sum.iter_mut().zip(term) {
        *sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digits_do_not_depend_on_the_number_of_threads() {
        let numbers: Vec<f64> = (0..50_000).map(|i| f64::from(i).sin()).collect();
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| sum(numbers.len(), |i| [numbers[i], numbers[i].powi(2)]))
        };
        assert_eq!(on(1).map(f64::to_bits), on(3).map(f64::to_bits));
    }

    #[test]
    fn every_number_is_visited_once() {
        let mut numbers = vec![0.0; 3 * CHUNK + 5];
        let [count] = update(&mut numbers, |i, number| {
            *number += i as f64;
            [1.0]
        });
        assert_eq!(count as usize, numbers.len());
        assert!(
            numbers.iter().enumerate().all(|(i, &number)| number.to_bits() == (i as f64).to_bits())
        );
        assert_eq!(reduce(0, |_| 1, |a, b| a + b), None);
    }
}
