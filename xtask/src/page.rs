//! The page: the explorer in `target/page`, with relative links only.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::command::{cargo, run};
use crate::folder::{copy, root, target_folder};

const TARGET: &str = "wasm32-unknown-unknown";
/// Two numbers at once: in Chrome since 91, Firefox 89, Safari 16.4.
const SIMD: &str = "target.wasm32-unknown-unknown.rustflags = ['-Ctarget-feature=+simd128']";

/// Writes the page and returns its front page; with `keep_module` without building the module
/// again.
///
/// # Errors
/// A failed build, files that cannot be read or written.
pub fn write(keep_module: bool) -> Result<PathBuf> {
    let folder = target_folder().join("page");
    copy(&root().join("crates/apps/web/www"), &folder)?;
    copy(&root().join("crates/answer/scene/examples"), &folder.join("examples"))?;
    if !keep_module {
        build(&folder)?;
    }
    Ok(folder.join("index.html"))
}

/// Builds `asperity.js` and `asperity_bg.wasm` into a folder.
fn build(folder: &Path) -> Result<()> {
    let tools = target_folder().join("page-tools");
    let cargo = || {
        let mut command = cargo();
        command.current_dir(root()).env("CARGO_TARGET_DIR", &tools);
        command
    };
    // Of the same version as the crate wasm-bindgen, so that nothing has to be installed. Built
    // beside the module, whose last steps have one thread.
    let pack = ["build", "--quiet", "--release", "--manifest-path"];
    let module = ["--config", SIMD, "build", "--quiet", "--package", "asperity-web", "--lib"];
    let (packed, built) = rayon::join(
        || run(cargo().args(pack).arg("crates/apps/web/pack/Cargo.toml")),
        || run(cargo().args(module).args(["--profile", "page", "--target", TARGET])),
    );
    packed.and(built)?;
    let module = tools.join(TARGET).join("page/asperity_web.wasm");
    run(Command::new(tools.join("release/asperity-web-pack")).arg(module).arg(folder))
}

/// Serves a folder on 127.0.0.1 until it is stopped, and prints the address.
///
/// # Errors
/// A machine without Python.
pub fn serve(folder: &Path) -> Result<()> {
    let server = ["-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory"];
    let served = run(Command::new("python3").args(server).arg(folder));
    served.with_context(|| format!("serve {} by another server", folder.display()))
}

#[cfg(test)]
mod tests {
    use crate::folder::{read, root};

    #[test]
    fn a_page_may_load_what_its_script_needs_and_nothing_inline() {
        let page = read(&root().join("crates/apps/web/www/index.html")).unwrap();
        let allowed = page.contains("script-src 'self' 'wasm-unsafe-eval';");
        assert!(page.contains("content=\"default-src 'none';"));
        assert!(allowed == page.contains("<script") && !page.contains("unsafe-inline"));
    }
}
