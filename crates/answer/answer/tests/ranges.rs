//! Answers on surfaces that are known within ranges, against closed forms.
#![allow(clippy::unwrap_used, reason = "a panic is how a test fails")]

use std::path::Path;

use asperity::{At, ContactModel, Finding, Quantity, Request, Separation, Tolerance};
use asperity_answer::{
    AnswerError, ENDS, Inquiry, Sheet, Silent, column_of_end, models, with_ranges,
};
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
        // Slopes of profiles with the cut-off of the table.
        let cut_offs = "lambda_s = 2.5e-6\nlambda_c = 8e-4";
        let file = two_faces(&format!("ra = {ra}e-6\nfinish = \"{finish}\"\n{cut_offs}"), 2e9);
        // Persson's area at a light load is 2 p/(E g) up to a factor, and needs no bandwidth.
        let (found, _) = ends(&file, "persson", Quantity::AreaFraction);
        assert!((width(found) / elastic - 1.0).abs() < 0.02, "{line}: {found:?}");
        let keys = format!("ra = {ra}e-6\nfinish = \"{finish}\"\nbandwidth = 10\n{cut_offs}");
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
fn what_would_narrow_a_slope_is_not_given_already() {
    for (keys, narrowed) in [
        ("ra = 1e-6\nrz = 6e-6\nrsm = 1e-4", "rdq or a scan"),
        ("rq = 1e-6\nrdq = 0.1\nfinish = \"ground\"", "a scan"),
    ] {
        let all = two_faces(keys, 2e9).unknowns();
        let slope = all.iter().find(|one| one.name == "mean_slope").unwrap();
        assert_eq!(slope.narrowed, narrowed);
    }
    let (_, sheet) = ends(&finished("ground", 0.8, 2e9), "gw", Quantity::Tangent);
    assert!(sheet.findings.iter().any(|found| found.code.name() == "waviness"));
    assert!(sheet.results.iter().any(|text| text.contains("mean_slope")), "{:?}", sheet.results);
}

/// Of two like surfaces either may be the rougher one.
#[test]
fn the_shear_flow_factor_of_two_like_surfaces_has_either_sign() {
    let thick = At::from(Separation::film_ratio(1.5));
    let file = finished("ground", 0.8, 2e9);
    let ([middle, lower, upper], _) = ends_at(&file, "ke", Quantity::ShearFlowFactor, thick);
    assert!(middle.abs() < 1e-12 && (lower + upper).abs() < 1e-9, "{middle} {lower} {upper}");
    assert!((0.12..0.14).contains(&upper), "{upper}");
}

