//! Links that hold the state of the page.

use std::io::{Read, Write};

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;
use serde::{Deserialize, Serialize};

use crate::random::RandomKeys;
use crate::refusal::Refusal;

/// The version of links that this page writes and reads.
const VERSION: u32 = 1;
/// Longer states are compressed.
const PLAIN: usize = 1000;
/// The largest state, in bytes.
const MOST: u64 = 4 << 20;
/// The first byte of compressed data; that of json is a brace.
const ZLIB: u8 = 0x78;

/// What a link restores.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PageState {
    #[serde(default = "version")]
    version: u32,
    pub(crate) scene: String,
    pub(crate) models: Vec<String>,
    /// The load as typed, with its unit.
    pub(crate) load: String,
    /// The quantity of the picture.
    pub(crate) view: String,
    /// The scan, which the link does not hold.
    pub(crate) scan: Option<ScanName>,
    /// The random surface, which is made again.
    #[serde(default)]
    pub(crate) random: Option<RandomKeys>,
    /// The example that the scene started from.
    #[serde(default)]
    pub(crate) example: Option<String>,
}

fn version() -> u32 {
    VERSION
}

/// A file by its name and the checksum of its bytes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct ScanName {
    pub(crate) name: String,
    pub(crate) checksum: String,
}

/// The checksum of a file, as links have it.
pub(crate) fn checksum(bytes: &[u8]) -> String {
    format!("{:x}", md5::compute(bytes))
}

/// The text of a link behind `#s=`.
pub(crate) fn link(state: &PageState) -> Result<String, Refusal> {
    let state = PageState { version: VERSION, ..state.clone() };
    let json = serde_json::to_vec(&state)?;
    let bytes = if json.len() > PLAIN { packed(&json)? } else { json };
    Ok(URL_SAFE_NO_PAD.encode(bytes))
}

fn packed(json: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut out = ZlibEncoder::new(vec![], Compression::best());
    out.write_all(json)?;
    out.finish()
}

/// The state of a link.
pub(crate) fn unlink(text: &str) -> Result<PageState, Refusal> {
    let damaged = || {
        let advice = "copy the whole link, or start from an example";
        Refusal::new(format!("the link is damaged or incomplete, and was not opened: {advice}"))
    };
    let bytes = URL_SAFE_NO_PAD.decode(text.trim_end_matches('=')).map_err(|_| damaged())?;
    let json = match bytes.first() {
        Some(&ZLIB) => {
            let mut json = vec![];
            let read = ZlibDecoder::new(&*bytes).take(MOST + 1).read_to_end(&mut json);
            read.map_err(|_| damaged())?;
            if json.len() as u64 > MOST {
                return Err(damaged());
            }
            json
        }
        _ => bytes,
    };
    #[derive(Deserialize)]
    struct Versioned {
        version: u32,
    }
    let found: Versioned = serde_json::from_slice(&json).map_err(|_| damaged())?;
    if found.version != VERSION {
        let found = found.version;
        return Err(Refusal::new(format!(
            "the link has version {found} and this page reads version {VERSION}: open it with the page that made it"
        )));
    }
    serde_json::from_slice(&json).map_err(|_| damaged())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(scene: &str) -> PageState {
        let scan = ScanName { name: "a.x3p".into(), checksum: checksum(b"abc") };
        PageState {
            version: VERSION,
            scene: scene.into(),
            models: vec!["ke".into()],
            load: "12 N".into(),
            view: "tangent".into(),
            scan: Some(scan),
            random: None,
            example: Some("wheel-rail".into()),
        }
    }

    #[test]
    fn short_links_are_json_with_the_version_first_and_long_ones_are_compressed() {
        let short = link(&state("a = 1")).unwrap();
        let json = String::from_utf8(URL_SAFE_NO_PAD.decode(&short).unwrap()).unwrap();
        assert!(json.starts_with("{\"version\":1,\"scene\":\"a = 1\""), "{json}");
        assert!(json.contains("900150983cd24fb0d6963f7d28e17f72"), "{json}");
        let long = "# ground steel, twice\n".repeat(500);
        let text = link(&state(&long)).unwrap();
        assert!(text.len() < 1000, "{}", text.len());
        for state in [state("a = 1"), state(&long)] {
            assert_eq!(unlink(&link(&state).unwrap()).unwrap(), state);
        }
    }

    #[test]
    fn damaged_links_and_those_of_other_versions_have_a_message() {
        let long = link(&state(&"ab\n12".repeat(400))).unwrap();
        let short = link(&state("a = 1")).unwrap();
        for text in ["", "%%%", "AAAA", &long[..long.len() / 2], &short[..short.len() / 2]] {
            let refused = unlink(text).unwrap_err().message;
            assert!(refused.starts_with("the link is damaged or incomplete"), "{refused}");
        }
        let newer = URL_SAFE_NO_PAD.encode(b"{\"version\":2,\"world\":[]}");
        let refused = unlink(&newer).unwrap_err().message;
        assert!(refused.starts_with("the link has version 2 and this page reads"), "{refused}");
    }
}
