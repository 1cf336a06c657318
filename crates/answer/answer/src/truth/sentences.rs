//! Models beside boundary elements on a scan, in sentences.

use asperity::{At, Code, Compared, Described, Tolerance, nearest_in_each};
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
    known.retain(|quantity| found.iter().any(|truth| truth.bem.contains_key(quantity)));
    let is_coarse = found.iter().any(|truth| truth.has_note(&COARSE));
    let is_ranked = |quantity: &_| !is_coarse || grid_is_nearest(found, *quantity);
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
    for of in others {
        nearest += &format!("; models are not ranked in {}, which depends on the grid", of.label());
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

/// Whether solutions on the scan of a scene lie in the intervals of solved surfaces, a line for
/// each quantity; or why there is no interval. Loads that few pixels or patches carry do not count.
#[must_use]
pub fn beside_table(file: &SceneFile, found: &[Truth]) -> Vec<String> {
    let resolved = found.iter().filter(|truth| !truth.has_note(&FEW) && !truth.has_note(&COARSE));
    let resolved: Vec<&Truth> = resolved.collect();
    let best = match file.best().on(&file.scene, Tolerance::default()) {
        Ok(best) if !resolved.is_empty() => best,
        _ => return vec![],
    };
    let at = |truth: &Truth| At::Pressure(truth.pressure);
    let bases: Vec<_> = resolved.iter().map(|truth| best.basis(at(truth))).collect();
    let Some(basis) = bases.iter().find_map(|basis| basis.as_ref().ok()) else {
        let reason = bases.iter().find_map(|basis| basis.as_ref().err());
        let reason = reason.map_or_else(String::new, ToString::to_string);
        return vec![format!("the solved surfaces do not cover this scan: {reason}")];
    };
    let line = |of: Compared| {
        let both = |truth: &&Truth| {
            let known = best.known(of, at(truth)).ok()?;
            Some((*truth.bem.get(&of)?, known.value, known.ends?))
        };
        let both: Vec<(f64, f64, [f64; 2])> = resolved.iter().filter_map(both).collect();
        // An area of F/H is an end of its interval.
        let inside = |(solved, _, [low, high]): &&(f64, f64, [f64; 2])| {
            (low - SAME * low.abs()..=high + SAME * high.abs()).contains(solved)
        };
        let (all, agree) = (both.len(), both.iter().filter(inside).count());
        let gap = found.first().filter(|_| of == Compared::MeanGap).map(|truth| truth.rms_height);
        let off =
            |(solved, value, _): &(f64, f64, [f64; 2])| (solved - value) / gap.unwrap_or(*value);
        let most = both.iter().map(off).reduce(|a, b| if b.abs() > a.abs() { b } else { a })?;
        let unit = if gap.is_some() { "% of Sq" } else { "%" };
        let loads = if all == 1 { String::new() } else { format!(" at {agree} of {all} loads") };
        let verdict = if agree == 0 { "is outside" } else { "lies in" };
        Some(format!(
            "{} {verdict} the interval of solved surfaces{loads}, up to {:+.0} {unit} from its middle ({basis})",
            of.label(),
            100.0 * most
        ))
    };
    Compared::ALL.into_iter().filter_map(line).collect()
}
