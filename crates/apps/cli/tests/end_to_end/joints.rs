//! The opening of a closed joint, its histories, and the plots of both.

use asperity::joints::{Joint, Unloading, UnloadingLaw};
use asperity::{At, Model, Tolerance};

use crate::bench::{Bench, NEGATIVE, cells, column, csv};

/// A closed joint, by the library.
pub fn joint(bench: &Bench, model: &str, at: At, law: UnloadingLaw) -> Unloading {
    let scene = bench.scene("scene.toml").scene;
    let model: Model = model.parse().unwrap();
    Unloading::new(&model, &scene, at, law, Tolerance::default()).unwrap()
}

#[test]
fn unloading_is_printed_as_it_is_computed() {
    let bench = Bench::new();
    for (law, arguments) in [
        (UnloadingLaw::Hertz, ""),
        (UnloadingLaw::Brake, "--law brake"),
        (UnloadingLaw::Etsion, "--law etsion"),
    ] {
        let data = bench
            .data(&format!("joint scene.toml --model ke --load 100 --retreat 0,0.2,1 {arguments}"));
        let joint = joint(&bench, "ke", At::Load(100.0), law);
        let retreats = column(&data, "retreat_m");
        // The template's heights spread by 1 um.
        assert!((retreats[1] / 0.2e-6 - 1.0).abs() < 1e-15);
        for (k, retreat) in retreats.into_iter().enumerate() {
            let same = |name: &str, value: f64| {
                assert!(column(&data, name)[k].to_bits() == value.to_bits(), "{law} {name}");
            };
            same("force_N", joint.force(retreat).unwrap().value());
            same("stiffness_N_per_m", joint.stiffness(retreat).unwrap().value());
            match law {
                UnloadingLaw::Etsion => assert!(!data.contains("area_m2")),
                _ => same("area_m2", joint.area(retreat).unwrap().value()),
            }
        }
        assert!((column(&data, "force_N")[0] / 100.0 - 1.0).abs() < 1e-8);
        assert_eq!(cells(&data, "law"), [law.to_string().as_str(); 3]);
    }
}

#[test]
fn all_laws_have_their_loss_and_end_of_contact() {
    let bench = Bench::new();
    let run = bench.run("joint scene.toml --model ke --law hertz,brake,etsion --load 2kN");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let (_, rows) = csv(&run.out);
    assert_eq!(rows.len(), 3 * 101);
    let (law, area) = (cells(&run.out, "law"), cells(&run.out, "area_m2"));
    assert!(law.iter().zip(&area).all(|(law, area)| (*law == "etsion") == area.is_empty()));
    let (force, pressure) = (column(&run.out, "force_N"), column(&run.out, "pressure_Pa"));
    assert!(force.iter().zip(&pressure).all(|(f, p)| (p * 1e-4 - f).abs() <= 1e-9 * f));
    // The last of brake's, which lasts longest.
    let touching = column(&run.out, "contacts");
    assert!((touching[201] - 1.0).abs() < 1e-6 && touching[100] < 1.0, "{touching:?}");
    let joint = joint(&bench, "ke", At::Load(2e3), UnloadingLaw::Brake);
    let end = format!("{:.5e} m", joint.last_contact().unwrap());
    assert!(run.messages.contains(&end), "{}", run.messages);
    // The work and the end of contact of each law.
    assert_eq!(run.results().len(), 6, "{}", run.messages);
    // Lengths have units, and likely unit errors have a warning.
    let short = "joint scene.toml --model ke --closest 1um --retreat 0nm,100nm,200nm";
    let retreats = column(&bench.data(short), "retreat_m");
    assert!((retreats[2] / 2e-7 - 1.0).abs() < 1e-15, "{retreats:?}");
}

