//! Every model compared with boundary elements on the same scan.

mod sentences;
mod sheet;

use std::ops::ControlFlow;

use asperity::bem::{Bem, BemError, LoadCase, Progress};
use asperity::{
    Check, Compared, Contact, ContactError, ContactModel, Finding, Model, Quantity, Request, Scene,
};
pub use sentences::{beside_table, summary, unranked};
pub use sheet::{Truths, truth};

/// A contact of a scan by boundary elements, and by every model.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Truth {
    /// Mean pressure on the nominal area \[Pa\].
    pub pressure: f64,
    /// The contact by boundary elements.
    pub bem: ContactState,
    /// Root mean square height of the scan \[m\], the unit of the deviations of gaps.
    pub rms_height: f64,
    /// Limits of the solution by boundary elements.
    pub notes: Vec<Finding>,
    /// The contact by each model, in the order given.
    pub models: Vec<(Model, ContactState)>,
    /// Models whose area would exceed the nominal one, and the finding.
    pub refused: Vec<(Model, Finding)>,
    /// Findings of models of independent asperities whose contacts merge.
    pub merging: Vec<Finding>,
    /// Models that lack a number, and the error of the first that they lack.
    pub missing: Vec<(Model, ContactError)>,
}

/// Area, gap and stiffness of a contact; `None` where there is no such number.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactState {
    /// Real over nominal area.
    pub area_fraction: Option<f64>,
    /// Separation of the mean planes \[m\].
    pub mean_gap: Option<f64>,
    /// -dF/dd \[N/m\].
    pub stiffness: Option<f64>,
}

impl Truth {
    /// How far a model is from boundary elements: relative, for the gap over the root mean square
    /// height of the scan.
    #[must_use]
    pub fn deviation(&self, model: &ContactState) -> ContactState {
        let relative = |found: Option<f64>, truth: Option<f64>| {
            found.zip(truth).map(|(found, truth)| found / truth - 1.0).filter(|d| d.is_finite())
        };
        let gap = model.mean_gap.zip(self.bem.mean_gap);
        ContactState {
            area_fraction: relative(model.area_fraction, self.bem.area_fraction),
            mean_gap: gap.map(|(found, truth)| (found - truth) / self.rms_height),
            stiffness: relative(model.stiffness, self.bem.stiffness),
        }
    }
}

