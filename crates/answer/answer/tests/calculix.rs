//! CalculiX reads the exported tables: a block pressed on a block carries the force, and conducts
//! the heat, that the model gives. Skipped with a note where ccx is not installed (Debian's package
//! is calculix-ccx).
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test: a panic is the failure")]

use std::fs;
use std::path::Path;
use std::process::Command;

use asperity::{
    At, Body, ContactModel, Interface, Model, Quantity, Request, Scene, Surface, Tolerance,
};
use asperity_answer::{Export, Exported, Nodes, Sheet, Silent, Subject, TableFormat, UnitSystem};
use asperity_scene::SceneFile;

/// Printed digits of ccx, seven, with which overclosures are differences.
const PRINTED: f64 = 5e-6;
/// Closing of the blocks in each step [mm].
const STEPS: [f64; 5] = [4e-4, 8e-4, 1.4e-3, 2e-3, 2.4e-3];

fn scene() -> Scene {
    let mut steel = Body::new(210e9, 0.3, 2e9);
    steel.thermal_conductivity = Some(50.0);
    let interface = Interface::between(&steel, &steel).unwrap();
    Scene::new(interface, Surface::new(2e-4, 2e8, 1e-6), 1e-4)
}

fn exported(model: &Model, scene: &Scene, error: f64, conductance: bool) -> Exported {
    let file = SceneFile::from(scene.clone());
    let tolerance = Tolerance::default();
    let export = Export {
        subject: Subject { file: &file, name: "", model, tolerance },
        nodes: Nodes::Range {
            ends: [At::Pressure(1e5), At::Pressure(2e7)],
            count: 2,
            log: false,
            max_error: Some(error),
        },
        format: TableFormat::Calculix,
        units: UnitSystem::MM_TONNE_S,
        conductance,
    };
    export.answer(&mut Sheet::default(), &Silent).unwrap()
}

/// The values of one quantity of a scene at a pressure or separation, over the nominal area.
fn value(model: &Model, scene: &Scene, quantity: Quantity, at: At) -> f64 {
    model.solve(scene, &Request::new([quantity]).at([at])).unwrap().values(quantity).unwrap()[0]
}

/// Two cubes of 10 mm, one on the other, of steel without lateral contraction; the upper one is
/// moved down in steps, and kept at 400 K above 300 K.
fn deck(interaction: &str, pair: &str, procedure: &str) -> String {
    let corners = |first: u32, base: f64| -> String {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)];
        let both = [base, base + 10.0].into_iter().flat_map(|z| square.map(|(x, y)| (x, y, z)));
        both.zip(first..).map(|((x, y, z), node)| format!("{node}, {x}, {y}, {z}\n")).collect()
    };
    let printed = ["TOP, TOTALS=ONLY\nRF", "LOWERFACE\nU", "UPPERFACE\nU"];
    let heat = ["TOP, TOTALS=ONLY\nRFL", "LOWERFACE\nNT", "UPPERFACE\nNT"];
    let thermal = procedure.starts_with("COUPLED");
    let printed = printed.iter().chain(heat.iter().filter(|_| thermal));
    let printed: String = printed.map(|what| format!("*NODE PRINT, NSET={what}\n")).collect();
    let temperatures = if thermal { "TOP, 11, 11, 400.\nLOWEST, 11, 11, 300.\n" } else { "" };
    let steps = STEPS.map(|down| {
        format!(
            "*STEP, NLGEOM, INC=1000
*{procedure}
*BOUNDARY
TOP, 3, 3, -{down}
{temperatures}{printed}*END STEP
"
        )
    });
    format!(
        include_str!("calculix/blocks.inp"),
        lower = corners(1, 0.0),
        upper = corners(11, 10.0),
        interaction = interaction,
        pair = pair,
        steps = steps.concat()
    )
}

/// The printed results of ccx; `None` where it is not installed.
fn solved(name: &str, deck: &str) -> Option<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    fs::write(folder.join(format!("{name}.inp")), deck).unwrap();
    let Ok(run) = Command::new("ccx").arg(name).current_dir(folder).output() else {
        eprintln!("skipped: ccx is not installed");
        return None;
    };
    let log = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success() && !log.contains("*ERROR"), "{log}");
    Some(fs::read_to_string(folder.join(format!("{name}.dat"))).unwrap())
}

/// The last number of the first row of the blocks with this head that end a step, at a whole time.
fn ends(results: &str, head: &str) -> Vec<f64> {
    let lines: Vec<&str> = results.lines().collect();
    let last = |line: &str| -> f64 { line.split_whitespace().last().unwrap().parse().unwrap() };
    let ends = |line: &str| line.contains(head) && last(line).fract() == 0.0;
    (0..lines.len()).filter(|k| ends(lines[*k])).map(|k| last(lines[k + 2])).collect()
}

