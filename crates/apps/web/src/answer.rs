//! Values of models at loads, as `asperity curve` prints them.

use asperity::recommended::JKR;
use asperity::{
    At, Best, Code, ContactError, Described, Finding, Findings, Model, Quantity, Request, Severity,
    Tolerance, shortest_digits,
};
use asperity_answer::{
    ADHESIVE, Answer, Asked, ENDS, Line, Numbers, OPENING, Search, column_of_end, has_property,
};
use asperity_scene::SceneFile;
use serde::Serialize;
use serde_json::{Value, json};

use crate::labels::{message, raised};
use crate::refusal::Refusal;
use crate::shown::ranged;
use crate::span::Span;

/// The quantities that every scene has; models are held against the answer in the first two.
const USUAL: [Quantity; 6] = [
    Quantity::AreaFraction,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::TangentialStiffness,
    Quantity::MeanPressure,
    Quantity::Contacts,
];

/// Those that curved bodies have first, with the approach in the place of the separation.
const OF_BODIES: [Quantity; 5] = [
    Quantity::Approach,
    Quantity::Area,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::PeakPressure,
];

/// The quantities of a scene: conductances where the bodies have the property.
pub(crate) fn quantities(file: &SceneFile) -> Vec<Quantity> {
    if file.shape().is_some() {
        let usual = Answer::new(file, &[], [At::Load(1.0)], Tolerance::default());
        let others = usual.request.quantities.into_iter().filter(|q| !OF_BODIES.contains(q));
        return OF_BODIES.into_iter().chain(others).collect();
    }
    let conductances = [Quantity::ThermalConductance, Quantity::ElectricalConductance];
    let had = conductances.into_iter().filter(|of| has_property(file, *of));
    USUAL.into_iter().chain(had).collect()
}

/// A column of values, which can be drawn.
#[derive(Debug, Serialize)]
pub(crate) struct Column {
    pub(crate) id: String,
    pub(crate) label: &'static str,
    pub(crate) definition: String,
    /// Its name in a csv, which ends with the unit.
    #[serde(skip)]
    pub(crate) head: String,
    #[serde(skip)]
    pub(crate) unit: &'static str,
}

impl From<Quantity> for Column {
    fn from(of: Quantity) -> Self {
        let (label, definition) = (of.label(), of.definition().into());
        Self { id: of.to_string(), label, definition, head: of.column(), unit: of.unit() }
    }
}

impl Column {
    /// A column under its head, which the id follows from.
    pub(crate) fn new([head, unit, label]: [&'static str; 3], definition: String) -> Self {
        let name = head.trim_end_matches(&unit.replace('/', "_per_")).trim_end_matches('_');
        let id = name.replace('_', "-");
        Self { id, label, definition, head: head.into(), unit }
    }

    /// The separation of a scene.
    pub(crate) fn separation(file: Option<&SceneFile>) -> Self {
        let from = file.map_or("the mean of the asperity heights", SceneFile::plane);
        let definition = format!("Distance of the surfaces, from {from} to the other surface.");
        Self::new(["separation_m", "m", "separation"], definition)
    }

    /// Its names in a csv: its own and, with ends, the names of these.
    pub(crate) fn heads(&self, with_ends: bool) -> Vec<String> {
        let ends = ENDS.map(|end| column_of_end(&self.head, end));
        [self.head.clone()].into_iter().chain(ends.into_iter().filter(|_| with_ends)).collect()
    }

    /// A value as shown with all its digits in SI units.
    pub(crate) fn known(&self, known: &Known) -> Value {
        let text = match known.ends.filter(|_| known.ranged) {
            ends @ Some(_) if self.head == "area_fraction" => ranged(known.value, ends, "%"),
            ends => ranged(known.value, ends, self.unit),
        };
        let digits = shortest_digits(known.value);
        let mut cell = json!({ "quantity": self.id, "digits": digits, "shown": text });
        if let Some(bound) = known.bound {
            cell["bound"] = bound.into();
        }
        for (end, value) in ["lower", "upper"].into_iter().zip(known.ends.iter().flatten()) {
            cell[end] = shortest_digits(*value).into();
        }
        cell
    }

    /// A value, or the reason why there is none.
    pub(crate) fn cell(&self, found: &Result<Known, String>) -> Value {
        let none = |reason: &String| json!({ "quantity": self.id, "shown": raised(reason) });
        found.as_ref().map_or_else(none, |known| self.known(known))
    }
}

/// The separation of flat bodies and the quantities; without a scene those that all have.
pub(crate) fn columns(file: Option<&SceneFile>) -> Vec<Column> {
    let quantities = file.map_or(USUAL.to_vec(), quantities).into_iter().map(Column::from);
    let is_flat = file.is_none_or(|file| file.shape().is_none());
    is_flat.then(|| Column::separation(file)).into_iter().chain(quantities).collect()
}

/// A value with its ends: those at the ends of the ranges of the surface, or of an interval that
/// holds nine of ten surfaces.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Known {
    pub(crate) value: f64,
    pub(crate) ends: Option<[f64; 2]>,
    /// A bound on its error.
    bound: Option<f64>,
    /// Whether the ends are those of the ranges of the surface, too.
    pub(crate) ranged: bool,
    /// Whether boundary elements on this scan gave it at this load.
    pub(crate) solved: bool,
}

