//! Histories, works and tables of joints, against sums over steps, finite elements and unloading.
#![allow(clippy::float_cmp, reason = "a contact stores its closest approach unchanged")]

use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    At, ContactModel, HeightDistribution, Heights, Quantity, TabulatedHeights, Tolerance,
};
use asperity_etsion::EtsionKligermanKadin;
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_joints::{Joint, UnloadingLaw, restitution};
use asperity_ke::KogutEtsion;

use crate::is_long;
use crate::scenes::{SIGMA, flat, tight, with_index};

fn joint(model: &dyn ContactModel, law: UnloadingLaw) -> Joint {
    Joint::new(model, &with_index(2.0), law, tight()).unwrap()
}

#[test]
fn histories_follow_the_virgin_curve_and_retrace_unloading() {
    for law in UnloadingLaw::ALL {
        let joint = joint(&KogutEtsion, law);
        let turns = [4.0, 1.0, 2.0, 0.5, 3.0, 0.0].map(|s| s * SIGMA);
        let path = joint.path(&turns, 10).unwrap();
        // Two legs reach the virgin curve again, at 1 and at 0.5, once between steps.
        let met = path.points.windows(2).filter(|p| p[1].separation == p[1].closest);
        assert!(met.count() > 10 && path.points.len() >= 52, "{}", path.points.len());
        let virgin = |d: f64| {
            let found = joint.virgin().evaluate(Quantity::Force, At::metres(d));
            found.unwrap().value()
        };
        let mut closest = f64::INFINITY;
        for point in &path.points {
            let d = point.separation;
            closest = d.min(closest);
            assert_eq!(point.closest, closest);
            let way = joint.unloading(At::metres(closest)).unwrap();
            let wanted =
                if d > closest { way.force(d - closest).unwrap().value() } else { virgin(d) };
            assert!((point.force / wanted - 1.0).abs() < 1e-10, "{law} {d}");
            assert!(point.force <= virgin(d) * (1.0 + 1e-10), "{law} {d}");
        }
        // Reloading passes the points of unloading in reverse order.
        let twice = joint.path(&[4.0, 0.5, 2.0, 0.5, 2.0].map(|s| s * SIGMA), 8).unwrap();
        for k in 0..=8 {
            let [a, b, c] = [16 - k, 16 + k, 32 - k].map(|k| twice.points[k]);
            // The turning point belongs to the virgin curve on one of the legs.
            let stiff = k == 8 || (a.stiffness / b.stiffness - 1.0).abs() < 1e-9;
            assert!((a.force / b.force - 1.0).abs() < 1e-9 && stiff, "{law} {k}");
            assert!((b.force / c.force - 1.0).abs() < 1e-9);
        }
        assert!((twice.work[1] / twice.work[2] + 1.0).abs() < 1e-10, "{:?}", twice.work);
    }
}

#[test]
fn the_work_of_each_leg_is_the_area_under_its_points() {
    let models: [&dyn ContactModel; 2] = [&KogutEtsion, &ChangEtsionBogy];
    for (law, model) in UnloadingLaw::ALL.into_iter().flat_map(|law| models.map(|m| (law, m))) {
        let joint = joint(model, law);
        let turns = [3.0, 0.7, 1.6, 0.2, 6.0].map(|s| s * SIGMA);
        let path = joint.path(&turns, 400).unwrap();
        let mut sums = vec![0.0; path.work.len()];
        // Trapezia with the slopes at both ends: of fourth order.
        let (mut leg, mut done) = (0, 0);
        for pair in path.points.windows(2) {
            let width = pair[0].separation - pair[1].separation;
            let slopes = (pair[1].stiffness - pair[0].stiffness) * width / 12.0;
            sums[leg] += width * (0.5 * (pair[0].force + pair[1].force) - slopes);
            done += 1;
            if pair[1].separation == turns[leg + 1] && done >= 400 {
                (leg, done) = (leg + 1, 0);
            }
        }
        for (found, sum) in path.work.iter().zip(&sums) {
            // Slopes at the turning points belong to the leg before: one trapezium of 400.
            assert!((found / sum - 1.0).abs() < 1e-4, "{law}: {:?} {sums:?}", path.work);
        }
        // The work of the history is the loss at the closest approach, corrected for the work
        // before its start and the work left at its end.
        let lost = joint.work(At::metres(0.2 * SIGMA)).unwrap().lost().value();
        let before = joint.work(At::metres(turns[0])).unwrap().spent.value();
        let way = joint.unloading(At::metres(0.2 * SIGMA)).unwrap();
        let rest = way.returned(f64::INFINITY).unwrap().value()
            - way.returned(5.8 * SIGMA).unwrap().value();
        let total: f64 = path.work.iter().sum();
        assert!(((total + before - rest) / lost - 1.0).abs() < 1e-9, "{law}: {total} {lost}");
        // CEB's force jumps up by half at w_c, so that Brake's law returns more than was spent.
        assert_eq!(lost > 0.0, model.id() == "ke" || law != UnloadingLaw::Brake, "{law}: {lost}");
    }
}

