//! What a task needs beside Rust, looked for before anything is compiled.

use std::process::{Command, Stdio};

use anyhow::{Result, ensure};

/// A tool, how it is tried, and the command that installs it.
struct Need {
    what: &'static str,
    trial: &'static [&'static str],
    /// What the trial must print; nothing if its success is enough.
    printed: &'static str,
    install: &'static str,
}

const WASM: Need = Need {
    what: "the Rust target wasm32-unknown-unknown",
    trial: &["rustup", "target", "list", "--installed"],
    printed: "wasm32-unknown-unknown",
    install: "rustup target add wasm32-unknown-unknown",
};
const MUSL: Need = Need {
    what: "the Rust target x86_64-unknown-linux-musl",
    trial: &["rustup", "target", "list", "--installed"],
    printed: "x86_64-unknown-linux-musl",
    install: "rustup target add x86_64-unknown-linux-musl",
};
const PYTHON: Need = Need {
    what: "Python 3.10 or newer with venv and pip",
    trial: &["python3", "-c", "import sys, venv, ensurepip; print(sys.version_info >= (3, 10))"],
    printed: "True",
    install: "apt install python3 python3-venv",
};

/// An error that names all that is missing for the task, with the commands that install it.
///
/// # Errors
/// A tool that is not installed.
pub fn check(task: &str, quick: bool) -> Result<()> {
    let needed: &[Need] = match task {
        "page" => &[WASM],
        "dist" if quick => &[PYTHON],
        "dist" => &[PYTHON, MUSL],
        _ => &[],
    };
    let missing: Vec<String> = needed
        .iter()
        .filter(|need| !need.is_met())
        .map(|need| format!("{}: `{}`", need.what, need.install))
        .collect();
    ensure!(missing.is_empty(), "missing for this task:\n{}", missing.join("\n"));
    Ok(())
}

impl Need {
    fn is_met(&self) -> bool {
        let [program, arguments @ ..] = self.trial else { return true };
        let output = Command::new(program).args(arguments).stderr(Stdio::null()).output();
        output.is_ok_and(|output| {
            let text = String::from_utf8_lossy(&output.stdout);
            output.status.success() && text.lines().any(|line| line.trim() == self.printed)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_is_met_by_what_it_prints_and_a_missing_one_is_named() {
        let need = |trial| Need { what: "", trial, printed: "yes", install: "" };
        assert!(need(&["echo", "yes"]).is_met() && !need(&["echo", "no"]).is_met());
        assert!(!need(&["no-such-program"]).is_met());
        assert!(check("figures", false).is_ok());
    }
}
