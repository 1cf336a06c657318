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

    /// Lines of x, y [um] and z [nm], by this function.
    pub fn points(self, of: impl Fn(f64, f64, f64) -> Vec<f64>) -> String {
        let point = |at: usize| {
            let (i, j) = (at / COLUMNS, at % COLUMNS);
            self.line(of(STEP * j as f64, STEP * i as f64, z(i, j)))
        };
        (0..ROWS * COLUMNS).map(point).collect()
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
pub const LANGUAGES: [[&str; 4]; 10] = [
    ENGLISH,
    ["Kanál:", "Šířka:", "Výška:", "Jednotky hodnot:"],
    ["Kanal:", "Breite:", "Höhe:", "Einheiten:"],
    ["Canal:", "Anchura:", "Altura:", "Unidades de valor:"],
    ["Canal\u{a0}:", "Largeur\u{a0}:", "Hauteur :", "Unités :"],
    ["Canale:", "Larghezza:", "Altezza:", "unità valore:"],
    ["チャネル：", "幅:", "高さ：", "値の単位:"],
    ["채널:", "폭:", "높이:", "값 단위:"],
    ["Canal:", "Largura:", "Altura:", "Unidades de valor:"],
    ["Канал:", "Ширина:", "Высота:", "Единицы измерения:"],
];

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
    cases(LANGUAGES.map(|language| (gwyddion(language, "nm") + &plain(), "", "")));
    cases(LANGUAGES.map(|language| (gwyddion(language, "deg") + &plain(), "", "line 4")));
}

