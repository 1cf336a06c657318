//! A scan at a glance: its map, and its curves from the text of a csv with the columns
//! `panel,curve,x,y`.

use crate::canvas::{Type, picture};
use crate::error::PlotError;
use crate::figure::{Axis, Figure, Mark, Panel, Scale};
use crate::layout::Layout;
use crate::map::{Map, Placed, check};
use crate::panel::Plot;
use crate::series::{Table, check_all_drawn};
use crate::size::{LABEL, WIDTH};
use crate::style::{BLACK, Curve};
use crate::text::{CAPITAL, number};

/// The picture of a scan. Lengths are in m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScanPicture {
    /// A line above.
    pub title: String,
    /// Paragraphs below; each is wrapped.
    pub caption: Vec<String>,
    /// Heights, row by row; NaN for missing points.
    pub heights: Vec<f64>,
    /// Heights in a row.
    pub columns: usize,
    /// Length of the rows and of the columns.
    pub size: [f64; 2],
    /// Wavelengths marked in the radial spectrum.
    pub marks: Vec<f64>,
    /// The name of the law in the radial spectrum, where the csv has one.
    pub law: String,
}

/// Place of the map beside the left edge of its panel, and room for its bar of colours.
const OUT: f64 = 44.0;
const BAR: f64 = 92.0;
/// Colours end at so many standard deviations.
const SPREAD: f64 = 4.0;
/// Units of lengths.
const UNITS: [(f64, &str); 4] = [(1e-9, "nm"), (1e-6, "µm"), (1e-3, "mm"), (1.0, "m")];

/// Draws a scan; returns the text of an svg.
///
/// # Errors
/// Those of [`draw`](crate::draw) and [`draw_map`](crate::draw_map).
pub fn draw_scan(scan: &ScanPicture, csv: &str) -> Result<String, PlotError> {
    let table = Table::read(csv)?;
    let there = || scan.heights.iter().copied().filter(|z| !z.is_nan());
    let n = there().count().max(1) as f64;
    let mean = there().sum::<f64>() / n;
    let wide = SPREAD * (there().map(|z| (z - mean).powi(2)).sum::<f64>() / n).sqrt();
    let lowest = there().fold(f64::INFINITY, f64::min);
    let highest = there().fold(f64::NEG_INFINITY, f64::max);
    // Spikes would leave one colour for all else.
    let (low, high) = (lowest.max(mean - wide), highest.min(mean + wide));
    let (height, of_height) = unit(high - low);
    let (length, of_length) = unit(scan.size[0].max(scan.size[1]) / 10.0);
    let map = Map {
        values: scan.heights.iter().map(|z| z / height).collect(),
        columns: scan.columns,
        size: scan.size.map(|side| side / length),
        unit: of_length.into(),
        label: format!("height ({of_height})"),
        top: high / height,
        bottom: Some(low / height),
        white: match scan.heights.iter().any(|z| z.is_nan()) {
            true => "blank: missing".into(),
            false => String::new(),
        },
        ..Map::default()
    };
    check(&map)?;
    let mut figure = figure(scan, csv, height, of_height);
    if low > lowest || high < highest {
        let text =
            format!("Colours of the map end at {SPREAD} standard deviations of the heights.");
        figure.caption.push(text);
    }
    let plots = (0..figure.panels.len())
        .map(|index| Plot::new(&figure, index, &table))
        .collect::<Result<Vec<Plot>, _>>()?;
    check_all_drawn(&figure, &table)?;
    let layout = Layout::new(&figure, &plots);
    picture(&figure.title, (WIDTH, layout.height), |canvas| {
        layout.draw(canvas);
        let mut each = plots.iter().zip(&layout.frames);
        if let Some((plot, frame)) = each.next() {
            let room = [frame.width() + OUT - BAR, frame.height()];
            Placed::new(&map, (frame.left - OUT, frame.top), room).draw(canvas)?;
            let top = frame.top - plot.above() + CAPITAL * LABEL;
            let face = Type { bold: true, ..Type::new(LABEL, BLACK, "start") };
            canvas.text("(a) map", (frame.left - OUT, top), face);
        }
        each.try_for_each(|(plot, frame)| plot.draw(canvas, frame))
    })
}

