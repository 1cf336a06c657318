//! Scenes with other numbers.

use std::f64::consts::PI;

use asperity::{
    Body, ContactError, Findings, Interface, ProfileMoments, Scene, Surface, TabulatedHeights,
};

use crate::SceneFile;
use crate::bandwidth::{GRADIENT, MEAN_SLOPE};

/// The ways to describe a surface by three numbers: the asperities themselves, those that follow
/// from the interface as well, and those of [`Roughness`].
pub(crate) const WAYS: &[[&str; 3]; 7] = &[
    ["asperity_radius", "asperity_density", "asperity_height_std"],
    ["plasticity_index", "roughness_parameter", "asperity_height_std"],
    ["asperity_radius", "asperity_density", "surface_height_std"],
    ["surface_height_std", MEAN_SLOPE, "asperity_density"],
    ["m0", "m2", "m4"],
    ["sq", "spd", "spc"],
    ["sq", "spd", GRADIENT],
];

/// Three numbers from which the asperities of a surface follow, as in `[surface]`, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Roughness {
    /// Radius and density of the asperities, and the standard deviation of the surface heights.
    SurfaceStd([f64; 3]),
    /// The standard deviation of the surface heights, the mean absolute slope of profiles, and the
    /// density of the asperities.
    MeanSlope([f64; 3]),
    /// Spectral moments of profiles: m0, m2 and m4.
    Moments([f64; 3]),
    /// Parameters of ISO 25178: Sq, Spd and Spc.
    Iso25178([f64; 3]),
    /// Parameters of ISO 25178: Sq, Spd and the rms gradient Sdq of an isotropic Gaussian surface.
    Gradient([f64; 3]),
}

impl Roughness {
    /// The keys of the numbers.
    #[must_use]
    pub fn keys(&self) -> &'static [&'static str; 3] {
        let [.., surface_std, mean_slope, moments, iso, gradient] = WAYS;
        match self {
            Self::SurfaceStd(_) => surface_std,
            Self::MeanSlope(_) => mean_slope,
            Self::Moments(_) => moments,
            Self::Iso25178(_) => iso,
            Self::Gradient(_) => gradient,
        }
    }

    /// The numbers, in the order of the keys.
    #[must_use]
    pub fn numbers(&self) -> [f64; 3] {
        let mut same = *self;
        *same.numbers_mut()
    }

    /// The same kind of description with other numbers.
    #[must_use]
    pub fn with(mut self, numbers: [f64; 3]) -> Self {
        *self.numbers_mut() = numbers;
        self
    }

    pub(crate) fn numbers_mut(&mut self) -> &mut [f64; 3] {
        match self {
            Self::SurfaceStd(numbers)
            | Self::MeanSlope(numbers)
            | Self::Moments(numbers)
            | Self::Iso25178(numbers)
            | Self::Gradient(numbers) => numbers,
        }
    }

    /// The description by the numbers of these keys; `None` for asperities and dimensionless
    /// numbers.
    #[must_use]
    pub fn of(keys: [&str; 3], numbers: [f64; 3]) -> Option<Self> {
        let kinds =
            [Self::SurfaceStd, Self::MeanSlope, Self::Moments, Self::Iso25178, Self::Gradient];
        kinds.into_iter().map(|kind| kind(numbers)).find(|kind| *kind.keys() == keys)
    }

    /// The spectral moments of profiles of an isotropic Gaussian surface with these numbers.
    ///
    /// # Errors
    /// Those of [`surface`](Self::surface).
    pub fn moments(&self) -> Result<ProfileMoments, ContactError> {
        let surface = self.surface()?;
        Ok(match *self {
            Self::Moments([m0, m2, m4]) => ProfileMoments { m0, m2, m4 },
            Self::SurfaceStd([.., std])
            | Self::MeanSlope([std, ..])
            | Self::Iso25178([std, ..])
            | Self::Gradient([std, ..]) => ProfileMoments { m0: std * std, ..surface.moments() },
        })
    }

    /// The surface with these asperities.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn surface(&self) -> Result<Surface, ContactError> {
        let surface = match *self {
            Self::SurfaceStd([radius, density, std]) => {
                Surface::from_surface_std(radius, density, std)
            }
            Self::MeanSlope([std, slope, density]) => Surface::from_mean_slope(std, slope, density),
            Self::Moments([m0, m2, m4]) => Surface::from_moments(&ProfileMoments { m0, m2, m4 }),
            Self::Iso25178([sq, spd, spc]) => Surface::from_iso25178(sq, spd, spc),
            Self::Gradient([sq, spd, sdq]) => from_gradient(sq, spd, sdq),
        }?;
        surface.check()?;
        Ok(surface)
    }
}

