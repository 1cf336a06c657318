//! `bem`, `joint` and `curve` on the scan of a ball, pressed alike.

use crate::bench::{Bench, column};

const MODULUS: f64 = 210e9 / (2.0 * (1.0 - 0.09));
const RADIUS: f64 = 2e-3;
const LOAD: f64 = 10.0;

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
