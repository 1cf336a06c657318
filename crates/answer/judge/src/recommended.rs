//! Ids of the models that messages recommend and compare with; a test of the crate `asperity`
//! compares them with its registry.

use asperity_core::Scene;

/// Models of yielding asperities.
pub const YIELDING: &str = "ke or jg";
/// Adhesion of small, hard asperities.
pub const DMT: &str = "dmt";
/// Adhesion of large, soft asperities, on approach.
pub const JKR: &str = "jkr";
/// The same on separation.
pub const JKR_SEPARATION: &str = "jkr-separation";
/// Both limits of adhesion.
pub const ADHESIVE: &str = "dmt or jkr";
/// Boundary elements on a scan.
pub const BEM: &str = "bem";
/// For merging contacts and real areas near the nominal one; one theory has yielding.
pub const WHOLE_SURFACE: &str =
    "boundary elements, persson-plastic, or persson-fudge if nothing yields";

/// Models of which the first valid one answers where there is no evidence, and whose ratios to it
/// are kept beyond solved loads; those with adhesion where it matters.
pub const ANSWERING: [&str; 9] = [
    "ke",
    "zmc",
    "jg",
    "gw",
    "persson-plastic",
    "persson-fudge",
    "jkr",
    // The branch of opening: larger tensions than jkr carries.
    "jkr-separation",
    "dmt",
];

/// The id of the default reference model: `ke`, or `gw` without a hardness.
///
/// ```
/// use asperity::{Interface, Scene, Surface, usual_reference};
///
/// let surface = Surface::new(3.6e-4, 1.11e8, 1e-6);
/// assert_eq!(usual_reference(&Scene::new(Interface::new(116e9, 0.31, 1e9), surface, 3e-5)), "ke");
/// assert_eq!(usual_reference(&Scene::new(Interface::elastic(1e7, 0.49), surface, 3e-5)), "gw");
/// ```
#[must_use]
pub fn usual_reference(scene: &Scene) -> &'static str {
    match scene.asperity() {
        Ok(asperity) if asperity.hardness.is_some() => "ke",
        _ => "gw",
    }
}
