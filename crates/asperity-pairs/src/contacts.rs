//! The contacts between two surfaces as those of one surface.

use std::f64::consts::FRAC_1_SQRT_2;

use asperity_core::{ContactError, Pair, Scene, Surface};

/// The scene of the contacts: their radius R, the density of two like surfaces with as many
/// contacts, √(η₁ η₂ (β₁ + β₂)/(4R)), and the standard deviation of the sum of the heights. Of such
/// a scene it is the same scene again.
///
/// # Errors
/// [`ContactError::OutOfRange`] for asperities of either surface that are out of range.
pub(crate) fn of_contacts(scene: &Scene) -> Result<Scene, ContactError> {
    let pair = scene.both_surfaces();
    let [first, second] = pair.surfaces;
    first.check()?;
    second.check()?;
    let radii = first.asperity_radius + second.asperity_radius;
    let radius = first.asperity_radius * (second.asperity_radius / radii);
    let densities = first.asperity_density.sqrt() * second.asperity_density.sqrt();
    let density = densities * (radii / (4.0 * radius)).sqrt();
    let std = first.asperity_height_std.hypot(second.asperity_height_std);
    let surface = Surface::new(radius, density, std);
    let mut own = Scene::new(scene.interface, surface, scene.nominal_area);
    let offset = Some(pair.mean_plane_offset());
    let like = Surface::new(2.0 * radius, density, FRAC_1_SQRT_2 * std);
    let mut like = Pair::new(like, like);
    (own.mean_plane_offset, like.mean_plane_offset) = (offset, offset);
    own.surface_height_std = Some(pair.surface_height_std());
    like.surface_height_std = own.surface_height_std;
    own.pair = Some(like);
    Ok(own)
}
