//! Answers on surfaces that are known within ranges, against closed forms.
#![allow(clippy::unwrap_used, reason = "a panic is how a test fails")]

use std::path::Path;

use asperity::{At, Quantity, Request, Separation};
use asperity_answer::{AnswerError, Inquiry, Sheet, Silent, models, with_ranges};
use asperity_scene::{SceneFile, parse};

const PRESSURE: f64 = 5e6;

/// Two faces with these keys, on steel with E = 115 GPa.
fn two_faces(keys: &str, hardness: f64) -> SceneFile {
    let text = format!(
        "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\npoissons_ratio = 0.3\n\
         hardness = {hardness:e}\nthermal_conductivity = 50\n[surface]\n{keys}\n\
         counterface = {{ {} }}\n",
        keys.replace('\n', ", ")
    );
    parse(&text, Path::new(".")).unwrap()
}

fn finished(finish: &str, ra: f64, hardness: f64) -> SceneFile {
    two_faces(&format!("ra = {ra}e-6\nfinish = \"{finish}\""), hardness)
}

/// Middle, lower and upper end of a quantity by a model.
fn ends(file: &SceneFile, id: &str, quantity: Quantity) -> ([f64; 3], Sheet) {
    ends_at(file, id, quantity, At::Pressure(PRESSURE))
}

fn ends_at(file: &SceneFile, id: &str, quantity: Quantity, at: At) -> ([f64; 3], Sheet) {
    let mut sheet = Sheet::default();
    let fill = |file: &SceneFile, sheet: &mut Sheet| -> Result<(), AnswerError> {
        let request = Request::new([quantity]).at([at]);
        let models = models(file, &[id.into()], SceneFile::models, &request.quantities, sheet)?;
        Inquiry::new(file, models, request).answer(sheet, &Silent)
    };
    with_ranges(file, &mut sheet, fill).unwrap();
    (numbers(&sheet, quantity), sheet)
}

fn numbers(sheet: &Sheet, quantity: Quantity) -> [f64; 3] {
    let (column, name) = (quantity.column(), quantity.to_string().replace('-', "_"));
    let unit = column.strip_prefix(&name).unwrap();
    [&column, &format!("{name}_lower{unit}"), &format!("{name}_upper{unit}")].map(|head| {
        let column = sheet.column(head).unwrap_or_else(|| panic!("{head}: {:?}", sheet.heads));
        sheet.rows[0][column].number().unwrap()
    })
}

fn width([middle, lower, upper]: [f64; 3]) -> f64 {
    assert!(lower <= middle && middle <= upper, "{lower} {middle} {upper}");
    upper / lower
}

#[test]
fn widths_are_those_of_closed_forms() {
    for line in include_str!("../../../../tests/reference/finishes_answers.csv").lines().skip(1) {
        let (finish, rest) = line.split_once(',').unwrap();
        let row: Vec<f64> = rest.split(',').map(|n| n.parse().unwrap()).collect();
        let [ra, slope_lower, slope_upper, gradient_lower, gradient_upper, ..] = row[..] else {
            panic!("{line}")
        };
        let [elastic, yielding_2, yielding_7, stiffness, conductance] = row[5..] else {
            panic!("{line}")
        };
        let file = finished(finish, ra, 2e9);
        // Persson's area at a light load is 2 p/(E g) up to a factor, and needs no bandwidth.
        let (found, _) = ends(&file, "persson", Quantity::AreaFraction);
        assert!((width(found) / elastic - 1.0).abs() < 0.02, "{line}: {found:?}");
        let keys = format!("ra = {ra}e-6\nfinish = \"{finish}\"\nbandwidth = 10");
        // Of a known bandwidth; additive areas overestimate the width where yielding begins.
        for (hardness, wanted) in [(2e9, yielding_2), (7e9, yielding_7)] {
            let (found, _) = ends(&two_faces(&keys, hardness), "ke", Quantity::AreaFraction);
            let over = width(found) / wanted;
            assert!((0.6..1.3).contains(&over), "{line}: {found:?} {over}");
        }
        // The correlation knows the lay, which m/Rq leaves out.
        let lay = (gradient_upper / gradient_lower) / (slope_upper / slope_lower);
        let (found, _) = ends(&file, "cmy", Quantity::ThermalConductancePerArea);
        assert!((width(found) / (conductance * lay) - 1.0).abs() < 1e-3, "{line}: {found:?}");
        // With a known bandwidth, only Rq is left to the stiffness.
        let (found, _) = ends(&two_faces(&keys, 2e9), "gw", Quantity::Tangent);
        let found = width(found);
        assert!(found > 0.98 * stiffness && found < 1.4 * stiffness, "{line}: {found}");
    }
}

