//! The scan of a scene: its picture, its statistics, and its slopes at several distances.

use asperity::shortest_digits;
use asperity_inputs::SceneFile;
use asperity_plot::draw_surface;
use asperity_topography::{AtDistance, Glance, Level, Reported, Statistics, Topography};
use serde::Serialize;

use crate::message::NumberShown;
use crate::refusal::Refusal;
use crate::shown::shown;

/// What the page shows of a scan.
#[derive(Debug, Serialize)]
pub(crate) struct ScanReport {
    pub(crate) svg: String,
    pub(crate) caption: Vec<String>,
    pub(crate) numbers: Vec<NumberShown>,
    pub(crate) scales: Scales,
}

/// Slopes and curvatures, each row at one distance of points.
#[derive(Debug, Serialize)]
pub(crate) struct Scales {
    pub(crate) head: [&'static str; 5],
    pub(crate) rows: Vec<[String; 5]>,
}

/// The report of the scan of a scene.
pub(crate) fn report(file: &SceneFile) -> Result<ScanReport, Refusal> {
    let (Some(scan), Some(measured)) = (&file.scan, &file.measured) else {
        return Err(Refusal::new("the scene has no scan"));
    };
    let level = Level::usual(scan.is_periodic());
    let glance = Glance::new(scan, level, [None; 2], scan)?;
    let rows = scan.scale_dependence();
    Ok(ScanReport {
        svg: draw_surface(scan, &glance, None)?,
        caption: scan.caption(&glance),
        numbers: numbers(&measured.statistics),
        scales: Scales {
            head: [
                "distance",
                "slope, rows",
                "slope, columns",
                "curvature, rows",
                "curvature, columns",
            ],
            rows: rows.iter().map(|at| row(scan, at)).collect(),
        },
    })
}

fn row(scan: &Topography, at: &AtDistance) -> [String; 5] {
    let text = |value: Option<f64>, unit| value.map_or("–".into(), |value| shown(value, unit));
    let [dx, _] = scan.pixel_size();
    [
        shown(at.step as f64 * dx, "m"),
        text(at.slope_rows, ""),
        text(at.slope_columns, ""),
        text(at.curvature_rows, "1/m"),
        text(at.curvature_columns, "1/m"),
    ]
}

fn numbers(of: &Statistics) -> Vec<NumberShown> {
    let number = |of: Reported| {
        of.value.map(|value| NumberShown {
            name: of.name.into(),
            digits: shortest_digits(value),
            shown: shown(value, of.unit),
            meaning: of.meaning.into(),
        })
    };
    of.numbers().into_iter().filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_inputs::{HandedFiles, parse_handed};

    #[test]
    fn a_scan_has_picture_caption_statistics_and_scales() {
        let keys = crate::random::example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = asperity_inputs::template();
        let text = crate::surface_keys::with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let found = report(&file).unwrap();
        assert!(found.svg.starts_with("<svg") && found.caption[0].contains("64 x 64 points"));
        assert_eq!(
            (found.numbers[0].name.as_str(), found.numbers[0].shown.as_str()),
            ("sq", "500 nm")
        );
        assert_eq!(found.scales.rows[0][0], "1 µm");
        let plain = asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new("."));
        assert!(report(&plain.unwrap()).is_err());
    }
}
