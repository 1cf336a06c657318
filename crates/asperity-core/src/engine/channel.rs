//! The integral of one law on one scene.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::{Density, QuadratureError};

use crate::engine::height_integral::HeightIntegral;
use crate::engine::inverse::force_at::Falls;
use crate::engine::onset::Onset;
use crate::{Asperity, AsperityModel, At, ContactError, Law, Quantity, Scene, Tolerance, Validity};

/// Scales w_c/σ_z outside mean nothing, and powers of them leave the doubles.
const SCALES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// The integral of one law.
#[derive(Debug)]
pub(crate) struct Channel {
    /// What the law is of.
    pub(crate) base: Quantity,
    pub(crate) law: Arc<Law>,
    pub(crate) units: Units,
    pub(crate) total: HeightIntegral,
    parts: OnceLock<Vec<HeightIntegral>>,
    falls: OnceLock<Option<Falls>>,
    scene: Scene,
    tolerance: Tolerance,
}

/// From a law's numbers to those of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// Interference unit over σ_z.
    pub(crate) scale: f64,
    /// Where the law begins.
    pub(crate) begins: Onset,
}

impl Units {
    /// Refuses scenes whose numbers leave the doubles.
    pub(crate) fn new(base: Quantity, law: &Law, scene: &Scene) -> Result<Self, ContactError> {
        let height_std = scene.surface.asperity_height_std;
        let factor = scene.asperities() * law.value_unit;
        let scale = law.interference_unit / height_std;
        // Tangents are divided by σ_z.
        let held = |x: &f64| *x > 0.0 && x.is_finite();
        match [factor, factor / height_std].into_iter().find(|x| !held(x)) {
            Some(scale) => Err(ContactError::Scale { quantity: base, scale }),
            None if SCALES.contains(&scale) && (law.begins * scale).is_finite() => {
                Ok(Self { factor, scale, begins: Onset(law.begins * scale) })
            }
            None => Err(ContactError::Ratio { ratio: scale }),
        }
    }
}

/// The laws that quantities come of.
pub(crate) fn bases(quantity: Quantity, own_stiffness: bool) -> &'static [Quantity] {
    match quantity {
        Quantity::Area | Quantity::AreaFraction | Quantity::LnArea => &[Quantity::Area],
        Quantity::MeanPressure => &[Quantity::Force, Quantity::Area],
        Quantity::Contacts => &[Quantity::Contacts],
        Quantity::ContactRadiusSum
        | Quantity::UnloadingStiffness
        | Quantity::TangentialStiffness
        | Quantity::ThermalConductance
        | Quantity::ElectricalConductance
        | Quantity::ThermalConductancePerArea
        | Quantity::ElectricalConductancePerArea => &[Quantity::ContactRadiusSum],
        Quantity::Stiffness if own_stiffness => &[Quantity::Stiffness],
        _ => &[Quantity::Force],
    }
}

/// The laws of one asperity that quantities come of.
#[derive(Debug)]
pub(crate) struct Laws {
    pub(crate) asperity: Asperity,
    /// Whether the model has a law for the stiffness; not looked at where none is asked for.
    pub(crate) own_stiffness: bool,
    /// Whether loads may be tensions.
    pub(crate) adhesive: bool,
    pub(crate) laws: Vec<(Quantity, Law)>,
    by_load: bool,
}

impl Laws {
    /// Those that these quantities need, and the force's where loads are to be met.
    pub(crate) fn new(
        model: &dyn AsperityModel,
        asperity: Asperity,
        quantities: &[Quantity],
        by_load: bool,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let Validity { adhesive, .. } = model.validity();
        let (own_stiffness, laws) = (false, vec![]);
        let mut found = Self { asperity, own_stiffness, adhesive, laws, by_load };
        for &quantity in quantities.iter().chain(by_load.then_some(&Quantity::Force)) {
            if quantity == Quantity::Stiffness && !found.own_stiffness {
                let own = model.law(&asperity, quantity, tolerance)?;
                found.own_stiffness = own.is_some();
                found.laws.extend(own.map(|law| (quantity, law)));
            }
            for &base in bases(quantity, found.own_stiffness) {
                if !found.laws.iter().any(|(known, _)| *known == base) {
                    let law = Self::law(model, &asperity, base, tolerance)?;
                    found.laws.push((base, law));
                }
            }
        }
        // Without any work of adhesion there are no tensions to be met.
        let pulls = |(base, law): &(Quantity, Law)| *base == Quantity::Force && law.is_signed();
        found.adhesive &= found.laws.iter().any(pulls);
        Ok(found)
    }

    /// The model's law, or the one that every model has.
    fn law(
        model: &dyn AsperityModel,
        asperity: &Asperity,
        base: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        match model.law(asperity, base, tolerance)? {
            Some(law) => Ok(law),
            // Every asperity that is reached touches, and what has an area has a contact.
            None if base == Quantity::Contacts && model.validity().adhesive => {
                let area = Self::law(model, asperity, Quantity::Area, tolerance)?;
                let unit = area.interference_unit;
                Ok(Law::counting(unit).beginning_at(area.begins))
            }
            None if base == Quantity::Contacts => Ok(Law::counting(asperity.radius)),
            None if base == Quantity::ContactRadiusSum => {
                let area = Self::law(model, asperity, Quantity::Area, tolerance)?;
                crate::law::contact_radii::law(model, &area)
            }
            None => Err(ContactError::NoLaw { model: model.name().into(), quantity: base }),
        }
    }

    /// Whether they are those of this asperity, and all that is needed.
    pub(crate) fn serve(&self, asperity: &Asperity, by_load: bool) -> bool {
        self.asperity == *asperity && (self.by_load || !by_load)
    }
}

pub(crate) fn failed(quantity: Quantity, at: At) -> impl Fn(QuadratureError) -> ContactError {
    move |source| ContactError::Integral { quantity, at, source }
}

impl Channel {
    pub(crate) fn new(
        base: Quantity,
        law: Arc<Law>,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let units = Units::new(base, &law, scene)?;
        let total = HeightIntegral::new(law.density(), &law, scene, tolerance.relative());
        let (parts, falls, scene) = (OnceLock::new(), OnceLock::new(), scene.clone());
        Ok(Self { base, law, units, total, parts, falls, scene, tolerance })
    }

    /// Where the law falls, if it does.
    pub(crate) fn falls(&self) -> Option<&Falls> {
        let of = || Falls::of(&self.law, &self.scene, self.tolerance);
        self.falls.get_or_init(of).as_ref()
    }

    /// The integrals of the law's parts, each alone.
    pub(crate) fn parts(&self) -> &[HeightIntegral] {
        self.parts.get_or_init(|| {
            let integral = |part: &crate::Part| {
                let alone = Density { pieces: vec![part.piece()] };
                HeightIntegral::new(alone, &self.law, &self.scene, self.tolerance.relative())
            };
            self.law.parts.iter().map(integral).collect()
        })
    }
}
