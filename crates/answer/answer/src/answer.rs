//! What is known best about a scene at loads, in the lines that a reader needs.

use asperity::{
    At, Best, BestContact, Compared, ContactEngine, Datum, Described, Model, Other, Quantity,
    Request, Separation, SeparationUnit, Source, Tolerance, usual_reference,
};
use asperity_scene::{INTERFACE, SceneFile, Shape};

use crate::compiled::NO_EVIDENCE;
use crate::curve::{Beside, Inquiry};
use crate::models::grouped;
use crate::number::{fixed, prefixed};
use crate::ranges::with_ranges;
use crate::sheet::{ENDS, column_of_end};
use crate::subject::Outcome;
use crate::{Cell, Sheet, Silent, Watch};

/// The mean gap, which every answer has.
const GAP: &str = "mean_gap_m";
/// Most models beside the answer that are named.
const MOST_NAMED: usize = 3;

/// What is asked at loads.
#[derive(Debug, Clone)]
pub struct Answer {
    /// Quantities and loads.
    pub request: Request,
}

/// What stands behind an answer.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Basis {
    /// Models and solved surfaces, and of what the intervals are.
    pub by: String,
    /// The unknown of the surface that makes the answer wide, and the shares of all.
    pub widest: String,
    /// Other models, each with its deviation from the answer or why it is not valid.
    pub also: String,
}

/// What everyone asks of curved bodies.
const OF_BODIES: [Quantity; 13] = [
    Quantity::Approach,
    Quantity::ApproachBeyondHertz,
    Quantity::PeakPressure,
    Quantity::PeakPressureRatio,
    Quantity::EffectiveRadius,
    Quantity::AxisX,
    Quantity::AxisY,
    Quantity::Area,
    Quantity::CentralAreaFraction,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::TangentialStiffness,
    Quantity::ThermalConductance,
];

/// Whether these bodies have a quantity, and need it.
fn is_of(shape: Shape, quantity: Quantity) -> bool {
    let is_circle = match shape {
        Shape::Point { radius_x, radius_y } => (radius_x / radius_y - 1.0).abs() < 1e-12,
        Shape::Line { .. } => false,
    };
    let is_line = matches!(shape, Shape::Line { .. });
    let no_length = matches!(shape, Shape::Line { reference_length: None, .. });
    match quantity {
        Quantity::EffectiveRadius => is_circle,
        Quantity::AxisX => !is_circle,
        Quantity::AxisY => !is_circle && !is_line,
        Quantity::Approach | Quantity::Tangent => !no_length,
        other => !(no_length && other.is_of_joint()),
    }
}

/// Whether the bodies have the property that a quantity needs.
#[must_use]
pub fn has_property(file: &SceneFile, quantity: Quantity) -> bool {
    let given = |key| INTERFACE.iter().find(|field| field.name == key);
    let value = |key| given(key).and_then(|field| (field.get)(&file.scene.interface));
    quantity.property().is_none_or(|key| value(key).is_some())
}

impl Answer {
    /// These quantities, or those that everyone asks for, at loads.
    #[must_use]
    pub fn new(
        file: &SceneFile,
        quantities: &[Quantity],
        at: impl IntoIterator<Item = At>,
        tolerance: Tolerance,
    ) -> Self {
        let is_here = |of: &Quantity| file.shape().is_none_or(|shape| is_of(shape, *of));
        let of_joint = [Quantity::TangentialStiffness, Quantity::ThermalConductancePerArea];
        let mut usual = match file.shape() {
            None => [&Compared::QUANTITIES[..], &of_joint].concat(),
            Some(_) => OF_BODIES.to_vec(),
        };
        usual.retain(|of| is_here(of) && has_property(file, *of));
        let mut request = Request::default().at(at).within(tolerance);
        // The approach, which is the first, is given.
        if let (Some(At::Separation(_)), Some(first)) = (request.at.first(), usual.first_mut()) {
            *first = Quantity::Force;
        }
        request.quantities = if quantities.is_empty() { usual } else { quantities.to_vec() };
        Self { request }
    }

    /// Fills a sheet with a row for each load: the quantities and the mean gap, each with the ends
    /// of its interval where there is evidence or a range, in SI units.
    ///
    /// # Errors
    /// The errors of the models, if none has a value.
    pub fn answer(&self, file: &SceneFile, sheet: &mut Sheet) -> Outcome<Basis> {
        let results = sheet.results.len();
        with_ranges(file, sheet, |file, sheet| self.fill(file, sheet))?;
        let middle = file.middle()?;
        let at = self.request.at.first().copied().unwrap_or(At::Load(0.0));
        let widest = sheet.results.drain(results..).collect::<Vec<_>>().join("; ");
        if file.shape().is_some() {
            let by = format!("{}, {NO_EVIDENCE}", usual_reference(&middle.scene));
            return Ok(Basis { by, widest, also: String::new() });
        }
        let best = middle.best().on(&middle.scene, self.request.tolerance)?;
        let mut basis = basis(&best, &self.request.quantities, at);
        if self.request.at.len() > 1 {
            let load = at.load(&middle.scene).map(|load| in_words(load, "N"));
            basis.by = format!("at {}, {}", load.unwrap_or_default(), basis.by);
        }
        Ok(Basis { widest, ..basis })
    }

