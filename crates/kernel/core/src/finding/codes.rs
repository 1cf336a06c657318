//! The codes of findings: what each means, when it is harmless, what to do, and how it behaves
//! beside others.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::text::{nearest_hint, nearest_name};

/// What is known of a code.
#[derive(Debug)]
struct Entry {
    name: &'static str,
    /// Meaning with the threshold, when it is harmless, what to do.
    texts: [&'static str; 3],
    /// Whether it concerns only asperities.
    of_asperities: bool,
    /// Whether it is a limit of one model.
    of_model: bool,
    /// The codes with the same cause that it replaces.
    hides: &'static [Code],
}

impl Entry {
    const fn new(name: &'static str, texts: [&'static str; 3]) -> Self {
        Self { name, texts, of_asperities: false, of_model: false, hides: &[] }
    }
}

macro_rules! codes {
    ($($code:ident $name:literal $meaning:literal $harmless:literal $remedy:literal
        $({ $($key:ident: $value:expr),* })?;)*) => {
        /// The code of a finding.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $(#[doc = $meaning] $code),* }

        impl Code {
            /// All codes, sorted by their names.
            pub const ALL: &'static [Self] = &[$(Self::$code),*];
        }

        static ENTRIES: &[Entry] = &[$(Entry {
            $($($key: $value,)*)?
            ..Entry::new($name, [$meaning, $harmless, $remedy])
        }),*];
    };
}

