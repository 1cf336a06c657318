//! The examples run, and the README shows what they print.

use std::env::consts::EXE_EXTENSION;
use std::path::Path;
use std::process::Command;

/// Runs what `cargo test` has built beside this test: cargo itself would build it anew, with the
/// features of this package alone.
fn run(example: &str) -> String {
    let test = std::env::current_exe().expect("a test has a path");
    let profile = test.parent().and_then(Path::parent).expect("target/debug/deps/test");
    let built = profile.join("examples").join(example).with_extension(EXE_EXTENSION);
    let output = Command::new(&built).output().expect("cargo test builds examples");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("examples print UTF-8")
}

#[test]
fn the_readme_shows_its_example_and_what_it_prints() {
    let example = include_str!("../../examples/readme.rs");
    let (_, code) = example.split_once("\n\n").expect("a head comment");
    let printed = run("readme");
    let readme = include_str!("../../README.md");
    assert!(readme.contains(code), "examples/readme.rs");
    assert!(readme.contains(&format!("```text\n{printed}```")), "it should show\n{printed}");
}

#[test]
fn a_model_of_ones_own_has_no_findings() {
    let printed = run("own_model");
    assert!(!printed.contains("wrong"), "{printed}");
    assert_eq!(printed.lines().count(), 3);
}
