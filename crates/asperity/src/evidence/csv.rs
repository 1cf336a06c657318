//! Evidence as csv: a row of boundary elements, then the rows of the models for the same case.

use crate::ContactError;
use crate::evidence::case::{EvidenceCase, EvidenceRow};

pub(crate) const COLUMNS: [&str; 10] = [
    "alpha",
    "plasticity_index",
    "p_over_Eg",
    "model",
    "area_fraction",
    "area_low",
    "area_high",
    "stiffness",
    "stiffness_low",
    "stiffness_high",
];

/// Reads all cases; any invalid number is an error.
pub(crate) fn cases(text: &str) -> Result<Vec<EvidenceCase>, ContactError> {
    let refused = |line: usize, reason: &str| ContactError::Refused {
        model: "evidence".into(),
        reason: format!("line {line}: {reason}"),
    };
    let mut lines = text.lines().zip(1..);
    let head = COLUMNS.join(",");
    if lines.next().is_none_or(|(found, _)| found != head) {
        return Err(refused(1, &format!("the columns {head} were required")));
    }
    let mut cases: Vec<EvidenceCase> = vec![];
    for (text, line) in lines {
        let fields: Vec<&str> = text.split(',').collect();
        if fields.len() != COLUMNS.len() {
            return Err(refused(line, &format!("{} fields, not {}", fields.len(), COLUMNS.len())));
        }
        let number = |k: usize| match fields[k].parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(refused(line, &format!("{} is {:?}, not a number", COLUMNS[k], fields[k]))),
        };
        let optional = |k: usize| (!fields[k].is_empty()).then(|| number(k)).transpose();
        let span = |k: usize| match (optional(k)?, optional(k + 1)?) {
            (Some(low), Some(high)) => Ok(Some([low, high])),
            (None, None) => Ok(None),
            _ => Err(refused(line, &format!("{} or its counterpart is missing", COLUMNS[k]))),
        };
        let row = EvidenceRow {
            area_fraction: optional(4)?,
            area_span: span(5)?,
            stiffness: optional(7)?,
            stiffness_span: span(8)?,
        };
        let (alpha, plasticity_index, load) = (number(0)?, number(1)?, number(2)?);
        match (fields[3], cases.last_mut()) {
            ("bem", _) => {
                let whole = row.area_fraction.is_some() && row.stiffness.is_some();
                if !whole || row.area_span.is_none() || row.stiffness_span.is_none() {
                    return Err(refused(line, "a result of boundary elements is missing"));
                }
                let (bem, models) = (row, vec![]);
                cases.push(EvidenceCase { alpha, plasticity_index, load, bem, models });
            }
            (id, Some(case)) => {
                let known = [case.alpha, case.plasticity_index, case.load];
                if known.map(f64::to_bits) != [alpha, plasticity_index, load].map(f64::to_bits) {
                    return Err(refused(line, "this case has no row of bem"));
                }
                case.models.push((id.into(), row));
            }
            (_, None) => return Err(refused(line, "a row of bem must come first")),
        }
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
        let head = COLUMNS.join(",");
        let bem = "3,0,0.1,bem,0.2,0.1,0.3,1,0.9,1.1";
        let read = |rows: &[&str]| cases(&[&[head.as_str()], rows].concat().join("\n"));
        let found = read(&[bem, "3,0,0.1,gw,0.25,,,,,"]).unwrap();
        assert_eq!(
            found[0].models,
            [("gw".into(), EvidenceRow { area_fraction: Some(0.25), ..EvidenceRow::default() })]
        );
        for (rows, wanted) in [
            (&[][..], "line 1: no cases"),
            (&["3,0,0.1,gw,0.2,,,,,"], "line 2: a row of bem must come first"),
            (&[bem, "3,0,0.2,gw,0.2,,,,,"], "line 3: this case has no row of bem"),
            (&[bem, "3,0,0.1,gw,O.2,,,,,"], "line 3: area_fraction is \"O.2\", not a number"),
            (&[bem, "3,0,0.1,gw,nan,,,,,"], "line 3: area_fraction is \"nan\", not a number"),
            (&[bem, "3,0,0.1,gw,0.2,,,"], "line 3: 8 fields, not 10"),
            (&["3,0,0.1,bem,0.2,0.1,,1,0.9,1.1"], "line 2: area_low or its counterpart is missing"),
            (&["3,0,0.1,bem,0.2,0.1,0.3,,0.9,1.1"], "line 2: a result of boundary elements"),
        ] {
            let error = read(rows).unwrap_err().to_string();
            assert!(error.starts_with(&format!("evidence: {wanted}")), "{error}");
        }
        let error = Evidence::parse("alpha,model\n").unwrap_err().to_string();
        assert!(error.contains("line 1: the columns alpha,plasticity_index,"), "{error}");
    }
}
