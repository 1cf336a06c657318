//! What is said about scenes: one snapshot a topic, read as prose when it changes. Other tests look
//! at variants, fields, codes and numbers.

use std::fmt::Write;
use std::path::Path;

use asperity_scene::{HandedFiles, parse_handed, read_measurements, template};

use crate::scene_files::{INTERFACE, SURFACE, text};

const BODIES: &str = "[[body]]
youngs_modulus = \"210 GPa\"
poissons_ratio = 0.3
yield_strength = \"400 MPa\"
[[body]]
youngs_modulus = \"210 GPa\"
poissons_ratio = 0.3
yield_strength = \"400 MPa\"
";

/// Whole files.
const FILES: &[&str] = &[
    "nominal_area = ",
    "",
    "[surface]\nm0 = 1",
    "nominal_area = 1",
    "nominal_area = 1\nsurface = { m0 = 1, \"m 2\" = 3 }",
];

/// Lines above the sections.
const TOP: &[&str] = &[
    "[grains]",
    "interfaces = 3",
    "rigid_counterface = true",
    "work_of_adhesion = 0.05",
    "accept = [\"few-contact\"]",
];

/// What stands for the section of the interface.
const INTERFACES: &[&str] = &[
    "[interface]\nequivalent_modulus = 1e9",
    "body = 3",
    "[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3",
    "[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\n[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = 0.7",
    "body = [{}, {}, {}]",
    "rigid_counterface = true\nbody = [{}, {}]",
    "rigid_counterface = 1\n[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3",
    "rigid_counterface = true\n[body]",
    "[body]\n[body]",
    "rigid_counterface = true\n[[body]]\npoissons_ratio = 0.3",
    "rigid_counterface = true\n[[body]]\nmaterial = \"brass-naval\"\nhardness = 2e9",
    "rigid_counterface = true\n[[body]]\nmaterial = \"steel-100cr5\"",
    "rigid_counterface = true\n[[body]]\nmaterial = \"steel\"",
    "rigid_counterface = true\n[[body]]\nmaterial = \"unobtainium\"",
];

/// Lines below those of the interface.
const OF_INTERFACE: &[&str] = &[
    "nominal_area = 1",
    "body_1 = { hardness = 1e9 }",
    "work_of_adhesion = \"5 J\"",
    "electrical_conductivity = 1",
    "surface_energy = 1",
    "[[body]]",
    "electrical_resistivity = 1.7",
];

/// One text for another, in the interface and surface.
const EDITS: &[(&str, &str)] = &[
    ("asperity_radius", "asperity_radus"),
    ("1e-6", "\"1 parsec\""),
    ("1e-6", "-1e-6"),
    ("1e-6", "nan"),
    ("1e-6", "1e999"),
    ("0.31", "0.6"),
    ("0.31", "\"0.31\""),
    ("0.31", "0,31"),
    ("116e9", "\"116 mm\""),
    ("116e9", "\"116\""),
    ("116e9", "\u{201c}116 GPa\u{201d}"),
    ("1.11e8", "\"111 mm2\""),
    ("3e-5", "0"),
    ("3e-5", "\"1 in2\""),
    ("1.12e9", "\"1,12e9\""),
    ("1.12e9", "\"1,12 GPa\""),
    ("1.12e9", "\"58\""),
    ("1.12e9", "\"58 HRC\""),
    ("1.12e9", "\"200\""),
    ("1.12e9", "\"2\""),
    ("116e9", "\"120 HV\""),
];

/// Lines below those of the surface.
const OF_SURFACE: &[&str] = &[
    "plasticity_index = 6",
    "surface_height_std = 1e-6",
    "mean_slope = 0.1",
    "sdq = 0.1",
    "unit = \"um\"",
    "asperity_radius = 1",
    "work_of_adhesion = 0.05",
    "separation_from = \"surfacemean\"",
    "separation_from = \"surface-mean\"\nheights = \"exponential\"",
    "heights = \"gausian\"",
    "heights = \"measured\"",
    "heights = { fil = \"pdf.csv\" }",
    "heights = 3",
    "heights = { file = \"absent.csv\" }",
    "heights = { skewness = -6 }",
    "[options]\nstick = \"clampd\"",
    "[options]\nstik = 3",
    "[options]\nforce = 3",
    "[options]\nangle_density = { a20 = 3, a21 = 0, b21 = 0 }",
    "[options]\ndisplacement = { zeta = 1 }",
    "[options]\ndisplacement = { zeta = 1, xi = -1 }",
    "[options]\ndisplacement = { zeta = 1, xi = 1, eta = 1 }",
    "[options.displacement]\nzeta = 1",
    "[options]\nhurst_exponent = 2",
    "[options]\nnominal_area = 1",
];

