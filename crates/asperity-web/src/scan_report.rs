//! The scan of a scene: its picture, its statistics, and its slopes at several distances.

use asperity::shortest_digits;
use asperity_inputs::SceneFile;
use asperity_plot::draw_surface;
use asperity_topography::{AtDistance, Glance, Level, Reported};
use serde_json::{Value, json};

use crate::refusal::Refusal;
use crate::shown::shown;

/// Slopes and curvatures, each row at one distance of points.
const SCALES: [&str; 5] =
    ["distance", "slope, rows", "slope, columns", "curvature, rows", "curvature, columns"];

/// The report of the scan of a scene.
pub(crate) fn report(file: &SceneFile) -> Result<Value, Refusal> {
    let (Some(scan), Some(measured)) = (&file.scan, &file.measured) else {
        return Err(Refusal::new("the scene has no scan"));
    };
    let level = Level::usual(scan.is_periodic());
    let glance = Glance::new(scan, level, [None; 2], scan)?;
    let [dx, _] = scan.pixel_size();
    let text = |value: Option<f64>, unit| value.map_or("–".into(), |value| shown(value, unit));
    let row = |at: &AtDistance| {
        [
            shown(at.step as f64 * dx, "m"),
            text(at.slope_rows, ""),
            text(at.slope_columns, ""),
            text(at.curvature_rows, "1/m"),
            text(at.curvature_columns, "1/m"),
        ]
    };
    let number = |of: Reported| {
        let value = of.value?;
        let (digits, shown) = (shortest_digits(value), shown(value, of.unit));
        Some(json!({ "name": of.name, "digits": digits, "shown": shown, "meaning": of.meaning }))
    };
    let numbers = measured.statistics.numbers().into_iter().filter_map(number);
    let rows: Vec<_> = scan.scale_dependence().iter().map(row).collect();
    Ok(json!({
        "svg": draw_surface(scan, &glance, None)?,
        "caption": scan.caption(&glance),
        "numbers": numbers.collect::<Value>(),
        "scales": { "head": SCALES, "rows": rows },
    }))
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
        assert!(found["svg"].as_str().unwrap().starts_with("<svg"));
        assert!(found["caption"][0].as_str().unwrap().contains("64 x 64 points"));
        assert_eq!(
            (&found["numbers"][0]["name"], &found["numbers"][0]["shown"]),
            (&json!("sq"), &json!("500 nm"))
        );
        assert_eq!(found["scales"]["rows"][0][0], "1 µm");
        let plain = asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new("."));
        assert!(report(&plain.unwrap()).is_err());
    }
}
