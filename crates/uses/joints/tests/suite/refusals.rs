//! Errors of joints: each names the input and gives no number.

use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    At, ContactError, HeightDistribution, Heights, QuadratureError, TabulatedHeights, Tolerance,
};
use asperity_gw::GreenwoodWilliamson;
use asperity_joints::{Joint, PartialSlip, Unloading, UnloadingLaw};
use asperity_ke::KogutEtsion;

use crate::scenes::{SIGMA, flat, named, tight, with_index};

#[test]
fn tables_that_miss_their_tolerance_are_refused_with_the_error_reached() {
    // A step of the density makes a kink for each jump of the law, which limits polynomials.
    let (mut scene, tolerance) = (flat(1.5), Tolerance::new(1e-6).unwrap());
    let points = [(-2.0, 0.1), (0.0, 0.1), (1e-6, 0.4), (2.0, 0.4)];
    let step = TabulatedHeights::new("step", &points.map(|(z, g)| (z * SIGMA, g / SIGMA))).unwrap();
    scene.heights = HeightDistribution::other(step);
    let joint = Joint::new(&ChangEtsionBogy, &scene, UnloadingLaw::Brake, tolerance).unwrap();
    match joint.table((-1.05 * SIGMA, -1.03 * SIGMA), 1e-10).map(|_| ()).unwrap_err() {
        ContactError::Integral {
            at: At::Separation(place),
            source: QuadratureError::NotConverged { reached, asked, .. },
            ..
        } => {
            assert!((-1.05 * SIGMA..-1.03 * SIGMA).contains(&place.value), "{place}");
            assert!(reached > asked && asked.to_bits() == 1e-10f64.to_bits(), "{reached}");
        }
        other => panic!("{other}"),
    }
    // Multiples of σ_z in place of metres.
    let refused = joint.table((-1.0, 3.0), 1e-6).unwrap_err().to_string();
    assert!(refused.starts_with("open - deepest is 4"), "{refused}");
}

#[test]
fn steps_outside_the_table_are_refused_with_the_number() {
    let tolerance = Tolerance::default();
    let joint = Joint::new(&KogutEtsion, &with_index(2.0), UnloadingLaw::Hertz, tolerance).unwrap();
    let table = joint.table((0.0, 2.0 * SIGMA), 1e-7).unwrap();
    for (separation, closest, field) in [
        (1.0, -0.5, "closest is -5"),
        (1.0, f64::NAN, "closest is NaN"),
        (-0.5, 1.0, "separation is -5"),
        (f64::NAN, 1.0, "separation is NaN"),
        (f64::NAN, f64::INFINITY, "separation is NaN"),
        (-0.5, f64::INFINITY, "separation is -5"),
    ] {
        let refused = table.at(separation * SIGMA, closest * SIGMA).unwrap_err();
        let text = refused.to_string();
        assert!(text.starts_with(field) && text.contains(" m: 0 m or more"), "{text}");
        assert!(matches!(refused, ContactError::BelowTable { .. }), "{text}");
    }
}

#[test]
fn losses_at_invalid_amplitudes_are_refused_by_name() {
    let (scene, at) = (named("mild"), At::from(1.0));
    let joint =
        Unloading::new(&GreenwoodWilliamson, &scene, at, UnloadingLaw::Hertz, tight()).unwrap();
    let slip = PartialSlip::new(&joint, 0.2).unwrap();
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        let refused = slip.loss(bad).unwrap_err().to_string();
        assert!(refused.starts_with("amplitude is"), "{refused}");
    }
    // A small share is reached at the shift of the initial slope.
    let small = slip.shift_at(1e-13).unwrap();
    let slope = slip.force(1e-6 * small).unwrap().value() / (1e-6 * small);
    let wanted = 1e-13 * 0.2 * joint.force(0.0).unwrap().value() / slope;
    assert!((small / wanted - 1.0).abs() < 1e-6, "{small} {wanted}");
    // Close to 1, a share may be unreachable by rounding.
    match slip.shift_at(1.0_f64.next_down()) {
        Ok(shift) => assert!(shift > 0.0 && shift.is_finite()),
        Err(refused) => assert!(refused.to_string().starts_with("share is"), "{refused}"),
    }
}

/// Density ν/2 (1 + |z|/σ)^(-ν-1)/σ: the tail is a power.
#[derive(Debug)]
struct Heavy(f64);

impl Heights for Heavy {
    fn name(&self) -> &str {
        "heavy"
    }

    fn ln_density(&self, z: f64) -> f64 {
        (0.5 * self.0 / SIGMA).ln() - (self.0 + 1.0) * (z.abs() / SIGMA).ln_1p()
    }

    fn support(&self) -> (f64, f64) {
        (f64::NEG_INFINITY, f64::INFINITY)
    }

    fn breaks(&self) -> &[f64] {
        &[0.0]
    }
}

#[test]
fn infinite_work_is_refused() {
    // F falls as d^(1.5-ν), which has a finite integral for ν above 2.5.
    let mut scene = with_index(1.0);
    scene.heights = HeightDistribution::other(Heavy(2.2));
    let tolerance = Tolerance::new(1e-6).unwrap();
    let joint = Joint::new(&GreenwoodWilliamson, &scene, UnloadingLaw::Hertz, tolerance).unwrap();
    let refused = joint.work(At::from(1.0)).unwrap_err().to_string();
    assert!(refused.contains("beyond 1e8"), "{refused}");
}
