//! The scan of a scene: its pictures and its statistics.

use asperity_plot::{caption_of_surface, draw_material_ratio, draw_surface};
use asperity_scene::SceneFile;
use asperity_topography::{Glance, Level, Reported};
use serde_json::{Value, json};

use crate::refusal::Refusal;
use crate::shown::{number, shown};

/// The statistics and functional parameters of the scan of a scene, its pictures and a caption.
pub(crate) fn report(file: &SceneFile) -> Result<Value, Refusal> {
    let (Some(scan), Some(measured)) = (file.scan(), &file.measured) else {
        return Err(Refusal::new("the scene has no scan"));
    };
    let reported =
        |of: Reported| Some(number(of.name, shown(of.value?, of.unit), of.value?, &of.meaning));
    let all = measured.statistics.numbers().into_iter().chain(scan.functional()?);
    let numbers: Value = all.filter_map(reported).collect();
    let glance = Glance::new(scan, Level::usual(scan.is_periodic()), [None; 2], scan)?;
    let (ratio, profile) = (scan.material_ratio()?, scan.is_profile());
    Ok(json!({
        "numbers": numbers,
        "svg": draw_surface(scan, &glance, None)?,
        "curve": draw_material_ratio(&ratio, profile, "material ratio curve")?,
        "caption": caption_of_surface(scan, &glance),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_scene::{HandedFiles, parse_handed};

    #[test]
    fn a_scan_has_pictures_caption_and_statistics() {
        let keys = crate::random::example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = asperity_scene::template();
        let text = crate::surface_keys::with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let found = report(&file).unwrap();
        assert!(found["svg"].as_str().unwrap().starts_with("<svg"));
        assert!(found["curve"].as_str().unwrap().contains("line of the core"));
        let names = found["numbers"].as_array().unwrap().iter().map(|number| &number["name"]);
        assert!(names.clone().any(|name| name == "svk") && names.clone().any(|name| name == "vmc"));
        assert!(found["caption"][0].as_str().unwrap().contains("64 x 64 points"));
        assert_eq!(
            (&found["numbers"][0]["name"], &found["numbers"][0]["shown"]),
            (&json!("sq"), &json!("500 nm"))
        );
        let plain = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        assert!(report(&plain.unwrap()).is_err());
    }
}
