//! What an evaluation, a scene, a curve and an inverse cost. See `crates/bench/README.md`; the
//! report of `cargo xtask report` holds other methods beside them.

use std::hint::black_box;

use asperity::{
    At, Case, HeightDistribution, Interface, Model, Quantity, Request, Scene, Surface, Sweep,
    TabulatedHeights, Tolerance, linspace,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

type Outcome<T> = Result<T, asperity::ContactError>;

fn scene() -> Outcome<Scene> {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    interface.pressure_factor = Some(0.58);
    let surface = Surface::from_plasticity_index(6.0, 0.04, 1e-6, &interface)?;
    Ok(Scene::new(interface, surface, 3e-5))
}

fn request(quantity: Quantity) -> Outcome<Request> {
    Ok(Request::new([quantity]).within(Tolerance::new(1e-10)?))
}

/// Separations in an order that no branch predictor learns.
fn separations() -> Vec<f64> {
    (0..1024).map(|k| -1.0 + 7.0 * f64::from(k * 619 % 1024) / 1024.0).collect()
}

fn evaluations(c: &mut Criterion) -> Outcome<()> {
    let separations = separations();
    for id in ["gw", "gw-random", "ke", "ke-random", "ke-pairs", "jg", "jg-pairs", "gao", "at"] {
        for quantity in [Quantity::Force, Quantity::Tangent] {
            let compiled = id.parse::<Model>()?.compile(&scene()?, &request(quantity)?)?;
            let mut k = 0;
            c.bench_function(&format!("evaluate/{id}/{quantity}"), |b| {
                b.iter(|| {
                    k = (k + 1) % separations.len();
                    compiled.evaluate(quantity, black_box(separations[k])).map(|e| e.scaled)
                });
            });
        }
    }
    Ok(())
}

/// 1024 values into plain arrays.
fn arrays(c: &mut Criterion) -> Outcome<()> {
    let separations = separations();
    let pair = [Quantity::Force, Quantity::Tangent];
    for (name, asked) in [("force", &pair[..1]), ("force and tangent", &pair)] {
        let request = Request::new(asked.iter().copied()).within(Tolerance::new(1e-10)?);
        let compiled = "ke".parse::<Model>()?.compile(&scene()?, &request)?;
        let mut columns = vec![vec![0.0; separations.len()]; asked.len()];
        let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        c.bench_function(&format!("array of 1024/ke/{name}"), |b| {
            b.iter(|| compiled.fill(asked, black_box(&separations), &mut columns));
        });
    }
    Ok(())
}

fn whole_answers(c: &mut Criterion) -> Outcome<()> {
    let (scene, request) = (scene()?, request(Quantity::Force)?);
    let curve = request.clone().at(linspace(0.0, 4.0, 401));
    for id in ["ke", "ke-pairs", "jg", "jg-pairs"] {
        let model: Model = id.parse()?;
        c.bench_function(&format!("compile and one value/{id}"), |b| {
            b.iter(|| model.compile(&scene, &request)?.evaluate(Quantity::Force, 1.0));
        });
        let one = request.clone().at([1.0]);
        c.bench_function(&format!("one value/{id}"), |b| b.iter(|| model.solve(&scene, &one)));
        c.bench_function(&format!("curve of 401/{id}"), |b| b.iter(|| model.solve(&scene, &curve)));
        let compiled = model.compile(&scene, &request)?;
        c.bench_function(&format!("inverse/{id}"), |b| {
            b.iter(|| compiled.separations_at(black_box(37.0)));
        });
    }
    let gao: Model = "gao".parse()?;
    let mut slow = c.benchmark_group("law and curve of 401");
    slow.sample_size(10);
    slow.bench_function("gao", |b| b.iter(|| gao.solve(&scene, &curve)));
    Ok(())
}

/// Scenes that differ in moduli, hardness and roughness.
fn sweeps(c: &mut Criterion) -> Outcome<()> {
    let scene = scene()?;
    let cases: Vec<Case> = (0..4096u32)
        .map(|k| {
            let share = f64::from(k * 1597 % 4096) / 4096.0;
            let mut scene = scene.clone();
            scene.surface.asperity_height_std *= 100f64.powf(share - 0.5);
            scene.interface.equivalent_modulus *= 0.8 + 0.4 * share;
            scene.interface.hardness = scene.interface.hardness.map(|h| h * (0.9 + 0.2 * share));
            Case::new(scene, 4.0 * share)
        })
        .collect();
    let ke: Model = "ke".parse()?;
    let sweep = Sweep::new(&ke, &[Quantity::Force], Tolerance::new(1e-10)?);
    c.bench_function("sweep of 4096 scenes/ke", |b| b.iter(|| sweep.evaluate_all(&cases)));
    let rougher: Vec<Case> = cases
        .iter()
        .map(|case| {
            let mut scene = scene.clone();
            scene.surface.asperity_height_std = case.scene.surface.asperity_height_std;
            Case::new(scene, case.at)
        })
        .collect();
    c.bench_function("sweep of 4096 roughnesses/ke", |b| b.iter(|| sweep.evaluate_all(&rougher)));
    Ok(())
}

/// Scenes whose materials are drawn, so that no law recurs, at a separation and at the load that
/// belongs to it.
fn drawn(c: &mut Criterion) -> Outcome<()> {
    let scene = scene()?;
    let mut group = c.benchmark_group("drawn");
    group.sample_size(10);
    for (id, rows) in [
        ("ke", 4096u32),
        ("ke-pairs", 4096),
        ("zmc", 1024),
        ("zmc-pairs", 1024),
        ("jg", 1024),
        ("jg-pairs", 1024),
        ("gao", 16),
        ("at", 16),
    ] {
        let model: Model = id.parse()?;
        let all = || Sweep::new(&model, &[Quantity::Force], Tolerance::default());
        let cases: Vec<Case> = (0..rows)
            .map(|k| {
                let share = |step: u32| f64::from((k * step + 1) % rows) / f64::from(rows);
                let mut scene = scene.clone();
                scene.surface.asperity_height_std *= 10f64.powf(share(619) - 0.5);
                let of = &mut scene.interface;
                of.equivalent_modulus *= 0.8 + 0.4 * share(389);
                of.hardness = of.hardness.map(|h| h * (0.8 + 0.4 * share(157)));
                of.poissons_ratio += 0.1 * share(97);
                Case::new(scene, 4.0 * share(1))
            })
            .collect();
        let forces = all().evaluate_all(&cases).into_iter().collect::<Outcome<Vec<_>>>()?;
        let loads: Vec<Case> = cases
            .iter()
            .zip(forces)
            .map(|(case, force)| Case::new(case.scene.clone(), At::Load(force[0].value())))
            .collect();
        group.throughput(Throughput::Elements(rows.into()));
        group.bench_function(id, |b| b.iter(|| all().evaluate_all(&cases)));
        group.bench_function(format!("{id}, to a separation"), |b| {
            b.iter(|| all().separations(&loads));
        });
    }
    Ok(())
}

/// KE's force on measured heights: from its series, and integrated anew.
fn tables(c: &mut Criterion) -> Outcome<()> {
    let ke: Model = "ke".parse()?;
    for rows in [101u32, 1001] {
        let point = |k: u32| {
            let z = -4.0 + 9.0 * f64::from(k) / f64::from(rows - 1);
            (1e-6 * z, (-0.5 * z * z).exp() * (1.0 + 0.2 * f64::from(7 * k).sin()))
        };
        let points: Vec<(f64, f64)> = (0..rows).map(point).collect();
        let heights = TabulatedHeights::new("measured", &points)?;
        let mut scene = scene()?;
        scene.surface.asperity_height_std = heights.standard_deviation();
        scene.heights = HeightDistribution::other(heights);
        let separations: Vec<f64> = separations().into_iter().map(|d| 0.5 * d).collect();
        let compiled = ke.compile(&scene, &request(Quantity::Force)?)?;
        let sweep = Sweep::new(&ke, &[Quantity::Force], Tolerance::new(1e-10)?);
        let mut k = 0;
        let mut next = || {
            k = (k + 1) % separations.len();
            separations[k]
        };
        c.bench_function(&format!("table of {rows}, compiled/ke"), |b| {
            b.iter(|| compiled.evaluate(Quantity::Force, black_box(next())).map(|e| e.scaled));
        });
        c.bench_function(&format!("table of {rows}, once/ke"), |b| {
            b.iter(|| sweep.evaluate(&Case::new(scene.clone(), next())));
        });
    }
    Ok(())
}

fn all(c: &mut Criterion) {
    for group in [evaluations, arrays, whole_answers, sweeps, drawn, tables] {
        if let Err(error) = group(c) {
            eprintln!("error: {error}");
        }
    }
}

criterion_group!(benches, all);
criterion_main!(benches);