/// Sdq over √π is the mean absolute slope of profiles of an isotropic Gaussian surface.
fn from_gradient(sq: f64, spd: f64, sdq: f64) -> Result<Surface, ContactError> {
    let made = Surface::from_mean_slope(sq, sdq / PI.sqrt(), spd);
    made.map_err(|error| match error {
        ContactError::OutOfRange { field, value, required } => {
            let (field, value) = match field {
                "surface_height_std" => ("sq", value),
                "asperity_density" => ("spd", value),
                "mean_slope" => ("sdq", sdq),
                other => (other, value),
            };
            ContactError::OutOfRange { field, value, required }
        }
        error => error,
    })
}

impl SceneFile {
    /// The scene with other numbers and the same options, heights and plane of separations: a table
    /// of heights stays in metres, and the mean plane follows the surface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_numbers(
        &self,
        interface: Interface,
        surface: Surface,
        nominal_area: f64,
    ) -> Result<Self, ContactError> {
        let mut scene = Scene::new(interface, surface, nominal_area);
        scene.asperity()?;
        scene.heights = self.scene.heights.clone();
        let same = surface == self.scene.surface;
        // A measurement is valid for its own surface only.
        let offset = self.scene.mean_plane_offset.filter(|_| same);
        scene.mean_plane_offset = self.table.as_ref().map(TabulatedHeights::mean).or(offset);
        let keep_bodies = self.with_pair(interface) == self.scene.interface;
        Ok(Self {
            scene,
            bodies: if keep_bodies { self.bodies.clone() } else { vec![] },
            measured: self.measured.clone().filter(|_| same),
            follows_from: if same { self.follows_from } else { &[] },
            roughness: self.roughness.filter(|_| same),
            odd_number: self.odd_number.clone().filter(|_| same),
            stated: vec![],
            warnings: Findings::default(),
            scan: self.scan.clone().filter(|_| same),
            ..self.clone()
        })
    }

    /// An interface with the properties of this pair that do not follow from the bodies.
    fn with_pair(&self, mut of_bodies: Interface) -> Interface {
        of_bodies.work_of_adhesion = self.scene.interface.work_of_adhesion;
        of_bodies.pressure_factor = self.scene.interface.pressure_factor;
        of_bodies
    }

    /// [`with_numbers`](Self::with_numbers) for other bodies, one of them on a rigid counterface;
    /// the work of adhesion and the pressure factor stay.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range, or another number of bodies than 1
    /// or 2.
    pub fn with_bodies(&self, bodies: Vec<Body>) -> Result<Self, ContactError> {
        let interface = self.with_pair(interface_of(&bodies)?);
        let made = self.with_numbers(interface, self.scene.surface, self.scene.nominal_area)?;
        Ok(Self { bodies, ..made })
    }

    /// [`with_numbers`](Self::with_numbers) for a surface that follows from other numbers.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_roughness(&self, roughness: Roughness) -> Result<Self, ContactError> {
        let made =
            self.with_numbers(self.scene.interface, roughness.surface()?, self.scene.nominal_area)?;
        Ok(Self { roughness: Some(roughness), follows_from: roughness.keys(), ..made })
    }
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
