//! Plausibility of a scene file: the library's findings by the keys of the file, and those of a
//! scan.

use asperity::joints::conductance::GapRoughness;
use asperity::{
    Advice, At, Check, Code, Contact, ContactError, ContactModel, DerivedNumber, Finding, Findings,
    HeightDistribution, Plausible, Quantity, Request, Severity, outside, unusual,
};
use asperity_curved::Shape;
use asperity_topography::Statistics;

use crate::evidence::KURTOSIS;
use crate::input::OF_BOTH;
use crate::keys::{CURVATURE, Field, GAP, INTERFACE, SEAL};
use crate::measured::Measured;
use crate::ranges::Points;
use crate::scene_file::SceneFile;
use crate::unknown::Unknown;

/// The range of the skewness of nearly Gaussian heights.
const SKEWNESS: [f64; 2] = [-0.8, 0.8];

/// Fields of findings about the asperities.
const ASPERITY_FIELDS: [&str; 6] = [
    "asperity_height_std",
    "asperity_radius",
    "asperity_density",
    "roughness_parameter",
    "height_std_over_radius",
    "rms_gradient",
];

/// Whether a field of the interface follows from the bodies, whose findings are of these.
fn of_bodies(field: &str) -> bool {
    Field::of(INTERFACE, field).is_some() && Field::of(OF_BOTH, field).is_none()
}

/// The unusual numbers of a section; 0 is a vacuum, or none, and a hollow radius is negative.
fn of_section<T>(section: &'static str, fields: &[Field<T>], of: Option<&T>) -> Vec<Finding> {
    let value = |field: &Field<T>| (field.get)(of?).map(f64::abs).filter(|value| *value > 0.0);
    let found = fields.iter().filter_map(|field| unusual(field.name, value(field)?));
    found.map(|found| found.within(section)).collect()
}

impl SceneFile {
    /// Unusual values of the scene, of each body by its own name, and of a scan.
    #[must_use]
    pub fn findings(&self) -> Findings {
        let spec = &self.spec;
        let of_area =
            |found: &Finding| found.field == "nominal_area" || found.code == Code::FewAsperities;
        let is_own = |found: &Finding| self.bodies().is_empty() || !of_bodies(&found.field);
        let mut of_scene: Vec<Finding> = self.scene.findings().into_iter().collect();
        of_scene.retain(|found| is_own(found) && !(spec.curvature.is_some() && of_area(found)));
        let (of_asperities, of_scene): (Vec<_>, Vec<_>) =
            of_scene.into_iter().partition(|found| ASPERITY_FIELDS.contains(&&*found.field));
        let mut found: Vec<Finding> = self.warnings.iter().cloned().chain(of_scene).collect();
        let given = self.unusual_given();
        if !given.is_empty() {
            // The asperities follow from these numbers.
            found.retain(|found| found.code != Code::FewAsperities);
            found.extend(given);
        } else if self.no_asperities().is_none() {
            match spec.follows_from() {
                None => found.extend(of_asperities),
                Some(numbers) => {
                    let first = of_asperities.into_iter().next();
                    found.extend(first.and_then(Finding::with_stated_unit).map(|found| {
                        let found = found.from_origin(format!("asperities from {numbers}"));
                        found.advice("check these numbers and their units")
                    }));
                }
            }
        }
        let offset = spec.surface.mean_plane_offset;
        found.extend(offset.and_then(|offset| unusual("mean_plane_offset", offset)));
        found.extend(of_section("gap", GAP, spec.gas.as_ref()));
        if matches!(spec.heights.distribution, HeightDistribution::Gaussian) {
            let skewed = spec
                .surfaces()
                .filter_map(|(section, one)| Some(one.drawing()?.skewed()?.within(section)));
            found.extend(skewed);
        }
        found.extend(self.of_bodies());
        found.extend(self.missing_hardness());
        found.extend(of_section("seal", SEAL, spec.seal.as_ref()));
        found.extend(of_section("curvature", CURVATURE, spec.curvature.as_ref()));
        found.extend(self.of_outline());
        found.extend(self.measured.iter().flat_map(|measured| self.scan_findings(measured)));
        self.judge_ends(&mut found);
        let found = self.accepted(found.into_iter().collect()).into_iter();
        let found = found.filter(|found| !self.warnings.contains(found));
        found.filter_map(|found| self.without_stated_unit(found)).collect()
    }

