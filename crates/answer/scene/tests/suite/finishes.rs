//! Surfaces by roughness and finish, whose numbers are known within ranges.

use std::path::Path;

use asperity::{At, Code, ContactModel, Quantity, Request};
use asperity_scene::{SceneError, SceneFile, Unknown, parse};

use crate::two_surfaces::HEAD;

/// A surface whose numbers have no range.
const KNOWN: &str = "rq = \"1 um\"\nrdq = 0.1\nbandwidth = 10";

fn scene(surface: &str) -> SceneFile {
    parse(&format!("{}{surface}\n", HEAD.replace("1e-8", "1e-4")), Path::new(".")).unwrap()
}

fn near(found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{found} is not {wanted}");
}

/// Lower end, middle and upper end of the unknowns: Rq, slope and bandwidth of the first surface.
fn ranges(file: &SceneFile) -> [[f64; 3]; 3] {
    let three = |one: &Unknown| [one.ends[0], one.middle(), one.ends[1]];
    let all: Vec<[f64; 3]> = file.unknowns().iter().map(three).collect();
    [all[0], all[1], all[2]]
}

/// The unknowns with the ratios of their ends.
fn open(file: &SceneFile) -> Vec<(String, f64)> {
    let all = file.unknowns().into_iter();
    all.map(|one| (one.name, one.ends[1] / one.ends[0])).collect()
}

#[test]
fn a_ground_surface_has_the_ranges_of_its_finish() {
    let file = scene("ra = \"0.8 um\"\nfinish = \"Ground\"");
    let [rq, slope, bandwidth] = ranges(&file);
    for (found, wanted) in rq.into_iter().zip([9.52e-7, 1.032_589e-6, 1.12e-6]) {
        near(found, wanted, 1e-6);
    }
    let usual = |rq: f64| 0.125 * rq.powf(0.402);
    near(slope[0], 0.4 * usual(1.032_589) * (1.0625f64 / 2.0).sqrt(), 1e-6);
    near(slope[2], 1.5 * usual(1.032_589) * (1.4356f64 / 2.0).sqrt(), 1e-6);
    near(bandwidth[0], 5.5, 1e-12);
    near(bandwidth[2], 51.5, 1e-12);
    // The surface of the scene is the one in the middle.
    let moments = file.scene.surface.moments();
    near(moments.m0.sqrt(), rq[1], 1e-12);
    near(moments.bandwidth(), bandwidth[1], 1e-9);
    let points = file.points().unwrap();
    assert_eq!((points.middle.scene.surface, points.all.len()), (file.scene.surface, 8 + 64));
    let m0 = |k: usize| points.all[k].scene.surface.moments().m0.sqrt();
    near(m0(0), rq[0], 1e-12);
    near(m0(1), rq[2], 1e-12);
    // The slope of a finish follows from Rq.
    let usual = usual(1.12) / usual(0.952);
    let m2 = |k: usize| points.all[k].scene.surface.moments().m2;
    near((m2(1) / m2(0)).sqrt(), usual, 1e-9);
    assert!((8..72).all(|k| rq[0] < m0(k) && m0(k) < rq[2]));
    assert!(points.all.iter().all(|point| point.unknowns().is_empty()));
}

/// Of each half, quarter and eighth of each range as many points inside as of the others, and of
/// the ends any three unknowns have every combination equally often.
#[test]
fn points_fill_the_ranges_and_their_ends_are_balanced() {
    let hardness = "[\"1.8 GPa\", \"2.2 GPa\"]";
    let body = format!(
        "youngs_modulus = [2e11, 2.1e11]\npoissons_ratio = [0.28, 0.3]\nhardness = {hardness}\nthermal_conductivity = [40, 50]\n"
    );
    let text = format!(
        "nominal_area = 1e-4\n[[body]]\n{body}[[body]]\n{body}[surface]\nm0 = [1e-12, 2e-12]\nm2 = 1e-4\nm4 = 5e4\n"
    );
    let file = parse(&text, Path::new(".")).unwrap();
    let points = file.points().unwrap();
    let corners: Vec<Vec<bool>> = points.corners().collect();
    assert_eq!((points.unknowns.len(), corners.len(), points.all.len()), (9, 128, 192));
    for a in 0..9 {
        for b in 0..a {
            for c in 0..b {
                let all = corners.iter().filter(|ends| ends[a] && ends[b] && !ends[c]);
                assert_eq!(all.count(), 16, "{a} {b} {c}");
            }
        }
        let value = |file: &SceneFile| {
            let input = file.inputs([&*points.unknowns[a].name]).unwrap()[0];
            file.value_of(input).unwrap()
        };
        let [low, high] = points.unknowns[a].ends;
        let share = |file: &SceneFile| (value(file) / low).ln() / (high / low).ln();
        let inside: Vec<f64> = points.all[128..].iter().map(share).collect();
        for part in 0..4 {
            let [from, to] = [f64::from(part) / 4.0, f64::from(part + 1) / 4.0];
            let count = inside.iter().filter(|share| (from..to).contains(*share)).count();
            assert!((12..=20).contains(&count), "{a} {part} {count}");
        }
    }
}

