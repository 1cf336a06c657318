//! Flow through a map of conductivities, by elimination of its pixels, without iterations.
//!
//! Nested dissection orders the pixels: a block is cut by a line of pixels, which is taken out
//! after both halves are. The sides of the map are nodes of their own, half a pixel outside: an
//! inlet, an outlet, or where the map meets itself. So the four quarters between the middle row and
//! the middle column, which are most of the work, are reduced once for flows in both directions.

use std::fmt;
use std::ops::Range;
use std::sync::OnceLock;

use crate::front::{Front, Part};
use crate::parallel::{join, map};

/// Pixels in a block that is not cut.
const SMALL: usize = 64;

/// A direction of flow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Along the rows of the map, from its first column to its last.
    X,
    /// Along its columns, from its first row to its last.
    Y,
}

impl Direction {
    /// Both.
    pub const ALL: [Self; 2] = [Self::X, Self::Y];
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(if *self == Self::X { "x" } else { "y" })
    }
}

/// Pixels, and the nodes on the four sides of the map: above the first row, below the last, left of
/// the first column and right of the last.
pub(crate) struct Network {
    /// Row after row; 0 in closed pixels.
    conductivities: Vec<f64>,
    shape: [usize; 2],
    /// Height and width of a pixel.
    pixel: [f64; 2],
    /// Whether sides along the flow meet each other; otherwise nothing flows through them.
    periodic: bool,
    /// The place of each node in the order in which they are taken out.
    ranks: Vec<usize>,
    /// The quarters, taken out.
    parts: OnceLock<Vec<Part>>,
}

#[derive(Clone)]
struct Block {
    rows: Range<usize>,
    columns: Range<usize>,
}

/// The network of a flow in one direction, with its quarters taken out.
struct Joint {
    /// Of all nodes the places in the order, equal for nodes that are one in this direction; inlet
    /// and outlet are the last two.
    names: Vec<usize>,
    /// The halves beside the middle line across the flow, taken out.
    halves: Vec<Front>,
    /// That line, not yet taken out, with the parts of the halves, and inlet and outlet outside.
    last: Front,
}

impl Network {
    pub(crate) fn new(
        conductivities: Vec<f64>,
        shape: [usize; 2],
        pixel: [f64; 2],
        periodic: bool,
    ) -> Self {
        let mut network =
            Self { conductivities, shape, pixel, periodic, ranks: vec![], parts: OnceLock::new() };
        let mut order = vec![];
        network.quarters().iter().for_each(|quarter| network.order(quarter, &mut order));
        let [above, below, left, right] = network.sides();
        let [row, column] = Direction::ALL.map(|along| network.middle_line(along));
        order.extend(row.chain(above).chain(below).chain(column).chain(left).chain(right));
        network.ranks = vec![usize::MAX; network.nodes()];
        for (rank, node) in order.into_iter().enumerate() {
            // The middle row and column cross.
            network.ranks[node] = network.ranks[node].min(rank);
        }
        network
    }

    pub(crate) fn conductivities(&self) -> &[f64] {
        &self.conductivities
    }

    fn nodes(&self) -> usize {
        self.conductivities.len() + 2 * (self.shape[0] + self.shape[1])
    }

    fn sides(&self) -> [Range<usize>; 4] {
        let ([rows, columns], mut start) = (self.shape, self.conductivities.len());
        [columns, columns, rows, rows].map(|length| {
            start += length;
            start - length..start
        })
    }

    /// The line of pixels in the middle of the map along a direction.
    fn middle_line(&self, along: Direction) -> impl Iterator<Item = usize> + use<> {
        let [rows, columns] = self.shape;
        let (start, step, count) = match along {
            Direction::X => (rows / 2 * columns, 1, columns),
            Direction::Y => (columns / 2, columns, rows),
        };
        (0..count).map(move |k| start + k * step)
    }

    /// Upper left, upper right, lower left, lower right.
    fn quarters(&self) -> [Block; 4] {
        let [[above, below], [left, right]] =
            self.shape.map(|count| [0..count / 2, count / 2 + 1..count]);
        let block = |rows: &Range<usize>, columns: &Range<usize>| Block {
            rows: rows.clone(),
            columns: columns.clone(),
        };
        [block(&above, &left), block(&above, &right), block(&below, &left), block(&below, &right)]
    }

    fn order(&self, block: &Block, order: &mut Vec<usize>) {
        let (line, parts) = block.cut();
        parts.iter().flatten().for_each(|part| self.order(part, order));
        order.extend(line.pixels(self.shape[1]));
    }

    /// A block whose parts are taken out, before its line is.
    fn assembled(&self, block: &Block) -> Front {
        let (line, parts) = block.cut();
        let columns = self.shape[1];
        let open = line.pixels(columns).filter(|at| self.conductivities[*at] > 0.0).collect();
        let Some([one, other]) = parts else {
            return self.front(open, vec![], &self.ranks, []);
        };
        let [mut first, mut second] = [None, None];
        join(&mut || first = Some(self.reduced(&one)), &mut || second = Some(self.reduced(&other)));
        self.front(open, vec![], &self.ranks, [&first, &second].map(Option::as_ref))
    }

