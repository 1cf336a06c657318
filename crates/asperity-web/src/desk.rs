//! The desk: a scene, its files, and its models ready to answer.

use std::collections::BTreeMap;

use asperity::{ContactError, Corrected, Evidence, Findings, Severity};
use asperity_answer::Asked;
use asperity_inputs::{HandedFiles, SceneFile};
use asperity_topography::Topography;
use serde_json::{Value, json};

use crate::advice::Judged;
use crate::best::{Best, recommended};
use crate::files::{admit, usable};
use crate::message::{LoadKeys, Message, Solved};
use crate::ranges::Ranges;
use crate::refusal::Refusal;
use crate::span::{Load, Span};
use crate::{
    advice, answer, dialect, fields, law, link, picture, press, ranges, read_scene, scan_report,
    surface_keys, table,
};

/// A scene with the files that it names, and its compiled models.
#[derive(Default)]
pub struct Desk {
    files: HandedFiles,
    file: Option<SceneFile>,
    compiled: BTreeMap<String, Result<Asked, String>>,
    /// Models corrected by the evidence.
    corrected: BTreeMap<&'static str, Result<Corrected, ContactError>>,
    /// The scene in the middle and at the ends of the ranges of its surface, if it has any.
    ranges: Option<Box<Ranges>>,
    /// Whether this is a scene of such ranges, on which evidence and ranges are not combined.
    at_an_end: bool,
}