    fn fill(&self, file: &SceneFile, sheet: &mut Sheet) -> Outcome {
        let models = vec![file.model(Best::<Model>::ID)?];
        Inquiry::new(file, models, self.request.clone()).answer(sheet, &Silent)?;
        let Some(metres) = sheet.column("separation_m") else { return Ok(()) };
        // The mean gap in place of the separations, whose plane is the scene's.
        let mean_gap = |metres: f64| {
            let from = file.spec.separation_from;
            let at = Separation { from, ..Separation::metres(metres) };
            let found = at.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, &file.scene);
            Some(found.ok()?.value)
        };
        for row in &mut sheet.rows {
            row.push(row[metres].map(mean_gap));
            row.drain(metres - 1..=metres);
        }
        sheet.heads.push(GAP.into());
        sheet.heads.drain(metres - 1..=metres);
        sheet.with_ends.push(GAP.into());
        Ok(())
    }

    /// Every model beside the answer, each quantity with its deviation from that.
    ///
    /// # Errors
    /// The errors of the models, if none has a value.
    pub fn all(&self, file: &SceneFile, sheet: &mut Sheet, watch: &dyn Watch) -> Outcome {
        let best = file.model(Best::<Model>::ID)?;
        let models = [best.clone()].into_iter().chain(file.models_beside_bem().0).collect();
        let inquiry = Inquiry::new(file, models, self.request.clone());
        Inquiry { beside: Beside::Deviations(best), ..inquiry }.answer(sheet, watch)
    }
}

/// What stands behind the answer at a place, in these quantities and the mean gap.
#[must_use]
pub fn basis(best: &BestContact<Model>, quantities: &[Quantity], at: At) -> Basis {
    let asked = quantities.iter().filter_map(|one| Compared::behind(*one));
    let mut compared: Vec<Compared> = asked.chain([Compared::MeanGap]).collect();
    compared.sort_unstable();
    compared.dedup();
    let of = |of: &Compared| {
        let known = best.known(*of, at).ok()?;
        let (by, basis) = match known.source {
            Source::Solved => ("boundary elements on this scan".into(), String::new()),
            Source::Evidence => {
                let basis = best.basis(at).ok()?;
                let text = match known.ends {
                    Some(_) => format!(", corrected by solved surfaces like this one ({basis})"),
                    None => format!(
                        ", corrected by solved surfaces ({basis}), without an interval: {}",
                        best.why(*of, at).1
                    ),
                };
                (best.by(*of, at)?.id().into(), text)
            }
            Source::Model(id, outside) => {
                let invalid = outside.map(|why| format!(" (not valid here: {})", why.code));
                let why = best.why(*of, at).1;
                (id + &invalid.unwrap_or_default(), format!(", without an interval: {why}"))
            }
        };
        Some((basis, (by, of.label())))
    };
    let group = |(basis, members): (String, Vec<(String, &str)>)| {
        let members = grouped(members).into_iter();
        let members = members.map(|(id, labels)| format!("{id} for {}", labels.join(", ")));
        format!("{}{basis}", members.collect::<Vec<_>>().join(", "))
    };
    let mut by: Vec<String> =
        grouped(compared.iter().filter_map(of)).into_iter().map(group).collect();
    let asked = quantities.iter().copied().map(Some).chain([None]);
    let interval = asked.into_iter().find_map(|one| best.interval_at(one, at));
    by.extend(interval.map(|interval| format!("between from and to: {}", interval.of)));
    let (by, widest, also) = (by.join("; "), String::new(), also(best, at));
    Basis { by, widest, also }
}

/// The nearest other models, and those that are not valid.
fn also(best: &BestContact<Model>, at: At) -> String {
    let of = Compared::Area;
    let own = |of| best.by(of, at).map(Described::id);
    let is_own = |other: &Other<Model>, of| own(of) == Some(other.model.id());
    let (mut valid, mut others): (Vec<Other<Model>>, Vec<_>) =
        best.others(at).into_iter().partition(|other| other.outside.is_none());
    valid.retain(|other| !is_own(other, of));
    others.retain(|other| !Compared::ALL.iter().any(|of| is_own(other, *of)));
    let off = |other: &Other<Model>| {
        let (_, off) = other.off.iter().find(|(known, _)| *known == of)?;
        let side = if *off < 0.0 { "low" } else { "high" };
        Some((off.abs(), format!("{} {:.0} % {side}", other.model.id(), 100.0 * off.abs())))
    };
    let mut near: Vec<(f64, String)> = valid.iter().filter_map(off).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let near: Vec<String> = near.into_iter().take(MOST_NAMED).map(|(_, text)| text).collect();
    let mut text = vec![];
    if !near.is_empty() {
        text.push(format!("{} in {}", near.join(", "), of.label()));
    }
    let why = |other: Other<Model>| Some((other.outside?.code, other.model.id().to_string()));
    let invalid = grouped(others.into_iter().filter_map(why)).into_iter();
    let invalid: Vec<_> =
        invalid.map(|(code, ids)| format!("{} ({code})", ids.join(", "))).collect();
    if !invalid.is_empty() {
        text.push(format!("not valid here: {}", invalid.join(", ")));
    }
    text.join("; ")
}

