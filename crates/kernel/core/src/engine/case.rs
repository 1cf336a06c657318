//! A scene with a separation or a load.

use crate::{At, Scene};

/// A scene at one separation or load.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Case {
    /// The scene.
    pub scene: Scene,
    /// A separation or a load.
    pub at: At,
}

impl Case {
    /// A scene at a separation or under a load; a plain number is a separation d/σ_z from the mean
    /// of the asperity heights.
    #[must_use]
    pub fn new(scene: Scene, at: impl Into<At>) -> Self {
        Self { scene, at: at.into() }
    }
}
