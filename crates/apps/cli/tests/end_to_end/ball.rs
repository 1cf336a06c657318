//! `bem`, `joint` and `curve` on the scan of a ball, pressed alike, against Hertz, Cattaneo and
//! Mindlin.

use crate::bench::{Bench, column};

const MODULUS: f64 = 210e9 / (2.0 * (1.0 - 0.09));
const RADIUS: f64 = 2e-3;
const LOAD: f64 = 10.0;
/// 4 G/E of like bodies with a Poisson's ratio of 0.3.
const RATIO: f64 = 1.4 / 1.7;

/// Two bodies of steel, 65 x 65 points around the top of a ball of one.
fn bench() -> Bench {
    let bench = Bench::new();
    let at = |k: usize| (k as f64 - 32.0) * 2.5e-6;
    let height = |x, y| -(at(x) * at(x) + at(y) * at(y)) / (2.0 * RADIUS);
    let row = |y| (0..65).map(|x| height(x, y).to_string()).collect::<Vec<_>>().join(" ");
    bench.write("ball.txt", &(0..65).map(row).collect::<Vec<_>>().join("\n"));
    let body = "[[body]]\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\n";
    let scene = format!(
        "nominal_area = {}\n{body}{body}[surface]\nfile = \"ball.txt\"\nunit = \"m\"\npixel_size = 2.5e-6\n",
        (65.0 * 2.5e-6f64).powi(2)
    );
    bench.write("ball.toml", &scene);
    bench.write("repeated.toml", &format!("{scene}[options]\nboundary = \"periodic\"\n"));
    bench
}

/// The depth to which Hertz' ball is pressed \[m\].
fn depth() -> f64 {
    (9.0 * LOAD * LOAD / (16.0 * RADIUS * MODULUS * MODULUS)).cbrt()
}

#[track_caller]
fn close(found: f64, required: f64, within: f64) {
    assert!((found / required - 1.0).abs() < within, "{found:e} {required:e}");
}

/// A number behind these words of a message.
fn told(messages: &str, words: &str) -> f64 {
    let (_, rest) = messages.split_once(words).unwrap();
    rest.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn a_ball_opens_as_hertz_found() {
    let bench = bench();
    let run = bench.run("joint ball.toml --model bem --load 10 --retreat 0nm,50nm");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(run.messages.matches("note[single-body]").count(), 1, "{}", run.messages);
    let (force, stiffness) = (column(&run.out, "force_N"), column(&run.out, "stiffness_N_per_m"));
    close(stiffness[0], 2.0 * MODULUS * (RADIUS * depth()).sqrt(), 0.01);
    close(force[1], LOAD * (1.0 - 50e-9 / depth()).powf(1.5), 2e-3);
    close(told(&run.messages, "a retreat of "), depth(), 5e-3);
    // One description of the press: as `bem` and `curve` solve it.
    let asked = "--load 10 --quantity unloading-stiffness --format csv";
    for command in ["bem ball.toml", "curve ball.toml --model bem"] {
        let out = bench.data(&format!("{command} {asked}"));
        close(column(&out, "unloading_stiffness_N_per_m")[0], stiffness[0], 1e-9);
    }
}

#[test]
fn a_ball_slips_as_cattaneo_and_mindlin_found() {
    let bench = bench();
    let (limit, whole) = (0.2 * LOAD, 0.2 * depth() / RATIO);
    let slip = |amplitude: f64| {
        let line = "joint ball.toml --model bem --load 10 --friction 0.2 --points 2";
        let run = bench.run(&format!("{line} --amplitude {amplitude}"));
        assert_eq!(run.code, Some(0), "{}", run.messages);
        (column(&run.out, "forth_N")[1], told(&run.messages, "dissipates "), run.messages)
    };
    for amplitude in [150e-9, 300e-9] {
        let share = amplitude / whole;
        let force = 1.0 - (1.0 - share).powf(1.5);
        let under = share - 0.4 * (1.0 - (1.0 - share).powf(2.5));
        let (found, loss, messages) = slip(amplitude);
        close(found, limit * force, 5e-3);
        close(loss, limit * whole * (8.0 * under - 4.0 * force * share), 0.01);
        let sliding = told(&messages, "a shift of ");
        close(sliding, whole * (1.0 - 0.01f64.powf(2.0 / 3.0)), 5e-3);
    }
}

#[test]
fn options_press_the_scan_alike_in_every_command() {
    let bench = bench();
    let asked = "--load 10 --quantity unloading-stiffness --format csv";
    let stiffness = |line: &str| {
        let (asked, name) = match line.starts_with("joint") {
            true => ("--load 10 --retreat 0", "stiffness_N_per_m"),
            false => (asked, "unloading_stiffness_N_per_m"),
        };
        let run = bench.run(&format!("{line} {asked}"));
        assert_eq!(run.code, Some(0), "{line}: {}", run.messages);
        assert!(!run.messages.contains("single-body"), "{line}: {}", run.messages);
        column(&run.out, name)[0]
    };
    let commands = ["bem", "joint --model bem", "curve --model bem"];
    // The scene, or the option in front of it.
    for (scene, boundary) in [
        ("ball.toml", "--boundary periodic"),
        ("ball.toml", "--boundary free"),
        ("repeated.toml", ""),
        ("repeated.toml", "--boundary free"),
    ] {
        let found = commands.map(|command| stiffness(&format!("{command} {scene} {boundary}")));
        close(found[1], found[0], 1e-9);
        close(found[2], found[0], 1e-9);
        let free = 2.0 * MODULUS * (RADIUS * depth()).sqrt();
        match boundary.ends_with("free") {
            true => close(found[0], free, 0.01),
            false => assert!(found[0] > 1.5 * free, "{:e} {free:e}", found[0]),
        }
    }
    // Without the hardness the ball is elastic again.
    let scene = bench.read("ball.toml").replacen("0.3\n", "0.3\nhardness = 1e9\n", 2);
    bench.write("soft.toml", &scene);
    for command in commands {
        let soft = stiffness(&format!("{command} soft.toml --boundary free"));
        let elastic = stiffness(&format!("{command} soft.toml --boundary free --elastic"));
        close(elastic, 2.0 * MODULUS * (RADIUS * depth()).sqrt(), 0.01);
        assert!(soft > 1.05 * elastic, "{soft:e} {elastic:e}");
    }
}
