//! Lists of contacts: warm starts, order, failures, stopping; and mean gaps.

use std::ops::ControlFlow;

use asperity_bem::{BemError, Boundary, BoundaryElements, LoadCase};

use crate::{MODULUS, UNIT, close, rough};

const GO_ON: ControlFlow<()> = ControlFlow::Continue(());

#[test]
fn a_list_answers_in_its_own_order_and_keeps_what_can_be_solved() {
    let solver = BoundaryElements::new(rough(64, 8), MODULUS).unwrap().hardness(UNIT).unwrap();
    let area = rough(64, 8).area();
    let given = [
        LoadCase::MeanPressure(0.01 * UNIT),
        LoadCase::MeanPressure(f64::NAN),
        LoadCase::Load(0.1 * UNIT * area),
        LoadCase::MeanPressure(2.0 * UNIT),
        LoadCase::MeanGap(4e-7),
        LoadCase::MeanPressure(0.03 * UNIT),
        LoadCase::MeanGap(1.0),
    ];
    let mut reported = Vec::new();
    let list = solver.solve_all(&given, |progress| {
        reported.push((progress.index, progress.done));
        GO_ON
    });
    for (given, solution) in given.iter().zip(&list) {
        match (given, solution) {
            (LoadCase::MeanPressure(p), Err(error)) if p.is_nan() => {
                assert!(matches!(error, BemError::OutOfRange { field: "mean pressure", .. }));
            }
            (LoadCase::MeanPressure(_), Err(error)) => {
                assert!(matches!(error, BemError::CannotBeCarried { .. }));
            }
            (LoadCase::MeanGap(_), Err(error)) => {
                assert!(matches!(error, BemError::NothingTouches { .. }));
            }
            (given, solution) => {
                let warm = solution.as_ref().unwrap();
                assert_eq!(warm.given, *given);
                let cold = solver.solve(*given).unwrap();
                assert_eq!(warm.patches, cold.patches);
                close(warm.mean_gap, cold.mean_gap, 3e-7);
            }
        }
    }
    // From the greatest load down, gaps last.
    reported.dedup_by_key(|(index, _)| *index);
    assert_eq!(reported.iter().map(|(index, _)| *index).collect::<Vec<_>>(), [2, 5, 0, 4]);
    assert!(reported.is_sorted_by_key(|(_, done)| *done));
}

#[test]
fn a_warm_list_takes_fewer_iterations() {
    let solver = BoundaryElements::new(rough(128, 9), MODULUS).unwrap();
    let given: Vec<_> =
        (0..8).map(|k| LoadCase::MeanPressure(0.1 * UNIT * 0.8_f64.powi(k))).collect();
    let warm = solver.solve_all(&given, |_| GO_ON);
    let warm: usize = warm.into_iter().map(|solution| solution.unwrap().iterations).sum();
    let cold: usize = given.iter().map(|&given| solver.solve(given).unwrap().iterations).sum();
    assert!(10 * warm < 9 * cold, "{warm} {cold}");
}

#[test]
fn a_stopped_list_keeps_what_is_done() {
    let solver = BoundaryElements::new(rough(64, 10), MODULUS).unwrap();
    let given = [0.01, 0.03, 0.1].map(|share| LoadCase::MeanPressure(share * UNIT));
    let list = solver.solve_all(&given, |progress| {
        if progress.index == 1 && progress.iterations == 5 { ControlFlow::Break(()) } else { GO_ON }
    });
    assert!(list[2].is_ok());
    assert_eq!(list[1], Err(BemError::Cancelled));
    assert_eq!(list[0], Err(BemError::Cancelled));
}

#[test]
fn answers_come_as_they_are_done() {
    let solver = BoundaryElements::new(rough(32, 11), MODULUS).unwrap();
    let given = [0.01, 0.1, 0.03].map(|share| LoadCase::MeanPressure(share * UNIT));
    let mut order = Vec::new();
    solver.solve_each(&given, |_| GO_ON, |index, solution| order.push((index, solution.is_ok())));
    assert_eq!(order, [(1, true), (2, true), (0, true)]);
}

#[test]
fn mean_gaps_are_met() {
    let map = rough(64, 12);
    let (sq, highest) = (map.rms_height(), map.highest());
    let elastic = BoundaryElements::new(map, MODULUS).unwrap();
    let ways = [
        elastic.clone(),
        elastic.clone().hardness(0.2 * UNIT).unwrap(),
        elastic.clone().boundary(Boundary::Free),
    ];
    for solver in ways {
        for gap in [0.999 * highest, 2.0 * sq, 0.5 * sq, 0.01 * sq] {
            let solution = solver.solve(LoadCase::MeanGap(gap)).unwrap();
            assert!((solution.mean_gap - gap).abs() <= 1e-7 * sq);
            // The load that was found has this gap.
            let again = solver.solve(LoadCase::MeanPressure(solution.mean_pressure)).unwrap();
            assert!((again.mean_gap - gap).abs() <= 3e-7 * sq);
        }
    }
}
