//! The keys of a scene file, as serde reads them: what is not here is refused.

use std::path::PathBuf;

use asperity::{Body, Datum, Interface};
use asperity_topography::{Estimator, LengthUnit, Level};
use serde::Deserialize;

use crate::{Asperities, ModelOptions};

/// The top of the file and its sections.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SceneKeys {
    pub(crate) nominal_area: f64,
    pub(crate) rigid_counterface: Option<bool>,
    pub(crate) work_of_adhesion: Option<f64>,
    /// Codes of warnings and notes that are not shown.
    #[serde(default)]
    pub(crate) accept: Vec<String>,
    pub(crate) interface: Option<Interface>,
    #[serde(default)]
    pub(crate) body: Vec<Body>,
    pub(crate) surface: SurfaceKeys,
    #[serde(default)]
    pub(crate) options: ModelOptions,
}

/// `[surface]`.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields, expecting = "a table, [surface],")]
pub(crate) struct SurfaceKeys {
    pub(crate) asperity_radius: Option<f64>,
    pub(crate) asperity_density: Option<f64>,
    pub(crate) asperity_height_std: Option<f64>,
    pub(crate) surface_height_std: Option<f64>,
    pub(crate) plasticity_index: Option<f64>,
    pub(crate) roughness_parameter: Option<f64>,
    pub(crate) m0: Option<f64>,
    pub(crate) m2: Option<f64>,
    pub(crate) m4: Option<f64>,
    pub(crate) sq: Option<f64>,
    pub(crate) spd: Option<f64>,
    pub(crate) spc: Option<f64>,
    pub(crate) file: Option<PathBuf>,
    pub(crate) files: Option<Vec<PathBuf>>,
    pub(crate) unit: Option<LengthUnit>,
    pub(crate) pixel_size: Option<PixelSize>,
    pub(crate) estimator: Estimator,
    pub(crate) level: Option<Level>,
    pub(crate) filter: Option<f64>,
    pub(crate) smooth: Option<f64>,
    pub(crate) periodic: bool,
    pub(crate) max_missing: Option<f64>,
    pub(crate) fill_missing: bool,
    pub(crate) separation_from: Datum,
    pub(crate) heights: HeightsKey,
    pub(crate) asperities: Option<Asperities>,
}

/// `pixel_size`: of square pixels, or along a row and along a column.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(
    untagged,
    expecting = "a length in the unit of the heights, or a list of two, along a row and a column,"
)]
pub(crate) enum PixelSize {
    Square(f64),
    Rectangle([f64; 2]),
}

/// `heights`.
#[derive(Debug, Default, Deserialize)]
#[serde(
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"gaussian\" or \"exponential\" or \"measured\" or { skewness = -0.5 } or { file = \"pdf.csv\" }"
)]
pub(crate) enum HeightsKey {
    #[default]
    Gaussian,
    Exponential,
    Measured,
    #[serde(untagged)]
    Skewed {
        skewness: f64,
    },
    #[serde(untagged)]
    Table {
        file: PathBuf,
    },
}