#[test]
fn a_plastic_area_does_not_depend_on_ra() {
    let areas = [0.8, 3.2].map(|ra| {
        let (found, sheet) = ends(&finished("ground", ra, 2e8), "ke", Quantity::AreaFraction);
        assert!(width(found) < 1.05, "{found:?}");
        assert!(!sheet.results.is_empty());
        found[0]
    });
    assert!((areas[0] / areas[1] - 1.0).abs() < 0.01, "{areas:?}");
    assert!((areas[0] / (PRESSURE / 2e8) - 1.0).abs() < 0.01, "{areas:?}");
}

#[test]
fn a_known_surface_has_one_value_and_no_columns_of_ends() {
    let known = two_faces("rq = 1e-6\nrdq = 0.1\nbandwidth = 10", 2e9);
    let mut sheet = Sheet::default();
    let fill = |file: &SceneFile, sheet: &mut Sheet| -> Result<(), AnswerError> {
        let request = Request::new([Quantity::Area]).at([At::Pressure(PRESSURE)]);
        let models = models(file, &["ke".into()], SceneFile::models, &request.quantities, sheet)?;
        Inquiry::new(file, models, request).answer(sheet, &Silent)
    };
    with_ranges(&known, &mut sheet, fill).unwrap();
    assert!(sheet.heads.iter().all(|head| !head.contains("lower")), "{:?}", sheet.heads);
    assert!(sheet.results.is_empty());
}

#[test]
fn columns_of_ends_depend_on_what_is_asked_and_not_on_the_numbers() {
    // Factors of a film ratio depend on no number of the surface.
    let thick = At::from(Separation::film_ratio(2.0));
    let factor = Quantity::PressureFlowFactorX;
    let file = finished("ground", 0.8, 2e9);
    let ([middle, lower, upper], sheet) = ends_at(&file, "ke", factor, thick);
    assert!((upper / lower - 1.0).abs() < 1e-9 && middle > 0.0, "{middle} {lower} {upper}");
    let heads = sheet.heads.join(" ");
    assert!(heads.contains("separation_m separation_lower_m separation_upper_m"), "{heads}");
    // A pressure that is given has none.
    let (_, sheet) = ends(&file, "ke", Quantity::Area);
    let heads = sheet.heads.join(" ");
    assert!(heads.contains("load_N pressure_Pa separation_over_sigma "), "{heads}");
    assert!(heads.ends_with("area_m2 area_lower_m2 area_upper_m2"), "{heads}");
}

#[test]
fn the_results_name_the_widest_unknown_and_the_shares() {
    let (_, sheet) = ends(&finished("ground", 0.8, 2e9), "persson", Quantity::Area);
    let texts = &sheet.results;
    for part in ["area 4.7 (rq 4 %, mean_slope 96 %, ", "area within 4.4; rdq, "] {
        assert!(texts.iter().any(|text| text.contains(part)), "{texts:?}");
    }
    // What is given already does not narrow the slope.
    for (keys, narrowed) in [
        ("ra = 1e-6\nrz = 6e-6\nrsm = 1e-4", "; rdq or a scan"),
        ("rq = 1e-6\nrdq = 0.1\nfinish = \"ground\"", "within 1.16; a scan"),
    ] {
        let (_, sheet) = ends(&two_faces(keys, 2e9), "persson", Quantity::Area);
        let texts = &sheet.results;
        let of_slope = |text: &&String| text.starts_with("mean_slope is unknown");
        let text = texts.iter().find(of_slope).unwrap_or_else(|| panic!("{texts:?}"));
        assert!(text.contains(narrowed), "{text}");
    }
    let (_, sheet) = ends(&finished("ground", 0.8, 2e9), "gw", Quantity::Tangent);
    assert!(sheet.findings.iter().any(|found| found.code == "waviness"));
}