#[test]
fn a_number_that_is_given_has_no_range() {
    let exact = scene(KNOWN);
    assert!(exact.unknowns().is_empty());
    let moments = exact.scene.surface.moments();
    near(moments.m2, 0.01, 1e-12);
    near(moments.m4, 10.0 * 0.01 * 0.01 / 1e-12, 1e-9);
    // The same surface by its moments.
    let other = scene("m0 = 1e-12\nm2 = 0.01\nm4 = 1e9");
    let force = |file: &SceneFile| {
        let request = Request::new([Quantity::Force]).at([2.0]);
        let found = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        found.values(Quantity::Force).unwrap()[0]
    };
    near(force(&exact), force(&other), 1e-9);
    let names = |surface: &str| -> Vec<String> {
        open(&scene(surface)).into_iter().map(|(name, _)| name).collect()
    };
    assert_eq!(names("ra = \"1 um\"\nfinish = \"lapped\"\nmean_slope = 0.1"), ["rq", "bandwidth"]);
    // The lay of a ground surface remains.
    let [(name, spread)] = &open(&scene(&format!("{KNOWN}\nfinish = \"ground\"")))[..] else {
        panic!("one unknown")
    };
    assert_eq!(name, "mean_slope");
    near(*spread, (1.4356f64 / 1.0625).sqrt(), 1e-9);
}

#[test]
fn rz_and_rsm_give_the_slope_without_a_finish() {
    let file = scene("ra = \"0.8 um\"\nrz = \"5 um\"\nrsm = \"120 um\"");
    let [_, slope, _] = ranges(&file);
    near(slope[0], 0.9 * 10.0 / 120.0, 1e-12);
    near(slope[2], 2.2 * 10.0 / 120.0, 1e-12);
    let [rq, ..] = ranges(&scene("rz = \"5 um\"\nfinish = \"ground\""));
    near(rq[0], 5e-6 / 5.8, 1e-12);
    near(rq[2], 5e-6 / 3.3, 1e-12);
}

#[test]
fn rows_of_csv_lie_in_the_ranges_of_profiles_with_these_cut_offs() {
    // 37 windows; the others are noise, pits or made.
    let odd =
        ["SurfaceTopography_dektak-1.csv", "SurfaceTopography_mnt-2.mnt", "mts_riefen_4mm.mat"];
    let mut compared = 0;
    for line in include_str!("../../../../../tests/reference/finishes_rsm.csv").lines().skip(1) {
        let (surface, numbers) = line.split_once(',').unwrap();
        let [cut, short, rz, rsm, slope] =
            numbers.split(',').map(|n| n.parse::<f64>().unwrap()).collect::<Vec<_>>()[..]
        else {
            panic!("{line}")
        };
        if odd.contains(&surface) {
            continue;
        }
        let file = scene(&format!(
            "rz = {rz}e-6\nrsm = {rsm}e-6\nlambda_c = {cut}e-6\nlambda_s = {short}e-6"
        ));
        let [_, [lower, _, upper], _] = ranges(&file);
        assert!((lower..=upper).contains(&slope), "{line}: {lower} to {upper}");
        compared += 1;
    }
    assert_eq!(compared, 37);
}

