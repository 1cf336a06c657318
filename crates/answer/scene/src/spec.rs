//! What was written about a scene, in SI numbers.

use std::sync::Arc;

use asperity::{Body, Code, ContactError, Datum, HeightDistribution, Interface, TabulatedHeights};

use crate::curvature::Curvature;
use crate::finish::Drawing;
use crate::keys::COUNTERFACE;
use crate::materials::Material;
use crate::measured::{Measured, Scan};
use crate::options::ModelOptions;
use crate::roughness::{Roughness, Way};
use crate::seal::{Gas, Seal};

/// No second rough surface.
pub(crate) const SMOOTH: &str = "smooth";
/// A second surface like the first.
pub(crate) const SAME: &str = "same";

/// What was written about a scene. `SceneFile::of_spec` makes a scene of it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SceneSpec {
    /// A_n \[m²\]; 1 of curved bodies, which have none.
    pub nominal_area: f64,
    /// The bodies, or their interface.
    pub bodies: Bodies,
    /// The rough surface, or the first of two.
    pub surface: SurfaceSpec,
    /// The second rough surface.
    pub counterface: Option<SurfaceSpec>,
    /// The word in place of a second surface: [`SMOOTH`], or [`SAME`] while it is like the first.
    pub(crate) counterface_word: Option<&'static str>,
    /// What boundary elements press where that is not the scan of `surface`: the sum of two aligned
    /// scans, or a scan beside asperities.
    pub(crate) pressed: Option<Arc<Scan>>,
    /// The distribution of the asperity heights.
    pub heights: HeightsSpec,
    /// The plane from which separations are measured.
    pub separation_from: Datum,
    /// The bodies, where they are curved.
    pub curvature: Option<Curvature>,
    /// The gas in the gap, if there is one.
    pub gas: Option<Gas>,
    /// The seal whose faces the scan stands for.
    pub seal: Option<Seal>,
    /// The variants of the models.
    pub options: ModelOptions,
    /// Codes of accepted warnings and notes, which are not shown.
    pub accept: Vec<Code>,
}

/// The two bodies in contact, or what they have together.
#[derive(Debug, Clone)]
pub enum Bodies {
    /// Two bodies, or one on a rigid counterface.
    Each {
        /// One or two.
        bodies: Vec<Body>,
        /// The materials that give their numbers.
        materials: [Option<&'static Material>; 2],
        /// Of both together \[J/m²\].
        work_of_adhesion: Option<f64>,
    },
    /// Their equivalent properties.
    Interface(Interface),
}

/// One rough surface.
#[derive(Debug, Clone)]
pub struct SurfaceSpec {
    /// How it is described.
    pub by: Description,
    /// The height of the mean of the asperities above its mean plane \[m\], if given.
    pub mean_plane_offset: Option<f64>,
    /// Correlation length along x over that across, if given.
    pub peklenik_number: Option<f64>,
}

/// A way to describe a rough surface.
#[derive(Debug, Clone)]
pub enum Description {
    /// By three numbers.
    Numbers(Roughness),
    /// By roughness and finish.
    Drawing(Box<Drawing>),
    /// By a measurement.
    Scan(Arc<Scan>),
}

/// The distribution of the asperity heights.
#[derive(Debug, Clone, Default)]
pub struct HeightsSpec {
    /// The distribution.
    pub distribution: HeightDistribution,
    /// Its table, if it is one.
    pub table: Option<Arc<TabulatedHeights>>,
    /// Whether the table is of the summits of the scan.
    pub(crate) is_measured: bool,
}

/// The interface of two bodies, or of one on a rigid counterface.
///
/// # Errors
/// [`ContactError`] naming the field that is out of range, or another number of bodies than 1 or 2.
pub fn interface_of(bodies: &[Body]) -> Result<Interface, ContactError> {
    match bodies {
        [body] => Interface::against_rigid(body),
        [first, second] => Interface::between(first, second),
        more => Err(ContactError::OutOfRange {
            field: "the number of bodies",
            value: f64::from(u32::try_from(more.len()).unwrap_or(u32::MAX)),
            required: "1 or 2",
        }),
    }
}

impl Bodies {
    /// The bodies from which an interface was made, if they give it, or else the interface.
    #[must_use]
    pub fn of(bodies: Vec<Body>, interface: Interface) -> Self {
        let each = Self::each(bodies, interface.work_of_adhesion);
        if each.interface().is_ok_and(|made| made == interface) {
            each
        } else {
            Self::Interface(interface)
        }
    }

    fn each(bodies: Vec<Body>, work_of_adhesion: Option<f64>) -> Self {
        Self::Each { bodies, materials: [None; 2], work_of_adhesion }
    }