#[test]
fn elastic_joints_dissipate_nothing_and_equal_closed_forms() {
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential] {
        let mut scene = with_index(0.5);
        scene.heights = heights.clone();
        let joint = Joint::new(&GreenwoodWilliamson, &scene, UnloadingLaw::Hertz, tight()).unwrap();
        let at = At::from(0.5);
        let work = joint.work(at).unwrap();
        let lost = work.lost();
        assert!(lost.value() == 0.0 && lost.error < 3e-10 && work.loss_factor().unwrap() == 0.0);
        let spent = work.spent.value();
        let returned = joint.unloading(at).unwrap().returned(f64::INFINITY).unwrap();
        let known = work.spent.relative_error() + returned.relative_error();
        assert!((returned.value() / spent - 1.0).abs() < known && known < 1e-10);
        // The loss factor of a work that underflows is refused.
        let nothing = joint.work(At::sigmas(800.0)).unwrap();
        assert!(nothing.loss_factor().is_err());
        if matches!(heights, HeightDistribution::Exponential) {
            // ∫ F dd = σ F.
            let force = joint.virgin().evaluate(Quantity::Force, at).unwrap().value();
            assert!((spent / (SIGMA * force) - 1.0).abs() < 1e-11);
        }
    }
}

#[test]
fn restitution_of_one_asperity_equals_finite_elements() {
    let asperity = with_index(2.0).asperity().unwrap();
    let critical = asperity.critical_interference().unwrap();
    let of =
        |x: f64, law| restitution(&KogutEtsion, &asperity, x * critical, law, tight()).unwrap();
    // By mpmath from KE's powers; finite elements give 0.697.
    let found = of(20.0, UnloadingLaw::Etsion);
    assert!((found / 0.697_378_230_482_933 - 1.0).abs() < 1e-11, "{found}");
    for law in UnloadingLaw::ALL {
        assert!((of(0.7, law) - 1.0).abs() < 1e-10, "{law}");
        assert!(of(5.0, law) < 1.0 && of(50.0, law) < of(5.0, law), "{law}");
    }
    // JG is elastic up to 1.9 w_c and retraces loading, except with Etsion's fit, which starts at
    // w_c.
    for law in [UnloadingLaw::Hertz, UnloadingLaw::Brake] {
        let of = |x: f64| {
            restitution(&JacksonGreen::default(), &asperity, x * critical, law, tight()).unwrap()
        };
        assert!((of(1.5) - 1.0).abs() < 1e-10 && of(2.5) < 1.0, "{law}: {} {}", of(1.5), of(2.5));
    }
    let small = restitution(&KogutEtsion, &asperity, 1e-300, UnloadingLaw::Hertz, tight());
    let small = small.unwrap_err().to_string();
    assert!(small.contains("interference is 1e-300") && small.contains("2.2e-308 J"), "{small}");
    let refused = restitution(&EtsionKligermanKadin, &asperity, -1.0, UnloadingLaw::Hertz, tight());
    assert!(refused.unwrap_err().to_string().starts_with("interference is -1"));
}

#[test]
fn tables_return_0_beyond_the_highest_asperity() {
    // Heights end 2 σ_z above their mean.
    let scene = flat(2.0);
    let tolerance = Tolerance::new(1e-8).unwrap();
    let joint = Joint::new(&KogutEtsion, &scene, UnloadingLaw::Hertz, tolerance).unwrap();
    let table = joint.table((2.5 * SIGMA, 4.0 * SIGMA), 1e-4).unwrap();
    assert_eq!(table.at(3.5 * SIGMA, 3.0 * SIGMA).unwrap().force, 0.0);
    assert!(table.at(2.4 * SIGMA, 3.0 * SIGMA).is_err(), "below the deepest");
}