    fn reduced(&self, block: &Block) -> Part {
        let mut front = self.assembled(block);
        front.eliminate();
        front.part()
    }

    /// A front from which `inner` will be eliminated, assembled from the parts beside it; `names`
    /// are the places of nodes in the order.
    fn front<const N: usize>(
        &self,
        inner: Vec<usize>,
        mut outer: Vec<usize>,
        names: &[usize],
        parts: [Option<&Part>; N],
    ) -> Front {
        let last = inner.last().map_or(0, |node| names[*node]);
        let beside = inner.iter().flat_map(|node| self.edges(*node)).flatten();
        outer.extend(beside.map(|(other, _)| other));
        outer.extend(parts.iter().flatten().flat_map(|part| &part.outer));
        // Nodes that come before are taken out.
        outer.retain(|node| names[*node] > last);
        outer.sort_unstable_by_key(|node| names[*node]);
        outer.dedup_by_key(|node| names[*node]);
        let mut front = Front::new(inner, outer, N == 0);
        let first = front.inner.first().map_or(0, |node| names[*node]);
        let place = |front: &Front, node: usize| {
            let name = names[node];
            let count = front.inner.len();
            // Without closed pixels the names are in a row.
            let guess = name.wrapping_sub(first);
            if front.inner.get(guess).is_some_and(|node| names[*node] == name) {
                return Some(guess);
            }
            if name <= last {
                return front.inner.binary_search_by_key(&name, |node| names[*node]).ok();
            }
            let found = front.outer.binary_search_by_key(&name, |node| names[*node]);
            found.ok().map(|at| count + at)
        };
        for part in parts.into_iter().flatten() {
            let places: Vec<usize> =
                part.outer.iter().filter_map(|node| place(&front, *node)).collect();
            front.add_part(part, &places);
        }
        for at in 0..front.inner.len() {
            for (other, conductance) in self.edges(front.inner[at]).into_iter().flatten() {
                // Edges to nodes of a part came with it; those inside the line are added once.
                let found = place(&front, other).filter(|other| *other > at);
                found.into_iter().for_each(|found| front.add([at, found], conductance));
            }
        }
        front
    }

    /// The open neighbours of a pixel above, below, left and right, with the conductances to them,
    /// or nodes on the sides of the map. A side itself brings no edges.
    fn edges(&self, at: usize) -> [Option<(usize, f64)>; 4] {
        let ([rows, columns], [height, width]) = (self.shape, self.pixel);
        let Some(here) = self.conductivities.get(at).filter(|here| **here > 0.0) else {
            return [None; 4];
        };
        let (i, j) = (at / columns, at % columns);
        let [above, below, left, right] = self.sides();
        let edge = |other: Option<usize>, side: usize, factor: f64| match other {
            None => Some((side, 2.0 * factor * here)),
            Some(other) => {
                let there = self.conductivities[other];
                // The harmonic mean, without a product that may be too small.
                (there > 0.0).then(|| (other, 2.0 * factor * here / (1.0 + here / there)))
            }
        };
        [
            edge(at.checked_sub(columns), above.start + j, width / height),
            edge((i + 1 < rows).then_some(at + columns), below.start + j, width / height),
            edge((j > 0).then(|| at.wrapping_sub(1)), left.start + i, height / width),
            edge((j + 1 < columns).then_some(at + 1), right.start + i, height / width),
        ]
    }

    /// The network between inlet and outlet once both halves beside the middle line across the flow
    /// are taken out.
    fn joint(&self, along: Direction) -> Joint {
        let reduced = |(): &mut (), block| self.reduced(&block);
        let parts = self.parts.get_or_init(|| map(self.quarters().into_iter(), || (), reduced));
        let [above, below, left, right] = self.sides();
        let (across, sides, faces, [first, second]) = match along {
            Direction::X => (Direction::Y, [above, below], [left, right], [[0, 2], [1, 3]]),
            Direction::Y => (Direction::X, [left, right], [above, below], [[0, 1], [2, 3]]),
        };
        let (length, middle) = (sides[0].len(), sides[0].len() / 2);
        let (mut names, mut next) = (self.ranks.clone(), self.conductivities.len());
        let mut named = |mut nodes: Vec<usize>, places: Range<usize>| {
            for node in &nodes {
                names[*node] = next;
                next += 1;
            }
            nodes.retain(|node| self.conductivities[*node] > 0.0);
            for k in places {
                let [one, other] = [&sides[0], &sides[1]].map(|side| side.start + k);
                names[one] = next;
                next += usize::from(!self.periodic);
                names[other] = next;
                next += 1;
                nodes.push(one);
                nodes.extend((!self.periodic).then_some(other));
            }
            nodes
        };
        let line: Vec<usize> = self.middle_line(along).collect();
        let inner = [0..middle, middle + 1..length];
        let [one, other] = inner.map(|half| named(line[half.clone()].to_vec(), half));
        let last = named(self.middle_line(across).collect(), middle..middle + 1);
        let outer: Vec<usize> = faces.iter().map(|face| face.start).collect();
        for face in faces {
            names[face].fill(next);
            next += 1;
        }
        let half = |inner: &Vec<usize>, quarters: [usize; 2]| {
            let quarters = quarters.map(|quarter| parts.get(quarter));
            let mut front = self.front(inner.clone(), vec![], &names, quarters);
            front.eliminate();
            front
        };
        let halves = [(&one, first), (&other, second)];
        let halves = map(halves.into_iter(), || (), |(), (inner, parts)| half(inner, parts));
        let [first, second] = [0, 1].map(|k| halves.get(k).map(Front::part));
        let last = self.front(last, outer, &names, [first.as_ref(), second.as_ref()]);
        Joint { names, halves, last }
    }

