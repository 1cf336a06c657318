//! The report's errors are snapshots, and the committed report is complete.

use std::fs;

use asperity::{Model, Quantity};
use insta::Comparator;
use insta::internals::SnapshotContents;
use xtask::figures::report_csv::Row;
use xtask::folder::{figures_folder, root};
use xtask::table::{agree_by, rows};

use super::tables;

/// Whether two errors are the same up to rounding, which dominates small errors and differs between
/// compilers.
fn errors_agree(a: f64, b: f64) -> bool {
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    large <= 1.05 * small || large < 2e-14 || (large < 1e-10 && large <= 5.0 * small)
}

/// Whether texts agree exactly, and errors up to rounding.
#[derive(Clone)]
struct Errors;

impl Comparator for Errors {
    fn matches(&self, reference: &insta::Snapshot, test: &insta::Snapshot) -> bool {
        match (reference.contents(), test.contents()) {
            (SnapshotContents::Text(a), SnapshotContents::Text(b)) => {
                agree_by(&a.to_string(), &b.to_string(), errors_agree)
            }
            _ => false,
        }
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

#[test]
fn errors_agree_with_their_snapshot() {
    let pairs = ["ke", "jg"].map(|id| {
        let model: Model = id.parse().unwrap();
        [Quantity::Force, Quantity::Tangent].map(|quantity| (model.clone(), quantity))
    });
    let pairs = pairs.concat();
    let speed = tables::write(&pairs, None).unwrap();
    let mut settings = insta::Settings::clone_current();
    settings.set_comparator(Box::new(Errors));
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| {
        insta::assert_snapshot!("speed-vs-error", speed);
    });
}

fn committed(name: &str) -> String {
    fs::read_to_string(figures_folder().join(name)).unwrap()
}

#[test]
fn our_committed_errors_are_below_their_tolerances() {
    let csv = committed("speed-vs-error.csv");
    let head = "model,quantity,method,tolerance,median_ns,max_relative_error";
    assert_eq!(csv.lines().nth(1), Some(head));
    let mut rows = 0;
    for line in csv.lines().skip(2) {
        let fields: Vec<&str> = line.split(',').collect();
        if ["compiled", "rule"].contains(&fields[2]) {
            let [tolerance, error] = [fields[3], fields[5]].map(|f| f.parse::<f64>().unwrap());
            assert!(error <= tolerance, "{line}");
            rows += 1;
        }
    }
    // 8 models at 7 tolerances and 4 at 6, 4 quantities each.
    assert!(rows >= 4 * (8 * 7 + 4 * 6), "{rows} rows");
}

#[test]
fn the_readme_has_the_numbers_of_the_committed_report() {
    let rows: Vec<Row> = rows(&committed("speed-vs-error.csv")).unwrap();
    let of = |method: &str| {
        let own = |row: &&Row| {
            [&*row.model, &*row.quantity, &*row.method, &*row.tolerance]
                == ["ke", "force", method, "1e-10"]
        };
        rows.iter().find(own).unwrap()
    };
    let time = |method| -> f64 { of(method).median_ns.parse().unwrap() };
    let error: f64 = of("compiled").max_relative_error.parse().unwrap();
    let ns = time("compiled");
    let wanted = format!(
        "KE's force at a tolerance of 1e-10, medians of one run: a value in an array takes {ns:.0} ns with an error of {error:.0e}; adaptive Gauss-Kronrod 21, split at the kinks, takes {:.0} times as long, scipy's `quad` {:.0} times.\n",
        time("gauss-kronrod") / ns,
        time("scipy") / ns,
    );
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.contains(&wanted), "README.md: {wanted}");
}
