//! The figures: models over boundary elements against the load, a panel for each case.

use anyhow::Result;
use asperity::{Compared, Evidence, EvidenceCase};
use asperity_plot::{Axis, Between, Curve, Figure, Mark, Panel};

use super::models::MARKERS;
use crate::table::{Field, Table};

/// Pixels per shortest wave of the solved surfaces.
pub const PIXELS_PER_WAVE: f64 = 8.0;
/// Most surfaces of a case: of broad spectra, which have few contacts, under light loads, which
/// cost little.
pub const MOST_SEEDS: u64 = 64;

/// The quantity that is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// The real area.
    Area,
    /// -dp/d(gap) in first loading.
    Stiffness,
    /// -dp/d(gap) at the start of unloading, and conductances.
    Unloading,
}

impl Shown {
    /// All figures.
    pub const ALL: [Self; 3] = [Self::Area, Self::Stiffness, Self::Unloading];

    /// Name of the files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "truth-area",
            Self::Stiffness => "truth-stiffness",
            Self::Unloading => "truth-unloading",
        }
    }

    fn quantity(self) -> Compared {
        match self {
            Self::Area => Compared::Area,
            Self::Stiffness => Compared::Stiffness,
            Self::Unloading => Compared::UnloadingStiffness,
        }
    }
}

/// Plasticity indices with panels.
const SHOWN_INDICES: [f64; 3] = [0.0, 2.0, 4.0];
/// The models drawn in colour, with their looks; the others are grey.
const DRAWN: [(&str, &str, usize); 9] = [
    ("gw", "GW", 0),
    ("zmc", "ZMC", 2),
    ("ke", "KE", 3),
    ("jg", "JG", 5),
    ("gao", "Gao", 7),
    ("gw-random", "GW random", 9),
    ("jg-random", "JG random", 11),
    ("persson", "Persson", 12),
    ("persson-fudge", "Persson fudge", 13),
];
/// Models that have a colour in elastic panels alone: at most six curves of a panel have one.
const ELASTIC_ONLY: [&str; 3] = ["gw", "gw-random", "persson"];
/// Edges of the band.
const BAND: [&str; 2] = ["error-low", "error-high"];

/// The label of grey curves.
const OTHERS: &str = "other models";
/// The material of elastic cases.
const ELASTIC: &str = "elastic";

/// The name of a case.
fn name(case: &EvidenceCase) -> String {
    let EvidenceCase { alpha, plasticity_index: index, .. } = case;
    let material = if *index > 0.0 { format!("ψ = {index}") } else { ELASTIC.into() };
    format!("α = {alpha:.1}; {material}")
}

/// The numbers of a figure, from the text of the evidence.
///
/// # Errors
/// A text that is not evidence.
pub fn table(text: &str, shown: Shown) -> Result<Table> {
    let mut table = Table::new(&["case", "curve", "p_over_Eg", "model_over_bem"]);
    let evidence = Evidence::parse(text)?;
    let mut cases: Vec<&EvidenceCase> = evidence
        .cases()
        .iter()
        .filter(|case| case.skewness == 0.0 && case.slope_ratio <= 1.0)
        .filter(|case| SHOWN_INDICES.contains(&case.plasticity_index))
        .collect();
    cases.sort_by(|a, b| {
        let index = a.plasticity_index.total_cmp(&b.plasticity_index);
        a.alpha.total_cmp(&b.alpha).then(index).then(a.load.total_cmp(&b.load))
    });
    for found in cases {
        let case = name(found);
        let Some(truth) = found.bem.value(shown.quantity()) else { continue };
        let error = found.bem.error(shown.quantity()).unwrap_or(0.0) / truth;
        let mut push = |curve: &str, value: f64| {
            let numbers = [found.load, value].map(Field::Number);
            table.push(&[&[Field::Word(&case), Field::Word(curve)], &numbers[..]].concat())
        };
        push(BAND[0], 1.0 - error)?;
        push(BAND[1], 1.0 + error)?;
        for (id, row) in &found.models {
            if let Some(value) = row.value(shown.quantity()) {
                push(id, value / truth)?;
            }
        }
    }
    Ok(table)
}

