//! Messages on standard error: errors, and findings with their codes.

use std::io::{self, Write};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::{Code, Finding, Severity};
use clap::Args;

/// How the program treats warnings and notes.
#[derive(Debug, Default, Args)]
pub struct Treatment {
    /// Print errors only, without warnings and notes
    #[arg(long, global = true, display_order = 100)]
    quiet: bool,
    /// End with exit code 1 if there is a warning that is not accepted
    #[arg(long, global = true, display_order = 100)]
    strict: bool,
    /// Leave out warnings and notes of these codes, as accept does in a scene
    #[arg(long, global = true, display_order = 100)]
    #[arg(value_name = "CODE", value_delimiter = ',', value_parser = code)]
    accept: Vec<String>,
}

static TREATMENT: OnceLock<Treatment> = OnceLock::new();
/// Warnings that are not accepted.
static WARNINGS: AtomicUsize = AtomicUsize::new(0);

fn code(text: &str) -> Result<String, String> {
    Code::named(text).map(|code| code.name.into())
}

/// Treats messages like this from now on.
pub fn treat(treatment: Treatment) {
    TREATMENT.get_or_init(|| treatment);
}

/// The codes that are accepted beside those of the scene.
pub fn accepted() -> &'static [String] {
    TREATMENT.get().map_or(&[], |treatment| &treatment.accept)
}

/// The reason why a strict run fails although it has an answer.
pub fn strict_failure() -> Option<String> {
    let strict = TREATMENT.get().is_some_and(|treatment| treatment.strict);
    match WARNINGS.load(Ordering::Relaxed) {
        _ if !strict => None,
        0 => None,
        1 => Some("--strict: there is a warning that is not accepted".into()),
        count => Some(format!("--strict: there are {count} warnings that are not accepted")),
    }
}

/// The error that ends the program; it goes on where standard error is closed.
pub fn print_error(text: &str) {
    let _ = writeln!(io::stderr(), "error: {text}");
}

/// Each finding on a line, unless its code is accepted: `warning[few-contacts]: ...`.
pub fn show<'a>(found: impl IntoIterator<Item = &'a Finding>) {
    let is_quiet = TREATMENT.get().is_some_and(|treatment| treatment.quiet);
    for found in found {
        let Finding { code, severity, .. } = found;
        let is_refusal = *severity == Severity::Refusal;
        if !is_refusal && accepted().iter().any(|accepted| accepted == code) {
            continue;
        }
        if *severity == Severity::Warning {
            WARNINGS.fetch_add(1, Ordering::Relaxed);
        }
        if is_refusal || !is_quiet {
            let _ = writeln!(io::stderr(), "{severity}[{code}]: {found}");
        }
    }
}

/// A note that is a sentence of its own.
pub fn note(code: &'static str, text: impl Into<String>) {
    show([&Finding::note(code, "", f64::NAN).fact(text.into())]);
}

/// A warning that is a sentence of its own.
pub fn warn(code: &'static str, text: impl Into<String>) {
    show([&Finding::warning(code, "", f64::NAN).fact(text.into())]);
}
