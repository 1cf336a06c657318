//! Texts with several readings, in many words, delimiters and encodings: read as one map, or
//! refused with the option that decides.

use asperity_topography::read_bytes;

use crate::texts::{
    COLUMNS, COMMA, ENGLISH, GERMAN, LANGUAGES, ROWS, STEP, STYLES, Style, TAB, cases, gwyddion,
    options, plain, z,
};

#[test]
fn codes_of_missing_points_are_refused_at_any_share() {
    let gwy = gwyddion(ENGLISH, "nm");
    let coded = |code: f64, nth: usize| -> String {
        let z =
            |i: usize, j: usize| if (31 * i + 17 * j).is_multiple_of(nth) { code } else { z(i, j) };
        gwy.clone()
            + &(0..ROWS).map(|i| TAB.line((0..COLUMNS).map(|j| z(i, j)))).collect::<String>()
    };
    let codes = [-9999.0, -32768.0, 32767.0, 1e10, -1000.0, 1e30, 500.0, -400.0, 65535.0, 9999.0];
    cases(codes.map(|code| (coded(code, 23), "", "missing")));
    cases(codes.map(|code| (coded(code, 61), "", "missing")));
    cases([3, 7, 11].map(|nth| (coded(-500.0, nth), "", "missing")));
    cases([(coded(-500.0, 23), "missing=-500", "")]);
    let kept = read_bytes("a.txt", coded(-500.0, 23).as_bytes(), &options("missing=nan")).unwrap();
    assert!(kept.missing_share() == 0.0);
    // Saturation at the end of a range, and terraces.
    let clipped = gwy.clone() + &TAB.matrix(|z| z.clamp(-60.0, 60.0));
    assert!(read_bytes("a.txt", clipped.as_bytes(), &options("")).is_ok());
    let terraces = gwy + &TAB.matrix(|z| 100.0 * (z / 60.0).round());
    assert!(read_bytes("a.txt", terraces.as_bytes(), &options("")).is_ok());
}

#[test]
fn a_second_table_is_a_second_image() {
    let gwy = |unit: &str| gwyddion(ENGLISH, unit) + &plain();
    let phase = gwyddion(ENGLISH, "deg").replace("Topo", "Phase") + &plain();
    let both = gwy("nm") + "\n" + &phase;
    let first = "unit=nm pixel=0.25um";
    cases([
        (both.clone(), "", "channel"),
        (both.clone(), "channel=1", ""),
        (both.clone(), "channel=topo", ""),
        (both.clone(), "channel=Phase", "Value units: deg"),
        (both.clone(), "channel=3", "channel is \"3\""),
        (phase + &gwy("nm"), "channel=2", ""),
        (gwy("nm") + &gwy("nm") + &gwy("nm"), "", "channel"),
        (gwy("nm") + &gwyddion(LANGUAGES[1], "nm") + &plain(), "", "channel"),
        (gwy("nm") + "# Channel: Zoom\n1\t2\t4\n5\t6\t9\n", "channel=Topo", ""),
        (format!("Height\n{}\nPhase\n{}", plain(), plain()), first, "channel"),
        (format!("Height\n{}\nPhase\n{}", plain(), plain()), "unit=nm pixel=0.25um channel=2", ""),
        (format!("[Height];\n{0}[Error];\n{0}", GERMAN.matrix(|z| z)), first, "channel"),
        (format!("{}\n{}", plain(), plain()), first, "channel"),
        (
            format!("{}\n\n{}\n\n{}", plain(), plain(), plain()),
            "unit=nm pixel=0.25um channel=3",
            "",
        ),
        (format!("{0},,\n{0}", COMMA.matrix(|z| z)), first, "a row of 3"),
        // A comment, a broken row, a last word and metadata behind the table are none.
        (gwy("nm") + "# exported\n" + "# by hand\n", "", ""),
        (gwy("nm").replacen('\n', "\n# note: 3\n", 9), "", ""),
        (gwy("nm") + "EOF\n", "", ""),
        (gwy("nm") + "[End]\n", "", ""),
        (plain() + &gwyddion(ENGLISH, "nm"), "", ""),
        (gwy("nm") + "the end of it\n", "", "line 23"),
        (gwy("nm") + "12 x\n", "", "line 23"),
        (gwy("nm").replacen("\t", "\tx", 3), "", "line 5"),
    ]);
}

