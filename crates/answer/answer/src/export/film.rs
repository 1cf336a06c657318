//! A table for a Reynolds code: contact pressure, area fraction and flow factors against the film.

use asperity::film::{PatirCheng, not_gaussian};
use asperity::{
    Asperities, ContactError, ContactModel, Datum, Quantity, Request, Scene, Separation,
    SeparationUnit, Surface, linspace, shortest_digits,
};

use super::text::filled;
use super::{Export, Nodes};
use crate::number::rounded;
use crate::subject::Outcome;
use crate::{Cell, Sheet};

/// Quantities of the contact.
const OF_CONTACT: [Quantity; 2] = [Quantity::Pressure, Quantity::AreaFraction];

/// The words of the head, with their blanks.
const OF_PAIR: [(&str, &str); 4] = [
    ("surfaces", "both surfaces"),
    ("formula", "Greenwood & Tripp"),
    ("each", "each of two like surfaces"),
    ("together", "of both surfaces together"),
];
const OF_ONE: [(&str, &str); 4] = [
    ("surfaces", "the rough surface and a flat"),
    ("formula", "Greenwood & Williamson (one rough surface on a flat)"),
    ("each", "this surface"),
    ("together", "of this surface"),
];

impl Export<'_> {
    /// The table at films of equal distances, in SI units; fills a sheet with the same columns.
    pub(super) fn film_text(&self, sheet: &mut Sheet) -> Outcome<String> {
        if self.units.length != "m" {
            return Err("a table of films is in SI units".into());
        }
        let Nodes::Range { ends, count, max_error: None, .. } = self.nodes else {
            return Err("a table of films has equal distances and no --max-error: give a range with the number of its nodes".into());
        };
        let file = self.subject.file;
        let request = Request::new(OF_CONTACT).within(self.subject.tolerance);
        let contact = self.subject.model.compile(&file.scene, &request)?;
        // Of both surfaces, for models of pairs.
        let scene = contact.scene();
        let factors = Quantity::ALL.into_iter().filter(|quantity| quantity.is_flow_factor());
        let factors: Vec<Quantity> = factors.collect();
        let flow = file.flow(self.subject.model)?;
        sheet.report(file, not_gaussian(&file.scene.heights).into_iter().collect());
        // All fits hold at this film, so that an error is about the lay, and about every film.
        flow.factor(Quantity::PressureFlowFactorX, 3.0)?;
        // Blank outside of the range of a fit.
        let factor = |quantity: &Quantity, film: f64| match flow.factor(*quantity, film) {
            Ok(value) => Ok(Some(value.value())),
            Err(ContactError::OutOfRange { .. }) => Ok(None),
            Err(error) => Err(error),
        };
        let of_contact = |quantity: &Quantity, film: f64| {
            Ok(Some(contact.evaluate(*quantity, Separation::film_ratio(film))?.value()))
        };
        let lambda = |at| contact.separation_in(SeparationUnit::SurfaceStd, Datum::SurfaceMean, at);
        let [first, last] = [lambda(ends[0])?, lambda(ends[1])?];
        sheet.under(&[&["film_m", "lambda"]]);
        let columns = OF_CONTACT.iter().chain(&factors);
        sheet.heads.extend(columns.map(|quantity| quantity.column()));
        let mut text = self.film_head(scene, &flow) + &sheet.heads.join(",") + "\n";
        for film in linspace(first.min(last), first.max(last), count.max(2)) {
            let places = vec![Some(film * scene.surface_height_std()), Some(film)];
            let values = OF_CONTACT.iter().map(|quantity| of_contact(quantity, film));
            let values = values.chain(factors.iter().map(|quantity| factor(quantity, film)));
            let values = values.collect::<Result<Vec<_>, ContactError>>()?;
            let row = [places, values].concat();
            let cells = row.iter().map(|x| x.map_or(String::new(), shortest_digits));
            text += &(cells.collect::<Vec<_>>().join(",") + "\n");
            sheet.rows.push(row.into_iter().map(Cell::from).collect());
        }
        Ok(text)
    }

    /// The comments at the head of the table.
    fn film_head(&self, scene: &Scene, flow: &PatirCheng) -> String {
        let (each, words) = match self.subject.model.asperities() == Asperities::Pairs {
            // Models of pairs average over two like surfaces.
            true => (scene.both_surfaces().surfaces[0].asperities, OF_PAIR),
            false => (scene.surface, OF_ONE),
        };
        let Surface { asperity_radius: beta, asperity_density: eta, .. } = each;
        let sigma_z = scene.surface.asperity_height_std;
        let numbers = [
            ("eta", eta),
            ("beta", beta),
            ("sigma", scene.surface_height_std()),
            ("product", eta * beta * sigma_z),
            ("sigma_z", sigma_z),
            ("offset", scene.mean_plane_offset()),
            ("modulus", scene.interface.equivalent_modulus),
            ("share", flow.share_at_rest),
        ];
        let numbers = numbers.map(|(name, value)| (name, rounded(value)));
        let lay = |k: usize| match (rounded(flow.peklenik_numbers[k]), flow.lay_angles[k]) {
            (number, 0.0) => number,
            (number, angle) => format!("{number} (lay axes at {} degrees)", rounded(angle)),
        };
        let numbers = numbers.into_iter().chain([("moving", lay(0)), ("resting", lay(1))]);
        let numbers: Vec<(&str, String)> = numbers.collect();
        let blanks: Vec<(&str, &str)> =
            numbers.iter().map(|(name, value)| (*name, &**value)).collect();
        let form = filled(&filled(include_str!("forms/film.txt"), &words), &blanks);
        filled(&form, &[("title", &self.title()), ("converted", &self.origin("#", &[]))])
    }
}
