//! The desk: a scene, its files, and its models ready to answer.

use std::collections::BTreeMap;

use asperity::{BestContact, Code, Finding, Model, SolvedContact, Tolerance};
use asperity_scene::{HandedFiles, SceneFile};
use serde_json::{Value, json};

use crate::advice::BEST;
use crate::answer::{Compiled, Row, Scenes};
use crate::files::{admit, usable};
use crate::message::{Message, Solved};
use crate::refusal::Refusal;
use crate::span::{Load, LoadKeys, Span};
use crate::{
    advice, answer, fields, labels, link, picture, press, read_scene, scan_report, surface_keys,
    table,
};

/// A scene with the files that it names, and its compiled models.
#[derive(Default)]
pub struct Desk {
    files: HandedFiles,
    file: Option<SceneFile>,
    /// The scene or, where numbers are known within ranges, those in the middle and at points of
    /// these.
    scenes: Scenes,
    /// Models on all of these, or why the scene refuses them.
    compiled: BTreeMap<String, Result<Compiled, String>>,
    /// What stands behind the answers on the first of these.
    best: Option<BestContact<Model>>,
    /// The text whose surface was described in another way, and what was made of it.
    described: Option<[String; 2]>,
}

impl Desk {
    /// Takes the bytes of a file that scenes may name; returns json with its checksum, or with a
    /// refusal.
    pub fn hand(&mut self, name: &str, bytes: Vec<u8>) -> String {
        reply(admit(name, bytes.len() as u64).map(|()| self.keep(name, bytes)))
    }

    fn keep(&mut self, name: &str, bytes: Vec<u8>) -> Value {
        let checksum = link::checksum(&bytes);
        self.files.insert(name.into(), bytes);
        self.forget();
        json!({ "name": name, "checksum": checksum })
    }

    /// Answers a message in json with json: `{"ok": ..}` or `{"error": {message, line, field}}`.
    pub fn call(&mut self, message: &str) -> String {
        let message = serde_json::from_str(message).map_err(Refusal::from);
        reply(message.and_then(|message| self.answer(message)))
    }

    /// Solves the scan of the scene at mean pressures \[Pa\], with `leaks` also the flow through
    /// its gap; every event is passed on as json.
    pub fn press(&self, pressures: &[f64], leaks: bool, mut happened: impl FnMut(&str)) -> String {
        let tell = |event: Value| happened(&event.to_string());
        let pressed = self.scene().and_then(|file| press::press(file, pressures, leaks, tell));
        reply(pressed.map(Value::from))
    }

    /// The bytes of a file of the scene.
    #[must_use]
    pub fn file(&self, name: &str) -> Option<&[u8]> {
        self.files.get(name).map(Vec::as_slice)
    }

    fn scene(&self) -> Result<&SceneFile, Refusal> {
        self.file.as_ref().ok_or_else(no_scene)
    }

    fn forget(&mut self) {
        let (files, described) = (std::mem::take(&mut self.files), self.described.take());
        *self = Self { files, described, ..Self::default() };
    }

