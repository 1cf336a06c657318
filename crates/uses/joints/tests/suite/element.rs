//! The table as an element of a time integration: consistent tangents, and states that are saved.

use asperity_core::Tolerance;
use asperity_joints::{Joint, JointTable, Reply, UnloadingLaw};
use asperity_ke::KogutEtsion;

use crate::scenes::{SIGMA, with_index};

fn table() -> JointTable {
    let scene = with_index(4.0);
    let joint = Joint::new(&KogutEtsion, &scene, UnloadingLaw::Hertz, Tolerance::default());
    joint.unwrap().table((-0.5 * SIGMA, 4.0 * SIGMA), 1e-6).unwrap()
}

/// The negative slope by a difference that is exact for polynomials up to the eighth degree, as
/// the slopes of the table.
fn slope(force: impl Fn(f64) -> f64, step: f64) -> f64 {
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let pair = |(weight, k): (f64, i32)| {
        let h = f64::from(k) * step;
        weight * (force(-h) - force(h))
    };
    WEIGHTS.into_iter().zip(1..).map(pair).sum::<f64>() / step
}

#[test]
fn stiffnesses_are_the_slopes_of_the_forces_to_1e_8() {
    let table = table();
    let mut worst = [0.0_f64; 2];
    for k in 0..60 {
        let closest = (-0.45 + 0.071 * f64::from(k)) * SIGMA;
        let at = |d: f64, c: f64| table.at(d, c).unwrap();
        // First loading: every step is a new closest approach.
        let stiffness = at(closest, f64::INFINITY).stiffness;
        let found = slope(|h| at(closest + h, f64::INFINITY).force, 0.01 * SIGMA);
        worst[0] = worst[0].max((found / stiffness - 1.0).abs());
        // On the way back, away from the ends of the table's cells.
        for retreat in [0.013, 0.0577, 0.171, 0.333] {
            let d = closest + retreat * SIGMA;
            let found = slope(|h| at(d + h, closest).force, 1e-4 * SIGMA);
            worst[1] = worst[1].max((found - at(d, closest).stiffness).abs() / stiffness);
        }
    }
    assert!(worst[0] < 1e-8 && worst[1] < 1e-8, "{worst:?}");
}

#[test]
fn saved_states_go_on_as_if_they_had_not_been_saved() {
    let (table, way) = (table(), [3.0, 1.5, 1.9, 1.7, 1.1, 1.4, 1.2, 0.8, 2.0]);
    let places = way.map(|d| d * SIGMA);
    let step = |closest: &mut f64, d: &f64| {
        let reply = table.at(*d, *closest).unwrap();
        *closest = reply.closest;
        Some(reply)
    };
    let whole: Vec<Reply> = places.iter().scan(f64::INFINITY, step).collect();
    for (k, saved) in whole.iter().enumerate() {
        let text = serde_json::to_string(saved).unwrap();
        let read: Reply = serde_json::from_str(&text).unwrap();
        assert_eq!(read, *saved);
        let mut again = read.closest;
        for (d, wanted) in places.iter().zip(&whole).skip(k + 1) {
            assert_eq!(step(&mut again, d), Some(*wanted));
        }
    }
}
