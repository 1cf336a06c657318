//! Scenes with adhesion: tensions, pull-off and messages about models.

use asperity::{ContactModel, JkrBranch, JohnsonKendallRoberts, Quantity, Request, pull_off};

use crate::bench::{Bench, cells, column};

pub const SOFT: &str = "nominal_area = 1e-4
work_of_adhesion = \"50 mJ/m2\"
rigid_counterface = true
[[body]]
youngs_modulus = \"1 MPa\"
poissons_ratio = 0.5
[surface]
asperity_radius = 1e-4
asperity_density = 1e9
asperity_height_std = 1e-6
";

fn soft() -> Bench {
    let bench = Bench::new();
    bench.write("soft.toml", SOFT);
    bench
}

/// A tension has two separations; the stable one is meant.
#[test]
fn tensions_are_answered_by_all_models_at_the_stable_separation() {
    let bench = soft();
    let run = bench.run("curve soft.toml --model all --load=-0.1 --quantity tangent");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["gw", "dmt", "jkr", "jkr-separation"]);
    let (ids, stiffness) = (cells(&run.out, "model"), cells(&run.out, "tangent_N_per_m"));
    for (id, stiffness) in ids.iter().zip(stiffness).filter(|(id, _)| **id != "gw") {
        assert!(stiffness.is_empty() || stiffness.parse::<f64>().unwrap() > 0.0, "{id}");
    }
    let both = bench.data("curve soft.toml --load=-0.1 --model jkr-separation --all --format csv");
    let one = bench.data("curve soft.toml --load=-0.1 --model jkr-separation --format csv");
    let [both, one] = [both, one].map(|text| column(&text, "separation_over_sigma"));
    assert_eq!((both.len(), one), (2, vec![both[0]]));
    let run = bench.run("curve soft.toml --load=-1 --model jkr-separation");
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
}

#[test]
fn the_pull_off_agrees_with_the_library_and_is_blank_without_tension() {
    let bench = soft();
    let run = bench.run("curve --pull-off soft.toml --model dmt,jkr --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["dmt", "jkr-separation"]);
    let model = JohnsonKendallRoberts { branch: JkrBranch::Separation };
    let request = Request::new([Quantity::Force, Quantity::Tangent]);
    let contact = model.compile(&bench.scene("soft.toml").scene, &request).unwrap();
    let found = pull_off(&*contact).unwrap().unwrap();
    let (force, place) = (column(&run.out, "force_N"), column(&run.out, "separation_over_sigma"));
    assert!(force[1].to_bits() == found.force.value().to_bits());
    assert!(place[1].to_bits() == found.separation.value.to_bits());
    assert!(run.messages.contains("[adhesion]"), "{}", run.messages);
    let one = 1.5 * std::f64::consts::PI * 1e-4 * 0.05 * 1e5;
    let (_, left) = run.messages.split_once("jkr-separation: roughness").unwrap();
    let (_, left) = left.split_once(" to ").unwrap();
    let left: f64 = left.split(' ').next().unwrap().parse().unwrap();
    assert!((-left / 100.0 * one / force[1] - 1.0).abs() < 1e-5, "{left} % of {one} N");
    bench.write("joules.toml", &SOFT.replace("50 mJ", "50 J"));
    let joules = bench.run("curve --pull-off joules.toml --model jkr").messages;
    assert!(joules.contains("[unusual-size]"), "{joules}");
    // With stiff exponential heights, the compression of the highest asperities exceeds the
    // adhesion of the others.
    let stiff =
        SOFT.replace("1 MPa", "1 GPa").replace("[surface]", "[surface]\nheights = \"exponential\"");
    bench.write("stiff.toml", &stiff);
    let run = bench.run("curve --pull-off stiff.toml --model dmt --format csv");
    assert!(run.code == Some(0) && cells(&run.out, "force_N") == [""], "{}", run.out);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
    let printed = bench
        .refusals("{}", &["curve --pull-off soft.toml --model gw", "curve --pull-off scene.toml"]);
    insta::assert_snapshot!(printed);
}

#[test]
fn tensions_are_loads_below_0() {
    let bench = soft();
    let run = bench.run("curve soft.toml --model gw,jkr --load -10mN,100mN --quantity area");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let area = cells(&run.out, "area_m2");
    assert!(area[0].is_empty() && area[1..].iter().all(|area| !area.is_empty()), "{area:?}");
    assert_eq!(column(&run.out, "load_N"), [-0.01, 0.1, -0.01, 0.1]);
    assert!(run.messages.contains("[no-tension]"), "{}", run.messages);
    assert!(bench.data("check soft.toml --model jkr --load -10mN").contains("-0.01"));
    let all = bench.data("curve soft.toml --model jkr-separation --load -0.01 --all");
    assert_eq!(all.lines().count(), 3, "{all}");
    let both = bench.run("curve soft.toml --model jkr-separation --load -0.01 --all").messages;
    assert!(both.contains("[adhesion]"), "{both}");
    let largest = bench.run("curve soft.toml --model jkr-separation --load -0.01").messages;
    assert!(!largest.contains("negative"), "{largest}");
    let several = bench.run("curve soft.toml --model gw,persson --load -5").messages;
    assert!(several.contains("[no-tension]"), "{several}");
    let refused = bench.run("curve soft.toml --model gw --load -5").messages;
    assert!(refused.contains("[no-tension]") && !refused.contains("load is"), "{refused}");
    for load in ["-1N", "-1kN"] {
        let beyond = bench.run(&format!("curve soft.toml --model jkr --load {load}")).messages;
        assert!(beyond.contains("[no-value]"), "{beyond}");
    }
    let far = bench.run("curve soft.toml --model jkr --separation 1e300").messages;
    assert!(far.contains("[no-value]"), "{far}");
}

#[test]
fn curves_and_answers_name_the_adhesive_model_to_use() {
    let bench = soft();
    let answer = "curve soft.toml --model all --load 10mN";
    for arguments in ["check soft.toml", "curve soft.toml --model gw --separation 1", answer] {
        let run = bench.run(arguments);
        let all = run.out + &run.messages;
        assert!(all.contains("[adhesion]"), "{arguments}: {all}");
    }
    let quiet = bench.run("curve soft.toml --model jkr --separation 1").messages;
    assert!(!quiet.contains("tabor_parameter"), "{quiet}");
}
