//! Which model does a scene need? The simplest that agrees with a reference model, and how far each
//! model is from boundary elements.

mod advice;

use serde::Serialize;

use crate::{
    At, Check, Compared, ContactError, ContactModel, Described, Deviation, Diagnostic, Evaluation,
    Evidence, Expected, Model, Nearest, Quantity, Request, Scene, Severity,
};

/// The id of the default reference model: `ke`, or `gw` without a hardness.
///
/// ```
/// use asperity::{Interface, Scene, Surface, usual_reference};
///
/// let surface = Surface::new(3.6e-4, 1.11e8, 1e-6);
/// assert_eq!(usual_reference(&Scene::new(Interface::new(116e9, 0.31, 1e9), surface, 3e-5)), "ke");
/// assert_eq!(usual_reference(&Scene::new(Interface::elastic(1e7, 0.49), surface, 3e-5)), "gw");
/// ```
#[must_use]
pub fn usual_reference(scene: &Scene) -> &'static str {
    match scene.asperity() {
        Ok(asperity) if asperity.hardness.is_some() => "ke",
        _ => "gw",
    }
}

/// Deviations of one model from the reference.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Comparison {
    /// The model.
    pub model: Model,
    /// Largest relative deviation from the reference over all rows, for each requested quantity; or
    /// the error of the model.
    pub deviations: Result<Vec<(Quantity, f64)>, ContactError>,
    /// Parts of the model's laws, a measure of its complexity.
    pub regimes: usize,
    /// Why a model within the limit is not valid there; the reference may be invalid too.
    pub outside: Option<Diagnostic>,
    /// Largest deviation of the model from boundary elements in the solved cases nearest to the
    /// scene, if there are any.
    pub off: Option<Deviation>,
}

impl Comparison {
    /// The largest deviation of any quantity; infinite if the model failed.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let none = |_: &ContactError| f64::INFINITY;
        let largest = |all: &Vec<(Quantity, f64)>| all.iter().fold(0.0, |m: f64, (_, d)| m.max(*d));
        self.deviations.as_ref().map_or_else(none, largest)
    }
}

/// All models compared with a reference, and the simplest within a limit.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Recommendation {
    /// The reference model.
    pub reference: Model,
    /// Largest relative deviation allowed.
    pub within: f64,
    /// The first model of the comparisons that is within the limit and valid; otherwise the
    /// reference, if that is valid.
    pub simplest: Option<Model>,
    /// Models from simplest to most complex: upright asperities of one radius, random asperities,
    /// no asperities, inclined contacts; then by number of parts of the force law and by year.
    pub comparisons: Vec<Comparison>,
    /// For each separation or load, the nearest solved case, or why there is none.
    pub evidence: Vec<EvidenceAt>,
}

impl Recommendation {
    /// Removes the evidence, for a surface that differs from the solved ones in a property that a
    /// [`Scene`] does not hold; `reason` names it.
    #[must_use]
    pub fn without_evidence(mut self, reason: &str) -> Self {
        for place in &mut self.evidence {
            place.nearest = Err(Evidence::none(reason.to_string()));
            place.expected.clear();
        }
        self.comparisons.iter_mut().for_each(|found| found.off = None);
        self
    }
}

/// Evidence for a separation or load.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct EvidenceAt {
    /// The separation or load.
    pub at: At,
    /// The nearest solved case, or why there is none.
    pub nearest: Result<Nearest<'static>, ContactError>,
    /// How far the reference and the recommended model are expected to be from boundary elements
    /// at this very load.
    pub expected: Vec<Expectation>,
}

/// The expected ratio of a quantity of a model to boundary elements.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Expectation {
    /// The id of the model.
    pub model: String,
    /// The quantity.
    pub quantity: Compared,
    /// The ratio and its interval.
    pub expected: Expected,
}

/// Compares all models with `reference` at the separations and loads of the request. Recommends the
/// simplest that deviates by at most `within` in every requested quantity and is valid there: no
/// model without yielding where asperities yield.
///
/// ```
/// use asperity::{Interface, Quantity, Request, Scene, Surface, linspace, recommend};
///
/// // A smooth surface that hardly yields: Greenwood & Williamson is sufficient.
/// let interface = Interface::new(116e9, 0.31, 7e9);
/// let surface = Surface::from_plasticity_index(0.3, 0.04, 1e-7, &interface)?;
/// let scene = Scene::new(interface, surface, 1e-4);
/// let request = Request::new([Quantity::Force, Quantity::Area]).at(linspace(0.0, 4.0, 9));
/// let advice = recommend(&scene, &request, &"ke".parse()?, 0.05)?;
/// assert_eq!(advice.simplest.map(|model| model.id().to_string()).as_deref(), Some("gw"));
/// # Ok::<(), asperity::ContactError>(())
/// ```
///
/// # Errors
/// [`ContactError::OutOfRange`] unless 0 < `within` ≤ 1 and there is at least one separation or
/// load; errors of the reference model.
pub fn recommend(
    scene: &Scene,
    request: &Request,
    reference: &Model,
    within: f64,
) -> Result<Recommendation, ContactError> {
    recommend_among(Model::all(), scene, request, reference, within)
}

