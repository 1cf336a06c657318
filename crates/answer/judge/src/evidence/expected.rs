//! What boundary elements are expected to give on a surface that was not solved.
//!
//! Areas and stiffnesses of solved surfaces change smoothly with load, bandwidth and hardness (in
//! E g/H the families nearly coincide), so that they are interpolated, and any model, solved beside
//! them or not, is compared with the result.

use serde::Serialize;

use crate::evidence::Evidence;
use crate::evidence::case::Compared;
use crate::evidence::coordinates::{
    Coordinates, LEAST_HURST, Nearest, Outside, SurfaceShape, gradient,
};
use asperity_core::{ContactError, Scene, short};

/// With fewer contacts, scatter alone exceeds the widest interval.
const FEWEST: f64 = 4.0;
/// Stiffnesses and gaps of spectra of at least this α whose Hurst exponent is below the second
/// number have no interval: 12 and 16 of 30 were inside at exponents of 0.3 to 0.5.
const BROAD: f64 = 10.0;

/// Boundary elements at a load, interpolated between solved surfaces.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ExpectedContact {
    /// m₀ m₄/m₂².
    pub alpha: f64,
    /// ψ; 0 without a hardness.
    pub plasticity_index: f64,
    /// Skewness and lay.
    pub shape: SurfaceShape,
    /// Mean pressure \[Pa\] of the values: the nearest solved one where `extrapolated`.
    pub pressure: f64,
    /// Whether the load is outside of the solved ones, where ratios to models are kept.
    pub extrapolated: bool,
    /// The property that is outside of the solved ones, with the reason why there are no intervals.
    pub outside: Option<Outside>,
    /// Solved surfaces of the nearest family.
    pub surfaces: usize,
    /// The quantities; those that the solved surfaces determine within a factor of 1.5 have an
    /// interval.
    pub values: Vec<(Compared, Estimate)>,
    /// Sq \[m\], the unit of differences of gaps.
    pub rms_height: f64,
    /// Hurst exponent of the surface, if known.
    #[serde(skip)]
    pub hurst: Option<f64>,
    /// Mean pressure over the hardness; 0 without one.
    #[serde(skip)]
    pub pressure_over_hardness: f64,
    /// Contacts of the surface; infinite if unknown.
    #[serde(skip)]
    pub contacts: f64,
}

/// A value, and an interval that holds nine of ten surfaces, or nine of ten means of many.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Estimate {
    /// Area over the nominal one, stiffness \[N/m\], mean gap \[m\].
    pub value: f64,
    /// Ends of the interval, if it is known.
    pub ends: Option<[f64; 2]>,
    /// The ends where it is not: beyond solved surfaces as at the nearest of them, at most a factor
    /// of 1.5 away.
    #[serde(skip)]
    pub presumed: Option<[f64; 2]>,
}

impl ExpectedContact {
    /// The estimate of a quantity; `None` under loads where solved surfaces do not determine it.
    #[must_use]
    pub fn estimate(&self, quantity: Compared) -> Option<Estimate> {
        self.values.iter().find(|(known, _)| *known == quantity).map(|(_, estimate)| *estimate)
    }

    /// Why a quantity has no interval.
    #[must_use]
    pub fn undetermined(&self, quantity: Compared) -> Outside {
        let highest = quantity.highest_pressure();
        if let Some(outside) = &self.outside {
            return outside.clone();
        }
        let is_rough = quantity != Compared::Area && is_rough(self.alpha, self.hurst);
        let hurst = self.hurst.filter(|_| is_rough);
        let reason = match (hurst, self.contacts) {
            (Some(hurst), _) => {
                let what = if quantity == Compared::MeanGap { "the gap" } else { "stiffness" };
                format!(
                    "the Hurst exponent of the scan is {hurst:.2}; solved surfaces have 0.8, and {what} depends on it at a bandwidth of {:.0}",
                    self.alpha
                )
            }
            _ if self.pressure_over_hardness > highest => format!(
                "values are interpolated up to {highest} H, and the pressure is {} H; the ratio to a model at the former is kept",
                short(self.pressure_over_hardness)
            ),
            (_, few) if few < 1.0 => format!("less than one asperity touches ({})", short(few)),
            (_, few) if few < FEWEST => {
                format!("with {few:.1} contacts, the scatter between surfaces is too large")
            }
            _ => "the interval would exceed a factor of 1.5".into(),
        };
        (quantity.name(), reason)
    }

