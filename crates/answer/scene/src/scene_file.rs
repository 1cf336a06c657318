//! A scene with what was written about it.

use std::sync::Arc;

use asperity::{
    Code, ContactError, Datum, Findings, HeightDistribution, Scene, Separation, SeparationUnit,
    SolvedContact, TabulatedHeights,
};
use asperity_topography::Topography;

use crate::error::{Provenance, SceneError};
use crate::input::SceneInput;
use crate::measured::{Measured, Scan};
use crate::resolve::resolve;
use crate::roughness::Roughness;
use crate::seal::{Gas, Seal};
use crate::spec::{Bodies, Description, HeightsSpec, SceneSpec};
use crate::unknown::Unknown;

/// A scene with what was written about it, and where.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SceneFile {
    /// What was written.
    pub spec: SceneSpec,
    /// The surfaces in contact; those of numbers with ranges in the middle of these.
    pub scene: Scene,
    /// Statistics of the scans of the surface, if there are any.
    pub measured: Option<Arc<Measured>>,
    /// Warnings about the file.
    pub warnings: Findings,
    /// What boundary elements gave on its scan, where that was solved: an input of
    /// [`best`](Self::best).
    pub solved: Vec<SolvedContact>,
    /// Whether it is a point of the ranges of another, whose answers are ends of that.
    pub(crate) within_ranges: bool,
    /// The numbers that were written as ranges.
    pub(crate) ranges: Vec<(SceneInput, Unknown)>,
    /// Where it was written; nowhere where numbers were changed since.
    pub(crate) origin: Option<Arc<Provenance>>,
}

impl From<Scene> for SceneFile {
    /// A scene without a file: default options, and separations from the mean of the asperity
    /// heights.
    fn from(scene: Scene) -> Self {
        let surface = Description::Numbers(Roughness::asperities(&scene.surface)).into();
        let bodies = Bodies::Interface(scene.interface);
        let mut spec = SceneSpec::new(bodies, surface, scene.nominal_area);
        spec.surface.mean_plane_offset = scene.mean_plane_offset;
        spec.heights = HeightsSpec::from(scene.heights.clone());
        Self::new(spec, scene, None)
    }
}

impl SceneFile {
    /// The scene of a spec with the statistics of its scans, written nowhere.
    pub(crate) fn new(spec: SceneSpec, scene: Scene, measured: Option<Arc<Measured>>) -> Self {
        let (warnings, solved) = Default::default();
        let (within_ranges, ranges, origin) = Default::default();
        Self { spec, scene, measured, warnings, solved, within_ranges, ranges, origin }
    }

    /// The scene that a spec describes.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn of_spec(spec: SceneSpec) -> Result<Self, ContactError> {
        let (scene, measured) = resolve(&spec).map_err(|fault| fault.source)?;
        Ok(Self::new(spec, scene, measured))
    }

    /// Accepts warnings and notes of these codes, too.
    #[must_use]
    pub fn accepting(mut self, codes: &[Code]) -> Self {
        self.spec.accept.extend_from_slice(codes);
        self.warnings = self.warnings.silenced(codes);
        self
    }

    /// The bodies from which the interface follows, if given.
    #[must_use]
    pub fn bodies(&self) -> &[asperity::Body] {
        self.spec.bodies.list()
    }

    /// The table of heights of the scene, if there is one.
    #[must_use]
    pub fn table(&self) -> Option<&TabulatedHeights> {
        self.spec.heights.table.as_deref()
    }

    /// The scan of the surface, levelled and filtered, if there is exactly one.
    #[must_use]
    pub fn scan(&self) -> Option<&Topography> {
        Some(&self.spec.single_scan()?.topography)
    }

    /// The numbers from which the asperities follow, if they are not given directly or measured: of
    /// two surfaces by numbers the sums of their moments.
    #[must_use]
    pub fn roughness(&self) -> Option<Roughness> {
        let first = self.spec.surface.roughness()?;
        let Some(second) = &self.spec.counterface else {
            return Some(first).filter(|only| only.way.is_of_surface());
        };
        let [one, two] = self.scene.pair?.surfaces;
        let own = first.moments(&one.asperities);
        Some(Roughness::of_moments(own.plus(&second.roughness()?.moments(&two.asperities))))
    }

    /// The scans that the scene names.
    #[must_use]
    pub fn files(&self) -> &[std::path::PathBuf] {
        self.origin.as_ref().map_or(&[], |origin| &origin.files)
    }

    /// A separation measured from the plane of this scene.
    #[must_use]
    pub fn separation(&self, value: f64, unit: SeparationUnit) -> Separation {
        Separation { value, unit, from: self.spec.separation_from }
    }

    /// The name of the plane from which separations are measured.
    #[must_use]
    pub fn plane(&self) -> &'static str {
        self.spec.separation_from.name(&self.scene.heights)
    }

    /// The missing requirement for separations from the mean plane of the surface, if any.
    pub(crate) fn no_mean_plane(&self) -> Option<&'static str> {
        match (&self.scene.heights, self.table()) {
            _ if self.spec.separation_from == Datum::AsperityMean => None,
            (_, Some(table)) if table.mean().abs() < 1e-3 * table.standard_deviation() => Some(
                "a table whose heights are measured from the mean plane of the surface (the mean of this table is 0: its heights are measured from their own mean)",
            ),
            _ if self.scene.mean_plane_offset.is_some() => None,
            (HeightDistribution::Exponential | HeightDistribution::Weibull(_), _) => Some(
                "separation_from = \"asperity-mean\" or mean_plane_offset (the mean plane of such heights is unknown)",
            ),
            _ => None,
        }
    }

    /// The reason why the scan has no asperities, in a scene from `load_scan`.
    pub(crate) fn no_asperities(&self) -> Option<String> {
        Some(self.measured.as_ref()?.statistics.surface().err()?.to_string())
    }

    /// The gas in the gap.
    ///
    /// # Errors
    /// [`ContactError::Missing`] without one.
    pub fn needed_gas(&self) -> Result<Gas, ContactError> {
        let (field, reason) = ("gas_conductivity", "set it and gas_parameter in [gap]".into());
        self.spec.gas.ok_or(ContactError::Missing { field, reason })
    }

    /// The seal.
    ///
    /// # Errors
    /// [`ContactError::Missing`] without one.
    pub fn needed_seal(&self) -> Result<Seal, ContactError> {
        let reason = "write [seal] with width, length, upstream_pressure, downstream_pressure, and gas or viscosity".into();
        self.spec.seal.ok_or(ContactError::Missing { field: "seal", reason })
    }

    /// Refuses a scene of curved bodies, for what flat bodies alone have.
    ///
    /// # Errors
    /// [`SceneError::Refused`] at `[curvature]`.
    pub fn need_flat(&self) -> Result<(), SceneError> {
        if self.spec.curvature.is_none() {
            return Ok(());
        }
        let own = Provenance::default();
        let at = self.origin.as_deref().unwrap_or(&own).place("curvature");
        let reason = "separations, films, boundary elements, joints, exports and fits are of flat bodies: write nominal_area instead of [curvature]";
        Err(SceneError::refused(at, reason))
    }

    /// The scene with this scan to be pressed by boundary elements.
    #[must_use]
    pub fn pressing_scan(mut self, scan: Topography) -> Self {
        self.spec.pressed = Some(Arc::new(Scan::new(scan, None)));
        self
    }
}