/// The picture.
///
/// # Errors
/// The csv of another figure.
pub fn style(csv: &str, shown: Shown) -> Result<Figure> {
    let mut cases: Vec<(&str, Vec<&str>)> = vec![];
    for line in csv.lines().skip(1) {
        let mut fields = line.split(',');
        let (Some(case), Some(curve)) = (fields.next(), fields.next()) else { continue };
        if cases.last().is_none_or(|(known, _)| *known != case) {
            cases.push((case, vec![]));
        }
        if let Some((_, curves)) = cases.last_mut()
            && !curves.contains(&curve)
        {
            curves.push(curve);
        }
    }
    let panel = |(case, curves): &(&str, Vec<&str>)| {
        let x = Axis::new("p_over_Eg", "p/(E g)").log().range(1e-5, 0.3);
        let (label, range) = match shown {
            Shown::Area => ("area/BEM", (0.4, 1.6)),
            Shown::Stiffness => ("stiffness/BEM", (0.0, 1.6)),
            Shown::Unloading => ("unloading stiffness/BEM", (0.0, 2.0)),
        };
        let mut panel = Panel::new(x, Axis::new("model_over_bem", label).range(range.0, range.1));
        panel.title = (*case).into();
        panel.only = Some(("case".into(), (*case).into()));
        let elastic = case.ends_with(ELASTIC);
        let coloured = |id: &str| elastic || !ELASTIC_ONLY.contains(&id);
        let drawn = DRAWN.iter().filter(|(id, ..)| curves.contains(id) && coloured(id));
        panel.curves = drawn.map(|(id, label, look)| Curve::new(*look, id, label)).collect();
        let others: Vec<&&str> = curves
            .iter()
            .filter(|id| !BAND.contains(id) && !panel.curves.iter().any(|c| c.key == **id))
            .collect();
        panel.curves.extend(others.into_iter().map(|id| Curve::faint(id, OTHERS)));
        let [lower, upper] = BAND.map(Into::into);
        panel.between = vec![Between { lower, upper, look: 9, label: String::new() }];
        panel.horizontals = vec![Mark::new(1.0, "")];
        panel
    };
    let panels = cases.iter().map(panel).collect();
    let (title, what) = match shown {
        Shown::Area => ("Real area of the models over that of boundary elements", "Real area"),
        Shown::Stiffness => (
            "Stiffness of the models in first loading over that of boundary elements",
            "Stiffness -dp/d(mean gap) in first loading (of boundary elements with a hardness from pressures 5 % to either side)",
        ),
        Shown::Unloading => (
            "Unloading stiffness and conductance: models over boundary elements",
            "Stiffness at the start of unloading, of boundary elements at fixed contact (conductances have the same ratio)",
        ),
    };
    let hurst = Evidence::HURST;
    let how = format!(
        "{what} over the mean of up to {MOST_SEEDS} surfaces with the same moments, whose standard error is grey, against the nominal pressure p; g is the rms gradient, α = m₀m₄/m₂², ψ = √(σ_z/w_c). Isotropic periodic surfaces of asperity::bem::RandomSurface: 256 × 256 to 2048 × 2048 pixels, shortest wave {PIXELS_PER_WAVE} pixels, Hurst exponent {hurst}."
    );
    let caveats = "In boundary elements the pressure is capped at H: a contact yields at a Hertz peak pressure of H, in the models at S·H = 0.577 H, so that yield starts a little later at the same ψ. This is a reference for a constant mean pressure H, not for elastic-plastic finite elements. Other ψ, skewed surfaces and surfaces with a lay are in crates/asperity/data/truth.csv.";
    let mut figure = Figure::new(title, &[&how, caveats, MARKERS], panels);
    figure.columns = 3;
    Ok(figure)
}
