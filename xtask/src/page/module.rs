//! The module of the page and its JavaScript side.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

const TARGET: &str = "wasm32-unknown-unknown";
/// Two numbers at once: in Chrome since 91, Firefox 89, Safari 16.4.
const SIMD: &str = "target.wasm32-unknown-unknown.rustflags = ['-Ctarget-feature=+simd128']";

/// Builds `asperity.js` and `asperity_bg.wasm` into a folder.
pub(super) fn write(root: &Path, folder: &Path) -> Result<()> {
    let tools = root.join("target").join("page-tools");
    let build = ["--config", SIMD, "build", "--quiet", "--package", "asperity-web", "--lib"];
    run(cargo(root, &tools).args(build).args(["--profile", "page", "--target", TARGET]))?;
    let module = tools.join(TARGET).join("page").join("asperity_web.wasm");
    // Of the same version as the crate wasm-bindgen, so that nothing has to be installed.
    let pack = root.join("crates/asperity-web/pack/Cargo.toml");
    let pack = pack.as_os_str();
    let run_pack = ["run", "--quiet", "--release", "--manifest-path"];
    run(cargo(root, &tools).args(run_pack).arg(pack).arg("--").arg(module).arg(folder))
}

fn cargo(root: &Path, target: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root).env("CARGO_TARGET_DIR", target);
    command
}

fn run(command: &mut Command) -> Result<()> {
    let status = command.status().context("cargo")?;
    ensure!(
        status.success(),
        "{command:?} failed: {status}; `rustup target add {TARGET}` installs the target"
    );
    Ok(())
}
