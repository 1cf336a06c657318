//! The desk: a scene, its files, and its models ready to answer.

use std::collections::BTreeMap;

use asperity::{Described, Model, shortest_digits};
use asperity_plot::{ScanPicture, draw_scan};
use asperity_scene::{HandedFiles, Material, SceneFile, parse_handed};
use asperity_topography::Glance;
use serde::Serialize;
use serde_json::{Value, json};

use crate::answer::{self, Compiled};
use crate::message::{Answer, LoadKeys, MaterialShown, Message, ModelShown, NumberShown, Shown};
use crate::press::{Event, press, scan};
use crate::refusal::Refusal;
use crate::shown::shown;
use crate::{advice, code, fields, link, picture, span, surface_keys};

/// The longest text of a scene, in bytes, as for scene files.
const MOST_TEXT: usize = 1 << 20;
/// The longest file, in bytes.
const MOST_FILE: usize = 512 << 20;
/// Most points of a drawn scan on a side.
const DRAWN: usize = 400;
/// Models whose laws take long to prepare.
const SLOW: [&str; 4] = ["gao", "at", "at-additive", "at-overlap"];

/// A scene with the files that it names, and its compiled models.
#[derive(Default)]
pub struct Desk {
    files: HandedFiles,
    text: String,
    file: Option<SceneFile>,
    compiled: BTreeMap<String, Result<Compiled, String>>,
}

impl Desk {
    /// Takes the bytes of a file that scenes may name; returns json with its checksum, or with a
    /// refusal.
    pub fn hand(&mut self, name: &str, bytes: Vec<u8>) -> String {
        let handed = || {
            if bytes.is_empty() {
                let reason = format!("{name} is empty (0 bytes): choose another file");
                return Err(Refusal::at("surface.file", reason));
            }
            if bytes.len() > MOST_FILE {
                let most = MOST_FILE >> 20;
                let reason = format!(
                    "{name} is larger than {most} MB: use the program, asperity surface {name}"
                );
                return Err(Refusal::at("surface.file", reason));
            }
            Ok(json!({ "name": name, "checksum": link::checksum(&bytes) }))
        };
        let answer = handed();
        if answer.is_ok() {
            self.files.insert(name.into(), bytes);
            self.forget();
        }
        reply(answer)
    }

    /// Answers a message in json with json: `{"ok": ..}` or `{"error": {message, line, field}}`.
    pub fn call(&mut self, message: &str) -> String {
        let message = serde_json::from_str(message).map_err(Refusal::new);
        reply(message.and_then(|message| self.answer(message)))
    }

    /// Solves the scan of the scene at mean pressures \[Pa\] of the slider's range, or at one;
    /// every event is passed on as json.
    pub fn press(&self, pressures: &[f64], mut happened: impl FnMut(&str)) -> String {
        let mut run = || {
            let file = self.scene()?;
            let all = span::Span::of(&file.scene).solved();
            let pressures = if pressures.is_empty() { &all } else { pressures };
            let tell = |event: &Event| {
                happened(&serde_json::to_string(event).unwrap_or_default());
            };
            press(&self.text, &self.files, pressures, tell)
        };
        reply(run())
    }

    fn forget(&mut self) {
        (self.file, self.text) = (None, String::new());
        self.compiled.clear();
    }

    fn scene(&self) -> Result<&SceneFile, Refusal> {
        self.file.as_ref().ok_or_else(|| Refusal::new("the scene has an error; correct it first"))
    }

    /// The models of these ids, compiled once.
    fn compile(&mut self, ids: &[String]) -> Result<(), Refusal> {
        let file = self.file.as_ref();
        let file = file.ok_or_else(|| Refusal::new("the scene has an error; correct it first"))?;
        for id in ids {
            let made = || Compiled::new(file, id).map_err(|refusal| refusal.message);
            self.compiled.entry(id.clone()).or_insert_with(made);
        }
        Ok(())
    }

