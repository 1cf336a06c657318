//! A solved case with the results of boundary elements and of the models, and the compared
//! quantities of a model.

use asperity_core::{At, Contact, ContactError, Datum, Quantity, SeparationUnit};
use serde::Serialize;

/// One family of surfaces, one material and one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvidenceCase {
    /// m₀ m₄/m₂² of profiles, the mean of all directions.
    pub alpha: f64,
    /// Skewness of the heights.
    pub skewness: f64,
    /// Rms slope across the lay over that along it.
    pub slope_ratio: f64,
    /// ψ = √(σ_z/w_c); 0 for elastic cases.
    pub plasticity_index: f64,
    /// p/(E g), with the root mean square gradient g.
    pub load: f64,
    /// Number of surfaces with the same moments.
    pub surfaces: usize,
    /// Contact patches of at least 12 pixels on all of them.
    pub patches: usize,
    /// Share of the contact at the hardness.
    pub plastic_share: f64,
    /// Boundary elements: the mean of the surfaces.
    pub bem: EvidenceRow,
    /// Results of the models, by id.
    #[serde(skip)]
    pub models: Vec<(String, EvidenceRow)>,
}

/// Dimensionless results, in the order of [`Compared::ALL`]; `None` if not available.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// The values.
    pub values: [Option<f64>; 4],
    /// Standard errors of the mean, for boundary elements only.
    pub errors: [Option<f64>; 4],
}

/// A quantity that is compared with boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Compared {
    /// Real area; in rows over the nominal area.
    Area,
    /// Stiffness of first loading; in rows −dp/d(gap) √m₀/E of a surface with the gradient
    /// [`Evidence::GRADIENT`](crate::Evidence::GRADIENT), in proportion to which it grows.
    Stiffness,
    /// Stiffness at the start of unloading, with which conductances and the tangential stiffness
    /// go; in rows in the same unit.
    UnloadingStiffness,
    /// Mean gap; in rows over √m₀.
    MeanGap,
}

impl Compared {
    /// All four.
    pub const ALL: [Self; 4] =
        [Self::Area, Self::Stiffness, Self::UnloadingStiffness, Self::MeanGap];

    /// Of each its name, its words and its quantity.
    const TABLE: [(&'static str, &'static str, Option<Quantity>); 4] = [
        ("area", "real area", Some(Quantity::Area)),
        ("stiffness", "first-loading stiffness", Some(Quantity::Tangent)),
        (
            "unloading_stiffness",
            "stiffness of small vibrations",
            Some(Quantity::UnloadingStiffness),
        ),
        ("mean_gap", "mean gap", None),
    ];

    /// Its name in columns and keys.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::TABLE[self as usize].0
    }

    /// Its name in sentences.
    #[must_use]
    pub fn label(self) -> &'static str {
        Self::TABLE[self as usize].1
    }

    /// The quantity of a contact that is compared; none is the distance of the mean planes.
    #[must_use]
    pub fn quantity(self) -> Option<Quantity> {
        Self::TABLE[self as usize].2
    }

    /// The quantities of a contact that are compared; the mean gap is none.
    pub const QUANTITIES: [Quantity; 3] =
        [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness];

    /// The value of a model at a place: area over nominal area, stiffness \[N/m\], mean gap \[m\].
    ///
    /// # Errors
    /// Those of the contact, which must be compiled for the area, the tangent and the unloading
    /// stiffness.
    pub fn of_contact(self, contact: &dyn Contact, at: At) -> Result<f64, ContactError> {
        let Some(quantity) = self.quantity() else {
            return contact.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at);
        };
        let unit = if self == Self::Area { contact.scene().nominal_area } else { 1.0 };
        Ok(contact.evaluate(quantity, at)?.value() / unit)
    }

    /// The compared quantity from which a quantity at a load follows.
    #[must_use]
    pub fn behind(quantity: Quantity) -> Option<Self> {
        match quantity {
            Quantity::Area | Quantity::AreaFraction | Quantity::MeanPressure | Quantity::LnArea => {
                Some(Self::Area)
            }
            Quantity::Tangent => Some(Self::Stiffness),
            radii if radii.needs_circles() => Some(Self::UnloadingStiffness),
            _ => None,
        }
    }
}

impl EvidenceRow {
    /// The value of a quantity.
    #[must_use]
    pub fn value(&self, quantity: Compared) -> Option<f64> {
        self.values[quantity as usize]
    }

    /// Its standard error.
    #[must_use]
    pub fn error(&self, quantity: Compared) -> Option<f64> {
        self.errors[quantity as usize]
    }
}

/// Quantities that a model does not have, and why.
pub(crate) type Lacking = Vec<(Quantity, ContactError)>;

/// A contact compiled for those of the quantities that the model has, and why it lacks the others;
/// `compile` makes it for some of them. Without any, it is made for those `otherwise`.
///
/// # Errors
/// The errors of the model for all quantities, if it has none and there is nothing otherwise.
pub fn compile_known(
    quantities: &[Quantity],
    otherwise: &[Quantity],
    compile: impl Fn(&[Quantity]) -> Result<Box<dyn Contact>, ContactError>,
) -> Result<(Box<dyn Contact>, Lacking), ContactError> {
    let whole = match compile(quantities) {
        Ok(contact) => return Ok((contact, vec![])),
        Err(whole) => whole,
    };
    let refusal = |q: &Quantity| Some((*q, compile(&[*q]).err()?));
    let lacking: Lacking = quantities.iter().filter_map(refusal).collect();
    let mut had = quantities.to_vec();
    had.retain(|q| lacking.iter().all(|(lacks, _)| lacks != q));
    let had = if had.is_empty() { otherwise.to_vec() } else { had };
    match had.is_empty() {
        true => Err(whole),
        false => Ok((compile(&had).map_err(|_| whole)?, lacking)),
    }
}

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
