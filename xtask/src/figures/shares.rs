//! The shares of the regimes in the force of the AT model.

use anyhow::Result;
use asperity::{Model, Quantity, Request, linspace};
use asperity_plot::{Axis, Figure, Mark};

use super::models::{self, beside, named, of, panel, separation_axis};
use crate::table::Table;

const READINGS: [(&str, &str); 2] =
    [("at", "as printed: shares are signed"), ("at-additive", "additive reading")];
const PARTS: [(&str, usize, &str); 4] = [
    ("elastic", 0, "elastic (y < 1)"),
    ("elastic-plastic 1", 1, "ep1 (1 < y < 6)"),
    ("elastic-plastic 2", 2, "ep2 (6 < y < 110)"),
    ("plastic", 3, "plastic (y > 110)"),
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
        let shares = separations.iter().map(|s| compiled.shares(Quantity::Force, *s));
        let shares = shares.collect::<Result<Vec<_>, _>>()?;
        for (part, ..) in PARTS {
            for (s, shares) in separations.iter().zip(&shares) {
                for share in shares.iter().filter(|share| share.name == part) {
                    table.push(&[id, part], [s * std, share.share])?;
                }
            }
        }
    }
    Ok(table)
}

/// Signed lines for the printed reading, stacked areas for the additive one.
pub fn style(_: &str) -> Result<Figure> {
    let panels = READINGS.map(|(id, title)| {
        let y = Axis::new("share_of_force", "share of the force");
        let mut panel = of("reading", id, title, panel(&separation_axis(), y, &named(&PARTS)));
        panel.stacked = id == "at-additive";
        if !panel.stacked {
            panel.horizontals = vec![Mark::new(0.0, "")];
        }
        panel
    });
    Ok(beside(1, panels))
}
