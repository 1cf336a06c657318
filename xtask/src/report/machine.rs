//! The machine and the date of the measured times.

use std::process::Command;

use crate::command::output;

/// One line: processor, cores, compiler, build, date.
#[must_use]
pub fn description() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "development build" } else { "release build" };
    let about = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = about.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let name = name.map_or("unknown processor", |(_, name)| name.trim());
    let arch = std::env::consts::ARCH.replace('_', "-");
    let printed = |command: &str, argument: &str| {
        let printed = output(Command::new(command).arg(argument));
        printed.unwrap_or_else(|_| format!("unknown {command}"))
    };
    let (compiler, date) = (printed("rustc", "--version"), printed("date", "+%F"));
    let compiler = compiler.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    format!("{name} ({arch}), {cores} cores, {compiler}, {build}, {}", date.trim())
}

#[cfg(test)]
mod tests {
    use super::description;

    #[test]
    fn the_line_names_compiler_build_and_date() {
        let line = description();
        assert!(line.contains("rustc ") && line.contains(" build, 20"), "{line}");
    }
}