    /// The surface and what stands behind the estimate: `alpha 8, psi 2; boundary elements on 16
    /// surfaces`.
    #[must_use]
    pub fn basis(&self) -> String {
        let short = |x: f64| ((10.0 * x).round() / 10.0).to_string();
        let mut text = format!("alpha {}", short(self.alpha));
        match self.plasticity_index > 0.0 {
            true => text += &format!(", psi {}", short(self.plasticity_index)),
            false => text += ", elastic",
        }
        text.extend(self.shape.differences().into_iter().map(|part| format!(", {part}")));
        let is_open = self.alpha > BROAD && self.hurst.is_none();
        let hurst = if is_open { ", for a Hurst exponent near 0.8" } else { "" };
        format!("{text}; boundary elements on {} surfaces{hurst}", self.surfaces)
    }
}

impl Evidence {
    /// What boundary elements are expected to give for a scene at a mean pressure \[Pa\]. Without a
    /// shape the surface is taken as isotropic, and its heights must be Gaussian. With the number
    /// of `contacts` the intervals are for single surfaces, which are small samples if they have
    /// few; without, for the mean of many surfaces.
    ///
    /// Intervals hold nine of ten values on surfaces of other spectra than the solved ones, whose
    /// Hurst exponent is 0.8. The exception that was found are spectra with α of 12 or more and an
    /// exponent of 0.3 to 0.5: 12 of 30 stiffnesses and 16 of 30 gaps were inside. They have none
    /// where the exponent is known to be below 0.6. Outside of the solved ones, values are at the
    /// nearest of them, without intervals.
    ///
    /// ```
    /// use asperity::{Compared, Evidence, Interface, ProfileMoments, Scene, Surface};
    ///
    /// let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4: 3e8 })?;
    /// let mut scene = Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4);
    /// let found = Evidence::committed()?.expected(&scene, None, 2e8, None)?;
    /// let area = found.estimate(Compared::Area).ok_or("no estimate")?;
    /// let [low, high] = area.ends.ok_or("no interval")?;
    /// assert!(low < area.value && area.value < high && high < 1.3 * low);
    /// // No surface of so large a bandwidth was solved.
    /// scene.surface = Surface::from_moments(&ProfileMoments { m0: 1e-11, m2: 2.5e-3, m4: 1e9 })?;
    /// let found = Evidence::committed()?.expected(&scene, None, 2e8, None)?;
    /// assert!(found.estimate(Compared::Area).ok_or("no estimate")?.ends.is_none());
    /// assert!(found.undetermined(Compared::Area).1.contains("alpha"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ContactError::NoEvidence`] where surfaces adhere, or heights without a shape are not
    /// Gaussian. Errors of the scene.
    pub fn expected(
        &self,
        scene: &Scene,
        shape: Option<SurfaceShape>,
        pressure: f64,
        contacts: Option<f64>,
    ) -> Result<ExpectedContact, ContactError> {
        self.expected_of(&Compared::ALL, scene, shape, pressure, contacts)
    }