/// Numbers drawn at random from the ranges lie between the ends.
#[test]
fn draws_from_the_ranges_lie_between_the_ends() {
    use Quantity::{Area, Contacts, Force, Tangent, ThermalConductancePerArea};
    let steel = "youngs_modulus = 2.1e11\npoissons_ratio = [0.28, 0.3]\nhardness = [1.8e9, 2.6e9]\nthermal_conductivity = [40, 50]\n";
    let body = steel.replace("[1.8e9, 2.6e9]", "[2e9, 4e9]");
    let head = format!("nominal_area = 1e-4\n[[body]]\n{steel}[[body]]\n{body}[surface]\n");
    let alike = "ra = [\"0.4 um\", \"0.8 um\"]\nfinish = \"ground\"\ncounterface = { ra = 1.6e-6, finish = \"turned\" }";
    let hard = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
        poissons_ratio = 0.3\nhardness = 7e9\nthermal_conductivity = 50\n[surface]\n\
        ra = 8e-7\nfinish = \"unknown\"\n";
    let moments = "m0 = [1e-13, 1e-12]\nm2 = [1e-3, 4e-3]\nm4 = [1e9, 1e10]";
    // Outside of the solved bandwidths in the middle, and between them at a part of the points.
    let narrow = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = [80e9, 115e9]\n\
        poissons_ratio = 0.3\nhardness = [1e9, 4e9]\nthermal_conductivity = 50\n[surface]\n\
        asperity_radius = [4e-6, 4e-5]\nasperity_density = [5e9, 5e10]\n\
        asperity_height_std = [2e-7, 8e-7]\n";
    let loads = [At::Pressure(1e6), At::Pressure(1e8)];
    let planes = [-1.1e-6, 7e-7, 3e-6].map(|metres| At::from(Separation::metres(metres)));
    let at_loads = [Area, Tangent, Contacts, ThermalConductancePerArea];
    let at_planes = [Force, Area, Tangent, ThermalConductancePerArea];
    let is_long = std::env::var_os("ASPERITY_LONG").is_some();
    let draws = if is_long { 1000 } else { 40 };
    let mut state = 1_u64;
    let mut share = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for (surface, places, quantities) in [
        ("ra = 8e-7\nfinish = \"ground\"", &loads[..], &at_loads),
        ("ra = 8e-7\nfinish = \"ground\"", &planes, &at_planes),
        (moments, &loads, &at_loads),
        (moments, &planes, &at_planes),
        (alike, &loads, &at_loads),
        (alike, &planes, &at_planes),
        ("", &planes, &at_planes),
        (narrow, &loads, &at_loads),
    ] {
        let text = match surface {
            "" => hard.into(),
            whole if whole == narrow => narrow.into(),
            surface => format!("{head}{surface}\n"),
        };
        let file = parse(&text, Path::new(".")).unwrap();
        let unknowns = file.unknowns().len();
        let middle = file.middle().unwrap();
        // Two surfaces have eleven unknowns.
        let ids: &[&str] = match surface {
            _ if is_long => &["gw", "ceb", "ke", "jg", "zmc", "af", "at", "persson", "cmy", "best"],
            _ if surface == alike => &["jg"],
            _ if surface == narrow => &["best"],
            _ => &["ceb", "jg", "zmc", "persson", "cmy"],
        };
        // Some separations have no load by solved surfaces.
        let has_values = |id: &&&str| **id != "best" || places[0] == loads[0];
        for &id in ids.iter().filter(has_values) {
            let request = |quantities: &[Quantity]| {
                Request::new(quantities.iter().copied()).at(places.iter().copied())
            };
            let model = middle.model(id).unwrap();
            let has = |one: &&Quantity| {
                let found = model.solve(&file.scene, &request(&[**one]));
                found.is_ok_and(|found| found.values(**one).is_ok())
            };
            let had: Vec<Quantity> = quantities.iter().filter(has).copied().collect();
            let of = |file: &SceneFile| -> Vec<Vec<f64>> {
                let model = file.model(id).unwrap();
                let found = model.solve(&file.scene, &request(&had)).unwrap();
                had.iter().map(|one| found.values(*one).unwrap()).collect()
            };
            if had.is_empty() {
                continue;
            }
            let mut sheet = Sheet::default();
            let fill = |file: &SceneFile, sheet: &mut Sheet| -> Result<(), AnswerError> {
                let models = vec![file.model(id)?];
                Inquiry::new(file, models, request(&had)).answer(sheet, &Silent)
            };
            with_ranges(&file, &mut sheet, fill).unwrap();
            let end = |quantity: Quantity, row: usize, end: &str| {
                let column = sheet.column(&column_of_end(&quantity.column(), end)).unwrap();
                sheet.rows[row][column].number().unwrap()
            };
            if id == "jg" && surface.is_empty() {
                // The stiffness close to the planes is largest well inside the ranges.
                let points = file.points().unwrap();
                let corners = points.all.iter().take(points.corners().count());
                let most = corners.map(|one| of(one)[2][0]).fold(0.0, f64::max);
                assert!(end(Tangent, 0, "upper") > 1.3 * most);
            }
            let (mut outside, mut compared) = (0, 0);
            for _ in 0..draws {
                let shares: Vec<f64> = (0..unknowns).map(|_| share()).collect();
                let drawn = of(&file.at(&shares).unwrap());
                for (k, values) in drawn.iter().enumerate() {
                    for (row, value) in values.iter().enumerate() {
                        let [least, most] = ENDS.map(|of| end(had[k], row, of));
                        let slack = 0.01 * least.abs().max(most.abs());
                        let is_within = (least - slack..=most + slack).contains(value);
                        outside += usize::from(!is_within);
                        compared += 1;
                    }
                }
            }
            assert!(outside * 100 <= compared, "{id} {outside} of {compared} {surface}");
        }
    }
}