/// Like [`recommend`], among these models, such as models with options or of your own. Of two
/// equally simple models, the first of the list is named.
///
/// # Errors
/// Those of [`recommend`].
pub fn recommend_among(
    models: Vec<Model>,
    scene: &Scene,
    request: &Request,
    reference: &Model,
    within: f64,
) -> Result<Recommendation, ContactError> {
    if !(within > 0.0 && within <= 1.0) {
        let required = "a share above 0 and at most 1 (5 % is 0.05)";
        return Err(ContactError::OutOfRange { field: "within", value: within, required });
    }
    if request.at.is_empty() {
        let (field, required) = ("number of separations and loads", "at least 1");
        return Err(ContactError::OutOfRange { field, value: 0.0, required });
    }
    let wanted = answers(reference, scene, request)?;
    let mut evidence = evidence(scene, request, reference)?;
    let mut comparisons: Vec<Comparison> = models
        .into_iter()
        .map(|model| {
            let deviations = answers(&model, scene, request).map(|found| {
                let columns = request.quantities.iter().zip(found.iter().zip(&wanted));
                columns.map(|(q, (a, b))| (*q, largest_deviation(*q, a, b))).collect()
            });
            let regimes = regimes(&model, scene, request);
            let cases = evidence.iter().filter_map(|(place, _)| place.nearest.as_ref().ok());
            let off = cases.filter_map(|near| near.deviation(model.id())).reduce(Deviation::worse);
            let mut found = Comparison { model, deviations, regimes, outside: None, off };
            if found.largest() <= within {
                found.outside = outside(&found.model, scene, &request.at);
            }
            found
        })
        .collect();
    let kind = |model: &Model| {
        let validity = model.validity();
        (validity.angles, !validity.asperities, model.equal().id() != model.id())
    };
    comparisons.sort_by_key(|c| (kind(&c.model), c.regimes));
    let near = comparisons.iter().find(|c| c.largest() <= within && c.outside.is_none());
    let itself = || outside(reference, scene, &request.at).is_none().then(|| reference.clone());
    let simplest = near.map(|c| c.model.clone()).or_else(itself);
    let mut named = vec![reference.id()];
    named.extend(simplest.as_ref().map(Described::id).filter(|id| *id != reference.id()));
    for (place, pressure) in &mut evidence {
        let Some(pressure) = pressure.filter(|_| place.nearest.is_ok()) else { continue };
        for (model, quantity) in
            named.iter().flat_map(|id| Compared::ALL.map(|quantity| (*id, quantity)))
        {
            let expected = Evidence::committed()?.expected(scene, pressure, model, quantity)?;
            let model = model.to_string();
            let found = expected.map(|expected| Expectation { model, quantity, expected });
            place.expected.extend(found);
        }
    }
    let evidence = evidence.into_iter().map(|(place, _)| place).collect();
    Ok(Recommendation { reference: reference.clone(), within, simplest, comparisons, evidence })
}

/// The finding that makes a model invalid at these separations or loads.
fn outside(model: &Model, scene: &Scene, places: &[At]) -> Option<Diagnostic> {
    let found = Check::answers(model, scene, places).into_iter();
    found.filter(|finding| finding.severity < Severity::Note).find(Diagnostic::is_of_model)
}

/// At separations, the pressure is that of the reference.
fn evidence(
    scene: &Scene,
    request: &Request,
    reference: &Model,
) -> Result<Vec<(EvidenceAt, Option<f64>)>, ContactError> {
    let places = || request.at.iter().copied();
    let pressed = Request::new([Quantity::Pressure]).within(request.tolerance).at(places());
    let contact = reference.compile(scene, &pressed)?;
    let counted = Request::new([Quantity::Contacts]).within(request.tolerance).at(places());
    let touching = reference.compile(scene, &counted).ok();
    let near = |at: At| {
        let touching = touching.as_ref().and_then(|t| t.evaluate(Quantity::Contacts, at).ok());
        let contacts = touching.map(|contacts| contacts.value());
        if let Some(contacts) = contacts.filter(|contacts| *contacts < 1.0) {
            let reason = format!("less than one asperity touches ({contacts:.1e})");
            return Err(Evidence::none(reason));
        }
        let pressure = at.pressure(scene).map_or_else(
            || Ok(contact.evaluate(Quantity::Pressure, at)?.value()),
            Ok::<_, ContactError>,
        )?;
        Ok((Evidence::committed()?.nearest(scene, pressure)?, pressure))
    };
    let place = |at| {
        let (nearest, pressure) = match near(at) {
            Ok((nearest, pressure)) => (Ok(nearest), Some(pressure)),
            Err(reason) => (Err(reason), None),
        };
        (EvidenceAt { at, nearest, expected: vec![] }, pressure)
    };
    Ok(places().map(place).collect())
}

