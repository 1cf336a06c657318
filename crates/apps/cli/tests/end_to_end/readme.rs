//! The README and the walk-throughs show what the program prints. After a change that is meant,
//! `ASPERITY_BLESS=1 cargo test -p asperity-cli readme` writes them anew.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::bench::Bench;
use crate::help::sh;

/// The examples, below the root of the repository.
const EXAMPLES: &str = "crates/answer/scene/examples";

#[test]
fn the_walk_throughs_show_the_real_output() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files: Vec<PathBuf> = fs::read_dir(folder.join("tests/walkthrough"))
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.push(folder.join("README.md"));
    let mut all = String::new();
    for file in &files {
        let bench = Bench::new();
        for example in fs::read_dir(folder.join("../../..").join(EXAMPLES)).unwrap() {
            let path = example.unwrap().path();
            if path.is_file() {
                fs::copy(&path, bench.folder().join(path.file_name().unwrap())).unwrap();
            }
        }
        let shown = fs::read_to_string(file).unwrap();
        let real = replayed(&bench, &shown);
        if env::var_os("ASPERITY_BLESS").is_some() {
            fs::write(file, &real).unwrap();
            continue;
        }
        let (shown_lines, real_lines) = (shown.lines(), real.lines());
        for (shown, real) in shown_lines.clone().zip(real_lines.clone()) {
            assert!(agree(shown, real), "{}\nshown: {shown}\nreal:  {real}", file.display());
        }
        assert_eq!(shown_lines.count(), real_lines.count(), "{}", file.display());
        all += &shown;
    }
    let readme = fs::read_to_string(folder.join("README.md")).unwrap();
    assert!(readme.contains(&format!("cd {EXAMPLES}")));
    assert!(readme.split_whitespace().count() <= 1200);
    for file in &files[..files.len() - 1] {
        let name = file.file_name().unwrap().to_str().unwrap();
        assert!(readme.contains(&format!("(tests/walkthrough/{name})")), "{name}");
    }
    if env::var_os("ASPERITY_BLESS").is_none() {
        for scene in ["wheel-rail", "bolted-joint", "elastomer-on-glass"] {
            assert!(all.contains(&format!(" {scene}.toml")), "{scene}");
        }
    }
}

/// The README with every command run again, and its output in the place of the one shown.
fn replayed(bench: &Bench, readme: &str) -> String {
    let mut real = String::new();
    let mut rest = readme;
    while let Some((before, after)) = rest.split_once("```console\n") {
        let (block, after) = after.split_once("```").expect("its end");
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
