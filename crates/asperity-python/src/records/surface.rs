//! `Surface` and `Asperity`.

use asperity::{ContactError, ProfileMoments};
use asperity_inputs::{Roughness, Way};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::{Arg, Field, Interface, Origin, Record, instance, record, shown};
use crate::convert::error::refused;
use crate::convert::numbers::numbers;

record! {
    /// Asperities of one radius on a nominally flat surface.
    ///
    /// Numbers are in SI units, or texts with their unit, as "0.2 mm" or "200 1/mm2".
    ///
    /// Parameters
    /// ----------
    /// asperity_radius : float or str
    ///     R [m], above 0.
    /// asperity_density : float or str
    ///     Asperities per area [1/m^2], above 0.
    /// asperity_height_std : float or str
    ///     Standard deviation of the asperity heights [m], above 0; for that of the surface heights
    ///     use ``from_surface_std``.
    ///
    /// Examples
    /// --------
    /// >>> import asperity
    /// >>> surface = asperity.Surface(2e-4, 2e8, 1e-6)
    /// >>> round(surface.roughness_parameter, 6)
    /// 0.04
    /// >>> asperity.Surface("0.2 mm", "200 1/mm2", "1 um") == surface
    /// True
    Surface (asperity_radius, asperity_density, asperity_height_std)
        from asperity::Surface::new(0.0, 0.0, 0.0), asperity::Surface::check, by Option<Roughness>;
    /// Radius of the asperities [m].
    asperity_radius: f64,
    /// Asperities per area [1/m^2].
    asperity_density: f64,
    /// Standard deviation of the asperity heights [m].
    asperity_height_std: f64,
    {
        /// From the plasticity index, the roughness parameter (density times radius times
        /// height_std), the standard deviation of the asperity heights [m] and the interface.
        #[staticmethod]
        fn from_plasticity_index(
            plasticity_index: &Arg<'_>, roughness_parameter: &Arg<'_>,
            asperity_height_std: &Arg<'_>, interface: &Arg<'_>,
        ) -> PyResult<Self> {
            let [index, parameter, std] = numbers("Surface", [
                ("plasticity_index", plasticity_index),
                ("roughness_parameter", roughness_parameter),
                ("asperity_height_std", asperity_height_std),
            ])?;
            let interface = instance::<Interface>("interface", interface)?.get().0;
            Self::of(asperity::Surface::from_plasticity_index(index, parameter, std, &interface))
        }

        /// From the spectral moments of profiles of an isotropic Gaussian surface: averages of z^2
        /// [m^2], z'^2 and z''^2 [1/m^2].
        #[staticmethod]
        fn from_moments(m0: &Arg<'_>, m2: &Arg<'_>, m4: &Arg<'_>) -> PyResult<Self> {
            Self::following(Way::Moments, [m0, m2, m4])
        }

        /// From the parameters of ISO 25178 that instruments report: the standard deviation of the
        /// surface heights Sq [m], the density of peaks Spd [1/m^2] and their mean curvature Spc
        /// [1/m]. The peaks are the asperities.
        ///
        /// >>> import asperity
        /// >>> surface = asperity.Surface.from_iso25178(sq="1.1 um", spd="200 1/mm2", spc="5 1/mm")
        /// >>> surface.asperity_radius, surface.asperity_density
        /// (0.0002, 200000000.0)
        #[staticmethod]
        fn from_iso25178(sq: &Arg<'_>, spd: &Arg<'_>, spc: &Arg<'_>) -> PyResult<Self> {
            Self::following(Way::Iso25178, [sq, spd, spc])
        }

        /// From radius [m], density [1/m^2] and the standard deviation of the surface heights [m].
        #[staticmethod]
        fn from_surface_std(
            asperity_radius: &Arg<'_>, asperity_density: &Arg<'_>, surface_height_std: &Arg<'_>,
        ) -> PyResult<Self> {
            let given = [asperity_radius, asperity_density, surface_height_std];
            Self::following(Way::SurfaceStd, given)
        }

        /// The surface whose gap to a flat is that between this surface and an independent one:
        /// moments of profiles add. They are those given to ``from_moments``, or those of an
        /// isotropic Gaussian surface with these asperities (and this Sq).
        ///
        /// >>> import asperity
        /// >>> one = asperity.Surface.from_moments(1e-12, 1e-4, 5e4)
        /// >>> two = asperity.Surface.from_iso25178("0.4 um", "300 1/mm2", "4 1/mm")
        /// >>> round(one.against(two).asperity_height_std, 9)
        /// 1.037e-06
        fn against(&self, other: &Bound<'_, Self>) -> PyResult<Self> {
            let sum = self.moments()?.plus(&other.get().moments()?);
            Self::by(Roughness { way: Way::Moments, numbers: [sum.m0, sum.m2, sum.m4] })
        }

        /// From the standard deviation of the surface heights [m] and the mean absolute slope of
        /// profiles of an isotropic Gaussian surface, which correlations of conductance use, and
        /// the density of the summits [1/m^2].
        ///
        /// >>> import asperity
        /// >>> surface = asperity.Surface.from_mean_slope("1 um", 0.1, "4000 1/mm2")
        /// >>> round(surface.asperity_radius, 9)
        /// 1.4679e-05
        #[staticmethod]
        fn from_mean_slope(
            surface_height_std: &Arg<'_>, mean_slope: &Arg<'_>, asperity_density: &Arg<'_>,
        ) -> PyResult<Self> {
            let given = [surface_height_std, mean_slope, asperity_density];
            Self::following(Way::MeanSlope, given)
        }

        /// From parameters of ISO 25178, with the rms gradient Sdq of an isotropic Gaussian surface
        /// instead of Spc: Sq [m], Spd [1/m^2] and Sdq, without a unit.
        ///
        /// >>> import asperity
        /// >>> surface = asperity.Surface.from_gradient("1 um", "4000 1/mm2", 0.18)
        /// >>> round(surface.asperity_radius, 9)
        /// 1.4454e-05
        #[staticmethod]
        fn from_gradient(sq: &Arg<'_>, spd: &Arg<'_>, sdq: &Arg<'_>) -> PyResult<Self> {
            Self::following(Way::Gradient, [sq, spd, sdq])
        }

        /// Density times radius times height_std.
        #[getter]
        fn roughness_parameter(&self) -> f64 {
            self.0.roughness_parameter()
        }

        /// Height of the mean of the asperity heights above the mean plane of an isotropic Gaussian
        /// surface [m].
        #[getter]
        fn mean_plane_offset(&self) -> f64 {
            self.0.mean_plane_offset()
        }
    }
}

