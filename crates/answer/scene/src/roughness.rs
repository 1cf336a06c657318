//! Three numbers that describe a rough surface.

use std::f64::consts::FRAC_PI_2;

use asperity::{ContactError, Interface, ProfileMoments, Surface, positive};

/// The ways to describe a surface by three numbers, in their order, with the keys.
pub(crate) const WAYS: [(Way, [&str; 3]); 6] = [
    (Way::Asperities, ["asperity_radius", "asperity_density", "asperity_height_std"]),
    (Way::PlasticityIndex, ["plasticity_index", "roughness_parameter", "asperity_height_std"]),
    (Way::SurfaceStd, ["asperity_radius", "asperity_density", "surface_height_std"]),
    (Way::MeanSlope, ["surface_height_std", "mean_slope", "asperity_density"]),
    (Way::Moments, ["m0", "m2", "m4"]),
    (Way::Iso25178, ["sq", "spd", "spc"]),
];

/// What three numbers of a surface are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// Radius and density of the asperities, and the standard deviation of their heights.
    Asperities,
    /// Plasticity index, density times radius times standard deviation, and that deviation: the
    /// asperities follow from the interface as well.
    PlasticityIndex,
    /// Radius and density of the asperities, and the standard deviation of the surface heights.
    SurfaceStd,
    /// The standard deviation of the surface heights, the mean absolute slope of profiles, and the
    /// density of the asperities.
    MeanSlope,
    /// Spectral moments of profiles: m0, m2 and m4.
    Moments,
    /// Parameters of ISO 25178: Sq, Spd and Spc.
    Iso25178,
}

impl Way {
    /// All of them.
    pub fn all() -> impl DoubleEndedIterator<Item = Self> + Clone {
        WAYS.iter().map(|(way, _)| *way)
    }

    /// The keys of the numbers.
    #[must_use]
    pub fn keys(self) -> &'static [&'static str; 3] {
        const ALL: &[(Way, [&str; 3])] = &WAYS;
        &ALL[self as usize].1
    }

    /// The way with these keys.
    #[must_use]
    pub fn of(keys: &[&str]) -> Option<Self> {
        Self::all().find(|way| *way.keys() == *keys)
    }

    /// The error of a ratio of the surface as that of the keys from which it follows.
    fn in_own_keys(self, error: ContactError) -> ContactError {
        let field = match self {
            Self::Iso25178 => "sq times spd over spc",
            Self::MeanSlope => {
                "12 sqrt(3) times asperity_density times (surface_height_std/mean_slope)^2"
            }
            _ => return error,
        };
        match error {
            ContactError::OutOfRange { value, required, .. } => {
                ContactError::OutOfRange { field, value, required }
            }
            other => other,
        }
    }

    /// Whether the numbers are those of the surface, from which its asperities follow, not the
    /// asperities themselves.
    #[must_use]
    pub fn is_of_surface(self) -> bool {
        !matches!(self, Self::Asperities | Self::PlasticityIndex)
    }
}

/// A rough surface by three numbers in SI units, as in `[surface]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// What they are.
    pub way: Way,
    /// The numbers, in the order of the keys.
    pub numbers: [f64; 3],
}

impl Roughness {
    /// A surface by its asperities.
    #[must_use]
    pub fn asperities(surface: &Surface) -> Self {
        let Surface { asperity_radius: radius, asperity_density: density, .. } = *surface;
        Self { way: Way::Asperities, numbers: [radius, density, surface.asperity_height_std] }
    }

    /// An isotropic Gaussian surface by its spectral moments.
    #[must_use]
    pub fn of_moments(ProfileMoments { m0, m2, m4 }: ProfileMoments) -> Self {
        Self { way: Way::Moments, numbers: [m0, m2, m4] }
    }

    /// An isotropic Gaussian surface by Rq \[m\], the mean slope and the bandwidth of its profiles.
    pub(crate) fn of_profile([rq, slope, bandwidth]: [f64; 3]) -> Self {
        let (m0, m2) = (rq * rq, FRAC_PI_2 * slope * slope);
        Self::of_moments(ProfileMoments { m0, m2, m4: bandwidth * m2 * (m2 / m0) })
    }

    /// The numbers with their keys.
    pub fn by_key(&self) -> impl Iterator<Item = (&'static str, f64)> + Clone + use<> {
        self.way.keys().iter().copied().zip(self.numbers)
    }

    /// The asperities of the surface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn surface(&self, interface: &Interface) -> Result<Surface, ContactError> {
        for (key, number) in self.by_key() {
            positive(key, number)?;
        }
        let [a, b, c] = self.numbers;
        let surface = match self.way {
            Way::Asperities => Ok(Surface::new(a, b, c)),
            Way::PlasticityIndex => Surface::from_plasticity_index(a, b, c, interface),
            Way::SurfaceStd => Surface::from_surface_std(a, b, c),
            Way::MeanSlope => Surface::from_mean_slope(a, b, c),
            Way::Moments => Surface::from_moments(&ProfileMoments { m0: a, m2: b, m4: c }),
            Way::Iso25178 => Surface::from_surface_std(1.0 / c, b, a),
        };
        let surface = surface.map_err(|error| self.way.in_own_keys(error))?;
        surface.check()?;
        Ok(surface)
    }

    /// The spectral moments of profiles: given, or of the isotropic Gaussian surface with these
    /// numbers and these `asperities`.
    #[must_use]
    pub fn moments(&self, asperities: &Surface) -> ProfileMoments {
        let [first, second, third] = self.numbers;
        let std = match self.way {
            Way::Moments => return ProfileMoments { m0: first, m2: second, m4: third },
            Way::Asperities | Way::PlasticityIndex => return asperities.moments(),
            Way::SurfaceStd => third,
            _ => first,
        };
        ProfileMoments { m0: std * std, ..asperities.moments() }
    }

    /// Sets the number of a key.
    pub(crate) fn set(&mut self, key: &str, value: f64) {
        let numbers = self.way.keys().iter().zip(&mut self.numbers);
        numbers.filter(|(name, _)| **name == key).for_each(|(_, number)| *number = value);
    }
}