/// The label of a column of an answer and its unit: the real area is a share of the nominal one.
fn labelled(head: &str, is_flat: bool) -> Option<(&'static str, &'static str)> {
    if head == GAP {
        return Some((Compared::MeanGap.label(), "m"));
    }
    let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.column() == head)?;
    Some(match quantity {
        Quantity::Pressure => return None,
        Quantity::Area if !is_flat => ("real area", "mm2"),
        Quantity::CentralAreaFraction => ("share of real contact in the middle", "%"),
        Quantity::Area | Quantity::AreaFraction => ("real area, share of the nominal", "%"),
        Quantity::Tangent => (Compared::Stiffness.label(), "N/m"),
        Quantity::UnloadingStiffness => (Compared::UnloadingStiffness.label(), "N/m"),
        other => (other.label(), other.unit()),
    })
}

/// The rows of an answer as lines: a quantity with its value, the ends of its interval and a unit
/// that suits it; of several loads each with its load.
#[must_use]
pub fn lines(file: &SceneFile, sheet: &Sheet) -> Sheet {
    let several = sheet.rows.len() > 1;
    let (at, place, si) = match sheet.column("load_N") {
        Some(_) => ("load_N", "load", "N"),
        None => ("approach_m", "approach", "m"),
    };
    let load: &[&str] = if several { &[place] } else { &[] };
    let mut lines = Sheet::default();
    let is_end = |head: &String| sheet.column(&column_of_end(head, ENDS[0])).is_some();
    let has_ends = sheet.heads.iter().any(is_end);
    let ends: &[&str] = if has_ends { &["from", "to"] } else { &[] };
    lines.under(&[load, &["quantity", "value"], ends, &["unit"]]);
    // A share of a nominal area within a range is no ratio of two ends.
    let is_flat = file.shape().is_none() && file.has_fixed_area();
    for row in &sheet.rows {
        let number = |head: &str| row[sheet.column(head)?].number();
        for head in &sheet.heads {
            let Some((label, unit)) = labelled(head, is_flat) else { continue };
            let of_nominal = if head == "area_m2" { file.scene.nominal_area } else { 1.0 };
            let ends = ENDS.map(|end| number(&column_of_end(head, end)));
            let (factor, unit) = match (unit, number(head)) {
                ("%", _) => (0.01 * of_nominal, unit.into()),
                ("mm2", _) => (1e-6, unit.into()),
                (unit, value) => prefixed(value.unwrap_or(0.0), unit),
            };
            let value = number(head).map(|value| value / factor);
            let shown = |x: Option<f64>| x.map_or("–".into(), |x| fixed(x, value.unwrap_or(x)));
            let ends = ends.map(|end| shown(end.map(|end| end / factor)));
            let load = number(at).map_or(String::new(), |load| in_words(load, si));
            let load = load.as_str();
            let ends = ends.iter().map(|end| &**end).filter(|_| has_ends);
            let value = shown(value);
            let texts = [label, &value].into_iter().chain(ends).chain([&*unit]);
            let all = [load].into_iter().filter(|_| several).chain(texts);
            lines.rows.push(all.map(Cell::from).collect());
        }
    }
    lines
}

/// The load of an answer, its pressure on flat bodies and what is in contact: `at 20 kN, 50 MPa,
/// steel-4140-tempered on aluminium-6082-t6, ground, ra 0.8 um`.
#[must_use]
pub fn title(file: &SceneFile, at: At) -> String {
    let [load, pressure] = [(at.load(&file.scene), "N"), (at.pressure(&file.scene), "Pa")]
        .map(|(value, unit)| in_words(value.unwrap_or(0.0), unit));
    let place = match at {
        At::Separation(approach) => format!("an approach of {}", in_words(-approach.value, "m")),
        _ if file.shape().is_some() => load,
        _ => format!("{load}, {pressure}"),
    };
    format!("at {place}, {}", file.in_words())
}

fn in_words(value: f64, unit: &str) -> String {
    let (factor, unit) = prefixed(value, unit);
    format!("{} {unit}", crate::rounded(value / factor))
}
