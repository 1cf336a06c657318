//! Flow through a map of conductivities, by elimination of its pixels.
//!
//! A pixel that is taken out of a network leaves its neighbours connected to each other: c_ij grows
//! by c_ik c_kj/Σ_j c_kj. Nothing is subtracted, so that every conductance keeps its digits however
//! far the conductivities are apart, and nothing is iterated. Nested dissection orders the pixels:
//! a block is cut by a line of pixels, which is taken out after both halves are.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};

use crate::parallel::join;

/// Pixels in a block that is not cut.
const SMALL: usize = 32;
/// Pixels that are taken out in one pass over the others.
const PANEL: usize = 16;

/// Pixels between an inlet before the first column and an outlet behind the last one.
pub(crate) struct Network {
    /// Row after row; 0 in closed pixels.
    pub(crate) conductivities: Vec<f64>,
    pub(crate) shape: [usize; 2],
    /// Height and width of a pixel.
    pub(crate) pixel: [f64; 2],
    /// Whether the first row follows the last one; otherwise nothing flows through these sides.
    pub(crate) periodic: bool,
}

#[derive(Clone)]
struct Block {
    rows: Range<usize>,
    columns: Range<usize>,
}

/// Conductances between pixels, and to the inlet and the outlet behind them: the upper triangle of
/// a matrix.
#[derive(Default)]
struct Links {
    /// Pixels to be taken out, sorted.
    inner: Vec<usize>,
    /// Their neighbours outside the block and those of its parts, sorted.
    outer: Vec<usize>,
    numbers: Vec<f64>,
}

impl Links {
    fn side(&self) -> usize {
        self.inner.len() + self.outer.len() + 2
    }

    fn place(&self, pixel: usize) -> Option<usize> {
        let outer = || self.outer.binary_search(&pixel).map(|at| self.inner.len() + at);
        self.inner.binary_search(&pixel).or_else(|_| outer()).ok()
    }

    fn add(&mut self, [one, other]: [usize; 2], conductance: f64) {
        let side = self.side();
        self.numbers[one.min(other) * side + one.max(other)] += conductance;
    }

    /// The conductances from a place to those behind it.
    fn row(&self, place: usize) -> &[f64] {
        let side = self.side();
        &self.numbers[place * side + place + 1..(place + 1) * side]
    }

    fn eliminate(&mut self) {
        let (side, count) = (self.side(), self.inner.len());
        dispatch!(Level::new(), simd => simd.vectorize(
            #[inline(always)]
            || eliminate(&mut self.numbers, side, count),
        ));
    }

    /// The shares of inlet and outlet in the pressures of the pixels that were taken out, from
    /// those of the outer pixels.
    fn fill(&self, shares: &mut [[f64; 2]]) {
        for (place, pixel) in self.inner.iter().enumerate().rev() {
            let others = self.inner[place + 1..].iter().chain(&self.outer).map(|at| shares[*at]);
            let others = others.chain([[1.0, 0.0], [0.0, 1.0]]);
            let mut sums = [0.0; 3];
            for (link, [inlet, outlet]) in self.row(place).iter().zip(others) {
                let terms = [link * inlet, link * outlet, *link];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            }
            let [inlet, outlet, total] = sums;
            if total > 0.0 {
                shares[*pixel] = [inlet / total, outlet / total];
            }
        }
    }
}

impl Network {
    /// The flows through inlet and outlet at a unit difference of pressure; 0 where no path of open
    /// pixels connects them.
    ///
    /// Both come from the pressures on the line that is taken out last, and neither is a small
    /// difference of large numbers.
    pub(crate) fn flows(&self) -> [f64; 2] {
        let mut last = self.assembled(&self.all());
        let faces = |links: &Links, place: usize| match links.row(place) {
            [.., inlet, outlet] => [*inlet, *outlet],
            _ => [0.0; 2],
        };
        let before: Vec<[f64; 2]> = (0..last.inner.len()).map(|k| faces(&last, k)).collect();
        let direct = last.row(last.side() - 2)[0];
        last.eliminate();
        let mut shares = vec![[0.0; 2]; self.conductivities.len()];
        last.fill(&mut shares);
        let mut flows = [direct; 2];
        for (pixel, links) in last.inner.iter().zip(before) {
            let [inlet, outlet] = shares[*pixel];
            flows[0] += links[0] * outlet;
            flows[1] += links[1] * inlet;
        }
        flows
    }

    /// Pressures at a unit difference as the shares of inlet and outlet, whose sum is 1; both are 0
    /// in pixels that are connected to neither.
    pub(crate) fn shares(&self) -> Vec<[f64; 2]> {
        let mut shares = vec![[0.0; 2]; self.conductivities.len()];
        self.fill(&self.all(), &mut shares);
        shares
    }

