//! Combinations of parameters that the data do not fix, in words.

use nalgebra::DMatrix;

use crate::Parameter;
use crate::remark::Remark;

/// Shares of a direction below this are errors of the derivatives.
const NONE: f64 = 1e-4;

/// Says which combinations of the parameters the data fix, for directions (columns) in which the
/// data do not change: "only asperity_density x asperity_radius^0.5 is determined".
pub(crate) fn undetermined(parameters: &[Parameter], directions: &DMatrix<f64>) -> Vec<Remark> {
    let Some((pivots, exponents)) = reduced(directions) else { return vec![] };
    let has = |row: usize, column: usize| exponents[(row, column)].abs() > NONE;
    let involved = |row: usize| (0..pivots.len()).any(|column| has(row, column));
    let rows: Vec<usize> =
        (0..parameters.len()).filter(|row| !pivots.contains(row) && involved(*row)).collect();
    let name = |row: usize| parameters[row].name.as_str();
    let alone = |column: usize| rows.iter().all(|row| !has(*row, column));
    let without_effect = |column: usize| Remark {
        parameters: vec![pivots[column]],
        sentence: format!(
            "{} is not determined: it does not change the data",
            name(pivots[column])
        ),
    };
    let idle = (0..pivots.len()).filter(|column| alone(*column));
    let mut found: Vec<Remark> = idle.map(without_effect).collect();
    let together: Vec<usize> = (0..pivots.len()).filter(|column| !alone(*column)).collect();
    if together.is_empty() {
        return found;
    }
    let mut of: Vec<usize> =
        rows.iter().copied().chain(together.iter().map(|k| pivots[*k])).collect();
    of.sort_unstable();
    let names: Vec<&str> = of.iter().map(|row| name(*row)).collect();
    if !of.iter().all(|row| parameters[*row].is_log()) {
        let sentence = format!("{} are not determined separately", list(&names));
        found.push(Remark { sentence, parameters: of });
        return found;
    }
    let product = |row: &usize| {
        let factor = |column: &usize| power(name(pivots[*column]), -exponents[(*row, *column)]);
        let factors = together.iter().filter_map(factor);
        std::iter::once(name(*row).to_string()).chain(factors).collect::<Vec<_>>().join(" x ")
    };
    let products: Vec<String> = rows.iter().map(product).collect();
    let products: Vec<&str> = products.iter().map(String::as_str).collect();
    let verb = if products.len() == 1 { "is" } else { "are" };
    // Others may be determined by themselves.
    let among = match of.len() < parameters.len() {
        true => format!("of {}, ", list(&names)),
        false => String::new(),
    };
    let sentence = format!("{among}only {} {verb} determined", list(&products));
    found.push(Remark { sentence, parameters: of });
    found
}

/// The directions with a unit matrix in the rows of the pivots.
fn reduced(directions: &DMatrix<f64>) -> Option<(Vec<usize>, DMatrix<f64>)> {
    let mut pivots: Vec<usize> = vec![];
    let mut left = directions.clone();
    for column in 0..left.ncols() {
        let size = |row: &usize| left[(*row, column)].abs();
        let free = (0..left.nrows()).filter(|row| !pivots.contains(row));
        let pivot = free.max_by(|a, b| size(a).total_cmp(&size(b)))?;
        if size(&pivot) < NONE {
            return None;
        }
        let scale = left[(pivot, column)];
        left.column_mut(column).scale_mut(1.0 / scale);
        let own = left.column(column).clone_owned();
        for other in (0..left.ncols()).filter(|other| *other != column) {
            let share = left[(pivot, other)];
            left.column_mut(other).axpy(-share, &own, 1.0);
        }
        pivots.push(pivot);
    }
    (!pivots.is_empty()).then_some((pivots, left))
}

/// A power of a name; none for an exponent of 0.
fn power(name: &str, exponent: f64) -> Option<String> {
    let rounded = (1000.0 * exponent).round() / 1000.0;
    match rounded {
        none if none.abs() < NONE => None,
        one if (one - 1.0).abs() < NONE => Some(name.into()),
        other => Some(format!("{name}^{other}")),
    }
}

/// Names in a sentence.
pub(crate) fn list(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).into(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sentences_of(parameters: &[Parameter], directions: &DMatrix<f64>) -> Vec<String> {
        crate::remark::sentences(undetermined(parameters, directions))
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
        assert_eq!(undetermined(&three, &one)[0].parameters, [0, 1]);
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