impl Known {
    /// Without ends.
    pub(crate) fn new(value: f64, solved: bool) -> Self {
        Self { value, solved, ..Self::default() }
    }

    /// Over the ranges of the surface.
    pub(crate) fn between(self, ends: [f64; 2]) -> Self {
        Self { ends: Some(ends), ranged: true, ..self }
    }
}

/// A scene in the middle of its ranges, and at the points at which answers are looked for.
#[derive(Debug, Default)]
pub(crate) struct Scenes {
    pub(crate) all: Vec<SceneFile>,
    ranges: Option<(SceneFile, Search)>,
}

impl std::ops::Deref for Scenes {
    type Target = [SceneFile];

    fn deref(&self) -> &[SceneFile] {
        &self.all
    }
}

impl Scenes {
    pub(crate) fn of(file: &SceneFile) -> Result<Self, ContactError> {
        let points = file.points()?;
        let search = Search::over(&points, file.shape().is_some());
        let ranges = (!points.all.is_empty()).then(|| (file.clone(), search.clone()));
        let first = points.all.into_iter().take(search.first());
        Ok(Self { all: [points.middle].into_iter().chain(first).collect(), ranges })
    }
}

/// A model on each scene, ready for many loads.
#[derive(Debug)]
pub(crate) struct Compiled {
    id: String,
    all: Vec<Asked>,
}

/// The model of an id on a scene with all quantities that it has.
fn asked(file: &SceneFile, id: &str, at: &[At]) -> Result<Asked, Refusal> {
    let request = Request::new(quantities(file)).at(at.iter().copied());
    Ok(Asked::new(file, &file.model(id)?, &request, false)?)
}

/// The model of an id on each scene.
pub(crate) fn compile(scenes: &[SceneFile], id: &str) -> Result<Compiled, Refusal> {
    let of = |file: &SceneFile| asked(file, id, &Span::of(file).prepared());
    Ok(Compiled { id: id.into(), all: scenes.iter().map(of).collect::<Result<_, _>>()? })
}

/// The values of a model at one load or one pressure, or the reasons why there are none.
type Cells = Vec<Result<Known, String>>;

