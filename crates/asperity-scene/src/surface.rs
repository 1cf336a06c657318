//! `[surface]`: exactly one of four ways to say what the asperities are.

use asperity::{Interface, ProfileMoments, Surface};

use crate::SceneError;
use crate::document::Section;

/// The surface of a scene.
#[derive(Debug, Clone)]
pub(crate) struct Described {
    pub(crate) surface: Surface,
    /// Mean of the asperity heights above the mean plane \[m\].
    pub(crate) mean_plane_offset: f64,
    pub(crate) notes: Vec<String>,
}

/// The four ways, each with the keys that tell it from the others.
const WAYS: [(&str, &[&str]); 4] = [
    (
        "asperity_radius, asperity_density and asperity_height_std",
        &["asperity_radius", "asperity_density"],
    ),
    (
        "plasticity_index, roughness_parameter and asperity_height_std",
        &["plasticity_index", "roughness_parameter"],
    ),
    ("m0, m2 and m4", &["m0", "m2", "m4"]),
    ("file or files", &["file", "files"]),
];

const ONE_WAY: &str = "exactly one way to describe the surface: (1) asperity_radius, asperity_density, asperity_height_std; (2) plasticity_index, roughness_parameter, asperity_height_std; (3) m0, m2, m4; (4) file or files";

/// Keys that only measured files have.
const OF_FILES: [&str; 6] = ["unit", "pixel_size", "estimator", "level", "filter", "max_missing"];

/// `measured_std` is the standard deviation of a table of heights, where there is one: it may
/// stand in for an `asperity_height_std` that was not given.
pub(crate) fn surface(
    section: &Section<'_>,
    interface: &Interface,
    measured_std: Option<f64>,
) -> Result<Described, SceneError> {
    let first =
        |way: &(&str, &'static [&'static str])| way.1.iter().copied().find(|k| section.has(k));
    let mut given = WAYS.iter().enumerate().filter_map(|(k, way)| Some((k, first(way)?)));
    let Some((way, key)) = given.next() else { return Err(section.missing("", ONE_WAY)) };
    if let Some((_, other)) = given.next() {
        return Err(section.conflict(key, other, ONE_WAY));
    }
    let of_files = OF_FILES.iter().find(|k| section.has(k)).filter(|_| way != 3);
    if let Some(of_files) = of_files {
        return Err(section.conflict(of_files, key, "a measured file"));
    }
    let std_given = section.has("asperity_height_std");
    if way > 1 && std_given {
        let needed =
            format!("either {} or asperity_height_std, which follows from them,", WAYS[way].0);
        return Err(section.conflict("asperity_height_std", key, &needed));
    }
    let number = |key| {
        section
            .required(key, &format!("with {} go {}", first(&WAYS[way]).unwrap_or(key), WAYS[way].0))
    };
    let std = || match (section.number("asperity_height_std")?, measured_std) {
        (Some(std), _) | (None, Some(std)) => Ok(std),
        (None, None) => number("asperity_height_std"),
    };
    let surface = match way {
        0 => Surface::new(number("asperity_radius")?, number("asperity_density")?, std()?),
        1 => {
            let (index, parameter) = (number("plasticity_index")?, number("roughness_parameter")?);
            Surface::from_plasticity_index(index, parameter, std()?, interface)
                .map_err(section.refused())?
        }
        2 => {
            let moments =
                ProfileMoments { m0: number("m0")?, m2: number("m2")?, m4: number("m4")? };
            Surface::from_moments(&moments).map_err(section.refused())?
        }
        _ => return crate::measured::surface(section),
    };
    surface.check().map_err(section.refused())?;
    Ok(Described { surface, mean_plane_offset: surface.mean_plane_offset(), notes: vec![] })
}
