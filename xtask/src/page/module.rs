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
    // Of the same version as the crate wasm-bindgen, so that nothing has to be installed. Built
    // beside the module, whose last steps have one thread.
    let pack = root.join("crates/asperity-web/pack/Cargo.toml");
    let build_pack = ["build", "--quiet", "--release", "--manifest-path"];
    let mut packer = cargo(root, &tools).args(build_pack).arg(pack).spawn().context("cargo")?;
    let build = ["--config", SIMD, "build", "--quiet", "--package", "asperity-web", "--lib"];
    let built =
        run(cargo(root, &tools).args(build).args(["--profile", "page", "--target", TARGET]));
    let packs = packer.wait().context("cargo")?;
    built?;
    ensure!(packs.success(), "the build of crates/asperity-web/pack failed: {packs}");
    let module = tools.join(TARGET).join("page").join("asperity_web.wasm");
    run(Command::new(tools.join("release/asperity-web-pack")).arg(module).arg(folder))
}

fn cargo(root: &Path, target: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root).env("CARGO_TARGET_DIR", target);
    command
}

fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?}"))?;
    ensure!(
        status.success(),
        "{command:?} failed: {status}; `rustup target add {TARGET}` installs the target"
    );
    Ok(())
}
