//! What the desk says, but for findings: one snapshot, read when it changes.

#![allow(clippy::unwrap_used, reason = "a test: a panic is the failure")]

use asperity_web::Desk;
use serde_json::{Value, json};

/// Fields whose text the page shows.
const SAID: [&str; 9] =
    ["message", "field_message", "reason", "basis", "spoken", "caption", "about", "shown", "text"];
/// A surface of which only Ra is known.
const GROUND: &str = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
    poissons_ratio = 0.3\nhardness = 2e9\n[surface]\nra = 8e-7\nfinish = \"ground\"\n";

/// A desk and what it said, each text once below what it was asked.
#[derive(Default)]
struct Heard {
    desk: Desk,
    said: Vec<String>,
}

impl Heard {
    fn ask(&mut self, what: &str, keys: Value) -> Value {
        let mut message = keys;
        let call = message["call"].as_str().unwrap_or_default().to_string();
        let answer = match call.as_str() {
            "hand" => self.desk.hand(message["name"].as_str().unwrap(), vec![]),
            _ => self.desk.call(&message.take().to_string()),
        };
        let answer: Value = serde_json::from_str(&answer).unwrap();
        self.said.push(format!("\n{what}"));
        self.hear(&answer, "");
        answer["ok"].clone()
    }

    fn hear(&mut self, value: &Value, key: &str) {
        match value {
            Value::Object(fields) => {
                let hidden = ["findings", "rows", "first", "row", "numbers", "views", "materials"];
                let shown = fields.iter().filter(|(key, _)| !hidden.contains(&key.as_str()));
                shown.for_each(|(key, value)| self.hear(value, key));
            }
            Value::Array(items) => items.iter().for_each(|item| self.hear(item, key)),
            Value::String(text) if SAID.contains(&key) && text.lines().count() == 1 => {
                let line = format!("  {key}: {text}");
                if !self.said.contains(&line) {
                    self.said.push(line);
                }
            }
            _ => {}
        }
    }

    fn show(&mut self, what: &str, text: &str) {
        self.ask(what, json!({ "call": "show", "text": text }));
    }

    fn answer(&mut self, load: &str) {
        let models = ["gw", "ke", "jkr", "persson-fudge"];
        let load_keys = json!({ "text": load, "unit": "N" });
        let asked = json!({ "call": "answer", "models": models, "load": load_keys });
        let found = self.ask(load, asked);
        for row in found["rows"].as_array().into_iter().flatten() {
            self.hear(&row["reason"], "reason");
        }
    }
}

#[test]
fn messages() {
    let template = asperity_scene::template();
    let mut heard = Heard::default();
    heard.ask("no scene", json!({ "call": "curve", "models": ["ke"] }));
    heard.show("no toml", "a = ");
    for (key, typed) in [
        ("poissons_ratio", "\"0,3\""),
        ("youngs_modulus", "\"210,000 MPa\""),
        ("youngs_modulus", "\"210 mm\""),
        ("hardness", "-5"),
        ("poissons_ratio", "0.7"),
        ("material", "\"unobtainium\""),
    ] {
        let wanted = if key == "material" { "youngs_modulus" } else { key };
        let line = template.lines().find(|line| line.starts_with(wanted)).unwrap();
        let text = template.replacen(line, &format!("{key} = {typed}"), 1);
        heard.show(&format!("{key} = {typed}"), &text);
    }
    heard.show("template", template);
    for load in ["100 N", "-5 N", "1e30 N", "0", "0,3 N", "5 kg", "36 ksi", "1e999"] {
        heard.answer(load);
    }
    heard.ask(
        "no table",
        json!({ "call": "export", "model": "persson", "form": "csv", "units": "SI" }),
    );
    let draw = |rows: Value| json!({ "call": "draw", "rows": rows, "view": "tangent", "load": { "text": "9 N" }, "solved": [] });
    heard.ask("no model drawn", draw(json!([])));
    for link in ["AAAA", "eyJ2ZXJzaW9uIjoyfQ"] {
        heard.ask("link", json!({ "call": "unlink", "link": link }));
    }
    heard.ask("empty file", json!({ "call": "hand", "name": "a.x3p" }));
    heard.ask("large file", json!({ "call": "admit", "name": "b.x3p", "size": 2_u64 << 30 }));
    let random = |pixels: &str| json!({ "pixels": pixels, "side": "64 um", "longest": "32 um", "shortest": "4 um", "hurst": "0.8", "sq": "0.5 um", "seed": "3" });
    for pixels in ["abc", "2048", "8"] {
        heard.ask(&format!("{pixels} pixels"), json!({ "call": "random", "keys": random(pixels) }));
    }
    heard.ask("random surface", json!({ "call": "random", "keys": random("64") }));
    let text = heard
        .ask("its scene", json!({ "call": "use-scan", "text": template, "name": "random-3.x3p" }));
    heard.show("scan", text.as_str().unwrap());
    let mut events = vec![];
    heard.desk.press(&[2e8], true, |event| events.push(event.to_string()));
    for event in events {
        let event: Value = serde_json::from_str(&event).unwrap();
        if event["event"] != "progress" {
            heard.hear(&event["maps"], "");
            heard.hear(&event["map"], "");
        }
    }
    heard.show("Ra alone", GROUND);
    heard.answer("100 N");
    let area = template.lines().find(|line| line.starts_with("nominal_area")).unwrap();
    heard.show("a ball", &(template.replace(area, "") + "\n[curvature]\nradius = \"10 mm\"\n"));
    heard.answer("50 N");
    heard.answer("5 MPa");
    let adhesive = include_str!("../../../answer/scene/examples/elastomer-on-glass.toml");
    heard.show("adhesion", &adhesive.replace("rigid_", "work_of_adhesion = 0.05\nrigid_"));
    heard.answer("-1 N");
    insta::assert_snapshot!(heard.said.join("\n"));
}