/// Solves the scan at mean pressures \[Pa\] on the nominal area, one after another, and every model
/// at the same pressures. `progress` is called at every iteration and may stop the run: the
/// pressures solved by then are kept.
///
/// # Errors
/// [`ContactError`] naming the input of the scene that is out of range or missing. What a single
/// pressure lacks stands in its place.
pub fn compare_with_bem(
    scene: &Scene,
    bem: &Bem,
    pressures: &[f64],
    models: &[Model],
    progress: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Vec<Result<Truth, BemError>>, ContactError> {
    asperity::positive("nominal_area", scene.nominal_area)?;
    let elements = bem.elements(&scene.interface)?;
    let around = |p: &f64| {
        let [lighter, heavier] = elements.pressures_around(*p);
        [lighter, *p, heavier].map(LoadCase::MeanPressure)
    };
    let given: Vec<LoadCase> = pressures.iter().flat_map(around).collect();
    let mut solved: Vec<Result<Kept, BemError>> =
        given.iter().map(|_| Err(BemError::Cancelled)).collect();
    elements.solve_each(&given, progress, |index, solution| {
        solved[index] = solution.map(|found| (found.area, found.mean_gap, found.notes));
    });
    let request = Request::new([Quantity::Area, Quantity::Tangent]);
    let contacts: Vec<_> =
        models.iter().map(|model| (model, model.compile(scene, &request))).collect();
    let rms_height = bem.map().rms_height();
    let answer = |(pressure, around): (&f64, &[Result<Kept, BemError>])| {
        let (area, gap, notes) = around[1].clone()?;
        let gaps = around[0].as_ref().ok().zip(around[2].as_ref().ok());
        let [lighter, heavier] = elements.pressures_around(*pressure);
        let force = (heavier - lighter) * scene.nominal_area;
        let bem = ContactState {
            area_fraction: Some(area),
            mean_gap: Some(gap),
            // Where all touches, gaps no longer fall.
            stiffness: gaps
                .map(|(light, heavy)| force / (light.1 - heavy.1))
                .filter(|stiffness| stiffness.is_finite() && *stiffness > 0.0),
        };
        let (mut models, mut refused, mut missing) = (vec![], vec![], vec![]);
        let mut merging = vec![];
        for (model, contact) in &contacts {
            let (state, lacks) = match contact {
                Ok(contact) => state(contact.as_ref(), *pressure),
                Err(reason) => (ContactState::default(), Some(reason.clone())),
            };
            let area = state.area_fraction;
            let crowded = area.and_then(|area| Check::crowded(*model, *pressure, area));
            let is_refused = area.is_some_and(|area| area > 1.0);
            models
                .push(((*model).clone(), if is_refused { ContactState::default() } else { state }));
            if is_refused {
                refused.extend(crowded.map(|why| ((*model).clone(), why)));
            } else {
                merging.extend(crowded);
                missing.extend(lacks.map(|lacks| ((*model).clone(), lacks)));
            }
        }
        Ok(Truth { pressure: *pressure, bem, rms_height, notes, models, refused, merging, missing })
    };
    Ok(pressures.iter().zip(solved.chunks(3)).map(answer).collect())
}

/// Area, mean gap and notes of a solution, without its maps.
type Kept = (f64, f64, Vec<Finding>);

/// The contact by a model at a pressure, and the error of the first number that it lacks.
fn state(contact: &dyn Contact, pressure: f64) -> (ContactState, Option<ContactError>) {
    let mut lacks = None;
    let mut value = |quantity: Compared| {
        let found = quantity.of_contact(contact, pressure);
        found.map_err(|reason| lacks.get_or_insert(reason).clone()).ok()
    };
    let state = ContactState {
        area_fraction: value(Compared::Area),
        mean_gap: value(Compared::MeanGap),
        stiffness: value(Compared::Stiffness),
    };
    (state, lacks)
}

#[cfg(test)]
mod tests {
    use asperity::bem::RandomSurface;
    use asperity::{Asperities, Described, Interface, Surface};

    use super::*;

    const GO_ON: ControlFlow<()> = ControlFlow::Continue(());

    fn scan() -> (Scene, Bem) {
        let rough = RandomSurface::new(2.0, 3.0, 12.0).unwrap().gradient(0.05).unwrap();
        let surface = Surface::from_moments(&rough.moments()).unwrap();
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), surface, 2.0);
        (scene, Bem::new(rough.heights(96).unwrap(), None, false))
    }

    #[test]
    fn areas_gaps_and_stiffnesses_are_those_of_the_solver() {
        let (scene, bem) = scan();
        let all =
            compare_with_bem(&scene, &bem, &[3e7, 2e9, 3e8], &Model::all(), |_| GO_ON).unwrap();
        assert!(matches!(all[1], Err(BemError::CannotBeCarried { .. })));
        let elements = bem.elements(&scene.interface).unwrap();
        for found in all.iter().flatten() {
            let [light, here, heavy] = [0.99, 1.0, 1.01]
                .map(|k| elements.solve(LoadCase::MeanPressure(k * found.pressure)).unwrap());
            let near = |a: Option<f64>, b: f64, within: f64| (a.unwrap() / b - 1.0).abs() < within;
            assert!(near(found.bem.area_fraction, here.area, 1e-9));
            assert!(near(found.bem.mean_gap, here.mean_gap, 1e-5));
            let stiffness = 0.02 * found.pressure * 2.0 / (light.mean_gap - heavy.mean_gap);
            // 8 patches at the light load: single pixels are felt.
            assert!(near(found.bem.stiffness, stiffness, 0.05), "{stiffness} {:?}", found.bem);
            assert_eq!(found.notes, here.notes);
            let none = found.deviation(&found.bem);
            assert_eq!(none.area_fraction, Some(0.0));
            let answered = found.models.iter().filter(|(_, m)| m.area_fraction.is_some()).count();
            // gao and at need a shear modulus, and say so.
            let lacking: Vec<&str> = found.missing.iter().map(|(model, _)| model.id()).collect();
            assert_eq!(lacking, ["gao", "at", "at-additive", "at-overlap"]);
            let told = |(_, why): &(Model, ContactError)| {
                why.to_string().starts_with("equivalent_shear_modulus is missing")
            };
            assert!(found.missing.iter().all(told));
            assert!(found.refused.is_empty());
            assert_eq!(
                (found.models.len(), answered + found.refused.len()),
                (Model::all().len(), Model::all_on(Asperities::Random).len())
            );
        }
    }

    #[test]
    fn more_area_than_there_is_is_no_answer() {
        let (mut scene, bem) = scan();
        let models = ["gw", "ke", "persson"].map(|id| id.parse::<Model>().unwrap());
        let solve = |scene: &Scene, bem: &Bem| {
            let mut found = compare_with_bem(scene, bem, &[1e8], &models, |_| GO_ON).unwrap();
            found.remove(0).unwrap()
        };
        let refused = |truth: &Truth| -> Vec<(String, &str)> {
            truth.refused.iter().map(|(model, why)| (model.id().into(), why.code)).collect()
        };
        scene.interface.hardness = Some(1e10);
        let usual = solve(&scene, &bem);
        assert!(usual.models.iter().all(|(_, state)| state.area_fraction.is_some()));
        scene.interface = Interface::elastic(1e6, 0.3);
        let soft = solve(&scene, &bem);
        assert_eq!(refused(&soft), [("gw".to_string(), "crowded")]);
        assert_eq!(soft.models[0].1, ContactState::default());
        assert!(soft.models[2].1.area_fraction.is_some_and(|area| area <= 1.0));
        // Loads that few pixels carry take no part in what is said of all.
        let [mut clear, mut few] = [soft.clone(), soft];
        (clear.notes, few.notes) = (vec![], vec![Finding::warning("few-pixels", "pixels", 33.0)]);
        let both = summary(&[clear.clone(), few.clone()], &[]);
        assert!(
            both.starts_with("over the loads with enough pixels and patches in contact (1 of 2), "),
            "{both}"
        );
        assert!(both.contains("persson") && !both.contains("gw"), "{both}");
        assert!(summary(&[clear.clone(), clear.clone()], &[]).starts_with("over these loads, "));
        assert!(summary(&[few], &[]).starts_with("models are not ranked: too few pixels"));
        let notes = vec![Finding::warning("short-waves", "shortest_wavelength", 3.0)];
        let coarse = Truth { notes, ..usual };
        // Half the grid is nearer than the models, or it is not.
        let off = |area: f64| {
            let mut half = coarse.clone();
            half.bem.area_fraction = half.bem.area_fraction.map(|fraction| fraction * area);
            half.bem.stiffness = None;
            summary(std::slice::from_ref(&coarse), &[Some(half)])
        };
        let near = off(1.0003);
        assert!(
            near.starts_with("over these loads, nearest to boundary elements in area"),
            "{near}"
        );
        assert!(off(1.9).starts_with("models are not ranked: the grid is too coarse"));
        assert!(
            summary(&[coarse], &[]).starts_with("models are not ranked: the grid is too coarse")
        );
    }

    #[test]
    fn a_model_that_knows_some_of_its_numbers_says_what_it_lacks() {
        let (mut scene, bem) = scan();
        scene.interface = Interface::elastic(1e11, 0.3);
        // Without a spectrum there is an area, and nothing else.
        let persson = ["persson".parse::<Model>().unwrap()];
        let found =
            compare_with_bem(&scene, &bem, &[1e8], &persson, |_| GO_ON).unwrap().remove(0).unwrap();
        let (_, state) = &found.models[0];
        assert!(state.area_fraction.is_some() && state.mean_gap.or(state.stiffness).is_none());
        let message = found.missing[0].1.to_string();
        assert!(
            message.starts_with("hurst_exponent is missing: stiffness and mean gap"),
            "{message}"
        );
        assert!(found.refused.is_empty());
    }

    #[test]
    fn what_is_done_is_kept_when_it_is_stopped() {
        let (scene, bem) = scan();
        let stop = |progress: &Progress| match progress.done {
            0..=3 => GO_ON,
            _ => ControlFlow::Break(()),
        };
        let found = compare_with_bem(&scene, &bem, &[3e7, 3e8], &[], stop).unwrap();
        assert!(matches!(found[0], Err(BemError::Cancelled)));
        assert!(found[1].as_ref().is_ok_and(|heavy| heavy.bem.stiffness.is_some()));
    }
}