/// A scene with models on it, or the reasons why it refuses them.
type Compiled<'d> = (&'d SceneFile, Vec<(&'d str, Result<&'d Asked, &'d String>)>);

impl Desk {
    /// Takes the bytes of a file that scenes may name; returns json with its checksum, or with a
    /// refusal.
    pub fn hand(&mut self, name: &str, bytes: Vec<u8>) -> String {
        reply(admit(name, bytes.len() as u64).map(|()| self.keep(name, bytes)))
    }

    fn keep(&mut self, name: &str, bytes: Vec<u8>) -> Value {
        let checksum = link::checksum(&bytes);
        self.files.insert(name.into(), bytes);
        (self.file, self.ranges) = (None, None);
        json!({ "name": name, "checksum": checksum })
    }

    /// Answers a message in json with json: `{"ok": ..}` or `{"error": {message, line, field}}`.
    pub fn call(&mut self, message: &str) -> String {
        let message = serde_json::from_str(message).map_err(Refusal::from);
        reply(message.and_then(|message| self.answer(message)))
    }

    /// Solves the scan of the scene at mean pressures \[Pa\]; every event is passed on as json.
    pub fn press(&self, pressures: &[f64], mut happened: impl FnMut(&str)) -> String {
        let tell = |event: Value| happened(&event.to_string());
        reply(self.scene().and_then(|file| press::press(file, pressures, tell)).map(Value::from))
    }

    /// The bytes of a file of the scene.
    #[must_use]
    pub fn file(&self, name: &str) -> Option<&[u8]> {
        self.files.get(name).map(Vec::as_slice)
    }

    /// The heights \[m\] of the scan of the scene, for the report of another desk.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        let scan = self.file.as_ref().and_then(|file| file.scan.as_deref());
        scan.map_or(&[], Topography::heights)
    }

    /// The report of a scan from its heights \[m\] and their shape, as `scan` gives it.
    #[must_use]
    pub fn report(&self, heights: Vec<f64>, shape: &str) -> String {
        let shape = serde_json::from_str(shape).map_err(Refusal::from);
        reply(shape.and_then(|shape| scan_report::report(heights, shape)))
    }

    fn scene(&self) -> Result<&SceneFile, Refusal> {
        self.file.as_ref().ok_or_else(no_scene)
    }

    /// The desk of a scene at an end of the ranges of its surface, or in the middle.
    pub(crate) fn at_an_end(file: SceneFile) -> Self {
        Self { file: Some(file), at_an_end: true, ..Self::default() }
    }

    /// The models of these ids on the scene, each compiled once; those that it refuses with the
    /// reason.
    fn compile<'d>(&'d mut self, ids: &'d [String]) -> Result<Compiled<'d>, Refusal> {
        let file = self.file.as_ref().ok_or_else(no_scene)?;
        let made = |id: &String| answer::compile(file, id).map_err(|refusal| refusal.message);
        for id in ids {
            self.compiled.entry(id.clone()).or_insert_with(|| made(id));
        }
        let models =
            ids.iter().filter_map(|id| Some((id.as_str(), self.compiled.get(id)?.as_ref())));
        Ok((file, models.collect()))
    }

    fn answer(&mut self, message: Message) -> Result<Value, Refusal> {
        Ok(match message {
            Message::Show { text } => self.show(&text),
            Message::Edit { text, changes } => fields::edit(&text, &changes)?.into(),
            Message::Changed { text } => fields::changed(&text).into(),
            Message::Form => {
                let materials = asperity_inputs::materials().iter().map(read_scene::material);
                let mut form = surface_keys::form();
                form["materials"] = materials.collect();
                form
            }
            Message::Surface { text, way, typed } => {
                surface_keys::described(&text, &way, &typed, self.scene()?)?.into()
            }
            Message::UseScan { text, name } => surface_keys::with_scan(&text, &name)?.into(),
            Message::Usable { name } => usable(&name, self.file(&name).unwrap_or_default())?,
            Message::Admit { name, size } => admit(&name, size)?.into(),
            Message::Random { keys } => self.keep(&keys.name(), keys.file()?),
            Message::Answer { models, load, solved } => match &mut self.ranges {
                Some(ranges) => ranges.values(&models, &load)?,
                None => self.values(&models, &load, &solved)?,
            },
            Message::Curve { models } => {
                let pressures = Span::of(&self.scene()?.scene).pressures();
                if self.ranges.is_some() {
                    return ranges::curves(self.scene()?, &models, &pressures);
                }
                let (file, models) = self.compile(&models)?;
                let rows = models.into_iter().filter_map(|(id, asked)| {
                    Some((id, answer::rows(file, id, asked.ok()?, &pressures)))
                });
                json!(rows.collect::<BTreeMap<_, _>>())
            }
            Message::Draw { rows, view, load, solved, outside, size } => {
                let file = self.scene()?;
                let load = Load::of(&load, &file.scene)?;
                picture::curves(file, &rows, &view, &load, &solved, (&outside, size))?.into()
            }
            Message::Scan => scan_report::numbers(self.scene()?)?,
            Message::Check { models, load } => {
                if let Some(ranges) = &mut self.ranges {
                    return ranges.middle.answer(Message::Check { models, load });
                }
                let (file, models) = self.compile(&models)?;
                let at = Load::of(&load, &file.scene)?.at;
                dialect::findings(&advice::check(file, &models, at), file)
            }
            Message::Export { model, form, units } => {
                table::table(self.scene()?, &model, &form, &units)?
            }
            Message::Law { model } => law::law(self.scene()?, &model)?,
            Message::Link { state } => link::link(state)?.into(),
            Message::Unlink { link } => link::unlink(&link)?,
        })
    }

    /// Reads a text, whose scene answers later messages, and keeps the files that it names alone.
    fn show(&mut self, text: &str) -> Value {
        self.compiled.clear();
        self.corrected.clear();
        let (found, file) = read_scene::read(text, &self.files);
        let named = fields::files(text);
        self.files.retain(|name, _| named.contains(name));
        self.ranges = file.as_ref().and_then(|file| Ranges::of(file).ok()?).map(Box::new);
        self.file = file;
        found
    }

    pub(crate) fn values(
        &mut self,
        models: &[String],
        load: &LoadKeys,
        solved: &[Solved],
    ) -> Result<Value, Refusal> {
        let (file, models) = self.compile(models)?;
        let load = Load::of(load, &file.scene)?;
        let (mut rows, mut findings) = (vec![], Findings::default());
        for (id, asked) in models {
            match asked {
                Ok(asked) => {
                    let (row, found) = answer::row(file, id, asked, load.at)?;
                    rows.push(row);
                    // The findings of the load name an area above the nominal one already.
                    findings.extend(found.into_iter().filter(|f| f.code != "area-above-nominal"));
                }
                Err(reason) => rows.push(json!({ "model": id, "cells": [], "reason": reason })),
            }
        }
        let findings = file.accepted(findings).at_least(Severity::Warning);
        let findings = dialect::findings(&findings, file);
        let answer = self.best(&load, solved, &mut rows)?;
        Ok(json!({ "load": load, "rows": rows, "answer": answer, "findings": findings }))
    }

    /// The answer at a load; the rows of the shown models get their deviation from it.
    fn best(
        &mut self,
        load: &Load,
        solved: &[Solved],
        rows: &mut [Value],
    ) -> Result<Value, Refusal> {
        let id = recommended(self.scene()?, load.at);
        self.compile(&[id.into(), advice::ELASTIC.into()])?;
        let Self { file: Some(file), compiled, corrected, at_an_end, .. } = self else {
            return Err(no_scene());
        };
        let asked = |id: &str| compiled.get(id).and_then(|asked| asked.as_ref().ok());
        let row = match asked(id) {
            Some(asked) => answer::row(file, id, asked, load.at)?.0,
            None => Value::Null,
        };
        let corrected = corrected.entry(id).or_insert_with(|| match asked(id) {
            _ if *at_an_end => Err(Evidence::none("the surface is known within ranges".into())),
            Some(asked) => asked.corrected(file, id),
            None => Err(Evidence::none(format!("{id} has no values"))),
        });
        let here = solved.iter().find(|solved| solved.pressure.total_cmp(&load.pascals).is_eq());
        let best = Best::new(file, &row, corrected, load, here);
        let ids = rows.iter().filter_map(|row| row["model"].as_str()).chain([advice::ELASTIC]);
        let judge = |id: &str| Some((id.to_string(), Judged::of(file, asked(id)?, load.at)));
        let judged: BTreeMap<_, _> = ids.filter_map(judge).collect();
        for row in rows.iter_mut() {
            let of = row["model"].as_str().and_then(|id| judged.get(id));
            advice::hold_against(&best, row, of);
        }
        let mut shown = advice::answer(&best, file, load, rows, &judged);
        if let Some(mut row) = here.map(Solved::row) {
            advice::hold_against(&best, &mut row, None);
            shown["solved"] = row;
        }
        Ok(shown)
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
    use super::*;
    use crate::files::MOST_FILE;

    fn call(desk: &mut Desk, message: Value) -> Value {
        serde_json::from_str(&desk.call(&message.to_string())).unwrap()
    }

    #[test]
    fn a_scene_is_shown_answered_and_drawn() {
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": asperity_inputs::template() }));
        assert!(shown["ok"]["error"].is_null(), "{shown}");
        assert_eq!(shown["ok"]["fields"]["body[1].hardness"], "2e9");
        let load = json!({ "text": "100 N", "unit": "N" });
        let asked = json!({ "call": "answer", "models": ["ke", "gw"], "load": load });
        let answer = call(&mut desk, asked);
        assert_eq!(answer["ok"]["rows"][1]["model"], "gw");
        assert_eq!(answer["ok"]["load"]["pascals"], 1e6);
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
        let check = call(&mut desk, json!({ "call": "check", "models": ["gw"], "load": load }));
        assert!(check["ok"].is_array(), "{check}");
    }

    #[test]
    fn errors_have_line_and_field_and_the_desk_goes_on() {
        let mut desk = Desk::default();
        let text = asperity_inputs::template().replace("hardness = 2e9", "hardness = \"2 GP\"");
        let shown = call(&mut desk, json!({ "call": "show", "text": text }));
        assert_eq!(shown["ok"]["error"]["field"], "body[1].hardness");
        let line = 1 + text.lines().position(|line| line.contains("2 GP")).unwrap();
        assert_eq!(shown["ok"]["error"]["line"], line);
        let refused = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        assert!(refused["error"]["message"].as_str().unwrap().contains("correct it first"));
        assert!(call(&mut desk, json!({ "call": "fly" }))["error"]["message"].is_string());
        let empty: Value = serde_json::from_str(&desk.hand("a.x3p", vec![])).unwrap();
        assert!(empty["error"]["message"].as_str().unwrap().starts_with("a.x3p is empty"));
        let large = json!({ "call": "admit", "name": "b.x3p", "size": 2_u64 << 30 });
        let large = call(&mut desk, large)["error"]["message"].to_string();
        assert!(large.contains("b.x3p has 2048 MB, and the page reads at most 128 MB"), "{large}");
        let right = json!({ "call": "admit", "name": "b.x3p", "size": MOST_FILE });
        assert!(call(&mut desk, right)["ok"].is_null());
    }

    #[test]
    fn only_the_files_of_the_scene_are_kept() {
        let mut desk = Desk::default();
        for name in ["a.txt", "b.txt"] {
            desk.hand(name, b"1 2".to_vec());
        }
        let text = "[surface]\nfiles = [\"b.txt\"]\n";
        call(&mut desk, json!({ "call": "show", "text": text }));
        assert_eq!((desk.file("a.txt"), desk.file("b.txt")), (None, Some(&b"1 2"[..])));
    }

    #[test]
    fn a_random_surface_is_pressed_and_shown() {
        let mut desk = Desk::default();
        let keys = json!({ "pixels": "64", "side": "64 um", "longest": "32 um", "shortest": "4 um", "hurst": "0.8", "sq": "0.5 um", "seed": "3" });
        let made = call(&mut desk, json!({ "call": "random", "keys": keys }));
        let name = made["ok"]["name"].as_str().unwrap();
        let text = asperity_inputs::template();
        let text = call(&mut desk, json!({ "call": "use-scan", "text": text, "name": name }));
        let shown = call(&mut desk, json!({ "call": "show", "text": text["ok"] }));
        assert!(shown["ok"]["error"].is_null(), "{shown}");
        let scan = &shown["ok"]["scan"];
        assert_eq!((&scan["rows"], &scan["columns"]), (&json!(64), &json!(64)));
        assert!(scan["refused"].is_null() && scan["pressures"].as_array().unwrap().len() == 6);
        // Another desk reports on the heights without the file.
        let scan = call(&mut desk, json!({ "call": "scan" }));
        let shape = scan["ok"]["shape"].to_string();
        let report = Desk::default().report(desk.heights().to_vec(), &shape);
        assert!(report.contains("\"svg\":\"<svg") && report.contains("64 x 64 points"), "{report}");
        assert!(Desk::default().report(vec![], &shape).starts_with("{\"error\""));
        let mut solved = 0;
        let answer = desk.press(&[2e8], |event| solved += usize::from(event.contains("solved")));
        assert_eq!((answer.as_str(), solved), ("{\"ok\":null}", 1));
    }
}