    /// Compiles models on the scene, each once.
    fn compile<'i>(&mut self, ids: impl IntoIterator<Item = &'i str>) {
        let Self { scenes, compiled, .. } = self;
        let made = |id| answer::compile(scenes, id).map_err(|refusal| refusal.message);
        for id in ids {
            compiled.entry(id.into()).or_insert_with(|| made(id));
        }
    }

    /// Takes what was solved on the scan as an input of the answer.
    fn take_solved(&mut self, solved: &[Solved]) {
        let solved: Vec<SolvedContact> = solved.iter().map(Solved::contact).collect();
        if let Some(file) = self.scenes.all.first_mut().filter(|file| file.solved != solved) {
            file.solved = solved;
            self.best = None;
            self.compiled.remove(BEST);
        }
    }

    fn answer(&mut self, message: Message) -> Result<Value, Refusal> {
        Ok(match message {
            Message::Show { text } => self.show(&text)?,
            Message::Edit { text, changes, another } => {
                surface_keys::edited(&text, &changes, another)?.into()
            }
            Message::Form => {
                let materials = asperity_scene::materials().iter().map(read_scene::material);
                let mut form = surface_keys::form();
                form["materials"] = materials.collect();
                form
            }
            Message::Surface { text, way } => self.describe(&text, &way)?.into(),
            Message::UseScan { text, name } => surface_keys::with_scan(&text, &name)?.into(),
            Message::Usable { name } => usable(&name, self.file(&name).unwrap_or_default())?,
            Message::Admit { name, size } => admit(&name, size)?.into(),
            Message::Random { keys } => self.keep(&keys.name(), keys.file()?),
            Message::Answer { models, load, solved } => self.values(&models, &load, &solved)?,
            Message::Curve { models } => {
                let pressures = Span::of(self.scene()?).pressures();
                self.compile(models.iter().map(String::as_str));
                let rows = models.iter().filter_map(|id| {
                    let asked = self.compiled.get(id)?.as_ref().ok()?;
                    Some((id, answer::rows(&self.scenes, asked, &pressures)))
                });
                json!(rows.collect::<BTreeMap<_, _>>())
            }
            Message::Draw(asked) => picture::curves(self.scene()?, &asked)?.into(),
            Message::Scan => scan_report::report(self.scene()?)?,
            Message::Export { model, form, units } => {
                table::table(self.scene()?, &model, &form, &units)?
            }
            Message::Link { state } => link::link(state)?.into(),
            Message::Unlink { link } => link::unlink(&link)?,
        })
    }

    /// The text with its surface described in another way. Where the page made the present
    /// description, the surface as the user gave it is described, so that a look changes nothing.
    fn describe(&mut self, text: &str, way: &str) -> Result<String, Refusal> {
        let surface = |text: &str| -> Vec<(String, String)> {
            let is_surface = |(path, _): &(String, String)| path.starts_with("surface.");
            fields::fields(text).into_iter().filter(is_surface).collect()
        };
        let given = match &self.described {
            Some([given, made]) if surface(made) == surface(text) => {
                fields::with_surface_of(text, given)?
            }
            _ => text.into(),
        };
        let made = match asperity_scene::parse_handed(&given, &self.files) {
            _ if surface_keys::way(&fields::fields(&given)) == way => given.clone(),
            Ok(file) => surface_keys::described(&given, way, &file)?,
            // The scan that was given is not among the files any more.
            Err(_) => surface_keys::described(text, way, self.scene()?)?,
        };
        self.described = Some([given, made.clone()]);
        Ok(made)
    }

    /// Reads a text, whose scene answers later messages, and keeps the files that it names alone.
    fn show(&mut self, text: &str) -> Result<Value, Refusal> {
        self.forget();
        let (found, file) = read_scene::read(text, &self.files);
        let named = fields::files(text);
        self.files.retain(|name, _| named.contains(name));
        if let Some(file) = &file {
            self.scenes = Scenes::of(file)?;
        }
        self.file = file;
        Ok(found)
    }

    /// The values of models at a load with what is found there, and the answer.
    fn values(
        &mut self,
        models: &[String],
        load: &LoadKeys,
        solved: &[Solved],
    ) -> Result<Value, Refusal> {
        let load = Load::of(load, self.scene()?)?;
        self.take_solved(solved);
        self.compile(models.iter().map(String::as_str).chain([BEST]));
        let Self { file: Some(file), scenes, compiled, best, .. } = self else {
            return Err(no_scene());
        };
        let row = |id: &str| match compiled.get(id) {
            Some(Ok(asked)) => Row::of(scenes, asked, load.at),
            other => {
                let reason = other.and_then(|refused| refused.as_ref().err().cloned());
                Row { model: id.into(), reason, ..Row::default() }
            }
        };
        let rows: Vec<Row> = models.iter().map(|id| row(id)).collect();
        let here = solved.iter().find(|solved| solved.pressure.total_cmp(&load.pascals).is_eq());
        let columns = answer::columns(Some(file));
        let mut answered = row(BEST);
        if best.is_none() && file.shape().is_none() {
            *best = scenes[0].best().on(&scenes[0].scene, Tolerance::default()).ok();
        }
        if here.is_some() && best.as_ref().is_some_and(|best| best.is_solved(load.at)) {
            answered.solved();
        }
        let mut answer = advice::answer(&answered, (file, scenes, &columns), best.as_ref(), &load);
        let shown = |row: &Row| advice::shown_row(&answered, row, &columns);
        answer["solved"] = here.map(|solved| shown(&solved.row(&columns))).into();
        let scene = &scenes[0];
        let of_scene = scene.warnings.iter().cloned().chain(scene.findings());
        let of_models = rows.iter().flat_map(|row| row.findings.iter().cloned());
        // The table of values marks it at each model.
        let unmarked = |found: &Finding| found.code != Code::BeyondFullContact;
        let findings = scene.accepted(of_scene.chain(of_models).filter(unmarked).collect());
        Ok(json!({
            "load": load,
            "rows": rows.iter().map(shown).collect::<Value>(),
            "answer": answer,
            "findings": findings.iter().map(labels::finding).collect::<Value>(),
        }))
    }
}