/// What stands below `[surface]`: numbers.
const NUMBERS: &[&str] = &[
    "",
    "m0 = 1e-12\nm4 = 5e4",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 1.4e4",
    "m0 = 1\nm2 = 1\nm4 = 1\nasperity_height_std = 1",
    "asperity_radius = 1e-5\nasperity_density = 1e9\nsurface_height_std = 1e-6",
    "mean_slope = 0.1\nasperity_density = 2e9",
    "sq = 1e-9\nspd = 1.11e8\nspc = 2500",
    "sq = 1e-6\nspd = 1.11e8\nspc = -2500",
    "sq = 1e-6\nspd = 1.11e8\nspc = 2500\nm2 = 1e-2",
    "sq = 1e-6\nspd = 1.11e8\nspc = 2500\nsdq = 0.1",
    "sq = 1e-6\nspd = 1.11e8\nspc = 2500\nsurface_height_std = 1e-6",
    "sq = 1e-6\nsdq = 0.02",
    "sq = 1e-6\nspd = 1.11e8\nsdq = -0.02",
    "sq = 1e-6\nspd = 1.11e8\nsdq = 12",
    "sq = 1e-6\nspd = 1.11e8\nsdq = 90",
    "sq = 1e-6\nspd = 1.11e8\nsdq = 0.7",
    "sq = 1e-6\nspd = 1.11e8\nsdq = \"12 %\"",
    "sq = 1e-6\nspd = 1.11e8\nsdq = \"0,06\"",
    "sq = 1e-3\nspd = 1.11e8\nsdq = 12\n[surface.counterface]\nsq = 1e-3\nspd = 1.11e8\nsdq = 7",
    "surface_height_std = 1e-6\nasperity_density = 1.11e8\nmean_slope = 7",
    "surface_height_std = 1e-6\nasperity_density = 1.11e8\nmean_slope = 0.7",
];

/// What stands below `[surface]` on two bodies of steel: numbers in other units than SI.
const UNITS: &[&str] = &[
    "asperity_radius = 50\nasperity_density = 2000\nasperity_height_std = 1",
    "asperity_radius = \"50 m\"\nasperity_density = 2e9\nasperity_height_std = 1e-6",
    "asperity_radius = 2e-4\nasperity_density = 2e8\nsurface_height_std = 1.1",
    "sq = \"1 um\"\nspd = 2000\nspc = 50",
    "sq = 1.1\nspd = 2e8\nspc = 5e3",
    "sq = 1.1e-6\nspd = 2e8\nspc = 5",
    "sq = 1.1\nspd = 2e8\nspc = 5",
    "sq = 1.1\nspd = 200\nspc = 5",
    "sq = 1.1\nspd = 2e8\nsdq = 0.058",
    "sq = 1.1e-6\nspd = 200\nsdq = 0.058",
    "sq = 9\nspd = 8e8\nspc = 1.3e4",
    // None of these is in centimetres.
    "sq = 0.9e-6\nspd = 8e8\nspc = 1.3e6",
    "sq = 1e-7\nspd = 1e9\nspc = 1e5",
    "sq = 0.9\nspd = 8e8\nsdq = 0.31",
    "m0 = 1e-14\nm2 = 0.05\nm4 = 1e9",
    "asperity_radius = \"0.1 mm\"\nasperity_density = 1e8\nsurface_height_std = 1e-7",
    "sq = 0.05\nspd = \"80000 1/mm2\"\nspc = 1.3e4",
    "sq = \"0.9 um\"\nspd = \"8e4 1/m2\"\nspc = \"13000 1/m\"",
];