    /// The properties of both together.
    ///
    /// # Errors
    /// The errors of [`interface_of`].
    pub fn interface(&self) -> Result<Interface, ContactError> {
        match self {
            Self::Each { bodies, work_of_adhesion, .. } => {
                let mut made = interface_of(bodies)?;
                made.work_of_adhesion = *work_of_adhesion;
                Ok(made)
            }
            Self::Interface(interface) => Ok(*interface),
        }
    }

    /// The bodies; none of an interface.
    #[must_use]
    pub fn list(&self) -> &[Body] {
        match self {
            Self::Each { bodies, .. } => bodies,
            Self::Interface(_) => &[],
        }
    }

    /// The section of the hardness.
    pub(crate) fn section(&self) -> &'static str {
        match self {
            Self::Each { .. } => "body[1]",
            Self::Interface(_) => "interface",
        }
    }
}

impl From<Description> for SurfaceSpec {
    fn from(by: Description) -> Self {
        Self { by, mean_plane_offset: None, peklenik_number: None }
    }
}

impl SurfaceSpec {
    pub(crate) fn scan(&self) -> Option<&Arc<Scan>> {
        match &self.by {
            Description::Scan(scan) => Some(scan),
            _ => None,
        }
    }

    pub(crate) fn roughness(&self) -> Option<Roughness> {
        match self.by {
            Description::Numbers(roughness) => Some(roughness),
            _ => None,
        }
    }

    pub(crate) fn drawing(&self) -> Option<&Drawing> {
        match &self.by {
            Description::Drawing(drawing) => Some(drawing),
            _ => None,
        }
    }

    /// The numbers that describe it, by their keys.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, f64)> {
        match &self.by {
            Description::Numbers(roughness) => roughness.by_key().collect(),
            Description::Drawing(drawing) => drawing.by_key().collect(),
            Description::Scan(_) => vec![],
        }
    }

    /// The statistics of the scan of this surface.
    pub(crate) fn measured(&self) -> Option<&Arc<Measured>> {
        self.scan()?.measured.as_ref()
    }
}

impl HeightsSpec {
    /// The heights of a table.
    #[must_use]
    pub fn of_table(table: TabulatedHeights) -> Self {
        let distribution = HeightDistribution::other(table.clone());
        Self { distribution, table: Some(Arc::new(table)), ..Self::default() }
    }
}

impl From<HeightDistribution> for HeightsSpec {
    fn from(distribution: HeightDistribution) -> Self {
        Self { distribution, ..Self::default() }
    }
}

impl SceneSpec {
    /// A surface between bodies, with all other values by default.
    #[must_use]
    pub fn new(bodies: Bodies, surface: SurfaceSpec, nominal_area: f64) -> Self {
        Self {
            nominal_area,
            bodies,
            surface,
            counterface: None,
            counterface_word: None,
            pressed: None,
            heights: HeightsSpec::default(),
            separation_from: Datum::AsperityMean,
            curvature: None,
            gas: None,
            seal: None,
            options: ModelOptions::default(),
            accept: vec![],
        }
    }

    /// The rough surfaces with their sections.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = (&'static str, &SurfaceSpec)> {
        [("surface", &self.surface)]
            .into_iter()
            .chain(self.counterface.as_ref().map(|one| (COUNTERFACE, one)))
    }

    /// The surface of a section.
    pub(crate) fn one(&self, section: &str) -> Option<&SurfaceSpec> {
        self.surfaces().find(|(of, _)| *of == section).map(|(_, one)| one)
    }

    /// The surface of a section, to be changed.
    pub(crate) fn surface_mut(&mut self, section: &str) -> Option<&mut SurfaceSpec> {
        if section == COUNTERFACE { self.counterface.as_mut() } else { Some(&mut self.surface) }
    }

    /// The scan that boundary elements press.
    pub(crate) fn single_scan(&self) -> Option<&Arc<Scan>> {
        let own = || self.surface.scan().filter(|_| self.counterface.is_none());
        self.pressed.as_ref().or_else(own)
    }

    /// What the asperities follow from, if they are not given directly or measured.
    pub(crate) fn follows_from(&self) -> Option<String> {
        let by_asperities = |one: Roughness| one.way == Way::Asperities;
        let is_given =
            self.counterface.is_none() && self.surface.roughness().is_some_and(by_asperities);
        let is_measured = self.surfaces().any(|(_, one)| one.scan().is_some());
        let words = || self.surfaces().map(|(_, one)| one.in_words()).collect::<Vec<_>>();
        (!is_given && !is_measured).then(|| words().join(" on "))
    }
}
