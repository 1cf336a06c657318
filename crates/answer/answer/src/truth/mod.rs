//! Every model compared with boundary elements on the same scan.

mod sentences;
mod sheet;

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use asperity::bem::{Bem, BemError, LoadCase, Progress};
use asperity::{
    At, Check, Compared, ContactError, ContactModel, Described, Finding, Model, Quantity, Request,
    Scene, compile_known,
};
pub use sentences::{beside_table, uncertain};
pub use sheet::{Truths, compared, heads, truth, truth_of};

/// A contact of a scan by boundary elements, and by every model.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Truth {
    /// Mean pressure on the nominal area \[Pa\].
    pub pressure: f64,
    /// The contact by boundary elements.
    pub bem: ContactState,
    /// The same on half the grid, if that was solved.
    pub half: Option<ContactState>,
    /// Root mean square height of the scan \[m\], the unit of the deviations of gaps.
    pub rms_height: f64,
    /// Limits of the solution by boundary elements.
    pub notes: Vec<Finding>,
    /// The contact by each model, in the order given; empty if its area exceeds the nominal one.
    pub models: Vec<(Model, ContactState)>,
    /// Findings of such models, and of models of independent asperities whose contacts merge.
    pub crowded: Vec<Finding>,
    /// The ids of models, and of boundary elements, that lack a number, and why.
    pub missing: Vec<(String, ContactError)>,
}

/// The compared quantities that are known of a contact: real over nominal area, the separation of
/// the mean planes \[m\], stiffnesses \[N/m\].
pub type ContactState = BTreeMap<Compared, f64>;

impl Truth {
    /// How far a model is from boundary elements: relative, for the gap over the root mean square
    /// height of the scan.
    #[must_use]
    pub fn deviation(&self, model: &ContactState) -> ContactState {
        let off = |(quantity, found): (&Compared, &f64)| {
            let truth = self.bem.get(quantity)?;
            let off = match quantity {
                Compared::MeanGap => (found - truth) / self.rms_height,
                _ => found / truth - 1.0,
            };
            off.is_finite().then_some((*quantity, off))
        };
        model.iter().filter_map(off).collect()
    }
}

