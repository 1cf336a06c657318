//! Exit codes: 2 for errors of the command line, 1 for errors of a file.

use crate::bench::Bench;

#[test]
fn an_empty_model_name_leads_to_the_list_of_models() {
    let bench = Bench::new();
    for command in ["curve", "recommend", "check"] {
        let mut run = bench.command();
        let found = run.args([command, "scene.toml", "--model", "", "--load", "5"]).output();
        let found = found.unwrap();
        let arguments = String::from_utf8_lossy(&found.stderr);
        assert_eq!(found.status.code(), Some(2), "{arguments}");
        assert!(
            arguments.contains("invalid value '' for '--model <M>': a name is empty"),
            "{arguments}"
        );
        assert!(arguments.contains("`asperity models` lists them"), "{arguments}");
    }
}

#[test]
fn bad_usage_ends_with_2_and_states_the_requirement() {
    let bench = Bench::new();
    for (arguments, printed) in [
        ("curv scene.toml", "similar subcommand exists: 'curve'"),
        ("curve", "<SCENE>"),
        ("curve scene.toml extra.toml", "unexpected argument 'extra.toml'"),
        ("curve scene.toml --modle gw", "'--model'"),
        ("curve scene.toml --model zcm", "the nearest is \"zmc\""),
        ("curve scene.toml --model gw ke", "unexpected argument 'ke'"),
        ("curve scene.toml --model gw,,ke", "a name is empty"),
        ("curve scene.toml --model", "a value is required"),
        ("curve scene.toml --model --errors", "a value is required"),
        ("curve scene.toml --quantity separation", "separations come with every answer, unasked"),
        ("curve scene.toml --quantity stifness", "the nearest is \"stiffness\""),
        ("curve scene.toml --separation", "a value is required"),
        ("curve scene.toml --separation --errors", "a value is required"),
        ("curve scene.toml --separation 4:0:11", "A must be below B"),
        ("curve scene.toml --separation 0:4:1", "a whole number from 2"),
        ("curve scene.toml --separation 0:4", "A:B:N"),
        ("curve scene.toml --separation 1,two", "\"two\" is not a number"),
        ("curve scene.toml --separation nan", "finite"),
        ("curve scene.toml --separation 1 --separation-unit mm", "sigma"),
        ("curve scene.toml --separation 1:4:5:lgo", "only :log may follow"),
        ("curve scene.toml --separation 0:4:5:log", "begin above 0"),
        ("curve scene.toml --load 0:100:5", "0 is neither a load"),
        ("curve scene.toml --separation 1,2um", "write 1.2um for one value, or 1um,2um for two"),
        ("unload scene.toml --model ke --load -5", "-5 is not above 0"),
        ("unload scene.toml --model ke --history 1,2 --closest 1", "cannot be used with"),
        ("slip scene.toml --model ke --load 5 --amplitude 1um --friction 25", "20 % is 0.2"),
        (
            "slip scene.toml --model ke,jg --load 5 --amplitude 1um --friction 0.2",
            "this command takes one model",
        ),
        ("curve scene.toml --model ke,", "a name is empty"),
        ("curve scene.toml --load 20KN", "the nearest is \"20kN\""),
        ("unload scene.toml --model ke --load 1 --law herz", "the nearest is \"hertz\""),
        ("unload scene.toml --model ke --load=-1e300", "-1e300 is not above 0"),
        ("curve scene.toml --load 10mm", "\"10mm\" is not a number in N"),
        (
            "curve scene.toml --load -1 kN",
            "--load -1 kN is two arguments, as a blank separates -1 from kN; write --load -1kN, or --load \"-1 kN\"",
        ),
        ("curve --separation 2 um scene.toml", "--separation 2 um is two arguments"),
        (
            "curve scene.toml --pressure 120HV",
            "\"120HV\" is a hardness, not a pressure on the nominal",
        ),
        (
            "fit scene.toml data.csv --free yield_strength=120HV:200HV",
            "\"120HV\" is a hardness, not a yield strength: give hardness = \"1.269GPa\"",
        ),
        (
            "slip scene.toml --closest 2 --amplitude 1um --friction 0.2 --points 1.5",
            "invalid value '1.5' for '--points <N>': \"1.5\" is not a whole number",
        ),
        (
            "fit scene.toml --free hardness --load 1 --target tangent=1N/pm",
            "\"1N/pm\" is not a number in N/m: write 20N/um, for example (units: N/m, N/mm,",
        ),
        ("curve scene.toml --load 1:20kN:5", "1 has no unit; give every value a unit"),
        ("curve scene.toml --pressure 1MPa:20:5", "20 has no unit; give every value a unit"),
        (
            "export scene.toml --model ke --as csv --load 1:2kN:4",
            "1 has no unit; give every value a unit",
        ),
        ("curve scene.toml --load 1:10", "the number of values is missing"),
        ("curve scene.toml --load 5 --separation 2", "cannot be used with"),
        ("curve scene.toml --pressure 5 --load 2", "cannot be used with"),
        ("curve scene.toml --tolerance 0", "1e-15 to 0.1"),
        ("curve scene.toml --plot -", "name a file for the data"),
        ("curve scene.toml --output q.svg --plot ./q.svg", "--plot and --output name the same"),
        (
            "surface s --scales 1e-6 --output q.svg --plot q.svg",
            "--plot and --output name the same",
        ),
        ("curve scene.toml --format xml", "[possible values: csv, json, table]"),
        ("solve scene.toml --model ke", "--load"),
        ("solve scene.toml --model ke --separation 5", "--load"),
        ("export scene.toml --model ke --as csv --load -5:5:3", "-5 is not above 0"),
        ("solve scene.toml --model ke --load 5 --pressure 5", "cannot be used with"),
        ("compare scene.toml --separation 1 --load 5", "cannot be used with"),
        ("recommend scene.toml --quantity wear", "the quantities are force, area"),
        ("recommend scene.toml --load 5 --pressure 5", "cannot be used with"),
        ("plan scene.toml --load 5 --separation 5", "cannot be used with"),
        ("export scene.toml --model ke --as csv", "--separation"),
        ("export scene.toml --model ke --as csv --separation 0:4", "needs --max-error"),
        ("export scene.toml --model ke --as csv --load 1:4:3:log", "log is not allowed here"),
        ("export scene.toml --model ke --as csv --load 1:4:3 --pressure 1:4:3", "cannot be used"),
        ("export scene.toml --model ke --as nastran --separation 0:4:5", "abaqus"),
        ("export scene.toml --model ke --as csv --separation 4:0:5", "A must be below B"),
    ] {
        let run = bench.run(arguments);
        assert_eq!(
            (run.code, run.out.as_str()),
            (Some(2), ""),
            "asperity {arguments}\n{}",
            run.messages
        );
        assert!(run.messages.starts_with("error: "), "asperity {arguments}\n{}", run.messages);
        assert!(run.messages.contains(printed), "asperity {arguments}\n{}", run.messages);
    }
    let run = bench.run("");
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    assert!(run.messages.contains("Usage: asperity [OPTIONS] <COMMAND>"), "{}", run.messages);
}

