//! Contact tables against dense scans of their models.

use asperity::{
    Evaluation, HeightDistribution, Interface, Model, Scene, Surface, TabulatedHeights, Tolerance,
};
use asperity_scene::SceneFile;

use super::*;

fn scene() -> Scene {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5)
}

fn table(
    model: &Model,
    scene: &Scene,
    tolerance: Tolerance,
    (ends, nodes, max_error): ([At; 2], usize, Option<f64>),
    format: TableFormat,
) -> Outcome<ContactTable> {
    let file = SceneFile::from(scene.clone());
    let subject = Subject { file: &file, name: "", model, tolerance };
    Builder::new(&subject, format, &[])?.between(ends, nodes, max_error)
}

fn ke(
    ends: [At; 2],
    nodes: usize,
    error: Option<f64>,
    format: TableFormat,
) -> Outcome<ContactTable> {
    let (model, tolerance) = ("ke".parse().unwrap(), Tolerance::default());
    table(&model, &scene(), tolerance, (ends, nodes, error), format)
}

fn even(count: usize, format: TableFormat) -> ContactTable {
    ke([0.0, 4.0].map(At::sigmas), count, None, format).unwrap()
}

#[test]
fn errors_fall_as_the_interpolation_promises() {
    // Halving the intervals divides the error by 2² for lines and by 2⁴ for cubics.
    for (format, order) in [(TableFormat::Abaqus, 4.0), (TableFormat::Csv, 16.0)] {
        let (coarse, fine) = (even(81, format), even(161, format));
        let ratio = coarse.errors.unwrap()[0] / fine.errors.unwrap()[0];
        assert!((ratio / order - 1.0).abs() < 0.15, "{format:?}: {ratio}");
    }
}

#[test]
fn an_asked_error_is_met_with_few_nodes() {
    for (format, most) in [(TableFormat::Abaqus, 700), (TableFormat::Csv, 90)] {
        let ends = [-1.0, 4.0].map(At::sigmas);
        let within = |error| ke(ends, 2, Some(error), format);
        let table = within(1e-4).unwrap();
        assert!(
            table.errors.unwrap()[0] <= 1e-4 && table.nodes.len() <= most,
            "{}",
            table.nodes.len()
        );
        assert!(
            table.nodes.is_sorted_by(|a, b| a.separation < b.separation && a.pressure > b.pressure)
        );
        assert!(within(1e-17).is_err());
    }
}

#[test]
fn loads_and_pressures_are_ends_like_any_other() {
    let of = |a, b| ke([a, b], 9, None, TableFormat::Csv).unwrap().nodes;
    let nodes = of(At::Pressure(1e4), At::Pressure(1e6));
    assert!((nodes[0].pressure / 1e6 - 1.0).abs() < 1e-9);
    // In either order.
    assert_eq!(of(At::Pressure(1e6), At::Pressure(1e4)), nodes);
    assert!(ke([At::Load(5.0); 2], 9, None, TableFormat::Csv).is_err());
    assert!((nodes[8].pressure / 1e4 - 1.0).abs() < 1e-9);
    assert_eq!(nodes, of(At::Load(1e4 * 3e-5), At::Load(1e6 * 3e-5)));
    let metres = of(At::metres(1e-6), At::metres(3e-6));
    assert!((metres[8].separation - 3.0).abs() < 1e-12);
}

#[test]
fn the_tangent_of_the_last_node_ends_the_table() {
    let table = even(41, TableFormat::Abaqus);
    let (last, end) = (table.nodes[40], table.cut_off);
    let slope = last.pressure / ((end - last.separation) * 1e-6);
    assert!(end > 4.0 && (slope / last.stiffness - 1.0).abs() < 1e-9);
}

#[test]
fn what_a_solver_cannot_use_is_refused() {
    let interface = scene().interface;
    let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
    let mut odd = scene();
    odd.surface = surface;
    let table = |scene: &Scene, id: &str, (first, last, nodes): (f64, f64, usize)| {
        let range = ([first, last].map(At::sigmas), nodes, None);
        let model = id.parse::<Model>().unwrap();
        table(&model, scene, Tolerance::default(), range, TableFormat::Csv)
    };
    let message = table(&odd, "at", (0.0, 4.0, 9)).unwrap_err().to_string();
    assert!(message.starts_with("at a separation of") && message.contains("required"));
    let message = table(&scene(), "ke", (0.0, 6.0, 2)).unwrap_err().to_string();
    assert!(message.starts_with("2 nodes"), "{message}");
    assert!(table(&scene(), "ke", (1.0, 1.0, 5)).is_err());
}