fn no_scene() -> Refusal {
    Refusal::new("the scene has an error; correct it first")
}

fn reply(answer: Result<Value, Refusal>) -> String {
    match answer {
        Ok(value) => json!({ "ok": value }),
        Err(error) => json!({ "error": error }),
    }
    .to_string()
}

#[cfg(test)]
mod tests {
    use asperity::{ContactModel, Quantity, Request};

    use super::*;
    use crate::files::MOST_FILE;

    fn call(desk: &mut Desk, message: Value) -> Value {
        serde_json::from_str(&desk.call(&message.to_string())).unwrap()
    }

    const SURFACES: [&str; 3] = [
        "sq = \"95 nm\"  # measured\nspd = \"20000 1/mm2\"\nspc = \"50 1/mm\"",
        "asperity_radius = \"18.3 um\"\nasperity_density = 6.4e9\nasperity_height_std = 1e-7",
        "ra = \"0.8 um\"\nfinish = \"ground\"\ncounterface = { ra = 4e-7, finish = \"honed\" }",
    ];

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
        assert!(answer["ok"]["findings"].is_array());
        // A load that no model carries has rows too, with the reasons.
        let tension = json!({ "text": "-5 N", "unit": "N" });
        let asked = json!({ "call": "answer", "models": ["ke", "none"], "load": tension });
        let refused = call(&mut desk, asked);
        for row in refused["ok"]["rows"].as_array().unwrap() {
            assert!(row["reason"].is_string(), "{row}");
        }
        assert_eq!(refused["ok"]["rows"].as_array().unwrap().len(), 2);
        let curve = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        let rows = curve["ok"]["ke"].as_str().unwrap();
        let drawn = json!({ "call": "draw", "rows": [rows], "view": "tangent", "load": load, "solved": [] });
        assert!(call(&mut desk, drawn)["ok"].as_str().unwrap().starts_with("<svg"));
    }

    #[test]
    fn curved_bodies_are_answered_as_by_the_library() {
        let flat = asperity_scene::template();
        let area = flat.lines().find(|line| line.starts_with("nominal_area")).unwrap();
        let text = flat.replace(area, "") + "\n[curvature]\nradius = \"10 mm\"\n";
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": text }))["ok"].clone();
        assert!(shown["error"].is_null(), "{shown}");
        let ids: Vec<&str> =
            shown["views"].as_array().unwrap().iter().map(|v| v["id"].as_str().unwrap()).collect();
        let place = |id: &str| ids.iter().position(|known| *known == id).unwrap();
        let ask = |desk: &mut Desk, load: Value| {
            call(desk, json!({ "call": "answer", "models": ["ke", "jkr"], "load": load }))
        };
        let found = ask(&mut desk, json!({ "text": "50 N" }))["ok"].clone();
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        let asked = [Quantity::Approach, Quantity::Area, Quantity::PeakPressure];
        let request = Request::new(asked).at_loads([50.0]);
        let wanted = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        for quantity in asked {
            for row in [&found["rows"][0], &found["answer"]["row"]] {
                let cell = &row["cells"][place(&quantity.to_string())];
                let own: f64 = cell["digits"].as_str().unwrap().parse().unwrap();
                let right = wanted.values(quantity).unwrap()[0];
                assert!((own / right - 1.0).abs() < 1e-9, "{quantity}: {own} {right}");
            }
        }
        let first = &found["answer"]["first"];
        assert_eq!(
            (&first[3]["name"], &found["answer"]["model"]),
            (&json!("peak pressure"), &json!("ke"))
        );
        assert!(first[0]["shown"].as_str().unwrap().ends_with("m²"), "{first}");
        assert!(found["rows"][1]["reason"].is_string());
        let refused = ask(&mut desk, json!({ "text": "5 MPa" }));
        assert_eq!(refused["error"]["field"], "load");
        // The slider gives loads, whatever the unit beside it.
        let slid = ask(&mut desk, json!({ "position": 0.6, "unit": "Pa" }))["ok"].clone();
        assert_eq!(
            (&slid["load"]["unit"], &slid["rows"][0]["reason"]),
            (&json!("N"), &Value::Null)
        );
        let curve = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        let rows = curve["ok"]["ke"].as_str().unwrap();
        assert!(rows.lines().count() > 15 && !rows.contains(",,"), "{rows}");
        let load = json!({ "text": "50 N" });
        let drawn = json!({ "call": "draw", "rows": [rows], "view": "peak-pressure", "load": load, "solved": [] });
        assert!(call(&mut desk, drawn)["ok"].as_str().unwrap().starts_with("<svg"));
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
        assert!(refused["error"]["message"].is_string());
        assert!(call(&mut desk, json!({ "call": "fly" }))["error"]["message"].is_string());
        let empty: Value = serde_json::from_str(&desk.hand("a.x3p", vec![])).unwrap();
        assert_eq!(empty["error"]["field"], "surface.file");
        let large = json!({ "call": "admit", "name": "b.x3p", "size": 2_u64 << 30 });
        assert_eq!(call(&mut desk, large)["error"]["field"], "surface.file");
        let right = json!({ "call": "admit", "name": "b.x3p", "size": MOST_FILE });
        assert!(call(&mut desk, right)["ok"].is_null());
    }

    #[test]
    fn a_look_at_another_description_changes_nothing() {
        let template = asperity_scene::template();
        let (head, _) = template.split_once("\n[surface]").unwrap();
        for surface in SURFACES {
            let given = format!("{head}\n[surface]\n{surface}\n");
            let mut desk = Desk::default();
            let mut show = |text: &str| call(&mut desk, json!({ "call": "show", "text": text }));
            let first = show(&given)["ok"]["way"].as_str().unwrap().to_string();
            let mut turned = |text: &str, way: &str| {
                call(&mut desk, json!({ "call": "show", "text": text }));
                let made = call(&mut desk, json!({ "call": "surface", "text": text, "way": way }));
                made["ok"].as_str().unwrap_or_else(|| panic!("{made}")).to_string()
            };
            // Over all others and back, also where something else is changed meanwhile.
            let mut text = given.clone();
            for way in ["moments", "finish", "iso", "asperities", "index", "finish"] {
                text = turned(&text, way);
            }
            let wider = |text: &str| text.replacen("1e-4", "2e-4", 1);
            assert_ne!(wider(&text), text);
            assert_eq!(turned(&wider(&text), &first), wider(&given));
            let moments = turned(&given, "moments");
            assert_eq!(turned(&moments, &first), given);
            if first != "iso" {
                continue;
            }
            // A surface that was changed there is another one.
            let m0 = fields::fields(&moments)["surface.m0"].clone();
            let changed = moments.replace(&m0, "1e-14");
            let back = turned(&changed, "iso");
            assert!(fields::fields(&back)["surface.sq"].starts_with("1e-7"), "{back}");
        }
    }

    #[test]
    fn only_the_files_of_the_scene_are_kept() {
        let mut desk = Desk::default();
        for name in ["a.txt", "b.txt"] {
            desk.hand(name, b"1 2".to_vec());
        }
        let text = "[surface]\nfile = \"b.txt\"\n";
        call(&mut desk, json!({ "call": "show", "text": text }));
        assert_eq!((desk.file("a.txt"), desk.file("b.txt")), (None, Some(&b"1 2"[..])));
    }
}
