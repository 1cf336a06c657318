//! What figures and studies share of the comparison with boundary elements.

use asperity::{Asperities, Described, Evidence, EvidenceCase, Model, Persson, PerssonVariance};

/// The cell of a column without deviations.
pub const NOTHING: &str = "–";

/// Models of asperities in the table: each of the paper's once, and four with random asperities.
const COMPARED: &str = "gw ceb zmc ke etsion jg af gao at gw-random zmc-random ke-random jg-random";

/// The models that are compared with boundary elements. Persson's spectrum is a power law, as that
/// of the solved surfaces beyond their roll-off.
#[must_use]
pub fn models() -> Vec<Model> {
    let hurst_exponent = Some(Evidence::HURST);
    let whole = PerssonVariance::ALL
        .map(|variance| Model::known(Persson { variance, hurst_exponent, spectrum: None }));
    let compared = |model: &Model| COMPARED.split(' ').any(|id| id == model.id());
    let of_asperities = Model::of_asperities().into_iter().chain(Model::all_on(Asperities::Random));
    of_asperities.filter(compared).chain(whole).collect()
}

/// Numbers of the table are equal digit by digit.
#[must_use]
pub fn equal(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

/// Whether the surfaces of a case are isotropic and Gaussian.
#[must_use]
pub fn is_plain(case: &EvidenceCase) -> bool {
    case.skewness == 0.0 && case.slope_ratio <= 1.0
}

/// The name of a plasticity index.
#[must_use]
pub fn material(index: f64) -> String {
    if index > 0.0 { format!("ψ = {index}") } else { "elastic".into() }
}
