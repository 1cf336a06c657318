//! One map in the dialects of instruments and programs is read as the map.

use asperity_topography::{ReadOptions, Topography, TopographyError, read_bytes, read_header};

pub const COLUMNS: usize = 24;
pub const ROWS: usize = 18;
/// Distance of points [um].
pub const STEP: f64 = 0.25;

/// Heights [nm] of a row and a column.
pub fn z(row: usize, column: usize) -> f64 {
    let (x, y) = (column as f64, row as f64);
    let wave = 60.0 * (0.9 * x + 0.3 * y).sin() + 40.0 * (0.5 * x - 1.1 * y).cos();
    (1e3 * (wave + 15.0 * (7.3 * x * y + 2.1 * x).sin())).round() / 1e3
}

/// Numbers of a file: their delimiter, decimal separator and quotes.
#[derive(Clone, Copy)]
pub struct Style(pub &'static str, pub &'static str, pub &'static str);

pub const TAB: Style = Style("\t", ".", "");
pub const COMMA: Style = Style(",", ".", "");
pub const GERMAN: Style = Style(";", ",", "");
pub const STYLES: [Style; 5] = [TAB, COMMA, GERMAN, Style(" ", ".", ""), Style(",", ".", "\"")];

impl Style {
    fn number(self, value: f64) -> String {
        let text = format!("{value}").replace('.', self.1);
        format!("{}{text}{}", self.2, self.2)
    }

    pub fn line(self, values: impl IntoIterator<Item = f64>) -> String {
        let fields: Vec<_> = values.into_iter().map(|value| self.number(value)).collect();
        fields.join(self.0) + "\n"
    }

    /// The map with each height changed.
    pub fn matrix(self, of: impl Fn(f64) -> f64) -> String {
        (0..ROWS).map(|i| self.line((0..COLUMNS).map(|j| of(z(i, j))))).collect()
    }
}

pub fn plain() -> String {
    TAB.matrix(|z| z)
}

/// The header of Gwyddion in a language.
pub fn gwyddion([channel, width, height, unit]: [&str; 4], value: &str) -> String {
    format!("# {channel} Topo\n# {width} 6.00 µm\n# {height} 4.50 µm\n# {unit} {value}\n")
}

pub const ENGLISH: [&str; 4] = ["Channel:", "Width:", "Height:", "Value units:"];

pub fn options(text: &str) -> ReadOptions {
    let mut options = ReadOptions { max_missing: Some(0.5), ..ReadOptions::default() };
    for (key, value) in text.split_whitespace().map(|pair| pair.split_once('=').unwrap()) {
        match key {
            "unit" => options.unit = Some(value.parse().unwrap()),
            "pixel" => options.pixel_size = Some([value.parse().unwrap(); 2]),
            "units" => {
                options.units = Some(value.split(',').map(|unit| unit.parse().unwrap()).collect());
            }
            "columns" => options.columns = Some(value.into()),
            "skip" => options.skip_lines = value.parse().unwrap(),
            "missing" => options.missing = Some(value.parse().unwrap()),
            "factor" => options.factor = Some(value.parse().unwrap()),
            "channel" => options.channel = Some(value.into()),
            // A blank would part the options.
            "delimiter" => options.delimiter = value.chars().next().or(Some(' ')),
            _ => panic!("{key}"),
        }
    }
    options
}

/// Whether a surface is the map or, of a profile, its first row.
pub fn check(name: &str, surface: &Topography) {
    let rows = if surface.is_profile() { 1 } else { ROWS };
    assert_eq!((surface.columns(), surface.rows()), (COLUMNS, rows), "{name}");
    for (at, found) in surface.heights().iter().enumerate() {
        let wanted = 1e-9 * z(at / COLUMNS, at % COLUMNS);
        assert!(
            found.is_nan() || (found - wanted).abs() < 1e-12,
            "{name}: {at} {found:e} {wanted:e}"
        );
    }
    for found in surface.pixel_size() {
        assert!((found / (1e-6 * STEP) - 1.0).abs() < 1e-9, "{name}: {found:e}");
    }
}

/// A style of texts.txt by its name.
fn style(name: &str) -> Style {
    match name {
        "tab" => TAB,
        "comma" => COMMA,
        "german" => GERMAN,
        "space" => Style(" ", ".", ""),
        "space-german" => Style(" ", ",", ""),
        "quoted" => Style(",", ".", "\""),
        "quoted;" => Style(";", ".", "\""),
        "quoted-german" => Style(";", ",", "\""),
        "quoted-commas" => Style(",", ",", "\""),
        "both" => Style(", ", ",", ""),
        "comma-blank" => Style(", ", ".", ""),
        "quoted-both" => Style(", ", ",", "\""),
        "bar" => Style("|", ".", ""),
        "dots" => Style(".", ".", ""),
        other => panic!("{other}"),
    }
}

/// A term such as `10000*y+x` or `z/1000` in a row and a column: x, y \[um\] and z \[nm\].
fn value(term: &str, row: usize, column: usize) -> f64 {
    let of = |name: &str| match name {
        "x" => STEP * column as f64,
        "y" => STEP * row as f64,
        "z" => z(row, column),
        "z1" => z(row + 1, column),
        "z2" => z(row + 2, column),
        "grey" => (100.0 + z(row, column) / 3.0).round(),
        number => number.parse().unwrap(),
    };
    let part = |part: &str| match (part.split_once('*'), part.split_once('/')) {
        (Some((a, b)), _) => of(a) * of(b),
        (_, Some((a, b))) => of(a) / of(b),
        _ => of(part),
    };
    term.split('+').map(part).sum()
}

/// What a part in braces stands for.
fn expanded(part: &str) -> String {
    let words: Vec<&str> = part.split(' ').collect();
    let [kind, second, ref more @ ..] = words[..] else { panic!("{part}") };
    if kind == "gwy" {
        return gwyddion(ENGLISH, second);
    }
    let (style, columns) = (style(second), more[0].split(','));
    let line = |i: usize, j: usize| style.line(columns.clone().map(|term| value(term, i, j)));
    let row = |i: usize| (0..COLUMNS).map(move |j| value(more[0], i, j));
    let broken = |i: usize, width: &str| {
        let row: Vec<f64> = row(i).collect();
        let lines = row.chunks(width.parse().unwrap()).map(|part| style.line(part.to_vec()));
        lines.collect::<String>() + "\n"
    };
    match (kind, more.get(1)) {
        ("points", _) => (0..ROWS)
            .flat_map(|i| (0..COLUMNS).map(move |j| (i, j)))
            .map(|(i, j)| line(i, j))
            .collect(),
        ("profile", _) => (0..COLUMNS).map(|j| line(0, j)).collect(),
        (_, None) => (0..ROWS).map(|i| style.line(row(i))).collect(),
        (_, Some(&"up")) => (0..ROWS).rev().map(|i| style.line(row(i))).collect(),
        // Lines of a file are columns of the scan.
        (_, Some(&"turned")) => {
            (0..COLUMNS).map(|j| style.line((0..ROWS).map(|i| value(more[0], i, j)))).collect()
        }
        (_, Some(width)) => (0..ROWS).map(|i| broken(i, width)).collect(),
    }
}

/// The lines of a section of texts.txt.
fn lines(section: &str) -> Vec<&'static str> {
    let own = |text: &'static str| text.strip_prefix(section)?.strip_prefix('\n');
    let text = include_str!("texts.txt").split("\n\n# ").find_map(own);
    text.unwrap().lines().filter(|line| line.contains("=>")).collect()
}

