//! The example of the README.

use asperity::{Body, ContactError, Interface, Model, Quantity, Request, Scene, Surface};

fn main() -> Result<(), ContactError> {
    let steel = Body::new(210e9, 0.3, 2e9); // E [Pa], ν, H [Pa]
    let surface = Surface::new(2e-4, 2e8, 1e-6); // R [m], η [1/m²], σ_z [m]
    let scene = Scene::new(Interface::between(&steel, &steel)?, surface, 1e-4); // A_n [m²]
    let asked = [Quantity::Area, Quantity::Tangent];
    let request = Request::new(asked).at_loads([10.0, 100.0, 1000.0]); // N; or at separations
    for name in ["gw", "ke", "gao"] {
        let answer = name.parse::<Model>()?.solve(&scene, &request)?;
        let (area, stiffness) = (answer.values(asked[0])?, answer.values(asked[1])?);
        println!("{name:>3}: at 100 N {:.3e} m² and {:.3} N/nm", area[1], 1e-9 * stiffness[1]);
    }
    Ok(())
}
