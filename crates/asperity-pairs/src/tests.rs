//! Laws between two rough surfaces against references computed another way.

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    ContactModel, Interface, Quantity, Request, Scene, Separation, Surface, Tolerance,
};
use asperity_etsion::EtsionKligermanKadin;
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;
use asperity_zmc::ZhaoMaiettaChang;

use crate::AsperityPairs;

fn model(id: &str) -> AsperityPairs {
    match id {
        "gw" => AsperityPairs::new(GreenwoodWilliamson),
        "ceb" => AsperityPairs::new(ChangEtsionBogy),
        "zmc" => AsperityPairs::new(ZhaoMaiettaChang),
        "ke" => AsperityPairs::new(KogutEtsion),
        "etsion" => AsperityPairs::new(EtsionKligermanKadin),
        "jg" => AsperityPairs::new(JacksonGreen::default()),
        "af" => AsperityPairs::new(AbdoFarhang::default()),
        other => panic!("{other}"),
    }
}

/// A scene of the table of scenes.
fn scene(name: &str) -> Scene {
    let rows = include_str!("../../../tests/reference/models_scenes.csv");
    let row = rows.lines().find(|row| row.starts_with(&format!("{name},"))).unwrap();
    let numbers: Vec<f64> = row.split(',').skip(1).map(|n| n.parse().unwrap()).collect();
    let [e, g, nu, hardness, factor, radius, density, std, area] = numbers[..] else { panic!() };
    let mut interface = Interface::new(e, nu, hardness);
    (interface.equivalent_shear_modulus, interface.pressure_factor) = (Some(g), Some(factor));
    Scene::new(interface, Surface::new(radius, density, std), area)
}

#[test]
fn values_are_those_of_the_reference_alone_and_prepared() {
    let (mut count, mut worst) = (0, 0.0f64);
    for row in include_str!("../../../tests/reference/pairs.csv").lines().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let quantity: Quantity = fields[3].parse().unwrap();
        let [at, wanted] = [fields[2], fields[4]].map(|n| n.parse::<f64>().unwrap());
        let (scene, model) = (scene(fields[0]), model(fields[1]));
        let tolerance = Tolerance::new(1e-13).unwrap();
        let request = Request::new([quantity]).within(tolerance).at([Separation::sigmas(at)]);
        for contact in [model.contact(&scene, &request), model.compile(&scene, &request)] {
            let found = contact.unwrap().evaluate(quantity, at).unwrap();
            let off = (found.value() / wanted - 1.0).abs();
            println!("{row} {off:e} {:e}", found.relative_error());
            worst = worst.max(off);
            count += 1;
        }
    }
    println!("{count} {worst:e}");
}