#[test]
fn commas_between_and_within_numbers_are_refused() {
    let (gwy, both) = (gwyddion(ENGLISH, "nm"), Style(", ", ",", ""));
    cases([
        (gwy.clone() + &both.matrix(|z| z), "", "delimiter"),
        (gwy.clone() + &both.matrix(|z| z), "delimiter=", ""),
        (gwy.clone() + &both.matrix(|z| z), "delimiter=,", "delimiter"),
        (both.points(|x, y, z| vec![x, y, z]), "units=um,nm", "delimiter"),
        (both.points(|x, y, z| vec![x, y, z]), "units=um,nm delimiter=", ""),
        (gwy.clone() + &Style(", ", ".", "").matrix(|z| z), "", ""),
        (gwy.clone() + &Style(", ", ",", "\"").matrix(|z| z), "", ""),
        (gwy + &Style(" ", ",", "").matrix(|z| z), "", ""),
    ]);
}

#[test]
fn lengths_of_a_header_agree_or_are_refused() {
    let sides = |keys: &str| format!("{keys}unit: nm\n{}", plain());
    let both = |pixel: &str| gwyddion(ENGLISH, "nm") + "# Pixel size: " + pixel + "\n" + &plain();
    cases([
        (sides("Xsize: 6 um\nYsize: 4.5 um\n"), "", ""),
        (sides("X Size 6 um\nY Size 4.5 um\n"), "", ""),
        (sides("xsize 24\nysize 18\nx length 6 um\ny length 4.5 um\n"), "", ""),
        (both("0.25 um"), "", ""),
        (both("0.0005 mm"), "", "line 2"),
        (both("1 um"), "", "24 times the distance of points"),
    ]);
}

#[test]
fn columns_that_are_no_heights_are_refused() {
    let two = |names: &str, style: Style| {
        format!(
            "{names}\n{}",
            (0..COLUMNS).map(|j| style.line([STEP * j as f64, z(0, j)])).collect::<String>()
        )
    };
    let one = |name: &str| {
        format!("{name}\n") + &(0..COLUMNS).map(|j| format!("{}\n", z(0, j))).collect::<String>()
    };
    let none = "required: a column of heights";
    cases([
        (two("x(mm)\tSlope (urad)", TAB), "", none),
        (two("x [mm];Steigung [mrad]", GERMAN), "unit=um", none),
        (two("Position (mm),Tilt (µrad)", COMMA), "unit=um", none),
        (two("x_um,phase_deg", COMMA), "unit=nm", none),
        (two("x [um] V [mV]", Style(" ", ".", "")), "unit=nm", none),
        (two("\"x (um)\",\"Intensity (%)\"", COMMA), "unit=nm", none),
        (two("x in um\tangle in rad", TAB), "unit=nm", none),
        (two("Distance/um;Winkel/°", GERMAN), "unit=nm", none),
        (two("#x gradient", Style(" ", ".", "")), "units=um,nm", none),
        (two("X;Y\n[um];[V]", GERMAN), "unit=nm", none),
        (two("x (um)\tz (V)", TAB), "unit=nm columns=x,z", "required: a unit of length"),
        (one("Slope (urad)"), "unit=nm pixel=0.25um", none),
        (one("intensity"), "unit=nm pixel=0.25um", none),
        (two("x(um)\tz (nm)", TAB), "", ""),
        (two("x [um];z [nm]", GERMAN), "", ""),
        (two("x_um y_nm", Style(" ", ".", "")), "", ""),
        (two("Lateral um,Raw nanometer,", COMMA), "", ""),
        (two("Abscissa (um)\tHöhe (nm)", TAB), "", ""),
        (two("Weglänge [um];Höhe [nm]", GERMAN), "", ""),
        (two("t,z", COMMA), "units=um,nm", ""),
    ]);
}