    /// From the last line down: every block is reduced again, about twice the work of the flow
    /// alone.
    fn fill(&self, block: &Block, shares: &mut [[f64; 2]]) {
        let mut links = self.assembled(block);
        links.eliminate();
        links.fill(shares);
        self.cut(block).1.iter().for_each(|part| self.fill(part, shares));
    }

    /// The flows to the right and downward out of every pixel at a unit difference of pressure; out
    /// of the last column those to the outlet.
    pub(crate) fn edge_flows(&self) -> Vec<[f64; 2]> {
        let (shares, columns) = (self.shares(), self.shape[1]);
        let flow = |at: usize, (other, conductance): (usize, f64)| {
            let ([a, b], [c, d]) = (shares[at], shares[other]);
            // The difference of the smaller shares has more digits.
            conductance * if a + c < b + d { a - c } else { d - b }
        };
        let of = |at: usize| {
            let [_, below, _, right] = self.edges(at);
            let right = match right {
                Some(right) => flow(at, right),
                None if at % columns + 1 == columns => self.to_faces(at)[1] * shares[at][0],
                None => 0.0,
            };
            [right, below.map_or(0.0, |below| flow(at, below))]
        };
        (0..shares.len()).map(of).collect()
    }

    fn all(&self) -> Block {
        Block { rows: 0..self.shape[0], columns: 0..self.shape[1] }
    }

    /// The lines that cut a block, and the parts that they leave.
    fn cut(&self, block: &Block) -> (Vec<Block>, Vec<Block>) {
        let Block { rows, columns } = block;
        let with_rows = |rows| Block { rows, columns: columns.clone() };
        let with_columns = |columns| Block { rows: rows.clone(), columns };
        if rows.len() * columns.len() <= SMALL {
            return (vec![block.clone()], vec![]);
        }
        if columns.len() >= rows.len() {
            let middle = columns.start + columns.len() / 2;
            let parts = [columns.start..middle, middle + 1..columns.end];
            return (vec![with_columns(middle..middle + 1)], parts.map(with_columns).into());
        }
        // A ring is cut twice.
        let ring = self.periodic && rows.len() == self.shape[0];
        let start = rows.start + usize::from(ring);
        let middle = rows.start + rows.len() / 2;
        let lines = [rows.start..start, middle..middle + 1];
        (lines.map(with_rows).into(), [start..middle, middle + 1..rows.end].map(with_rows).into())
    }

    /// The links of a block whose parts are taken out, before its lines are.
    fn assembled(&self, block: &Block) -> Links {
        let (lines, parts) = self.cut(block);
        let mut reduced = [Links::default(), Links::default()];
        if let ([one, other], [first, second]) = (&parts[..], &mut reduced) {
            let reduce = |links: &mut Links, part: &Block| {
                *links = self.assembled(part);
                links.eliminate();
            };
            join(&mut || reduce(first, one), &mut || reduce(second, other));
        }
        let columns = self.shape[1];
        let pixels = |line: &Block| -> Vec<usize> {
            let rows = line.rows.clone().map(|i| i * columns);
            let all = rows.flat_map(|row| line.columns.clone().map(move |j| row + j));
            all.filter(|at| self.conductivities[*at] > 0.0).collect()
        };
        let is_inside = |at: &usize| {
            block.rows.contains(&(at / columns)) && block.columns.contains(&(at % columns))
        };
        let inner: Vec<usize> = lines.iter().flat_map(pixels).collect();
        let beside = inner.iter().flat_map(|at| self.edges(*at).into_iter().flatten());
        let beside = beside.map(|(other, _)| other).filter(|at| !is_inside(at));
        let mut outer: Vec<usize> = beside.collect();
        outer.extend(reduced.iter().flat_map(|part| &part.outer));
        outer.retain(|at| inner.binary_search(at).is_err());
        outer.sort_unstable();
        outer.dedup();
        let mut links = Links { inner, outer, numbers: vec![] };
        let side = links.side();
        let faces = [side - 2, side - 1];
        links.numbers = vec![0.0; side * side];
        for part in reduced.iter().filter(|_| !parts.is_empty()) {
            let places = part.outer.iter().filter_map(|at| links.place(*at)).chain(faces);
            let places: Vec<usize> = places.collect();
            for (k, one) in places.iter().enumerate() {
                for (other, link) in places[k + 1..].iter().zip(part.row(part.inner.len() + k)) {
                    links.add([*one, *other], *link);
                }
            }
        }
        for place in 0..links.inner.len() {
            let pixel = links.inner[place];
            for (other, conductance) in self.edges(pixel).into_iter().flatten() {
                // A neighbour in a part brought this edge, a line has it once.
                let found =
                    links.place(other).filter(|at| *at >= links.inner.len() || other > pixel);
                found.into_iter().for_each(|found| links.add([place, found], conductance));
            }
            for (face, conductance) in faces.into_iter().zip(self.to_faces(pixel)) {
                links.add([place, face], conductance);
            }
        }
        links
    }

