//! Unloading and partial slip against `tests/reference/engineering.csv` (far tails by
//! `engineering_tails.py` in the same folder), closed forms, and sums over asperities that are
//! independent of the engine.

use std::f64::consts::PI;

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    At, ContactModel, Evaluation, HeightDistribution, Interface, Quantity, Request, Scene, Surface,
    Tolerance,
};
use asperity_etsion::EtsionKligermanKadin;
use asperity_gao::Gao;
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity_ke::KogutEtsion;
use asperity_zmc::ZhaoMaiettaChang;

use crate::scenes::{named, tight};

fn model(id: &str) -> Box<dyn ContactModel> {
    let models: [Box<dyn ContactModel>; 7] = [
        Box::new(GreenwoodWilliamson),
        Box::new(ChangEtsionBogy),
        Box::new(ZhaoMaiettaChang),
        Box::new(KogutEtsion),
        Box::new(EtsionKligermanKadin),
        Box::new(JacksonGreen::default()),
        Box::new(AbdoFarhang::default()),
    ];
    models.into_iter().find(|model| model.id() == id).unwrap()
}

fn close(found: &Evaluation, wanted: f64, within: f64, what: &str) {
    let error = (found.value() / wanted - 1.0).abs();
    assert!(error < within, "{what}: {} is {error:.1e} from {wanted}", found.value());
}

#[test]
fn reference_rows_are_reproduced() {
    let rows = include_str!("../../../../../tests/reference/engineering.csv").lines().skip(1);
    let (mut count, mut failures) = (0, vec![]);
    for line in rows.filter(|line| !line.contains(",,,")) {
        let fields: Vec<&str> = line.split(',').collect();
        let [case, id, closest, law, retreat, quantity, value] = fields[..] else {
            panic!("{line}")
        };
        let [closest, retreat, value] =
            [closest, retreat, value].map(|n| n.parse::<f64>().unwrap());
        let scene = named(case);
        let law: UnloadingLaw = law.parse().unwrap();
        let joint = Unloading::new(&*model(id), &scene, At::from(closest), law, tight()).unwrap();
        let retreat = retreat * scene.surface.asperity_height_std;
        let found = match quantity {
            "force" => joint.force(retreat),
            _ => joint.area(retreat),
        };
        let found = found.unwrap();
        let (error, bound) = ((found.value() / value - 1.0).abs(), found.relative_error());
        // The file is accurate to about 1e-12, and 9e-12 in far tails.
        if error.is_nan() || error > 1e-11 {
            failures.push(format!("{line}: {error:.1e}, bound {bound:.1e}"));
        }
        count += 1;
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert_eq!(count, 414);
}

#[test]
fn errors_are_below_their_bounds() {
    let rows = include_str!("../../../../../tests/reference/unloading_bounds.csv").lines().skip(1);
    let (mut count, mut failures) = (0, vec![]);
    for line in rows {
        let fields: Vec<&str> = line.split(',').collect();
        let [case, id, closest, retreat, force, area] = fields[..] else { panic!("{line}") };
        let [closest, retreat, force, area] =
            [closest, retreat, force, area].map(|n| n.parse::<f64>().unwrap());
        let scene = named(case);
        let retreat = retreat * scene.surface.asperity_height_std;
        for tolerance in [1e-4, 1e-8, 1e-12] {
            let tolerance = Tolerance::new(tolerance).unwrap();
            let (model, closest, law) = (model(id), At::from(closest), UnloadingLaw::Hertz);
            let way = Unloading::new(&*model, &scene, closest, law, tolerance).unwrap();
            for (found, wanted) in [(way.force(retreat), force), (way.area(retreat), area)] {
                let found = found.unwrap();
                // Subnormal numbers have fewer digits.
                if wanted < 1e-300 {
                    assert!((found.value() - wanted).abs() < 1e-300, "{line}");
                    continue;
                }
                let (error, bound) = ((found.value() / wanted - 1.0).abs(), found.relative_error());
                // Rounding of a separation of 30 σ_z limits the accuracy to 1e-11.
                let within = tolerance.relative().max(1e-11);
                if error.is_nan() || error > bound || bound > within {
                    failures.push(format!("{line} {tolerance:?}: {error:.1e}, bound {bound:.1e}"));
                }
                count += 1;
            }
        }
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert_eq!(count, 150);
}

#[test]
fn elastic_unloading_retraces_loading_for_every_law_and_any_heights() {
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential] {
        let mut scene = named("severe");
        scene.heights = heights;
        let sigma = scene.surface.asperity_height_std;
        let asked = Request::new([Quantity::Force, Quantity::Area, Quantity::Tangent]);
        let gw = GreenwoodWilliamson.compile(&scene, &asked.within(tight())).unwrap();
        for (closest, retreat) in [(-3.0, 0.4), (0.0, 1e-3), (1.5, 0.2), (1.5, 6.0), (8.0, 1.0)] {
            for law in UnloadingLaw::ALL {
                let at = At::from(closest);
                let joint = Unloading::new(&GreenwoodWilliamson, &scene, at, law, tight()).unwrap();
                let wanted = |q| gw.evaluate(q, closest + retreat).unwrap().value();
                let (u, what) = (retreat * sigma, format!("{law} {closest} {retreat}"));
                close(&joint.force(u).unwrap(), wanted(Quantity::Force), 1e-11, &what);
                close(&joint.stiffness(u).unwrap(), wanted(Quantity::Tangent), 1e-11, &what);
                if law != UnloadingLaw::Etsion {
                    close(&joint.area(u).unwrap(), wanted(Quantity::Area), 1e-11, &what);
                }
            }
        }
    }
}

#[test]
fn initial_unloading_stiffness_is_the_sum_of_2_e_a() {
    let scene = named("at-paper");
    for id in ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"] {
        let asked = [Quantity::Force, Quantity::Area, Quantity::UnloadingStiffness];
        let request = Request::new(asked).within(tight());
        let virgin = model(id).compile(&scene, &request).unwrap();
        let hertz = UnloadingLaw::Hertz;
        let joint = Unloading::new(&*model(id), &scene, At::from(0.5), hertz, tight()).unwrap();
        let found = [joint.force(0.0), joint.area(0.0), joint.stiffness(0.0)];
        for (found, quantity) in found.into_iter().zip(asked) {
            let wanted = virgin.evaluate(quantity, 0.5).unwrap().value();
            close(&found.unwrap(), wanted, 1e-11, &format!("{id} {quantity}"));
        }
        // -dF/du is the slope of the force, and force plus released force is constant.
        let [low, high] = [0.2e-6, 0.2002e-6].map(|u| joint.force(u).unwrap().value());
        close(&joint.stiffness(0.2001e-6).unwrap(), (low - high) / 0.0002e-6, 1e-6, id);
        let all = joint.force(0.0).unwrap().value();
        close(&joint.released(0.2e-6).unwrap(), all - low, 1e-10, id);
    }
}

