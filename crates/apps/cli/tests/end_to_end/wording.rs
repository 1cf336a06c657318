//! What the commands say about scenes and results: one snapshot a command, to be read as prose when
//! it changes. Other tests look for codes, fields and numbers.

use crate::adhesion::SOFT;
use crate::bem::bench;
use crate::bench::NEGATIVE;

/// The messages of lines with an answer.
fn said(lines: &[&str]) -> String {
    let bench = bench();
    bench.write("soft.toml", SOFT);
    bench.write("negative.toml", NEGATIVE);
    let said = |line: &&str| {
        let run = bench.run(line);
        assert_eq!(run.code, Some(0), "asperity {line}\n{}", run.messages);
        format!("$ asperity {line}\n{}", run.messages)
    };
    lines.iter().map(said).collect::<Vec<_>>().join("\n")
}

#[test]
fn curve() {
    let printed = said(&[
        "curve scene.toml --model best --load 1.5 --quantity area",
        "curve scene.toml --model ke --load 10MN --quantity area",
        "curve scene.toml --model gw,gw-pairs --reference gw --load 100 --quantity area",
        "curve scene.toml --model ke --separation 40",
        "curve negative.toml --model at --separation 1,3.4637,40 --quantity force",
        "curve soft.toml --model gw,jkr --load -10mN",
        "curve soft.toml --model gw --separation 1",
    ]);
    insta::assert_snapshot!(printed);
}

/// With what it prints.
#[test]
fn answer() {
    let bench = bench();
    let lines = ["--load 100", "--pressure 1e8 --solve", "--load 1,100"];
    let said = lines.map(|line| {
        let run = bench.run(&format!("answer scan.toml {line}"));
        format!("$ asperity answer scan.toml {line}\n{}{}", run.messages, run.out)
    });
    insta::assert_snapshot!(said.join("\n"));
}

#[test]
fn joint() {
    let printed = said(&[
        "joint scene.toml --model ke --friction 0.3 --closest 2 --tangential-force 1N,1MN",
        "joint scene.toml --model ke --load 100 --retreat 0um,100um",
        "joint scene.toml --model ke --history 2,40,0.5",
        "joint scan.toml --model bem --pressure 1e7 --retreat 0um,1um",
    ]);
    insta::assert_snapshot!(printed);
}

#[test]
fn bem() {
    let printed = said(&[
        "bem scan.toml --pressure 1e7,1e9",
        "bem scan.toml --pressure 1e8 --compare --model gw,ke",
    ]);
    insta::assert_snapshot!(printed);
}

#[test]
fn export() {
    let printed = said(&["export scene.toml --model gw --as abaqus --load 1:1e4:4"]);
    insta::assert_snapshot!(printed);
}

#[test]
fn generate() {
    let printed = said(&[
        "generate --size 64x64 --output s.npy --long 16 --short 2 --pixel 0.25 --sq 0.1",
        "generate --size 64x64 --output s.npy --long 99um --short 2um --pixel 0.25um --sq 9um",
    ]);
    insta::assert_snapshot!(printed);
}

#[test]
fn surface() {
    let printed = said(&["surface scan.txt --unit um --pixel-size 2 --periodic"]);
    insta::assert_snapshot!(printed);
}
