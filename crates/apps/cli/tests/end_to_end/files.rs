//! Broken pipes, files that cannot be written, names that are not UTF-8.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

use crate::bench::{Bench, Run};

const CURVE: &str = "curve scene.toml --model ke --separation 0:4:3";

#[test]
fn a_closed_pipe_is_no_error() {
    let bench = Bench::new();
    for format in ["csv", "json", "table"] {
        let arguments =
            format!("curve scene.toml --model ke --separation 0:4:50000 --format {format}");
        let mut child = bench
            .command()
            .args(arguments.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut reader = BufReader::new(child.stdout.take().unwrap());
        reader.read_line(&mut line).unwrap();
        drop(reader);
        let run = Run::of(child.wait_with_output().unwrap());
        assert_eq!((run.code, run.messages.as_str()), (Some(0), ""), "{format}");
        assert!(!line.is_empty());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let bench = Bench::new();
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let output = bench.command().args(CURVE.split(' ')).stdout(full).output().unwrap();
    let run = Run::of(output);
    assert_eq!(run.code, Some(1));
    let run = bench.run(&format!("{CURVE} --output /dev/full"));
    assert_eq!(run.code, Some(1));
}

#[test]
fn files_that_cannot_be_written_are_named_and_nothing_is_left_behind() {
    let bench = Bench::new();
    for end in ["csv", "svg"] {
        let kept = bench.path(&format!("kept.{end}"));
        fs::write(&kept, "kept").unwrap();
        let mut permissions = fs::metadata(&kept).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&kept, permissions).unwrap();
        fs::create_dir(bench.path(&format!("folder.{end}"))).unwrap();
    }
    for target in ["missing/out", "folder", "kept", "scene.toml/out"] {
        for (flag, end) in [("--output", "csv"), ("--plot", "svg")] {
            let target = format!("{target}.{end}");
            let run = bench.run(&format!("{CURVE} {flag} {target}"));
            assert_eq!((run.code, run.out.as_str()), (Some(1), ""), "{flag} {target}");
            assert!(run.messages.contains(&format!("cannot write {target}: ")), "{}", run.messages);
        }
    }
    assert_eq!(bench.read("kept.csv"), "kept");
    let mut names: Vec<_> =
        fs::read_dir(bench.folder()).unwrap().map(|e| e.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["folder.csv", "folder.svg", "kept.csv", "kept.svg", "scene.toml"]);
}

#[test]
fn an_answer_that_fails_leaves_the_old_file() {
    let bench = Bench::new();
    bench.write("out.csv", "old");
    let run = bench.run("curve scene.toml --model ke --load 1e40 --output out.csv");
    assert_eq!(run.code, Some(1));
    assert_eq!(bench.read("out.csv"), "old");
    bench.data(&format!("{CURVE} --output out.csv"));
    assert_eq!(bench.read("out.csv"), bench.data(CURVE));
    assert_eq!(bench.data(&format!("{CURVE} --output -")), bench.data(CURVE));
}

#[cfg(unix)]
#[test]
fn file_names_may_be_invalid_utf8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let bench = Bench::new();
    let [scene, out, plot] =
        [&b"sc\xffne.toml"[..], b"o\xfet.csv", b"pl\xf0t.svg"].map(OsStr::from_bytes);
    fs::rename(bench.path("scene.toml"), bench.folder().join(scene)).unwrap();
    let curve = |model: &OsStr| {
        let mut command = bench.command();
        command.arg("curve").arg(scene).arg("--output").arg(out).arg("--plot").arg(plot);
        Run::of(command.args(["--separation", "1", "--model"]).arg(model).output().unwrap())
    };
    let run = curve(OsStr::new("ke"));
    assert_eq!((run.code, run.messages.as_str()), (Some(0), ""));
    assert!(fs::read(bench.folder().join(out)).unwrap().starts_with(b"model,"));
    assert!(fs::read(bench.folder().join(plot)).unwrap().starts_with(b"<svg"));
    // A model is text.
    let run = curve(OsStr::from_bytes(b"g\xffw"));
    assert_eq!(run.code, Some(2), "{}", run.messages);
    // And so is the name in an error, as far as it can be.
    fs::write(bench.folder().join(scene), "nominal_area = -1").unwrap();
    let run = curve(OsStr::new("ke"));
    assert_eq!(run.code, Some(1));
    assert!(run.messages.contains("sc\u{fffd}ne.toml"), "{}", run.messages);
}