#[test]
fn bad_input_ends_with_1_and_names_the_place() {
    let bench = Bench::new();
    let template = asperity_inputs::template();
    let commands = [
        "curve bad.toml",
        "solve bad.toml --model ke --load 1",
        "compare bad.toml",
        "plan bad.toml",
        "recommend bad.toml",
        "export bad.toml --model ke --as csv --separation 0:4:9",
    ];
    for (from, to, printed) in [
        ("nominal_area =", "nominal_aera =", &["bad.toml:", "the nearest is \"nominal_area\""][..]),
        ("poissons_ratio = 0.3", "poissons_ratio = 0.7", &["bad.toml:", "poissons_ratio", "0.7"]),
        ("poissons_ratio = 0.3", "poissons_ratio = \"x\"", &["bad.toml:", "poissons_ratio", "x"]),
        ("asperity_radius = 2e-4", "", &["bad.toml:", "surface", "asperity_radius"]),
        ("nominal_area = 1e-4", "nominal_area = ", &["bad.toml:"]),
    ] {
        bench.write("bad.toml", &template.replacen(from, to, 1));
        for arguments in commands {
            let run = bench.run(arguments);
            assert_eq!((run.code, run.out.as_str()), (Some(1), ""), "asperity {arguments}: {to}");
            assert!(run.messages.starts_with("error: "), "{}", run.messages);
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
    assert!(run.messages.contains("ke: separation is 2000000000"), "{}", run.messages);
}
