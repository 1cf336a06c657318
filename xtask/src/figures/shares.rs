//! The shares of the regimes in the force of the AT model.

use anyhow::Result;
use asperity::{Model, Quantity, Request, linspace};

use super::models::{self, INPUTS, MARKERS};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel};

const READINGS: [(&str, &str); 2] =
    [("at", "as printed: shares are signed"), ("at-additive", "additive reading")];
const PARTS: [(&str, &str); 4] = [
    ("elastic", "elastic (y < 1)"),
    ("elastic-plastic 1", "ep1 (1 < y < 6)"),
    ("elastic-plastic 2", "ep2 (6 < y < 110)"),
    ("plastic", "plastic (y > 110)"),
];

/// Shares of the force for two readings.
pub fn table() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let std = scene.surface.asperity_height_std;
    let mut table = Table::new(&["reading", "curve", "separation_m", "share_of_force"]);
    for (id, _) in READINGS {
        let model: Model = id.parse()?;
        let compiled = model.compile(&scene, &Request::new([Quantity::Force]))?;
        let separations = linspace(0.0, 4.0, 201);
        let shares = separations
            .iter()
            .map(|s| compiled.shares(Quantity::Force, *s))
            .collect::<Result<Vec<_>, _>>()?;
        for (part, _) in PARTS {
            for (s, shares) in separations.iter().zip(&shares) {
                for share in shares.iter().filter(|share| share.name == part) {
                    let (at, share) = (Field::Number(s * std), Field::Number(share.share));
                    table.push(&[Field::Word(id), Field::Word(part), at, share])?;
                }
            }
        }
    }
    Ok(table)
}

/// Signed lines for the printed reading, stacked areas for the additive one.
pub fn style(_: &str) -> Result<Figure> {
    let panels = READINGS.map(|(id, title)| {
        let x = Axis::new("separation_m", "separation d (µm)").times(1e6);
        let mut panel = Panel::new(x, Axis::new("share_of_force", "share of the force"));
        panel.only = Some(("reading".into(), id.into()));
        panel.title = title.into();
        panel.curves =
            PARTS.iter().enumerate().map(|(k, (key, label))| Curve::new(k, key, label)).collect();
        panel.stacked = id == "at-additive";
        if !panel.stacked {
            panel.horizontals = vec![Mark::new(0.0, "")];
        }
        panel
    });
    let caption = format!(
        "y is the contact-normal interference over w_c, ep1 and ep2 are the elastic-plastic ranges. Shares sum to 1; the printed sum subtracts the range 1 < y < 6. {INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm."
    );
    Ok(Figure::new("Regimes of the AT model's force", &[&caption, MARKERS], panels.to_vec()))
}