    fn answer(&mut self, message: Message) -> Result<Value, Refusal> {
        match message {
            Message::Show { text } => json(self.show(text)),
            Message::Edit { text, changes } => {
                let rigid = changes.iter().find(|change| change.path == "rigid_counterface");
                let text = match rigid {
                    Some(change) => fields::with_rigid(&text, change.value.is_some())?,
                    None => fields::edit(&text, &changes)?,
                };
                json(text)
            }
            Message::Materials => {
                json(asperity_scene::materials().iter().map(material).collect::<Vec<_>>())
            }
            Message::Material { text, body, changes } => {
                let id = changes.first().and_then(|change| change.value.as_deref());
                json(fields::edit(&text, &fields::material(&text, body, id.unwrap_or_default()))?)
            }
            Message::Surface { text, way } => {
                json(fields::edit(&text, &surface_keys::changes(&way, self.scene()?)?)?)
            }
            Message::UseScan { text, name } => {
                let periodic =
                    if name.starts_with("random-") { &[("periodic", "true")][..] } else { &[] };
                json(fields::edit(&text, &surface_keys::scan(&name, periodic))?)
            }
            Message::Random { keys } => {
                let (name, bytes) = (keys.name(), keys.file()?);
                let checksum = link::checksum(&bytes);
                self.files.insert(name.clone(), bytes);
                self.forget();
                json(json!({ "name": name, "checksum": checksum }))
            }
            Message::Answer { models, load } => json(self.values(&models, &load)?),
            Message::Curve { models } => {
                self.compile(&models)?;
                let file = self.scene()?;
                let pressures = span::Span::of(&file.scene).pressures();
                let rows = |id: &String| {
                    let compiled = self.compiled.get(id)?.as_ref().ok()?;
                    Some((id.clone(), compiled.rows(file, id, &pressures)))
                };
                let rows: BTreeMap<String, String> = models.iter().filter_map(rows).collect();
                json(json!({ "head": answer::head(file).join(","), "rows": rows }))
            }
            Message::Draw { rows, view, load, solved } => {
                let file = self.scene()?;
                let (_, shown) = span::load(&load, &file.scene)?;
                json(picture::curves(file, &rows, &view, (&shown, load.unit == "Pa"), &solved)?)
            }
            Message::Scan => json(self.scan_picture()?),
            Message::Check { models, load } => {
                let file = self.scene()?;
                json(advice::check(file, &models, span::load(&load, &file.scene)?.0)?)
            }
            Message::Advise { load } => {
                let file = self.scene()?;
                json(advice::advise(file, span::load(&load, &file.scene)?.0)?)
            }
            Message::Export { model, form, units } => {
                json(code::table(self.scene()?, &model, &form, &units)?)
            }
            Message::Code { models, load } => {
                let file = self.scene()?;
                let (at, shown) = span::load(&load, &file.scene)?;
                json(code::code(file, &models, (at, &shown)))
            }
            Message::Law { model } => json(picture::law(self.scene()?, &model)?),
            Message::Link { state } => json(link::link(&state)?),
            Message::Unlink { link } => json(link::unlink(&link)?),
        }
    }

    /// Reads a text, whose scene answers later messages.
    fn show(&mut self, text: String) -> Shown {
        self.forget();
        let mut found = Shown {
            fields: BTreeMap::new(),
            way: "asperities",
            files: vec![],
            error: None,
            findings: Default::default(),
            numbers: vec![],
            models: vec![],
            views: vec![],
            scan: None,
        };
        if text.len() > MOST_TEXT {
            let reason =
                format!("the scene file is longer than {MOST_TEXT} bytes: shorten the text");
            found.error = Some(Refusal::at("the scene file", reason));
            return found;
        }
        found.fields = fields::fields(&text);
        found.way = surface_keys::way(&found.fields);
        found.files = found.fields.get("surface.file").cloned().into_iter().collect();
        let file = match parse_handed(&text, &self.files) {
            Ok(file) => file,
            Err(error) => {
                found.error = Some(error.into());
                return found;
            }
        };
        if let Ok(check) = file.check(None) {
            found.numbers = check.numbers.iter().map(number).collect();
        }
        found.findings = file.warnings.iter().cloned().chain(file.findings()).collect();
        found.findings = file.accepted(std::mem::take(&mut found.findings));
        (found.models, found.views) = (models(&file), answer::views(&file));
        found.scan = scan(&file);
        (self.text, self.file) = (text, Some(file));
        found
    }

