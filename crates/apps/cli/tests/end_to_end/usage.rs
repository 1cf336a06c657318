//! Exit codes: 2 for errors of the command line, 1 for errors of a file.

use crate::bench::Bench;

/// What a refused command line prints first; the usage follows.
#[test]
fn bad_usage_ends_with_2_and_states_the_requirement() {
    let bench = Bench::new();
    let printed = bench.refusals("{}", &[
        "curv scene.toml",
        "curve",
        "curve scene.toml extra.toml",
        "curve scene.toml --modle gw",
        "curve scene.toml --model zcm",
        "curve scene.toml --model gw ke",
        "curve scene.toml --model gw,,ke",
        "curve scene.toml --model",
        "curve scene.toml --model --errors",
        "curve scene.toml --quantity separation",
        "curve scene.toml --quantity stifness",
        "curve scene.toml --separation",
        "curve scene.toml --separation --errors",
        "curve scene.toml --separation 4:0:11",
        "curve scene.toml --separation 0:4:1",
        "curve scene.toml --separation 0:4",
        "curve scene.toml --separation 1,two",
        "curve scene.toml --separation nan",
        "curve scene.toml --separation 1:4:5:lgo",
        "curve scene.toml --separation 0:4:5:log",
        "curve scene.toml --load 0:100:5",
        "curve scene.toml --separation 1,2um",
        "joint scene.toml --model ke --load -5",
        "joint scene.toml --model ke --history 1,2 --closest 1",
        "joint scene.toml --model ke --load 5 --amplitude 1um --friction 25",
        "joint scene.toml --model ke,jg --load 5 --amplitude 1um --friction 0.2",
        "curve scene.toml --model ke,",
        "curve scene.toml --load 20KN",
        "joint scene.toml --model ke --load 1 --law herz",
        "joint scene.toml --model ke --load=-1e300",
        "curve scene.toml --load 10mm",
        "curve scene.toml --load -1 kN",
        "curve --separation 2 um scene.toml",
        "curve scene.toml --pressure 120HV",
        "fit scene.toml data.csv --free yield_strength=120HV:200HV",
        "joint scene.toml --closest 2 --amplitude 1um --friction 0.2 --points 1.5",
        "fit scene.toml --free hardness --load 1 --target tangent=1N/pm",
        "curve scene.toml --load 1:20kN:5",
        "curve scene.toml --pressure 1MPa:20:5",
        "export scene.toml --model ke --as csv --load 1:2kN:4",
        "curve scene.toml --load 1:10",
        "curve scene.toml --load 5 --separation 2",
        "curve scene.toml --pressure 5 --load 2",
        "curve scene.toml --tolerance 0",
        "curve scene.toml --format xml",
        "export scene.toml --model ke --as csv --load -5:5:3",
        "answer scene.toml --load 5 --quantity wear",
        "answer scene.toml --load 5 --pressure 5",
        "answer scene.toml",
        "export scene.toml --model ke --as csv",
        "export scene.toml --model ke --as csv --separation 0:4",
        "export scene.toml --model ke --as csv --load 1:4:3 --pressure 1:4:3",
        "export scene.toml --model ke --as nastran --separation 0:4:5",
        "export scene.toml --model ke --as csv --separation 4:0:5",
        "export scene.toml --model ke --as csv --load 1:4:3 --max-error 0",
        "export scene.toml --model ke --as csv --load 1:4:3 --friction 0.2",
        "fit scene.toml --free hardness --load 1 --target area_fraction=1% --model bem",
        "fit scene.toml --free hardness=5:1 --load 1 --target area_fraction=1%",
        "fit scene.toml --free hardness --load 1 --target area_fraction=2",
        "joint scene.toml --closest 1 --retreat -1:2:4",
        "curve scene.toml --pull-off --all --load 1",
        "generate --size 64x64 --pixel 1um --long 9um --short 8um --sq 1um --hurst 2 --output g.npy",
    ]);
    insta::assert_snapshot!(printed);
    let run = bench.run("");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
}

#[test]
fn bad_input_ends_with_1_and_names_the_place() {
    let bench = Bench::new();
    let template = asperity_scene::template();
    let commands = [
        "curve bad.toml",
        "curve bad.toml --model ke --load 1",
        "curve --plan bad.toml",
        "answer bad.toml --load 1",
        "export bad.toml --model ke --as csv --separation 0:4:9",
    ];
    for (from, to, printed) in [
        ("nominal_area =", "nominal_aera =", &["bad.toml:", "\"nominal_area\""][..]),
        ("poissons_ratio = 0.3", "poissons_ratio = 0.7", &["bad.toml:", "poissons_ratio", "0.7"]),
        ("poissons_ratio = 0.3", "poissons_ratio = \"x\"", &["bad.toml:", "poissons_ratio", "x"]),
        ("asperity_radius = 2e-4", "", &["bad.toml:", "surface", "asperity_radius"]),
        ("nominal_area = 1e-4", "nominal_area = ", &["bad.toml:"]),
    ] {
        bench.write("bad.toml", &template.replacen(from, to, 1));
        for arguments in commands {
            let run = bench.run(arguments);
            assert_eq!((run.code, run.out.as_str()), (Some(1), ""), "asperity {arguments}: {to}");
            for printed in printed {
                assert!(
                    run.messages.contains(printed),
                    "asperity {arguments}: {to}\n{}",
                    run.messages
                );
            }
        }
    }
    let run = bench.run("curve nowhere.toml");
    assert_eq!(run.code, Some(1));
    assert!(run.messages.contains("nowhere.toml"), "{}", run.messages);
}

#[test]
fn values_beyond_what_can_be_integrated_are_bad_input() {
    let bench = Bench::new();
    let run = bench.run("curve scene.toml --model ke --separation 2e9");
    assert_eq!((run.code, run.out.as_str()), (Some(1), ""));
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
}
