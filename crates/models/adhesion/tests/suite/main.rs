//! Tests of the contact models with adhesion.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]

mod references;
mod tensions;

use asperity_adhesion::{DerjaguinMullerToporov, JkrBranch, JohnsonKendallRoberts};
use asperity_core::{
    Contact, ContactModel, Interface, Quantity, Request, Scene, Surface, Tolerance,
};

const APPROACH: JohnsonKendallRoberts = JohnsonKendallRoberts { branch: JkrBranch::Approach };
const SEPARATION: JohnsonKendallRoberts = JohnsonKendallRoberts { branch: JkrBranch::Separation };

fn model(id: &str) -> &'static dyn ContactModel {
    let models: [&'static dyn ContactModel; 3] = [&DerjaguinMullerToporov, &APPROACH, &SEPARATION];
    models.into_iter().find(|model| model.id() == id).unwrap()
}

/// E = 1 GPa, R = 0.1 mm, σ_z = 0.1 µm, a thousand asperities.
fn scene(work: f64) -> Scene {
    let mut interface = Interface::elastic(1e9, 0.5);
    interface.work_of_adhesion = Some(work);
    Scene::new(interface, Surface::new(1e-4, 1e9, 1e-7), 1e-6)
}

/// w_a at which θ = E σ_z^1.5/(w_a √R) is this.
fn work_of(theta: f64) -> f64 {
    1e9 * 1e-7f64.powf(1.5) / (theta * 1e-2)
}

fn compiled(model: &dyn ContactModel, scene: &Scene, tolerance: f64) -> Box<dyn Contact> {
    let asked = [Quantity::Force, Quantity::Tangent];
    let request = Request::new(asked).within(Tolerance::new(tolerance).unwrap());
    model.compile(scene, &request).unwrap()
}
