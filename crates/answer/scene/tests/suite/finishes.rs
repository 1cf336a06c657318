//! Surfaces by roughness and finish, whose numbers are known within ranges.

use std::path::Path;

use asperity::{ContactModel, Quantity, Request};
use asperity_scene::{SceneError, SceneFile, parse};

use crate::two_surfaces::HEAD;

/// A surface whose numbers have no range.
const KNOWN: &str = "rq = \"1 um\"\nrdq = 0.1\nbandwidth = 10";

fn scene(surface: &str) -> SceneFile {
    parse(&format!("{}{surface}\n", HEAD.replace("1e-8", "1e-4")), Path::new(".")).unwrap()
}

fn near(found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{found} is not {wanted}");
}

/// Ranges of Rq, slope and bandwidth of the first surface.
fn ranges(file: &SceneFile) -> [[f64; 3]; 3] {
    let all: Vec<[f64; 3]> =
        file.unknowns().into_iter().map(|(_, unknown)| unknown.range).collect();
    [all[0], all[1], all[2]]
}

#[test]
fn a_ground_surface_has_the_ranges_of_its_finish() {
    let file = scene("ra = \"0.8 um\"\nfinish = \"Ground\"");
    let [rq, slope, bandwidth] = ranges(&file);
    for (found, wanted) in rq.into_iter().zip([9.52e-7, 1.032_589e-6, 1.12e-6]) {
        near(found, wanted, 1e-6);
    }
    let usual = 0.125 * 1.032_589f64.powf(0.402);
    near(slope[0], 0.4 * usual * (1.0625f64 / 2.0).sqrt(), 1e-6);
    near(slope[2], 1.5 * usual * (1.4356f64 / 2.0).sqrt(), 1e-6);
    near(bandwidth[0], 5.5, 1e-12);
    near(bandwidth[2], 51.5, 1e-12);
    // The surface of the scene is the one in the middle.
    let moments = file.scene.surface.moments();
    near(moments.m0.sqrt(), rq[1], 1e-12);
    near(moments.bandwidth(), bandwidth[1], 1e-9);
    let (middle, corners) = file.corners().unwrap();
    assert_eq!((middle.scene.surface, corners.len()), (file.scene.surface, 8));
    let m0 = |k: usize| corners[k].scene.surface.moments().m0.sqrt();
    near(m0(0), rq[0], 1e-12);
    near(m0(1), rq[2], 1e-12);
    assert!(corners.iter().all(|corner| corner.spreads().is_empty()));
}