#[test]
fn slip_is_the_direct_sum_of_cattaneo_mindlin_asperities() {
    let (mut scene, mu) = (named("mild"), 0.2);
    scene.heights = HeightDistribution::Exponential;
    let asperity = scene.asperity().unwrap();
    let (e, g, r) = (asperity.equivalent_modulus, 41e9_f64.max(44e9), asperity.radius);
    let sigma = scene.surface.asperity_height_std;
    let hertz = UnloadingLaw::Hertz;
    let joint =
        Unloading::new(&GreenwoodWilliamson, &scene, At::from(1.0), hertz, tight()).unwrap();
    let slip = PartialSlip::new(&joint, mu).unwrap();
    for shift in [1e-9, 5e-8, 2e-7] {
        // Q = μ F [1 - (1 - u/u_s)^1.5], u_s = 3 μ F/(16 G a) for 1/G = (2-ν₁)/G₁ + (2-ν₂)/G₂.
        let full = mu * e / (4.0 * g); // of gross slip: u_s/w
        let kink = shift / full;
        let mut sum = 0.0;
        for [low, high] in [[0.0, kink], [kink, kink + 45.0 * sigma]] {
            const STEPS: i32 = 40_000;
            for k in 0..=STEPS {
                let v = f64::from(k) / f64::from(STEPS);
                let weight = if k == 0 || k == STEPS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                let w = low + (high - low) * v * v;
                let (force, a) = (4.0 / 3.0 * e * (r * w).sqrt() * w, (r * w).sqrt());
                let gross = 3.0 * mu * force / (16.0 * g * a);
                let stuck = (1.0 - shift / gross.max(f64::MIN_POSITIVE)).max(0.0);
                let tangential = mu * force * (1.0 - stuck * stuck.sqrt());
                let share = weight / f64::from(3 * STEPS) * 2.0 * v * (high - low);
                sum += share * tangential * (-w / sigma).exp() / sigma;
            }
        }
        let sum = scene.asperities() * (-1.0_f64).exp() * sum;
        close(&slip.force(shift).unwrap(), sum, 1e-9, &format!("{shift}"));
        // Exponential heights: μ F (1 - exp(-s/σ)).
        let closed = mu * joint.force(0.0).unwrap().value() * -(-kink / sigma).exp_m1();
        close(&slip.force(shift).unwrap(), closed, 1e-11, &format!("{shift}"));
    }
}

