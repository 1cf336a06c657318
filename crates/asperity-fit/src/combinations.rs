//! Combinations of parameters that the data do not fix.

use asperity_core::Finding;
use nalgebra::DMatrix;

use crate::Parameter;
use crate::doubt::{UNDETERMINED, doubt, list};

/// Shares of a direction below this are errors of the derivatives.
const NONE: f64 = 1e-4;

/// Which combinations of the parameters the data fix, for directions (columns) in which the data do
/// not change: "only asperity_density x asperity_radius^0.5 is determined".
pub(crate) fn undetermined(parameters: &[Parameter], directions: &DMatrix<f64>) -> Vec<Finding> {
    let Some((pivots, exponents)) = reduced(directions) else { return vec![] };
    let name = |row: &usize| parameters[*row].name.as_str();
    let (mut of, mut products): (Vec<usize>, Vec<String>) = (vec![], vec![]);
    for row in (0..parameters.len()).filter(|row| !pivots.contains(row)) {
        let (before, mut product) = (of.len(), name(&row).to_string());
        for (column, pivot) in pivots.iter().enumerate() {
            let exponent = -exponents[(row, column)];
            if exponent.abs() > NONE {
                product += &power(name(pivot), exponent);
                of.extend([row, *pivot]);
            }
        }
        products.extend((of.len() > before).then_some(product));
    }
    of.sort_unstable();
    of.dedup();
    let idle = pivots.iter().filter(|pivot| !of.contains(pivot)).map(name);
    let idle = idle.map(|name| {
        let text = format!("{name} is not determined: it does not change the data");
        doubt(UNDETERMINED, name, f64::NAN, text)
    });
    let mut found: Vec<Finding> = idle.collect();
    let names: Vec<&str> = of.iter().map(name).collect();
    let products: Vec<&str> = products.iter().map(String::as_str).collect();
    // Others may be determined by themselves.
    let among = match of.len() < parameters.len() {
        true => format!("of {}, ", list(&names)),
        false => String::new(),
    };
    let verb = if products.len() == 1 { "is" } else { "are" };
    let text = match of.iter().all(|row| parameters[*row].is_log()) {
        true => format!("{among}only {} {verb} determined", list(&products)),
        false => format!("{} are not determined separately", list(&names)),
    };
    found.extend((!of.is_empty()).then(|| doubt(UNDETERMINED, &names.join(", "), f64::NAN, text)));
    found
}

/// The directions with a unit matrix in the rows of the pivots.
fn reduced(directions: &DMatrix<f64>) -> Option<(Vec<usize>, DMatrix<f64>)> {
    let mut rows = DMatrix::from_fn(1, directions.nrows(), |_, row| row);
    directions.transpose().col_piv_qr().p().permute_columns(&mut rows);
    let pivots: Vec<usize> = rows.iter().copied().take(directions.ncols()).collect();
    let own = directions.select_rows(&pivots).try_inverse()?;
    (!pivots.is_empty()).then(|| (pivots, directions * own))
}

/// A factor, with an exponent unless it is 1.
fn power(name: &str, exponent: f64) -> String {
    match (1000.0 * exponent).round() / 1000.0 {
        0.0 => String::new(),
        1.0 => format!(" x {name}"),
        other => format!(" x {name}^{other}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sentences_of(parameters: &[Parameter], directions: &DMatrix<f64>) -> Vec<String> {
        undetermined(parameters, directions).iter().map(ToString::to_string).collect()
    }

    fn parameters(names: &[&str]) -> Vec<Parameter> {
        names.iter().map(|name| Parameter::new(*name, "", 1.0, [0.1, 10.0], 1.0).unwrap()).collect()
    }

    #[test]
    fn combinations_are_named_with_their_exponents() {
        let three = parameters(&["density", "radius", "std"]);
        let one = DMatrix::from_column_slice(3, 1, &[-0.4472136, 0.8944272, 1e-9]);
        let wanted = ["of density and radius, only density x radius^0.5 is determined"];
        assert_eq!(sentences_of(&three, &one), wanted);
        assert_eq!(undetermined(&three, &one)[0].field, "density, radius");
        let both = parameters(&["density", "radius"]);
        let found = sentences_of(&both, &one.rows(0, 2).into_owned());
        assert_eq!(found, ["only density x radius^0.5 is determined"]);
        let shift = DMatrix::from_column_slice(3, 1, &[0.0, 0.0, 1.0]);
        let found = sentences_of(&three, &shift);
        assert_eq!(found, ["std is not determined: it does not change the data"]);
        let two = DMatrix::from_column_slice(3, 2, &[0.5, 1.0, 0.0, 2.0, 0.0, 1.0]);
        let found = sentences_of(&three, &two);
        assert_eq!(found.len(), 1);
        assert!(found[0].starts_with("only ") && found[0].ends_with(" is determined"), "{found:?}");
        assert!(sentences_of(&three, &DMatrix::zeros(3, 0)).is_empty());
    }

    #[test]
    fn a_shift_has_no_exponent() {
        let mut both = parameters(&["std"]);
        both.push(Parameter::new("separation_offset", "m", 0.0, [-1.0, 1.0], 1.0).unwrap());
        let one = DMatrix::from_column_slice(2, 1, &[0.6, 0.8]);
        let wanted = ["std and separation_offset are not determined separately"];
        assert_eq!(sentences_of(&both, &one), wanted);
    }
}