#[test]
fn columns_are_named_and_chosen() {
    let named = |names: &str, style: Style, of: &dyn Fn(f64, f64, f64) -> Vec<f64>| {
        format!("{names}\n{}", style.points(of))
    };
    let space = Style(" ", ".", "");
    let grey = |z: f64| (100.0 + z / 3.0).round();
    let um = |x, y, z: f64| vec![x, y, z / 1e3];
    let four = |x, y, z: f64| vec![x, y, z, grey(z)];
    cases([
        (named("y_um,x_um,z_nm", COMMA, &|x, y, z| vec![y, x, z]), "", ""),
        (named("z [nm];y [um];x [um]", GERMAN, &|x, y, z| vec![z, y, x]), "", ""),
        (named("Z(nm)\tX(um)\tY(um)", TAB, &|x, y, z| vec![z, x, y]), "", ""),
        (named("//X Y Z Intensity", space, &|x, y, z| vec![x, y, z / 1e3, grey(z)]), "unit=um", ""),
        (
            named("x y z r g b", space, &|x, y, z| vec![x, y, z / 1e3, grey(z), 1.0, 2.0]),
            "unit=um",
            "",
        ),
        (named("id,x,y,z", COMMA, &|x, y, z| vec![1e4 * y + x, x, y, z / 1e3]), "unit=um", ""),
        (named("x,y,intensity,z", COMMA, &|x, y, z| vec![x, y, grey(z), z]), "units=um,nm", ""),
        (named("X Pos;Y Pos;Height;Quality", GERMAN, &four), "units=um,um,nm", ""),
        (
            named("Unnamed: 0,x,y,z", COMMA, &|x, y, z| vec![1e4 * y + x, x, y, z]),
            "units=um,nm",
            "",
        ),
        (named(",x,y,z", COMMA, &|x, y, z| vec![1e4 * y + x, x, y, z]), "units=um,nm", ""),
        (named("x,y,z1,z2", COMMA, &four), "units=um,nm", "columns"),
        (named("x,y,z1,z2", COMMA, &four), "units=um,nm columns=x,y,z,-", ""),
        (named("x,y,z,z_error", COMMA, &four), "units=um,nm", ""),
        // Without names.
        (space.points(four), "units=um,nm", "columns"),
        (COMMA.points(four), "units=um,nm columns=x,y,z,-", ""),
        (GERMAN.points(|x, y, z| vec![y, z, x]), "units=um,nm columns=y,z,x", ""),
        (TAB.points(|x, y, z| vec![1.0 + x, y, z, 7.0, 8.0, 9.0]), "units=um,nm", "columns"),
        (
            TAB.points(|x, y, z| vec![1.0 + x, y, z, 7.0, 8.0, 9.0]),
            "units=um,nm columns=x,y,z,-,-,-",
            "",
        ),
        // Lengths and heights in different units.
        (COMMA.points(|x, y, z| vec![x / 1e3, y / 1e3, z / 1e3]), "units=mm,um", ""),
        (TAB.points(|x, y, z| vec![x / 1e3, y, z]), "units=mm,um,nm", ""),
        (GERMAN.points(um), "unit=um", ""),
        (named("x [mm];y [mm];z [um]", GERMAN, &um), "units=um,um", "units is um"),
        (named("x [um];y [um];z [um]", GERMAN, &um), "unit=nm", "unit is nm"),
        (space.points(um), "", "give unit"),
        (space.points(um), "unit=um columns=x,y", "columns is \"x,y\""),
        (space.points(um), "unit=um columns=9", "columns is \"9\""),
        (space.points(um).replace(' ', "|"), "unit=um delimiter=|", ""),
        (Style(",", ",", "").points(um).replace(',', "."), "unit=um", "required"),
        (format!("one\n2 three\n{}", space.points(um)), "unit=um skip=2", ""),
    ]);
}

#[test]
fn several_profiles_beside_one_x() {
    let three = |names: &str, style: Style| -> String {
        let line = |j: usize| style.line([STEP * j as f64, z(0, j), z(1, j), z(2, j)]);
        names.to_owned() + &(0..COLUMNS).map(line).collect::<String>()
    };
    let mut all = vec![
        (three("x_um,z1_nm,z2_nm,z3_nm\n", COMMA), "columns=2", ""),
        (three("x_um,z1_nm,z2_nm,z3_nm\n", COMMA), "columns=x,z,-,-", ""),
        (three("x [um];z1 [nm];z2 [nm];z3 [nm]\n", GERMAN), "columns=2", ""),
        (three("", TAB), "units=um,nm columns=x,z,-,-", ""),
        (three("x,first,second,third\n", COMMA), "units=um,nm columns=x,z,-,-", ""),
    ];
    for names in [
        "x_um,z1_nm,z2_nm,z3_nm\n",
        "x,z,z,z\n",
        "Distance,profile1,profile2,profile3\n",
        "x,first,second,third\n",
        "",
    ] {
        all.extend(
            STYLES.map(|style| {
                (three(&names.replace(',', style.0), style), "units=um,nm", "columns")
            }),
        );
    }
    cases(all);
}

