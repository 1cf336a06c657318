//! Which model does a scene need? What it takes to be near another, and what boundary elements say.

use std::fmt;

use serde::Serialize;

use crate::{
    At, ContactError, ContactModel, Deviation, Evaluation, Evidence, Model, Nearest, Quantity,
    Request, Scene, ranking,
};

/// How far one model is from the reference.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Comparison {
    /// The model.
    pub model: Model,
    /// Largest deviation from the reference relative to it, over the separations, for each
    /// quantity asked; or why the model could not answer.
    pub deviations: Result<Vec<(Quantity, f64)>, ContactError>,
    /// Parts of the model's laws, a measure of its complexity.
    pub regimes: usize,
    /// How far the model was from boundary elements in the cases nearest to the scene, where there
    /// are any: the largest over the separations and loads.
    pub off: Option<Deviation>,
}

impl Comparison {
    /// The largest deviation of any quantity; infinite where the model could not answer.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let none = |_: &ContactError| f64::INFINITY;
        let largest = |all: &Vec<(Quantity, f64)>| all.iter().fold(0.0, |m: f64, (_, d)| m.max(*d));
        self.deviations.as_ref().map_or_else(none, largest)
    }
}

/// All models against a reference, and the simplest that is near enough.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Recommendation {
    /// The model that the others are compared with.
    pub reference: Model,
    /// Largest relative deviation that was allowed.
    pub within: f64,
    /// The first of the comparisons within it. The reference itself is always within.
    pub simplest: Model,
    /// Every model, the simplest first: no angles before angles, then fewest parts of the force
    /// law, then the order of [`Model::all`], which is that of their years.
    pub comparisons: Vec<Comparison>,
    /// Where boundary elements were nearest to the scene, for each separation or load that has such
    /// a case; or why none has one.
    pub evidence: Result<Vec<Nearest<'static>>, ContactError>,
}

/// Compares all models with `reference` at the request's separations, and names the simplest that
/// stays `within` a relative deviation of it in every asked quantity.
///
/// ```
/// use asperity::{Interface, Quantity, Request, Scene, Surface, linspace, recommend};
///
/// // A soft, smooth surface that never yields: Greenwood & Williamson will do.
/// let interface = Interface::new(116e9, 0.31, 7e9);
/// let surface = Surface::from_plasticity_index(0.3, 0.04, 1e-7, &interface)?;
/// let scene = Scene::new(interface, surface, 1e-4);
/// let request = Request::new([Quantity::Force, Quantity::Area]).at(linspace(0.0, 4.0, 9));
/// let advice = recommend(&scene, &request, &"ke".parse()?, 0.05)?;
/// assert_eq!(advice.simplest.id(), "gw");
/// # Ok::<(), asperity::ContactError>(())
/// ```
///
/// # Errors
/// [`ContactError::OutOfRange`] when `within` is no share above 0 and at most 1, or there are no separations, and
/// what the reference model cannot answer.
pub fn recommend(
    scene: &Scene,
    request: &Request,
    reference: &Model,
    within: f64,
) -> Result<Recommendation, ContactError> {
    recommend_among(Model::all(), scene, request, reference, within)
}

/// As [`recommend`], among these models: those with a scene's options, say, or with some of your
/// own. Of two that are equally simple, the one that stands first here is named.
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
    let evidence = evidence(scene, request, reference);
    let mut comparisons: Vec<Comparison> = models
        .into_iter()
        .map(|model| {
            let deviations = answers(&model, scene, request).map(|found| {
                let columns = request.quantities.iter().zip(found.iter().zip(&wanted));
                columns.map(|(q, (a, b))| (*q, largest_deviation(*q, a, b))).collect()
            });
            let regimes = regimes(&model, scene, request);
            let near = evidence.iter().flatten().filter_map(|near| near.deviation(model.id()));
            let off = near.reduce(Deviation::worse);
            Comparison { model, deviations, regimes, off }
        })
        .collect();
    comparisons.sort_by_key(|c| (c.model.claims().angles, c.regimes));
    let near = comparisons.iter().find(|c| c.largest() <= within);
    let simplest = near.map_or_else(|| reference.clone(), |c| c.model.clone());
    Ok(Recommendation { reference: reference.clone(), within, simplest, comparisons, evidence })
}

