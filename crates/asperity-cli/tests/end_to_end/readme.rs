//! The walk-through of the README shows what the program prints. After a change that is meant,
//! `ASPERITY_BLESS=1 cargo test -p asperity-cli readme` writes it anew.

use std::path::Path;
use std::{env, fs};

use crate::bench::Bench;
use crate::help::sh;

/// Where the walk-through begins, below the root of the repository.
const EXAMPLES: &str = "crates/asperity-inputs/examples";

#[test]
fn the_walk_through_shows_the_real_output() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let bench = Bench::new();
    for file in fs::read_dir(folder.join("../..").join(EXAMPLES)).unwrap() {
        let path = file.unwrap().path();
        if path.is_file() {
            fs::copy(&path, bench.folder().join(path.file_name().unwrap())).unwrap();
        }
    }
    let shown = include_str!("../../README.md");
    let real = replayed(&bench, shown);
    if env::var_os("ASPERITY_BLESS").is_some() {
        fs::write(folder.join("README.md"), &real).unwrap();
    }
    let (shown_lines, real_lines) = (shown.lines(), real.lines());
    for (shown, real) in shown_lines.clone().zip(real_lines.clone()) {
        assert!(agree(shown, real), "shown: {shown}\nreal:  {real}");
    }
    assert_eq!(shown_lines.count(), real_lines.count());
    assert!(shown.contains(&format!("cd {EXAMPLES}")));
    for scene in ["wheel-rail", "bolted-joint", "elastomer-on-glass"] {
        assert!(shown.contains(&format!(" {scene}.toml")), "{scene}");
    }
}

/// The README with every command run again, and its output in the place of the one shown.
fn replayed(bench: &Bench, readme: &str) -> String {
    let mut real = String::new();
    let mut rest = readme;
    while let Some((before, after)) = rest.split_once("```console\n") {
        let (block, after) = after.split_once("```").expect("the end of a block");
        real.push_str(before);
        real.push_str("```console\n");
        for line in block.lines().filter_map(|line| line.strip_prefix("$ ")) {
            let run = sh(bench, line);
            assert_eq!(run.code, Some(0), "{line}\n{}", run.messages);
            real.push_str(&format!("$ {line}\n{}{}", run.messages, run.out));
        }
        real.push_str("```");
        rest = after;
    }
    real + rest
}

/// The same arguments, and numbers that differ by less than processors make them differ.
fn agree(shown: &str, real: &str) -> bool {
    let arguments = |line: &str| -> Vec<String> {
        line.split([' ', ',']).filter(|word| !word.is_empty()).map(Into::into).collect()
    };
    let (shown, real) = (arguments(shown), arguments(real));
    shown.len() == real.len()
        && shown.iter().zip(&real).all(|(a, b)| match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() <= 2e-5 * a.abs(),
            _ => a == b,
        })
}
