//! Which model does a scene need?

use std::fmt;

use crate::{ContactError, Model, Quantity, Request, Scene};

/// How far one model is from the reference.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// The model.
    pub model: Model,
    /// Largest deviation from the reference relative to it, over the separations, for each
    /// quantity asked; or why the model could not answer.
    pub deviations: Result<Vec<(Quantity, f64)>, ContactError>,
    /// Parts of the model's laws, a measure of its complexity.
    pub regimes: usize,
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
#[derive(Debug, Clone)]
pub struct Recommendation {
    /// The model that the others are compared with.
    pub reference: Model,
    /// Largest relative deviation that was allowed.
    pub within: f64,
    /// The simplest model within it: no angles before angles, then fewest regimes, then the order
    /// of [`Model::all`], simplest first. The reference itself is always within.
    pub simplest: Model,
    /// Every model, in the order of [`Model::all`].
    pub comparisons: Vec<Comparison>,
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
/// [`ContactError::OutOfRange`] when `within` is not positive or there are no separations, and
/// what the reference model cannot answer.
pub fn recommend(
    scene: &Scene,
    request: &Request,
    reference: &Model,
    within: f64,
) -> Result<Recommendation, ContactError> {
    recommend_among(Model::all(), scene, request, reference, within)
}

/// As [`recommend`], among these models, in the order of preference: those with a scene's options,
/// say, or with some of your own.
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
    crate::positive("within", within)?;
    if request.separations.is_empty() {
        let (field, required) = ("number of separations", "at least 1");
        return Err(ContactError::OutOfRange { field, value: 0.0, required });
    }
    let wanted = logarithms(reference, scene, request)?;
    let comparisons: Vec<Comparison> = models
        .into_iter()
        .map(|model| {
            let deviations = logarithms(&model, scene, request).map(|found| {
                let quantities = request.quantities.iter().copied();
                quantities
                    .zip(found.iter().zip(&wanted).map(|(a, b)| largest_deviation(a, b)))
                    .collect()
            });
            let regimes = regimes(&model, scene, request);
            Comparison { model, deviations, regimes }
        })
        .collect();
    let simplest = comparisons
        .iter()
        .filter(|c| c.largest() <= within)
        .min_by_key(|c| (c.model.claims().angles, c.regimes))
        .map_or_else(|| reference.clone(), |c| c.model.clone());
    Ok(Recommendation { reference: reference.clone(), within, simplest, comparisons })
}

/// Signs and logarithms of the values: far tails compare as well as near ones.
type Column = Vec<(f64, f64)>;

fn logarithms(
    model: &Model,
    scene: &Scene,
    request: &Request,
) -> Result<Vec<Column>, ContactError> {
    let compiled = model.compile(scene, request)?;
    let column = |quantity: &Quantity| {
        let value = |s: &f64| {
            let found = compiled.evaluate(*quantity, *s)?;
            Ok((found.scaled.signum(), found.ln_value()))
        };
        request.separations.iter().map(value).collect::<Result<Column, ContactError>>()
    };
    request.quantities.iter().map(column).collect()
}

fn largest_deviation(found: &Column, wanted: &Column) -> f64 {
    let deviation = |((s, a), (t, b)): (&(f64, f64), &(f64, f64))| {
        if a.is_infinite() && b.is_infinite() { 0.0 } else { (s * t * (a - b).exp() - 1.0).abs() }
    };
    found.iter().zip(wanted).map(deviation).fold(0.0, f64::max)
}

fn regimes(model: &Model, scene: &Scene, request: &Request) -> usize {
    let parts = |asperity| {
        let law = model.law(&asperity, Quantity::Force, request.tolerance);
        law.map_or(0, |law| law.parts.len())
    };
    scene.asperity().map_or(0, parts)
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
        for Comparison { model, deviations, .. } in &self.comparisons {
            write!(f, "  {:12}", model.name())?;
            match deviations {
                Ok(all) => {
                    for (quantity, deviation) in all {
                        write!(f, " {quantity} {:.3} %", 100.0 * deviation)?;
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
        let text = advice(6.0, 0.05).to_string();
        assert!(text.contains("Gao          equivalent_shear_modulus is missing"), "{text}");
        assert!(text.contains("KE           force 0.000 % area 0.000 %"), "{text}");
    }
}
