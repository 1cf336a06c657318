//! Panels cut at the kinks of a density, into strips with maps that suit panel and density.

use super::panel::{MAP_POWER, Panel};
use super::run::Run;
use super::strip::{Map, Strip, View};
use crate::{Piece, QuadratureError, WeightFault};

/// Ratio of the ends of a strip for a density of unknown form.
const RATIO: f64 = 4.0;
/// An end farther away than this number of widths needs no map.
const FAR: f64 = 3.0;
/// Far out, the logarithm changes by at most this over a strip,
const STEP: f64 = 8.0;
/// and a strip smaller than this share, in logarithms, is negligible.
const LN_NOTHING: f64 = -50.0;
/// A weight that needs more samples of the density before bisection is refused.
const ENOUGH: usize = 1_000_000;

/// A place as z and as x: kinks are exact in x.
#[derive(Debug, Clone, Copy)]
struct CutPoint {
    z: f64,
    x: f64,
}

impl<'a> Run<'a> {
    /// Cuts a panel at the kinks of the density.
    pub(super) fn panel(&mut self, panel: &'a Panel) -> Result<(), QuadratureError> {
        let begin = if panel.low >= self.start {
            CutPoint { z: panel.low, x: self.x(panel.low) }
        } else {
            CutPoint { z: self.start, x: self.integrand.kinks[0] }
        };
        let end = CutPoint { z: panel.high, x: self.x(panel.high) };
        let integrand = self.integrand;
        let from = integrand.kinks.partition_point(|kink| *kink <= begin.x);
        let inside = integrand.kinks[from..].iter().take_while(|kink| **kink < end.x);
        let gentle = panel.is_gentle();
        let mut left = begin;
        for &x in inside {
            let right = CutPoint { z: self.view.d + x * self.view.unit, x };
            self.piece(panel, left, right, gentle)?;
            left = right;
        }
        self.piece(panel, left, end, gentle)
    }

    /// A panel between two kinks.
    fn piece(
        &mut self,
        panel: &'a Panel,
        left: CutPoint,
        right: CutPoint,
        gentle: bool,
    ) -> Result<(), QuadratureError> {
        if right.z <= left.z {
            return Ok(());
        }
        if self.integrand.density.active(left.x, right.x).next().is_none() {
            return Ok(());
        }
        if gentle {
            return self.ends(panel, left, right);
        }
        // Far out: the larger part first; negligible parts are left out.
        let mut parts = vec![(left, right)];
        while let Some((left, right)) = parts.pop() {
            let middle = CutPoint { z: 0.5 * (left.z + right.z), x: 0.5 * (left.x + right.x) };
            let ln = [left, middle, right].map(|place| panel.ln(panel.distance(place.z)));
            let most = ln.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let least = ln.iter().copied().fold(f64::INFINITY, f64::min);
            if most == f64::NEG_INFINITY {
                continue;
            }
            let (mut scratch, mut q) = ([0.0; 2], [0.0; 2]);
            let x = [middle.x, middle.x + 0.5 * (right.x - middle.x)];
            self.found.evaluations +=
                self.integrand.density.sample((left.x, right.x), &x, &mut scratch, &mut q)?;
            let q = q[0].abs().max(q[1].abs());
            let left_over = most - self.view.ln_scale + (q * (right.z - left.z)).ln();
            if self.found.sizes[0] > 0.0 && left_over < self.found.sizes[0].ln() + LN_NOTHING {
                continue;
            }
            if self.found.evaluations > ENOUGH {
                return Err(self.weight.source.fault(WeightFault::Wild { at: middle.z }));
            }
            let divisible = middle.z > left.z && middle.z < right.z;
            if most - least <= STEP || !divisible {
                self.ends(panel, left, right)?;
            } else if ln[0] > ln[2] {
                parts.extend([(middle, right), (left, middle)]);
            } else {
                parts.extend([(left, middle), (middle, right)]);
            }
        }
        Ok(())
    }