#[test]
fn tables_open_past_the_last_asperity() {
    let triangle = [(-1.0, 0.0), (0.0, 1.0), (1.0, 0.0)].map(|(z, g)| (z * SIGMA, g / SIGMA));
    let steep = [(-1.0, 0.0), (-0.998, 0.5), (0.998, 0.5), (1.0, 0.0)];
    let steep = steep.map(|(z, g)| (z * SIGMA, g / SIGMA));
    for (points, index, law) in [
        (&triangle[..], 2.0, UnloadingLaw::Hertz),
        (&steep, 2.0, UnloadingLaw::Etsion),
        (&steep, 8.0, UnloadingLaw::Brake),
    ] {
        let mut scene = with_index(index);
        let heights = TabulatedHeights::new("with an end", points).unwrap();
        let end = heights.support().1;
        scene.heights = HeightDistribution::other(heights);
        let joint = Joint::new(&KogutEtsion, &scene, law, Tolerance::default()).unwrap();
        let table = joint.table((-0.5 * SIGMA, 1.2 * SIGMA), 1e-4).unwrap();
        for beyond in [0.0, 1e-13, 0.1, 5.0] {
            let reply = table.at(end + beyond * SIGMA, f64::INFINITY).unwrap();
            assert!(reply.force == 0.0 && reply.stiffness == 0.0, "{law} {beyond}");
        }
        for closest in [-0.45, 0.2, 0.5, 0.9, 0.97] {
            let closest = closest * SIGMA;
            let way = joint.unloading(At::metres(closest)).unwrap();
            let whole = way.force(0.0).unwrap().value();
            for share in [0.0, 0.01, 0.1, 0.3, 0.6, 0.9] {
                let retreat = share * (end - closest);
                let force = table.at(closest + retreat, closest).unwrap().force;
                let wanted = way.force(retreat).unwrap().value();
                let off = (force - wanted).abs() / whole;
                assert!(force >= 0.0 && off < 1e-4, "{law} {index} {closest} {share}: {off:e}");
            }
        }
    }
}

#[test]
fn forces_of_a_table_are_at_least_0() {
    for (model, index) in [(&KogutEtsion as &dyn ContactModel, 2.0), (&ChangEtsionBogy, 1.5)] {
        let scene = with_index(index);
        let joint = Joint::new(model, &scene, UnloadingLaw::Hertz, Tolerance::default()).unwrap();
        let table = joint.table((-1.5 * SIGMA, 5.0 * SIGMA), 1e-5).unwrap();
        let mut zeros = 0;
        for k in 0..50_000 {
            let [a, b] = [0.618_033_988, 0.754_877_666].map(|g| (f64::from(k) * g).fract());
            let (closest, retreat) = ((-1.5 + 6.5 * a) * SIGMA, 8.0 * b * SIGMA);
            let reply = table.at(closest + retreat, closest).unwrap();
            assert!(reply.force >= 0.0, "{closest:e} {retreat:e}: {}", reply.force);
            zeros += i32::from(reply.force == 0.0);
        }
        assert!(zeros > 250);
    }
}

#[test]
fn tables_equal_unloading_within_their_tolerance() {
    let jg = JacksonGreen::default();
    // Jumps of CEB and JG are kinks of the table, which hide between its nodes.
    let cases: [(&dyn ContactModel, f64, UnloadingLaw, u32); 6] = [
        (&KogutEtsion, 2.0, UnloadingLaw::Hertz, 150),
        (&KogutEtsion, 8.0, UnloadingLaw::Etsion, 150),
        (&ChangEtsionBogy, 1.5, UnloadingLaw::Brake, 400),
        (&ChangEtsionBogy, 4.0, UnloadingLaw::Brake, 400),
        (&jg, 2.0, UnloadingLaw::Hertz, 400),
        (&GreenwoodWilliamson, 1.0, UnloadingLaw::Hertz, 150),
    ];
    for (model, index, law, count) in cases.into_iter().step_by(if is_long() { 1 } else { 3 }) {
        let count = if is_long() { count } else { count / 8 };
        let joint = Joint::new(model, &with_index(index), law, Tolerance::default()).unwrap();
        let tolerance = 1e-6;
        let table = joint.table((-1.5 * SIGMA, 5.0 * SIGMA), tolerance).unwrap();
        let (mut force_worst, mut slope_worst) = (0.0_f64, 0.0_f64);
        for k in 0..count {
            // Spread evenly over both, never on a node.
            let [a, b] = [0.618_033_988, 0.754_877_666].map(|g| (f64::from(k) * g).fract());
            let (closest, retreat) = ((-1.5 + 6.5 * a) * SIGMA, 2.5 * b * b * SIGMA);
            let way = joint.unloading(At::metres(closest)).unwrap();
            let reply = table.at(closest + retreat, closest).unwrap();
            let [force, stiffness] =
                [way.force(retreat), way.stiffness(retreat)].map(|x| x.unwrap());
            let [all, stiff] = [way.force(0.0), way.stiffness(0.0)].map(|x| x.unwrap().value());
            force_worst = force_worst.max((reply.force - force.value()).abs() / all);
            slope_worst = slope_worst.max((reply.stiffness - stiffness.value()).abs() / stiff);
            assert_eq!(reply.closest, closest);
        }
        assert!(force_worst < tolerance, "{} {law}: {force_worst:e}", model.name());
        // Differentiation of the polynomials loses some digits.
        assert!(slope_worst < 1e-3, "{} {law}: {slope_worst:e}", model.name());
    }
}