    fn values(&mut self, models: &[String], load: &LoadKeys) -> Result<Answer, Refusal> {
        self.compile(models)?;
        let file = self.scene()?;
        let (at, load) = span::load(load, &file.scene)?;
        let (mut rows, mut findings) = (vec![], vec![]);
        for id in models {
            if let Some(Ok(compiled)) = self.compiled.get(id) {
                let (row, found) = compiled.row(file, id, at);
                rows.push(row);
                findings.extend(found);
            }
        }
        Ok(Answer { load, views: answer::views(file), rows, findings })
    }

    /// The picture and the numbers of the scan.
    fn scan_picture(&self) -> Result<Value, Refusal> {
        let file = self.scene()?;
        let (Some(scan), Some(measured)) = (&file.scan, &file.measured) else {
            return Err(Refusal::new("the scene has no scan"));
        };
        let level = asperity_topography::Level::usual(scan.is_periodic());
        let glance = Glance::new(scan, level, [None; 2], scan)?;
        let (heights, columns) = scan.coarse(DRAWN);
        let [dx, dy] = scan.pixel_size();
        let picture = ScanPicture {
            heights,
            columns,
            size: [scan.columns() as f64 * dx, scan.rows() as f64 * dy],
            marks: glance.roll_off.into_iter().chain(glance.cut_off).collect(),
            law: glance.hurst.map(|hurst| format!("power law, H = {hurst:.2}")).unwrap_or_default(),
            ..Default::default()
        };
        let svg = draw_scan(&picture, &scan.curves_csv(&glance))?;
        let moments: Vec<Value> = scan
            .scale_dependence()
            .iter()
            .map(|at| serde_json::to_value(at).unwrap_or_default())
            .collect();
        Ok(json!({
            "svg": svg,
            "statistics": &measured.statistics,
            "caption": scan.caption(&glance),
            "scales": moments,
        }))
    }
}

/// The models of a scene, those that it does not allow with the reason.
fn models(file: &SceneFile) -> Vec<ModelShown> {
    let (allowed, left_out) = file.models_beside_bem();
    let shown = |model: &Model, reason: Option<String>| {
        let citation = model.citation();
        ModelShown {
            id: model.id().into(),
            name: model.name().into(),
            source: format!("{} ({})", citation.authors, citation.year),
            slow: SLOW.contains(&model.id()),
            reason,
        }
    };
    let mut all: Vec<ModelShown> = allowed.iter().map(|model| shown(model, None)).collect();
    all.extend(left_out.iter().filter_map(|left_out| {
        Some(shown(&left_out.id.parse().ok()?, Some(left_out.reason.to_string())))
    }));
    all
}

fn material(material: &'static Material) -> MaterialShown {
    let body = &material.body;
    let numbers = [
        ("E", Some(body.youngs_modulus), "Pa"),
        ("ν", Some(body.poissons_ratio), ""),
        ("H", body.hardness, "Pa"),
        ("yield", body.yield_strength, "Pa"),
        ("k", body.thermal_conductivity, "W/(m K)"),
        ("ρ", body.electrical_resistivity, "Ω m"),
    ];
    let number = |(name, value, unit): (&str, Option<f64>, &str)| {
        value.map(|value| format!("{name} {}", shown(value, unit)))
    };
    let shown = numbers.into_iter().filter_map(number).collect::<Vec<_>>().join(", ");
    MaterialShown { id: &material.id, name: &material.name, shown, source: &material.source }
}

fn number(number: &asperity::DerivedNumber) -> NumberShown {
    NumberShown {
        name: number.name.replace('_', " "),
        digits: shortest_digits(number.value),
        shown: shown(number.value, number.unit),
        meaning: number.meaning.to_string(),
    }
}