#[test]
fn two_surfaces_add_and_vary_each_on_its_own() {
    let ground = "ra = \"0.8 um\"\nfinish = \"ground\"";
    let inline = ground.replace('\n', ", ");
    let (one, both) = (scene(ground), scene(&format!("{ground}\ncounterface = {{ {inline} }}")));
    let moments = [&one, &both].map(|file| file.scene.surface.moments());
    near(moments[1].m0, 2.0 * moments[0].m0, 1e-9);
    near(moments[1].m2, 2.0 * moments[0].m2, 1e-9);
    near(moments[1].bandwidth(), moments[0].bandwidth(), 1e-9);
    let names: Vec<String> = open(&both).into_iter().map(|(name, _)| name).collect();
    let of_one = ["rq", "mean_slope", "bandwidth"];
    assert_eq!(names[..3], of_one);
    assert_eq!(names[3..], of_one.map(|name| format!("counterface_{name}")));
    // A rough surface with gentle slopes and a smooth one with steep ones have a wide spectrum.
    let points = both.points().unwrap();
    assert_eq!(points.all.len(), 64 + 64);
    let of_pair = |file: &SceneFile| file.scene.surface.moments().bandwidth();
    let widest = points.all.iter().map(of_pair).fold(0.0, f64::max);
    let [rq, slope, bandwidth] = ranges(&one);
    let sum = |power: i32, of: [f64; 3]| of[0].powi(power) + of[2].powi(power);
    let m4 = |slope: f64, alpha: f64, rq: f64| alpha * slope.powi(4) / (rq * rq);
    let at = |slope: f64, of: f64| slope * (of / rq[1]).powf(0.402);
    let slope = [at(slope[0], rq[2]), 0.0, at(slope[2], rq[0])];
    let m4 = m4(slope[0], bandwidth[2], rq[2]) + m4(slope[2], bandwidth[2], rq[0]);
    let by_hand = sum(2, rq) * m4 / sum(2, slope).powi(2);
    assert!(widest > by_hand * (1.0 - 1e-9) && (70.0..130.0).contains(&widest), "{widest}");
    let honed = format!("{ground}\ncounterface = {{ ra = 4e-7, finish = \"honed\" }}");
    let points = scene(&honed).points().unwrap();
    let widest = points.all.iter().map(of_pair).fold(0.0, f64::max);
    assert!((200.0..300.0).contains(&widest), "{widest}");
    // A counterface by its moments has no range of its own.
    let beside = scene(&format!("{ground}\ncounterface = {{ m0 = 1e-18, m2 = 1e-8, m4 = 1e3 }}"));
    assert_eq!(open(&beside), open(&one));
}

/// Each corner is the scene that has its numbers alone, given offset and all.
#[test]
fn a_given_offset_holds_at_the_ends_of_the_ranges() {
    let counterface = "[surface.counterface]\n".to_string() + &KNOWN.replace("1 um", "0.5 um");
    let of = |rest: &str| {
        scene(&format!("rq = \"0.6 um\"\nmean_plane_offset = 3e-7\n{rest}\n{counterface}"))
    };
    let open = of("rdq = 0.1\nfinish = \"unknown\"");
    let mut ends: Vec<f64> = vec![];
    for corner in open.points().unwrap().all {
        let pair = corner.scene.pair.unwrap();
        assert_eq!(pair.surfaces[0].mean_plane_offset, Some(3e-7));
        // The surface that is equivalent to both has its share of the given sum.
        let [first, second] = pair.surfaces.map(|one| one.asperities.mean_plane_offset());
        let share = (3e-7 + second) / (first + second);
        let wanted = corner.scene.surface.mean_plane_offset() * share;
        near(corner.scene.mean_plane_offset.unwrap(), wanted, 1e-12);
        ends.push(wanted);
    }
    assert!(ends.len() > 1 && ends.iter().any(|end| (end / ends[0] - 1.0).abs() > 0.01));
}

/// Single numbers are those in the middle, or at the ends of all ranges.
#[test]
fn one_end_of_every_range_is_taken_and_the_keys_are_written_again() {
    let file = scene("ra = \"0.8 um\"\nfinish = \"ground\"");
    for (end, k) in [("lower", 0), ("middle", 1), ("upper", 2)] {
        let (taken, note) = file.taken_at(end).unwrap();
        near(taken.scene.surface.moments().m0.sqrt(), ranges(&file)[0][k], 1e-12);
        assert_eq!(note.unwrap().code.name(), "taken-at");
        assert!(taken.unknowns().is_empty() && taken.taken_at(end).unwrap().1.is_none());
    }
    assert!(matches!(file.taken_at("most"), Err(SceneError::Refused { .. })));
    assert!(file.model("ke").is_ok() && !file.models().0.is_empty());
    let area = file.inputs(["nominal_area"]).unwrap()[0];
    let larger = file.with_inputs([(area, 2e-4)]).unwrap();
    let again = parse(&larger.to_toml().unwrap(), Path::new(".")).unwrap();
    assert_eq!((ranges(&again), again.scene.nominal_area), (ranges(&file), 2e-4));
    let check = file.check(None).unwrap();
    let named: Vec<_> = check.numbers.iter().take(3).map(|number| &*number.name).collect();
    assert_eq!(named, ["rq", "mean_slope", "bandwidth"]);
    assert!(check.numbers[1].meaning.starts_with("scan: 0.125 Rq^0.402 (um) times 0.4 to 1.5"));
    let modulus = check.numbers.iter().find(|number| number.name == "equivalent_modulus").unwrap();
    assert_eq!(modulus.ends, None);
    let index = check.numbers.iter().find(|number| number.name == "plasticity_index").unwrap();
    assert!(index.ends.is_some_and(|[lower, upper]| upper > 4.0 * lower));
}

