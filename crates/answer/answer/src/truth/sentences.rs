//! Solutions of boundary elements on a scan beside what is expected of solved surfaces.

use asperity::{At, Code, Compared, Tolerance};
use asperity_scene::SceneFile;

use super::Truth;

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
}

/// Why a solution on a scan with notes of these codes is uncertain, if it is.
#[must_use]
pub fn uncertain(codes: &[Code]) -> Option<&'static str> {
    let has = |list: &[Code]| codes.iter().any(|code| list.contains(code));
    match (has(&COARSE), has(&FEW)) {
        (true, _) => Some("the grid is too coarse for the shortest waves of the scan"),
        (_, true) => Some("too few pixels or patches are in contact"),
        _ => None,
    }
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
