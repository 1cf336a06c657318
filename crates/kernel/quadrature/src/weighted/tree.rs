//! Groups of panels, and groups of groups: far from the kinks of a law, a group counts as twenty
//! points.

use super::panel::{Panel, Shape};
use crate::chebyshev::lobatto::{NODES, Samples, lobatto};
use crate::rules::legendre::legendre;

/// Points of the rule on one panel.
const POINTS: usize = 32;
/// Number of halvings of a panel beside an end.
const HALVINGS: u32 = 10;
/// A part smaller than its neighbour by this (in logarithms) is negligible.
const NOTHING: f64 = 45.0;

/// A panel, or two neighbouring groups of them.
#[derive(Debug)]
pub(crate) struct Node {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// ∫ g ℓⱼ of Lagrange's polynomials ℓⱼ over the points of [`lobatto`] on [low, high]: the
    /// integral of the weight g times a polynomial is a sum over the points. `None` where the
    /// weight varies too much.
    pub(crate) weights: Option<Samples>,
    /// Error of the weights, relative to their sum.
    pub(crate) error: f64,
    /// Roughly the logarithm of the largest weight.
    pub(crate) peak: f64,
    pub(crate) parts: Parts,
}

#[derive(Debug, Clone, Copy)]
pub(crate) enum Parts {
    /// The index of a panel.
    Panel(usize),
    /// The indices of two groups.
    Groups(usize, usize),
}

/// The groups, the root last.
pub(crate) fn tree(panels: &[Panel]) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(2 * panels.len());
    group(panels, 0, panels.len(), &mut nodes);
    nodes
}

/// Adds the groups of the panels from..to, and returns the index of the largest.
fn group(panels: &[Panel], from: usize, to: usize, nodes: &mut Vec<Node>) -> usize {
    let node = if to - from == 1 {
        leaf(&panels[from], from)
    } else {
        // Halves as even as the panels allow, neither empty.
        let middle = 0.5 * (panels[from].low + panels[to - 1].high);
        let at = from + panels[from..to].partition_point(|p| p.low < middle);
        let near = |k: usize| (panels[k].low - middle).abs();
        let at = if at > from + 1 && (at >= to || near(at - 1) < near(at)) { at - 1 } else { at };
        let at = at.clamp(from + 1, to - 1);
        let left = group(panels, from, at, nodes);
        let right = group(panels, at, to, nodes);
        both(nodes, left, right)
    };
    nodes.push(node);
    nodes.len() - 1
}

fn leaf(panel: &Panel, place: usize) -> Node {
    let (low, high) = (panel.low, panel.high);
    let width = panel.width();
    let ends = [0.0, 0.5, 1.0].map(|share| panel.ln(share * width));
    // An infinite or zero end does not count.
    let finite = ends.into_iter().filter(|ln| *ln < f64::INFINITY);
    let peak = finite.fold(f64::NEG_INFINITY, f64::max);
    let weights = match &panel.shape {
        Shape::Zero => Some([0.0; NODES]),
        Shape::Linear([near, far]) => {
            let [below, above] = &lobatto().linear;
            let (below, above) = if panel.side > 0.0 { (below, above) } else { (above, below) };
            Some(std::array::from_fn(|j| width * (near * below[j] + far * above[j])))
        }
        Shape::Series(_) => panel.is_gentle().then(|| {
            let mut weights = [0.0; NODES];
            let mut add = |share: f64, mass: f64| {
                let at = if panel.side > 0.0 { share } else { 1.0 - share };
                let mass = mass * width * panel.weight(share * width, 0.0);
                weights.iter_mut().zip(&lobatto().basis(at)).for_each(|(w, b)| *w += mass * b);
            };
            let rule = legendre(POINTS);
            let nodes = || rule.nodes.iter().zip(&rule.weights);
            // The map v^power makes a power of the distance smooth and everything else steep, so it
            // serves a small share of the panel only.
            let (mut top, power) = (1.0, panel.map_power());
            for _ in 0..power.map_or(0, |_| HALVINGS) {
                nodes().for_each(|(v, w)| add(top * (0.5 + 0.5 * v), 0.5 * top * w));
                top *= 0.5;
            }
            let power = power.unwrap_or(1.0);
            for (v, w) in nodes() {
                let share = top * v.powf(power);
                add(share, w * power * share / v);
            }
            weights
        }),
    };
    Node { low, high, weights, error: panel.error, peak, parts: Parts::Panel(place) }
}

fn both(nodes: &[Node], left: usize, right: usize) -> Node {
    let (a, b) = (&nodes[left], &nodes[right]);
    let (low, high) = (a.low, b.high);
    let peak = a.peak.max(b.peak);
    let mut weights = Some([0.0; NODES]);
    let (mut off, mut mass) = (0.0, 0.0);
    for part in [a, b] {
        let Some(own) = &part.weights else {
            if part.peak > peak - NOTHING {
                weights = None;
            }
            continue;
        };
        let own_mass: f64 = own.iter().sum();
        off += part.error * own_mass;
        mass += own_mass;
        let Some(weights) = &mut weights else { continue };
        if own_mass == 0.0 {
            continue;
        }
        for (node, own) in lobatto().nodes.iter().zip(own) {
            let at = (part.low - low + (part.high - part.low) * node) / (high - low);
            let basis = lobatto().basis(at);
            weights.iter_mut().zip(&basis).for_each(|(w, b)| *w += own * b);
        }
    }
    let error = if mass > 0.0 { off / mass } else { 0.0 };
    Node { low, high, weights, error, peak, parts: Parts::Groups(left, right) }
}