/// The panels of the csv, after one that keeps the place of the map.
fn figure(scan: &ScanPicture, csv: &str, height: f64, of_height: &str) -> Figure {
    let has = |start: &str| csv.lines().any(|line| line.starts_with(start));
    let curves = |panel: &str, all: &[(usize, &str, &str)]| -> Vec<Curve> {
        let there = all.iter().filter(|(_, key, _)| has(&format!("{panel},{key},")));
        there.map(|(look, key, label)| Curve::new(*look, key, label)).collect()
    };
    let lines = [(2, "rows", "along rows"), (3, "columns", "along columns")];
    let micro = |label: &str| Axis::new("x", label).times(1e6).log();
    let wave_number = || Axis::new("x", "wave number (rad/µm)").times(1e-6).log();
    let x = Axis::new("x", &format!("height ({of_height})")).times(1.0 / height);
    let panels = [
        (
            "histogram",
            "density of heights",
            x,
            Axis::new("y", "density (1/m)").log(),
            vec![(0, "heights", "heights"), (1, "gaussian", "Gaussian of the same Sq")],
        ),
        (
            "radial",
            "radial spectrum",
            wave_number(),
            Axis::new("y", "C (m⁴)").log(),
            vec![(0, "radial", "radial spectrum"), (4, "law", &*scan.law)],
        ),
        (
            "axial",
            "spectra of profiles",
            wave_number(),
            Axis::new("y", "C (m³)").log(),
            lines.to_vec(),
        ),
        (
            "slope",
            "slope against scale",
            micro("distance (µm)"),
            Axis::new("y", "rms slope"),
            lines.to_vec(),
        ),
        (
            "curvature",
            "curvature against scale",
            micro("distance (µm)"),
            Axis::new("y", "rms curvature (1/m)"),
            lines.to_vec(),
        ),
    ];
    let mut place =
        Panel::new(Axis::new("x", "").range(0.0, 1.0), Axis::new("y", "").range(0.0, 1.0));
    place.only = Some(("panel".into(), String::new()));
    // Underscores of file names lower no letters.
    let title = scan.title.replace('_', "_\u{200b}");
    let mut figure = Figure::new(&title, &[], vec![place]);
    figure.caption.clone_from(&scan.caption);
    figure.columns = 2;
    for (key, title, x, mut y, all) in panels {
        if !has(&format!("{key},")) {
            continue;
        }
        if matches!(key, "slope" | "curvature") {
            y.scale = Scale::Log;
        }
        let mut panel = Panel::new(x, y);
        panel.title = title.into();
        panel.only = Some(("panel".into(), key.into()));
        panel.curves = curves(key, &all);
        if matches!(key, "slope" | "curvature" | "histogram") {
            panel.curves.iter_mut().for_each(|curve| curve.every_point = key != "histogram");
        }
        if key == "radial" {
            let mark = |length: &f64| {
                let (of, name) = unit(*length);
                let text = format!("{} {name}", three(length / of));
                Mark::new(std::f64::consts::TAU / length, &text)
            };
            panel.verticals = scan.marks.iter().map(mark).collect();
        }
        figure.panels.push(panel);
    }
    figure
}

/// A number with three digits.
fn three(value: f64) -> String {
    number(format!("{value:.2e}").parse().unwrap_or(value))
}

/// The unit in which a length is at least 1.
fn unit(length: f64) -> (f64, &'static str) {
    UNITS.into_iter().rev().find(|(unit, _)| length >= *unit).unwrap_or(UNITS[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "panel,curve,x,y\nhistogram,heights,-1e-7,1e6\nhistogram,heights,1e-7,2e6\n\
        histogram,gaussian,-1e-7,1e6\nhistogram,gaussian,1e-7,1e5\nradial,radial,1e5,1e-20\n\
        radial,radial,4e6,1e-26\nradial,law,1e5,1e-20\nradial,law,4e6,1e-26\naxial,rows,1e5,1e-15\n\
        axial,rows,4e6,1e-19\nslope,rows,1e-6,0.1\nslope,rows,2e-6,0.05\ncurvature,rows,1e-6,1e5\n\
        curvature,rows,2e-6,1e4\n";

    fn scan() -> ScanPicture {
        ScanPicture {
            title: "a_1 scan".into(),
            caption: vec!["Sq 0.1 µm".into()],
            heights: vec![-1e-7, 0.0, 1e-7, f64::NAN, 2e-7, 0.0],
            columns: 3,
            size: [60e-6, 40e-6],
            marks: vec![12.34e-6],
            law: "power law, H = 0.80".into(),
        }
    }

    #[test]
    fn map_panels_marks_and_legend_are_drawn() {
        let svg = draw_scan(&scan(), CSV).unwrap();
        for word in [
            "a_\u{200b}1 scan",
            "(a) map",
            ">20 µm<",
            "height (nm)",
            "blank: missing",
            "rad/µm",
            "power law, H = 0.80",
            ">12.3 µm<",
            "along rows",
            "rms curvature",
            "Sq 0.1 µm",
        ] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(svg.contains("<image ") && !svg.contains("NaN") && !svg.contains("inf"));
        assert!(svg == draw_scan(&scan(), CSV).unwrap());
    }

    #[test]
    fn panels_without_rows_are_left_out_and_flat_maps_refused() {
        let few: String =
            CSV.lines().filter(|l| !l.starts_with("radial")).map(|l| format!("{l}\n")).collect();
        assert!(!draw_scan(&scan(), &few).unwrap().contains("radial"));
        let spike: Vec<f64> =
            (0..300).map(|k| if k == 7 { 5e-6 } else { 1e-8 * f64::from(k % 5) }).collect();
        let spiked = ScanPicture { heights: spike, columns: 30, ..scan() };
        assert!(draw_scan(&spiked, CSV).unwrap().contains("end at 4 standard deviations"));
        let flat = ScanPicture { heights: vec![0.0; 6], ..scan() };
        assert!(draw_scan(&flat, CSV).is_err());
    }
}
