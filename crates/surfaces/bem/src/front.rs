//! Elimination of nodes from a part of a network of conductances.
//!
//! A node that is taken out leaves its neighbours connected to each other: c_ij grows by
//! c_ik c_kj/Σ_j c_kj. Nothing is subtracted, so that every conductance keeps its digits however
//! far they are apart.

use fearless_simd::{Level, Simd, dispatch};

/// Nodes that are taken out in one pass over the others.
const PANEL: usize = 32;
/// Rows and columns that are changed together, in registers.
const TILE: [usize; 2] = [4, 8];
/// Nodes to be taken out from which on passes are worth their preparation.
const MANY: usize = 12;

/// Conductances between the nodes of a part of a network, above the diagonal of a matrix; below it
/// stands nothing.
pub(crate) struct Front {
    /// Nodes to be taken out, in this order.
    pub(crate) inner: Vec<usize>,
    /// Their neighbours that stay, and the neighbours of the parts within.
    pub(crate) outer: Vec<usize>,
    /// Whether each node is connected to few others.
    is_sparse: bool,
    /// A multiple of the columns of a tile, as the number of rows is of its rows.
    stride: usize,
    numbers: Vec<f64>,
}

/// What is left of a part of a network: conductances between its outer nodes, without those that
/// were between them before.
pub(crate) struct Part {
    pub(crate) outer: Vec<usize>,
    /// Above the diagonal, row after row.
    numbers: Vec<f64>,
}

impl Front {
    pub(crate) fn new(inner: Vec<usize>, outer: Vec<usize>, is_sparse: bool) -> Self {
        let [rows, stride] = TILE.map(|tile| (inner.len() + outer.len()).next_multiple_of(tile));
        Self { inner, outer, is_sparse, stride, numbers: vec![0.0; rows * stride] }
    }

    fn side(&self) -> usize {
        self.inner.len() + self.outer.len()
    }

    /// Connects two places; one to itself is no connection.
    pub(crate) fn add(&mut self, [one, other]: [usize; 2], conductance: f64) {
        if one != other {
            self.numbers[one.min(other) * self.stride + one.max(other)] += conductance;
        }
    }

    /// Adds a part whose outer nodes have these places.
    pub(crate) fn add_part(&mut self, part: &Part, places: &[usize]) {
        // Most places follow each other.
        let runs: Vec<&[usize]> = places.chunk_by(|one, next| one + 1 == *next).collect();
        let (mut rest, mut passed) = (&part.numbers[..], 0);
        let mut runs = &runs[..];
        for (k, place) in places.iter().enumerate() {
            let (row, others) = rest.split_at(places.len() - 1 - k);
            rest = others;
            if let Some((first, more)) = runs.split_first()
                && passed + first.len() == k
            {
                (passed, runs) = (k, more);
            }
            let mut row = row;
            for (number, run) in runs.iter().enumerate() {
                let run = if number == 0 { &run[k + 1 - passed..] } else { run };
                let Some(first) = run.first() else { continue };
                let (links, more) = row.split_at(run.len());
                row = more;
                if first > place {
                    let targets = &mut self.numbers[place * self.stride + first..];
                    targets.iter_mut().zip(links).for_each(|(target, link)| *target += link);
                } else {
                    run.iter()
                        .zip(links)
                        .for_each(|(other, link)| self.add([*place, *other], *link));
                }
            }
        }
    }

    /// The conductances from a place to those behind it.
    pub(crate) fn row(&self, place: usize) -> &[f64] {
        &self.numbers[place * self.stride..][place + 1..self.side()]
    }

    pub(crate) fn eliminate(&mut self) {
        let (stride, side, count) = (self.stride, self.side(), self.inner.len());
        let by_panels = !self.is_sparse && count >= MANY;
        dispatch!(Level::new(), simd => simd.vectorize(
            #[inline(always)]
            || match by_panels {
                true => eliminate_by_panels(&mut self.numbers, stride, side, count),
                false => {
                    take_out(&mut self.numbers, stride, side, 0..count);
                }
            },
        ));
    }

    /// What the elimination left.
    pub(crate) fn part(&self) -> Part {
        let count = self.outer.len();
        let mut numbers = Vec::with_capacity(count * count.saturating_sub(1) / 2);
        (self.inner.len()..self.side()).for_each(|at| numbers.extend_from_slice(self.row(at)));
        Part { outer: self.outer.clone(), numbers }
    }

