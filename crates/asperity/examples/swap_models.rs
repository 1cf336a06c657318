//! One scene, several models: chosen by name, or by value.

use asperity::{
    AminiTehrani, AtReading, ContactError, ContactModel, Interface, KogutEtsion, Model, Quantity,
    Request, Scene, Surface,
};

fn main() -> Result<(), ContactError> {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    let scene = Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5);
    let request = Request::new([Quantity::Force]).at([1.0]);

    // By name: from a scene file or a command line.
    for name in ["gw", "ke", "jg"] {
        let model: Model = name.parse()?;
        println!("{name:12} {:8.3} N", model.solve(&scene, &request)?.values(Quantity::Force)?[0]);
    }

    // By value, with options.
    let additive = AminiTehrani { reading: AtReading::Additive, ..AminiTehrani::default() };
    let models: Vec<Box<dyn ContactModel>> = vec![Box::new(KogutEtsion), Box::new(additive)];
    for model in &models {
        let answer = model.solve(&scene, &request)?;
        println!("{:12} {:8.3} N", model.id(), answer.values(Quantity::Force)?[0]);
    }
    Ok(())
}