/// At separations, the pressure is the reference's.
fn evidence(
    scene: &Scene,
    request: &Request,
    reference: &Model,
) -> Result<Vec<Nearest<'static>>, ContactError> {
    let pressed = Request::new([Quantity::Pressure]).within(request.tolerance);
    let contact = reference.compile(scene, &pressed.at(request.at.iter().copied()))?;
    let touching = reference.compile(scene, &Request::new([Quantity::Contacts])).ok();
    let contacts = touching.and_then(|touching| {
        let contacts = |at: &At| touching.evaluate(Quantity::Contacts, *at).ok();
        let all: Option<Vec<Evaluation>> = request.at.iter().map(contacts).collect();
        all?.iter().map(Evaluation::value).reduce(f64::max)
    });
    if let Some(contacts) = contacts.filter(|contacts| *contacts < 1.0) {
        let reason = format!("nothing touches: of all asperities, {contacts:.1e} do");
        return Err(Evidence::none(reason));
    }
    let near = |at: &At| {
        let pressure = at.pressure(scene).map_or_else(
            || Ok(contact.evaluate(Quantity::Pressure, *at)?.value()),
            Ok::<_, ContactError>,
        )?;
        Evidence::committed()?.nearest(scene, pressure)
    };
    let (mut found, mut refused) = (vec![], None);
    for near in request.at.iter().map(near) {
        match near {
            Ok(near) => found.push(near),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    match refused {
        Some(refused) if found.is_empty() => Err(refused),
        _ => Ok(found),
    }
}

impl Recommendation {
    /// What the evidence says, in a sentence or two: where it is from, and which of all models were
    /// nearest to boundary elements there, in area and in stiffness.
    #[must_use]
    pub fn told(&self) -> String {
        let found = match &self.evidence {
            Ok(found) => found,
            Err(reason) => return reason.to_string(),
        };
        let Some(far) = found.iter().max_by(|a, b| a.away.total_cmp(&b.away)) else {
            return "no evidence here".into();
        };
        let off = |id: &str| {
            let of = |near: &Nearest<'_>| {
                near.deviation(id).map_or([None; 2], |off| [off.area, off.stiffness])
            };
            found.iter().map(of).collect()
        };
        let nearest = ranking::nearest(far.case.models.iter().map(|(id, _)| id.as_str()), off);
        let places = match found.len() {
            1 => "at 1 of the places,".into(),
            count => format!("at {count} of the places, the farthest"),
        };
        format!("boundary elements on surfaces like this one, {places} at {far}: {nearest}")
    }
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

/// Infinite where there is none that is a number.
fn largest_deviation(quantity: Quantity, found: &Column, wanted: &Column) -> f64 {
    let deviations = found.iter().zip(wanted).map(|(a, b)| a.deviation(b, quantity));
    deviations.fold(0.0, |most, d| most.max(d.map_or(f64::INFINITY, f64::abs)))
}

/// 0 for a model that has no law of an asperity.
fn regimes(model: &Model, scene: &Scene, request: &Request) -> usize {
    let law = |model: &dyn crate::AsperityModel| {
        model.law(&scene.asperity().ok()?, Quantity::Force, request.tolerance).ok()?
    };
    model.equal().asperity_model().and_then(law).map_or(0, |law| law.parts.len())
}

impl fmt::Display for Recommendation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} is the simplest model within {:.3} % of {}",
            self.simplest.name(),
            100.0 * self.within,
            self.reference.name()
        )?;
        writeln!(f, "{}", self.told())?;
        for Comparison { model, deviations, off, .. } in &self.comparisons {
            write!(f, "  {:12}", model.name())?;
            match deviations {
                Ok(all) => {
                    for (quantity, deviation) in all {
                        write!(f, " {quantity} {:.3} %", 100.0 * deviation)?;
                    }
                    if let Some((area, spread)) = off.and_then(|o| o.area.zip(o.area_spread)) {
                        let [area, spread] = [area, spread].map(|x| 100.0 * x);
                        write!(f, ", area off boundary elements {area:+.0} +- {spread:.0} %")?;
                    }
                    writeln!(f)?;
                }
                Err(error) => writeln!(f, " {error}")?,
            }
        }
        Ok(())
    }
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
        assert_eq!(advice(0.3, 0.05).simplest.id(), "gw");
        assert_eq!(advice(6.0, 1e-6).simplest.id(), "ke");
        // At psi = 6 two-part laws are off by more than 1 %, three-part ones by more than 5 %.
        let rough = advice(6.0, 0.05);
        assert!(!["gw", "ceb", "af"].contains(&rough.simplest.id()), "{rough}");
    }

    #[test]
    fn what_a_model_lacks_is_said_beside_it() {
        let rough = advice(6.0, 0.05);
        let text = rough.to_string();
        assert!(text.contains("Gao          equivalent_shear_modulus is missing"), "{text}");
        assert!(text.contains("KE           force 0.000 % area 0.000 %"), "{text}");
        // β = 0.04 is α = 4; at d = 0 half of the surface would touch.
        assert!(text.contains("boundary elements on surfaces like this one"), "{text}");
        let off = rough.comparisons.iter().find(|c| c.model.id() == "ke").unwrap().off.unwrap();
        assert!(off.area.is_some_and(|off| off.abs() < 1.0) && off.stiffness.is_some(), "{off:?}");
        let smooth = advice(0.3, 0.05);
        assert!(smooth.told().contains("elastic"), "{}", smooth.told());
        // Models that yield were not asked where nothing does.
        let ke = smooth.comparisons.iter().find(|c| c.model.id() == "ke").unwrap();
        assert!(ke.off.is_none());
    }

    #[test]
    fn outside_of_what_was_solved_that_is_said() {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface = Surface::from_plasticity_index(30.0, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let request = Request::new([Quantity::Area]).at_loads([100.0]);
        let advice = recommend(&scene, &request, &"ke".parse().unwrap(), 0.1).unwrap();
        let told = advice.told();
        assert!(
            told.starts_with("no evidence here: plasticity_index is 30.0: at most 6.0"),
            "{told}"
        );
        assert!(advice.comparisons.iter().all(|comparison| comparison.off.is_none()));
        let far = Request::new([Quantity::Force]).at([2.0, 30.0]);
        let told = recommend(&scene, &far, &"ke".parse().unwrap(), 0.1).unwrap().told();
        assert!(told.starts_with("no evidence here: plasticity_index"), "{told}");
        let far = Request::new([Quantity::Force]).at([30.0]);
        let told = recommend(&scene, &far, &"ke".parse().unwrap(), 0.1).unwrap().told();
        assert!(told.starts_with("no evidence here: nothing touches: of all"), "{told}");
        let refused = recommend(&scene, &request, &"ke".parse().unwrap(), 5.0).unwrap_err();
        assert!(refused.to_string().starts_with("within is 5.0: a share above 0"), "{refused}");
    }
}