/// The cases of a section of texts.txt.
fn listed(section: &str) -> Vec<(String, &'static str, &'static str)> {
    let parts = lines("parts");
    let case = |line: &'static str| {
        let [given, expected, text] = line.splitn(3, "=>").collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let mut text = text.trim_start().to_owned();
        for (name, part) in parts.iter().filter_map(|line| line.split_once(" => ")) {
            text = text.replace(&format!("{{{name}}}"), part);
        }
        text = text.replace("\\n", "\n").replace("\\t", "\t");
        while let Some((before, (part, after))) =
            text.split_once('{').and_then(|(before, rest)| Some((before, rest.split_once('}')?)))
        {
            text = format!("{before}{}{after}", expanded(part));
        }
        (text, given.trim(), expected.trim())
    };
    lines(section).into_iter().map(case).collect()
}

/// Cases of a text, options, and what is expected: nothing where it is the map, an option that is
/// requested, or a part of the message.
pub fn cases<'a>(cases: impl IntoIterator<Item = (String, &'a str, &'a str)>) {
    for (k, (text, given, expected)) in cases.into_iter().enumerate() {
        let units = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        let utf16 = units.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let latin: Option<Vec<u8>> =
            text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
        for bytes in [text.clone().into_bytes(), utf16].into_iter().chain(latin) {
            let name =
                format!("case {k}, {given:?}, {:?}", text.chars().take(90).collect::<String>());
            match read_bytes("a.txt", &bytes, &options(given)) {
                Ok(surface) if expected.is_empty() => check(&name, &surface),
                Ok(_) => panic!("{name}: was read, {expected} was expected"),
                Err(TopographyError::Undecided { option, .. }) if option == expected => {}
                Err(error) => {
                    let message = error.to_string();
                    assert!(
                        !expected.is_empty() && message.contains(expected),
                        "{name}: {message}"
                    );
                }
            }
        }
    }
}