    /// Judges numbers that are written as ranges at both ends: what is unusual in the middle stays
    /// where it is at both.
    fn judge_ends(&self, found: &mut Vec<Finding>) {
        let is_size = |found: &Finding| found.code == Code::UnusualSize;
        let is_in = |all: &[Finding], one: &Finding| all.iter().any(|of| of.field == one.field);
        for (input, range) in &self.ranges {
            let ends = range.ends.map(|value| {
                let made = self.with_inputs([(*input, value)]);
                let made = made.map(|made| Self { ranges: vec![], ..made }.findings());
                made.into_iter().flatten().filter(is_size).collect::<Vec<_>>()
            });
            found.retain(|one| !is_size(one) || ends.iter().all(|end| is_in(end, one)));
            for (end, of_end) in ["lower", "upper"].into_iter().zip(ends) {
                for new in of_end {
                    if !is_in(found, &new) {
                        found.push(new.from_origin(format!("{end} end of {}", range.name)));
                    }
                }
            }
        }
    }

    /// A finding where the nominal area is not that of the seal.
    fn of_outline(&self) -> Option<Finding> {
        let area = self.spec.seal?.area().filter(|_| self.spec.curvature.is_none())?;
        let (given, advice) = (
            self.spec.nominal_area,
            "the area of [seal] is another one: leave nominal_area out, which follows from it",
        );
        let found = outside("nominal_area", given, [0.95 * area, 1.05 * area])?;
        found.with_stated_unit().map(|found| found.advice(advice).implausible(false))
    }

    /// The unusual ones among the numbers of the surfaces from which their asperities follow.
    fn unusual_given(&self) -> Vec<Finding> {
        let is_pair = self.spec.counterface.is_some();
        let given = self.spec.surfaces().flat_map(|(section, one)| {
            let follows = is_pair || one.roughness().is_none_or(|one| one.way.is_of_surface());
            let numbers = if follows { one.numbers() } else { vec![] };
            numbers.into_iter().filter_map(move |(key, value)| {
                let drawn = one.drawing().map(|drawing| drawing.unusual(key, value));
                let found = drawn.unwrap_or_else(|| unusual(key, value))?;
                Some(if is_pair { found.within(section) } else { found })
            })
        });
        given.collect()
    }

    /// Unusual values of the bodies; those of two bodies of one material once.
    fn of_bodies(&self) -> Vec<Finding> {
        let mut kept: Vec<Finding> = vec![];
        for (body, section) in self.bodies().iter().zip(["body[1]", "body[2]"]) {
            for new in body.findings() {
                let same = |known: &&mut Finding| {
                    let key = known.field.rsplit('.').next();
                    key == Some(&*new.field) && known.value.to_bits() == new.value.to_bits()
                };
                match kept.iter_mut().find(same) {
                    Some(known) => known.also.push(section.into()),
                    None => kept.push(new.within(section)),
                }
            }
        }
        kept
    }

    /// The finding without a likely unit if the number was given with its unit; another number that
    /// has one is a warning.
    fn without_stated_unit(&self, found: Finding) -> Option<Finding> {
        if !self.origin.as_ref().is_some_and(|origin| origin.is_stated(&found.field)) {
            let is_guess = found.likely_unit.is_some() && found.severity == Severity::Note;
            return Some(if is_guess { found.severity(Severity::Warning) } else { found });
        }
        let found = found.with_stated_unit()?;
        let is_implausible = found.is_implausible() && found.excess() > 10.0;
        Some(found.implausible(is_implausible))
    }

    /// One finding for each cause, without those that the scene accepts.
    #[must_use]
    pub fn accepted(&self, found: Findings) -> Findings {
        found.by_cause().silenced(&self.spec.accept)
    }