/// The values of a model at places with their ends, and what is found about them. At several
/// places, for a picture, the ends are those at the fixed points.
fn values(scenes: &Scenes, compiled: &Compiled, places: &[At]) -> (Vec<Cells>, Vec<Finding>) {
    let [file, ..] = &**scenes else { return Default::default() };
    let quantities = quantities(file);
    let is_flat = file.shape().is_none();
    let of_line = |line: &Line| -> Cells {
        let known = |value, bound, ends| Known { value, bound, ends, ..Known::default() };
        let separation = line.separation[1].as_ref();
        let separation = separation.map(|value| known(*value, None, line.between));
        let values = line.values.iter().zip(&quantities).zip(&line.intervals);
        let values = values.map(|((found, quantity), interval)| {
            let ends = interval.as_ref().map(|of| [of.lower, of.upper]);
            found.as_ref().map(|found| known(found.value(), Some(found.bound(*quantity)), ends))
        });
        let all = is_flat.then_some(separation).into_iter().chain(values);
        all.map(|found| found.map_err(|error| error.to_string())).collect()
    };
    let mut all = scenes.iter().zip(&compiled.all).map(|(file, asked)| asked.lines(file, places));
    let Some((middle, warnings)) = all.next() else { return Default::default() };
    let mut rows: Vec<Cells> = middle.iter().map(of_line).collect();
    let Some((ranges, search)) = &scenes.ranges else { return (rows, warnings) };
    // Both ends of each value, row by row; the first of them stands for both without an interval.
    let ends = |cells: &Cells| -> Numbers {
        let of_cell = |cell: &Result<Known, String>| {
            let known = cell.as_ref().ok();
            [0, 1].map(|end| Some(known?.ends.map_or(known?.value, |ends| ends[end])))
        };
        cells.iter().flat_map(of_cell).collect()
    };
    let numbers = |(lines, _): (Vec<Line>, _)| -> Numbers {
        lines.iter().map(of_line).flat_map(|row| ends(&row)).collect()
    };
    let first = all.map(numbers).collect();
    let middle: Numbers = rows.iter().flat_map(ends).collect();
    let is_picture = places.len() > 1;
    let has_intervals = compiled.id == Best::<Model>::ID;
    let of_cell = match has_intervals {
        _ if is_picture => [[false; 2]; 2],
        true => [[true, false], [false, true]],
        false => [[true; 2], [false; 2]],
    };
    let sought = of_cell.repeat(middle.len() / 2);
    let fill = |shares: &[Vec<f64>]| {
        let at = |shares: &Vec<f64>| {
            let file = ranges.point(shares)?;
            Ok::<_, Refusal>(numbers(asked(&file, &compiled.id, places)?.lines(&file, places)))
        };
        shares.iter().map(at).collect::<Result<Vec<Numbers>, Refusal>>()
    };
    let found = search.ends(&middle, first, &sought, fill);
    for (place, cell) in rows.iter_mut().flatten().enumerate() {
        let second = usize::from(has_intervals);
        let ends = found.as_ref().map_err(|refused| refused.message.clone()).and_then(|found| {
            let [lower, upper] = [found[2 * place], found[2 * place + second]];
            let ends = lower.and_then(|lower| Ok([lower[0], upper?[1]]));
            ends.map_err(|why| why.text().to_string())
        });
        let known = std::mem::replace(cell, Err(String::new()));
        *cell = known.and_then(|known| Ok(known.between(ends?)));
    }
    (rows, warnings)
}

/// The values of a model at one load.
#[derive(Debug, Default)]
pub(crate) struct Row {
    pub(crate) model: String,
    pub(crate) cells: Cells,
    /// Why there are none.
    pub(crate) reason: Option<String>,
    /// Why no contact has them.
    pub(crate) mark: Option<String>,
    /// Why the load is out of its range.
    pub(crate) outside: Option<String>,
    pub(crate) findings: Findings,
}

impl Row {
    /// A compiled model at a load.
    pub(crate) fn of(scenes: &Scenes, compiled: &Compiled, at: At) -> Self {
        let id = &*compiled.id;
        let mut row = Self { model: id.into(), ..Self::default() };
        let (Some(file), Some(own)) = (scenes.first(), compiled.all.first()) else { return row };
        let (mut cells, warnings) = values(scenes, compiled, &[at]);
        row.cells = cells.pop().unwrap_or_default();
        let [mut found, _] = own.findings(file, &[at]);
        // Values may be impossible because of an implausible input.
        let is_impossible = |one: &&Finding| match one.code {
            Code::BeyondFullContact => true,
            Code::Crowded => one.value > 1.0,
            _ => false,
        };
        let mark = found.iter().find(is_impossible).filter(|_| !file.findings().are_implausible());
        row.mark = mark.map(message);
        let is_outside = |one: &&Finding| {
            one.code.is_of_model() && one.code != Code::Yields && one.severity != Severity::Note
        };
        row.outside = found.iter().find(is_outside).map(message);
        found.extend(warnings.into_iter().filter(|one| one.severity < Severity::Note));
        row.findings = found;
        let (model, load) = (own.model(), at.load(&file.scene).unwrap_or_default());
        if row.cells.iter().all(Result::is_err) {
            let why = row.cells.first().and_then(|cell| cell.as_ref().err());
            let why = why.map(|why| raised(why)).unwrap_or_default();
            row.reason = Some(match load < 0.0 {
                true if !model.validity().adhesive => {
                    format!("models without adhesion carry no tension; use {ADHESIVE}")
                }
                true if id == JKR => why + OPENING,
                _ => why,
            });
        }
        row
    }

    /// Marks what has no interval as solved on this scan.
    pub(crate) fn solved(&mut self) {
        let known = self.cells.iter_mut().flatten();
        known.filter(|known| known.ends.is_none()).for_each(|known| known.solved = true);
    }

    /// The values of a column.
    pub(crate) fn value(&self, column: usize) -> Option<&Known> {
        self.cells.get(column)?.as_ref().ok()
    }
}

