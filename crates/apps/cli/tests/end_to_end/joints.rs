//! The end of contact of a joint.

use crate::bench::{Bench, column};

#[test]
fn a_last_contact_that_is_hard_to_find_leaves_the_table_as_it_is() {
    let bench = Bench::new();
    let rail = include_str!("../../../../answer/scene/examples/wheel-rail.toml");
    let heights = "heights = \"exponential\"";
    bench.write("scene.toml", &rail.replace("separation_from = \"surface-mean\"", heights));
    let run = bench.run("joint scene.toml --model jg-cosine --load 20kN --retreat 0nm,100nm");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let forces = column(&run.out, "force_N");
    assert!((forces[0] / 2e4 - 1.0).abs() < 1e-9 && forces[1] < forces[0], "{forces:?}");
    // Where contact ends is printed to 1e-6 where 1e-10 is not reached.
    let (_, end) = run.messages.split_once("a retreat of ").unwrap();
    let end: f64 = end.split(' ').next().unwrap().parse().unwrap();
    let [before, after] = [0.9999, 1.0001].map(|share| {
        let arguments = "joint scene.toml --model jg-cosine --load 20kN --retreat";
        column(&bench.data(&format!("{arguments} {}m", share * end)), "contacts")[0]
    });
    assert!(after < 1.0 && before > 1.0, "{before} {after}");
}
