//! Values at many separations in plain arrays: a few nanoseconds each, with one bound for all.

use asperity_quadrature::{ArrayAccuracy, ScaledIntegral};

use crate::engine::height_integral::SLOPES_CANCEL;
use crate::engine::prepared::Prepared;
use crate::law::contact_radii;
use crate::request::quantity_table::Derivation;
use crate::scene::place::LOWEST;
use crate::{FillReport, Quantity};

/// The values, if the quantity is a multiple of an integral and every value is a normal number.
pub(crate) fn multiple(
    prepared: &Prepared,
    quantity: Quantity,
    separations: &[f64],
    values: &mut [f64],
) -> Option<FillReport> {
    prepared.facts.check_requested(quantity).ok()?;
    let (base, slope, factor) = factor(prepared, quantity)?;
    let channel = prepared.channel(base).ok()?;
    let column = ScaledIntegral { shift: 0.0, slope, factor: factor * channel.units.factor };
    if !column.factor.is_normal() {
        return None;
    }
    let ArrayAccuracy { error, condition, normal, lowest } =
        channel.total.fill(separations, column, values)?;
    // The factor is a product of two or three numbers.
    let report = FillReport { bound: error + f64::EPSILON, condition };
    // Near the lowest separation, rows are checked one by one; `lowest` includes the onset.
    let deep = lowest < 0.5 * LOWEST || slope && lowest < SLOPES_CANCEL;
    (normal && !deep).then_some(report)
}

/// The law, whether the slope is required, and the factor, for a multiple of an integral.
fn factor(prepared: &Prepared, quantity: Quantity) -> Option<(Quantity, bool, f64)> {
    let scene = &prepared.scene;
    match quantity.derivation() {
        Derivation::Integral => Some((quantity, false, 1.0)),
        Derivation::IntegralOrSlope(_) if prepared.facts.laws.own_stiffness => {
            Some((quantity, false, 1.0))
        }
        Derivation::IntegralOrSlope(of) | Derivation::Slope(of) => {
            Some((of, true, 1.0 / scene.surface.asperity_height_std))
        }
        Derivation::PerNominalArea(of) => {
            let (base, slope, total) = factor(prepared, of)?;
            Some((base, slope, total / scene.nominal_area))
        }
        Derivation::ContactRadii(..) => {
            let factor = contact_radii::factor(quantity, &scene.interface).ok()??;
            Some((quantity.origin(), false, factor))
        }
        _ => None,
    }
}
