//! Models beside boundary elements on a scan, in sentences.

use asperity::{
    At, Code, Compared, ContactError, Described, EvidenceAt, Model, Quantity, Ratio, Request,
    Scene, SurfaceShape, nearest_in_each, recommend_among, usual_reference,
};
use asperity_scene::SceneFile;

use super::{ContactState, Truth};

/// Codes of notes on loads that few pixels or patches carry.
const FEW: [Code; 2] = [Code::FewPixels, Code::FewPatches];
/// Rounding of ratios that are equal.
const SAME: f64 = 1e-9;
/// Code of a note on a grid too coarse for the shortest waves.
const COARSE: [Code; 1] = [Code::ShortWaves];

impl Truth {
    fn has_note(&self, codes: &[Code]) -> bool {
        self.notes.iter().any(|note| codes.contains(&note.code))
    }

    /// The deviation of a model in a quantity.
    fn off(&self, id: &str, quantity: Compared) -> Option<f64> {
        let (_, state) = self.models.iter().find(|(model, _)| model.id() == id)?;
        self.deviation(state).get(&quantity).copied()
    }
}

/// Why models are not ranked on solutions of a scan whose notes have these codes, a list a load,
/// and what to do; `None` where they are.
#[must_use]
pub fn unranked(codes: &[Vec<Code>]) -> Option<[&'static str; 2]> {
    let has = |list: &[Code], codes: &Vec<Code>| codes.iter().any(|code| list.contains(code));
    match codes {
        _ if codes.iter().any(|codes| has(&COARSE, codes)) => Some([
            "the grid is too coarse for the shortest waves of the scan",
            "set smooth, the shortest wave kept, to 16 pixels or more, or measure on smaller pixels",
        ]),
        _ if codes.iter().all(|codes| has(&FEW, codes)) => {
            Some(["too few pixels or patches are in contact", "raise the load"])
        }
        _ => None,
    }
}

/// Which models are nearest to boundary elements over these loads, in area and the compared
/// stiffnesses. Loads that few pixels or patches carry do not count; on a grid too coarse for the
/// shortest waves of the scan models are ranked where half the grid differs by less than each of
/// them.
#[must_use]
pub fn summary(found: &[Truth]) -> String {
    let mut known = Compared::RANKED.to_vec();
    known.retain(|(quantity, _)| found.iter().any(|truth| truth.bem.contains_key(quantity)));
    let is_coarse = found.iter().any(|truth| truth.has_note(&COARSE));
    let is_ranked = |(quantity, _): &_| !is_coarse || grid_is_nearest(found, *quantity);
    let (ranked, others): (Vec<_>, Vec<_>) = known.into_iter().partition(is_ranked);
    let codes = |truth: &Truth| {
        let codes = truth.notes.iter().map(|note| note.code);
        codes.filter(|code| ranked.is_empty() || !COARSE.contains(code)).collect()
    };
    if let Some([why, remedy]) = unranked(&found.iter().map(codes).collect::<Vec<_>>()) {
        let refine = match is_coarse && found.iter().all(|truth| truth.half.is_none()) {
            true => ", or compare with half the grid (refine)",
            false => "",
        };
        return format!("models are not ranked: {why}; {remedy}{refine}");
    }
    let resolved: Vec<&Truth> = found.iter().filter(|truth| !truth.has_note(&FEW)).collect();
    let models = found.first().map_or(&[][..], |first| &first.models);
    let ids = models.iter().map(|(model, _)| model.id());
    let off = |id: &str, of| resolved.iter().map(|truth| truth.off(id, of)).collect();
    let mut nearest = nearest_in_each(ids, off, &ranked).join("; ");
    for (_, name) in others {
        nearest += &format!("; models are not ranked in {name}, which depends on the grid");
    }
    match (resolved.len(), found.len()) {
        (count, all) if all == count => format!("over these loads, {nearest}"),
        (count, all) => format!(
            "over the loads with enough pixels and patches in contact ({count} of {all}), {nearest}"
        ),
    }
}

