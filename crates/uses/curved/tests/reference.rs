//! Curved contacts beside the numbers of an independent solver, `tests/reference/curved.csv`.
#![allow(clippy::unwrap_used, reason = "a test: a panic is the failure")]

use std::f64::consts::PI;
use std::sync::Arc;

use asperity_core::{
    At, Code, Contact, ContactError, ContactModel, Described, Interface, Quantity, Request, Scene,
    Separation, Surface, Tolerance, Wraps,
};
use asperity_curved::{BetweenCurved, Curved, Shape, Solution};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;

const REFERENCE: &str = include_str!("../../../../tests/reference/curved.csv");
const ASKED: [Quantity; 3] = [Quantity::Area, Quantity::Contacts, Quantity::UnloadingStiffness];

type Row = std::collections::HashMap<String, String>;

fn rows() -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(REFERENCE.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}

fn number(row: &Row, name: &str) -> Option<f64> {
    row[name].parse().ok()
}

/// The model, the scene and the bodies of a row.
fn inputs(row: &Row) -> (Arc<dyn ContactModel>, Scene, Shape) {
    let of = |name: &str| number(row, name).unwrap();
    let mut interface = Interface::new(of("E"), of("poissons_ratio"), of("hardness"));
    interface.pressure_factor = Some(of("pressure_factor"));
    let surface =
        Surface::new(of("asperity_radius"), of("asperity_density"), of("asperity_height_std"));
    let scene = Scene::new(interface, surface, 1.0);
    let model: Arc<dyn ContactModel> = match &*row["model"] {
        "gw" => Arc::new(GreenwoodWilliamson),
        "ke" => Arc::new(KogutEtsion),
        _ => Arc::new(JacksonGreen::default()),
    };
    let shape = match number(row, "Ry") {
        Some(radius_y) => Shape::Point { radius_x: of("Rx"), radius_y },
        None => Shape::Line {
            radius: of("Rx"),
            length: 1.0,
            reference_length: number(row, "reference_length"),
        },
    };
    (model, scene, shape)
}

fn curved(row: &Row, tolerance: f64) -> Curved {
    let (model, scene, shape) = inputs(row);
    Curved::new(&*model, &scene, shape, &ASKED, Tolerance::new(tolerance).unwrap()).unwrap()
}

/// The largest error over the row's numbers: relative, of lengths over the larger of value and σ.
fn error(row: &Row, found: &mut Solution) -> (f64, &'static str) {
    let sigma = number(row, "asperity_height_std").unwrap();
    let lengths = [
        ("approach", found.approach().unwrap()),
        ("extra_approach", found.approach_beyond_hertz()),
        ("center_separation", found.central_separation()),
    ];
    let mut others = vec![
        ("peak_pressure", found.peak_pressure()),
        ("axis_x", found.axes()[0]),
        ("real_area", found.sum(Quantity::Area).unwrap()),
        ("contacts", found.sum(Quantity::Contacts).unwrap()),
        ("stiffness", found.tangent().unwrap()),
        ("unloading_stiffness", found.unloading_stiffness().unwrap()),
        ("center_area_fraction", found.central_area_fraction().unwrap()),
    ];
    others.extend(found.effective_radius().map(|radius| ("effective_radius", radius)));
    if number(row, "axis_y").is_some() {
        others.push(("axis_y", found.axes()[1]));
    }
    let of = |name| number(row, name);
    let length = |(name, value): (&'static str, f64)| {
        let right = of(name).unwrap();
        ((value - right).abs() / right.abs().max(sigma), name)
    };
    let other =
        |(name, value): (&'static str, f64)| ((value / of(name).unwrap() - 1.0).abs(), name);
    let all = lengths.into_iter().map(length).chain(others.into_iter().map(other));
    all.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

fn long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}

#[test]
fn errors_are_below_the_tolerance() {
    let rows = rows();
    assert_eq!(rows.len(), 38);
    for (k, row) in rows.iter().enumerate() {
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let curved = curved(row, tolerance);
            let load = number(row, "load").unwrap();
            // Nearly smooth bodies take many points.
            let [approach, extra, sigma] =
                ["approach", "extra_approach", "asperity_height_std"].map(|of| number(row, of));
            let smooth = (approach.unwrap() - extra.unwrap()) / sigma.unwrap();
            let points = (12.0 - 2.2 * (tolerance.log10() + 6.0)) * smooth.sqrt();
            if !long() && (tolerance < 1e-7 && k % 3 > 0 || points > 50.0) {
                continue;
            }
            let mut found = curved.at_load(load).unwrap();
            let (error, name) = error(row, &mut found);
            assert!(error < tolerance, "row {k}, {tolerance:e}: {name} errs by {error:.1e}");
            let weight = found.grid().1;
            let sum = found.pressures().iter().sum::<f64>() * weight[0] * weight[1];
            assert!((sum / load - 1.0).abs() < 1e-10, "{}", sum / load - 1.0);
        }
    }
}

