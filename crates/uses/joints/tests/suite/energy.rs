//! Pairs of loading and unloading laws, with and without an energy gain.

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{At, ContactModel, Interface, Scene, Surface, Tolerance};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_joints::{EnergyGain, Joint, UnloadingLaw, Work};
use asperity_ke::KogutEtsion;
use asperity_zmc::ZhaoMaiettaChang;

fn scene(plasticity_index: f64) -> Scene {
    let mut interface = Interface::new(115e9, 0.3, 2e9);
    interface.equivalent_shear_modulus = Some(25e9);
    let surface = Surface::from_plasticity_index(plasticity_index, 0.04, 1e-6, &interface).unwrap();
    Scene::new(interface, surface, 1e-4)
}

fn gain(
    model: &dyn ContactModel,
    law: UnloadingLaw,
    (index, closest): (f64, f64),
) -> (Work, Option<EnergyGain>) {
    let joint = Joint::new(model, &scene(index), law, Tolerance::default()).unwrap();
    let work = joint.work(At::from(closest)).unwrap();
    (work, joint.energy_gain(At::from(closest), &work).unwrap())
}

#[test]
fn negative_losses_are_reported_with_their_amount() {
    let (af, jg) = (AbdoFarhang::default(), JacksonGreen::default());
    let models: [&dyn ContactModel; 6] =
        [&GreenwoodWilliamson, &ChangEtsionBogy, &ZhaoMaiettaChang, &KogutEtsion, &jg, &af];
    for place in [(0.7, -3.0), (0.7, 0.0), (2.0, 0.0), (0.3, 2.0)] {
        for (model, law) in models.iter().flat_map(|m| UnloadingLaw::ALL.map(|law| (*m, law))) {
            let (work, found) = gain(model, law, place);
            let name = format!("{} {law} {place:?}: {found:?}", model.id());
            let excess = work.returned.value() / work.spent.value() - 1.0;
            match found {
                Some(found) if found.is_net => {
                    assert!((found.amount - excess).abs() < 1e-9 && excess > 0.0, "{name}");
                }
                Some(found) => assert!(found.amount > 0.01 && excess <= 1e-9, "{name}"),
                None => assert!(excess <= 1e-9, "{name}"),
            }
        }
    }
}

#[test]
fn energy_gains_of_steep_laws_and_of_jumps() {
    let af = AbdoFarhang::default();
    let cases: [(&dyn ContactModel, UnloadingLaw, f64); 3] = [
        (&af, UnloadingLaw::Hertz, 0.60),
        (&af, UnloadingLaw::Brake, 0.91),
        (&ChangEtsionBogy, UnloadingLaw::Brake, 0.75),
    ];
    for (model, law, wanted) in cases {
        let found = gain(model, law, (0.7, -3.0)).1.unwrap();
        assert!((found.amount - wanted).abs() < 0.006, "{} {law}: {found:?}", model.id());
        let text = found.finding().to_string();
        let start = format!("{}: by {law}, opening returns ", model.id());
        assert!(text.contains(&start), "{text}");
    }
    // Some asperities create energy although the joint dissipates energy.
    let part = gain(&ChangEtsionBogy, UnloadingLaw::Brake, (2.0, 0.0)).1.unwrap();
    assert!(!part.is_net, "{}", part.finding());
    // Elastic contacts return the work of loading.
    assert!(gain(&GreenwoodWilliamson, UnloadingLaw::Brake, (0.7, -3.0)).1.is_none());
}
