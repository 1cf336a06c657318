//! `joint --friction`: a joint that is sheared.

use asperity::At;
use asperity::joints::{PartialSlip, UnloadingLaw};

use crate::bench::{Bench, cells, column, column_of, csv};
use crate::joints::joint;

#[test]
fn slip_is_printed_with_its_loop_and_its_loss() {
    let bench = Bench::new();
    let arguments = "joint scene.toml --model gw --friction 0.2 --pressure 5e6 --amplitude 1e-7";
    let run = bench.run(&format!("{arguments} --points 5"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let joint = joint(&bench, "gw", At::Pressure(5e6), UnloadingLaw::Hertz);
    let slip = PartialSlip::new(&joint, 0.2).unwrap();
    let (shifts, back, forth) =
        (column(&run.out, "shift_m"), column(&run.out, "back_N"), column(&run.out, "forth_N"));
    let first = cells(&run.out, "force_N");
    assert_eq!(first[..2], ["", ""]);
    for (k, shift) in shifts.iter().copied().enumerate() {
        if shift >= 0.0 {
            let force = slip.force(shift).unwrap().value();
            // Twelve digits at the tolerance of 1e-10.
            assert!((first[k].parse::<f64>().unwrap() - force).abs() <= 1e-11 * force);
        }
        assert!(back[k] <= forth[k] + 1e-9 && (back[k] + forth[4 - k]).abs() < 1e-9);
    }
    let (_, loss) = run.messages.split_once("dissipates ").unwrap();
    let (loss, _) = loss.split_once(" J").unwrap();
    let exact = slip.loss(1e-7).unwrap().value();
    assert!((loss.parse::<f64>().unwrap() / exact - 1.0).abs() < 1e-5 && loss.len() < 12, "{loss}");
    assert_eq!(run.results().len(), 2, "{}", run.messages);
    let (_, sliding) = run.messages.split_once("at a shift of ").unwrap();
    let sliding: f64 = sliding.split(' ').next().unwrap().parse().unwrap();
    assert!((slip.force(sliding).unwrap().value() / 99.0 - 1.0).abs() < 1e-4);
}

#[test]
fn slip_at_several_preloads_is_one_row_each_as_each_alone() {
    let bench = Bench::new();
    let arguments = "joint scene.toml --model ke --friction 0.3 --amplitude 100nm";
    let data = bench.data(&format!("{arguments} --load 100:10000:3:log --plot losses.svg"));
    let (head, rows) = csv(&data);
    let columns = "model,load_N,pressure_Pa,separation_over_sigma,force_N,secant_stiffness_N_per_m,loss_J,loss_factor,sliding_m";
    assert!(head.join(",") == columns && rows.len() == 3, "{data}");
    for (k, load) in [100.0, 1000.0, 10000.0].into_iter().enumerate() {
        let joint = joint(&bench, "ke", At::Load(load), UnloadingLaw::Hertz);
        let slip = PartialSlip::new(&joint, 0.3).unwrap();
        let force = slip.force(1e-7).unwrap().value();
        let loss = slip.loss(1e-7).unwrap().value();
        let factor = slip.loss_factor(1e-7).unwrap();
        let wanted = [load, load / 1e-4, joint.closest().value, force, force / 1e-7, loss, factor];
        for (name, wanted) in head[1..].iter().zip(wanted) {
            let found = column(&data, name)[k];
            assert!((found / wanted - 1.0).abs() < 1e-9, "{name} at {load}: {found} {wanted}");
        }
    }
    assert!(bench.read("losses.svg").contains("loss factor"));
    // One preload has its loop; unloading goes back from one place.
    assert!(bench.data(&format!("{arguments} --load 100 --points 3")).starts_with("model,shift_m"));
}

#[test]
fn cycles_of_forces_are_those_of_their_amplitudes_and_what_exceeds_friction_slides() {
    let bench = Bench::new();
    let arguments = "joint scene.toml --model ke --friction 0.3 --format csv";
    let forces = "--tangential-force 1N:100N:3:log";
    let run = bench.run(&format!("{arguments} --load 100,1000 {forces}"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(column(&run.out, "tangential_force_N"), [1.0, 10.0, 100.0, 1.0, 10.0, 100.0]);
    let slides = "[no-value]";
    assert!(run.messages.contains(slides), "{}", run.messages);
    // The load of a preload that is given by its closest approach is known where it slides.
    let closest = bench.run(&format!("{arguments} --closest 2 --tangential-force 1N,1MN"));
    let loads = column_of(&closest.out, "load_N");
    assert!(loads[0].is_some() && loads[0] == loads[1], "{}", closest.out);
    let amplitudes = column_of(&run.out, "amplitude_m");
    assert!(amplitudes[2].is_none() && column_of(&run.out, "loss_J")[2].is_none());
    let joint = joint(&bench, "ke", At::Load(1000.0), UnloadingLaw::Hertz);
    let slip = PartialSlip::new(&joint, 0.3).unwrap();
    let amplitude = amplitudes[4].unwrap();
    assert!((slip.force(amplitude).unwrap().value() / 10.0 - 1.0).abs() < 1e-11);
    let loss = slip.loss(amplitude).unwrap().value();
    assert!((column_of(&run.out, "loss_J")[4].unwrap() / loss - 1.0).abs() < 1e-11);
    let stiffness = column_of(&run.out, "secant_stiffness_N_per_m")[4].unwrap();
    // Both have twelve digits.
    assert!((stiffness * amplitude / 10.0 - 1.0).abs() < 1e-11);
    // One force at one preload gives the loop, whose ends are at the amplitude.
    for force in ["5", "12", "13.5"] {
        bench.data(&format!("{arguments} --load 100 --tangential-force {force}"));
    }
    let one = bench.data(&format!("{arguments} --load 1kN --tangential-force 10 --points 3"));
    let back = column(&one, "back_N");
    assert!((back[2] / 10.0 - 1.0).abs() < 1e-11 && (back[0] / -10.0 - 1.0).abs() < 1e-11);
    let shifts = column(&one, "shift_m");
    assert!((shifts[2] / amplitude - 1.0).abs() < 1e-12);
    let plot = format!("{arguments} --load 100,1000 {forces} --output a.csv --plot a.svg");
    assert_eq!(bench.run(&plot).code, Some(0));
    assert!(bench.read("a.svg").contains("load: 1000 N"));
}

/// A periodic scan of 128 x 128 points between bodies of steel.
fn scan() -> String {
    let body = "[[body]]\nyoungs_modulus = '210 GPa'\npoissons_ratio = 0.3\n";
    format!(
        "nominal_area = 1e-9\n{body}{body}[surface]\nfile = 's.npy'\nunit = 'm'\npixel_size = '0.25 um'\nperiodic = true\n"
    )
}

#[test]
fn a_scan_slips_at_constant_load() {
    let bench = Bench::new();
    bench.data(
        "generate --long 20um --short 2um --size 128x128 --pixel 0.25um --gradient 0.1 --output s.npy",
    );
    bench.write("scan.toml", &scan());
    let slip = "joint scan.toml --model bem --pressure 200MPa --friction 0.2";
    let run = bench.run(&format!("{slip} --amplitude 10nm --points 5 --stick-map map.npy"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let [shifts, back, forth] = ["shift_m", "back_N", "forth_N"].map(|head| column(&run.out, head));
    let force: Vec<f64> =
        cells(&run.out, "force_N")[2..].iter().map(|cell| cell.parse().unwrap()).collect();
    assert!(shifts.len() == 5 && force[0] == 0.0 && force[1] > 0.5 * force[2], "{force:?}");
    assert!(force[2] < 0.04 && (back[4] / force[2] - 1.0).abs() < 1e-11, "{force:?}");
    // The first shift halved is the start of the way back.
    assert!((back[2] - (force[2] - 2.0 * force[1])).abs() < 1e-9 && forth[2] + back[2] == 0.0);
    // The head of a NumPy file, and a number for each pixel.
    assert_eq!(std::fs::read(bench.path("map.npy")).unwrap().len(), 128 + 8 * 128 * 128);
    assert_eq!(run.results().len(), 3, "{}", run.messages);
    assert!(run.messages.contains("warning[few-patches]: "), "{}", run.messages);
    // The amplitude of a force is the shift of that force.
    let table = bench.data(&format!("{slip} --tangential-force {},0.03", force[2]));
    assert!((column(&table, "amplitude_m")[0] / 1e-8 - 1.0).abs() < 1e-5, "{table}");
}