/// GW with η R σ = .05, R = 500 σ, p₀ = 1.37 GPa and E = 115 GPa between spheres with this α.
fn sphere(alpha: f64, tolerance: f64) -> (Curved, f64, [f64; 3]) {
    let (sigma, modulus, peak) = (1e-6, 115e9_f64, 1.37e9);
    let (asperity_radius, radius) = (500.0 * sigma, 4.0 * sigma * (modulus / peak).powi(2));
    // δ = (π p₀/(2 E))² R
    let radius = radius / (PI * PI * alpha);
    let surface = Surface::new(asperity_radius, 0.05 / (asperity_radius * sigma), sigma);
    let scene = Scene::new(Interface::new(modulus, 0.3, 1e12), surface, 1.0);
    let shape = Shape::Point { radius_x: radius, radius_y: radius };
    let a = PI * peak * radius / (2.0 * modulus);
    let load = 2.0 / 3.0 * PI * a * a * peak;
    let tolerance = Tolerance::new(tolerance).unwrap();
    let asked = [Quantity::Area];
    let curved = Curved::new(&GreenwoodWilliamson, &scene, shape, &asked, tolerance).unwrap();
    (curved, load, [peak, a, 2.0 * modulus * a])
}

#[test]
fn smooth_and_rough_spheres_have_their_limits() {
    // Peak, effective radius and stiffness over Hertz, of an axisymmetric solution, to 3 digits.
    for (alpha, right) in [
        (0.03, [0.946, 1.035, 0.982]),
        (0.1, [0.835, 1.114, 0.939]),
        (0.3, [0.627, 1.304, 0.826]),
        (1.0, [0.349, 1.775, 0.572]),
    ] {
        let (curved, load, hertz) = sphere(alpha, 1e-5);
        let mut found = curved.at_load(load).unwrap();
        let all =
            [found.peak_pressure(), found.effective_radius().unwrap(), found.tangent().unwrap()];
        for ((found, hertz), right) in all.into_iter().zip(hertz).zip(right) {
            assert!((found / hertz - right).abs() < 6e-4, "{alpha}: {} {right}", found / hertz);
        }
    }
    // Undeformed bodies: F = 2π R ∫ P dd from d₀ on.
    let (curved, load, _) = sphere(3000.0, 1e-6);
    let found = curved.at_load(load).unwrap();
    let ([n, _], [step, _]) = found.grid();
    let middle = &found.separations()[n / 2 * n..n / 2 * n + n];
    let undeformed = |i: usize| ((i as f64 - (n / 2) as f64) * step).powi(2);
    let radius = 4e-6 * (115e9_f64 / 1.37e9).powi(2) / (PI * PI * 3000.0);
    let bent = middle.iter().enumerate().map(|(i, d)| d - undeformed(i) / (2.0 * radius));
    let (low, high) = bent.fold((f64::INFINITY, 0.0_f64), |(l, h), d| (l.min(d), h.max(d)));
    assert!(high - low < 1e-3 * 1e-6, "{low:e} {high:e}");
}

#[test]
fn loads_and_approaches_are_inverse_and_axes_are_alike() {
    for k in [4, 18, 30, 32] {
        let row = &rows()[k];
        let curved = curved(row, 1e-6);
        let load = number(row, "load").unwrap();
        let approach = number(row, "approach").unwrap();
        let found = curved.at_approach(approach).unwrap();
        assert!((found.load / load - 1.0).abs() < 1e-5, "row {k}: {}", found.load / load);
    }
    let mut row = rows().swap_remove(30);
    let first = curved(&row, 1e-6);
    let one = first.at_load(20.0).unwrap();
    let turned = [row["Ry"].clone(), row["Rx"].clone()];
    let [x, y] = turned;
    row.insert("Rx".into(), x);
    row.insert("Ry".into(), y);
    let second = curved(&row, 1e-6);
    let other = second.at_load(20.0).unwrap();
    assert!((one.axes()[0] / other.axes()[1] - 1.0).abs() < 1e-10);
    assert!((one.approach().unwrap() / other.approach().unwrap() - 1.0).abs() < 1e-10);
    assert_eq!(one.steps(), other.steps());
}

