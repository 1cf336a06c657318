//! The table of quantities: one entry for each, and everything else follows from it.

use serde::{Deserialize, Serialize};

use crate::Regime;

/// A property of the interface that turns the sum of the contact radii into a stiffness or a
/// conductance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum InterfaceProperty {
    Modulus,
    ShearModulus,
    ThermalConductivity,
    ElectricalResistivity,
}

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
    /// The sum of the contact radii times a property of the interface.
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
    ($($(#[$remark:meta])* $variant:ident {
        name: $name:literal, symbol: $symbol:literal, unit: $unit:literal, label: $label:literal,
        definition: $definition:literal, derivation: $derivation:expr $(,)?
    })*) => {
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

quantities! {
    Force {
        name: "force", symbol: "F", unit: "N", label: "force",
        definition: "Normal force between the surfaces, over the whole nominal area.",
        derivation: Derivation::Integral,
    }
    Area {
        name: "area", symbol: "A", unit: "m2", label: "real contact area",
        definition: "Real contact area: the sum of the areas of all contacts.",
        derivation: Derivation::Integral,
    }
    Stiffness {
        name: "stiffness", symbol: "K", unit: "N/m", label: "stiffness",
        definition: "Stiffness as the model's paper defines it: the tangent for models of upright \
            asperities, an average of asperity stiffnesses for Gao and AT.",
        derivation: Derivation::IntegralOrSlope(Quantity::Force),
    }
    Tangent {
        name: "tangent", symbol: "-dF/dd", unit: "N/m", label: "tangent stiffness",
        definition: "Fall of the force with the separation, -dF/dd, jumps of the law included; of \
            yielded boundary elements the chord between pressures up to 5 % to either side.",
        derivation: Derivation::Slope(Quantity::Force),
    }
    Pressure {
        name: "pressure", symbol: "p", unit: "Pa", label: "pressure",
        definition: "Force over the nominal area.",
        derivation: Derivation::PerNominalArea(Quantity::Force),
    }
    AreaFraction {
        name: "area-fraction", symbol: "A/A_n", unit: "", label: "real over nominal area",
        definition: "Real contact area over the nominal area.",
        derivation: Derivation::PerNominalArea(Quantity::Area),
    }
    Contacts {
        name: "contacts", symbol: "N", unit: "", label: "number of contacts",
        definition: "Number of asperities in contact.",
        derivation: Derivation::Integral,
    }
    /// Needs upright asperities with circular contacts.
    ContactRadiusSum {
        name: "contact-radius-sum", symbol: "sum a", unit: "m", label: "sum of contact radii",
        definition: "Sum of the radii a = (A/pi)^(1/2) of all contacts.",
        derivation: Derivation::Integral,
    }
    /// Small vibrations, ultrasound and modal tests measure this slope. First loading follows the
    /// tangent, which is smaller where asperities yield. For contacts with adhesion (JKR) it holds
    /// for motions so small that the edges of the contacts stay in place.
    UnloadingStiffness {
        name: "unloading-stiffness", symbol: "K_u", unit: "N/m", label: "unloading stiffness",
        definition: "Stiffness at the start of elastic unloading, 2 E times the sum of contact radii.",
        derivation: Derivation::ContactRadii(InterfaceProperty::Modulus),
    }
    /// Needs the equivalent shear modulus.
    TangentialStiffness {
        name: "tangential-stiffness", symbol: "K_t", unit: "N/m", label: "tangential stiffness",
        definition: "Tangential stiffness in full stick (Mindlin), 8 G times the sum of contact radii.",
        derivation: Derivation::ContactRadii(InterfaceProperty::ShearModulus),
    }
    /// Needs the thermal conductivity.
    ThermalConductance {
        name: "thermal-conductance", symbol: "C_t", unit: "W/K", label: "thermal conductance",
        definition: "Thermal conductance of contacts far from each other, 2 k times the sum of \
            contact radii.",
        derivation: Derivation::ContactRadii(InterfaceProperty::ThermalConductivity),
    }
    /// Needs the electrical resistivity.
    ElectricalConductance {
        name: "electrical-conductance", symbol: "C_e", unit: "S", label: "electrical conductance",
        definition: "Electrical conductance of contacts far from each other, 2/rho times the sum of \
            contact radii.",
        derivation: Derivation::ContactRadii(InterfaceProperty::ElectricalResistivity),
    }
    ThermalConductancePerArea {
        name: "thermal-conductance-per-area", symbol: "C_t/A_n", unit: "W/m2/K",
        label: "thermal conductance per area",
        definition: "Thermal conductance over the nominal area.",
        derivation: Derivation::PerNominalArea(Quantity::ThermalConductance),
    }
    ElectricalConductancePerArea {
        name: "electrical-conductance-per-area", symbol: "C_e/A_n", unit: "S/m2",
        label: "electrical conductance per area",
        definition: "Electrical conductance over the nominal area.",
        derivation: Derivation::PerNominalArea(Quantity::ElectricalConductance),
    }
    MeanPressure {
        name: "mean-pressure", symbol: "F/A", unit: "Pa", label: "mean contact pressure",
        definition: "Force over the real contact area.",
        derivation: Derivation::Ratio(Quantity::Force, Quantity::Area),
    }
    LnForce {
        name: "ln-force", symbol: "ln F", unit: "ln N", label: "logarithm of the force",
        definition: "Natural logarithm of the absolute force in newtons, also where the force \
            itself underflows.",
        derivation: Derivation::Logarithm(Quantity::Force),
    }
    LnArea {
        name: "ln-area", symbol: "ln A", unit: "ln m2", label: "logarithm of the real contact area",
        definition: "Natural logarithm of the absolute real contact area in square metres, also \
            where the area itself underflows.",
        derivation: Derivation::Logarithm(Quantity::Area),
    }
    /// Negative shares belong to models that subtract a part of their law.
    ElasticShare {
        name: "elastic-share", symbol: "F_e/F", unit: "", label: "elastic share of the force",
        definition: "Share of the force on elastic asperities.",
        derivation: Derivation::RegimeShare(Regime::Elastic),
    }
    ElasticPlasticShare {
        name: "elastic-plastic-share", symbol: "F_ep/F", unit: "",
        label: "elastic-plastic share of the force",
        definition: "Share of the force on elastic-plastic asperities.",
        derivation: Derivation::RegimeShare(Regime::ElasticPlastic),
    }
    PlasticShare {
        name: "plastic-share", symbol: "F_p/F", unit: "", label: "plastic share of the force",
        definition: "Share of the force on plastic asperities.",
        derivation: Derivation::RegimeShare(Regime::Plastic),
    }
    GapConductancePerArea {
        name: "gap-conductance-per-area", symbol: "h_g", unit: "W/m2/K",
        label: "conductance of the gas per area",
        definition: "Thermal conductance of the gas over the nominal area, k_g/(gap + gas parameter) \
            between the mean planes; of whole-surface models with the mean open gap, times the open \
            share of the area.",
        derivation: Derivation::Gap,
    }
    JointConductancePerArea {
        name: "joint-conductance-per-area", symbol: "h_j", unit: "W/m2/K",
        label: "conductance of the joint per area",
        definition: "Thermal conductance of the contacts and of the gas over the nominal area.",
        derivation: Derivation::Gap,
    }
    PressureFlowFactorX {
        name: "pressure-flow-factor-x", symbol: "phi_x", unit: "", label: "pressure flow factor along x",
        definition: "Mean flow along x, the direction of sliding, under a pressure gradient, over \
            that between smooth surfaces at the same film.",
        derivation: Derivation::Flow,
    }
    PressureFlowFactorY {
        name: "pressure-flow-factor-y", symbol: "phi_y", unit: "", label: "pressure flow factor along y",
        definition: "Mean flow across the direction of sliding under a pressure gradient, over that \
            between smooth surfaces at the same film.",
        derivation: Derivation::Flow,
    }
    ShearFlowFactor {
        name: "shear-flow-factor", symbol: "phi_s", unit: "", label: "shear flow factor",
        definition: "Additional flow that sliding rough surfaces carry, over half the sliding speed \
            times sigma; positive if the first surface moves.",
        derivation: Derivation::Flow,
    }
    FrictionFlowFactor {
        name: "friction-flow-factor", symbol: "phi_f", unit: "", label: "friction factor of the film",
        definition: "Film times the mean of 1/(local gap), gaps below a cut-off left out: the mean \
            shear stress over that of smooth surfaces.",
        derivation: Derivation::Flow,
    }
    FrictionShearFactor {
        name: "friction-shear-factor", symbol: "phi_fs", unit: "", label: "friction shear factor",
        definition: "Correction of the mean shear stress on the surfaces by their roughness, in \
            (phi_f +- phi_fs) times viscosity times sliding speed over film.",
        derivation: Derivation::Flow,
    }
    FrictionPressureFactor {
        name: "friction-pressure-factor", symbol: "phi_fp", unit: "", label: "friction pressure factor",
        definition: "Factor of the mean shear stress by a pressure gradient, half the film times the \
            gradient.",
        derivation: Derivation::Flow,
    }
    HydraulicGapX {
        name: "hydraulic-gap-x", symbol: "h_x", unit: "m", label: "hydraulic gap along x",
        definition: "Even gap that lets as much fluid pass along the rows of the scan as the gap of \
            the contact, 0 where no open path is left.",
        derivation: Derivation::Map,
    }
    HydraulicGapY {
        name: "hydraulic-gap-y", symbol: "h_y", unit: "m", label: "hydraulic gap along y",
        definition: "Even gap that lets as much fluid pass along the columns of the scan as the gap \
            of the contact, 0 where no open path is left.",
        derivation: Derivation::Map,
    }
    EffectiveMediumGap {
        name: "effective-medium-gap", symbol: "h_m", unit: "m",
        label: "hydraulic gap of the effective medium",
        definition: "Estimate of the hydraulic gap from the distribution of the gap alone \
            (Bruggeman), 0 where half of the area or more is closed.",
        derivation: Derivation::Map,
    }
    Leak {
        name: "leak", symbol: "m", unit: "kg/s", label: "leak",
        definition: "Mass flow through the seal of the scene, whose faces the scan stands for; of a \
            liquid without a density the volume flow.",
        derivation: Derivation::Seal,
    }
    Approach {
        name: "approach", symbol: "delta", unit: "m", label: "approach of the bodies",
        definition: "How far curved bodies have approached from where they would first touch, the \
            rough one at the mean of its asperity heights.",
        derivation: Derivation::Bodies,
    }
    ApproachBeyondHertz {
        name: "approach-beyond-hertz", symbol: "delta-delta_H", unit: "m",
        label: "approach beyond smooth bodies",
        definition: "Approach of curved bodies less that of smooth ones at the same load.",
        derivation: Derivation::Bodies,
    }
    PeakPressure {
        name: "peak-pressure", symbol: "p_0", unit: "Pa", label: "peak pressure",
        definition: "Largest pressure between curved bodies, averaged over many asperities.",
        derivation: Derivation::Bodies,
    }
    PeakPressureRatio {
        name: "peak-pressure-ratio", symbol: "p_0/p_H", unit: "", label: "peak pressure over Hertz'",
        definition: "Peak pressure over the peak pressure of smooth bodies at the same load.",
        derivation: Derivation::Bodies,
    }
    AxisX {
        name: "axis-x", symbol: "a", unit: "m", label: "half axis of the patch along x",
        definition: "Half axis of the patch of curved bodies along x, by the mean square of x with \
            the pressure as weight: Hertz' for smooth bodies.",
        derivation: Derivation::Bodies,
    }
    AxisY {
        name: "axis-y", symbol: "b", unit: "m", label: "half axis of the patch along y",
        definition: "The same along y; of a line contact half its length.",
        derivation: Derivation::Bodies,
    }
    EffectiveRadius {
        name: "effective-radius", symbol: "a*", unit: "m", label: "effective radius of the patch",
        definition: "Radius of a circular patch by Greenwood and Tripp, 3 pi/4 times the integral of \
            p r over that of p.",
        derivation: Derivation::Bodies,
    }
    CentralSeparation {
        name: "central-separation", symbol: "d_0", unit: "m", label: "separation in the middle",
        definition: "Separation in the middle of the patch of curved bodies, from the mean of the \
            asperity heights.",
        derivation: Derivation::Bodies,
    }
    CentralAreaFraction {
        name: "central-area-fraction", symbol: "A/A_n(0)", unit: "",
        label: "real over nominal area in the middle",
        definition: "Share of real contact area in the middle of the patch of curved bodies.",
        derivation: Derivation::Bodies,
    }
}
