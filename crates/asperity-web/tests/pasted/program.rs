use asperity::{At, ContactModel, Quantity, Request};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = asperity_inputs::load("scene.toml")?;
    let quantities = [
        Quantity::AreaFraction,
        Quantity::Tangent,
        Quantity::UnloadingStiffness,
        Quantity::TangentialStiffness,
        Quantity::MeanPressure,
        Quantity::Contacts,
    ];
    let request = Request::new(quantities).at([At::Load(123.0)]);
    for id in ["gw", "ke"] {
        println!("{id}: {:?}", file.model(id)?.solve(&file.scene, &request)?);
    }
    Ok(())
}
