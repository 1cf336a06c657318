//! Standard output, or a file that is complete or absent; messages on standard error.

pub mod contact_map;
mod messages;
pub mod plot;
pub mod table;

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};
pub use asperity_answer::once;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};
use tempfile::Builder;

pub use self::messages::{
    Treatment, accepted, note, print_error, print_results, show, strict_failure, treat, warn,
};

/// Shorter work shows no progress.
const PATIENCE: Duration = Duration::from_secs(1);

/// Whether this is the standard output: nothing named, or `-`.
pub fn is_standard(path: Option<&Path>) -> bool {
    path.is_none_or(|path| path == Path::new("-"))
}

/// Writes to a file, or to standard output without one or for `-`.
pub fn write(
    path: Option<&Path>,
    data: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<()> {
    match path {
        Some(path) if !is_standard(Some(path)) => {
            to_file(path, data).with_context(|| format!("cannot write {}", path.display()))
        }
        _ => {
            let mut out = BufWriter::new(io::stdout().lock());
            data(&mut out).and_then(|()| out.flush()).context("cannot write to standard output")
        }
    }
}

/// Likewise a text.
pub fn write_text(path: Option<&Path>, text: &str) -> Result<()> {
    write(path, |out| out.write_all(text.as_bytes()))
}

/// Writes beside the file and renames, so that the old file stays until the new one is complete.
fn to_file(path: &Path, data: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    // A link stays, and its target is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
    let found = fs::metadata(&target).ok();
    if found.as_ref().is_some_and(|found| !found.is_file() && !found.is_dir()) {
        // A device or a pipe is written to, not replaced.
        let mut out = BufWriter::new(File::options().write(true).open(&target)?);
        data(&mut out)?;
        return out.flush();
    }
    let permissions = found.as_ref().map(fs::Metadata::permissions);
    if permissions.as_ref().is_some_and(fs::Permissions::readonly) {
        // A rename would replace it regardless.
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"));
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return Err(io::Error::new(io::ErrorKind::NotFound, "the folder does not exist"));
    }
    let mut builder = Builder::new();
    builder.prefix(".asperity-");
    if let Some(permissions) = permissions.or_else(new_file) {
        builder.permissions(permissions);
    }
    let mut file = builder.tempfile_in(folder)?;
    let mut out = BufWriter::new(file.as_file_mut());
    data(&mut out)?;
    out.flush()?;
    drop(out);
    file.persist(&target).map_err(|refused| refused.error)?;
    Ok(())
}

/// Refuses to overwrite a scene, which may hold an hour's work.
pub fn refuse_to_replace(path: &Path) -> Result<()> {
    if fs::metadata(path).is_ok_and(|found| found.is_file() && found.len() > 0) {
        bail!("{} exists; remove it, or choose another name", path.display());
    }
    Ok(())
}

/// The permissions of any new file, which temporary ones lack; the system takes the mask off.
fn new_file() -> Option<fs::Permissions> {
    #[cfg(unix)]
    return Some(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    #[cfg(not(unix))]
    None
}

/// Whether the reader of the output has ended, as `head` does: no error.
pub fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        cause.downcast_ref::<io::Error>().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
    })
}

/// An error and its causes, each once: most messages of the libraries end with their cause's.
pub fn summary(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if !text.ends_with(&cause) {
            text = if text.is_empty() { cause } else { format!("{text}: {cause}") };
        }
    }
    text
}

/// Progress on a terminal, shown after one second until it is dropped.
pub fn progress(what: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
        .with_finish(ProgressFinish::AndClear)
        .with_message(what.to_string());
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    let shown = bar.downgrade();
    thread::spawn(move || {
        thread::sleep(PATIENCE);
        if let Some(bar) = shown.upgrade() {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.enable_steady_tick(PATIENCE / 10);
        }
    });
    bar
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        write(Some(&path), |out| out.write_all(b"old")).unwrap();
        let failing = write(Some(&path), |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(failing.is_err());
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_cause_that_its_error_repeats_is_not_repeated() {
        let error = anyhow::anyhow!("no rain").context("dry: no rain").context("scene.toml");
        assert_eq!(summary(&error), "scene.toml: dry: no rain");
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_permissions_kept() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("real"), folder.path().join("link"));
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        std::os::unix::fs::symlink(&path, &link).unwrap();
        write(Some(&link), |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
    }
}
