//! A scene, data made from it, and its free parameters.

use asperity_core::{
    ContactError, ContactModel, Datum, Interface, Quantity, Request, Scene, Surface,
};
use asperity_fit::{Data, DataColumn, Parameter};
use statrs::distribution::{ContinuousCDF, Normal};

/// Whether long cases run as well: `.ci/full` sets `ASPERITY_LONG`.
pub fn is_long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}

/// Radius, density, standard deviation of the heights, hardness.
pub const TRUTH: [f64; 4] = [2e-4, 2e8, 1e-6, 2e9];
pub const NAMES: [&str; 4] =
    ["asperity_radius", "asperity_density", "asperity_height_std", "hardness"];

pub const LOADS: [f64; 5] = [1.0, 10.0, 100.0, 300.0, 1000.0];

pub fn scene([radius, density, height_std, hardness]: [f64; 4]) -> Scene {
    let mut interface = Interface::new(115e9, 0.3, hardness);
    interface.thermal_conductivity = Some(50.0);
    Scene::new(interface, Surface::new(radius, density, height_std), 1e-4)
}

/// The scene with other values of some of its four numbers.
pub fn varied(free: &[usize]) -> impl Fn(&[f64]) -> Result<Scene, ContactError> {
    move |values| {
        let mut numbers = TRUTH;
        free.iter().zip(values).for_each(|(place, value)| numbers[*place] = *value);
        Ok(scene(numbers))
    }
}

/// The parameters, from a start that is `off` times the truth, within a factor 30 of the start.
pub fn parameters(free: &[usize], off: f64) -> Vec<Parameter> {
    let one = |place: &usize| {
        let start = off * TRUTH[*place];
        Parameter::new(NAMES[*place], "", start, [start / 30.0, start * 30.0], 1.0).unwrap()
    };
    free.iter().map(one).collect()
}

/// The columns of quantities at loads.
pub fn columns(
    model: &dyn ContactModel,
    loads: &[f64],
    quantities: &[Quantity],
) -> Vec<DataColumn> {
    let request = Request::new(quantities.iter().copied()).at_loads(loads.iter().copied());
    let answer = model.solve(&scene(TRUTH), &request).unwrap();
    let some = |values: &[f64]| values.iter().copied().map(Some).collect();
    let mut found = vec![("load_N".to_string(), some(loads))];
    found.extend(quantities.iter().map(|q| (q.column(), some(&answer.values(*q).unwrap()))));
    found
}

pub fn data(columns: &[DataColumn]) -> Data {
    Data::from_columns(columns, Datum::AsperityMean).unwrap()
}

/// Standard normal numbers, by SplitMix64 and the inverse of their distribution.
pub fn normal(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    let share = ((bits ^ (bits >> 31)) >> 11) as f64 + 0.5;
    Normal::standard().inverse_cdf(share / (1u64 << 53) as f64)
}
