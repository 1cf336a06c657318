//! `curve`: the output agrees with the library.

use asperity::{At, ContactModel, Model, Quantity, Request};

use crate::bench::{Bench, column};

#[test]
fn every_digit_agrees_with_the_library() {
    let bench = Bench::new();
    let scene = bench.scene("scene.toml").scene;
    let quantities = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let tolerance = asperity::Tolerance::new(1e-12).unwrap();
    for (arguments, at) in [
        ("--separation -1:3:3", [-1.0, 1.0, 3.0].map(At::sigmas)),
        ("--load 0.1,1,10 --quantity force,area,tangent", [0.1, 1.0, 10.0].map(At::Load)),
    ] {
        let data =
            bench.data(&format!("curve scene.toml --model jg --tolerance 1e-12 {arguments}"));
        let request = Request::new(quantities).at(at).within(tolerance);
        let answer = "jg".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
        for quantity in quantities {
            let printed = column(&data, &quantity.column());
            let computed = answer.values(quantity).unwrap();
            assert!(printed.iter().zip(computed).all(|(a, b)| a.to_bits() == b.to_bits()));
        }
    }
}