#[test]
fn a_number_that_is_given_has_no_range() {
    let exact = scene(KNOWN);
    assert!(exact.spreads().is_empty() && exact.need_known().is_ok());
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
    let names = |surface: &str| -> Vec<&str> {
        scene(surface).spreads().into_iter().map(|(name, _)| name).collect()
    };
    assert_eq!(names("ra = \"1 um\"\nfinish = \"lapped\"\nmean_slope = 0.1"), ["rq", "bandwidth"]);
    // The lay of a ground surface remains.
    let ground = scene(&format!("{KNOWN}\nfinish = \"ground\""));
    let [(name, spread)] = ground.spreads()[..] else { panic!("{:?}", ground.spreads()) };
    assert_eq!(name, "mean_slope");
    near(spread, (1.4356f64 / 1.0625).sqrt(), 1e-9);
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
fn two_faces_add_and_vary_together() {
    let ground = "ra = \"0.8 um\"\nfinish = \"ground\"";
    let inline = ground.replace('\n', ", ");
    let (one, both) = (scene(ground), scene(&format!("{ground}\ncounterface = {{ {inline} }}")));
    let moments = [&one, &both].map(|file| file.scene.surface.moments());
    near(moments[1].m0, 2.0 * moments[0].m0, 1e-9);
    near(moments[1].m2, 2.0 * moments[0].m2, 1e-9);
    near(moments[1].bandwidth(), moments[0].bandwidth(), 1e-9);
    let corners = [&one, &both].map(|file| file.corners().unwrap().1);
    for (one, both) in corners[0].iter().zip(&corners[1]) {
        near(both.scene.surface.moments().m2, 2.0 * one.scene.surface.moments().m2, 1e-9);
    }
    // A counterface by its moments has no range of its own.
    let beside = scene(&format!("{ground}\ncounterface = {{ m0 = 1e-18, m2 = 1e-8, m4 = 1e3 }}"));
    let spreads = [&one, &beside].map(|file| file.spreads()[1].1);
    near(spreads[0], spreads[1], 1e-3);
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
    for corner in open.corners().unwrap().1 {
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

#[test]
fn single_numbers_are_refused_and_the_keys_are_written_again() {
    let file = scene("ra = \"0.8 um\"\nfinish = \"ground\"");
    let SceneError::Refused { at, reason } = file.model("ke").unwrap_err() else { panic!() };
    assert!(at.field == "surface" && reason.contains("(rq, mean_slope, bandwidth)"), "{reason}");
    // The lay of the finish opens a known slope.
    let refused = scene(&format!(
        "{KNOWN}
finish = \"ground\""
    ))
    .model("ke")
    .unwrap_err();
    assert!(refused.to_string().contains("(mean_slope)"), "{refused}");
    assert!(scene(KNOWN).model("ke").is_ok());
    assert!(file.models().0.is_empty());
    assert!(file.inputs(["asperity_radius"]).is_err());
    let area = file.inputs(["nominal_area"]).unwrap()[0];
    let larger = file.with_inputs([(area, 2e-4)]).unwrap();
    let again = parse(&larger.to_toml(&[]).unwrap(), Path::new(".")).unwrap();
    assert_eq!((ranges(&again), again.scene.nominal_area), (ranges(&file), 2e-4));
    let check = file.check(None).unwrap();
    let named: Vec<_> = check.numbers.iter().take(3).map(|number| number.name).collect();
    assert_eq!(named, ["surface_rq", "surface_mean_slope", "surface_bandwidth"]);
    assert!(check.numbers[1].meaning.starts_with("scan: 0.4 to 1.5 times"));
    let modulus = check.numbers.iter().find(|number| number.name == "equivalent_modulus").unwrap();
    assert_eq!(modulus.ends, None);
    let index = check.numbers.iter().find(|number| number.name == "plasticity_index").unwrap();
    assert!(index.ends.is_some_and(|[lower, upper]| upper > 4.0 * lower));
}

#[test]
fn odd_numbers_have_a_warning() {
    let odd = |surface: &str| {
        let file = scene(surface);
        let all = file.warnings.iter().cloned().chain(file.findings());
        all.filter(|found| found.code != "smooth-counterface").count() > 0
    };
    let turned = "finish = \"turned\"\nfeed = \"0.2 mm\"\nnose_radius = \"0.8 mm\"";
    for (surface, wanted) in [
        ("ra = \"0.8 um\"\nfinish = \"ground\"", false),
        // The slope in metres, and the default of a program that is far too steep.
        ("ra = \"0.8 um\"\nfinish = \"ground\"\nmean_slope = 7e-6", true),
        ("rq = \"1 um\"\nmean_slope = 0.4", true),
        ("ra = \"1 um\"\nrq = \"1.11 um\"\nfinish = \"ground\"", true),
        // Rz is compared with Rq, also where its range follows from Ra.
        ("ra = \"1 um\"\nrz = \"1 um\"\nfinish = \"ground\"", true),
        ("ra = \"1 um\"\nrz = \"6 um\"\nfinish = \"ground\"", false),
        // The cusps of this tool have Ra = 0.2²/(31.18 0.8) mm = 1.604 um and a slope of 0.0625.
        (&format!("ra = \"0.8 um\"\n{turned}"), true),
        (&format!("ra = \"1.7 um\"\n{turned}"), false),
    ] {
        assert_eq!(odd(surface), wanted, "{surface}");
    }
    let [_, slope, _] = ranges(&scene(&format!("ra = \"1.6 um\"\n{turned}")));
    near(slope[0], 0.0625 * (1.01f64 / 2.0).sqrt(), 1e-9);
}