impl Code {
    fn entry(self) -> &'static Entry {
        &ENTRIES[self as usize]
    }

    /// Its name, in lower case with dashes: `few-contacts`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// What its findings mean, with the threshold; when they are harmless; what to do.
    #[must_use]
    pub fn texts(self) -> [&'static str; 3] {
        self.entry().texts
    }

    /// Whether its findings concern only asperities, which [models of the whole
    /// surface](crate::Validity::asperities) do not use.
    #[must_use]
    pub fn is_of_asperities(self) -> bool {
        self.entry().of_asperities
    }

    /// Whether its findings are a limit of one model.
    #[must_use]
    pub fn is_of_model(self) -> bool {
        self.entry().of_model
    }

    /// Whether who accepts findings of this code accepts those of another: contacts that merge or a
    /// load beyond full contact have more area than there is, too.
    #[must_use]
    pub fn accepts(self, other: Self) -> bool {
        let merges = matches!(self, Self::Crowded | Self::BeyondFullContact);
        self == other || merges && other == Self::AreaAboveNominal
    }

    /// Whether a finding of another code has the same cause and is replaced by one of this code.
    #[must_use]
    pub fn hides(self, other: Self) -> bool {
        self.entry().hides.contains(&other)
    }

    /// The code of this name.
    ///
    /// # Errors
    /// A message with the nearest name, where there is no such code.
    pub fn named(name: &str) -> Result<Self, String> {
        Self::ALL.iter().copied().find(|code| code.name() == name).ok_or_else(|| {
            let near = nearest_hint(nearest_name(name, Self::ALL.iter().map(|code| code.name())));
            format!("{name:?} is no code of a finding{near}: see the list of findings")
        })
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Serialize for Code {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

// A line a code: its name, what it means, when it is harmless, what to do.
codes! {
    AboveHardness "above-hardness" "The mean pressure on the real area exceeds 1.5 times the hardness, by a model that does not limit the pressure." "Never: the contacts would yield, and the real area is larger." "Use a model of yielding asperities." { of_model: true };
    Adhesion "adhesion" "As a note: the limit of adhesion of small, hard asperities (Tabor parameter up to 0.1) or of large, soft ones (from 5) fits the scene. As a warning: a force or tangent of a model with adhesion is negative." "Where `adhesion_parameter` is above 10, roughness hides adhesion; a negative force is a tension, and a negative tangent matters under a given load only." "Use the model that the note names; under a given load, use states with a positive tangent.";
    Anisotropic "anisotropic" "The rms slopes along and across the lay differ by more than a factor of 2, and the models assume isotropic asperities." "Near the limit: at a slope ratio of 2 and a plasticity index of 2, a model of upright asperities underestimates the area by 15 %." "Compare with boundary elements on the scan." { of_asperities: true };
    AreaAboveNominal "area-above-nominal" "The real area by the model exceeds the nominal area, because the model neglects that contacts merge." "Never for the rows concerned: no contact has so large an area." "Use boundary elements or a theory of the whole surface.";
    Atomic "atomic" "The critical interference is below 0.3 nm, the distance of two atoms, so that contacts are plastic from the onset of contact; or a gap of boundary elements is; or the tightest gap of a leak is below 1 nm, where no law of flow is known." "With models of yielding asperities, which take these contacts as plastic; for an order of magnitude of a leak." "Use a model of yielding asperities, not an elastic one; take such a gap as closed.";
    BadValue "bad-value" "In the checks of a model's laws, a law has a value that is not a finite number." "Never: integrals over the law fail." "Correct the law.";
    BelowAPixel "below-a-pixel" "The mean contact radius is smaller than a pixel of the scan, and the result depends on roughness below the pixel size." "If the results hardly change between several cut-offs." "Compare several cut-offs, or measure with a smaller pixel size.";
    BeyondFit "beyond-fit" "Asperities beyond the fitted range of the law carry more than 2 % of the force; or, at more than 2 % of the pressures, the tightest gap of a leak of gas has an inverse Knudsen number below 0.01, the least of the fit." "If such contacts are fully plastic, as the model assumes beyond the range." "Compare with another model of yielding asperities, or with boundary elements on a scan.";
    BeyondFullContact "beyond-full-contact" "The mean pressure on the nominal area exceeds the hardness or, without a hardness, that on the real area exceeds the equivalent modulus." "Never: full contact carries no more than the hardness, and above the equivalent modulus small strains do not hold." "Check the units of load, nominal area, modulus and hardness." { of_model: true, hides: &[Code::AboveHardness, Code::AreaAboveNominal, Code::Crowded, Code::Yields] };
    Cancelled "cancelled" "Positive and negative parts of a quantity cancel: its condition number exceeds 100." "If the inputs have enough digits: their relative errors grow by up to the condition number." "Take the error from the message, or choose another separation or load.";
    Channel "channel" "The file has several surfaces, of which the first is read." "If the first surface is the one to use." "Choose a surface by its name or number with `channel`.";
    Correlation "correlation" "The relative pressure is outside 1e-6 to 0.023 (`cmy`) or 1e-5 to 0.012 (`mikic`), or the plasticity index is below 1 (`cmy`) or at least 1 (`mikic`)." "Only slightly outside the range of pressures, where the power law is extrapolated." "Use `cmy` for plastic contacts, `mikic` for elastic ones, or a model.";
    Crowded "crowded" "The real area exceeds 0.1 of the nominal area: contacts merge, and asperities are not independent." "For an estimate just above 0.1; never above 1." "Use boundary elements or a theory of the whole surface." { hides: &[Code::AreaAboveNominal] };
    CurvatureFollowsSampling "curvature-follows-sampling" "The fourth moment m4 of the profile is more than 4 times that at half the resolution: radius and density depend on the pixel size." "Never for models of asperities." "Smooth the scan with `smooth`, or use a pixel size suited to the contact.";
    Deep "deep" "The interference exceeded by the asperities that carry the top 1 % of the load is above 0.3 of the asperity radius." "Never: laws of spherical asperities do not hold at such an interference." "Use boundary elements or a theory of the whole surface, or check the units of load, nominal area and asperities.";
    DefaultModel "default-model" "No model is named, and the default without a hardness ignores yielding." "If the contact is elastic, as of rubber." "Set `hardness` or `yield_strength`, with which the default has yielding, or name a model.";
    EnergyGain "energy-gain" "Opening returns more energy than closing takes, or asperities that recover by more than their interference create over 1 % of the work of loading." "For force and stiffness in first loading; never for work and loss." "Use another unloading law or another model.";
    EstimatorsDisagree "estimators-disagree" "Density, radius or height std of the asperities differ by more than a factor of 2 between spectral moments and summits." "If the results of both estimators agree." "Compare the results of both values of `estimator`." { of_asperities: true };
    ExampleValues "example-values" "Materials and nominal area of the written scene are examples, steel on steel." "If the bodies are of steel." "Replace them.";
    Extrapolated "extrapolated" "The load or the surface is outside of those solved by boundary elements, or differs too much between them: the answer is taken from the nearest ones, without an interval unless the load alone is outside, by up to 30 times lighter. Of a load, the ratio to a model at the nearest one is kept." "If the scene is only slightly outside." "Use a load in the range, or compare with boundary elements on a scan.";
    Factor "factor" "The header of the text states a factor, by which its heights are multiplied." "If the heights have the right size." "Compare Sq with that of the instrument; `surface --header` shows how the header is understood.";
    FewAsperities "few-asperities" "The nominal area holds fewer than 300 asperities (a note) or 30 (a warning), too few for an average." "For the average over many such areas, not for a single one." "Check `nominal_area` and `asperity_density`, or use boundary elements on a scan of the area." { of_asperities: true, hides: &[Code::FewContacts] };
    FewContacts "few-contacts" "Fewer than 30 asperities touch at a load or pressure or, in a joint, fewer than one touches on average." "For the average over many samples; the scatter of a single one exceeds the differences between models." "Increase the load or the nominal area, or state the scatter with the result.";
    FewPatches "few-patches" "The boundary-element contact has fewer than 30 patches, so that one map does not represent its surface." "If only this map is of interest, not other samples of its surface." "Average several maps, use a larger map or, where the patches have not merged, raise the load.";
    FewPixels "few-pixels" "Fewer than 100 pixels are in contact, and the grid does not resolve the area." "Never for the area." "Refine the grid or raise the load.";
    Filled "filled" "Missing points of the scan are filled with harmonic heights, which are smoother than the surface and have no summits." "If few points are filled; at most 5 % are." "Leave `fill_missing` out for models of asperities, which do not need all points.";
    FitMisses "fit-misses" "Asperities with interferences of 1.2 to 20 w_c carry more than 20 % of the force, where the fit of the law deviates from finite elements." "If errors of 9 to 17 % of the force and 5 to 12 % of the area are acceptable." "Use a model of yielding asperities." { of_model: true };
    GaussianFactors "gaussian-factors" "The flow factors are those of Gaussian surfaces, and the heights of the scene are not Gaussian." "For a film much thicker than the surfaces are rough, where all factors approach those of smooth surfaces." "Use the factors as an estimate; boundary elements compute the flow through the gap of a scan.";
    InterpolationError "interpolation-error" "Between the nodes of an exported table, the interpolation error of the pressure may exceed 10 %." "Never for a table that a finite-element program interpolates." "Add nodes, or narrow the range.";
    Inverted "inverted" "The SUR file marks its heights as inverted, and they are turned over." "If the skewness has the expected sign." "Check the sign of the skewness, because programs differ here.";
    LawStart "law-start" "In the checks of a model's laws, a law does not start as declared: at the onset, with the value 0, or with the force by Hertz." "If the model claims no such limit." "Correct the law, or withdraw the claim.";
    LeftOut "left-out" "Models are left out (a note), or models and correlations of conductance (a warning), because an input or a quantity is missing." "If these models are not needed." "Add the missing input that the message names.";
    Level "level" "Removing a plane or a quadratic form from a periodic surface makes its edges differ." "Never for slopes and curvatures at the edges." "Use `level = \"mean\"`.";
    LikelyUnit "likely-unit" "A separation or retreat exceeds 1000 `asperity_height_std` (in metres also 0.1 m), or is below 0.001 of it and looks like metres; or a shift, or roughness or gas of a conductance is in another unit." "If the number is right." "Write lengths with their unit, for example 2um.";
    Limits "limits" "A fitted parameter stops at a limit: a bound, or a value beyond which the scene is refused." "If the limit is a known bound of the parameter." "Widen the bounds, or check the data and their units.";
    LongWaves "long-waves" "The longest waves of a generated surface do not fit on its side, and only shorter ones are made." "If the longest waves do not matter." "Use more pixels or wider ones, or shorten the longest wave.";
    Mask "mask" "The mask of the Gwyddion file marks points, which are read as missing." "If the mask covers invalid points." "Remove the mask to keep these points.";
    Negative "negative" "A quantity of a model without adhesion is negative: the negative part of its law exceeds the positive part." "Never: the value has no physical meaning." "Use another model, or another variant of it.";
    NoAsperities "no-asperities" "The estimator finds no asperities in the scan, and models of asperities have no result." "With boundary elements and theories of the whole surface, which need no asperities." "Use boundary elements, or follow the reason: another `estimator` or pixel size may find asperities." { of_asperities: true };
    NoContact "no-contact" "No asperity touches, and logarithms, shares and the mean pressure are undefined." "If rows without contact are expected." "Choose a smaller separation.";
    NoEvidence "no-evidence" "The model `best` answers by a model, without an interval, as no surface like this one was solved by boundary elements, or the quantity is not determined there." "If the model named is known to hold." "Change the load to one that was solved, compare with boundary elements on a scan, or compare several models.";
    NoHardness "no-hardness" "One of two bodies, with a Young's modulus above 1e9 Pa, has neither `hardness` nor `yield_strength`, and the other has one of them; or, of an answer by `best`, both bodies have none." "If the other body is the softer one, or if nothing yields; if this body has the lower modulus, only elastic models work." "Set `hardness` or `yield_strength` of the body.";
    NoSecondEstimator "no-second-estimator" "Only one of spectral moments and summits gives asperities, and the two cannot be compared." "If the surface is nearly isotropic and Gaussian." "Follow the reason in the message, or compare with boundary elements on the scan." { of_asperities: true };
    NoTension "no-tension" "A load is negative, and the model carries no tension." "Never: these rows have no value." "Use a model with adhesion.";
    NoValue "no-value" "Answers, models, loads or a work have no value, and their cells are blank; the message gives the reason." "If these values are not needed." "Follow the reason: another separation, load, preload or retreat, a missing input, or another model.";
    NotConverged "not-converged" "The search of a fit did not converge, and the values are the best that it found." "If the residuals are small enough." "Narrow the bounds, or free fewer parameters.";
    NotGaussian "not-gaussian" "The skewness of the scan is outside -0.8 to 0.8 or its kurtosis outside 2 to 5, but the heights of the scene are Gaussian; or the kurtosis of a scan is above 30; or surfaces of the finish have a skewness, but the heights of the scene are Gaussian." "If valleys, which do not touch, cause the skewness." "Set `heights = \"measured\"`, which needs an areal scan of one surface or two aligned scans, or a skewness; mark points far from the others as missing.";
    NotMonotone "not-monotone" "In the checks of a model's laws, the force falls as the interference grows; a warning if the model claims a monotone force." "If several separations may carry one load, as of models that do not claim a monotone force." "Correct the law, or withdraw the claim.";
    OpenSeam "open-seam" "The edges of a scan declared periodic, or in Rust of a map without a boundary, differ by a step of 3 times that between neighbours or more." "If the surface has this step." "Remove `periodic` if the step is not real; in Rust declare a boundary, or use the periodic component of the map.";
    OtherJoint "other-joint" "Models of pairs stand beside models of one rough surface: `asperity_radius` is the radius of each of two surfaces for the former, and the equivalent radius of both for the latter." "Always if the two joints are to be compared." "Describe the second surface by `counterface`; both kinds of models then have the same joint.";
    Outliers "outliers" "Points far outside the neighbouring heights have at least 5 % of m4 or of the fourth moment of the heights." "Never for radius, density and kurtosis, which describe these points." "Replace these points with `despike = true`.";
    Patch "patch" "Between curved bodies: the patch exceeds a tenth of the smaller radius, or the peak pressure 1.6 times the yield strength (hardness over 2.8 without one)." "Where the excess is small, as of a body that has hardened." "Reduce the load, or use a finite-element model of the bodies.";
    PeriodicPart "periodic-part" "The edges of the scan differ by a step of 3 times that between neighbours or more, and its periodic component is pressed." "If the scan is a part of a larger surface." "Take the edges as free for a single body, or `periodic = true` if the step is real.";
    Resampled "resampled" "The positions of the profile deviate from equal distances by more than 0.1 of a step, and its heights are interpolated linearly." "If only the height is of interest, not slopes and curvatures." "Measure at equal distances.";
    RoughnessParameter "roughness-parameter" "The product eta R Sq of the scan is outside 0.02 to 0.1, the range of rough surfaces." "For a regular surface, such as a grating." "Above the range, remove form, waviness and noise with `level`, `filter` and `smooth`; below, use a smaller pixel size." { of_asperities: true };
    ShortWaves "short-waves" "Waves shorter than 8 pixels have more than 1 % of the mean square slope, so that results depend on the grid." "If refined grids show no dependence on the grid; then models are ranked." "Set `smooth`, the shortest wave kept, to 16 pixels or more, or measure with a smaller pixel size.";
    SingleBody "single-body" "The edges of the scan match, but its slope changes there more than 5 times as much as inside, as of a ball or a cylinder: boundary elements take the scan as a single body on a free half-space." "If the scan is of a single body." "Set `periodic = true` if the surface is repeated.";
    SmoothCounterface "smooth-counterface" "The surface is described by roughness and finish, and the other surface is taken as smooth." "If the other surface is much smoother." "Write `counterface = \"smooth\"` or `\"same\"`, or describe the other surface.";
    SolutionNotUsed "solution-not-used" "The solution by boundary elements on the scan is not the answer of `best`, as its own findings make it uncertain." "If the answer of solved surfaces like this one suffices." "Correct what the message names, as by a filter of the scan or a finer one, and solve again.";
    Sticks "sticks" "The model ignores `work_of_adhesion`, but `adhesion_parameter` is below 10, or adhesion changes the area under the load of `best` by more than 5 %." "Never: adhesion changes force and area." "Use a model with adhesion." { of_model: true };
    SummitsFollowSampling "summits-follow-sampling" "The summit density is more than 2 times that at half the resolution: radius and density depend on the pixel size." "Never for models of asperities." "Smooth the scan with `smooth`, or use a pixel size suited to the contact." { of_asperities: true };
    Tabor "tabor" "The Tabor parameter is above 0.1 for the limit of small, hard asperities or below 5 for that of large, soft ones, and `adhesion_parameter` is below 10." "Between 0.1 and 5, if the model serves as one of two bounds." "Use the other limit, or both as bounds." { of_model: true };
    TakenAt "taken-at" "Numbers of the scene are known within ranges, and the answer is calculated at one point of them." "If the ends make no difference to the answer." "`--at lower` and `--at upper` calculate at the ends; `curve` and `answer`, in Python `ranges`, give both ends.";
    UndeclaredKink "undeclared-kink" "In the checks of a model's laws, a part of a law has a kink that is not declared." "For the results, which remain correct but take longer." "Declare the kink.";
    Underflow "underflow" "A quantity is too small for f64 and reads 0: the surfaces hardly touch." "If 0 is accurate enough." "Use the logarithm in the message, or the quantity `ln-force` or `ln-area`.";
    Undetermined "undetermined" "The data do not determine a parameter of a fit, as where only a combination of several has an effect." "If the parameter is not needed." "Fix one of the parameters, or measure another quantity.";
    UnusualSize "unusual-size" "A number is outside the range of materials, surfaces or joints, as the rms slope of a scan outside 5e-4 to 1, or by its size, looks like another unit." "As a note, or as a warning for an unusual material or surface." "Check the number and its unit, of a scan `unit` and `pixel_size`.";
    Waviness "waviness" "Stiffnesses of a surface that is described by a roughness, which has no wavelengths beyond `lambda_c`." "If the joint is smaller than `lambda_c`, or its surfaces are flat beyond it." "Measure the waviness, or press a scan of the whole joint with boundary elements.";
    Yields "yields" "Yielding asperities or, without asperities, pressures above the hardness carry more than 2 % (a note) or 10 % (a warning) of the force of an elastic model." "Where evidence or boundary elements on the scan show the model to be near." "See in `asperity answer` how far each model is off; use a model with yielding; with adhesion, no model has yielding, and roughness hides adhesion if `adhesion_parameter` is above 10." { of_model: true };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_sorted_and_have_whole_texts() {
        assert!(Code::ALL.is_sorted_by(|a, b| a.name() < b.name()));
        for code in Code::ALL {
            assert_eq!(Code::named(code.name()), Ok(*code));
            for text in code.texts() {
                assert!(text.len() > 1 && text.ends_with('.'), "{code}: {text:?}");
                assert_eq!(text.matches('`').count() % 2, 0, "{code}: {text:?}");
            }
        }
        let refused = Code::named("few-contact").unwrap_err();
        assert!(refused.contains("(the nearest is \"few-contacts\")"), "{refused}");
    }
}
