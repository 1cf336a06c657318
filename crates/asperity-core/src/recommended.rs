//! Ids of the models that messages recommend. No other file of this crate names a model; tests of
//! the crate `asperity` compare these with its registry.

/// Models of yielding asperities.
pub const YIELDING: &str = "ke or jg";
/// Models that need neither hardness nor yield strength.
pub const ELASTIC: &str = "gw, persson, dmt and jkr";
/// Adhesion of small, hard asperities.
pub const DMT: &str = "dmt";
/// Adhesion of large, soft asperities, on approach.
pub const JKR: &str = "jkr";
/// The same on separation.
pub const JKR_SEPARATION: &str = "jkr-separation";
/// Theories of the whole surface, for merging contacts.
pub const WHOLE_SURFACE: &str = "persson or bem";
/// Of these, those for real areas near the nominal one.
pub const FULL_CONTACT: &str = "persson-fudge or bem";