    /// Strips with maps for the powers that panel and density have at their ends.
    fn ends(
        &mut self,
        panel: &'a Panel,
        left: CutPoint,
        right: CutPoint,
    ) -> Result<(), QuadratureError> {
        let View { d, unit, .. } = self.view;
        let width = right.z - left.z;
        let density = &self.integrand.density;
        let mut origins = density.active(left.x, right.x).map(|piece: &Piece| piece.origin);
        let first = origins.next().flatten();
        let known = first.filter(|_| origins.all(|origin| origin == first));
        let kinks = &self.integrand.kinks;
        let kink = kinks.partition_point(|kink| *kink <= left.x).checked_sub(1).map(|k| kinks[k]);
        let begin = known.or(kink).unwrap_or(left.x).min(left.x);
        let to_begin = (left.x - begin) * unit;
        let to_anchor = panel.distance(left.z);
        if let Some(power) = panel.map_power() {
            let anchor = (panel.anchor - d) / unit;
            if panel.side < 0.0 {
                if to_begin < FAR * width && panel.distance(right.z) < FAR * width {
                    // Powers at both ends.
                    let middle = CutPoint { z: left.z + 0.5 * width, x: 0.5 * (left.x + right.x) };
                    if middle.z > left.z && middle.z < right.z && to_begin < 0.5 * width {
                        let smooth = Map {
                            x: begin,
                            u: panel.distance(d + begin * unit),
                            side: 1.0,
                            span: to_begin + 0.5 * width,
                            power: MAP_POWER,
                            smooth: false,
                        };
                        self.strip(panel, smooth, to_begin, (left.x, middle.x))?;
                        return self.down(panel, anchor, power, middle, right);
                    }
                }
                return self.down(panel, anchor, power, left, right);
            }
            if to_anchor <= to_begin && to_anchor < FAR * width {
                let span = panel.distance(right.z);
                let map = Map { x: anchor, u: 0.0, side: 1.0, span, power, smooth: true };
                return self.strip(panel, map, to_anchor, (left.x, right.x));
            }
        }
        if to_begin >= FAR * width {
            let map =
                Map { x: left.x, u: to_anchor, side: 1.0, span: width, power: 1.0, smooth: true };
            return self.strip(panel, map, 0.0, (left.x, right.x));
        }
        let u = if to_begin == 0.0 { to_anchor } else { panel.distance(d + begin * unit) };
        let mut from = left.x;
        loop {
            // A density of unknown form has unknown scales.
            let endless = known.is_some() || from <= 0.0;
            let to = if endless { right.x } else { right.x.min(RATIO * from) };
            let to = if RATIO * to > right.x && to > 0.5 * right.x { right.x } else { to };
            let span = (to - begin) * unit;
            let map = Map { x: begin, u, side: 1.0, span, power: MAP_POWER, smooth: false };
            self.strip(panel, map, (from - begin) * unit, (from, to))?;
            if to >= right.x {
                return Ok(());
            }
            from = to;
        }
    }

    /// A strip mapped from a power at the higher end of a panel.
    fn down(
        &mut self,
        panel: &'a Panel,
        anchor: f64,
        power: f64,
        left: CutPoint,
        right: CutPoint,
    ) -> Result<(), QuadratureError> {
        let span = panel.distance(left.z);
        let map = Map { x: anchor, u: 0.0, side: -1.0, span, power, smooth: true };
        self.strip(panel, map, panel.distance(right.z), (left.x, right.x))
    }

    fn strip(
        &mut self,
        panel: &'a Panel,
        map: Map,
        nearest: f64,
        ends: (f64, f64),
    ) -> Result<(), QuadratureError> {
        let low = if nearest <= 0.0 { 0.0 } else { map.v(nearest) };
        let kinks = &self.integrand.kinks;
        let above = kinks.partition_point(|kink| *kink <= ends.0);
        let place = |k: usize| kinks.get(k).copied();
        let around = (
            above.checked_sub(1).and_then(place).unwrap_or(ends.0),
            place(above).unwrap_or(f64::INFINITY),
        );
        let mut strip = Strip::new(panel, map, (low, 1.0), ends, around);
        self.found.evaluations += strip.sample(&self.view)?;
        self.nonzero |= strip.nonzero;
        self.count(&strip, 1.0);
        self.add_sampled(&[ends.0, ends.1]);
        self.strips.push(strip);
        Ok(())
    }
}