/// Of a range of Ra and of two surfaces.
#[test]
fn a_check_has_the_ends_of_what_follows_from_a_range() {
    let text = format!(
        "{INTERFACE}[surface]\nra = [6e-7, 1.2e-6]\nfinish = \"ground\"\n\
         counterface = {{ ra = 1.6e-6, finish = \"turned\" }}\n"
    );
    let file = parse(&text, Path::new(".")).unwrap();
    let model = file.model("ke").unwrap();
    let check = file.check(Some((&model, At::Load(1e3)))).unwrap();
    let ends = |name: &str| check.numbers.iter().find(|one| one.name == name).unwrap().ends;
    let [lower, upper] = ends("rq").unwrap();
    assert!((lower / 7.14e-7 - 1.0).abs() < 1e-9 && (upper / 1.68e-6 - 1.0).abs() < 1e-9);
    assert!(ends("pair_bandwidth").unwrap()[1] > 4.0 * ends("bandwidth").unwrap()[1]);
    // Ends of answers are those of a curve.
    assert_eq!(ends("area"), None);
    assert_eq!(check.number("load"), Some(1e3));
}

const INTERFACE: &str = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
    poissons_ratio = 0.3\nhardness = 2e9\n";
const MOMENTS: &str = "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\n";

/// Two values of a number anywhere are the ends of a range, kept in writing; the middle is the
/// geometric mean, or of numbers that are not positive the arithmetic one.
#[test]
fn any_number_may_be_a_range() {
    let bodies = "nominal_area = 1e-4\n[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\n\
        hardness = 2e9\n[[body]]\nmaterial = \"steel-100cr6\"\nthermal_conductivity = 40\n";
    let gap = "[gap]\ngas_conductivity = 0.026\ngas_parameter = 3.7e-7\n";
    let both = format!("{MOMENTS}counterface = {{ sq = 1e-6, spd = 2e8, spc = 5e3 }}\n");
    let (pair, one) = (format!("{INTERFACE}{both}"), format!("{INTERFACE}{MOMENTS}"));
    let (of_bodies, in_gas) = (format!("{bodies}{MOMENTS}"), format!("{one}{gap}"));
    for (scene, edit, name, [low, high]) in [
        (&one, "hardness = 2e9>hardness = [\"1.8 GPa\", \"2.2 GPa\"]", "hardness", [1.8e9, 2.2e9]),
        (&of_bodies, "2e9>[\"120 HV\", \"240 HV\"]", "body1_hardness", [1.2691e9, 2.5382e9]),
        (&of_bodies, "ity = 40>ity = [35, 45]", "body2_thermal_conductivity", [35.0, 45.0]),
        (&of_bodies, "= 1e-4>= [\"1 cm2\", \"2 cm2\"]", "nominal_area", [1e-4, 2e-4]),
        (&of_bodies, "[[>work_of_adhesion = [0.05, 0.1]\n[[", "work_of_adhesion", [0.05, 0.1]),
        (&one, "m0 = 1e-12>m0 = [4e-12, 1e-12]", "m0", [1e-12, 4e-12]),
        (&one, "m0>peklenik_number = [1, 3]\nm0", "peklenik_number", [1.0, 3.0]),
        (&one, "m0>heights = { skewness = [-0.5, 0.1] }\nm0", "skewness", [-0.5, 0.1]),
        (&pair, "sq = 1e-6>sq = [1e-6, 2e-6]", "counterface_sq", [1e-6, 2e-6]),
        (
            &pair,
            "sq>mean_plane_offset = [1e-6, 2e-6], sq",
            "counterface_mean_plane_offset",
            [1e-6, 2e-6],
        ),
        (&in_gas, "ter = 3.7e-7>ter = [0, 3.7e-7]", "gas_parameter", [0.0, 3.7e-7]),
    ] {
        let (old, new) = edit.split_once('>').unwrap();
        let text = scene.replacen(old, new, 1);
        let file = parse(&text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let [one] = &file.unknowns()[..] else { panic!("{text}") };
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-4 * high;
        assert!(one.name == name && near(one.ends[0], low) && near(one.ends[1], high), "{one:?}");
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * (low + high) };
        let value = |file: &SceneFile| file.value_of(file.inputs([name]).unwrap()[0]).unwrap();
        assert!(near(value(&file), middle), "{name}: {}", value(&file));
        let points = file.points().unwrap();
        assert_eq!(points.all.len(), 2 + 64);
        assert!(near(value(&points.all[0]), low) && near(value(&points.all[1]), high), "{name}");
        // Written and read again.
        let again = parse(&file.to_toml().unwrap(), Path::new(".")).unwrap();
        assert_eq!(
            (again.unknowns(), again.scene.interface),
            (file.unknowns(), file.scene.interface)
        );
        // A number that is set has no range.
        let input = file.inputs([name]).unwrap()[0];
        assert!(file.with_inputs([(input, value(&file))]).unwrap().unknowns().is_empty());
        let other = file.inputs(["nominal_area"]).unwrap()[0];
        let left = file.with_inputs([(other, 3e-4)]).unwrap().unknowns();
        assert_eq!(left.len(), usize::from(name != "nominal_area"));
    }
}