fn json(value: impl Serialize) -> Result<Value, Refusal> {
    serde_json::to_value(value).map_err(Refusal::new)
}

fn reply<T: Serialize>(answer: Result<T, Refusal>) -> String {
    let text = match answer {
        Ok(value) => serde_json::to_string(&json!({ "ok": value })),
        Err(error) => serde_json::to_string(&json!({ "error": error })),
    };
    text.unwrap_or_else(|error| json!({ "error": Refusal::new(error) }).to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(desk: &mut Desk, message: Value) -> Value {
        serde_json::from_str(&desk.call(&message.to_string())).unwrap()
    }

    #[test]
    fn a_scene_is_shown_answered_and_drawn() {
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": asperity_scene::template() }));
        assert!(shown["ok"]["error"].is_null(), "{shown}");
        assert_eq!(shown["ok"]["fields"]["body[1].hardness"], "2e9");
        let load = json!({ "text": "100 N", "unit": "N" });
        let asked = json!({ "call": "answer", "models": ["ke", "gw"], "load": load });
        let answer = call(&mut desk, asked);
        assert_eq!(answer["ok"]["rows"][1]["model"], "gw");
        assert_eq!(answer["ok"]["load"]["pascals"], 1e6);
        let curve = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        let rows = curve["ok"]["rows"]["ke"].as_str().unwrap();
        let drawn = json!({ "call": "draw", "rows": [rows], "view": "tangent", "load": load, "solved": [] });
        assert!(call(&mut desk, drawn)["ok"].as_str().unwrap().starts_with("<svg"));
        let check = call(&mut desk, json!({ "call": "check", "models": ["gw"], "load": load }));
        assert!(check["ok"].is_array(), "{check}");
    }

    #[test]
    fn errors_have_line_and_field_and_the_desk_goes_on() {
        let mut desk = Desk::default();
        let text = asperity_scene::template().replace("hardness = 2e9", "hardness = \"2 GP\"");
        let shown = call(&mut desk, json!({ "call": "show", "text": text }));
        assert_eq!(shown["ok"]["error"]["field"], "body[1].hardness");
        let line = 1 + text.lines().position(|line| line.contains("2 GP")).unwrap();
        assert_eq!(shown["ok"]["error"]["line"], line);
        let refused = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        assert!(refused["error"]["message"].as_str().unwrap().contains("correct it first"));
        assert!(call(&mut desk, json!({ "call": "fly" }))["error"]["message"].is_string());
        let long = "#".repeat(MOST_TEXT + 1);
        let shown = call(&mut desk, json!({ "call": "show", "text": long }));
        assert!(shown["ok"]["error"]["message"].as_str().unwrap().contains("longer than"));
        let empty: Value = serde_json::from_str(&desk.hand("a.x3p", vec![])).unwrap();
        assert!(empty["error"]["message"].as_str().unwrap().starts_with("a.x3p is empty"));
    }

    #[test]
    fn a_random_surface_is_pressed_and_shown() {
        let mut desk = Desk::default();
        let keys = serde_json::to_value(crate::random::example()).unwrap();
        let made = call(&mut desk, json!({ "call": "random", "keys": keys }));
        let name = made["ok"]["name"].as_str().unwrap();
        let text = asperity_scene::template();
        let text = call(&mut desk, json!({ "call": "use-scan", "text": text, "name": name }));
        let shown = call(&mut desk, json!({ "call": "show", "text": text["ok"] }));
        assert!(shown["ok"]["error"].is_null(), "{shown}");
        assert_eq!(shown["ok"]["scan"], json!({ "rows": 64, "columns": 64, "refused": null }));
        let scan = call(&mut desk, json!({ "call": "scan" }));
        assert!(scan["ok"]["svg"].as_str().is_some_and(|svg| svg.starts_with("<svg")), "{scan}");
        let mut solved = 0;
        let answer = desk.press(&[2e8], |event| solved += usize::from(event.contains("solved")));
        assert_eq!((answer.as_str(), solved), ("{\"ok\":null}", 1));
    }
}
