//! x
mod error;
mod half_space;
mod height_map;
mod iteration;
mod note;
mod parallel;
mod patches;
mod projection;
mod random_surface;
mod solution;
mod solver;
pub use error::BemError;
pub use half_space::Boundary;
pub use height_map::HeightMap;
pub use note::Note;
pub use random_surface::{ProfileMoments, RandomSurface};
pub use solution::{EDGE_SHARE, Solution};
pub use solver::{BoundaryElements, Given, Progress};