    /// The open neighbours of a pixel above, below, left and right, with the conductances to them.
    fn edges(&self, at: usize) -> [Option<(usize, f64)>; 4] {
        let ([rows, columns], [height, width]) = (self.shape, self.pixel);
        let (i, j) = (at / columns, at % columns);
        let row = |inside: bool, other: usize| {
            (inside || self.periodic).then_some((other % rows * columns + j, width / height))
        };
        let column = |inside: bool, other: usize| inside.then_some((other, height / width));
        let [above, below] = [row(i > 0, i + rows - 1), row(i + 1 < rows, i + 1)];
        let [left, right] = [column(j > 0, at.wrapping_sub(1)), column(j + 1 < columns, at + 1)];
        [above, below, left, right].map(|edge| {
            let (other, factor) = edge?;
            let [a, b] = [at, other].map(|at| self.conductivities[at]);
            // The harmonic mean, without a product that may be too small.
            (a > 0.0 && b > 0.0).then(|| (other, 2.0 * factor * a / (1.0 + a / b)))
        })
    }

    /// The conductances from a pixel to the inlet and to the outlet.
    fn to_faces(&self, at: usize) -> [f64; 2] {
        let (columns, [height, width]) = (self.shape[1], self.pixel);
        let half = 2.0 * self.conductivities[at] * height / width;
        [0, columns - 1].map(|face| if at % columns == face { half } else { 0.0 })
    }
}

/// Takes out the first `count` of `side` nodes of a network.
#[inline(always)]
fn eliminate(links: &mut [f64], side: usize, count: usize) {
    let mut weights = vec![[[0.0; 4]; PANEL / 4]; side];
    for start in (0..count).step_by(PANEL) {
        let end = count.min(start + PANEL);
        let (panel, others) = links.split_at_mut(end * side);
        let panel = &mut panel[start * side..];
        weights.fill([[0.0; 4]; PANEL / 4]);
        for k in 0..end - start {
            let (done, later) = panel.split_at_mut((k + 1) * side);
            let row = &done[k * side..];
            let first = start + k + 1;
            let total: f64 = row[first..].iter().sum();
            let share = if total > 0.0 { 1.0 / total } else { 0.0 };
            for (weights, link) in weights[first..].iter_mut().zip(&row[first..]) {
                weights[k / 4][k % 4] = link * share;
            }
            for (i, target) in (first..).zip(later.chunks_mut(side)) {
                let weight = weights[i][k / 4][k % 4];
                let links = target[i + 1..].iter_mut().zip(&row[i + 1..]);
                links.for_each(|(link, other)| *link += weight * other);
            }
        }
        // Two rows at a time read the panel once; the last row has no links of its own.
        for (i, targets) in (end..side).step_by(2).zip(others.chunks_exact_mut(2 * side)) {
            let (first, second) = targets.split_at_mut(side);
            let groups = weights[i].iter().zip(&weights[i + 1]);
            for ((of_first, of_second), rows) in groups.zip(panel.chunks(4 * side)) {
                if [*of_first, *of_second] == [[0.0; 4]; 2] {
                    continue;
                }
                // Of the rows that a short panel lacks, the weight is 0.
                let row = |k: usize| &rows[(k * side).min(rows.len() - side)..][i + 1..side];
                let [a, b, c, d] = [row(0), row(1), row(2), row(3)];
                let sum = |weights: &[f64; 4], [a, b, c, d]: [f64; 4]| {
                    (weights[0] * a + weights[1] * b) + (weights[2] * c + weights[3] * d)
                };
                first[i + 1] += sum(of_first, [a[0], b[0], c[0], d[0]]);
                let targets = first[i + 2..].iter_mut().zip(&mut second[i + 2..]);
                let others = a[1..].iter().zip(&b[1..]).zip(c[1..].iter().zip(&d[1..]));
                for ((first, second), ((a, b), (c, d))) in targets.zip(others) {
                    *first += sum(of_first, [*a, *b, *c, *d]);
                    *second += sum(of_second, [*a, *b, *c, *d]);
                }
            }
        }
    }
}
