//! The README, the walk-throughs and the transcripts show what the program prints. After a change
//! that is meant, `ASPERITY_BLESS=1 cargo test -p asperity-cli readme` writes them anew.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::bench::{Bench, NEGATIVE, NO_SHEAR, Run, SOFT};
use crate::help::sh;

/// The examples, below the root of the repository.
const EXAMPLES: &str = "crates/answer/scene/examples";

#[test]
fn the_walk_throughs_show_the_real_output() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = files("tests/walkthrough");
    files.push(folder.join("README.md"));
    let shown = |file: &PathBuf| {
        let bench = Bench::new();
        for example in fs::read_dir(folder.join("../../..").join(EXAMPLES)).unwrap() {
            let path = example.unwrap().path();
            if path.is_file() {
                fs::copy(&path, bench.folder().join(path.file_name().unwrap())).unwrap();
            }
        }
        checked(file, &bench, |line, run| {
            assert_eq!(run.code, Some(0), "{line}\n{}", run.messages);
            run.messages + &run.out
        })
    };
    let all: String = std::thread::scope(|scope| {
        let runs: Vec<_> = files.iter().map(|file| scope.spawn(|| shown(file))).collect();
        runs.into_iter().map(|run| run.join().unwrap()).collect()
    });
    let cited = Bench::new().data("list models gw --format bibtex");
    let cited = cited.split("\n\n").next().unwrap();
    assert!(fs::read_to_string(folder.join("../../../README.md")).unwrap().contains(cited));
    let readme = fs::read_to_string(folder.join("README.md")).unwrap();
    assert!(readme.contains(&format!("cd {EXAMPLES}")));
    assert!(readme.split_whitespace().count() <= 1200);
    for file in &files[..files.len() - 1] {
        let name = file.file_name().unwrap().to_str().unwrap();
        assert!(readme.contains(&format!("(tests/walkthrough/{name})")), "{name}");
    }
    for scene in ["wheel-rail", "bolted-joint", "elastomer-on-glass"] {
        assert!(all.contains(&format!(" {scene}.toml")), "{scene}");
    }
}

/// What users are told, and rows of each option, read as prose when they change: refusals end with
/// 2 where the command line is wrong, with 1 where a file is, and print no data.
#[test]
fn transcripts_are_those_that_were_read() {
    std::thread::scope(|scope| {
        for file in files("tests/transcripts") {
            scope.spawn(move || {
                let bench = crate::bem::bench();
                bench.write("soft.toml", SOFT);
                bench.write("negative.toml", NEGATIVE);
                bench.write("plain.toml", NO_SHEAR);
                checked(&file, &bench, |line, run| match run.code {
                    Some(0) => run.messages + &run.out,
                    Some(code @ (1 | 2)) => {
                        assert!(run.out.is_empty(), "{line}\n{}", run.out);
                        // Usage follows after a blank line.
                        let said = run.messages.split("\n\n").next().unwrap().trim_end();
                        format!("{said}\nexit code {code}\n")
                    }
                    code => panic!("{line} ended with {code:?}"),
                });
            });
        }
    });
}

/// The files of a folder of the crate.
fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect()
}

/// The text of a file, whose commands print what it shows.
fn checked(file: &Path, bench: &Bench, show: impl Fn(&str, Run) -> String) -> String {
    let shown = fs::read_to_string(file).unwrap();
    assert!(shown.contains("```console\n$ "), "{}", file.display());
    let real = replayed(bench, &shown, show);
    if env::var_os("ASPERITY_BLESS").is_some() {
        fs::write(file, &real).unwrap();
        return real;
    }
    let (shown_lines, real_lines) = (shown.lines(), real.lines());
    for (shown, real) in shown_lines.clone().zip(real_lines.clone()) {
        assert!(agree(shown, real), "{}\nshown: {shown}\nreal:  {real}", file.display());
    }
    assert_eq!(shown_lines.count(), real_lines.count(), "{}", file.display());
    shown
}

/// The text with every command run again, and its output in the place of the one shown.
fn replayed(bench: &Bench, text: &str, show: impl Fn(&str, Run) -> String) -> String {
    let mut real = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("```console\n") {
        let (block, after) = after.split_once("```").expect("its end");
        real.push_str(before);
        real.push_str("```console\n");
        for line in block.lines().filter_map(|line| line.strip_prefix("$ ")) {
            real.push_str(&format!("$ {line}\n{}", show(line, sh(bench, line))));
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
            (Ok(x), Ok(y)) => a == b || (x - y).abs() <= 2e-5 * x.abs(),
            _ => a == b,
        })
}