/// What stands below `[surface]`: roughness and finish.
const FINISHES: &[&str] = &[
    "ra = 8e-7",
    "ra = 8e-7\nfinish = \"ground\"",
    "finish = \"ground\"",
    "ra = 8e-7\nfinish = \"EDM\"",
    "ra = 8e-7\nfinish = \"grund\"",
    "ra = -8e-7\nfinish = \"ground\"",
    "ra = \"0.8\"\nfinish = \"ground\"",
    "ra = 0.8\nfinish = \"ground\"",
    "ra = 8e-7\nfinish = \"ground\"\nfeed = 1e-4",
    "ra = 8e-7\nfinish = \"turned\"\nfeed = 1e-4",
    "ra = 8e-7\nfinish = \"turned\"\nfeed = 2e-4\nnose_radius = 8e-4",
    "ra = 8e-7\nfinish = \"ground\"\nm0 = 1e-12",
    "ra = 8e-7\nfinish = \"ground\"\nfile = \"a.txt\"",
    "file = \"a.txt\"\ncounterface = { ra = 8e-7, finish = \"ground\" }",
    "ra = 8e-7\nfinish = \"ground\"\ncounterface = { file = \"a.txt\" }",
    "ra = 8e-7\nfinish = \"ground\"\nrsm = 1e-4",
    "ra = 8e-7\nfinish = \"ground\"\nrdq = 0.1\nmean_slope = 0.1",
    "ra = 8e-7\nfinish = \"ground\"\nmean_slope = 7e-6",
    "rq = 1e-6\nmean_slope = 0.4",
    "ra = 8e-7\nfinish = \"ground\"\nlambda_s = 1e-8",
    "ra = 8e-7\nfinish = \"ground\"\nlambda_c = 0.8",
    "ra = 8e-7\nfinish = \"ground\"\nlambda_c = 1e-6\nlambda_s = 2e-6",
    "ra = 8e-7\nrq = 7e-7\nfinish = \"ground\"",
    "ra = 1e-6\nrq = 1.11e-6\nfinish = \"ground\"",
    "ra = 1e-6\nrz = 1e-6\nfinish = \"ground\"",
    "ra = 8e-7\nfinish = \"ground\"\npeklenik_number = -2",
];

/// What stands below `[surface]`: scans, of which `a.txt` has 16 x 16 points and `few.txt` 4 x 4.
const SCANS: &[&str] = &[
    "file = 3",
    "file = \"absent.x3p\"",
    "file = \"empty.txt\"",
    "file = \"few.txt\"",
    "files = \"a.txt\"",
    "files = [\"a.txt\"]",
    "files = [\"a.txt\", 3]",
    "files = [\"empty.txt\", \"b\"]",
    "file = \"a.txt\"\nfiles = [\"a.txt\", \"b\"]",
    "file = \"a.txt\"\nm0 = 1e-12",
    "file = \"a.txt\"\nasperity_height_std = 1e-6",
    "file = \"a.txt\"\nunit = \"miles\"",
    "file = \"a.txt\"\nunit = \"Um\"",
    "file = \"a.txt\"\npixel_size = \"1 mile\"",
    "file = \"a.txt\"\npixel_size = 0",
    "file = \"a.txt\"\npixel_size = [1, 2, 3]",
    "file = \"a.txt\"\npixel_size = [1, nan]",
    "file = \"a.txt\"\nestimator = \"sumits\"",
    "file = \"a.txt\"\nlevel = \"plain\"",
    "file = \"a.txt\"\nfilter = -1",
    "file = \"a.txt\"\nsmooth = 8e-6\nfilter = 4e-6",
    "file = \"a.txt\"\nmax_missing = 10",
    "file = \"a.txt\"\naligned = true",
    "file = \"a.txt\"\naligned = \"yes\"",
    "file = \"a.txt\"\naligned = true\ncounterface = { file = \"few.txt\", unit = \"m\", pixel_size = 1e-6 }",
    "file = \"a.txt\"\nheights = \"measured\"\ncounterface = { m0 = 1e-12, m2 = 1e-4, m4 = 5e4 }",
    "files = [\"a.txt\", \"a.txt\"]\nestimator = \"summits\"",
    "files = [\"a.txt\", \"a.txt\"]\nheights = \"measured\"",
    "files = [\"a.txt\", \"a.txt\"]\ncounterface = { m0 = 1e-12, m2 = 1e-4, m4 = 5e4 }",
    "file = \"a.txt\"\ncounterface = { estimator = \"summits\", file = \"b.txt\" }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = { m0 = -1, m2 = 1, m4 = 1 }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = { sq = 1e-6, spd = 2e8 }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = { sq = 1e-6, spd = 2e8, spc = 5e3 }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = { m0 = 1, files = [\"a.txt\"] }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = { m6 = 1 }",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\ncounterface = 3",
    "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\n[surface.counterface]",
];