#[test]
fn gwyddion_in_ten_languages() {
    let languages = lines("languages").into_iter().map(|line| line.split("=>").map(str::trim));
    let languages: Vec<[&str; 4]> =
        languages.map(|words| words.collect::<Vec<_>>().try_into().unwrap()).collect();
    assert_eq!(languages.len(), 10);
    for (unit, expected) in [("nm", ""), ("deg", "line 4")] {
        let text = |language: &[&str; 4]| (gwyddion(*language, unit) + &plain(), "", expected);
        cases(languages.iter().map(text));
    }
}

#[test]
fn listed_texts_are_read_or_refused() {
    for section in [
        "headers of instruments",
        "factors of headers",
        "a second table is a second image",
        "commas between and within numbers",
        "lengths of a header agree or are refused",
        "columns that are no heights",
        "columns are named and chosen",
        "several profiles beside one x",
        "counts and lengths above a profile",
    ] {
        cases(listed(section));
    }
}

#[test]
fn missing_points_have_the_code_of_the_header() {
    let coded = |head: &str, code: f64| -> String {
        let row = |i: usize| {
            Style(" ", ".", "")
                .line((0..COLUMNS).map(|j| if (i + j).is_multiple_of(7) { code } else { z(i, j) }))
        };
        head.to_owned() + &(0..ROWS).map(row).collect::<String>()
    };
    let grid = "nrows 18\nncols 24\ncellsize 0.25\n";
    for (text, code, given) in [
        (coded(&format!("{grid}NODATA_value -9999\n"), -9999.0), -9999.0, "units=um,nm"),
        (coded("DSAA\n24 18\n0 5.75\n0 4.25\n-200 200\n", 1.70141e38), 1.7e38, "units=um,nm"),
        (coded("# Width: 6 um\n# Height: 4.5 um\n# Unit: nm\n# missing value = 0\n", 0.0), 0.0, ""),
        (coded("# Width: 6 um\n# Height: 4.5 um\n# Unit: nm\n", -32768.0), 0.0, "missing=-32768"),
    ] {
        let surface = read_bytes("a.txt", text.as_bytes(), &options(given)).unwrap();
        check(given, &surface);
        let missing = surface.heights().iter().filter(|z| z.is_nan()).count();
        assert_eq!(
            missing,
            (0..ROWS * COLUMNS)
                .filter(|at| (at / COLUMNS + at % COLUMNS).is_multiple_of(7))
                .count(),
            "{code}"
        );
    }
}

#[test]
fn a_factor_of_a_header_is_noted() {
    let gwy = "# Width: 6 um\n# Height: 4.5 um\n";
    let notes = |line: &str, of: f64| -> Vec<f64> {
        let text = format!("{gwy}# {line}\n{}", TAB.matrix(|z| of * z));
        let notes = read_bytes("a.txt", text.as_bytes(), &options("unit=nm")).unwrap();
        notes
            .notes()
            .iter()
            .filter(|note| note.code.name() == "factor")
            .map(|note| note.value)
            .collect()
    };
    assert_eq!(notes("Multiplier: 0.5", 2.0), [0.5]);
    assert!(notes("Multiplier: 1", 1.0).is_empty() && notes("Unit: nm", 1.0).is_empty());
}

#[test]
fn every_line_of_a_header_is_understood_or_listed() {
    let text = "# File Format = ASCII\n# x-length = 6000\n# temperature: 21.5 C\n# z-unit = nm\n# operator: me\n1 2 3 4\n5 6 7 9\n# y-length = 30\n";
    let found = read_header("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap();
    let meanings: Vec<_> = found.iter().map(|line| (line.line, line.meaning)).collect();
    let wanted = [
        (1, Some("unit xy")),
        (2, Some("width")),
        (3, None),
        (4, Some("unit")),
        (5, None),
        (8, Some("height")),
    ];
    assert_eq!(meanings, wanted);
    assert!(
        found[2].text.contains("21.5")
            && read_header("a.txt", b"no", &ReadOptions::default()).is_err()
    );
    assert!(options("units=um,nm").units.is_some_and(|units| units[1] == "nm".parse().unwrap()));
}