    /// After the elimination: the shares of inlet and outlet in the pressures of the nodes that
    /// were taken out, from the shares of the outer ones; all by the names of nodes.
    pub(crate) fn fill(&self, names: &[usize], shares: &mut [[f64; 2]]) {
        for (place, node) in self.inner.iter().enumerate().rev() {
            let others = self.inner[place + 1..].iter().chain(&self.outer);
            let mut sums = [0.0; 3];
            for (link, other) in self.row(place).iter().zip(others) {
                let [inlet, outlet] = shares[names[*other]];
                let terms = [link * inlet, link * outlet, *link];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            }
            let [inlet, outlet, total] = sums;
            if total > 0.0 {
                shares[names[*node]] = [inlet / total, outlet / total];
            }
        }
    }
}

/// Takes out the nodes `which`, and changes the other nodes in `numbers`, which may be fewer than
/// `side`. Returns 1/Σ_j c_kj of each.
#[inline(always)]
fn take_out(
    numbers: &mut [f64],
    stride: usize,
    side: usize,
    which: std::ops::Range<usize>,
) -> [f64; PANEL] {
    let mut shares = [0.0; PANEL];
    let start = which.start;
    for k in which {
        let (done, later) = numbers.split_at_mut((k + 1) * stride);
        let row = &done[k * stride..][..side];
        let total = sum(&row[k + 1..]);
        let share = if total > 0.0 { 1.0 / total } else { 0.0 };
        if let Some(kept) = shares.get_mut(k - start) {
            *kept = share;
        }
        for (i, target) in (k + 1..side).zip(later.chunks_exact_mut(stride)) {
            let weight = row[i] * share;
            if weight > 0.0 {
                let links = target[i + 1..side].iter_mut().zip(&row[i + 1..]);
                links.for_each(|(link, other)| *link += weight * other);
            }
        }
    }
    shares
}

/// The sum of numbers, in lanes.
#[inline(always)]
fn sum(numbers: &[f64]) -> f64 {
    let (blocks, rest) = numbers.as_chunks::<8>();
    let mut lanes = [0.0; 8];
    for block in blocks {
        lanes.iter_mut().zip(block).for_each(|(lane, number)| *lane += number);
    }
    lanes.iter().sum::<f64>() + rest.iter().sum::<f64>()
}

/// Takes out the first `count` of `side` nodes.
#[inline(always)]
fn eliminate_by_panels(numbers: &mut [f64], stride: usize, side: usize, count: usize) {
    const ROWS: usize = TILE[0];
    const COLUMNS: usize = TILE[1];
    let mut weights = vec![[[0.0; ROWS]; PANEL]; side.div_ceil(ROWS)];
    let mut links = vec![[[0.0; COLUMNS]; PANEL]; stride / COLUMNS];
    for start in (0..count).step_by(PANEL) {
        let end = count.min(start + PANEL);
        let shares = take_out(&mut numbers[..end * stride], stride, side, start..end);
        // Copies the panel tile by tile; eliminated nodes and missing rows are 0.
        let [first_row, first_column] = TILE.map(|tile| end / tile);
        weights[first_row..].fill([[0.0; ROWS]; PANEL]);
        links[first_column..].fill([[0.0; COLUMNS]; PANEL]);
        for (k, (row, share)) in
            numbers[start * stride..end * stride].chunks_exact(stride).zip(shares).enumerate()
        {
            for (i, link) in (end..side).zip(&row[end..side]) {
                weights[i / ROWS][k][i % ROWS] = link * share;
                links[i / COLUMNS][k][i % COLUMNS] = *link;
            }
        }
        let rows = numbers.chunks_exact_mut(ROWS * stride).zip(&weights).enumerate();
        for (at, (rows, weights)) in rows.skip(first_row) {
            if !weights.as_flattened().iter().any(|weight| *weight > 0.0) {
                continue;
            }
            let column = at * ROWS / COLUMNS;
            let mut rows = rows.chunks_exact_mut(stride);
            let mut row =
                || rows.next().map_or(&mut [][..], |row| row.as_chunks_mut::<COLUMNS>().0);
            let [a, b, c, d] = [row(), row(), row(), row()];
            let tiles = a.iter_mut().zip(b).zip(c.iter_mut().zip(d)).zip(&links);
            for (((a, b), (c, d)), links) in tiles.skip(column) {
                let mut tile = [[0.0; COLUMNS]; ROWS];
                for (weights, links) in weights.iter().zip(links) {
                    for (row, weight) in tile.iter_mut().zip(weights) {
                        row.iter_mut().zip(links).for_each(|(sum, link)| *sum += weight * link);
                    }
                }
                for (row, tile) in [a, b, c, d].into_iter().zip(tile) {
                    row.iter_mut().zip(tile).for_each(|(link, more)| *link += more);
                }
            }
        }
    }
}