#[test]
fn axes_are_told_from_heights() {
    // A line of positions over the columns and one before each row.
    let framed = |corner: &str, style: Style, of: &dyn Fn(usize) -> f64| -> String {
        let top = style.line((0..COLUMNS).map(of));
        let row =
            |i: usize| style.line(std::iter::once(of(i)).chain((0..COLUMNS).map(|j| z(i, j))));
        format!("{corner}{}{top}", style.0) + &(0..ROWS).map(row).collect::<String>()
    };
    let counted = |style| framed("", style, &|k| k as f64);
    let placed = |corner, style| framed(corner, style, &|k| STEP * k as f64);
    let (pixel, lateral) = ("unit=nm pixel=0.25um", "units=um,nm");
    let styles = [TAB, COMMA, GERMAN, Style(";", ".", "\"")];
    cases(styles.map(|style| (counted(style), pixel, "")));
    cases(styles.map(|style| (framed("", style, &|k| (k + 1) as f64), pixel, "")));
    cases(styles.map(|style| (counted(style), "unit=nm", "give pixel_size")));
    cases(styles.map(|style| (placed("y\\x", style), lateral, "")));
    cases(styles.map(|style| (placed("", style), lateral, "")));
    cases(styles.map(|style| (placed("y\\x", style), "unit=nm", "units")));
    cases(styles.map(|style| (placed("y/x [um]", style), "unit=nm", "")));
    cases(styles.map(|style| (placed("um", style), "unit=nm", "")));
    cases(styles.map(|style| (placed("nan", style), lateral, "")));
    cases(styles.map(|style| (placed("0", style), lateral, "columns")));
    cases(styles.map(|style| (placed("0", style), "units=um,nm columns=axes", "")));
    // Rows from the last to the first.
    let down = |k: usize| STEP * (ROWS - 1 - k) as f64;
    let row = |i: usize| {
        COMMA.line(std::iter::once(down(i)).chain((0..COLUMNS).map(|j| z(ROWS - 1 - i, j))))
    };
    let top = COMMA.line((0..COLUMNS).map(|j| STEP * j as f64));
    cases([(format!("y\\x,{top}") + &(0..ROWS).map(row).collect::<String>(), lateral, "")]);
    // Axes without a corner.
    let beside = |style: Style, of: &dyn Fn(usize) -> f64| -> String {
        (0..ROWS)
            .map(|i| style.line(std::iter::once(of(i)).chain((0..COLUMNS).map(|j| z(i, j)))))
            .collect()
    };
    cases(styles.map(|style| (beside(style, &|i| i as f64), pixel, "columns")));
    cases(styles.map(|style| (beside(style, &|i| STEP * i as f64), pixel, "columns")));
    cases(
        styles.map(|style| (beside(style, &|i| i as f64), "unit=nm pixel=0.25um columns=axes", "")),
    );
    cases(styles.map(|style| {
        (style.line((0..COLUMNS).map(|j| STEP * j as f64)) + &style.matrix(|z| z), pixel, "columns")
    }));
    let matrix = read_bytes(
        "a.csv",
        beside(COMMA, &|i| i as f64).as_bytes(),
        &options("unit=nm pixel=0.25um columns=matrix"),
    );
    assert_eq!(matrix.unwrap().columns(), COLUMNS + 1);
    // A tilted or smooth surface is none.
    let tilted: String =
        (0..ROWS).map(|i| TAB.line((0..COLUMNS).map(|j| (2 * i + 3 * j) as f64))).collect();
    assert_eq!(read_bytes("a.txt", tilted.as_bytes(), &options(pixel)).unwrap().columns(), COLUMNS);
}

#[test]
fn counts_and_lengths_above_a_profile_are_no_heights() {
    let tester = |head: &str| {
        head.to_owned() + &(0..COLUMNS).map(|j| format!("{}\n", z(0, j))).collect::<String>()
    };
    let given = "unit=nm pixel=0.25um";
    let heads = [
        "4.8\n24\n",
        "24\n",
        "24.0\n",
        "4.8\n0.25\n24\n",
        "Ra\n4.8\n24\n",
        "0\n24\n",
        "1\n2\n3\n24\n",
        "+4.8\n24\n",
        "4,8\n24\n",
        "\n4.8\n\n24\n",
    ];
    cases(heads.map(|head| {
        (tester(head), given, if head == "4,8\n24\n" { "required" } else { "skip_lines" })
    }));
    cases([
        (tester("4.8\n24\n"), "unit=nm pixel=0.25um skip=2", ""),
        (tester("Ra\n4.8\n24\n"), "unit=nm pixel=0.25um skip=3", ""),
        (
            tester("Evaluation length: 4 um\nColumns: z\nStep: 2\nX range: 0 - 6\nUnit: nm\n"),
            "",
            "give pixel_size",
        ),
        (tester("Columns: z\nStep: 2\nLength x = 7\nUnit: nm\n"), "pixel=0.25um", ""),
        (tester("Profile length: 6 um\nUnit: nm\n"), "", ""),
        (tester("Scan Length; 6; um\nEinheit; nm\n"), "", ""),
        (tester("Sampling interval = 250 nm\nPoints = 24\nUnit = nm\n"), "", ""),
        (tester("z [nm]\n"), "pixel=0.25um", ""),
        (tester("Profile 1\n"), "unit=nm pixel=0.25um", ""),
    ]);
}
