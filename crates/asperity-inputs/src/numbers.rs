//! Scenes with other numbers.

use std::f64::consts::PI;

use asperity::{
    Asperities, Body, ContactError, Findings, Interface, Pair, ProfileMoments, Scene, Surface,
    TabulatedHeights, positive,
};

use crate::SceneFile;

/// The ways to describe a surface by three numbers: the asperities themselves, those that follow
/// from the interface as well, and those of [`Roughness`].
pub(crate) const WAYS: &[[&str; 3]; 7] = &[
    ["asperity_radius", "asperity_density", "asperity_height_std"],
    ["plasticity_index", "roughness_parameter", "asperity_height_std"],
    ["asperity_radius", "asperity_density", "surface_height_std"],
    ["surface_height_std", "mean_slope", "asperity_density"],
    ["m0", "m2", "m4"],
    ["sq", "spd", "spc"],
    ["sq", "spd", "sdq"],
];

/// Three numbers from which the asperities of a surface follow, as in `[surface]`, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// What they are.
    pub way: Way,
    /// The numbers, in the order of the keys.
    pub numbers: [f64; 3],
}

/// What three numbers of a surface are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// Radius and density of the asperities, and the standard deviation of the surface heights.
    SurfaceStd,
    /// The standard deviation of the surface heights, the mean absolute slope of profiles, and the
    /// density of the asperities.
    MeanSlope,
    /// Spectral moments of profiles: m0, m2 and m4.
    Moments,
    /// Parameters of ISO 25178: Sq, Spd and Spc.
    Iso25178,
    /// Parameters of ISO 25178: Sq, Spd and the rms gradient Sdq of an isotropic Gaussian surface.
    Gradient,
}

impl Way {
    const ALL: [Self; 5] =
        [Self::SurfaceStd, Self::MeanSlope, Self::Moments, Self::Iso25178, Self::Gradient];

    /// The keys of the numbers.
    #[must_use]
    pub fn keys(self) -> &'static [&'static str; 3] {
        let [_, _, keys @ ..] = WAYS;
        &keys[self as usize]
    }

    /// The description by the numbers of these keys; `None` for asperities and dimensionless
    /// numbers.
    #[must_use]
    pub fn of(keys: [&str; 3]) -> Option<Self> {
        Self::ALL.into_iter().find(|way| *way.keys() == keys)
    }
}

impl Roughness {
    /// The spectral moments of profiles of an isotropic Gaussian surface with these numbers.
    ///
    /// # Errors
    /// Those of [`surface`](Self::surface).
    pub fn moments(&self) -> Result<ProfileMoments, ContactError> {
        let surface = self.surface()?;
        let [first, second, third] = self.numbers;
        let std = match self.way {
            Way::Moments => return Ok(ProfileMoments { m0: first, m2: second, m4: third }),
            Way::SurfaceStd => third,
            _ => first,
        };
        Ok(ProfileMoments { m0: std * std, ..surface.moments() })
    }

    /// The surface with these asperities.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn surface(&self) -> Result<Surface, ContactError> {
        let [a, b, c] = self.numbers;
        let surface = match self.way {
            Way::SurfaceStd => Surface::from_surface_std(a, b, c),
            Way::MeanSlope => Surface::from_mean_slope(a, b, c),
            Way::Moments => Surface::from_moments(&ProfileMoments { m0: a, m2: b, m4: c }),
            Way::Iso25178 => Surface::from_iso25178(a, b, c),
            Way::Gradient => from_gradient(a, b, c),
        }?;
        surface.check()?;
        Ok(surface)
    }
}

/// Sdq over √π is the mean absolute slope of profiles of an isotropic Gaussian surface.
fn from_gradient(sq: f64, spd: f64, sdq: f64) -> Result<Surface, ContactError> {
    let (sq, spd, sdq) = (positive("sq", sq)?, positive("spd", spd)?, positive("sdq", sdq)?);
    Surface::from_mean_slope(sq, sdq / PI.sqrt(), spd)
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
        let pair = |pair: Pair| match same {
            true => pair,
            false => pair.scaled(&self.scene.surface, &surface),
        };
        scene.pair = self.scene.pair.map(pair);
        scene.mean_plane_offset = self.table.as_ref().map(TabulatedHeights::mean).or(offset);
        scene.surface_height_std = self.scene.surface_height_std.filter(|_| same);
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
            faces: if same { self.faces.clone() } else { vec![] },
            ..self.clone()
        })
    }

    /// Sets the heights of the means of the asperities above the mean planes \[m\] of the surface
    /// and of the counterface, where they are given. Beside a counterface, the surface that is
    /// equivalent to both has the Gaussian offset of its own, changed by the ratio of the sum of
    /// both offsets to that of Gaussian surfaces.
    pub(crate) fn set_mean_plane_offsets(&mut self, given: [Option<f64>; 2]) {
        let Scene { surface, pair, mean_plane_offset, .. } = &mut self.scene;
        let Some(pair) = pair else {
            *mean_plane_offset = given[0];
            return;
        };
        let [first, second] = pair.surfaces.map(|one| one.asperities);
        let gaussian = Pair::new(first, second).mean_plane_offset();
        for (one, given) in pair.surfaces.iter_mut().zip(given) {
            one.mean_plane_offset = given;
        }
        let ratio = pair.mean_plane_offset() / gaussian;
        let is_given = given.iter().any(Option::is_some);
        *mean_plane_offset = is_given.then(|| surface.mean_plane_offset() * ratio);
    }

    /// The heights that [`set_mean_plane_offsets`](Self::set_mean_plane_offsets) sets.
    pub(crate) fn mean_plane_offsets(&self) -> [Option<f64>; 2] {
        let alone = [self.scene.mean_plane_offset, None];
        self.scene.pair.map_or(alone, |pair| pair.surfaces.map(|one| one.mean_plane_offset))
    }

    /// Whether models on these asperities press two rough surfaces on each other.
    pub(crate) fn is_pair(&self, asperities: Asperities) -> bool {
        asperities == Asperities::Pairs && self.no_pair.is_none()
    }

    /// Whether the scene describes one surface, and its models press that on another one like it.
    pub(crate) fn meets_its_like(&self) -> bool {
        self.is_pair(self.options.asperities) && self.scene.pair.is_none()
    }

    /// An interface with the properties of this pair that do not follow from the bodies.
    pub(crate) fn with_pair(&self, mut of_bodies: Interface) -> Interface {
        of_bodies.work_of_adhesion = self.scene.interface.work_of_adhesion;
        of_bodies.pressure_factor = self.scene.interface.pressure_factor;
        of_bodies
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