/// The values of one quantity.
type Column = Vec<Evaluation>;

fn answers(model: &Model, scene: &Scene, request: &Request) -> Result<Vec<Column>, ContactError> {
    let contact = model.compile(scene, request)?;
    let column = |quantity: &Quantity| {
        request.at.iter().map(|at| contact.evaluate(*quantity, *at)).collect()
    };
    request.quantities.iter().map(column).collect()
}

/// Infinite if a deviation is not a number.
fn largest_deviation(quantity: Quantity, found: &Column, wanted: &Column) -> f64 {
    let deviations = found.iter().zip(wanted).map(|(a, b)| a.deviation(b, quantity));
    deviations.fold(0.0, |most, d| most.max(d.map_or(f64::INFINITY, f64::abs)))
}

/// 0 for a model without a law of an asperity.
fn regimes(model: &Model, scene: &Scene, request: &Request) -> usize {
    let law = |model: &dyn crate::AsperityModel| {
        model.force(&scene.asperity().ok()?, request.tolerance).ok()
    };
    model.equal().asperity_model().and_then(law).map_or(0, |law| law.parts.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, Surface, linspace};

    fn advice(plasticity_index: f64, within: f64) -> Recommendation {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface =
            Surface::from_plasticity_index(plasticity_index, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let request = Request::new([Quantity::Force, Quantity::Area]).at(linspace(0.0, 3.0, 7));
        recommend(&scene, &request, &"ke".parse().unwrap(), within).unwrap()
    }

    #[test]
    fn the_simplest_model_that_is_near_enough_is_named() {
        let simplest = |advice: &Recommendation| advice.simplest.as_ref().unwrap().id().to_string();
        assert_eq!(simplest(&advice(0.3, 0.05)), "gw");
        assert_eq!(simplest(&advice(6.0, 1e-6)), "ke");
        // At psi = 6 two-part laws are off by more than 1 %, three-part ones by more than 5 %.
        let rough = advice(6.0, 0.05);
        assert!(!["gw", "ceb", "af"].contains(&&*simplest(&rough)), "{rough}");
    }

    #[test]
    fn the_error_of_a_model_stands_beside_it() {
        let rough = advice(6.0, 0.05);
        let text = rough.to_string();
        assert!(text.contains("Gao          equivalent_shear_modulus is missing"), "{text}");
        assert!(text.contains("KE           force 0 % area 0 %"), "{text}");
        // β = 0.04 is α = 4; at d = 0 half of the surface would touch.
        assert!(text.contains("boundary elements on surfaces like this one"), "{text}");
        let off = rough.comparisons.iter().find(|c| c.model.id() == "ke").unwrap().off.unwrap();
        assert!(off.area.is_some_and(|off| off.abs() < 1.0) && off.stiffness.is_some(), "{off:?}");
        let smooth = advice(0.3, 0.05);
        assert!(smooth.summary()[0].contains("elastic"), "{smooth}");
        // Models with yielding have no elastic evidence.
        let ke = smooth.comparisons.iter().find(|c| c.model.id() == "ke").unwrap();
        assert!(ke.off.is_none());
    }

    #[test]
    fn no_model_is_the_simplest_where_it_does_not_hold() {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface = Surface::from_plasticity_index(0.8, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let request = Request::new([Quantity::Force]).at([0.0]);
        // Yielding asperities carry a third of the load, and the deviation is only a few per cent.
        let ask = |reference: &str, models: &[&str]| {
            let models = models.iter().map(|id| id.parse().unwrap()).collect();
            recommend_among(models, &scene, &request, &reference.parse().unwrap(), 0.3).unwrap()
        };
        let advice = ask("ke", &["gw", "ke", "zmc"]);
        let gw = &advice.comparisons[0];
        assert!(gw.model.id() == "gw" && gw.largest() < 0.3, "{advice}");
        assert_eq!(gw.outside.as_ref().map(|finding| finding.code), Some("yields"));
        assert_eq!(advice.simplest.as_ref().map(|m| m.id()), Some("zmc"), "{advice}");
        assert!(advice.to_string().contains("; not valid: yielding_share 0."), "{advice}");
        assert_eq!(ask("ke", &["gw"]).simplest.map(|m| m.id().to_string()).as_deref(), Some("ke"));
        let none = ask("gw", &["gw"]);
        assert!(none.simplest.is_none());
        assert!(none.to_string().starts_with("no valid model is within 30 % of GW"));
    }

    #[test]
    fn each_load_has_its_own_evidence_and_the_models_named_were_compared() {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let unit = 116e9 * surface.rms_slope();
        let pressures = [1e-14, 2e-14, 1e-2, 1.05e-2, 1e-1].map(|p| At::Pressure(p * unit));
        let request = Request::new([Quantity::Area]).at(pressures);
        let ke: Model = "ke".parse().unwrap();
        let models = vec![ke.clone(), "jg".parse().unwrap()];
        let advice = recommend_among(models, &scene, &request, &ke, 0.1).unwrap();
        let there: Vec<bool> = advice.evidence.iter().map(|place| place.nearest.is_ok()).collect();
        assert_eq!(there, [false, false, true, true, true]);
        let summary = advice.summary();
        assert_eq!(summary.len(), 4, "{summary:?}");
        assert!(
            summary[3].starts_with("over these 3 places, nearest in area were "),
            "{summary:?}"
        );
        assert!(
            summary[0].starts_with(
                "no boundary-element solution is close at 2 places from a pressure of "
            ),
            "{summary:?}"
        );
        assert!(
            summary[1].starts_with("boundary elements on surfaces like this one at 2 places from")
        );
        assert!(
            summary[1].contains("p/(E g) 0.01 ") && summary[2].contains("p/(E g) 0.1 "),
            "{summary:?}"
        );
        for summary in &summary[1..] {
            let (_, named) = summary.split_once("nearest in area were ").unwrap();
            assert!(named.contains("ke (") && named.contains("jg ("), "{named}");
            assert!(!named.contains("random") && !named.contains("persson"), "{named}");
        }
        assert!(advice.comparisons.iter().all(|comparison| comparison.off.is_some()));
    }

    #[test]
    fn a_surface_unlike_the_solved_ones_has_no_evidence() {
        let known = advice(2.0, 0.05);
        assert!(known.evidence.iter().any(|place| place.nearest.is_ok()), "{known}");
        let without = known.clone().without_evidence("the heights have a kurtosis of 175");
        assert_eq!(
            without.summary(),
            ["no boundary-element solution is close: the heights have a kurtosis of 175"]
        );
        assert!(without.comparisons.iter().all(|found| found.off.is_none()));
        let ids = |all: &Recommendation| all.simplest.as_ref().map(|m| m.id().to_string());
        assert_eq!(ids(&without), ids(&known));
    }

    #[test]
    fn scenes_outside_the_solved_range_have_no_evidence() {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface = Surface::from_plasticity_index(30.0, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let request = Request::new([Quantity::Area]).at_loads([100.0]);
        let advice = recommend(&scene, &request, &"ke".parse().unwrap(), 0.1).unwrap();
        let summary = advice.summary().remove(0);
        assert!(
            summary.starts_with(
                "no boundary-element solution is close: plasticity_index = 30.0; solved up to 4.0"
            ),
            "{summary}"
        );
        assert!(advice.comparisons.iter().all(|comparison| comparison.off.is_none()));
        let far = Request::new([Quantity::Force]).at([2.0, 30.0]);
        let summary =
            recommend(&scene, &far, &"ke".parse().unwrap(), 0.1).unwrap().summary().remove(0);
        let apart = "no boundary-element solution is close at a separation of 2 asperity_height_std: plasticity_index";
        assert!(summary.starts_with(apart), "{summary}");
        let far = Request::new([Quantity::Force]).at([30.0]);
        let summary =
            recommend(&scene, &far, &"ke".parse().unwrap(), 0.1).unwrap().summary().remove(0);
        assert!(summary.contains("is close: less than one asperity touches"), "{summary}");
        let light = Request::new([Quantity::Force]).at_loads([1e-9]);
        let light = recommend(&scene, &light, &"ke".parse().unwrap(), 0.1).unwrap();
        let summary = light.summary().remove(0);
        assert!(summary.contains("is close: less than one asperity touches"), "{summary}");
        let refused = recommend(&scene, &request, &"ke".parse().unwrap(), 5.0).unwrap_err();
        assert!(refused.to_string().starts_with("within is 5.0: a share above 0"), "{refused}");
    }
}
