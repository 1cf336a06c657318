//! What an evaluation, a scene, a curve, an inverse and a step of a joint cost: `cargo bench`.
