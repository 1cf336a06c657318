//! One asperity on the way back, against values that public code publishes.

use std::f64::consts::PI;

use asperity_core::{Asperity, Body, Interface, Tolerance};
use asperity_ghaednia::Ghaednia;

use crate::UnloadingLaw;
use crate::asperity_laws::{AsperityLaws, UnloadingQuantity};

#[test]
fn a_hardened_asperity_unloads_by_brake_as_in_public_code() {
    let mut body = Body::yielding(192e9, 0.3, 330e6);
    body.tangent_modulus = Some(620e6);
    let asperity = Asperity::new(&Interface::between(&body, &body).unwrap(), 1.4e-3).unwrap();
    let (law, tolerance) = (UnloadingLaw::Brake, Tolerance::default());
    let laws = AsperityLaws::new(&Ghaednia, asperity, law, tolerance).unwrap();
    // Largest interference, interference on the way back [m], force [N], contact radius [m].
    let rows = [
        (5.289458553446e-7, 4.848670340659e-7, 1.54655378324, 2.590104097194e-5),
        (7.052611404594e-7, 5.780095953337e-7, 1.852154596078, 2.788822595506e-5),
        (7.052611404594e-7, 4.457731314976e-7, 1.131395555276, 2.366282726083e-5),
    ];
    for (largest, back, force, radius) in rows {
        let of = |quantity| laws.answer(largest, largest - back, None, quantity).unwrap();
        let (found, area) = (of(UnloadingQuantity::Force), of(UnloadingQuantity::Area));
        // The values have thirteen digits, of which the retreat keeps eleven.
        assert!((found / force - 1.0).abs() < 1e-11, "{back}: {found}");
        let found = (area / PI).sqrt();
        assert!((found / radius - 1.0).abs() < 1e-11, "{back}: {found}");
    }
}
