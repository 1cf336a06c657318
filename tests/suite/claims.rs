//! What the AT paper says of its figures, held against the readings of its equations.

use asperity::{
    AminiTehrani, AngleDensity, AtReading, ContactModel, KogutEtsion, LateralOptions, Quantity,
    Request, Tolerance, linspace,
};
use xtask::figures::models::scene;

const CHAPTER: &str = include_str!("../../crates/apps/web/guide/models.md");
const QUANTITIES: [Quantity; 3] = [Quantity::Force, Quantity::Area, Quantity::Stiffness];

/// Force, area and stiffness at d = 0 to 4 σ_z on the surface of figures 5, 7 and 9.
fn values(model: &dyn ContactModel) -> [Vec<f64>; 3] {
    let request = Request::new(QUANTITIES).within(Tolerance::new(1e-4).unwrap());
    let answer = model.solve(&scene(1e-6).unwrap(), &request.at(linspace(0.0, 4.0, 5))).unwrap();
    QUANTITIES.map(|quantity| answer.values(quantity).unwrap())
}

/// The chapter's row of a reading and an angle density: ratios to KE, and which claims hold.
fn row(reading: AtReading, angle_density: AngleDensity, ke: &[Vec<f64>; 3]) -> String {
    let options = LateralOptions { angle_density, ..LateralOptions::default() };
    let at = values(&AminiTehrani { reading, options });
    let over = [0, 1, 2]
        .map(|k| -> Vec<f64> { at[k].iter().zip(&ke[k]).map(|(at, ke)| at / ke).collect() });
    let shown = over
        .clone()
        .map(|over| over.iter().map(|ratio| format!("{ratio:.2}")).collect::<Vec<_>>().join(" "));
    let [force, area, stiffness] = &over;
    let apart = |ratio: &f64| (1.0 - ratio).abs();
    let absolute = |k: usize| (at[1][k] - ke[1][k]).abs();
    // All surfaces of figures 4, 6 and 8 have one plasticity index, and curves over d/σ_z of one
    // shape: over d they rise faster on smoother ones where they rise at all.
    let rises = at.iter().all(|of| of.windows(2).all(|pair| pair[0] > pair[1] && pair[1] > 0.0));
    let holds = [
        force.iter().all(|ratio| (0.9 - 5e-3..1.0).contains(ratio)),
        area.iter().all(|ratio| *ratio < 1.0),
        absolute(4) < absolute(0),
        apart(&area[4]) < apart(&area[0]),
        stiffness.iter().all(|ratio| apart(ratio) < 0.25),
        rises,
    ];
    assert!(holds.contains(&false), "one reading satisfies all claims: the chapter says none");
    let holds = holds.map(|holds| if holds { "yes" } else { "no" }).join(" | ");
    format!("| {} | {holds} |", shown.join(" | "))
}

#[test]
fn the_guide_holds_the_claims_of_the_paper_against_every_reading() {
    let uniform = AngleDensity::Harmonic { a20: 0.0, a21: 0.0, b21: 0.0 };
    let densities = [
        ("harmonic", AngleDensity::default()),
        ("uniform", uniform),
        ("upright", AngleDensity::Upright),
    ];
    let ke = values(&KogutEtsion);
    let mut table = String::new();
    for (name, reading) in [
        ("printed", AtReading::Printed),
        ("additive", AtReading::Additive),
        ("overlap", AtReading::Overlap),
    ] {
        for (density, angle_density) in densities {
            table += &format!("| {name}, {density} {}\n", row(reading, angle_density, &ke));
        }
    }
    assert!(CHAPTER.contains(&table), "the chapter's table is another:\n{table}");
}

#[test]
fn the_guide_lists_the_solved_surfaces() {
    let evidence = asperity::Evidence::committed().unwrap();
    let plain = evidence.cases().iter().filter(|c| c.skewness == 0.0 && c.slope_ratio <= 1.0);
    let mut alpha: Vec<f64> = plain.map(|case| case.alpha).collect();
    alpha.sort_by(f64::total_cmp);
    alpha.dedup();
    let guide = include_str!("../../crates/apps/web/guide/which-model.md");
    let alpha: Vec<String> = alpha.iter().map(|alpha| format!("{alpha:.1}")).collect();
    let listed = format!(" of the heights | {} |", alpha.join(", "));
    assert!(guide.contains(&listed), "{listed}");
}
