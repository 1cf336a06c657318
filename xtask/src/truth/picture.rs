//! The figures: models over boundary elements against the load, a panel for each case.

use std::collections::BTreeMap;

use anyhow::Result;
use asperity::Evidence;
use asperity::bem::RandomSurface;
use asperity_plot::{Axis, Between, Curve, Figure, Mark, Panel};

use super::cases::{FULL, PIXELS_PER_WAVE, Scope};
use crate::figures::models::{self, MARKERS, PAPER};
use crate::table::{Field, Table};

/// The quantity that is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// The real area.
    Area,
    /// -dp/d(gap).
    Stiffness,
}

impl Shown {
    /// Area and stiffness.
    pub const ALL: [Self; 2] = [Self::Area, Self::Stiffness];

    /// Name of the files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "truth-area",
            Self::Stiffness => "truth-stiffness",
        }
    }

    /// The column of the evidence.
    pub(super) fn of(self, state: &asperity::EvidenceRow) -> Option<f64> {
        match self {
            Self::Area => state.area_fraction,
            Self::Stiffness => state.stiffness,
        }
    }

    pub(super) fn span(self, state: &asperity::EvidenceRow) -> Option<[f64; 2]> {
        match self {
            Self::Area => state.area_span,
            Self::Stiffness => state.stiffness_span,
        }
    }
}

/// The models drawn besides the paper's nine, with their looks.
const BESIDE: [(&str, &str, usize); 5] = [
    ("gw-random", "GW random", 9),
    ("ke-random", "KE random", 10),
    ("jg-random", "JG random", 11),
    ("persson", "Persson", 12),
    ("persson-fudge", "Persson fudge", 13),
];
/// Edges of the band.
const BAND: [&str; 2] = ["seeds-low", "seeds-high"];

/// The name of a case.
pub(super) fn case(alpha: f64, index: f64) -> String {
    let material = if index > 0.0 { format!("ψ = {index}") } else { "elastic".into() };
    format!("α = {alpha:.1}; {material}")
}

/// The numbers of a figure, from the text of the evidence.
///
/// # Errors
/// A text that is not evidence.
pub fn table(text: &str, shown: Shown) -> Result<Table> {
    let mut table = Table::new(&["case", "curve", "p_over_Eg", "model_over_bem"]);
    for found in Evidence::parse(text)?.cases() {
        let case = case(found.alpha, found.plasticity_index);
        let Some(truth) = shown.of(&found.bem) else { continue };
        let mut push = |curve: &str, value: f64| {
            let numbers = [found.load, value].map(Field::Number);
            table.push(&[&[Field::Word(&case), Field::Word(curve)], &numbers[..]].concat())
        };
        for (edge, value) in BAND.iter().zip(shown.span(&found.bem).unwrap_or([truth; 2])) {
            push(edge, value / truth)?;
        }
        let drawn = |id: &str| PAPER.contains(&id) || BESIDE.iter().any(|(known, ..)| *known == id);
        // Where asperities yield, two of the elastic theories are shown.
        let left_out =
            |id: &str| found.plasticity_index > 0.0 && ["gw-random", "persson"].contains(&id);
        for (id, state) in found.models.iter().filter(|(id, _)| drawn(id) && !left_out(id)) {
            if let Some(value) = shown.of(state) {
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
    let mut cases: Vec<&str> = vec![];
    let mut curves: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for line in csv.lines().skip(1) {
        let mut fields = line.split(',');
        let (Some(case), Some(curve)) = (fields.next(), fields.next()) else { continue };
        if !cases.contains(&case) {
            cases.push(case);
        }
        let of_case = curves.entry(case).or_default();
        if !of_case.contains(&curve) && !BAND.contains(&curve) {
            of_case.push(curve);
        }
    }
    // The hardness decreases down the columns; the spectrum broadens along the rows.
    let rows = cases.len() / 3;
    let panel = |k: usize| -> Result<Panel> {
        let case = cases[k % 3 * rows + k / 3];
        let x = Axis::new("p_over_Eg", "p/(E g)").log();
        let (label, range) = match shown {
            Shown::Area => ("area/BEM", (0.5, 1.75)),
            Shown::Stiffness => ("stiffness/BEM", (0.0, 1.6)),
        };
        let mut panel = Panel::new(x, Axis::new("model_over_bem", label).range(range.0, range.1));
        panel.title = case.into();
        panel.only = Some(("case".into(), case.into()));
        let curve = |id: &&str| match BESIDE.iter().find(|(known, ..)| known == id) {
            Some((_, label, look)) => Ok(Curve::new(*look, id, label)),
            None => models::curve(id),
        };
        panel.curves = curves[case].iter().map(curve).collect::<Result<_>>()?;
        let [lower, upper] = BAND.map(Into::into);
        panel.between = vec![Between { lower, upper, look: 9 }];
        panel.horizontals = vec![Mark::new(1.0, "")];
        Ok(panel)
    };
    let panels = (0..3 * rows).map(panel).collect::<Result<_>>()?;
    let (title, what) = match shown {
        Shown::Area => ("Real area of the models over that of boundary elements", "Real area"),
        Shown::Stiffness => (
            "Stiffness of the models over that of boundary elements",
            "Stiffness -dp/d(mean gap) (of boundary elements from pressures 5 % to either side; Persson's for a power law with the same moments and Hurst exponent)",
        ),
    };
    let Scope { pixels, seeds, waves, .. } = FULL;
    let longest: Vec<String> = waves.iter().map(|[longest, _]| format!("1/{longest}")).collect();
    let (longest, hurst) = (longest.join(", "), RandomSurface::HURST);
    let how = format!(
        "{what} over the mean of {seeds} surfaces with the same moments, whose span is grey, against the nominal pressure p; g is the rms gradient, α = m₀m₄/m₂², ψ = √(σ_z/w_c). Isotropic periodic surfaces of asperity::bem::RandomSurface: {pixels} × {pixels} pixels, shortest wave {PIXELS_PER_WAVE} pixels, longest {longest} of the side, Hurst exponent {hurst}, seeds 1 to {seeds}. AT as printed leaves the frame where its force decreases on approach."
    );
    let caveats = "At p/(E g) = 10⁻³ a surface has few contact patches, and the span is wide. In boundary elements the pressure is capped at H: a contact yields at a Hertz peak pressure of H, in the models at S·H = 0.577 H, so that yield starts a little later at the same ψ. This is a reference for a constant mean pressure H, not for elastic-plastic finite elements. The models use only m₀, m₂ and m₄ of the surface. JG cosine, the other readings of AT and the other random asperities are in crates/asperity/data/truth.csv.";
    let mut figure = Figure::new(title, &[&how, caveats, MARKERS], panels);
    figure.columns = 3;
    Ok(figure)
}