/// An area above the nominal one at an end is found.
/// AF takes the elastic constants of the softer body, so that areas jump where it changes.
#[test]
fn ends_are_those_of_either_body_being_barely_softer() {
    let scene = |first: &str, second: &str| {
        let text = format!(
            "nominal_area = 1e-4\n[[body]]\nyoungs_modulus = 70e9\npoissons_ratio = 0.33\n\
             hardness = {first}\n[[body]]\nyoungs_modulus = 210e9\npoissons_ratio = 0.2\n\
             hardness = {second}\n[surface]\nrq = 0.7e-6\nmean_slope = 0.1\nbandwidth = 10\n"
        );
        parse(&text, Path::new(".")).unwrap()
    };
    let (area, at) = (Quantity::Area, At::Pressure(PRESSURE));
    let file = scene("[1e9, 2e9]", "[1.4e9, 2.6e9]");
    let ([_, lower, upper], _) = ends_at(&file, "af", area, at);
    let of = |first: f64, second: f64| {
        let file = scene(&format!("{first:e}"), &format!("{second:e}"));
        let request = Request::new([area, Quantity::Force]);
        let contact = file.model("af").unwrap().compile(&file.scene, &request).unwrap();
        contact.evaluate(area, at).unwrap().value()
    };
    let barely = 1.0 - 1e-6;
    let pairs = [1.4e9, 2e9].map(|hard| [[hard, hard * barely], [hard * barely, hard]]);
    let found: Vec<f64> = pairs.concat().into_iter().map(|[a, b]| of(a, b)).collect();
    assert!(found.iter().all(|one| (0.999 * lower..=1.001 * upper).contains(one)), "{found:?}");
    // The jump is an end.
    assert!((found[3] / found[2] - 1.0).abs() > 0.005, "{found:?}");
    let jumps = found.iter().any(|one| (one / lower - 1.0).abs() < 1e-3);
    assert!(jumps, "{found:?} {lower} {upper}");
}

#[test]
fn a_finding_at_an_end_is_found() {
    let soft = finished("ground", 0.8, 2e9).to_toml().unwrap();
    let soft = soft.replace("hardness = 2e9", "hardness = [2e6, 2e9]");
    let (_, sheet) = ends(&parse(&soft, Path::new(".")).unwrap(), "ke", Quantity::AreaFraction);
    let at_end = |found: &Finding| found.origin.as_deref() == Some("within the ranges");
    assert!(sheet.findings.iter().any(at_end), "{:?}", sheet.findings);
}

/// The interval of an answer is part of its range, and where it has none the range stands alone.
#[test]
fn what_is_known_best_has_ends_on_a_surface_of_ranges() {
    for (hardness, has_interval) in [(2e9, false), (8e9, true)] {
        let file = finished("ground", 0.8, hardness);
        let ([value, lower, upper], _) = ends(&file, "best", Quantity::Tangent);
        assert!(lower < value && value < upper, "{hardness:e}: {lower:e} {value:e} {upper:e}");
        let middle = file.middle().unwrap();
        let contact = middle.best().contact(&middle.scene, &Request::new([Quantity::Tangent]));
        let own = contact.unwrap().interval(Quantity::Tangent, At::Pressure(PRESSURE));
        assert_eq!(own.is_some(), has_interval, "{hardness:e}");
        assert!(own.is_none_or(|own| lower <= own.lower && own.upper <= upper), "{hardness:e}");
    }
}

#[test]
fn the_largest_tension_of_ranges_is_between_those_at_their_ends() {
    let rubber = |work: &str| {
        let text = format!(
            "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 1.3e6\npoissons_ratio = 0.5\n\
             work_of_adhesion = {work}\n[surface]\nasperity_radius = 1e-4\n\
             asperity_density = 1e9\nasperity_height_std = 1e-6\n"
        );
        let (file, mut sheet) = (parse(&text, Path::new(".")).unwrap(), Sheet::default());
        let models = [file.model("jkr-separation").unwrap()];
        asperity_answer::pull_off(&file, &models, Tolerance::default(), &mut sheet).unwrap();
        sheet
    };
    let of = |work| numbers(&rubber(work), Quantity::Force);
    let alone = |work| rubber(work).rows[0][1].number().unwrap();
    let [middle, lower, upper] = of("[0.04, 0.06]");
    assert_eq!([lower, upper].map(f64::to_bits), [alone("0.06"), alone("0.04")].map(f64::to_bits));
    assert!(lower < middle && middle < upper && upper < 0.0);
}
