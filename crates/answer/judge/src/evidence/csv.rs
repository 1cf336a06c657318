//! Evidence as csv: a row for each case, with four columns for each model.

use crate::evidence::case::{Compared, EvidenceCase, EvidenceRow};
use asperity_core::ContactError;

/// The number of columns of a case.
const OWN: usize = 16;
/// Columns of a case and of boundary elements; four columns for each model follow.
pub(crate) const COLUMNS: &str = "alpha,skewness,slope_ratio,plasticity_index,p_over_Eg,surfaces,\
    patches,plastic_share,area,area_error,stiffness,stiffness_error,unloading_stiffness,\
    unloading_stiffness_error,mean_gap,mean_gap_error";
/// The numbers of models are in thousandths.
pub(crate) const UNIT: f64 = 1e-3;

fn absolute(quantity: Compared, number: f64, bem: f64) -> f64 {
    match quantity {
        Compared::MeanGap => bem + number * UNIT,
        _ => number * UNIT * bem,
    }
}

/// The cases of a csv.
///
/// # Errors
/// [`ContactError::Refused`] with the line that is not as required.
pub(crate) fn cases(text: &str) -> Result<Vec<EvidenceCase>, ContactError> {
    let refused = |line: usize, required: &str| ContactError::Refused {
        model: "evidence".into(),
        reason: format!("line {line}: {required} was required"),
    };
    let head: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
    let (known, models) = head.split_at(OWN.min(head.len()));
    if known.join(",") != COLUMNS || models.len() % 4 != 0 {
        return Err(refused(1, "the columns of evidence and four for each model"));
    }
    let ids: Vec<&str> = models.iter().step_by(4).copied().collect();
    let case = |(text, line): (&str, usize)| {
        let number = |cell: &str| match cell.parse::<f64>() {
            _ if cell.is_empty() => Some(None),
            Ok(number) if number.is_finite() => Some(Some(number)),
            _ => None,
        };
        let cells: Option<Vec<Option<f64>>> = text.split(',').map(number).collect();
        let cells = cells.filter(|cells| cells.len() == head.len());
        let (own, models) = cells
            .as_deref()
            .and_then(|cells| cells.split_at_checked(OWN))
            .ok_or_else(|| refused(line, "a number or nothing for each column"))?;
        let needed = || refused(line, "a number for each column of the case");
        let own: Vec<f64> = own.iter().copied().collect::<Option<_>>().ok_or_else(needed)?;
        let of = |from: usize| std::array::from_fn(|k| Some(own[from + 2 * k]));
        let bem = EvidenceRow { values: of(8), errors: of(9) };
        let model = |(id, found): (&&str, &[Option<f64>])| {
            let value = |of: Compared| {
                let bem = bem.value(of)?;
                found[of as usize].map(|relative| absolute(of, relative, bem))
            };
            let values = Compared::ALL.map(value);
            let row = EvidenceRow { values, errors: [None; 4] };
            values.iter().any(Option::is_some).then(|| ((*id).to_string(), row))
        };
        Ok(EvidenceCase {
            alpha: own[0],
            skewness: own[1],
            slope_ratio: own[2],
            plasticity_index: own[3],
            load: own[4],
            surfaces: own[5] as usize,
            patches: own[6] as usize,
            plastic_share: own[7],
            bem,
            models: ids.iter().zip(models.chunks(4)).filter_map(model).collect(),
        })
    };
    let cases: Vec<EvidenceCase> =
        text.lines().zip(1..).skip(1).map(case).collect::<Result<_, _>>()?;
    if cases.is_empty() { Err(refused(1, "a case")) } else { Ok(cases) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Evidence;

    #[test]
    fn invalid_evidence_is_refused_with_its_line() {
        let head = format!("{COLUMNS},gw,gw_k,gw_u,gw_gap");
        let read = |rows: &[&str]| cases(&[&[head.as_str()], rows].concat().join("\n"));
        let row = "3,0,1,2,0.1,4,210,0.25,0.2,0.01,1,0.1,1.5,0.1,0.5,0.01,800,900,,-20";
        let found = read(&[row]).unwrap().remove(0);
        assert_eq!((found.surfaces, found.patches), (4, 210));
        let [(id, gw)] = &found.models[..] else { panic!("{found:?}") };
        let near = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-12;
        assert!(id == "gw" && near(gw.values[0], 0.16) && near(gw.values[1], 0.9));
        assert!(gw.values[2].is_none() && near(gw.values[3], 0.48));
        assert!((Evidence::relative(Compared::Area, 0.16, 0.2) - 800.0).abs() < 1e-9);
        assert!((Evidence::relative(Compared::MeanGap, 0.48, 0.5) + 20.0).abs() < 1e-9);
        assert!(near(found.bem.error(Compared::Stiffness), 0.1));
        for (rows, wanted) in [
            (&[][..], "line 1: a case"),
            (&[&*row.replace("0.2,", "O.2,")], "line 2: a number"),
            (&[&*row.replace("900", "nan")], "line 2: a number"),
            (&[&row[..row.len() - 4]], "line 2: a number"),
        ] {
            let error = read(rows).unwrap_err().to_string();
            assert!(error.starts_with(&format!("evidence: {wanted}")), "{error}");
        }
        let error = Evidence::parse("alpha,model\n").unwrap_err().to_string();
        assert!(error.contains("line 1: the columns"), "{error}");
    }
}