    /// The flows through inlet and outlet at a unit difference of pressure; 0 where no path of open
    /// pixels connects them.
    ///
    /// Both come from the pressures on the line that is taken out last, and neither is a small
    /// difference of large numbers.
    pub(crate) fn flows(&self, along: Direction) -> [f64; 2] {
        let mut joint = self.joint(along);
        let last = &joint.last;
        let faces = |place: usize| match last.row(place) {
            [.., inlet, outlet] => [*inlet, *outlet],
            _ => [0.0; 2],
        };
        let before: Vec<[f64; 2]> = (0..last.inner.len()).map(faces).collect();
        let direct = last.row(last.inner.len())[0];
        joint.last.eliminate();
        let shares = joint.shares();
        let mut flows = [direct; 2];
        for (node, links) in joint.last.inner.iter().zip(before) {
            let [inlet, outlet] = shares[joint.names[*node]];
            flows[0] += links[0] * outlet;
            flows[1] += links[1] * inlet;
        }
        flows
    }

    /// The flows out of every pixel upward, downward, to the left and to the right at a unit
    /// difference of pressure; every block is reduced again, about twice the work of a flow alone.
    pub(crate) fn pixel_flows(&self, along: Direction) -> Vec<[f64; 4]> {
        let mut joint = self.joint(along);
        joint.last.eliminate();
        let (mut shares, names) = (joint.shares(), &joint.names);
        joint.halves.iter().for_each(|half| half.fill(names, &mut shares));
        self.quarters().iter().for_each(|quarter| self.fill(quarter, names, &mut shares));
        let flow = |at: usize, (other, conductance): (usize, f64)| {
            let ([a, b], [c, d]) = (shares[names[at]], shares[names[other]]);
            // The difference of the smaller shares has more digits.
            conductance * if a + c < b + d { a - c } else { d - b }
        };
        let of = |at: usize| self.edges(at).map(|edge| edge.map_or(0.0, |edge| flow(at, edge)));
        (0..self.conductivities.len()).map(of).collect()
    }

    /// Adds the shares of the nodes of a block, from the line that was taken out last to the first.
    fn fill(&self, block: &Block, names: &[usize], shares: &mut [[f64; 2]]) {
        let mut front = self.assembled(block);
        front.eliminate();
        front.fill(names, shares);
        block.cut().1.iter().flatten().for_each(|part| self.fill(part, names, shares));
    }
}

impl Joint {
    /// Pressures at a unit difference as the shares of inlet and outlet, by name, on the line that
    /// was taken out last; both are 0 in nodes that are connected to neither.
    fn shares(&self) -> Vec<[f64; 2]> {
        let outer = &self.last.outer;
        let count = outer.last().map_or(0, |outlet| self.names[*outlet] + 1);
        let mut shares = vec![[0.0; 2]; count];
        for (face, share) in outer.iter().zip([[1.0, 0.0], [0.0, 1.0]]) {
            shares[self.names[*face]] = share;
        }
        self.last.fill(&self.names, &mut shares);
        shares
    }
}

impl Block {
    /// The line that cuts a block, and the parts that it leaves; all of a small block.
    fn cut(&self) -> (Self, Option<[Self; 2]>) {
        let Self { rows, columns } = self;
        let with_rows = |rows| Self { rows, columns: columns.clone() };
        let with_columns = |columns| Self { rows: rows.clone(), columns };
        if rows.len() * columns.len() <= SMALL {
            return (self.clone(), None);
        }
        let halves = |all: &Range<usize>| {
            let middle = all.start + all.len() / 2;
            (middle..middle + 1, [all.start..middle, middle + 1..all.end])
        };
        if columns.len() >= rows.len() {
            let (line, parts) = halves(columns);
            return (with_columns(line), Some(parts.map(with_columns)));
        }
        let (line, parts) = halves(rows);
        (with_rows(line), Some(parts.map(with_rows)))
    }

    fn pixels(&self, columns: usize) -> impl Iterator<Item = usize> + use<> {
        let line = self.columns.clone();
        self.rows.clone().flat_map(move |i| line.clone().map(move |j| i * columns + j))
    }
}
