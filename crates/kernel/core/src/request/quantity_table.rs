//! The table of quantities: one entry for each, and everything else follows from it.

use serde::{Deserialize, Serialize};

use crate::Regime;
use Derivation::{
    Bodies, ContactRadii, Flow, Gap, Integral, IntegralOrSlope, Logarithm, Map, PerNominalArea,
    Ratio, RegimeShare, Seal, Slope,
};
use Quantity::{Area, ElectricalConductance, Force, ThermalConductance};

/// A number of the interface by its name, and the factor of the sum of the contact radii that
/// follows from it.
pub(crate) type InterfaceProperty = (&'static str, fn(f64) -> f64);

/// How a quantity follows from the laws of one asperity.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Derivation {
    /// The integral of the law of this quantity over the heights.
    Integral,
    /// The same for models with such a law; for others the [`Slope`](Self::Slope) of this.
    IntegralOrSlope(Quantity),
    /// -d/dd of an integral.
    Slope(Quantity),
    /// Over the nominal area.
    PerNominalArea(Quantity),
    /// The sum of the contact radii times a factor that a number of the interface gives.
    ContactRadii(InterfaceProperty),
    /// One integral over another.
    Ratio(Quantity, Quantity),
    /// The natural logarithm of the absolute value of an integral.
    Logarithm(Quantity),
    /// The share of a regime in the force.
    RegimeShare(Regime),
    /// A factor of flow, which follows from the film.
    Flow,
    /// A conductance of the gas in the gap, which follows from the gap.
    Gap,
    /// Of a map of the gap, and of no law of asperities.
    Map,
    /// Of a map of the gap and a seal.
    Seal,
    /// Of curved bodies.
    Bodies,
}

/// An entry of the table.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) symbol: &'static str,
    pub(crate) unit: &'static str,
    pub(crate) label: &'static str,
    pub(crate) definition: &'static str,
    pub(crate) derivation: Derivation,
}

macro_rules! quantities {
    ($($(#[$remark:meta])* $variant:ident $name:literal $symbol:literal $unit:literal
        $label:literal ($derivation:expr) $definition:literal;)*) => {
        /// A quantity of the whole contact, by the name users ask for it.
        ///
        /// ```
        /// use asperity_core::Quantity;
        ///
        /// let quantity: Quantity = "mean-pressure".parse()?;
        /// assert_eq!((quantity.to_string().as_str(), quantity.unit()), ("mean-pressure", "Pa"));
        /// let mistyped = "stifness".parse::<Quantity>().unwrap_err().to_string();
        /// assert!(mistyped.contains("the nearest is \"stiffness\""));
        /// # Ok::<(), asperity_core::ContactError>(())
        /// ```
        #[derive(
            Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
        )]
        #[serde(rename_all = "kebab-case")]
        #[non_exhaustive]
        pub enum Quantity {
            $(
                #[doc = concat!("`", $name, "` \\[", $unit, "\\]: ", $definition)]
                $(#[$remark])*
                $variant,
            )*
        }

        impl Quantity {
            /// All quantities.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            /// Number of quantities that are integrals of laws.
            pub(crate) const INTEGRALS: usize = 0 $(+ {
                let derivation: Derivation = $derivation;
                matches!(derivation, Derivation::Integral | Derivation::IntegralOrSlope(_)) as usize
            })*;

            pub(crate) const fn entry(self) -> &'static Entry {
                match self {
                    $(Self::$variant => {
                        const ENTRY: Entry = Entry {
                            name: $name,
                            symbol: $symbol,
                            unit: $unit,
                            label: $label,
                            definition: $definition,
                            derivation: $derivation,
                        };
                        &ENTRY
                    })*
                }
            }
        }
    };
}

