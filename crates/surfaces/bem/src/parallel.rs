//! Passes over maps on all cores whose digits do not depend on how many there are.
//!
//! A map is cut into chunks of one fixed length; a chunk is summed by one thread, and the sums of
//! the chunks are added in their order. This file alone knows of threads.

/// Numbers in a chunk: large against the price of a task, small against the second-level cache.
const CHUNK: usize = 4096;
/// Sums that run side by side in a chunk, so that an addition need not wait for the last one.
const LANES: usize = 8;

/// Runs of tasks for each thread, so that one that is late delays the others little.
#[cfg(feature = "rayon")]
const RUNS: usize = 4;

/// The results of `f` for each task, in order; `scratch` is made once for every run of tasks.
pub(crate) fn map<T: Send, S, R: Send>(
    tasks: impl Iterator<Item = T>,
    scratch: impl Fn() -> S + Sync,
    f: impl Fn(&mut S, T) -> R + Sync,
) -> Vec<R> {
    let mut slots: Vec<(Option<T>, Option<R>)> = tasks.map(|task| (Some(task), None)).collect();
    let run = |slots: &mut [(Option<T>, Option<R>)]| {
        let mut scratch = scratch();
        for (task, result) in slots {
            *result = task.take().map(|task| f(&mut scratch, task));
        }
    };
    #[cfg(feature = "rayon")]
    halves(&mut slots, RUNS * rayon::current_num_threads(), &run);
    #[cfg(not(feature = "rayon"))]
    run(&mut slots);
    slots.into_iter().filter_map(|(_, result)| result).collect()
}

/// Hands out `runs` runs of the slots, half of them to other threads that are free.
#[cfg(feature = "rayon")]
fn halves<T: Send>(slots: &mut [T], runs: usize, run: &(dyn Fn(&mut [T]) + Sync)) {
    if runs < 2 || slots.len() < 2 {
        return run(slots);
    }
    let (first, second) = slots.split_at_mut(slots.len() / 2);
    join(&mut || halves(first, runs / 2, run), &mut || halves(second, runs - runs / 2, run));
}

/// Both at the same time. Not generic: the pool's code is compiled once, not for every pass.
#[cfg(feature = "rayon")]
pub(crate) fn join(first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send)) {
    rayon::join(first, second);
}

/// Both, one after the other.
#[cfg(not(feature = "rayon"))]
pub(crate) fn join(first: &mut dyn FnMut(), second: &mut dyn FnMut()) {
    first();
    second();
}

/// `f` inside the pool: from outside, each of its passes would wait for a thread to wake.
#[cfg(feature = "rayon")]
pub(crate) fn inside<R: Send>(f: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| f())
}

/// `f` on the calling thread.
#[cfg(not(feature = "rayon"))]
pub(crate) fn inside<R>(f: impl FnOnce() -> R) -> R {
    f()
}

/// The sums over all pixels of the `K` terms that `term` makes of the maps' numbers there.
pub(crate) fn sum<const N: usize, const K: usize>(
    maps: [&[f64]; N],
    term: impl Fn([f64; N]) -> [f64; K] + Sync,
) -> [f64; K] {
    reduce(maps, [0.0; K], |sum, numbers| add(sum, term(numbers)), add)
}

/// The fold of all pixels, beginning with `zero` in every lane; `join` puts the lanes
/// and chunks together.
pub(crate) fn reduce<const N: usize, T: Copy + Send + Sync>(
    maps: [&[f64]; N],
    zero: T,
    fold: impl Fn(T, [f64; N]) -> T + Sync,
    join: impl Fn(T, T) -> T + Sync,
) -> T {
    let len = maps.first().map_or(0, |map| map.len());
    let chunk = |chunk: usize| {
        let maps = maps.map(|map| map[chunk * CHUNK..len.min((chunk + 1) * CHUNK)].as_chunks());
        let mut lanes = [zero; LANES];
        // Blocks of known length need no checks inside.
        for at in 0..maps[0].0.len() {
            let here: [&[f64; LANES]; N] = std::array::from_fn(|map| &maps[map].0[at]);
            for (lane, total) in lanes.iter_mut().enumerate() {
                *total = fold(*total, std::array::from_fn(|map| here[map][lane]));
            }
        }
        for (at, total) in (0..maps[0].1.len()).zip(&mut lanes) {
            *total = fold(*total, std::array::from_fn(|map| maps[map].1[at]));
        }
        lanes.into_iter().fold(zero, &join)
    };
    let chunks = map(0..len.div_ceil(CHUNK), || (), |(), number| chunk(number));
    chunks.into_iter().fold(zero, &join)
}

/// Changes every number of `map`: `each` gets it and the numbers of the other maps there, and
/// returns `K` terms, which are summed.
pub(crate) fn update<const N: usize, const K: usize>(
    map: &mut [f64],
    others: [&[f64]; N],
    each: impl Fn(&mut f64, [f64; N]) -> [f64; K] + Sync,
) -> [f64; K] {
    let len = map.len();
    let chunk = |(chunk, numbers): (usize, &mut [f64])| {
        let others = others.map(|map| map[chunk * CHUNK..len.min((chunk + 1) * CHUNK)].as_chunks());
        let mut lanes = [[0.0; K]; LANES];
        let (blocks, rest) = numbers.as_chunks_mut::<LANES>();
        for (at, numbers) in blocks.iter_mut().enumerate() {
            let here: [&[f64; LANES]; N] = std::array::from_fn(|map| &others[map].0[at]);
            for (lane, (number, total)) in numbers.iter_mut().zip(&mut lanes).enumerate() {
                *total = add(*total, each(number, std::array::from_fn(|map| here[map][lane])));
            }
        }
        for (at, (number, total)) in rest.iter_mut().zip(&mut lanes).enumerate() {
            *total = add(*total, each(number, std::array::from_fn(|map| others[map].1[at])));
        }
        lanes.into_iter().fold([0.0; K], add)
    };
    let chunks = self::map(map.chunks_mut(CHUNK).enumerate(), || (), |(), task| chunk(task));
    chunks.into_iter().fold([0.0; K], add)
}

/// 1 for yes, 0 for no: a factor where a branch would go either way at random.
pub(crate) fn number(yes: bool) -> f64 {
    f64::from(u8::from(yes))
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
        let numbers: Vec<f64> = (0..50_003).map(|i| f64::from(i).sin()).collect();
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| sum([&numbers], |[x]| [x, x.powi(2)]))
        };
        assert_eq!(on(1).map(f64::to_bits), on(3).map(f64::to_bits));
    }

    #[test]
    fn every_number_is_visited_once() {
        for len in [0, 1, LANES - 1, LANES, CHUNK, 3 * CHUNK + 2 * LANES + 5] {
            let places: Vec<f64> = (0..len).map(|i| i as f64).collect();
            let mut numbers = vec![0.5; len];
            let [count] = update(&mut numbers, [&places], |number, [place]| {
                *number += place;
                [1.0]
            });
            assert_eq!(count as usize, len);
            let wrong = numbers.iter().zip(&places).filter(|(a, b)| (*a - *b - 0.5).abs() > 0.0);
            assert_eq!(wrong.count(), 0);
            let [total] = sum([&numbers, &places], |[number, place]| [number - place]);
            assert_eq!((2.0 * total) as usize, len);
            let most = reduce([&places], -1.0, |most, [place]| f64::max(most, place), f64::max);
            assert_eq!((most + 1.0) as usize, len);
        }
    }
}
