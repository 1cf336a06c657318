//! A server of the page for this machine.

use std::fs::File;
use std::path::{Component, Path, PathBuf};

use anyhow::{Result, anyhow};
use tiny_http::{Header, Response, Server};

/// Serves the folder of a page on 127.0.0.1 until it is stopped, and prints the address.
///
/// # Errors
/// A port that cannot be opened.
pub fn serve(index: &Path) -> Result<()> {
    let server = Server::http("127.0.0.1:0").map_err(|error| anyhow!("127.0.0.1: {error}"))?;
    println!("http://{}/", server.server_addr());
    for request in server.incoming_requests() {
        let path = file_of(&index.with_file_name(""), request.url());
        // A browser that went away needs no answer.
        let _ = match path.and_then(|path| Some((File::open(&path).ok()?, kind(&path)))) {
            Some((file, kind)) => {
                let header = Header::from_bytes("Content-Type", kind).into_iter();
                request.respond(header.fold(Response::from_file(file), Response::with_header))
            }
            None => request.respond(Response::from_string("not found").with_status_code(404)),
        };
    }
    Ok(())
}

/// The file of an address, inside the folder.
fn file_of(folder: &Path, url: &str) -> Option<PathBuf> {
    let name = url.split(['?', '#']).next()?.trim_start_matches('/');
    let path = folder.join(if name.is_empty() { "index.html" } else { name });
    let inside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
    let path = if path.is_dir() { path.join("index.html") } else { path };
    (inside && path.is_file()).then_some(path)
}

fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|end| end.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        _ => "text/plain; charset=utf-8",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_served() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("index.html"), "page").unwrap();
        let index = Some(folder.path().join("index.html"));
        assert_eq!(file_of(folder.path(), "/"), index);
        assert_eq!(file_of(folder.path(), "/index.html?a#b"), index);
        assert_eq!(file_of(folder.path(), "/../index.html"), None);
        assert_eq!(file_of(folder.path(), "//etc/passwd"), None);
        assert_eq!(kind(Path::new("a.wasm")), "application/wasm");
    }
}