#[test]
fn histories_turn_at_separations_and_at_loads() {
    let bench = Bench::new();
    let arguments = "joint scene.toml --model ke --history-load 10N,2kN,500N,3kN";
    let run = bench.run(&format!("{arguments} --plot h.svg"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let (way, force) = (cells(&run.out, "way"), column(&run.out, "force_N"));
    for (number, wanted) in [("0", 10.0), ("1", 2e3), ("2", 500.0), ("3", 3e3)] {
        let last = way.iter().rposition(|way| *way == number).unwrap();
        assert!((force[last] / wanted - 1.0).abs() < 1e-8, "{number}: {}", force[last]);
    }
    assert!(run.results().len() == 1 && bench.read("h.svg").starts_with("<svg"));
    let area = bench.scene("scene.toml").scene.nominal_area;
    let pressures: Vec<String> =
        [10.0, 2e3, 500.0, 3e3].iter().map(|load| (load / area).to_string()).collect();
    let arguments =
        format!("joint scene.toml --model ke --history-pressure {}", pressures.join(","));
    let by_pressure = column(&bench.data(&arguments), "force_N");
    assert!(by_pressure.iter().zip(&force).all(|(a, b)| (a / b - 1.0).abs() < 1e-8));
    // Back to the start of an elastic joint, what is in it is the work of the first closing.
    let round = bench.run("joint scene.toml --model gw --history-load 10,200,10").messages;
    let (_, first) = round.split_once("first closing takes ").unwrap();
    let (first, rest) = first.split_once(" J, ").unwrap();
    let (_, all) = rest.split_once("returned), ").unwrap();
    assert_eq!(all.split(' ').next(), Some(first), "{round}");
    let gw: Model = "gw".parse().unwrap();
    let spent = Joint::new(
        &gw,
        &bench.scene("scene.toml").scene,
        UnloadingLaw::Hertz,
        Tolerance::default(),
    )
    .unwrap()
    .work(At::Load(10.0))
    .unwrap()
    .spent
    .value();
    assert!((first.parse::<f64>().unwrap() / spent - 1.0).abs() < 1e-5, "{first}: {spent}");
    // All laws open an elastic joint alike.
    let laws = "--law hertz,brake,etsion --history-load 100,200,150";
    let alike = bench.run(&format!("joint scene.toml --model gw {laws}"));
    assert_eq!(alike.results().len(), 1, "{}", alike.messages);
    let light = bench.run("joint scene.toml --model ke --closest 6");
    assert!(light.messages.contains("[few-contacts]"), "{}", light.messages);
    assert_eq!(csv(&light.out).1.len(), 1, "{}", light.out);
    let places =
        column(&bench.data("joint scene.toml --model ke --history 3um,1um,2um"), "separation_m");
    assert!((places[50] / 1e-6 - 1.0).abs() < 1e-12 && places.len() == 101, "{places:?}");
}

#[test]
fn a_last_contact_that_is_hard_to_find_leaves_the_table_as_it_is() {
    let bench = Bench::new();
    let rail = include_str!("../../../../answer/scene/examples/wheel-rail.toml");
    let heights = "heights = \"exponential\"";
    bench.write("scene.toml", &rail.replace("separation_from = \"surface-mean\"", heights));
    let run = bench.run("joint scene.toml --model jg-cosine --load 20kN --retreat 0nm,100nm");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let forces = column(&run.out, "force_N");
    assert!((forces[0] / 2e4 - 1.0).abs() < 1e-9 && forces[1] < forces[0], "{forces:?}");
    // Where contact ends is printed to 1e-6 where 1e-10 is not reached.
    let (_, end) = run.messages.split_once("a retreat of ").unwrap();
    let end: f64 = end.split(' ').next().unwrap().parse().unwrap();
    let [before, after] = [0.9999, 1.0001].map(|share| {
        let arguments = "joint scene.toml --model jg-cosine --load 20kN --retreat";
        column(&bench.data(&format!("{arguments} {}m", share * end)), "contacts")[0]
    });
    assert!(after < 1.0 && before > 1.0, "{before} {after}");
}

#[test]
fn a_joint_that_creates_energy_has_a_warning_within_the_tolerance() {
    let bench = Bench::new();
    bench.write("low.toml", &NEGATIVE.replace("plasticity_index = 2.0", "plasticity_index = 0.5"));
    let of = |arguments: &str| {
        let run = bench.run(&format!("joint low.toml --retreat 0 --closest -1 {arguments}"));
        assert_eq!(run.code, Some(0), "{}", run.messages);
        run
    };
    let created = of("--model ceb --law brake").messages;
    assert!(created.contains("[energy-gain]"), "{created}");
    // 0.1 % more is less than the error of a coarse tolerance.
    assert!(of("--model ke").messages.contains("[energy-gain]"));
    assert!(!of("--model ke --tolerance 1e-2").messages.contains("more energy"));
    let slip = "joint scene.toml --model ke --friction 0.3 --load 100 --amplitude 1e-7";
    assert!(bench.data(&format!("{slip} --tolerance 1e-8")).starts_with("model,shift_m"));
}
