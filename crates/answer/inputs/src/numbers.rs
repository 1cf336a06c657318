//! Scenes with other numbers.

use std::f64::consts::PI;

use asperity::{
    Body, ContactError, Interface, Pair, ProfileMoments, Scene, Surface, TabulatedHeights, positive,
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

/// What was written of one rough surface: three numbers by one of [`WAYS`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Written {
    pub(crate) keys: &'static [&'static str; 3],
    pub(crate) numbers: [f64; 3],
}

impl Written {
    /// The ways by which any surface can be written.
    const OF_ANY: [&'static [&'static str; 3]; 2] = [&WAYS[0], &WAYS[1]];

    /// A surface by its asperities.
    pub(crate) fn asperities(surface: &Surface) -> Self {
        let Surface { asperity_radius: radius, asperity_density: density, .. } = *surface;
        Self { keys: &WAYS[0], numbers: [radius, density, surface.asperity_height_std] }
    }

    /// The numbers as those from which asperities follow; `None` for asperities themselves, and for
    /// numbers that need the interface.
    pub(crate) fn roughness(&self) -> Option<Roughness> {
        Way::of(*self.keys).map(|way| Roughness { way, numbers: self.numbers })
    }

    /// Whether the asperities follow from the interface as well.
    pub(crate) fn needs_interface(&self) -> bool {
        self.keys == &WAYS[1]
    }

    /// The asperities of the surface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub(crate) fn surface(&self, interface: &Interface) -> Result<Surface, ContactError> {
        let [a, b, c] = self.numbers;
        let surface = match self.roughness() {
            Some(roughness) => roughness.surface()?,
            None if self.needs_interface() => Surface::from_plasticity_index(a, b, c, interface)?,
            None => Surface::new(a, b, c),
        };
        surface.check()?;
        Ok(surface)
    }

    /// The spectral moments of profiles, those of an isotropic Gaussian surface if they are not
    /// written.
    ///
    /// # Errors
    /// Those of [`surface`](Self::surface).
    pub(crate) fn moments(&self, interface: &Interface) -> Result<ProfileMoments, ContactError> {
        match self.roughness() {
            Some(roughness) => roughness.moments(),
            None => Ok(self.surface(interface)?.moments()),
        }
    }

    /// The way that has all of these keys: that of the surface, or else one of its asperities.
    pub(crate) fn way_with(&self, keys: &[&str]) -> Option<&'static [&'static str; 3]> {
        let ways = std::iter::once(self.keys).chain(Self::OF_ANY);
        let has_all = |way: &&'static [&str; 3]| keys.iter().all(|key| way.contains(key));
        ways.into_iter().find(has_all)
    }

    /// The same surface by the numbers of a way that [`way_with`](Self::way_with) gives.
    fn by(
        &self,
        keys: &'static [&'static str; 3],
        interface: &Interface,
    ) -> Result<Self, ContactError> {
        if self.keys == keys {
            return Ok(*self);
        }
        let surface = self.surface(interface)?;
        if keys == &WAYS[0] {
            return Ok(Self::asperities(&surface));
        }
        let scene = Scene::new(*interface, surface, 1.0);
        let (index, parameter) = (scene.plasticity_index()?, surface.roughness_parameter());
        Ok(Self { keys, numbers: [index, parameter, surface.asperity_height_std] })
    }

    /// The number of a key, if any way of the surface has it.
    pub(crate) fn number(&self, key: &str, interface: &Interface) -> Option<f64> {
        let of = self.by(self.way_with(&[key])?, interface).ok()?;
        of.keys.iter().zip(of.numbers).find(|(name, _)| **name == key).map(|(_, number)| number)
    }

    /// The surface with other numbers: those of its keys replace what was written; with others it
    /// is described by its asperities, of which the remaining numbers stay.
    ///
    /// # Errors
    /// Those of [`surface`](Self::surface).
    pub(crate) fn with(
        &self,
        given: &[(&'static str, f64)],
        interface: &Interface,
    ) -> Result<Self, ContactError> {
        let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
        let mut edited = self.by(self.way_with(&names).unwrap_or(self.keys), interface)?;
        for (key, number) in edited.keys.iter().zip(&mut edited.numbers) {
            let found = given.iter().find(|(name, _)| name == key);
            *number = found.map_or(*number, |(_, value)| *value);
        }
        Ok(edited)
    }
}

impl SceneFile {
    /// Gives the scene the surface that was written, one or two rough surfaces together.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub(crate) fn describe(&mut self, written: Vec<Written>) -> Result<(), ContactError> {
        let interface = &self.scene.interface;
        match written[..] {
            [first, second, ..] => {
                let of_second = second.moments(interface)?;
                let ProfileMoments { m0, m2, m4 } = first.moments(interface)?.plus(&of_second);
                let sum = Roughness { way: Way::Moments, numbers: [m0, m2, m4] };
                let pair = Pair::new(first.surface(interface)?, second.surface(interface)?);
                (self.scene.surface, self.scene.pair) = (sum.surface()?, Some(pair));
                (self.roughness, self.follows_from) = (Some(sum), sum.way.keys());
            }
            [only] => {
                (self.scene.surface, self.scene.pair) = (only.surface(interface)?, None);
                self.roughness = only.roughness();
                self.follows_from = if only.keys == &WAYS[0] { &[] } else { only.keys };
            }
            [] => {}
        }
        self.counter_variance = 0.0;
        self.written = written;
        Ok(())
    }

    /// What was written of the first surface, or its asperities if these are those of one surface;
    /// `None` of a surface with ranges, and of two that are not both described by numbers.
    pub(crate) fn first_written(&self) -> Option<Written> {
        let is_of_two = self.measured.is_some() && self.scan.is_none() || self.faces.len() > 1;
        let is_known = self.spreads().is_empty() && !is_of_two;
        let own = || is_known.then(|| Written::asperities(&self.scene.surface));
        self.written.first().copied().or_else(own)
    }

    /// The scene with other numbers of its first surface and of its interface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub(crate) fn with_surface(
        mut self,
        given: &[(&'static str, f64)],
        offset: Option<f64>,
    ) -> Result<Self, ContactError> {
        let (interface, before) = (self.scene.interface, self.scene.surface);
        let mut written = self.written.clone();
        if let Some(first) = self.first_written().filter(|_| !given.is_empty()) {
            let edited = first.with(given, &interface)?;
            match written.first_mut() {
                Some(first) => *first = edited,
                // A scan stays where its numbers do.
                None if edited.surface(&interface)? == before => {}
                None => written.push(edited),
            }
        }
        let [own, of_second] = self.mean_plane_offsets();
        let mut offsets = [offset.or(own), of_second];
        if written != self.written || written.iter().any(Written::needs_interface) {
            if self.written.is_empty() {
                // What was measured is valid for its own surface only.
                offsets = [None; 2];
                (self.measured, self.scan, self.faces) = (None, None, vec![]);
            }
            self.describe(written)?;
            self.odd_number = self.odd_number.filter(|_| before == self.scene.surface);
            self.set_heights(self.table.as_ref().map(TabulatedHeights::mean), offsets);
        } else if offset.is_some() {
            self.set_mean_plane_offsets(offsets);
        }
        Ok(self)
    }

    /// Sets mean planes and standard deviations of the heights: `measured`, the mean of the
    /// asperities above the mean plane, or those that are given of each surface.
    pub(crate) fn set_heights(&mut self, measured: Option<f64>, given: [Option<f64>; 2]) {
        match measured {
            Some(_) => self.scene.mean_plane_offset = measured,
            None => self.set_mean_plane_offsets(given),
        }
        let measured = self.measured.as_ref().map(|found| found.statistics.sq);
        let given = || Some(self.roughness?.moments().ok()?.m0.sqrt());
        self.scene.surface_height_std = measured.or_else(given);
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