#[test]
fn roughness_is_judged_by_its_finish_and_ranges_at_their_ends() {
    let found = |text: &str| {
        let file = parse(text, Path::new(".")).unwrap();
        let checked = file.check(None).unwrap().findings;
        let [all, checked] = [file.findings(), checked].map(|found| {
            let found = found.into_iter().filter(|one| one.code == Code::UnusualSize);
            found.map(|one| (one.field.to_string(), one.origin)).collect::<Vec<_>>()
        });
        assert_eq!(checked, all);
        all
    };
    let drawn = |keys: &str| found(&format!("{}{keys}\n", HEAD.replace("1e-8", "1e-4")));
    for (keys, field) in [
        ("finish = \"ground\"\nra = \"160 um\"", "ra"),
        ("finish = \"ground\"\nrq = \"0.8 nm\"", "rq"),
        ("finish = \"ground\"\nrz = 5", "rz"),
        ("finish = \"polished\"\nrz = \"0.8 nm\"", ""),
        ("finish = \"turned\"\nra = \"25 um\"", ""),
        ("rz = \"5 um\"\nrsm = 120", "rsm"),
    ] {
        let fields: String = drawn(keys).into_iter().map(|(field, _)| field).collect();
        assert_eq!(fields, field, "{keys}");
    }
    let body = |modulus: &str, hardness: &str| {
        let steel = "[[body]]\nmaterial = \"steel-100cr6\"\n";
        let own = format!(
            "[[body]]\nyoungs_modulus = {modulus}\npoissons_ratio = 0.3\nhardness = {hardness}\n"
        );
        found(&format!("nominal_area = 1e-4\n{own}{steel}{MOMENTS}"))
    };
    let end = |key: &str, end: &str| {
        vec![(format!("body[1].{key}"), Some(format!("{end} end of body1_{key}")))]
    };
    assert_eq!(body("2.1e11", "[1.6e6, 2.4e9]"), end("hardness", "lower"));
    assert_eq!(body("2.1e11", "[1.6e9, 2.4e12]"), end("hardness", "upper"));
    assert_eq!(body("[2.1e8, 2.1e11]", "2e9"), end("youngs_modulus", "lower"));
    assert_eq!(body("2.1e8", "2e9"), [("body[1].youngs_modulus".into(), None)]);
    assert_eq!(body("2.1e11", "[1.6e9, 2.4e9]"), []);
}

