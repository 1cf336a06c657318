//! stub
use super::external::External;
pub fn text(_: &str, _: &str, _: &[External], machine: &str) -> anyhow::Result<String> {
    Ok(machine.into())
}