/// Whether, at their worst loads, half the grid differs from the whole one by less than each model.
fn grid_is_nearest(found: &[Truth], quantity: Compared) -> bool {
    let worst = |state: &dyn for<'t> Fn(&'t Truth) -> Option<&'t ContactState>| {
        let off = |truth: &Truth| Some(truth.deviation(state(truth)?).get(&quantity)?.abs());
        let all: Option<Vec<f64>> = found.iter().map(off).collect();
        all?.into_iter().reduce(f64::max)
    };
    let count = found.first().map_or(0, |first| first.models.len());
    let of_model = |k: usize| worst(&|truth| truth.models.get(k).map(|(_, state)| state));
    let nearest = (0..count).filter_map(of_model).reduce(f64::min);
    let grid = worst(&|truth| truth.half.as_ref());
    grid.zip(nearest).is_some_and(|(grid, nearest)| grid < nearest)
}

/// How far the usual reference model is from boundary elements on the scan of a scene, and whether
/// that lies in the interval of the solved surfaces, a line for each quantity; or why there is no
/// interval. Loads that few pixels or patches carry do not count. Empty if the scene does not allow
/// that model.
#[must_use]
pub fn beside_table(file: &SceneFile, found: &[Truth]) -> Vec<String> {
    let Ok(model) = file.model(usual_reference(&file.scene)) else { return vec![] };
    match file.surface_shape() {
        Ok(shape) => lines(found, &file.scene, shape, &model).unwrap_or_else(|reason| {
            vec![format!("the solved surfaces were not compared: {reason}")]
        }),
        Err(reason) => vec![reason.to_string()],
    }
}

fn lines(
    found: &[Truth],
    scene: &Scene,
    shape: Option<SurfaceShape>,
    model: &Model,
) -> Result<Vec<String>, ContactError> {
    let resolved = found.iter().filter(|truth| !truth.has_note(&FEW) && !truth.has_note(&COARSE));
    let resolved: Vec<&Truth> = resolved.collect();
    if resolved.is_empty() {
        return Ok(vec![]);
    }
    let loads: Vec<At> = resolved.iter().map(|truth| At::Pressure(truth.pressure)).collect();
    let request = Request::new([Quantity::Area]).at(loads);
    let table = recommend_among(vec![], scene, shape, &request, model, 1.0)?.evidence;
    let covered = |place: &EvidenceAt| -> Option<&Truth> {
        let here = |truth: &&&Truth| At::Pressure(truth.pressure) == place.at;
        resolved.iter().find(here).copied().filter(|_| place.expected.is_ok())
    };
    let covered: Vec<(&Truth, &EvidenceAt)> =
        table.iter().filter_map(|place| Some((covered(place)?, place))).collect();
    let Some((_, EvidenceAt { expected: Ok(first), .. })) = covered.first() else {
        let reason = table.iter().find_map(|place| place.expected.as_ref().err());
        let reason = reason.map_or_else(String::new, |reason| match reason {
            ContactError::Refused { reason, .. } => reason.clone(),
            reason => reason.to_string(),
        });
        return Ok(vec![format!("the solved surfaces do not cover this scan: {reason}")]);
    };
    let line = |quantity: Compared| {
        let both = |(truth, place): &(&Truth, &EvidenceAt)| {
            let off = truth.off(model.id(), quantity)?;
            Some((Ratio::solved(off, quantity), place.ratio(model.id(), quantity)?))
        };
        let both: Vec<(Ratio, Ratio)> = covered.iter().filter_map(both).collect();
        // An area of F/H is an end of its interval.
        let inside = |(scan, table): &&(Ratio, Ratio)| {
            (table.low - SAME..=table.high + SAME).contains(&scan.ratio)
        };
        let (all, different) = (both.len(), both.iter().filter(|pair| !inside(pair)).count());
        let (scan, table) =
            both.into_iter().reduce(|(a, b), (c, d)| (a.with(c, quantity), b.with(d, quantity)))?;
        let (name, scan, table) = (model.id(), scan.words(quantity), table.words(quantity));
        let verdict = match different {
            0 => "the solved surfaces agree".into(),
            some if some == all => "the solved surfaces differ".into(),
            some => format!("at {some} of {all} loads the solved surfaces differ"),
        };
        let basis = first.basis();
        Some(format!("{name} {scan} on this scan; {verdict}: {name} {table} ({basis})"))
    };
    Ok(Compared::ALL.into_iter().filter_map(line).collect())
}
