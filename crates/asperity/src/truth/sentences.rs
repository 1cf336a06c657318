//! Models beside boundary elements on a scan, in sentences.

use crate::evidence::{NONE, compile};
use crate::recommend::evidence_of;
use crate::{
    At, Compared, ContactError, Described, EvidenceAt, Model, Quantity, Ratio, Request, Scene,
    SurfaceShape, Truth, ranking,
};

/// Codes of notes on loads that few pixels or patches carry.
const FEW: [&str; 2] = ["few-pixels", "few-patches"];
/// Rounding of ratios that are equal.
const SAME: f64 = 1e-9;
/// Code of a note on a grid too coarse for the shortest waves.
const COARSE: [&str; 1] = ["short-waves"];

impl Truth {
    fn has_note(&self, codes: &[&str]) -> bool {
        self.notes.iter().any(|note| codes.contains(&note.code))
    }

    /// A quantity of a model relative to boundary elements on this scan.
    fn ratio(&self, id: &str, quantity: Compared) -> Option<Ratio> {
        let (_, state) = self.models.iter().find(|(model, _)| model.id() == id)?;
        let off = self.deviation(state);
        match quantity {
            Compared::Area => off.area_fraction.map(|off| Ratio::exactly(1.0 + off)),
            Compared::Stiffness => off.stiffness.map(|off| Ratio::exactly(1.0 + off)),
            Compared::MeanGap => off.mean_gap.map(Ratio::exactly),
            Compared::UnloadingStiffness => None,
        }
    }
}

/// Why models are not ranked on solutions of a scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unranked {
    /// The grid is too coarse for the shortest waves.
    CoarseGrid,
    /// Too few pixels or patches are in contact at every load.
    FewInContact,
}

impl Unranked {
    /// The reason, and what to do.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::CoarseGrid => {
                "the grid is too coarse for the shortest waves of the scan; filter the scan or measure it on smaller pixels"
            }
            Self::FewInContact => "too few pixels or patches are in contact; increase the load",
        }
    }
}

/// Whether models are not ranked on solutions of a scan whose notes have these codes, a list a
/// load.
#[must_use]
pub fn unranked(codes: &[Vec<&str>]) -> Option<Unranked> {
    let has = |list: &[&str], codes: &Vec<&str>| codes.iter().any(|code| list.contains(code));
    match codes {
        _ if codes.iter().any(|codes| has(&COARSE, codes)) => Some(Unranked::CoarseGrid),
        _ if codes.iter().all(|codes| has(&FEW, codes)) => Some(Unranked::FewInContact),
        _ => None,
    }
}

/// Which models are nearest to boundary elements over these loads, in area and in stiffness in
/// first loading. Loads that few pixels or patches carry do not count; on a grid too coarse for the
/// shortest waves of the scan no model is ranked.
#[must_use]
pub fn summary(found: &[Truth]) -> String {
    let codes = |truth: &Truth| truth.notes.iter().map(|note| note.code).collect();
    if let Some(why) = unranked(&found.iter().map(codes).collect::<Vec<_>>()) {
        return format!("models are not ranked: {}", why.reason());
    }
    let resolved = || found.iter().filter(|truth| !truth.has_note(&FEW));
    let count = resolved().count();
    let models = found.first().map_or(&[][..], |first| &first.models);
    let off = |id: &str, quantity| {
        let of = |truth: &Truth| Some(truth.ratio(id, quantity)?.deviation(quantity));
        resolved().map(of).collect()
    };
    let ids = models.iter().map(|(model, _)| model.id());
    let nearest = ranking::nearest_in_each(ids, off, &ranking::NAMES[..2]).join("; ");
    match found.len() {
        all if all == count => format!("over these loads, {nearest}"),
        all => format!(
            "over the loads with enough pixels and patches in contact ({count} of {all}), {nearest}"
        ),
    }
}

/// How far a model is from boundary elements on this scan, and whether that lies in the interval
/// of the solved surfaces, a line for each quantity; or why there is no interval. Loads that few
/// pixels or patches carry do not count.
///
/// # Errors
/// Those of the model on the scene.
pub fn beside_table(
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
    let contact = compile(model, scene, &request)?;
    let table = evidence_of(model, &*contact, shape, &request)?;
    let covered = |place: &EvidenceAt| -> Option<&Truth> {
        let here = |truth: &&&Truth| At::Pressure(truth.pressure) == place.at;
        resolved.iter().find(here).copied().filter(|_| place.expected.is_ok())
    };
    let covered: Vec<(&Truth, &EvidenceAt)> =
        table.iter().filter_map(|place| Some((covered(place)?, place))).collect();
    let Some((_, EvidenceAt { expected: Ok(first), .. })) = covered.first() else {
        let reason = table.iter().find_map(|place| place.expected.as_ref().err());
        let reason = reason.map_or_else(String::new, ToString::to_string);
        let reason = reason.trim_start_matches(NONE).trim_start_matches(": ");
        return Ok(vec![format!("the solved surfaces do not cover this scan: {reason}")]);
    };
    let line = |quantity: Compared| {
        let both = |(truth, place): &(&Truth, &EvidenceAt)| {
            Some((truth.ratio(model.id(), quantity)?, place.ratio(model.id(), quantity)?))
        };
        let both: Vec<(Ratio, Ratio)> = covered.iter().filter_map(both).collect();
        // An area of F/H is an end of its interval.
        let inside = |(scan, table): &&(Ratio, Ratio)| {
            (table.low - SAME..=table.high + SAME).contains(&scan.ratio)
        };
        let (all, different) = (both.len(), both.iter().filter(|pair| !inside(pair)).count());
        let (scan, table) =
            both.into_iter().reduce(|(a, b), (c, d)| (a.with(c, quantity), b.with(d, quantity)))?;
        let (name, scan, table) = (model.name(), scan.words(quantity), table.words(quantity));
        let verdict = match different {
            0 => "the solved surfaces agree".into(),
            some if some == all => "the solved surfaces differ".into(),
            some => format!("the solved surfaces differ at {some} of {all} loads"),
        };
        let basis = first.basis();
        Some(format!("{name} {scan} on this scan; {verdict}: {name} {table} ({basis})"))
    };
    Ok(Compared::ALL.into_iter().filter_map(line).collect())
}
