//! Folders as archives: the same folder gives the same bytes.

use std::fs::{self, File};
use std::io::{Seek, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use zip::write::SimpleFileOptions;
use zip::{DateTime, ZipWriter};

use super::run;

/// Packs a folder, under its own name, as `.tar.gz`, with files that belong to nobody.
pub fn tar(folder: &Path, to: &Path) -> Result<()> {
    let parent = folder.parent().unwrap_or(folder);
    let name = folder.file_name().unwrap_or_default();
    run(Command::new("tar")
        .args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner"])
        .args(["--mtime=1980-01-01 00:00Z", "--use-compress-program=gzip -n", "--create", "--file"])
        .arg(to)
        .arg("--directory")
        .arg(parent)
        .arg(name))
}

/// Packs the files of a folder under `name` as a zip.
pub fn zip(folder: &Path, name: &str, to: &Path) -> Result<()> {
    let file = File::create(to).with_context(|| to.display().to_string())?;
    zip_into(folder, name, file).with_context(|| to.display().to_string())
}

fn zip_into(folder: &Path, name: &str, to: impl Write + Seek) -> Result<()> {
    let mut zip = ZipWriter::new(to);
    // The least time that a zip can have.
    let options = SimpleFileOptions::default().last_modified_time(DateTime::default());
    for path in files(folder)? {
        let inside = path.strip_prefix(folder)?.to_string_lossy().replace('\\', "/");
        zip.start_file(format!("{name}/{inside}"), options)?;
        zip.write_all(&fs::read(&path).with_context(|| path.display().to_string())?)?;
    }
    zip.finish()?.flush()?;
    Ok(())
}

/// All files below a folder, in order.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = vec![];
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        match path.is_dir() {
            true => found.extend(files(&path)?),
            false => found.push(path),
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Cursor, Read};

    #[test]
    fn a_zip_has_every_file_under_its_name_and_the_same_bytes_each_time() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("b")).unwrap();
        fs::write(folder.path().join("b/c.txt"), "c").unwrap();
        fs::write(folder.path().join("a.txt"), "a".repeat(1000)).unwrap();
        let pack = || {
            let mut bytes = Cursor::new(vec![]);
            zip_into(folder.path(), "page", &mut bytes).unwrap();
            bytes.into_inner()
        };
        assert_eq!(pack(), pack());
        let mut archive = zip::ZipArchive::new(Cursor::new(pack())).unwrap();
        let names: Vec<String> = archive.file_names().map(|name| name.unwrap().into()).collect();
        assert_eq!(names, ["page/a.txt", "page/b/c.txt"]);
        let mut text = String::new();
        archive.by_name("page/b/c.txt").unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "c");
    }
}
