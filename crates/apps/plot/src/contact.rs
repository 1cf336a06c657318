//! Maps of a contact, pixel by pixel: its pressures, and the flow through its gap.

use crate::map::Map;
use crate::text::legible;

/// The largest flow of a map with contacts over its top, which contacts have.
const DARKEST: f64 = 0.999;

impl Map {
    /// Values on rows x columns of pixels with these heights and widths \[m\].
    #[must_use]
    pub fn of_pixels(values: Vec<f64>, [rows, columns]: [usize; 2], [dy, dx]: [f64; 2]) -> Self {
        let size = [columns as f64 * dx, rows as f64 * dy];
        let (length, unit) = legible(size[0], "m");
        Self { values, columns, size: size.map(|side| side / length), unit, ..Self::default() }
    }

    /// Contact pressures \[Pa\] up to the `hardness` \[Pa\], if there is one, in a legible unit.
    #[must_use]
    pub fn of_pressures(
        pressures: &[f64],
        shape: [usize; 2],
        pixel: [f64; 2],
        hardness: Option<f64>,
    ) -> Self {
        let top = hardness.unwrap_or_else(|| pressures.iter().copied().fold(0.0, f64::max));
        let (factor, unit) = legible(top, "Pa");
        let map = Self::of_pixels(pressures.iter().map(|p| p / factor).collect(), shape, pixel);
        Self { label: format!("pressure ({unit})"), top: top / factor, ..map }
    }

    /// The flow through every pixel per width, over its mean.
    #[must_use]
    pub fn of_flow(flux: Vec<f64>, shape: [usize; 2], pixel: [f64; 2]) -> Self {
        let mut order: Vec<f64> = flux.iter().copied().filter(|flux| *flux > 0.0).collect();
        order.sort_unstable_by(f64::total_cmp);
        // Single constrictions have many times the flow of all others.
        let top = order.get(order.len() * 99 / 100).copied().unwrap_or(1.0);
        let map = Self::of_pixels(flux, shape, pixel);
        Self { label: "flow per width, over its mean".into(), top, ..map }
    }

    /// Flows, with the pixels of contact, whose pressures are above 0, in a colour of their own.
    #[must_use]
    pub fn with_contacts(mut self, pressures: &[f64]) -> Self {
        for (value, pressure) in self.values.iter_mut().zip(pressures) {
            *value = if *pressure > 0.0 { self.top } else { value.min(DARKEST * self.top) };
        }
        Self { full: "contact".into(), ..self }
    }

    /// With at most so many values on a side, the largest of those together, so that no contact
    /// disappears.
    #[must_use]
    pub fn coarser(self, most: usize) -> Self {
        let rows = self.values.len() / self.columns.max(1);
        let step = self.columns.max(rows).div_ceil(most);
        let columns = self.columns.div_ceil(step);
        let mut values = vec![0.0_f64; columns * rows.div_ceil(step)];
        for (k, value) in self.values.iter().enumerate() {
            let part = &mut values[k / self.columns / step * columns + k % self.columns / step];
            *part = part.max(*value);
        }
        Self { values, columns, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_contact_is_lost_in_a_coarser_map() {
        let mut values = vec![0.0; 35];
        (values[6], values[34]) = (2.0, 3.0);
        let map = Map::of_pixels(values, [5, 7], [2e-6, 1e-6]);
        assert_eq!((map.size, &*map.unit), ([7.0, 10.0], "µm"));
        let small = map.coarser(3);
        assert_eq!((small.columns, small.values.len(), small.size), (3, 6, [7.0, 10.0]));
        assert!(small.values[2] > 1.0 && small.values[5] > 2.0);
    }

    #[test]
    fn pressures_end_at_the_hardness_and_flows_below_single_constrictions() {
        let pressures = [0.0, 5e8, 2e8, 1e8];
        let of = |hardness| Map::of_pressures(&pressures, [2, 2], [1e-6; 2], hardness);
        assert_eq!((of(None).top, of(None).label), (500.0, "pressure (MPa)".into()));
        assert_eq!((of(Some(2e9)).top, of(Some(2e9)).values[1]), (2.0, 0.5));
        let mut flux = vec![1.0; 399];
        flux.push(40.0);
        let flow = Map::of_flow(flux, [20, 20], [1e-6; 2]);
        assert!((flow.top - 1.0).abs() < 1e-12, "{}", flow.top);
        let contacts = flow.with_contacts(&[&[1e8][..], &[0.0; 399]].concat());
        assert!(contacts.values[0] > 0.9999 && contacts.values[399] < 0.9995);
        assert!((Map::of_flow(vec![0.0; 4], [2, 2], [1e-6; 2]).top - 1.0).abs() < 1e-12);
    }
}