/// The rows of a model at pressures, as a csv without its head; blank where there is no value. Of
/// a surface that is known within ranges, each value has its ends behind it.
pub(crate) fn rows(scenes: &Scenes, compiled: &Compiled, pressures: &[f64]) -> String {
    let span = Span::of(&scenes[0]);
    let places: Vec<At> = pressures.iter().map(|pressure| span.at(*pressure)).collect();
    let (rows, _) = values(scenes, compiled, &places);
    let digits = |number: Option<f64>| {
        number.filter(|n| n.is_finite()).map_or(String::new(), shortest_digits)
    };
    let mut csv = String::new();
    for (at, row) in places.iter().zip(&rows) {
        let place = [at.load(&scenes[0].scene), at.pressure(&scenes[0].scene)];
        let values = row.iter().flat_map(|cell| {
            let known = cell.as_ref().ok();
            let ends = [0, 1].map(|k| Some(known?.ends?[k]));
            let ends = ends.into_iter().filter(|_| scenes.len() > 1);
            [known.map(|known| known.value)].into_iter().chain(ends)
        });
        let cells: Vec<String> = place.into_iter().chain(values).map(digits).collect();
        csv += &format!("{},{}\n", compiled.id, cells.join(","));
    }
    csv
}

/// The head of [`rows`]: of each column its own name and, with ends, the names of these.
pub(crate) fn head(columns: &[Column], with_ends: bool) -> String {
    let heads: Vec<String> = columns.iter().flat_map(|column| column.heads(with_ends)).collect();
    format!("model,load_N,pressure_Pa,{}", heads.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scenes() -> Scenes {
        let file = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        Scenes::of(&file.unwrap()).unwrap()
    }

    fn of(scenes: &Scenes, id: &str, at: At) -> Row {
        Row::of(scenes, &compile(scenes, id).unwrap(), at)
    }

    #[test]
    fn rows_and_curves_are_the_answers_of_the_library() {
        let scenes = scenes();
        let ke = compile(&scenes, "ke").unwrap();
        let row = Row::of(&scenes, &ke, At::Pressure(1e6));
        let request = Request::new(quantities(&scenes[0])).at([At::Pressure(1e6)]);
        let response = scenes[0].model("ke").unwrap().solve(&scenes[0].scene, &request).unwrap();
        for (k, quantity) in (1..).zip(quantities(&scenes[0])) {
            let (found, wanted) = (row.value(k).unwrap(), response.values(quantity).unwrap()[0]);
            assert!((found.value / wanted - 1.0).abs() < 1e-13, "{quantity}: {found:?} {wanted}");
            assert!(found.bound.unwrap() < 1e-9);
        }
        let csv = rows(&scenes, &ke, &[1e6, 2e6]);
        let first: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
        let head = head(&columns(Some(&scenes[0])), false);
        assert_eq!(first.len(), head.split(',').count());
        let area = head.split(',').position(|name| name == "area_fraction").unwrap();
        // Several loads are evaluated together.
        let (one, many) = (first[area].parse::<f64>().unwrap(), row.value(1).unwrap().value);
        assert!((one / many - 1.0).abs() < 1e-13, "{one} {many}");
    }

    #[test]
    fn a_model_without_a_quantity_has_the_others_and_the_reason() {
        let scenes = scenes();
        let row = of(&scenes, "gao", At::Load(100.0));
        assert!(row.value(1).is_some());
        assert!(!row.cells[3].as_ref().unwrap_err().is_empty());
        assert!(compile(&scenes, "dmt").is_err());
    }

    fn is_marked(text: &str, id: &str, at: At) -> bool {
        let file = asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        of(&Scenes::of(&file).unwrap(), id, at).mark.is_some()
    }

    #[test]
    fn what_no_contact_has_is_marked() {
        let text = asperity_scene::template();
        assert!(is_marked(text, "persson-fudge", At::Load(1e30)));
        for id in ["gw", "ke", "persson-fudge"] {
            assert!(!is_marked(text, id, At::Load(100.0)));
        }
        let soft = include_str!("../../../answer/scene/examples/elastomer-on-glass.toml");
        assert!(is_marked(soft, "gw", At::Pressure(1.5e6)));
        assert!(is_marked(soft, "persson", At::Pressure(1e7)));
        assert!(!is_marked(soft, "gw", At::Pressure(1e4)));
        // Not where a field has a wrong unit.
        let wrong = text.replacen("210e9", "210", 1);
        assert!(!is_marked(&wrong, "gw", At::Load(100.0)));
    }
}
