//! What is said about scenes: `said.txt` has inputs by topic, `; ` for the end of a line, and
//! below each in indented lines what is said about it; it is read as prose when it changes.
//! `ASPERITY_BLESS=1` writes it anew. Other tests look at variants, fields, codes and numbers.

use std::fs;
use std::path::{Path, PathBuf};

use asperity::Code;
use asperity_scene::{HandedFiles, parse_handed, read_measurements, template};

use crate::scene_files::{INTERFACE, SURFACE, text};

const SAID: &str = include_str!("said.txt");

const BODIES: &str = include_str!("scenes/bodies.toml");

/// The error of a scene, or its warnings and findings; `a.txt` has 16 x 16 points, `few.txt` 4 x 4.
fn of_scene(scene: &str) -> Vec<String> {
    let rows = |count: usize| {
        let row = |y: usize| (0..count).map(move |x| ((7 * x + 11 * y) % 13).to_string());
        (0..count).map(|y| row(y).collect::<Vec<_>>().join(" ") + "\n").collect::<String>()
    };
    let scan = format!("# Width: 16 um\n# Height: 16 um\n# Value units: nm\n{}", rows(16));
    let files = [("a.txt", scan), ("few.txt", rows(4)), ("empty.txt", String::new())];
    let files = files.into_iter();
    let files: HandedFiles =
        files.map(|(name, text)| (name.to_string(), text.into_bytes())).collect();
    match parse_handed(scene, &files) {
        Ok(file) => {
            let all = file.warnings.iter().cloned().chain(file.findings());
            let mut said: Vec<String> = vec![];
            for line in all.map(|found| found.to_string()) {
                if !said.contains(&line) {
                    said.push(line);
                }
            }
            said
        }
        Err(error) => vec![error.to_string()],
    }
}

fn said(topic: &str, input: &str) -> Vec<String> {
    let scene = match topic {
        "whole files" => input.to_string(),
        "lines above the sections" => text(input, INTERFACE, SURFACE),
        "in place of the interface" => text("", input, SURFACE),
        "keys of the interface" => text("", &format!("{INTERFACE}{input}"), SURFACE),
        "one text for another" => {
            let (from, to) = input.split_once(" -> ").unwrap();
            text("", INTERFACE, SURFACE).replacen(from, to, 1)
        }
        "keys of the surface" => text("", INTERFACE, &format!("{SURFACE}{input}")),
        "numbers of a surface" => text("", INTERFACE, &format!("[surface]\n{input}")),
        "numbers in other units" | "finishes" | "scans and pairs" => {
            text("", BODIES, &format!("[surface]\n{input}"))
        }
        "measurements" => {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("data.csv");
            let bytes = match input {
                "(an Excel file)" => b"PK\x03\x04\xff\x14\x00",
                text => text.as_bytes(),
            };
            fs::write(&path, bytes).unwrap();
            let message = read_measurements(&path).unwrap_err().to_string();
            return vec![message.replace(&format!("{}", path.display()), "data.csv")];
        }
        "names of numbers" => {
            let file = asperity_scene::parse(template(), Path::new(".")).unwrap();
            return vec![file.inputs(input.split(", ")).unwrap_err().to_string()];
        }
        other => panic!("no topic {other}"),
    };
    of_scene(&scene)
}

#[test]
fn scenes_are_said_to_be_what_the_text_says() {
    let (mut topic, mut all) = ("", String::new());
    for line in SAID.lines().filter(|line| !line.starts_with("    ")) {
        all += &format!("{line}\n");
        let input = line.replace("; ", "\n").replace("(nothing)", "");
        match line.strip_prefix("## ") {
            Some(next) => topic = next,
            None if line.is_empty() => {}
            None => {
                for line in said(topic, &input) {
                    assert!(!line.contains('\n'), "{line}");
                    // Lists of keys are long.
                    let end = if line.len() > 320 { " ..." } else { "" };
                    all += &format!("    {}{end}\n", line.get(..320).unwrap_or(&line));
                }
            }
        }
    }
    if std::env::var_os("ASPERITY_BLESS").is_some() {
        fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/suite/said.txt"), &all).unwrap();
        return;
    }
    let differs: Vec<&str> = all.lines().filter(|line| !SAID.lines().any(|l| l == *line)).collect();
    assert!(all == SAID, "ASPERITY_BLESS=1 writes what differs: {differs:#?}");
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn every_code_has_its_findings() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().parent().unwrap();
    let mut files = vec![];
    sources(crates, &mut files);
    let all: String = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
    for code in Code::ALL {
        assert!(all.contains(&format!("Code::{code:?}")), "{code}");
    }
}