/// Tables of heights.
const TABLES: &[&str] = &[
    "",
    "z,p\n0,1\n1,1\n",
    "height_m,density_per_m\n",
    "height_m,density_per_m\n0,1\n\n1e-6,x\n",
    "height_m,density_per_m\n0,1\n1e-6,-1\n",
    "height_m,density_per_m\n0,1\n#\n1e-6,1\n0,1\n",
    "height_m,density_per_m\n0,1\n1e-6\n",
    "height_m,density_per_m\n0,0\n1e-6,0\n",
    "height_m,density_per_m\n-2e-6,0\n0,1\n2e-6,0\n",
];

/// Measurements.
const MEASUREMENTS: &[&str] = &[
    "load_N,area_m2,comment\n1,2,first\n",
    "load_kN,area_m2\nabc,1\n",
    "laod_N,displacement_um\n1,abc\n",
    "load_N,area_m2\n1;2\n",
    "\"1,000,000\",\"2,000,000\"\n",
    "[[body]]\nyoungs_modulus = 2e11\n",
    "load_N,area_m2\n1,two\n",
    "load_N,area_m2\n1,2\n3\n",
    "1,2\n3,4\n",
    "model,load_N\nke,1\ngw,1\n",
    "load_N,area_m2\n1,2,\n",
    "load_N\n# by hand\n1e400\n",
    "load_N area_m2\n1 2\n",
    "load_N,area_m2\n",
    "load_N,area_m2\n1,500'000.0\n",
    "load_N,area_m2\n1,12\u{202f}500\n",
    "load_N\n1,5\n",
    "load_N;area_m2\n1.500,5;2e-9\n",
    "load_N;area_m2\n1.500.000;2e-9\n",
    "load_N;area_m2\n1,5,0;2e-9\n",
    "load_N;area_m2\n1.500;2,0e-9\n",
    "load_N,area_m2\n1,5,2,0e-9\n",
    "load_N,area_m2\n1,5e6,3e8\n",
];

/// Names of numbers to change in the template.
const NAMES: &[&[&str]] = &[
    &["hardnes"],
    &["electrical_conductivity"],
    &["m0"],
    &["skewness"],
    &["plasticity_index", "asperity_radius"],
    &["equivalent_modulus", "body1_youngs_modulus"],
    &["body1_hardness", "hardness"],
];

/// An input in one line, and below it what is said about it.
fn entry(input: &str, said: &[String]) -> String {
    let mut all = format!("{}\n", input.trim_end().replace('\n', "; "));
    for line in said {
        assert!(!line.contains('\n'), "{line}");
        // Lists of keys are long.
        let end = if line.len() > 320 { " ..." } else { "" };
        writeln!(all, "    {}{end}", line.get(..320).unwrap_or(line)).unwrap();
    }
    all
}

/// The error of a scene, or its warnings and findings.
fn of_scene(scene: &str, heights: &str) -> Vec<String> {
    let rows = |count: usize| {
        let row = |y: usize| (0..count).map(move |x| ((7 * x + 11 * y) % 13).to_string());
        (0..count).map(|y| row(y).collect::<Vec<_>>().join(" ") + "\n").collect::<String>()
    };
    let scan = format!("# Width: 16 um\n# Height: 16 um\n# Value units: nm\n{}", rows(16));
    let files = [("a.txt", scan), ("few.txt", rows(4)), ("empty.txt", String::new())];
    let files = files.into_iter().chain([("pdf.csv", heights.to_string())]);
    let files: HandedFiles =
        files.map(|(name, text)| (name.to_string(), text.into_bytes())).collect();
    match parse_handed(scene, &files) {
        Ok(file) => {
            let all = file.warnings.iter().cloned().chain(file.findings());
            let converted = file.converted().iter();
            let mut said: Vec<String> =
                converted.map(|(key, text)| format!("{key}: {text}")).collect();
            for line in all.map(|found| found.to_string()) {
                if !said.contains(&line) {
                    said.push(line);
                }
            }
            said
        }
        Err(error) => vec![error.to_string()],
    }
}