#[test]
fn headers_of_instruments() {
    let um = TAB.matrix(|z| z / 1e3);
    let spip = "# File Format = ASCII\n# x-pixels = 24\n# y-pixels = 18\n# x-length = 6000\n# y-length = 4500\n";
    let keyence = |[date, step, x, y, unit, name]: [&str; 6], style: Style| {
        let [s, q] = [style.0, "\""];
        format!(
            "{q}{date}{q}{s}{q}3/21/2025 11:43:55 AM{q}\n{q}{step}{q}{s}{q}250{q}{s}{q}nm{q}\n{q}{x}{q}{s}{q}24{q}\n\
             {q}{y}{q}{s}{q}18{q}\n{q}Minimum value{q}{s}{q}-1{q}\n{q}{unit}{q}{s}{q}um{q}\n{q}{q}\n{q}{name}{q}\n{}",
            style.matrix(|z| z / 1e3)
        )
    };
    let english = ["Measured date", "XY Calibration", "Horizontal", "Vertical", "Unit", "Height"];
    let german = ["Gemessenes Datum", "XY-Justierung", "Horizont.", "Vertikal", "Einheit", "Höhe"];
    let quoted = Style(",", ".", "\"");
    let nova = |rest: &str| {
        format!(
            "File Format = ASCII\nCreated by Nova 1.0\nNX = 24\nNY = 18\nScale X = 0.25\nScale Y = 0.25\nBias X = 0\nUnit X = um\nUnit Y = um\nUnit Data = nm\n{rest}\nStart of Data :\n"
        )
    };
    // Lines of a file are columns of the scan.
    let wyko = |flag: usize, of: &dyn Fn(f64) -> f64| -> String {
        let head = format!(
            "Wyko ASCII Data File Format 0\t{flag}\t1\nX Size\t24\nY Size\t18\nBlock Name\tType\tLength\tValue\nPixel_size\t7\t4\t0.00025\nWavelength\t7\t4\t500\nMult\t7\t4\t1000\nRAW_DATA\t3\t48\t\n"
        );
        head + &(0..COLUMNS).map(|j| TAB.line((0..ROWS).map(|i| of(z(i, j))))).collect::<String>()
    };
    let esri = |end: &str| -> String {
        let head = format!("ncols 24\nnrows 18\nxllcorner 0\nyllcorner 0\ncellsize 250\n{end}");
        head + &(0..ROWS)
            .rev()
            .map(|i| Style(" ", ".", "").line((0..COLUMNS).map(|j| z(i, j))))
            .collect::<String>()
    };
    let surfer = |width: usize| -> String {
        let values: Vec<_> =
            (0..ROWS).map(|i| (0..COLUMNS).map(|j| z(i, j)).collect::<Vec<_>>()).collect();
        let row = |row: &Vec<f64>| {
            row.chunks(width)
                .map(|part| Style(" ", ".", "").line(part.iter().copied()))
                .collect::<String>()
                + "\n"
        };
        format!(
            "DSAA\n24 18\n0 5750\n0 4250\n-200 200\n{}",
            values.iter().map(row).collect::<String>()
        )
    };
    cases([
        (format!("{spip}# Bit2nm = 0.5\n# Start of Data:\n{}", TAB.matrix(|z| 2.0 * z)), "", ""),
        (format!("{spip}# z-unit = um\n# voidpixels = 0\n# Start of Data:\n{um}"), "", ""),
        (format!("{spip}{}", plain()), "", "give unit"),
        (format!("{spip}{}", plain()), "unit=nm", ""),
        (
            format!("# File Format = ASCII\n# x-pixels = 18\n# y-pixels = 24\n{}", plain()),
            "unit=nm pixel=0.25um",
            "18 x 24 points",
        ),
        (
            format!(
                "# Daisy frame view snapshot\n# 2009-07-14T10:12:34\n# x-pixels: 24\n# y-pixels: 18\n# x-length: 6\n# y-length: 4.5\n# x-offset: 0\n# x-unit: um\n# y-unit: um\n# z-unit: nm\n# scanspeed: 2\n# display: Topography\n# Start of Data:\n{}",
                plain()
            ),
            "",
            "",
        ),
        (
            nova("Scale Data = 0.5\nBias Data = 0\nDataScaleNeeded = Yes")
                + &TAB.matrix(|z| 2.0 * z),
            "",
            "",
        ),
        (nova("Scale Data = 0.5\nDataScaleNeeded = No") + &plain(), "", ""),
        (keyence(english, quoted), "", ""),
        (keyence(english, Style(";", ".", "\"")), "", ""),
        (keyence(german, Style(";", ",", "\"")), "", ""),
        (keyence(german, Style(",", ",", "\"")), "", ""),
        (keyence(["측정 일시", "XY캘리브레이션", "가로", "세로", "단위", "높이"], quoted), "", ""),
        (keyence(["日期", "XY校准", "水平", "垂直", "单位", "高度"], quoted), "", ""),
        (wyko(0, &|z| 2.0 * z), "", ""),
        (wyko(1, &|z| z), "", ""),
        (esri(""), "unit=nm", ""),
        (esri("NODATA_value -9999\n"), "units=nm,nm", ""),
        (esri(""), "", "give unit"),
        (surfer(24), "unit=nm", ""),
        (surfer(10), "unit=nm", ""),
        (surfer(8), "units=nm,nm", ""),
        (
            format!(
                "pixel size=0.25 µm\ndata unit=rad\nheight conversion factor (-> m)=1e-9\n{}",
                plain()
            ),
            "",
            "",
        ),
        (format!("Pixel_Size (nm) = 250\nUnit: nm\n{}", plain()), "", ""),
        (format!("Scan size: 6 x 4.5 um\nz unit: nm\n{}", plain()), "", ""),
        (format!("Scan size,6,4.5,um\nz unit,nm\n{}", COMMA.matrix(|z| z)), "", ""),
        (
            format!(
                "Width: 24 px\nHeight: 18 px\ndx = 250 nm\ndy = 0.25 um\nunits = nm\n{}",
                plain()
            ),
            "",
            "",
        ),
        (format!("Width = 6\nHeight = 4.5\nunits = nm\n{}", plain()), "", "units"),
        (format!("Width = 6\nHeight = 4.5\n{}", plain()), "units=um,nm", ""),
        (format!("Width = 24\nHeight = 18\nunits = nm\n{}", plain()), "", "give pixel_size"),
        (format!("Scan size: 6 um\nunits = nm\n{}", plain()), "", "give pixel_size"),
        (format!("File format: 3\npixel size: 0.25 um\nunit: nm\n{}", plain()), "", ""),
    ]);
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
fn factors_of_headers_have_many_names() {
    let gwy = "# Width: 6 um\n# Height: 4.5 um\n";
    let twice = |line: &str| format!("{gwy}# {line}\n{}", TAB.matrix(|z| 2.0 * z));
    cases(
        [
            "Bit2nm = 0.5",
            "Scale Data = 0.5 nm",
            "Multiplier: 0.5\n# Unit: nm",
            "z-scale = 0.5\n# z-unit = nm",
            "Z scale factor (nm) = 0.5",
            "height factor (-> nm): 5e-1",
            "data scale=0.5\n# data unit=nm",
            "Faktor: 0,5 nm",
            "Umrechnungsfaktor [nm]: 0,5",
            "Facteur d'échelle : 0,5 nm",
            "conversion factor\t5e-10\tm",
            "value factor; 0.5; nm",
        ]
        .map(|line| (twice(line), "", "")),
    );
    cases([
        (twice("Multiplier: 0.5"), "", "line 3"),
        (twice("Multiplier: 0.5"), "unit=nm", ""),
        (twice("Multiplier: many"), "unit=nm", "line 3"),
        (twice("Unit: nm"), "factor=0.5", ""),
        (twice("Bit2nm = 0.5"), "factor=0.5", ""),
        (twice("Bit2nm = 0.5"), "factor=2", "factor is 2"),
        (twice("Bit2nm = 0.5"), "factor=0", "factor is 0"),
        (format!("{gwy}# Magnification factor = 50\n{}", plain()), "unit=nm", ""),
    ]);
    let notes = |line: &str, of: f64| -> Vec<f64> {
        let text = format!("{gwy}# {line}\n{}", TAB.matrix(|z| of * z));
        let notes = read_bytes("a.txt", text.as_bytes(), &options("unit=nm")).unwrap();
        notes.notes().iter().filter(|note| note.code == "factor").map(|note| note.value).collect()
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
