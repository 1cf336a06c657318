//! Links that hold the state of the page.

use std::io::Read;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::{ZlibDecoder, ZlibEncoder};
use serde_json::{Map, Value};

use crate::refusal::Refusal;

/// The version of links that this page writes and reads.
const VERSION: u32 = 1;
/// Longer states are compressed.
const PLAIN: usize = 1000;
/// The largest state, in bytes.
const MOST: u64 = 4 << 20;
/// The first byte of compressed data; json begins with a brace.
const ZLIB: u8 = 0x78;

/// The checksum of a file, as links have it.
pub(crate) fn checksum(bytes: &[u8]) -> String {
    format!("{:x}", md5::compute(bytes))
}

/// The text of a link behind `#s=`.
pub(crate) fn link(mut state: Map<String, Value>) -> Result<String, Refusal> {
    state.insert("version".into(), VERSION.into());
    let mut bytes = serde_json::to_vec(&state)?;
    if bytes.len() > PLAIN {
        bytes = read(ZlibEncoder::new(&*bytes, Compression::best()))?;
    }
    Ok(URL_SAFE_NO_PAD.encode(bytes))
}

fn read(from: impl Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = vec![];
    from.take(MOST).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The state of a link.
pub(crate) fn unlink(text: &str) -> Result<Value, Refusal> {
    let unpacked = || -> Option<Value> {
        let mut bytes = URL_SAFE_NO_PAD.decode(text.trim_end_matches('=')).ok()?;
        if bytes.first() == Some(&ZLIB) {
            bytes = read(ZlibDecoder::new(&*bytes)).ok()?;
        }
        serde_json::from_slice(&bytes).ok()
    };
    let state = unpacked().unwrap_or_default();
    let message = match &state["version"] {
        version if *version == VERSION && state["scene"].is_string() => return Ok(state),
        version if version.is_u64() && *version != VERSION => format!(
            "the link has version {version} and this page reads version {VERSION}: open it with the page that made it"
        ),
        _ => "the link is damaged or incomplete, and was not opened: copy the whole link, or start from an example".into(),
    };
    Err(Refusal::new(message))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn state(scene: &str) -> Map<String, Value> {
        let scan = json!({ "name": "a.x3p", "checksum": checksum(b"abc") });
        let state = json!({ "scene": scene, "models": ["ke"], "load": "12 N", "scan": scan });
        state.as_object().cloned().unwrap()
    }

    #[test]
    fn short_links_are_json_with_a_version_and_long_ones_are_compressed() {
        let short = link(state("a = 1")).unwrap();
        let json = String::from_utf8(URL_SAFE_NO_PAD.decode(&short).unwrap()).unwrap();
        assert!(json.contains("\"version\":1") && json.contains("\"scene\":\"a = 1\""), "{json}");
        assert!(json.contains("900150983cd24fb0d6963f7d28e17f72"), "{json}");
        let long = "# ground steel, twice\n".repeat(500);
        let text = link(state(&long)).unwrap();
        assert!(text.len() < 1000, "{}", text.len());
        for state in [state("a = 1"), state(&long)] {
            let mut found = unlink(&link(state.clone()).unwrap()).unwrap();
            assert_eq!(found.as_object_mut().unwrap().remove("version"), Some(json!(1)));
            assert_eq!(found.as_object(), Some(&state));
        }
    }

    #[test]
    fn damaged_links_and_those_of_other_versions_have_a_message() {
        let long = link(state(&"ab\n12".repeat(400))).unwrap();
        let short = link(state("a = 1")).unwrap();
        for text in ["", "%%%", "AAAA", &long[..long.len() / 2], &short[..short.len() / 2]] {
            assert!(unlink(text).is_err());
        }
        let newer = URL_SAFE_NO_PAD.encode(b"{\"version\":2,\"world\":[]}");
        assert!(unlink(&newer).is_err());
    }
}