#[test]
fn a_block_on_a_block_carries_the_force_of_the_model_at_that_clearance() {
    let (model, scene) = ("ke".parse().unwrap(), scene());
    let table = exported(&model, &scene, 1e-3, false);
    let Some(results) = solved("pressed", &deck(&table.text, "NODE TO SURFACE", "STATIC")) else {
        return;
    };
    let begins = table.text.split("at a separation of ").nth(1).unwrap();
    let begins = 1e-3 * begins.split(' ').next().unwrap().parse::<f64>().unwrap();
    let [force, lower, upper] =
        ["total force", "set LOWERFACE", "set UPPERFACE"].map(|head| ends(&results, head));
    let mut worst = 0.0_f64;
    for ((force, lower), upper) in force.iter().zip(&lower).zip(&upper) {
        let at = At::metres(begins + 1e-3 * (upper - lower));
        let wanted = value(&model, &scene, Quantity::Force, at);
        worst = worst.max((-force / wanted - 1.0).abs());
        println!("{} MPa: off by {:e}", -force / 100.0, -force / wanted - 1.0);
    }
    assert_eq!(force.len(), STEPS.len());
    assert!(-force[0] > 10.0 && -force[4] > 700.0, "{force:?}");
    assert!(worst < table.errors.unwrap()[0] + PRINTED, "{worst} {}", table.errors.unwrap()[0]);
}

/// The same blocks of 3 x 3 x 1 elements under 10 MPa, joined node to node.
fn loaded(interaction: &str) -> String {
    const N: u32 = 3;
    let node = |block: u32, x: u32, y: u32, z: u32| 1 + block * 100 + (z * 4 + y) * 4 + x;
    let all = || (0..2).flat_map(|b| (0..=N).flat_map(move |x| (0..=N).map(move |y| (b, x, y))));
    let side = |k: u32| 10.0 * f64::from(k) / f64::from(N);
    let nodes = all().flat_map(|(b, x, y)| [(b, x, y, 0), (b, x, y, 1)]);
    let nodes: String = nodes
        .map(|(b, x, y, z)| {
            format!("{}, {:.9}, {:.9}, {}\n", node(b, x, y, z), side(x), side(y), 10 * (b + z))
        })
        .collect();
    let elements: String = all()
        .filter(|(_, x, y)| *x < N && *y < N)
        .map(|(b, x, y)| {
            let square =
                |z| [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(|(x, y)| node(b, x, y, z));
            let corners: Vec<String> =
                square(0).into_iter().chain(square(1)).map(|k| k.to_string()).collect();
            format!("{}, {}\n", 1 + b * 100 + y * N + x, corners.join(", "))
        })
        .collect();
    format!(
        include_str!("calculix/loaded.inp"),
        nodes = nodes,
        elements = elements,
        interaction = interaction
    )
}

#[test]
fn faces_pass_a_uniform_pressure() {
    let (model, scene) = ("ke".parse().unwrap(), scene());
    let table = exported(&model, &scene, 1e-2, false);
    assert!(table.text.contains("TYPE=ELEMENT"));
    let Some(results) = solved("loaded", &loaded(&table.text)) else { return };
    let last = results.rsplit("stresses").next().unwrap();
    let numbers = |line: &str| -> Vec<f64> {
        line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
    };
    // Element, integration point, xx, yy, zz, ...
    let rows: Vec<Vec<f64>> = last.lines().map(numbers).filter(|row| row.len() == 8).collect();
    assert_eq!(rows.len(), 2 * 9 * 8);
    for row in rows {
        assert!((row[4] + 10.0).abs() < 0.01, "{row:?}");
    }
}

#[test]
fn heat_flows_between_the_blocks_as_the_model_says_at_that_pressure() {
    let (model, scene): (Model, _) = ("ke".parse().unwrap(), scene());
    let text = exported(&model, &scene, 1e-2, true).text;
    let conductance = &text[text.find("** thermal conductance").unwrap()..];
    let bound = conductance.split("largest relative error ").nth(1).unwrap();
    let bound: f64 = bound.split(',').next().unwrap().parse().unwrap();
    let line = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n";
    let stiffness: f64 = text.split(line).nth(1).unwrap().lines().next().unwrap().parse().unwrap();
    let procedure = "COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE, DIRECT\n1., 1.";
    let Some(results) = solved("heated", &deck(&text, "SURFACE TO SURFACE", procedure)) else {
        return;
    };
    let heads =
        ["total force", "heat generation", "temperatures for set L", "temperatures for set U"];
    let [force, heat, lower, upper] = heads.map(|head| ends(&results, head));
    let closed = ["(vx,vy,vz) for set L", "(vx,vy,vz) for set U"].map(|head| ends(&results, head));
    let mut worst = 0.0_f64;
    for k in 0..STEPS.len() {
        let pressure = -force[k] / 100.0;
        let found = 1e3 * heat[k] / 100.0 / (upper[k] - lower[k]);
        let at = At::Pressure(1e6 * pressure);
        let wanted = value(&model, &scene, Quantity::ThermalConductancePerArea, at);
        worst = worst.max((found / wanted - 1.0).abs());
        println!("{pressure} MPa: {found} W/(m2 K), off by {:e}", found / wanted - 1.0);
        let overclosure = closed[0][k] - closed[1][k];
        assert!((pressure / (stiffness * overclosure) - 1.0).abs() < 1e-4, "{pressure}");
    }
    assert!(worst < bound + 4.0 * PRINTED, "{worst} {bound}");
}
