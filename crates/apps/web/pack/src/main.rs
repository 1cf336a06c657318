//! `asperity-web-pack MODULE.wasm FOLDER`: writes `asperity.js` and `asperity_bg.wasm`.

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let mut words = std::env::args().skip(1);
    let module = words.next().context("the path of the module was required")?;
    let folder = words.next().context("a folder to write to was required")?;
    Bindgen::new()
        .input_path(module)
        .web(true)?
        .typescript(false)
        .omit_default_module_path(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .out_name("asperity")
        .generate(folder)
}
