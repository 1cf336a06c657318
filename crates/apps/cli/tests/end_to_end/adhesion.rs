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
    // With stiff exponential heights, the compression of the highest asperities exceeds the
    // adhesion of the others.
    let stiff =
        SOFT.replace("1 MPa", "1 GPa").replace("[surface]", "[surface]\nheights = \"exponential\"");
    bench.write("stiff.toml", &stiff);
    let run = bench.run("curve --pull-off stiff.toml --model dmt --format csv");
    assert!(run.code == Some(0) && cells(&run.out, "force_N") == [""], "{}", run.out);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
}