fn of_scenes<'a>(inputs: &[&'a str], scene: impl Fn(&'a str) -> String) -> String {
    inputs.iter().map(|input| entry(input, &of_scene(&scene(input), ""))).collect()
}

#[test]
fn files_and_sections() {
    let files = of_scenes(FILES, |file| file.to_string());
    let top = of_scenes(TOP, |top| text(top, INTERFACE, SURFACE));
    let interfaces = of_scenes(INTERFACES, |interface| text("", interface, SURFACE));
    insta::assert_snapshot!([files, top, interfaces].join("\n"));
}

#[test]
fn keys_and_values() {
    let of_interface =
        of_scenes(OF_INTERFACE, |key| text("", &format!("{INTERFACE}{key}"), SURFACE));
    let edited = |(from, to): &(&str, &str)| {
        let found = of_scene(&text("", INTERFACE, SURFACE).replacen(from, to, 1), "");
        entry(&format!("{from} -> {to}"), &found)
    };
    let edits = EDITS.iter().map(edited).collect();
    let of_surface = of_scenes(OF_SURFACE, |key| text("", INTERFACE, &format!("{SURFACE}{key}")));
    insta::assert_snapshot!([of_interface, edits, of_surface].join("\n"));
}

#[test]
fn numbers_of_a_surface() {
    let numbers = of_scenes(NUMBERS, |keys| text("", INTERFACE, &format!("[surface]\n{keys}")));
    let units = of_scenes(UNITS, |keys| text("", BODIES, &format!("[surface]\n{keys}")));
    insta::assert_snapshot!([numbers, units].join("\n"));
}

#[test]
fn finishes() {
    let found = of_scenes(FINISHES, |keys| text("", BODIES, &format!("[surface]\n{keys}")));
    insta::assert_snapshot!(found);
}

#[test]
fn scans_and_pairs() {
    let found = of_scenes(SCANS, |keys| text("", BODIES, &format!("[surface]\n{keys}")));
    insta::assert_snapshot!(found);
}

#[test]
fn tables_of_heights() {
    let surface = format!("{SURFACE}heights = {{ file = \"pdf.csv\" }}\n");
    let [own, metres] = ["1e-6", "1"].map(|std| text("", INTERFACE, &surface.replace("1e-6", std)));
    let datum = format!("{own}separation_from = \"surface-mean\"\n");
    let each = TABLES.iter().map(|table| entry(table, &of_scene(&own, table)));
    let last = TABLES[TABLES.len() - 1];
    let more = [&metres, &datum].map(|scene| entry(last, &of_scene(scene, last)));
    insta::assert_snapshot!(each.chain(more).collect::<String>());
}

#[test]
fn measurements() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("data.csv");
    let refused = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        let message = read_measurements(&path).unwrap_err().to_string();
        vec![message.replace(&format!("{}", path.display()), "data.csv")]
    };
    let texts = MEASUREMENTS.iter().map(|text| entry(text, &refused(text.as_bytes())));
    let binary = entry("(an Excel file)", &refused(b"PK\x03\x04\xff\x14\x00"));
    insta::assert_snapshot!(texts.chain([binary]).collect::<String>());
}

#[test]
fn names_of_numbers() {
    let file = asperity_scene::parse(template(), Path::new(".")).unwrap();
    let refused = |names: &&[&str]| {
        let message = file.inputs(names.iter().copied()).unwrap_err().to_string();
        entry(&names.join(", "), &[message])
    };
    insta::assert_snapshot!(NAMES.iter().map(refused).collect::<String>());
}
