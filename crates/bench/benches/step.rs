//! Time of one step: on the virgin curve, in unloading from a table, and in unloading integrated
//! anew. Paired in one run; `cargo bench --bench step`.

use std::hint::black_box;

use asperity::Gao;
use asperity_core::{
    At, Contact, ContactError, ContactModel, Interface, Quantity, Request, Scene, Separation,
    Surface, Tolerance,
};

use asperity_joints::{Joint, UnloadingLaw};
use asperity_ke::KogutEtsion;
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};

const SIGMA: f64 = 1e-6;

fn joint() -> Result<Joint, ContactError> {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.pressure_factor = Some(0.58);
    interface.equivalent_shear_modulus = Some(41e9);
    let surface = Surface::from_plasticity_index(6.0, 0.04, SIGMA, &interface)?;
    let scene = Scene::new(interface, surface, 3e-5);
    Joint::new(&KogutEtsion, &scene, UnloadingLaw::Hertz, Tolerance::default())
}

fn steps(c: &mut Criterion) -> Result<(), ContactError> {
    let joint = joint()?;
    let range = (-SIGMA, 5.0 * SIGMA);
    let table = joint.table(range, 1e-6)?;
    // Closest approaches and retreats in an order that defeats branch prediction.
    let places: Vec<(f64, f64)> = (0..1024)
        .map(|k| {
            let share = |prime: u32| f64::from(k * prime % 1024) / 1024.0;
            ((-1.0 + 5.9 * share(619)) * SIGMA, 0.5 * share(389) * SIGMA)
        })
        .collect();
    let mut k = 0;
    let mut next = move || {
        k = (k + 1) % places.len();
        places[k]
    };
    let virgin = joint.virgin();
    c.bench_function("step/virgin-force-alone", |b| {
        b.iter(|| {
            let at = Separation::sigmas(black_box(next().0) / SIGMA);
            virgin.evaluate(Quantity::Force, at).map(|force| force.value())
        })
    });
    c.bench_function("step/virgin", |b| b.iter(|| table.at(black_box(next().0), f64::INFINITY)));
    c.bench_function("step/way-back", |b| {
        b.iter(|| {
            let (closest, retreat) = black_box(next());
            table.at(closest + retreat, closest)
        })
    });
    let way = joint.unloading(At::metres(SIGMA))?;
    c.bench_function("step/way-back-integrated", |b| b.iter(|| way.force(black_box(next().1))));
    let request = Request::new([Quantity::Force, Quantity::Tangent]).at_loads([1.0]);
    let models: [(&str, &dyn ContactModel); 2] = [("ke", &KogutEtsion), ("gao", &Gao::default())];
    let mut slow = c.benchmark_group("first-call");
    slow.sample_size(10);
    for (name, model) in models {
        slow.bench_function(name, |b| {
            let compile = || model.compile(joint.scene(), &request);
            let call = |contact: Result<Box<dyn Contact>, ContactError>| {
                contact?.force_and_tangent(black_box(1.0))
            };
            b.iter_batched(compile, call, BatchSize::PerIteration)
        });
    }
    slow.finish();
    let mut slow = c.benchmark_group("table");
    slow.sample_size(10);
    slow.bench_function("build", |b| b.iter(|| joint.table(black_box(range), 1e-6)));
    slow.finish();
    Ok(())
}

fn all(c: &mut Criterion) {
    if let Err(error) = steps(c) {
        panic!("{error}");
    }
}

criterion_group!(benches, all);
criterion_main!(benches);