#[test]
fn ranges_that_are_none_are_refused_at_their_key() {
    let interface = |hardness: &str| {
        let text = format!("{}{MOMENTS}", INTERFACE.replace("= 2e9", &format!("= {hardness}")));
        parse(&text, Path::new("."))
    };
    assert!(interface("[2e9, 2e9]").unwrap().unknowns().is_empty());
    for odd in ["[-1e9, 2e9]", "[0, 2e9]", "[1e9, 2e9, 3e9]", "[1e9]", "[1e9, nan]"] {
        let error = interface(odd).unwrap_err();
        assert_eq!(error.place().unwrap().field, "interface.hardness", "{odd}: {error}");
        assert_eq!(error.place().unwrap().line, Some(5), "{odd}: {error}");
    }
}

/// Finer waves are steeper: by the ratio of the table for each factor of 3.2 of the cut-off.
#[test]
fn the_slope_of_a_finish_depends_on_the_short_cut_off() {
    let slope = |cut: f64| {
        let cut_offs = format!("lambda_s = {cut}e-6\nlambda_c = {}e-6", 100.0 * cut);
        let [_, [lower, _, upper], _] =
            ranges(&scene(&format!("ra = \"0.8 um\"\nfinish = \"honed\"\n{cut_offs}")));
        [lower, upper]
    };
    let [fine, usual, coarse] = [2.5 / 3.2, 2.5, 8.0].map(slope);
    for (ends, wanted) in [(coarse, [0.5, 0.75]), (fine, [1.0 / 0.75, 1.0 / 0.5])] {
        (0..2).for_each(|k| near(ends[k] / usual[k], wanted[k], 1e-9));
    }
    // A plateau-like profile at 25 um: 0.28 times the usual slope.
    let [lower, upper] = slope(25.0).map(|slope| slope / usual[0] * 0.4);
    assert!(lower < 0.28 && 0.28 < upper, "{lower} {upper}");
}

#[test]
fn the_other_surface_of_a_finish_is_said_or_warned_of() {
    let ground = "ra = [\"0.6 um\", \"1 um\"]\nfinish = \"ground\"";
    let with = |word: &str| scene(&format!("{ground}\ncounterface = \"{word}\""));
    let is_warned =
        |file: &SceneFile| file.warnings.iter().any(|one| one.code.name() == "smooth-counterface");
    assert!(is_warned(&scene(ground)) && scene(ground).model("ke-pairs").is_ok());
    // No rough surface that is not known within ranges needs the key.
    assert!(!is_warned(&scene(KNOWN)) && !is_warned(&scene("m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4")));
    let smooth = with("smooth");
    assert!(!is_warned(&smooth));
    assert_eq!(smooth.scene.surface, scene(ground).scene.surface);
    assert!(smooth.model("ke").is_ok() && smooth.model("ke-pairs").is_err());
    let again = parse(&smooth.to_toml().unwrap(), Path::new(".")).unwrap();
    assert!(again.model("ke-pairs").is_err());
    // The same is a surface of its own, with the same ranges.
    let same = with("same");
    assert!(!is_warned(&same) && same.model("ke-pairs").is_ok());
    let (own, other): (Vec<_>, Vec<_>) =
        open(&same).into_iter().partition(|(name, _)| !name.starts_with("counterface_"));
    assert_eq!((own.len(), other.len()), (4, 4));
    for ((name, spread), (other, same)) in own.iter().zip(&other) {
        assert_eq!(format!("counterface_{name}"), *other);
        near(*spread, *same, 1e-12);
    }
    let again = parse(&same.to_toml().unwrap(), Path::new(".")).unwrap();
    let sorted = |file: &SceneFile| {
        let mut names: Vec<String> = open(file).into_iter().map(|(name, _)| name).collect();
        names.sort_unstable();
        names
    };
    assert_eq!(sorted(&again), sorted(&same));
    let text = format!("{}{ground}\ncounterface = \"rough\"\n", HEAD.replace("1e-8", "1e-4"));
    let error = parse(&text, Path::new(".")).unwrap_err();
    assert_eq!(error.place().unwrap().field, "surface.counterface");
}

/// A surface by a finish whose height is a range: the range of the finish is that at each height.
#[test]
fn a_finish_supplies_its_ranges_at_every_height() {
    let file = scene("ra = [\"0.6 um\", \"1 um\"]\nfinish = \"ground\"");
    let names: Vec<String> = open(&file).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["ra", "rq", "mean_slope", "bandwidth"]);
    let lowest = file.at(&[0.0, 0.0, 0.5, 0.5]).unwrap();
    near(lowest.scene.surface.moments().m0.sqrt(), 0.6e-6 * 1.19, 1e-9);
}
