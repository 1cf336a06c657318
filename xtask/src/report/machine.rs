//! The machine and the date of the measured times.

use std::fs;
use std::process::Command;

/// One line: processor, cores, compiler, build, date.
#[must_use]
pub fn description() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "development build" } else { "release build" };
    format!("{}, {cores} cores, {}, {build}, {}", processor(), compiler(), today())
}

fn processor() -> String {
    let name = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    format!(
        "{} ({})",
        name.unwrap_or_else(|| "unknown processor".into()),
        std::env::consts::ARCH.replace('_', "-")
    )
}

fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output().ok();
    let text = output.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    let name: Vec<&str> = text.split_whitespace().take(2).collect();
    if name.is_empty() { "unknown rustc".into() } else { name.join(" ") }
}

fn today() -> String {
    jiff::Timestamp::now().strftime("%F").to_string()
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