// Of each its name, symbol, unit, label, derivation and definition.
quantities! {
    Force "force" "F" "N" "force" (Integral)
        "Normal force between the surfaces, over the whole nominal area.";
    Area "area" "A" "m2" "real contact area" (Integral)
        "Real contact area: the sum of the areas of all contacts.";
    Stiffness "stiffness" "K" "N/m" "stiffness" (IntegralOrSlope(Force))
        "Stiffness as the model's paper defines it: the tangent for models of upright asperities, \
        an average of asperity stiffnesses for Gao and AT.";
    Tangent "tangent" "-dF/dd" "N/m" "tangent stiffness" (Slope(Force))
        "Fall of the force with the separation, -dF/dd, jumps of the law included; of yielded \
        boundary elements the chord between pressures up to 5 % to either side.";
    Pressure "pressure" "p" "Pa" "pressure" (PerNominalArea(Force))
        "Force over the nominal area.";
    AreaFraction "area-fraction" "A/A_n" "" "real over nominal area" (PerNominalArea(Area))
        "Real contact area over the nominal area.";
    Contacts "contacts" "N" "" "number of contacts" (Integral)
        "Number of asperities in contact.";
    /// Needs upright asperities with circular contacts.
    ContactRadiusSum "contact-radius-sum" "sum a" "m" "sum of contact radii" (Integral)
        "Sum of the radii a = (A/pi)^(1/2) of all contacts.";
    /// Small vibrations, ultrasound and modal tests measure this slope. First loading follows the
    /// tangent, which is smaller where asperities yield. For contacts with adhesion (JKR) it holds
    /// for motions so small that the edges of the contacts stay in place.
    UnloadingStiffness "unloading-stiffness" "K_u" "N/m" "unloading stiffness"
        (ContactRadii(("equivalent_modulus", |modulus| 2.0 * modulus)))
        "Stiffness at the start of elastic unloading, 2 E times the sum of contact radii.";
    /// Needs the equivalent shear modulus.
    TangentialStiffness "tangential-stiffness" "K_t" "N/m" "tangential stiffness"
        (ContactRadii(("equivalent_shear_modulus", |modulus| 8.0 * modulus)))
        "Tangential stiffness in full stick (Mindlin), 8 G times the sum of contact radii.";
    /// Needs the thermal conductivity.
    ThermalConductance "thermal-conductance" "C_t" "W/K" "thermal conductance"
        (ContactRadii(("thermal_conductivity", |k| 2.0 * k)))
        "Thermal conductance of contacts far from each other, 2 k times the sum of contact radii.";
    /// Needs the electrical resistivity.
    ElectricalConductance "electrical-conductance" "C_e" "S" "electrical conductance"
        (ContactRadii(("electrical_resistivity", |rho| 2.0 / rho)))
        "Electrical conductance of contacts far from each other, 2/rho times the sum of contact \
        radii.";
    ThermalConductancePerArea "thermal-conductance-per-area" "C_t/A_n" "W/m2/K"
        "thermal conductance per area" (PerNominalArea(ThermalConductance))
        "Thermal conductance over the nominal area.";
    ElectricalConductancePerArea "electrical-conductance-per-area" "C_e/A_n" "S/m2"
        "electrical conductance per area" (PerNominalArea(ElectricalConductance))
        "Electrical conductance over the nominal area.";
    MeanPressure "mean-pressure" "F/A" "Pa" "mean contact pressure" (Ratio(Force, Area))
        "Force over the real contact area.";
    LnForce "ln-force" "ln F" "ln N" "logarithm of the force" (Logarithm(Force))
        "Natural logarithm of the absolute force in newtons, also where the force itself \
        underflows.";
    LnArea "ln-area" "ln A" "ln m2" "logarithm of the real contact area" (Logarithm(Area))
        "Natural logarithm of the absolute real contact area in square metres, also where the \
        area itself underflows.";
    /// Negative shares belong to models that subtract a part of their law.
    ElasticShare "elastic-share" "F_e/F" ""
        "elastic share of the force" (RegimeShare(Regime::Elastic))
        "Share of the force on elastic asperities.";
    ElasticPlasticShare "elastic-plastic-share" "F_ep/F" ""
        "elastic-plastic share of the force" (RegimeShare(Regime::ElasticPlastic))
        "Share of the force on elastic-plastic asperities.";
    PlasticShare "plastic-share" "F_p/F" ""
        "plastic share of the force" (RegimeShare(Regime::Plastic))
        "Share of the force on plastic asperities.";
    GapConductancePerArea "gap-conductance-per-area" "h_g" "W/m2/K"
        "conductance of the gas per area" (Gap)
        "Thermal conductance of the gas over the nominal area, k_g/(gap + gas parameter) between \
        the mean planes; of whole-surface models with the mean open gap, times the open share of \
        the area.";
    JointConductancePerArea "joint-conductance-per-area" "h_j" "W/m2/K"
        "conductance of the joint per area" (Gap)
        "Thermal conductance of the contacts and of the gas over the nominal area.";
    PressureFlowFactorX "pressure-flow-factor-x" "phi_x" "" "pressure flow factor along x" (Flow)
        "Mean flow along x, the direction of sliding, under a pressure gradient, over that \
        between smooth surfaces at the same film.";
    PressureFlowFactorY "pressure-flow-factor-y" "phi_y" "" "pressure flow factor along y" (Flow)
        "Mean flow across the direction of sliding under a pressure gradient, over that between \
        smooth surfaces at the same film.";
    ShearFlowFactor "shear-flow-factor" "phi_s" "" "shear flow factor" (Flow)
        "Additional flow that sliding rough surfaces carry, over half the sliding speed times \
        sigma; positive if the first surface moves.";
    FrictionFlowFactor "friction-flow-factor" "phi_f" "" "friction factor of the film" (Flow)
        "Film times the mean of 1/(local gap), gaps below a cut-off left out: the mean shear \
        stress over that of smooth surfaces.";
    FrictionShearFactor "friction-shear-factor" "phi_fs" "" "friction shear factor" (Flow)
        "Correction of the mean shear stress on the surfaces by their roughness, in (phi_f +- \
        phi_fs) times viscosity times sliding speed over film.";
    FrictionPressureFactor "friction-pressure-factor" "phi_fp" "" "friction pressure factor" (Flow)
        "Factor of the mean shear stress by a pressure gradient, half the film times the gradient.";
    HydraulicGapX "hydraulic-gap-x" "h_x" "m" "hydraulic gap along x" (Map)
        "Even gap that lets as much fluid pass along the rows of the scan as the gap of the \
        contact, 0 where no open path is left.";
    HydraulicGapY "hydraulic-gap-y" "h_y" "m" "hydraulic gap along y" (Map)
        "Even gap that lets as much fluid pass along the columns of the scan as the gap of the \
        contact, 0 where no open path is left.";
    EffectiveMediumGap "effective-medium-gap" "h_m" "m"
        "hydraulic gap of the effective medium" (Map)
        "Estimate of the hydraulic gap from the distribution of the gap alone (Bruggeman), 0 \
        where half of the area or more is closed.";
    Leak "leak" "m" "kg/s" "leak" (Seal)
        "Mass flow through the seal of the scene, whose faces the scan stands for; of a liquid \
        without a density the volume flow.";
    Approach "approach" "delta" "m" "approach of the bodies" (Bodies)
        "How far curved bodies have approached from where they would first touch, the rough one \
        at the mean of its asperity heights.";
    ApproachBeyondHertz "approach-beyond-hertz" "delta-delta_H" "m"
        "approach beyond smooth bodies" (Bodies)
        "Approach of curved bodies less that of smooth ones at the same load.";
    PeakPressure "peak-pressure" "p_0" "Pa" "peak pressure" (Bodies)
        "Largest pressure between curved bodies, averaged over many asperities.";
    PeakPressureRatio "peak-pressure-ratio" "p_0/p_H" "" "peak pressure over Hertz'" (Bodies)
        "Peak pressure over the peak pressure of smooth bodies at the same load.";
    AxisX "axis-x" "a" "m" "half axis of the patch along x" (Bodies)
        "Half axis of the patch of curved bodies along x, by the mean square of x with the \
        pressure as weight: Hertz' for smooth bodies.";
    AxisY "axis-y" "b" "m" "half axis of the patch along y" (Bodies)
        "The same along y; of a line contact half its length.";
    EffectiveRadius "effective-radius" "a*" "m" "effective radius of the patch" (Bodies)
        "Radius of a circular patch by Greenwood and Tripp, 3 pi/4 times the integral of p r over \
        that of p.";
    CentralSeparation "central-separation" "d_0" "m" "separation in the middle" (Bodies)
        "Separation in the middle of the patch of curved bodies, from the mean of the asperity \
        heights.";
    CentralAreaFraction "central-area-fraction" "A/A_n(0)" ""
        "real over nominal area in the middle" (Bodies)
        "Share of real contact area in the middle of the patch of curved bodies.";
}