#[test]
fn slip_and_losses_of_greenwood_and_williamson_equal_the_reference() {
    // nu = 0.3 on both sides: 4 G/E = 0.8235294...; d = 1.5 sigma, mu = 0.2.
    let mut interface = Interface::new(115.4e9, 0.3, 2e9);
    interface.equivalent_shear_modulus = Some(115.4e9 * 0.7 / 1.7 / 2.0);
    let scene = Scene::new(interface, Surface::new(1e-3, 1e8, 1e-6), 1e-4);
    let (sigma, mu, hertz) = (1e-6, 0.2, UnloadingLaw::Hertz);
    let joint =
        Unloading::new(&GreenwoodWilliamson, &scene, At::from(1.5), hertz, tight()).unwrap();
    let slip = PartialSlip::new(&joint, mu).unwrap();
    let limit = mu * joint.force(0.0).unwrap().value();
    for (shift, wanted) in [
        (0.01, 0.095716055042),
        (0.05, 0.403071927847),
        (0.1, 0.655150371024),
        (0.2, 0.895978844120),
        (0.5, 0.998781710858),
    ] {
        // 12 printed digits.
        close(&slip.force(shift * sigma).unwrap(), wanted * limit, 1e-11, &format!("{shift}"));
    }
    let per_retreat = mu / (2.0 * 0.7 / 1.7);
    for (s, wanted, printed) in
        [(0.05, 4.102276e-4, 3e-7), (0.2, 0.0230033890, 3e-9), (1.0, 1.4074850252, 1e-10)]
    {
        let unit = limit * per_retreat * sigma;
        let amplitude = s * per_retreat * sigma;
        close(&slip.loss(amplitude).unwrap(), wanted * unit, printed, &format!("loss at {s}"));
        // Definition of the loss factor: loss over π Q D.
        let spring = PI * slip.force(amplitude).unwrap().value() * amplitude;
        let factor = slip.loss_factor(amplitude).unwrap();
        assert!((factor * spring / (wanted * unit) - 1.0).abs() < printed, "{factor}");
        // The loop closes and encloses the loss: trapezia between its two branches.
        let of = |x: f64, forth| slip.loop_force(x * amplitude, amplitude, forth).unwrap();
        for end in [-1.0, 1.0] {
            assert!((of(end, true) - of(end, false)).abs() < 1e-10 * limit);
        }
        // The substitution x = sin smooths the square-root ends.
        let steps = 400;
        let area: f64 = (1..steps)
            .map(|k| {
                let angle = PI * (f64::from(k) / f64::from(steps) - 0.5);
                let width = of(angle.sin(), true) - of(angle.sin(), false);
                width.abs() * amplitude * angle.cos() * PI / f64::from(steps)
            })
            .sum();
        close(&slip.loss(amplitude).unwrap(), area, 1e-4, &format!("loop of {s}"));
    }
}

/// For exponential heights Q = μ F (1 - e^(-s/σ)).
#[test]
fn shift_at_a_share_of_sliding_equals_the_closed_form() {
    let mut scene = named("severe");
    scene.heights = HeightDistribution::Exponential;
    let sigma = scene.surface.asperity_height_std;
    let asperity = scene.asperity().unwrap();
    let moduli = 4.0 * asperity.equivalent_shear_modulus.unwrap() / asperity.equivalent_modulus;
    for (load, friction) in [(1e-3, 0.2), (10.0, 0.9)] {
        let (at, law) = (At::Load(load), UnloadingLaw::Hertz);
        let joint = Unloading::new(&GreenwoodWilliamson, &scene, at, law, tight()).unwrap();
        let slip = PartialSlip::new(&joint, friction).unwrap();
        for share in [1e-3_f64, 0.5, 0.99, 1.0 - 1e-9] {
            let wanted = -sigma * (-share).ln_1p() * friction / moduli;
            // Near the limit, the shift is ill-conditioned in the share.
            let within = 1e-11 / (1.0 - share);
            let error = (slip.shift_at(share).unwrap() / wanted - 1.0).abs();
            assert!(error < within, "{share}: {error:.1e}");
        }
        for share in [0.0, 1.0, -0.5, f64::NAN] {
            let refused = slip.shift_at(share).unwrap_err().to_string();
            assert!(refused.starts_with("share is "), "{refused}");
        }
    }
}

#[test]
fn unsupported_models_and_inputs_are_refused_by_name() {
    let (scene, at, law) = (named("mild"), At::from(1.0), UnloadingLaw::Etsion);
    let inclined = Unloading::new(&Gao::default(), &scene, at, law, tight()).unwrap_err();
    let joint = Unloading::new(&KogutEtsion, &scene, at, law, tight()).unwrap();
    let area = joint.area(0.0).unwrap_err();
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        assert!(joint.force(bad).unwrap_err().to_string().starts_with("retreat is"));
        let slip = PartialSlip::new(&joint, 0.2).unwrap();
        assert!(slip.force(bad).unwrap_err().to_string().starts_with("shift is"));
    }
    assert!(PartialSlip::new(&joint, 0.0).unwrap_err().to_string().starts_with("friction is"));
    let mut bare = scene;
    bare.interface.equivalent_shear_modulus = None;
    let joint = Unloading::new(&KogutEtsion, &bare, at, law, tight()).unwrap();
    let bare = PartialSlip::new(&joint, 0.2).unwrap_err();
    insta::assert_snapshot!([inclined, area, bare].map(|one| one.to_string()).join("\n"));
}
