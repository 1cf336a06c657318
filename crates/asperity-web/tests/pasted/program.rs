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
    for id in ["gw", "persson-fudge"] {
        let model = file.model(id)?;
        for quantity in quantities {
            let request = Request::new([quantity]).at([At::Load(123.0)]);
            match model.solve(&file.scene, &request) {
                Ok(answer) => println!("{id}: {:?}", answer.columns),
                Err(reason) => println!("{id}: {quantity}: none: {reason}"),
            }
        }
    }
    Ok(())
}