/// The largest relative errors of pressure and slope at 201 points between any two nodes.
fn scan(table: &ContactTable, format: TableFormat, model: &Model, scene: &Scene) -> [f64; 2] {
    let request = Request::new([Quantity::Force, Quantity::Tangent]);
    let contact = model.compile(scene, &request).unwrap();
    let mut worst = [0.0_f64; 2];
    for pair in table.nodes.windows(2) {
        let (x, h) = (pair[0].separation, pair[1].separation - pair[0].separation);
        let metres = h * scene.surface.asperity_height_std;
        let [(p, k), (q, l)] = [0, 1].map(|end| (pair[end].pressure, pair[end].stiffness * metres));
        for t in (0..201).map(|point| (f64::from(point) + 0.5) / 201.0) {
            // Bernstein's form of the cubic.
            let s = 1.0 - t;
            let [b, c] = [p - k / 3.0, q + l / 3.0];
            let (value, fall) = match format.is_cubic() {
                false => (s * p + t * q, p - q),
                true => (
                    s * s * s * p + 3.0 * s * t * (s * b + t * c) + t * t * t * q,
                    3.0 * (s * s * (p - b) + 2.0 * s * t * (b - c) + t * t * (c - q)),
                ),
            };
            let (force, tangent) = contact.force_and_tangent(At::sigmas(x + t * h)).unwrap();
            let of_area = |found: Evaluation| found.value() / scene.nominal_area;
            worst[0] = worst[0].max((value / of_area(force) - 1.0).abs());
            worst[1] = worst[1].max((fall / metres / of_area(tangent) - 1.0).abs());
        }
    }
    worst
}

#[test]
fn the_error_stated_holds_between_all_points_and_is_close() {
    let mut interface = Interface::new(115e9, 0.3, 2e9);
    interface.equivalent_shear_modulus = Some(25e9);
    let gaussian = |index: f64| {
        let surface = Surface::from_plasticity_index(index, 0.04, 1e-6, &interface).unwrap();
        Scene::new(interface, surface, 1e-4)
    };
    // Five narrow peaks of heights.
    let mut peaks = Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5);
    let corners = [0.0, 0.7e-6, 1.5e-6, 2.2e-6, 3e-6]
        .map(|z| [(z - 1e-8, 0.0), (z - 0.5e-8, 1.0), (z + 0.5e-8, 1.0), (z + 1e-8, 0.0)]);
    let points: Vec<(f64, f64)> = corners.into_iter().flatten().collect();
    peaks.heights = HeightDistribution::other(TabulatedHeights::new("peaks", &points).unwrap());
    let (lines, cubics) = (TableFormat::Abaqus, TableFormat::Csv);
    let cases = [
        ("gw", gaussian(0.6000566651586865), (0.998796301588242, 4.193196351099519), 0.4438, lines),
        ("gw", gaussian(3.104203423893087), (1.650554263752503, 4.8930611650202), 0.02174, cubics),
        ("gw", peaks.clone(), (-2.0, 0.9), 0.03, cubics),
        ("ke", peaks.clone(), (-2.0, 0.9), 0.03, cubics),
        ("jg", peaks.clone(), (-2.0, 0.9), 0.03, cubics),
        ("ke", peaks, (-2.0, 0.9), 0.03, lines),
        ("ke", gaussian(6.0), (-1.0, 4.0), 1e-4, cubics),
        ("ceb", gaussian(6.0), (-1.0, 4.0), 1e-3, lines),
    ];
    for (id, scene, (first, last), error, format) in cases {
        let model = id.parse::<Model>().unwrap();
        let tolerance = Tolerance::new(1e-8).unwrap();
        let range = ([first, last].map(At::sigmas), 2, Some(error));
        let table = table(&model, &scene, tolerance, range, format).unwrap();
        let [pressure, slope] = scan(&table, format, &model, &scene);
        let [stated, of_slope] = table.errors.unwrap();
        assert!(stated <= error && pressure <= stated, "{id} {error}: {pressure} {stated}");
        assert!(slope <= of_slope, "{id} {error}: {slope} {of_slope}");
        assert!(
            stated < 1.1 * pressure && of_slope < 1.25 * slope,
            "{id} {error}: {pressure} {stated}, {slope} {of_slope}"
        );
    }
}
