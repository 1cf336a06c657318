//! The scan of a scene: its picture, its statistics, and its slopes at several distances.

use asperity_plot::{caption_of_surface, draw_material_ratio, draw_surface};
use asperity_scene::SceneFile;
use asperity_topography::{AtDistance, Glance, Level, Reported, Topography};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::refusal::Refusal;
use crate::shown::{number, shown};

/// Slopes and curvatures, each row at one distance of points.
const SCALES: [&str; 5] =
    ["distance", "slope, rows", "slope, columns", "curvature, rows", "curvature, columns"];

/// The shape of the heights of a scan.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Shape {
    columns: usize,
    pixel_size: [f64; 2],
    periodic: bool,
}

/// The statistics and functional parameters of the scan of a scene, and the shape of its heights.
pub(crate) fn numbers(file: &SceneFile) -> Result<Value, Refusal> {
    let (Some(scan), Some(measured)) = (file.scan(), &file.measured) else {
        return Err(Refusal::new("the scene has no scan"));
    };
    let reported =
        |of: Reported| Some(number(of.name, shown(of.value?, of.unit), of.value?, &of.meaning));
    let all = measured.statistics.numbers().into_iter().chain(scan.functional()?);
    let numbers: Value = all.filter_map(reported).collect();
    let (columns, pixel_size) = (scan.columns(), scan.pixel_size());
    let shape = Shape { columns, pixel_size, periodic: scan.is_periodic() };
    Ok(json!({ "numbers": numbers, "shape": shape }))
}

/// The pictures of heights \[m\] and of their material ratio curve, a caption, and slopes at
/// several distances: as the scan of a scene has them, without reading its file again.
pub(crate) fn report(heights: Vec<f64>, shape: Shape) -> Result<Value, Refusal> {
    let Shape { columns, pixel_size, periodic } = shape;
    let scan = Topography::new(heights, columns, pixel_size)?.with_periodic(periodic);
    let glance = Glance::new(&scan, Level::usual(periodic), [None; 2], &scan)?;
    let text = |value: Option<f64>, unit| value.map_or("–".into(), |value| shown(value, unit));
    let row = |at: &AtDistance| {
        [
            shown(at.step as f64 * pixel_size[0], "m"),
            text(at.slope_rows, ""),
            text(at.slope_columns, ""),
            text(at.curvature_rows, "1/m"),
            text(at.curvature_columns, "1/m"),
        ]
    };
    let rows: Vec<_> = scan.scale_dependence().iter().map(row).collect();
    let (ratio, profile) = (scan.material_ratio()?, scan.is_profile());
    let curve = draw_material_ratio(&ratio, profile, "material ratio curve")?;
    Ok(json!({
        "svg": draw_surface(&scan, &glance, None)?,
        "curve": curve,
        "caption": caption_of_surface(&scan, &glance),
        "scales": { "head": SCALES, "rows": rows },
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_scene::{HandedFiles, parse_handed};

    #[test]
    fn a_scan_has_picture_caption_statistics_and_scales() {
        let keys = crate::random::example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = asperity_scene::template();
        let text = crate::surface_keys::with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let about = numbers(&file).unwrap();
        let shape = serde_json::from_value(about["shape"].clone()).unwrap();
        let found = report(file.scan().unwrap().heights().to_vec(), shape).unwrap();
        assert!(found["svg"].as_str().unwrap().starts_with("<svg"));
        assert!(found["curve"].as_str().unwrap().contains("line of the core"));
        let names = about["numbers"].as_array().unwrap().iter().map(|number| &number["name"]);
        assert!(names.clone().any(|name| name == "svk") && names.clone().any(|name| name == "vmc"));
        assert!(found["caption"][0].as_str().unwrap().contains("64 x 64 points"));
        assert_eq!(
            (&about["numbers"][0]["name"], &about["numbers"][0]["shown"]),
            (&json!("sq"), &json!("500 nm"))
        );
        assert_eq!(found["scales"]["rows"][0][0], "1 µm");
        let plain = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        assert!(numbers(&plain.unwrap()).is_err());
    }
}
