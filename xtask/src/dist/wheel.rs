//! The wheel of the Python package for any Linux with glibc 2.17 and Python 3.10, or newer.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::{Build, archive, licences, output, run};
use crate::folder::target_folder;
use crate::guide::root;

const TARGET: &str = "x86_64-unknown-linux-gnu";
/// What a user without Rust does: imports, one answer, one plot.
const TRIAL: &str = r#"
import pathlib, shutil
import asperity
assert shutil.which("cargo") is None, "cargo is on the path"
assert "site-packages" in asperity.__file__, asperity.__file__
steel = asperity.Body(210e9, 0.3, hardness=2e9)
scene = asperity.Scene(
    interface=asperity.Interface.between(steel, steel),
    surface=asperity.Surface(2e-4, 2e8, 1e-6),
    nominal_area=1e-4,
)
curve = asperity.model("ke").solve(scene, separation=[1.0, 2.0, 3.0], quantities=["force", "area"])
assert f"{curve.force[1]:.2f} {curve.area[1]:.3e}" == "216.94 1.427e-07", (curve.force, curve.area)
assert curve._repr_svg_().startswith("<svg"), "no plot"
"#;

/// Builds the wheel and tries it in a new environment without cargo on its path.
pub fn write(build: Build, folder: &Path) -> Result<PathBuf> {
    let tools = tools()?;
    let package = root().join("crates/asperity-python");
    write_licences(&package.join("licenses"))?;
    let profile = match build {
        Build::Release => "release",
        Build::Quick => "quick",
    };
    let path = std::env::var("PATH").unwrap_or_default();
    run(Command::new(tools.join("bin/maturin"))
        .args(["build", "--zig", "--compatibility", "manylinux2014", "--profile", profile])
        .args(["--target", TARGET, "--quiet", "--out"])
        .arg(folder)
        .arg("--manifest-path")
        .arg(package.join("Cargo.toml"))
        // Where maturin finds zig.
        .env("PATH", format!("{}:{path}", tools.join("bin").display())))?;
    let is_wheel = |path: &PathBuf| path.extension().is_some_and(|end| end == "whl");
    let wheel =
        archive::files(folder)?.into_iter().find(is_wheel).context("maturin made no wheel")?;
    let name = wheel.to_string_lossy();
    ensure!(name.contains("-abi3-manylinux") && name.contains("2014_x86_64"), "unexpected: {name}");
    try_out(&wheel)?;
    Ok(wheel)
}

/// An environment with maturin and zig, made once.
fn tools() -> Result<PathBuf> {
    let folder = target_folder().join("dist-tools");
    if !folder.join("bin/maturin").is_file() || !folder.join("bin/python-zig").is_file() {
        run(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
        pip(&folder, &["maturin>=1.9.4,<2", "ziglang"])?;
    }
    Ok(folder)
}

fn pip(environment: &Path, what: &[&str]) -> Result<()> {
    run(Command::new(environment.join("bin/python"))
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
        .args(what))
}

/// The licence of the package and those of what is compiled into it.
fn write_licences(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    for name in ["LICENSE-APACHE", "LICENSE-MIT"] {
        fs::copy(root().join(name), folder.join(name)).with_context(|| name.to_owned())?;
    }
    let notices = licences::notices("asperity-python", TARGET)?;
    fs::write(folder.join("THIRD-PARTY.txt"), notices).context("THIRD-PARTY.txt")
}

fn try_out(wheel: &Path) -> Result<()> {
    let folder = tempfile::tempdir().context("a folder for the trial")?;
    let environment = folder.path().join("venv");
    run(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
    pip(&environment, &[&wheel.to_string_lossy()])?;
    output(
        Command::new(environment.join("bin/python"))
            .args(["-c", TRIAL])
            .env("PATH", environment.join("bin"))
            .current_dir(folder.path()),
    )?;
    Ok(())
}
