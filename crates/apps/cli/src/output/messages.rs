//! Messages on standard error: errors, findings with their codes, and results in sentences.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::{Mutex, OnceLock};

use asperity::{Advice, Code, Finding, Severity};
use clap::Args;

/// How the program treats warnings and notes.
#[derive(Debug, Default, Args)]
pub struct Treatment {
    /// Print errors only, without warnings, notes and results in sentences
    #[arg(long, global = true, display_order = 100)]
    quiet: bool,
    /// End with exit code 1 if there is a warning that is not accepted
    #[arg(long, global = true, display_order = 100)]
    strict: bool,
    /// Leave out warnings and notes of these codes, as accept does in a scene
    #[arg(long, global = true, display_order = 100)]
    #[arg(value_name = "CODE", value_delimiter = ',', value_parser = Code::named)]
    accept: Vec<Code>,
}

static TREATMENT: OnceLock<Treatment> = OnceLock::new();
/// Codes of warnings that are not accepted.
static WARNINGS: Mutex<BTreeSet<Code>> = Mutex::new(BTreeSet::new());

/// Treats messages like this from now on.
pub fn treat(treatment: Treatment) {
    TREATMENT.get_or_init(|| treatment);
}

/// The codes that are accepted beside the scene's.
pub fn accepted() -> &'static [Code] {
    TREATMENT.get().map_or(&[], |treatment| &treatment.accept)
}

/// The reason why a strict run fails although it has an answer.
pub fn strict_failure() -> Option<String> {
    TREATMENT.get().filter(|treatment| treatment.strict)?;
    let codes: Vec<&str> = WARNINGS.lock().ok()?.iter().map(|code| code.name()).collect();
    let text = format!("--strict: not all warnings are accepted: {}", codes.join(", "));
    (!codes.is_empty()).then_some(text)
}

/// The error that ends the program; it goes on where standard error is closed.
pub fn print_error(text: &str) {
    let _ = writeln!(io::stderr(), "error: {text}");
}

/// Results that no column has, each on a line.
pub fn print_results(results: &[String]) {
    if !is_quiet() {
        results.iter().for_each(|text| drop(writeln!(io::stderr(), "{text}")));
    }
}

fn is_quiet() -> bool {
    TREATMENT.get().is_some_and(|treatment| treatment.quiet)
}

/// Each finding on a line, unless its code is accepted: `warning[few-contacts]: ...`.
pub fn show<'a>(found: impl IntoIterator<Item = &'a Finding>) {
    let is_quiet = is_quiet();
    for found in found {
        let Finding { code, severity, .. } = found;
        if found.is_accepted(accepted()) {
            continue;
        }
        if let (Severity::Warning, Ok(mut codes)) = (severity, WARNINGS.lock()) {
            codes.insert(*code);
        }
        if *severity == Severity::Refusal || !is_quiet {
            let text = found.worded(&found.field, words);
            let _ = writeln!(io::stderr(), "{severity}[{code}]: {text}");
        }
    }
}

/// The commands and options that do what is advised.
fn words(advice: Advice) -> String {
    match advice {
        Advice::CompareCutOffs => "compare cut-offs with `asperity surface --scales`".into(),
        Advice::Despike => "despike = true (--despike) replaces them".into(),
        other => other.to_string(),
    }
}

/// A note that is a sentence of its own.
pub fn note(code: Code, text: impl Into<String>) {
    show([&Finding::note(code, "", f64::NAN).fact(text.into())]);
}

/// A warning that is a sentence of its own.
pub fn warn(code: Code, text: impl Into<String>) {
    show([&Finding::warning(code, "", f64::NAN).fact(text.into())]);
}