    /// The same of some quantities alone.
    pub(crate) fn expected_of(
        &self,
        quantities: &[Compared],
        scene: &Scene,
        shape: Option<SurfaceShape>,
        pressure: f64,
        contacts: Option<f64>,
    ) -> Result<ExpectedContact, ContactError> {
        let mut own = Coordinates::of_scene(scene, shape, pressure)?;
        own.contacts = contacts.unwrap_or(f64::INFINITY);
        let Nearest { place, load, hardness, outside } = self.nearest(&own);
        let moments = scene.surface.moments();
        let unit = scene.asperity()?.equivalent_modulus * gradient(&moments);
        let rms_height = moments.m0.sqrt();
        let stiffness = unit * scene.nominal_area / rms_height;
        let hurst = shape.and_then(|shape| shape.hurst);
        let estimate = |&quantity: &Compared| {
            let unit = match quantity {
                Compared::Area => 1.0,
                Compared::MeanGap => rms_height,
                // Of what flows, loading takes in proportion to the hardness.
                Compared::Stiffness => hardness * stiffness,
                Compared::UnloadingStiffness => stiffness,
            };
            // Elastic contacts have one stiffness.
            let solved = match quantity {
                Compared::UnloadingStiffness if place.strain == 0.0 => Compared::Stiffness,
                other => other,
            };
            if place.of_hardness() > quantity.highest_pressure() {
                return None;
            }
            let least = match quantity {
                Compared::Area => place.of_hardness(),
                Compared::MeanGap => f64::NEG_INFINITY,
                _ => 0.0,
            };
            let found = self.interval(solved, &place)?;
            let is_known =
                outside.is_none() && (quantity == Compared::Area || !is_rough(place.alpha, hurst));
            let most = if quantity == Compared::Area { 1.0 } else { f64::INFINITY };
            let of = |x: f64| unit * x.max(least).min(most);
            let ends = found.ends.filter(|_| is_known).map(|ends| ends.map(of));
            let presumed = found.presumed.map(|ends| ends.map(of));
            Some((quantity, Estimate { value: of(found.value), ends, presumed }))
        };
        let mut values: Vec<_> = quantities.iter().filter_map(estimate).collect();
        unload_stiffer(&mut values);
        let how = |property: &str| match ["p/(E g)", "p/H"].contains(&property) {
            true => "the ratio to a model at the nearest end is kept",
            false => "taken at the nearest end",
        };
        let outside =
            outside.map(|(property, reason)| (property, format!("{reason}; {}", how(property))));
        Ok(ExpectedContact {
            alpha: own.alpha,
            plasticity_index: own.index,
            shape: own.shape,
            pressure: load * unit,
            extrapolated: load.total_cmp(&own.load).is_ne(),
            outside,
            surfaces: self.surfaces_near(&place),
            values,
            rms_height,
            hurst,
            pressure_over_hardness: own.of_hardness(),
            contacts: own.contacts,
        })
    }

    fn surfaces_near(&self, place: &Coordinates) -> usize {
        let away = |other: &Coordinates| {
            let skewness = other.shape.skewness - place.shape.skewness;
            let slopes = (other.shape.slope_ratio / place.shape.slope_ratio).ln();
            (other.alpha / place.alpha).ln().hypot(skewness).hypot(slopes)
        };
        let nearest = self.places.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        let Some(nearest) = nearest else { return 0 };
        let family = self.places.iter().zip(&self.cases).filter(|(p, _)| p.same_family(nearest));
        family.map(|(_, case)| case.surfaces).max().unwrap_or(0)
    }
}

fn is_rough(alpha: f64, hurst: Option<f64>) -> bool {
    alpha > BROAD && hurst.is_some_and(|hurst| hurst < LEAST_HURST)
}

/// What yielded in loading unloads elastically, at least as stiff: the two are interpolated one by
/// one, and may cross within their intervals where little yields.
fn unload_stiffer(values: &mut [(Compared, Estimate)]) {
    let of = |wanted: Compared| move |(quantity, _): &(Compared, Estimate)| *quantity == wanted;
    let Some((_, least)) = values.iter().copied().find(of(Compared::Stiffness)) else { return };
    for (_, found) in values.iter_mut().filter(|found| of(Compared::UnloadingStiffness)(found)) {
        let least_ends = least.ends.or(least.presumed).unwrap_or([least.value; 2]);
        let stiffer = |ends: [f64; 2]| [0, 1].map(|k| ends[k].max(least_ends[k]));
        found.value = found.value.max(least.value);
        (found.ends, found.presumed) = (found.ends.map(stiffer), found.presumed.map(stiffer));
    }
}