    /// The roughness of the gap for correlations of its conductance: of the scan or, without one,
    /// of an isotropic Gaussian surface with these asperities.
    #[must_use]
    pub fn gap_roughness(&self) -> GapRoughness {
        let measured = self.measured.as_deref().map(|measured| &measured.statistics);
        let moments = measured.map(|statistics| statistics.moments.profile);
        GapRoughness::of(&moments.unwrap_or_else(|| self.scene.surface.moments()))
    }

    /// The derived numbers of the scene and, for a model, at a separation or load, with findings;
    /// the numbers that are known within ranges come first, and others of the scene have the ends
    /// that follow from these. Ends of answers are searched, as a curve has them.
    ///
    /// # Errors
    /// The errors of [`Check::at`].
    pub fn check(&self, place: Option<(&dyn ContactModel, At)>) -> Result<Check, ContactError> {
        let points = self.points()?;
        let mut check = points.middle.answered(place)?;
        // A model has the curved bodies of the middle.
        let flat = place.filter(|_| self.shape().is_none());
        let all = points.all.iter().map(|point| point.answered(flat));
        let all = all.collect::<Result<Vec<_>, _>>()?;
        let of_scene = points.middle.answered(None)?;
        for number in &mut check.numbers {
            if of_scene.number(&number.name).is_some() {
                let found = all.iter().filter_map(|point| point.number(&number.name));
                number.ends = Unknown::spanned(number.value, found);
            }
        }
        let unknowns = self.unknowns_between()?;
        let is_given = |of: &DerivedNumber| unknowns.iter().any(|one| one.name == of.name);
        if self.scene.pair.is_some() {
            for number in check.numbers.iter_mut().filter(|number| is_given(number)) {
                number.name = format!("pair_{}", number.name).into();
            }
        }
        check.numbers.retain(|number| !is_given(number));
        check.numbers.splice(0..0, unknowns.iter().map(Unknown::derived));
        let asperities = place.is_none_or(|(model, _)| model.validity().asperities);
        check.extend(self.findings().for_asperities(asperities));
        let found = all.iter().flat_map(|one| one.findings.iter());
        check.extend(Points::worst(&check.findings, found));
        check.findings = self.accepted(check.findings);
        Ok(check)
    }

    /// The relative radii of curved bodies in place of the nominal area.
    fn add_bodies(&self, check: &mut Check) {
        let Some(shape) = self.shape() else { return };
        check.numbers.retain(|one| !["nominal_area", "asperities"].contains(&&*one.name));
        let found = std::mem::take(&mut check.findings).into_iter();
        check.findings = found.filter(|found| found.field != "nominal_area").collect();
        let radii = match shape {
            Shape::Point { radius_x, radius_y } => {
                vec![("radius_x", radius_x), ("radius_y", radius_y)]
            }
            Shape::Line { radius, .. } => vec![("radius_x", radius)],
        };
        for (name, radius) in radii {
            check.add_number(name, radius, "m", "relative radius: 1/R = 1/R1 + 1/R2");
        }
    }

    /// The numbers of the scene and of a model at a place, with findings of the answer; these may
    /// be consequences of an implausible input, of which there are none then.
    fn answered(&self, place: Option<(&dyn ContactModel, At)>) -> Result<Check, ContactError> {
        let mut check = match place {
            Some((model, at)) if self.shape().is_some() => {
                let request = Request::new([Quantity::Area, Quantity::Contacts]);
                let mut check = Check::of(&self.scene)?;
                check.extend(model.compile(&self.scene, &request)?.notes(&[at]));
                self.add_bodies(&mut check);
                return Ok(check);
            }
            Some((model, at)) => Check::at(model, &self.scene, at)?,
            None => Check::of(&self.scene)?,
        };
        self.add_bodies(&mut check);
        let valid = place.is_some() && !self.findings().are_implausible();
        let of_answer = std::mem::take(&mut check.findings).into_iter();
        check.findings = of_answer.filter(|found| valid && found.model.is_some()).collect();
        if let Some(Measured { statistics, pixel_size, .. }) = self.measured.as_deref() {
            let moments = statistics.moments.profile;
            let slope = (2.0 * moments.m2).sqrt();
            for (name, value, unit, meaning) in [
                ("measured_height_std", statistics.sq, "m", "Sq"),
                ("measured_skewness", statistics.ssk, "", "Ssk"),
                ("measured_kurtosis", statistics.sku, "", "Sku, 3 for Gaussian heights"),
                ("measured_slope", slope, "", "rms gradient of the scan"),
                ("measured_bandwidth", moments.bandwidth(), "", "of the measured profiles"),
                ("pixel_size", *pixel_size, "m", "of the scan"),
            ] {
                check.add_number(name, value, unit, meaning);
            }
            check.extend(self.below_a_pixel(&check, *pixel_size));
        }
        Ok(check)
    }