/// Solves the scan at mean pressures \[Pa\] on the nominal area, one after another, and asks every
/// model, also one of your own, for these quantities at the same pressures. `progress` is called at
/// every iteration and may stop the run: the pressures solved by then are kept. Without the area
/// among the quantities nothing tells that a model needs more than the nominal one.
///
/// Area and mean gap are part of a solution. The stiffness takes two more where pixels yield, the
/// unloading stiffness a linear one with the contact held. Conductances deviate as the unloading
/// stiffness does, whatever the conductivities.
///
/// # Errors
/// [`ContactError`] naming the input of the scene that is out of range or missing. What a single
/// pressure lacks stands in its place.
pub fn compare_with_bem(
    scene: &Scene,
    bem: &Bem,
    pressures: &[f64],
    models: &[Model],
    quantities: &[Compared],
    progress: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Vec<Result<Truth, BemError>>, ContactError> {
    asperity::positive("nominal_area", scene.nominal_area)?;
    let elements = bem.elements(&scene.interface)?;
    let asked: Vec<Quantity> = quantities.iter().filter_map(|of| of.quantity()).collect();
    let compiled = models.iter().map(|model| {
        // Places at a load need the force.
        let compile = |asked: &[Quantity]| {
            let asked = asked.iter().copied().chain([Quantity::Force]);
            model.compile(scene, &Request::new(asked))
        };
        (model, compile_known(&asked, &[], compile))
    });
    let compiled: Vec<_> = compiled.collect();
    let given: Vec<LoadCase> = pressures.iter().copied().map(LoadCase::MeanPressure).collect();
    let mut all: Vec<_> = given.iter().map(|_| Err(BemError::Cancelled)).collect();
    elements.solve_each(&given, progress, |index, solution| {
        all[index] = solution.map(|solution| {
            let (pressure, summary) = (pressures[index], elements.summary(&solution, &asked));
            let (mut missing, mut crowded) = (vec![], vec![]);
            let mut state = |id: &str, value: &dyn Fn(Compared) -> Value| {
                let mut known = |of: Compared| match value(of) {
                    Ok(found) => Some((of, found?)),
                    Err(why) => {
                        missing.push((id.to_string(), why));
                        None
                    }
                };
                quantities.iter().filter_map(|of| known(*of)).collect::<ContactState>()
            };
            let bem_state = state(Bem::ID, &|of| match of.quantity() {
                None => Ok(Some(summary.mean_gap)),
                Some(Quantity::Area) => Ok(Some(summary.area)),
                Some(of) => Ok(summary.evaluate(of, scene)?.map(|found| found.value())),
            });
            let models = compiled.iter().map(|(model, compiled)| {
                let mut found = state(model.id(), &|of| {
                    let (contact, lacking) = compiled.as_ref().map_err(Clone::clone)?;
                    match lacking.iter().find(|(lacks, _)| of.quantity() == Some(*lacks)) {
                        Some((_, why)) => Err(why.clone()),
                        None => of.of_contact(&**contact, At::Pressure(pressure)).map(Some),
                    }
                });
                if let Some(&area) = found.get(&Compared::Area) {
                    crowded.extend(Check::crowded(*model, pressure, area));
                    if area > 1.0 {
                        found.clear();
                    }
                }
                ((*model).clone(), found)
            });
            let (models, rms_height) = (models.collect(), bem.map().rms_height());
            let (bem, half, notes) = (bem_state, None, solution.notes);
            Truth { pressure, bem, half, rms_height, notes, models, crowded, missing }
        });
    });
    Ok(all)
}

/// A number of a contact, if it has one.
type Value = Result<Option<f64>, ContactError>;

#[cfg(test)]
mod tests {
    use asperity::bem::{BemOptions, LoadCase, RandomSurface};
    use asperity::{
        Asperities, Asperity, AsperityModel, Citation, GreenwoodWilliamson, Interface, Law,
        Surface, Tolerance,
    };

    use super::*;
    use Compared::{Area, MeanGap, Stiffness, UnloadingStiffness};

    const GO_ON: ControlFlow<()> = ControlFlow::Continue(());
    const ALL: [Compared; 4] = [Area, MeanGap, Stiffness, UnloadingStiffness];

    fn compare(scene: &Scene, bem: &Bem, pressures: &[f64], models: &[Model]) -> Vec<Truth> {
        let found = compare_with_bem(scene, bem, pressures, models, &ALL, |_| GO_ON).unwrap();
        found.into_iter().flatten().collect()
    }

    fn scan() -> (Scene, Bem) {
        let rough = RandomSurface::new(2.0, 3.0, 12.0).unwrap().gradient(0.05).unwrap();
        let surface = Surface::from_moments(&rough.moments()).unwrap();
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), surface, 2.0);
        (scene, Bem::new(rough.heights(96).unwrap(), BemOptions::default()))
    }

    #[test]
    fn areas_gaps_and_stiffnesses_are_those_of_the_solver() {
        let (scene, bem) = scan();
        let heavy = compare_with_bem(&scene, &bem, &[2e9], &[], &ALL, |_| GO_ON).unwrap();
        assert!(matches!(heavy[0], Err(BemError::CannotBeCarried { .. })));
        let elements = bem.elements(&scene.interface).unwrap();
        for found in compare(&scene, &bem, &[3e7, 2e9, 3e8], &Model::of_asperities()) {
            let [light, here, heavy] = [0.99, 1.0, 1.01]
                .map(|k| elements.solve(LoadCase::MeanPressure(k * found.pressure)).unwrap());
            let near = |of, b: f64, within: f64| (found.bem[&of] / b - 1.0).abs() < within;
            assert!(near(Area, here.area, 1e-9));
            assert!(near(MeanGap, here.mean_gap, 1e-5));
            let stiffness = 0.02 * found.pressure * 2.0 / (light.mean_gap - heavy.mean_gap);
            // 8 patches at the light load: single pixels are felt.
            assert!(near(Stiffness, stiffness, 0.05), "{stiffness} {:?}", found.bem);
            let back = elements.flattened_by(&here).unwrap();
            let back = back.solve(LoadCase::MeanPressure(0.99 * found.pressure)).unwrap();
            let stiffness = 0.01 * found.pressure * 2.0 / (back.mean_gap - here.gap_volume);
            assert!(near(UnloadingStiffness, stiffness, 0.01), "{stiffness} {:?}", found.bem);
            assert_eq!(found.notes, here.notes);
            assert!(found.deviation(&found.bem).values().all(|off| *off == 0.0));
            let answered = found.models.iter().filter(|(_, m)| m.contains_key(&Area)).count();
            // gao and at need a shear modulus, and say so.
            let mut lacking: Vec<&str> = found.missing.iter().map(|(id, _)| &**id).collect();
            lacking.dedup();
            assert_eq!(lacking, ["gao", "at", "at-additive", "at-overlap"]);
            let told = |(_, why): &(String, ContactError)| {
                why.to_string().starts_with("equivalent_shear_modulus is missing")
            };
            assert!(found.missing.iter().all(told));
            let known = Model::all_on(Asperities::Random).len();
            assert_eq!((found.models.len(), answered), (Model::of_asperities().len(), known));
        }
    }

    #[test]
    fn more_area_than_there_is_is_no_answer() {
        let (mut scene, bem) = scan();
        let models = ["gw", "ke", "persson"].map(|id| id.parse::<Model>().unwrap());
        let solve = |scene: &Scene, bem: &Bem| compare(scene, bem, &[1e8], &models).remove(0);
        scene.interface.hardness = Some(1e10);
        let usual = solve(&scene, &bem);
        assert!(usual.models.iter().all(|(_, state)| state.contains_key(&Area)));
        scene.interface = Interface::elastic(1e6, 0.3);
        let soft = solve(&scene, &bem);
        assert_eq!(soft.crowded.iter().map(|why| why.code).collect::<Vec<_>>(), ["crowded"]);
        assert!(soft.models[0].1.is_empty());
        assert!(soft.models[2].1.get(&Area).is_some_and(|area| *area <= 1.0));
    }

    #[test]
    fn a_model_that_knows_some_of_its_numbers_says_what_it_lacks() {
        let (mut scene, bem) = scan();
        scene.interface = Interface::elastic(1e11, 0.3);
        // Without a spectrum there is an area, and nothing else.
        let persson = ["persson".parse::<Model>().unwrap()];
        let found = compare(&scene, &bem, &[1e8], &persson).remove(0);
        let (_, state) = &found.models[0];
        assert_eq!(state.keys().collect::<Vec<_>>(), [&Area]);
        let mut messages: Vec<String> =
            found.missing.iter().map(|(id, why)| format!("{id}: {why}")).collect();
        messages.sort();
        messages.dedup();
        let [gap, radii] = &messages[..] else { panic!("{messages:?}") };
        assert!(gap.starts_with("persson: hurst_exponent is missing"), "{gap}");
        assert!(radii.contains("unloading-stiffness"), "{radii}");
        assert!(found.crowded.is_empty());
    }

    #[test]
    fn what_is_done_is_kept_when_it_is_stopped() {
        let (scene, bem) = scan();
        let stop = |progress: &Progress| match progress.done {
            0 => GO_ON,
            _ => ControlFlow::Break(()),
        };
        let found = compare_with_bem(&scene, &bem, &[3e7, 3e8], &[], &ALL, stop).unwrap();
        assert!(matches!(found[0], Err(BemError::Cancelled)));
        assert!(found[1].as_ref().is_ok_and(|heavy| heavy.bem.contains_key(&Stiffness)));
    }

    /// The laws of Greenwood & Williamson under another name.
    #[derive(Debug)]
    struct Own;

    impl Described for Own {
        fn citation(&self) -> &Citation {
            GreenwoodWilliamson.citation()
        }

        fn id(&self) -> &str {
            "own"
        }
    }

    impl AsperityModel for Own {
        fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
            GreenwoodWilliamson.force(asperity, tolerance)
        }

        fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
            GreenwoodWilliamson.area(asperity, tolerance)
        }
    }

    #[test]
    fn a_model_of_your_own_is_compared_under_its_name() {
        let (scene, bem) = scan();
        let models = ["gw".parse().unwrap(), Model::new(Own)];
        let found = compare(&scene, &bem, &[3e8], &models).remove(0);
        let [(_, gw), (model, own)] = &found.models[..] else { panic!("{:?}", found.models) };
        assert_eq!((model.id(), own.len()), ("own", 4));
        for (quantity, off) in found.deviation(own) {
            assert!((off - found.deviation(gw)[&quantity]).abs() < 1e-12, "{quantity:?} {off}");
        }
    }
}