impl Surface {
    pub(crate) fn of(made: Result<asperity::Surface, ContactError>) -> PyResult<Self> {
        Self::checked(made.map_err(refused)?)
    }

    fn moments(&self) -> PyResult<ProfileMoments> {
        self.1.map_or(Ok(self.0.moments()), |roughness| roughness.moments().map_err(refused))
    }

    /// The surface that follows from numbers of this kind.
    fn following(way: Way, [one, two, three]: [&Arg<'_>; 3]) -> PyResult<Self> {
        let [a, b, c] = *way.keys();
        let numbers = numbers("Surface", [(a, one), (b, two), (c, three)])?;
        Self::by(Roughness { way, numbers })
    }

    fn by(roughness: Roughness) -> PyResult<Self> {
        Ok(Self(roughness.surface().map_err(refused)?, Some(roughness)))
    }
}

impl Origin<Surface> for Option<Roughness> {
    fn call<'py>(
        &self,
        record: &Bound<'py, Surface>,
    ) -> PyResult<Option<(Bound<'py, PyAny>, Bound<'py, PyTuple>)>> {
        let Some(roughness) = self else { return Ok(None) };
        let name = match roughness.way {
            Way::Moments => "from_moments",
            Way::Iso25178 => "from_iso25178",
            Way::MeanSlope => "from_mean_slope",
            Way::Gradient => "from_gradient",
            Way::SurfaceStd => "from_surface_std",
        };
        let numbers = PyTuple::new(record.py(), roughness.numbers)?;
        Ok(Some((record.get_type().getattr(name)?, numbers)))
    }
}

record! {
    /// One asperity with every input resolved: the argument of a model written in Python.
    ///
    /// Made by the engine and by ``Scene.asperity``.
    Asperity (
        equivalent_modulus, equivalent_shear_modulus, poissons_ratio, hardness, yield_strength,
        pressure_factor, radius, work_of_adhesion=None, tangent_modulus=None
    ) from asperity::Asperity {
        equivalent_modulus: 0.0,
        equivalent_shear_modulus: None,
        poissons_ratio: 0.0,
        hardness: None,
        yield_strength: None,
        tangent_modulus: None,
        pressure_factor: 0.0,
        work_of_adhesion: None,
        radius: 0.0,
    }, |_| Ok(()), by ();
    /// Equivalent modulus E [Pa].
    equivalent_modulus: f64,
    /// Equivalent shear modulus G [Pa], if given.
    equivalent_shear_modulus: Option<f64>,
    /// Poisson's ratio of the softer body.
    poissons_ratio: f64,
    /// Hardness of the softer body [Pa]; None if it never yields.
    hardness: Option<f64>,
    /// Yield strength of the softer body [Pa]; None if it never yields.
    yield_strength: Option<f64>,
    /// Maximum contact pressure factor.
    pressure_factor: f64,
    /// Radius [m].
    radius: f64,
    /// Work of adhesion [J/m^2], if given.
    work_of_adhesion: Option<f64>,
    /// Tangent modulus of two like bodies [Pa], if given.
    tangent_modulus: Option<f64>,
    {
        /// The interference at the onset of yielding [m]; ValueError if it would exceed the radius,
        /// or without a hardness.
        #[getter]
        fn critical_interference(&self) -> PyResult<f64> {
            self.0.critical_interference().map_err(refused)
        }

        /// The force at the critical interference [N]; ValueError as for ``critical_interference``.
        #[getter]
        fn critical_force(&self) -> PyResult<f64> {
            self.0.critical_force().map_err(refused)
        }
    }
}