    /// Unusual results of a model at these separations or loads; none if an input is implausible,
    /// of which they may be a consequence. A `contact` of the model on this scene is not compiled
    /// again.
    #[must_use]
    pub fn judge(
        &self,
        model: &dyn ContactModel,
        contact: Option<&dyn Contact>,
        places: &[At],
    ) -> Findings {
        let known = self.findings().for_asperities(model.validity().asperities);
        // Of curved bodies, what a contact notes stands in its answers.
        match known.are_implausible() || self.shape().is_some() {
            true => Findings::default(),
            false => self.accepted(Check::answers(model, &self.scene, contact, places)),
        }
    }

    /// A warning if one body has a hardness and the other has none, which is probably an omission.
    fn missing_hardness(&self) -> Option<Finding> {
        let elastic = |body: &asperity::Body| body.hardness.or(body.yield_strength).is_none();
        let [first, second] = self.bodies() else { return None };
        let (k, body) = match (elastic(first), elastic(second)) {
            (true, false) => (1, first),
            (false, true) => (2, second),
            _ => return None,
        };
        let modulus = body.youngs_modulus;
        let finding = Finding::warning(Code::NoHardness, "youngs_modulus", modulus)
            .unit("Pa")
            .fact(format!("body[{k}] has neither hardness nor yield_strength"))
            .advice("only elastic models work if it is the softer one, which is assumed of the other body or of the one with the lower youngs_modulus");
        // No warning for rubber on glass.
        (modulus > 1e9).then(|| finding.within(&format!("body[{k}]")))
    }

    fn scan_findings(&self, Measured { statistics, pixel_size, .. }: &Measured) -> Vec<Finding> {
        let mut found = vec![];
        // Outliers would be part of measured heights.
        let clean = !statistics.outliers.matter() && self.no_asperities().is_none();
        if clean && matches!(self.scene.heights, HeightDistribution::Gaussian) {
            let advice = "the heights are not Gaussian; use heights = \"measured\" (of one areal scan), { skewness = .. } or a table of heights";
            found.extend(not_gaussian(statistics).map(|(field, value, usual)| {
                Finding::warning(Code::NotGaussian, field, value).usual(usual).advice(advice)
            }));
        }
        found.extend(statistics.unusual_slope(*pixel_size));
        found
    }

    /// A warning if contacts are smaller than a pixel of the scan.
    fn below_a_pixel(&self, check: &Check, pixel: f64) -> Option<Finding> {
        let radius = check.number("contact_radius")?;
        let found = Finding::warning(Code::BelowAPixel, "contact_radius", radius)
            .usual([pixel, f64::INFINITY])
            .fact(format!(
                "contact_radius is {radius:.3e} m, less than a pixel of the scan ({pixel:.3e} m)"
            ))
            .advice("the result depends on roughness below the pixel size")
            .to_do(Advice::CompareCutOffs)
            .unit("m");
        (radius < pixel).then_some(found)
    }
}

/// The number by which the heights of a scan are far from Gaussian, with its usual range.
fn not_gaussian(statistics: &Statistics) -> Option<(&'static str, f64, [f64; 2])> {
    let Statistics { ssk, sku, .. } = *statistics;
    let shape = [("measured_skewness", ssk, SKEWNESS), ("measured_kurtosis", sku, KURTOSIS)];
    shape.into_iter().find(|(_, value, [from, to])| !(from..=to).contains(&value))
}
