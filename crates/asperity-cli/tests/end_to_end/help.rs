//! Every help text has examples, and they work when pasted.

use std::env;
use std::process::Command;

use crate::bench::{Bench, Run};

const COMMANDS: [&str; 17] = [
    "",
    "check",
    "curve",
    "solve",
    "compare",
    "plan",
    "recommend",
    "models",
    "init",
    "surface",
    "export",
    "bem",
    "truth",
    "unload",
    "slip",
    "pull-off",
    "conductance",
];

#[test]
fn the_examples_of_every_help_text_work_when_pasted() {
    let bench = crate::bem::bench();
    std::fs::remove_file(bench.path("scene.toml")).unwrap();
    for command in COMMANDS {
        let help = bench.data(&format!("{command} --help"));
        let (_, examples) = help.split_once("Examples:\n").expect("examples in every help text");
        let pasted: Vec<&str> = examples.lines().filter(|l| l.starts_with("  asperity ")).collect();
        assert!(!pasted.is_empty(), "{help}");
        for line in pasted {
            let run = sh(&bench, line);
            assert_eq!(run.code, Some(0), "{line}\n{}", run.words);
            assert!(!run.words.contains("error:"), "{line}\n{}", run.words);
        }
    }
    assert!(bench.read("curve.svg").starts_with("<svg"));
    assert!(bench.read("ke.inp").contains("*SURFACE BEHAVIOR"));
}

#[test]
fn no_command_is_left_out() {
    let help = Bench::new().data("--help");
    let (_, commands) = help.split_once("Commands:\n").unwrap();
    let (commands, _) = commands.split_once("\n\n").unwrap();
    let names: Vec<&str> =
        commands.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert_eq!(names[..names.len() - 1], COMMANDS[1..], "the last one is help itself");
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
