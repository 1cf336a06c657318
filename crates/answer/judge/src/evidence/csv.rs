//! Evidence as csv: a row for each case, with four columns for each model.

use crate::evidence::case::{Compared, EvidenceCase, EvidenceRow};
use asperity_core::ContactError;

/// Columns of a case and of boundary elements; four columns for each model follow.
pub(crate) const COLUMNS: [&str; 16] = [
    "alpha",
    "skewness",
    "slope_ratio",
    "plasticity_index",
    "p_over_Eg",
    "surfaces",
    "patches",
    "plastic_share",
    "area",
    "area_error",
    "stiffness",
    "stiffness_error",
    "unloading_stiffness",
    "unloading_stiffness_error",
    "mean_gap",
    "mean_gap_error",
];
/// The numbers of models are in thousandths.
const UNIT: f64 = 1e-3;

/// Number of a model: the ratio to boundary elements, or the difference of mean gaps over √m₀, in
/// thousandths.
pub(crate) fn relative(quantity: Compared, model: f64, bem: f64) -> f64 {
    match quantity {
        Compared::MeanGap => (model - bem) / UNIT,
        _ => model / bem / UNIT,
    }
}

fn absolute(quantity: Compared, number: f64, bem: f64) -> f64 {
    match quantity {
        Compared::MeanGap => bem + number * UNIT,
        _ => number * UNIT * bem,
    }
}

/// Reads all cases; any invalid number is an error.
pub(crate) fn cases(text: &str) -> Result<Vec<EvidenceCase>, ContactError> {
    let refused = |line: usize, reason: &str| ContactError::Refused {
        model: "evidence".into(),
        reason: format!("line {line}: {reason}"),
    };
    let mut lines = text.lines().zip(1..);
    let head: Vec<&str> = lines.next().map_or("", |(head, _)| head).split(',').collect();
    let (known, models) = head.split_at(COLUMNS.len().min(head.len()));
    if known != COLUMNS || models.len() % Compared::ALL.len() != 0 {
        let known = COLUMNS.join(",");
        return Err(refused(
            1,
            &format!("the columns {known} and four for each model were required"),
        ));
    }
    let ids: Vec<&str> = models.iter().step_by(Compared::ALL.len()).copied().collect();
    let mut cases: Vec<EvidenceCase> = vec![];
    for (text, line) in lines {
        let fields: Vec<&str> = text.split(',').collect();
        if fields.len() != head.len() {
            return Err(refused(line, &format!("{} fields, not {}", fields.len(), head.len())));
        }
        let number = |k: usize| match fields[k].parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(refused(line, &format!("{} is {:?}, not a number", head[k], fields[k]))),
        };
        let optional = |k: usize| (!fields[k].is_empty()).then(|| number(k)).transpose();
        let mut values = [[None; 4]; 2];
        for (k, _) in Compared::ALL.iter().enumerate() {
            values[0][k] = Some(number(8 + 2 * k)?);
            values[1][k] = Some(number(9 + 2 * k)?);
        }
        let bem = EvidenceRow { values: values[0], errors: values[1] };
        let mut models = vec![];
        for (m, id) in ids.iter().enumerate() {
            let mut found = [None; 4];
            for (k, quantity) in Compared::ALL.into_iter().enumerate() {
                let relative = optional(COLUMNS.len() + 4 * m + k)?;
                found[k] = relative.zip(values[0][k]).map(|(x, bem)| absolute(quantity, x, bem));
            }
            if found.iter().any(Option::is_some) {
                let errors = [None; 4];
                models.push(((*id).to_string(), EvidenceRow { values: found, errors }));
            }
        }
        cases.push(EvidenceCase {
            alpha: number(0)?,
            skewness: number(1)?,
            slope_ratio: number(2)?,
            plasticity_index: number(3)?,
            load: number(4)?,
            surfaces: number(5)? as usize,
            patches: number(6)? as usize,
            plastic_share: number(7)?,
            bem,
            models,
        });
    }
    if cases.is_empty() {
        return Err(refused(1, "no cases"));
    }
    Ok(cases)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Evidence;

    #[test]
    fn invalid_evidence_is_refused_with_its_line() {
        let head = format!("{},gw,gw_k,gw_u,gw_gap", COLUMNS.join(","));
        let read = |rows: &[&str]| cases(&[&[head.as_str()], rows].concat().join("\n"));
        let row = "3,0,1,2,0.1,4,210,0.25,0.2,0.01,1,0.1,1.5,0.1,0.5,0.01,800,900,,-20";
        let found = read(&[row]).unwrap().remove(0);
        assert_eq!((found.surfaces, found.patches), (4, 210));
        let [(id, gw)] = &found.models[..] else { panic!("{found:?}") };
        let near = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-12;
        assert!(id == "gw" && near(gw.values[0], 0.16) && near(gw.values[1], 0.9));
        assert!(gw.values[2].is_none() && near(gw.values[3], 0.48));
        assert!((relative(Compared::Area, 0.16, 0.2) - 800.0).abs() < 1e-9);
        assert!((relative(Compared::MeanGap, 0.48, 0.5) + 20.0).abs() < 1e-9);
        assert!(near(found.bem.error(Compared::Stiffness), 0.1));
        for (rows, wanted) in [
            (&[][..], "line 1: no cases"),
            (&[&*row.replace("0.2,", "O.2,")], "line 2: area is \"O.2\""),
            (&[&*row.replace("900", "nan")], "line 2: gw_k is \"nan\""),
            (&[&row[..row.len() - 4]], "line 2: 19 fields, not 20"),
        ] {
            let error = read(rows).unwrap_err().to_string();
            assert!(error.starts_with(&format!("evidence: {wanted}")), "{error}");
        }
        let error = Evidence::parse("alpha,model\n").unwrap_err().to_string();
        assert!(error.contains("line 1: the columns alpha,skewness,"), "{error}");
    }
}
