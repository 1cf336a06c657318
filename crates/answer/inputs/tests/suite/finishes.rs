//! Surfaces by roughness and finish, whose numbers are known within ranges.

use std::path::Path;

use asperity::{ContactModel, Quantity, Request};
use asperity_inputs::{SceneFile, parse};

use crate::two_surfaces::HEAD;

fn read(surface: &str) -> Result<SceneFile, String> {
    parse(&format!("{}{surface}\n", HEAD.replace("1e-8", "1e-4")), Path::new("."))
        .map_err(|error| error.to_string())
}

fn scene(surface: &str) -> SceneFile {
    read(surface).unwrap()
}

fn near(found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{found} is not {wanted}");
}

/// Ranges of Rq, slope and bandwidth of the first surface.
fn ranges(file: &SceneFile) -> [[f64; 3]; 3] {
    let all: Vec<[f64; 3]> = file.unknowns().map(|(_, unknown)| unknown.range).collect();
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
    let exact = scene("rq = \"1 um\"\nrdq = 0.1\nbandwidth = 10");
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
    let ground = scene("rq = \"1 um\"\nfinish = \"ground\"\nrdq = 0.1\nbandwidth = 10");
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
    let counterface = "counterface = { rq = \"0.5 um\", rdq = 0.1, bandwidth = 10.0 }";
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
    let refused = file.model("ke").unwrap_err().to_string();
    assert!(refused.contains("known within ranges only (rq, mean_slope, bandwidth)"), "{refused}");
    // The lay of the finish opens a known slope.
    let known = "rq = \"1 um\"\nrdq = 0.1\nbandwidth = 10";
    let refused = scene(&format!("{known}\nfinish = \"ground\"")).model("ke").unwrap_err();
    let text = refused.to_string();
    assert!(
        text.contains("(mean_slope)") && text.contains("without a finish, whose lay"),
        "{text}"
    );
    assert!(scene(known).model("ke").is_ok());
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
fn what_is_missing_or_does_not_go_together_is_refused() {
    for (surface, wanted) in [
        (
            "ra = \"0.8 um\"",
            "surface.finish is missing: a height leaves the slope open: finish = one of \"blasted\", ",
        ),
        (
            "finish = \"ground\"",
            "surface.ra is missing: a finish needs the height of the roughness: ra, rq or rz",
        ),
        ("ra = 8e-7\nfinish = \"EDM\"", "(\"unknown\" for a finish without data) was required"),
        ("ra = 8e-7\nfinish = \"grund\"", "(the nearest is \"ground\")"),
        ("ra = -8e-7\nfinish = \"ground\"", "surface.ra is -8e-7"),
        ("ra = 8e-7\nfinish = \"ground\"\nfeed = 1e-4", "surface.feed and surface.finish (line"),
        (
            "ra = 8e-7\nfinish = \"turned\"\nfeed = 1e-4",
            "surface.nose_radius is missing: feed and nose_radius go together",
        ),
        ("ra = 8e-7\nfinish = \"ground\"\nm0 = 1e-12", "exclude each other"),
        ("ra = 8e-7\nfinish = \"ground\"\nfile = \"a.x3p\"", "exclude each other"),
        (
            "file = \"a.x3p\"\ncounterface = { ra = 8e-7, finish = \"ground\" }",
            "surface.counterface: the ranges of a finish do not add",
        ),
        (
            "ra = 8e-7\nfinish = \"ground\"\ncounterface = { file = \"a.x3p\" }",
            "surface: the ranges of a finish do not add to the moments of a scan: describe this surface by",
        ),
        (
            "ra = 8e-7\nfinish = \"ground\"\nrsm = 1e-4",
            "surface.rz is missing: rsm gives the slope with rz only",
        ),
        (
            "ra = 8e-7\nfinish = \"ground\"\nrdq = 0.1\nmean_slope = 0.1",
            "one of the two was required",
        ),
        (
            "ra = 8e-7\nfinish = \"ground\"\nlambda_s = 1e-8",
            "surface.bandwidth is missing: lambda_c/lambda_s is 80000",
        ),
        ("ra = 8e-7\nrq = 7e-7\nfinish = \"ground\"", "surface.rq = 7e-7 is below `ra`"),
        ("ra = 8e-7\nfinish = \"ground\"\nlambda_c = 0.8", "surface.lambda_c = 0.8 is in m: write"),
        (
            "ra = 8e-7\nfinish = \"ground\"\nlambda_c = 1e-6\nlambda_s = 2e-6",
            "surface.lambda_c = 1e-6 is the long cut-off",
        ),
        ("ra = \"0.8\"\nfinish = \"ground\"", "surface.ra = \"0.8\" has no unit; write \"0.8 um\""),
        (
            "ra = 8e-7\nfinish = \"ground\"\npeklenik_number = -2",
            "surface.peklenik_number is -2.0: a finite number above 0 was required",
        ),
    ] {
        let found = read(surface).unwrap_err();
        assert!(found.contains(wanted), "{surface}: {found}");
    }
}

#[test]
fn odd_numbers_have_a_warning() {
    let warnings = |surface: &str| -> Vec<String> {
        let file = scene(surface);
        let all = file.warnings.iter().cloned().chain(file.findings());
        all.map(|found| format!("{}: {}", found.code, found.message())).collect()
    };
    let has = |surface: &str, text: &str| {
        let found = warnings(surface);
        assert!(found.iter().any(|one| one.contains(text)), "{surface}: {found:?}");
    };
    let smooth = "smooth-counterface: the other surface is taken as smooth (by models of pairs as rough as this one): describe it as counterface if it is rough, too";
    assert_eq!(warnings("ra = \"0.8 um\"\nfinish = \"ground\""), [smooth]);
    // The slope in metres, and the default of a program that is far too steep.
    has(
        "ra = \"0.8 um\"\nfinish = \"ground\"\nmean_slope = 7e-6",
        "machined surfaces of this roughness have",
    );
    has(
        "rq = \"1 um\"\nmean_slope = 0.4",
        "machined surfaces of this roughness have 0.03125 to 0.225",
    );
    has(
        "ra = \"1 um\"\nrq = \"1.11 um\"\nfinish = \"ground\"",
        "rq is 1.11 times ra, and such surfaces have 1.19 to 1.4 (a sine has 1.11)",
    );
    // Rz is compared with Rq, also where its range follows from Ra.
    let rz = |rz: &str| format!("ra = \"1 um\"\nrz = \"{rz} um\"\nfinish = \"ground\"");
    has(&rz("1"), "rz is 0.7748 times the Rq of the surface, and such surfaces have 3.3 to 5.8");
    assert_eq!(warnings(&rz("6")), [smooth]);
    has("ra = 0.8\nfinish = \"ground\"", "ra = 0.8 looks like um");
    // The cusps of this tool have Ra = 0.2²/(31.18 0.8) mm = 1.604 um and a slope of 0.0625.
    let turned = "finish = \"turned\"\nfeed = \"0.2 mm\"\nnose_radius = \"0.8 mm\"";
    has(&format!("ra = \"0.8 um\"\n{turned}"), "have an Ra of 1.604 um, more than the 0.8 um");
    let [_, slope, _] = ranges(&scene(&format!("ra = \"1.6 um\"\n{turned}")));
    near(slope[0], 0.0625 * (1.01f64 / 2.0).sqrt(), 1e-9);
    assert_eq!(warnings(&format!("ra = \"1.7 um\"\n{turned}")), [smooth]);
}
