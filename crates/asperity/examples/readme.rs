//! The example of the README.

use asperity::{Body, ContactError, Interface, Model, Quantity, Request, Scene, Surface};

fn main() -> Result<(), ContactError> {
    let steel = Body::new(210e9, 0.3, 2e9); // E [Pa], ν, H [Pa]
    let surface = Surface::new(2e-4, 2e8, 1e-6); // R [m], η [1/m²], σ_z [m]
    let scene = Scene::new(Interface::between(&steel, &steel)?, surface, 1e-4); // A_n [m²]
    let request = Request::new([Quantity::Force, Quantity::Area]).at([1.0, 2.0, 3.0]); // d/σ_z
    for name in ["gw", "ke", "gao"] {
        let answer = name.parse::<Model>()?.solve(&scene, &request)?;
        let (force, area) = (answer.values(Quantity::Force)?, answer.values(Quantity::Area)?);
        println!("{name:>3}: at d = 2 σ_z {:6.2} N on {:.3e} m²", force[1], area[1]);
    }
    Ok(())
}
