//! Where data goes: the standard output, or a file that is complete or not there at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use tempfile::Builder;

/// Whether this is the standard output: nothing named, or `-`.
pub fn is_standard(path: Option<&Path>) -> bool {
    path.is_none_or(|path| path == Path::new("-"))
}

/// What `--output` says: a file, or `-` for the standard output.
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

/// Writes beside the file and renames, so that what was there stays until all is written.
fn to_file(path: &Path, data: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let target = resolved(path);
    if fs::metadata(&target).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        // A device or a pipe is written to, not replaced.
        let mut out = BufWriter::new(File::options().write(true).open(&target)?);
        data(&mut out)?;
        return out.flush();
    }
    if target.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory));
    }
    if fs::metadata(&target).is_ok_and(|found| found.permissions().readonly()) {
        // A rename would replace it all the same.
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"));
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        return Err(io::Error::new(io::ErrorKind::NotFound, "there is no such folder"));
    }
    let mut builder = Builder::new();
    builder.prefix(".asperity-");
    if let Some(permissions) = permissions(&target) {
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

/// A scene may hold an hour's work: it is replaced only when that is asked for.
pub fn refuse_to_replace(path: &Path, force: bool) -> Result<()> {
    if !force && fs::metadata(path).is_ok_and(|found| found.is_file() && found.len() > 0) {
        bail!("{} exists: another name, or --force to replace it, was required", path.display());
    }
    Ok(())
}

/// A link is followed, so that what it points to is replaced and not the link.
fn resolved(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.into())
}

/// Those of the file that is replaced; otherwise those of any new file, which temporary ones lack.
fn permissions(target: &Path) -> Option<fs::Permissions> {
    if let Ok(found) = fs::metadata(target) {
        return Some(found.permissions());
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The system takes the user's mask off.
        Some(fs::Permissions::from_mode(0o666))
    }
    #[cfg(not(unix))]
    None
}

/// Whether the reader of our output has gone: no error, it has seen enough.
pub fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        cause.downcast_ref::<io::Error>().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
    })
}

/// An error and its causes, each told once: most messages of the libraries end with their cause's.
pub fn told(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if !text.ends_with(&cause) {
            text = if text.is_empty() { cause } else { format!("{text}: {cause}") };
        }
    }
    text
}

/// A line of words on the standard error; that it may be closed is no reason to stop.
pub fn say(kind: &str, text: &str) {
    let _ = writeln!(io::stderr(), "{kind}: {text}");
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
    fn causes_that_have_been_told_are_not_told_again() {
        let error = anyhow::anyhow!("no rain").context("it is dry: no rain").context("scene.toml");
        assert_eq!(told(&error), "scene.toml: it is dry: no rain");
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
