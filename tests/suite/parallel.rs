//! Long lists of separations are computed on all cores, with the same digits in the same order.

use asperity::{At, HeightDistribution, Quantity, Request, Tolerance, linspace};

use crate::scenes::{model, named};

/// Above 2048, the least number of rows computed in parallel.
const MANY: usize = 5000;

/// Not sorted, so that an order by value or by thread fails the test.
fn separations() -> Vec<f64> {
    let sorted = linspace(-4.0, 45.0, MANY);
    // 1777 and 5000 have no common divisor, so every index occurs once.
    (0..MANY).map(|k| sorted[k * 1777 % MANY]).collect()
}

#[test]
fn many_separations_have_the_digits_of_single_ones_in_their_order() {
    let asked = [Quantity::Area, Quantity::Force, Quantity::Tangent];
    for (id, heights) in [
        ("ke", HeightDistribution::Gaussian),
        ("at", HeightDistribution::Gaussian),
        ("jg", HeightDistribution::Exponential),
    ] {
        let mut scene = named("severe");
        scene.heights = heights;
        let request = Request::new(asked).at(separations());
        let compiled = model(id).compile(&scene, &request).unwrap();
        let answer = compiled.respond(&request);
        assert!(answer.at == request.at);
        assert!(answer.columns.iter().map(|c| c.quantity).eq(asked));
        // A second, independent compilation, built in another order by one thread.
        let alone = model(id).compile(&scene, &request).unwrap();
        for column in &answer.columns {
            assert!(column.rows.len() == MANY);
            for (row, at) in column.rows.iter().zip(&request.at).rev() {
                let one = alone.evaluate(column.quantity, *at).unwrap();
                let many = row.as_ref().unwrap();
                // Sums of many are summed in another order: some units in the last place.
                let error = (one.scaled - many.scaled).abs() / one.size;
                let same = error < 1e-15
                    && one.ln_scale.to_bits() == many.ln_scale.to_bits()
                    && (one.error - many.error).abs() < 1e-15;
                assert!(same, "{id} {} at {at}: {one:?} {many:?}", column.quantity);
            }
        }
    }
}

#[test]
fn one_bad_separation_has_an_error_and_the_others_have_values() {
    let mut separations = separations();
    separations[MANY - 2] = f64::NAN;
    let request = Request::new([Quantity::Force]).at(separations);
    let answer = model("gw").solve(&named("mild"), &request).unwrap();
    let message = answer.values(Quantity::Force).unwrap_err().to_string();
    assert!(message.starts_with("separation is NaN"), "{message}");
    let rows = &answer.column(Quantity::Force).unwrap().rows;
    assert!(rows[MANY - 2].is_err() && rows.iter().filter(|row| row.is_ok()).count() == MANY - 1);
}

#[test]
fn threads_may_share_a_compiled_scene_while_it_is_built() {
    let scene = named("at-paper");
    let request = Request::new([Quantity::Force]);
    let compiled = model("zmc").compile(&scene, &request).unwrap();
    let sweep = linspace(-3.0, 20.0, 300);
    let digits = || -> Vec<u64> {
        let value = |s: &f64| compiled.evaluate(Quantity::Force, *s).unwrap().value().to_bits();
        sweep.iter().map(value).collect()
    };
    let all = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(digits)).collect();
        threads.into_iter().map(|t| t.join().unwrap()).collect::<Vec<_>>()
    });
    assert!(all.iter().all(|other| *other == all[0]));
    // The force falls, so different separations have different digits.
    let values: Vec<f64> = all[0].iter().map(|bits| f64::from_bits(*bits)).collect();
    assert!(values.windows(2).all(|pair| pair[0] > pair[1] && pair[1] > 0.0));
}

#[test]
fn separations_in_metres_are_the_same_with_a_wider_bound() {
    let scene = named("mild");
    let std = scene.surface.asperity_height_std;
    let ke = model("ke");
    let tolerance = Tolerance::new(1e-13).unwrap();
    let exact = Request::new([Quantity::Force]).at([30.0]).within(tolerance);
    let metres = Request::new([Quantity::Force]).at([At::metres(30.0 * std)]).within(tolerance);
    let [exact, metres] = [exact, metres].map(|request| {
        let answer = ke.solve(&scene, &request).unwrap();
        let column = answer.column(Quantity::Force).unwrap();
        (column.values().unwrap()[0], column.rows[0].as_ref().unwrap().bound(column.quantity))
    });
    // Rounding of d/σ_z changes the force by s² ε: 2e-13 at s = 30, which the bound includes.
    assert!((metres.0 / exact.0 - 1.0).abs() <= metres.1 + exact.1);
    let added = metres.1 - exact.1;
    assert!(added > 900.0 * f64::EPSILON && added < 1000.0 * f64::EPSILON, "{added:e}");
}
