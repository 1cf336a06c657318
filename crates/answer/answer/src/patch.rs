//! The patch of curved bodies: pressures, separations and area fractions at its points.

use asperity::{Quantity, Tolerance};
use asperity_scene::SceneFile;

use crate::{AnswerError, Cell, Sheet};

/// Points with less pressure, over its peak, are left out.
const LEAST: f64 = 1e-6;

/// The patch at a load \[N\]: all points with their pressure, Hertz' pressure, separation from the
/// mean of the asperity heights, area fraction and tangential flexibility of the rough layer
/// \[m/(N/m²)\], which is to be added to that of the bodies; and the same along the axes of the
/// patch, beside Hertz' pressure, to be drawn.
///
/// # Errors
/// Flat bodies, and the errors of the contact. Without a shear modulus the flexibility is blank.
pub fn patch(
    file: &SceneFile,
    id: &str,
    load: f64,
    tolerance: Tolerance,
) -> Result<[Sheet; 2], AnswerError> {
    let asked = [Quantity::Area, Quantity::UnloadingStiffness];
    let curved = file.curved(id, &asked, tolerance)??;
    let found = curved.at_load(load)?;
    let [areas, stiffnesses] = [found.per_area(asked[0])?, found.per_area(asked[1])?];
    let interface = &file.scene.interface;
    // K_t = (4 G/E) K_u of the same contacts.
    let ratio = interface.equivalent_shear_modulus.map(|g| 4.0 * g / interface.equivalent_modulus);
    let (pressures, separations) = (found.pressures(), found.separations());
    let mut all = Sheet::new(&[
        "x_m",
        "y_m",
        "pressure_Pa",
        "hertz_pressure_Pa",
        "separation_m",
        "area_fraction",
        "tangential_flexibility_m3_per_N",
    ]);
    let mut axes = Sheet::new(&["contact", "distance_m", "pressure_Pa", "area_fraction"]);
    for (k, pressure) in pressures.iter().enumerate() {
        if *pressure < LEAST * found.peak_pressure() {
            continue;
        }
        let place = found.place(k);
        let hertz = found.hertz.pressure(place);
        let flexibility = ratio.map(|ratio| (ratio * stiffnesses[k]).recip());
        let numbers = [place[0], place[1], *pressure, hertz, separations[k], areas[k]];
        all.add(&[], numbers.map(Cell::from).into_iter().chain([flexibility.into()]));
        let is_line = found.grid().0[1] == 1;
        for (axis, name) in [(0, "x"), (1, "y")] {
            if place[1 - axis] == 0.0 && !(is_line && axis == 1) {
                let along = [place[axis], *pressure, areas[k]].map(Cell::from);
                axes.add(&[&format!("{id} along {name}")], along);
                let smooth = [place[axis].into(), hertz.into(), Cell::BLANK];
                axes.add(&[&format!("smooth (Hertz) along {name}")], smooth);
            }
        }
    }
    Ok([all, axes])
}