#[test]
fn a_model_between_curved_bodies_answers_within_its_bounds() {
    let quantities = [
        (Quantity::Approach, "approach"),
        (Quantity::ApproachBeyondHertz, "extra_approach"),
        (Quantity::PeakPressure, "peak_pressure"),
        (Quantity::AxisX, "axis_x"),
        (Quantity::Area, "real_area"),
        (Quantity::Contacts, "contacts"),
        (Quantity::Tangent, "stiffness"),
        (Quantity::UnloadingStiffness, "unloading_stiffness"),
        (Quantity::CentralSeparation, "center_separation"),
        (Quantity::CentralAreaFraction, "center_area_fraction"),
        (Quantity::EffectiveRadius, "effective_radius"),
    ];
    let asked = || Request::new(quantities.map(|(quantity, _)| quantity));
    for row in [&rows()[4], &rows()[18], &rows()[30]] {
        let (model, scene, shape) = inputs(row);
        let between = BetweenCurved::new(Named(model), shape);
        let load = number(row, "load").unwrap();
        for request in [asked(), asked().within(Tolerance::new(1e-4).unwrap())] {
            let contact = between.compile(&scene, &request).unwrap();
            for (quantity, name) in quantities {
                let Some(right) = number(row, name) else {
                    assert!(contact.evaluate(quantity, At::Load(load)).is_err());
                    continue;
                };
                let found = contact.evaluate(quantity, At::Load(load)).unwrap();
                let error = (found.value() - right).abs();
                assert!(error <= found.relative_error() * found.value().abs(), "{name}");
            }
            // An approach is a separation below 0.
            let place = contact.separation(At::Load(load)).unwrap();
            let back = contact.evaluate(Quantity::Approach, place).unwrap().value();
            let size = back.abs().max(scene.surface.asperity_height_std);
            assert!((back + place.value).abs() < 1e-4 * size, "{back:e} {:e}", place.value);
        }
        let flat = [Quantity::Pressure, Quantity::AreaFraction, Quantity::LnForce];
        for quantity in flat {
            let refused = between.compile(&scene, &Request::new([quantity])).unwrap_err();
            assert!(matches!(refused, ContactError::Unsupported { .. }), "{refused}");
        }
        let contact = between.compile(&scene, &asked()).unwrap();
        assert!(contact.evaluate(Quantity::Area, At::Pressure(1e6)).is_err());
        assert!(contact.evaluate(Quantity::Area, At::from(Separation::sigmas(1e9))).is_err());
    }
}

#[test]
fn what_limits_the_answer_is_noted() {
    let scene = Scene::new(Interface::new(115e9, 0.3, 4e9), Surface::new(1e-4, 1e9, 1e-6), 1.0);
    let shape = Shape::Point { radius_x: 1e-3, radius_y: 1e-3 };
    let between = BetweenCurved::new(GreenwoodWilliamson, shape);
    let request = Request::new([Quantity::Contacts, Quantity::Area]);
    let codes = |load: f64| -> Vec<Code> {
        let response = between.solve(&scene, &request.clone().at_loads([load])).unwrap();
        response.warnings.iter().map(|found| found.code).collect()
    };
    assert!(codes(1e-6).contains(&Code::FewContacts));
    assert!(codes(100.0).contains(&Code::Patch));
}

/// A model that a table names.
#[derive(Debug)]
struct Named(Arc<dyn ContactModel>);

impl Wraps for Named {
    fn inner(&self) -> &dyn Described {
        &*self.0
    }
}

impl ContactModel for Named {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        self.0.compile(scene, request)
    }
}

#[test]
fn the_work_is_that_of_newtons_method() {
    for (k, points, steps) in [(9, 32, 3), (10, 32, 3), (1, 54, 4)] {
        let row = &rows()[k];
        let curved = curved(row, 1e-6);
        let found = curved.at_load(number(row, "load").unwrap()).unwrap();
        assert_eq!((found.grid().0, found.steps()), ([points; 2], steps), "row {k}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let row = &rows()[0];
    let curved = curved(row, 1e-6);
    for load in [0.0, -1.0, f64::NAN] {
        let refused = curved.at_load(load).err().unwrap();
        assert!(matches!(refused, ContactError::OutOfRange { field: "load", .. }), "{refused}");
    }
    // Smooth bodies would take a grid without end.
    assert!(matches!(curved.at_load(1e12), Err(ContactError::Refused { .. })));
    let scene = Scene::new(Interface::new(1e11, 0.3, 4e9), Surface::new(1e-4, 1e9, 1e-6), 1.0);
    let shape = Shape::Point { radius_x: -0.01, radius_y: 0.01 };
    let tolerance = Tolerance::new(1e-6).unwrap();
    let refused = Curved::new(&KogutEtsion, &scene, shape, &[], tolerance).unwrap_err();
    assert!(matches!(refused, ContactError::OutOfRange { field: "radius_x", .. }), "{refused}");
    let ball = Shape::Point { radius_x: 0.01, radius_y: 0.01 };
    let finer = Curved::new(&KogutEtsion, &scene, ball, &[], Tolerance::new(5e-9).unwrap());
    assert!(matches!(finer, Err(ContactError::OutOfRange { field: "tolerance", .. })));
    let line = Shape::Line { radius: 0.01, length: 1.0, reference_length: None };
    let curved = Curved::new(&KogutEtsion, &scene, line, &[], tolerance).unwrap();
    assert!(curved.at_approach(1e-6).is_err());
    let found = curved.at_load(1e4).unwrap();
    assert!(found.approach().is_none() && found.sum(Quantity::Area).is_err());
}
