//! What a task needs beside Rust, looked for before anything is compiled.

use std::process::{Command, Stdio};

use anyhow::{Result, ensure};

const PYTHON: &str = "Python 3.10 or newer with venv and pip: `apt install python3 python3-venv`";

/// An error that names all that is missing for the task, with the commands that install it.
///
/// # Errors
/// A tool that is not installed.
pub fn check(task: &str, quick: bool) -> Result<()> {
    let target = |name: &str| {
        let missing = format!("the Rust target {name}: `rustup target add {name}`");
        (missing, prints(&["rustup", "target", "list", "--installed"], name))
    };
    let python = || {
        let trial = "import sys, venv, ensurepip; print(sys.version_info >= (3, 10))";
        (PYTHON.to_owned(), prints(&["python3", "-c", trial], "True"))
    };
    let needed = match task {
        "page" => vec![target("wasm32-unknown-unknown")],
        "dist" if quick => vec![python()],
        "dist" => vec![python(), target("x86_64-unknown-linux-musl")],
        _ => vec![],
    };
    let missing = needed.into_iter().filter_map(|(missing, met)| (!met).then_some(missing));
    let missing: Vec<String> = missing.collect();
    ensure!(missing.is_empty(), "missing for this task:\n{}", missing.join("\n"));
    Ok(())
}

/// Whether a command succeeds and one of its lines is this.
fn prints(command: &[&str], wanted: &str) -> bool {
    let output = Command::new(command[0]).args(&command[1..]).stderr(Stdio::null()).output();
    output.is_ok_and(|output| {
        let text = String::from_utf8_lossy(&output.stdout);
        output.status.success() && text.lines().any(|line| line.trim() == wanted)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_is_met_by_what_it_prints_and_a_missing_one_is_named() {
        assert!(prints(&["echo", "yes"], "yes") && !prints(&["echo", "no"], "yes"));
        assert!(!prints(&["no-such-program"], "yes"));
        assert!(check("figures", false).is_ok());
    }
}
