//! Every help text has examples, and they work when pasted.

use std::env;
use std::process::Command;

use crate::bench::{Bench, Run, is_long};

/// The commands that the help lists.
fn commands(bench: &Bench) -> Vec<String> {
    let help = bench.data("--help");
    let (_, commands) = help.split_once("Commands:\n").unwrap();
    let (commands, _) = commands.split_once("\n\n").unwrap();
    let names = commands.lines().filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(Into::into).collect()
}

#[test]
fn the_examples_of_every_help_text_work_when_pasted() {
    let bench = crate::bem::bench();
    std::fs::remove_file(bench.path("scene.toml")).unwrap();
    let all = commands(&bench);
    for command in std::iter::once("").chain(all.iter().map(String::as_str)) {
        let help = bench.data(&format!("{command} --help"));
        let (_, examples) = help.split_once("Examples:\n").expect("examples");
        let pasted: Vec<&str> = examples.lines().filter(|l| l.starts_with("  asperity ")).collect();
        assert!(!pasted.is_empty(), "{help}");
        let is_slow = |line: &&str| line.contains(" --all");
        for line in pasted.into_iter().filter(|line| is_long() || !is_slow(line)) {
            let run = sh(&bench, line);
            assert_eq!(run.code, Some(0), "{line}\n{}", run.messages);
            assert!(!run.messages.contains("error:"), "{line}\n{}", run.messages);
        }
    }
    assert!(bench.read("curve.svg").starts_with("<svg"));
    assert!(bench.read("ke.inp").contains("*SURFACE BEHAVIOR"));
}

#[test]
fn the_help_lists_every_file_of_commands() {
    let listed = commands(&Bench::new());
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/commands");
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap().replace('_', "-");
        let is_command = text.starts_with(&format!("//! `asperity {name}`"));
        assert!(!is_command || listed.contains(&name), "{name}");
    }
    assert_eq!(listed[0], "init");
}

/// A line as a shell runs it, with the program on its path.
pub fn sh(bench: &Bench, line: &str) -> Run {
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_asperity"));
    let folders = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(
        program.parent().map(Into::into).into_iter().chain(env::split_paths(&folders)),
    );
    let mut shell = Command::new("sh");
    shell.current_dir(bench.folder()).env("PATH", path.unwrap()).args(["-c", line]);
    Run::of(shell.output().unwrap())
}
