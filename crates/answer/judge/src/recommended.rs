//! Ids of the models that messages recommend; a test of the crate `asperity` compares them with its
//! registry.

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