#[test]
fn contacts_step_and_invalid_separations_are_refused() {
    let joint = joint(&KogutEtsion, UnloadingLaw::Hertz);
    let table = joint.table((-SIGMA, 4.0 * SIGMA), 1e-6).unwrap();
    let mut so_far = f64::INFINITY;
    let virgin = |s: f64| {
        let found = joint.virgin().force_and_tangent(At::metres(s * SIGMA)).unwrap();
        (found.0.value(), found.1.value())
    };
    for (s, closest) in [(9.0, 9.0), (2.0, 2.0), (1.0, 1.0), (1.5, 1.0), (0.9, 0.9), (6.0, 0.9)] {
        let reply = table.at(s * SIGMA, so_far).unwrap();
        so_far = reply.closest;
        assert_eq!(so_far, closest * SIGMA);
        let (force, tangent) = virgin(s);
        if s == closest {
            // The separation is rounded twice.
            assert!((reply.force / force - 1.0).abs() < 1e-13, "{s}");
            assert!((reply.stiffness / tangent - 1.0).abs() < 1e-13, "{s}");
        } else {
            assert!(reply.force < force, "{s}");
        }
    }
    for bad in [-1.1 * SIGMA, f64::NAN] {
        let refused = table.at(bad, so_far).unwrap_err().to_string();
        assert!(refused.starts_with("separation is"), "{bad}");
    }
    assert!(joint.table((SIGMA, SIGMA), 1e-6).unwrap_err().to_string().starts_with("open"));
    assert!(joint.table((0.0, SIGMA), 0.0).unwrap_err().to_string().starts_with("tolerance"));
    let refused = joint.path(&[SIGMA, f64::NAN], 3).unwrap_err().to_string();
    assert!(refused.starts_with("turning_points is NaN"), "{refused}");
}

#[test]
fn loads_become_turning_points_on_the_present_curve() {
    let joint = joint(&KogutEtsion, UnloadingLaw::Hertz);
    let turns = [At::Load(1.0), At::Load(10.0), At::Pressure(2.0 / 3e-5), At::Load(12.0)];
    let points = joint.turning_points(&turns).unwrap();
    let path = joint.path(&points, 4).unwrap();
    for (way, wanted) in [(0, 1.0), (1, 10.0), (2, 2.0), (3, 12.0)] {
        let last = path.points.iter().rfind(|point| point.way == way).unwrap();
        assert!((last.force / wanted - 1.0).abs() < 1e-9, "{way}: {}", last.force);
    }
    // In unloading, the surfaces are closer than at the same load on the virgin curve.
    let virgin = joint.virgin().separation(At::Load(2.0)).unwrap().value * SIGMA;
    assert!(points[2] < virgin && points[2] > points[1]);
    let refused = joint.turning_points(&[At::Load(10.0), At::Load(-1.0)]).unwrap_err().to_string();
    assert!(refused.starts_with("load is -1"), "{refused}");
}

#[test]
fn contact_ends_where_one_asperity_is_left() {
    for law in UnloadingLaw::ALL {
        let joint = joint(&GreenwoodWilliamson, law);
        let way = joint.unloading(At::from(1.0)).unwrap();
        // Elastic asperities keep their number of contacts from loading.
        let request = asperity_core::Request::new([Quantity::Contacts]);
        let virgin = GreenwoodWilliamson.compile(joint.scene(), &request).unwrap();
        let wanted = virgin.evaluate(Quantity::Contacts, 1.7).unwrap().value();
        let found = way.contacts(0.7 * SIGMA).unwrap().value();
        assert!((found / wanted - 1.0).abs() < 1e-9, "{law}: {found} {wanted}");
        let end = way.last_contact().unwrap();
        assert!((way.contacts(end).unwrap().value() - 1.0).abs() < 1e-9, "{law}");
    }
    let far = joint(&KogutEtsion, UnloadingLaw::Hertz).unloading(At::from(7.0)).unwrap();
    assert_eq!(far.last_contact().unwrap(), 0.0);
}
