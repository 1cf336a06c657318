//! Texts with several readings, in many words, delimiters and encodings: read as one map, or
//! refused with the option that decides.

use asperity_topography::read_bytes;

use crate::texts::{
    COLUMNS, COMMA, ENGLISH, GERMAN, ROWS, STEP, STYLES, Style, TAB, cases, gwyddion, options,
    plain, z,
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
fn a_comment_within_a_table_is_none_and_a_broken_row_is_refused() {
    let gwy = gwyddion(ENGLISH, "nm") + &plain();
    cases([
        (gwy.replacen('\n', "\n# note: 3\n", 9), "", ""),
        (gwy.replacen("\t", "\tx", 3), "", "line 5"),
    ]);
}

#[test]
fn several_profiles_beside_one_x() {
    let three = |names: &str, style: Style| -> String {
        let line = |j: usize| style.line([STEP * j as f64, z(0, j), z(1, j), z(2, j)]);
        names.to_owned() + &(0..COLUMNS).map(line).collect::<String>()
    };
    let mut all = vec![];
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
