//! The thermal conductivity of an interface, as given or from its two bodies.

use asperity::{Body, Interface};
use asperity_answer::rounded;
use asperity_inputs::SceneFile;

use crate::input::lists::Numbers;
use crate::input::numbers::{of_unit, positive};
use crate::output::print_message;

/// The conductivity of an interface, or those of its two bodies \[W/(m K)\].
#[derive(Debug, Clone, PartialEq)]
pub struct Conductivity(Vec<f64>);

impl Conductivity {
    /// The conductivity of the interface \[W/(m K)\].
    pub fn value(&self) -> f64 {
        match self.0[..] {
            [first, second] => Interface::mean_conductivity(first, second),
            _ => self.0[0],
        }
    }

    /// Prints how two values are read.
    pub fn note(&self) {
        let [first, second] = self.0[..] else { return };
        let [k1, k2, k] = [first, second, self.value()].map(rounded);
        let how = format!(
            "--conductivity {k1},{k2} is read as two bodies, 2 k1 k2/(k1 + k2) = {k} W/(m K)"
        );
        print_message("note", &how);
    }
}

/// Reads `K` or `K1,K2`.
pub fn interface_conductivity(text: &str) -> Result<Conductivity, String> {
    if text.contains(':') {
        return Err("a range is not possible here; write K of the interface, or K1,K2".into());
    }
    match Numbers::read(text, conductivity)?.0 {
        one_or_two if one_or_two.len() <= 2 => Ok(Conductivity(one_or_two)),
        all => Err(format!("{} values; write K of the interface, or K1,K2", all.len())),
    }
}

/// What lacks a conductivity, and where to set it.
pub fn missing_conductivity(file: &SceneFile) -> String {
    let lacks = |(body, k): (&Body, usize)| {
        body.thermal_conductivity.is_none().then(|| format!("body[{k}].thermal_conductivity"))
    };
    let lacking: Vec<String> = file.bodies.iter().zip(1..).filter_map(lacks).collect();
    match (&lacking[..], file.bodies.len()) {
        ([one], 2) => format!("{one} is missing: set it there, or use --conductivity"),
        (_, 1) => {
            "thermal_conductivity of a rigid counterface is unknown: use --conductivity".into()
        }
        (_, 0) => {
            "interface.thermal_conductivity is missing: set it there, or use --conductivity".into()
        }
        _ => {
            "thermal_conductivity is missing: set it in both [[body]], or use --conductivity".into()
        }
    }
}

/// A conductivity \[W/(m K)\].
pub fn conductivity(text: &str) -> Result<f64, String> {
    of_unit(text, "W/(m K)").and_then(positive)
}
