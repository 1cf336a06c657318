//! A table for a Reynolds code: contact pressure, area fraction and flow factors against the film.

use asperity::recommended::FLOW;
use asperity::{
    At, Contact, ContactError, ContactModel, Datum, Quantity, Request, Separation, SeparationUnit,
    linspace, shortest_digits,
};

use super::Export;
use super::text::filled;
use crate::number::rounded;
use crate::subject::Outcome;
use crate::{Cell, Sheet};

/// Quantities of the contact.
const OF_CONTACT: [Quantity; 2] = [Quantity::Pressure, Quantity::AreaFraction];

impl Export<'_> {
    /// The table at films of equal distances; fills a sheet in SI units.
    pub(super) fn film_text(&self, sheet: &mut Sheet) -> Outcome<String> {
        let (file, units) = (self.subject.file, self.units.units());
        let request = Request::new(OF_CONTACT).within(self.subject.tolerance);
        let contact = self.subject.model.compile(&file.scene, &request)?;
        // That of both surfaces, for models of pairs.
        let scene = contact.scene();
        let factors = Quantity::ALL.into_iter().filter(|quantity| quantity.is_flow_factor());
        let flow = file.model(FLOW)?.compile(scene, &Request::new(factors))?;
        let (ratio, mean) = (SeparationUnit::SurfaceStd, Datum::SurfaceMean);
        let lambda = |at: At| {
            let separation = contact.separation(at)?.measured_in(ratio, mean, scene)?;
            Ok::<_, ContactError>(separation.value)
        };
        let mut ends = [lambda(self.ends[0])?, lambda(self.ends[1])?];
        ends.sort_by(f64::total_cmp);
        let columns = || {
            [&*contact, &*flow]
                .into_iter()
                .flat_map(|of| of.quantities().iter().map(move |quantity| (of, *quantity)))
        };
        let names = columns().map(|(_, quantity)| quantity.column());
        sheet.heads = ["film_m".into(), "lambda".into()].into_iter().chain(names).collect();
        let sigma = scene.surface_height_std();
        let mut text = self.film_head(sigma)?;
        text += &sheet
            .heads
            .join(",")
            .replace("film_m", &format!("film_{}", units.length))
            .replace("_Pa", &format!("_{}", units.pressure));
        text.push('\n');
        for lambda in linspace(ends[0], ends[1], self.nodes.max(2)) {
            let at = At::from(Separation::film_ratio(lambda));
            let value = |(of, quantity): (&dyn Contact, Quantity)| match of.evaluate(quantity, at) {
                Ok(value) => Ok(Some(value.value())),
                // Outside of the range of a fit.
                Err(ContactError::OutOfRange { .. }) if quantity.is_flow_factor() => Ok(None),
                Err(error) => Err(error),
            };
            let values = columns().map(value).collect::<Result<Vec<_>, _>>()?;
            let film = lambda * sigma;
            let scales = [units.per_metre, 1.0, 1.0 / units.pascals].into_iter();
            let numbers = [Some(film), Some(lambda)].into_iter().chain(values);
            let row: Vec<Option<f64>> = numbers.collect();
            let scaled = row.iter().zip(scales.chain(std::iter::repeat(1.0)));
            let cells =
                scaled.map(|(x, scale)| x.map_or(String::new(), |x| shortest_digits(x * scale)));
            text += &(cells.collect::<Vec<_>>().join(",") + "\n");
            sheet.rows.push(row.into_iter().map(Cell::from).collect());
        }
        Ok(text)
    }

    /// The comments at the head of the table.
    fn film_head(&self, sigma: f64) -> Outcome<String> {
        let (file, units) = (self.subject.file, self.units.units());
        let (scene, length) = (&file.scene, units.per_metre);
        let asperity::Surface { asperity_radius, asperity_density, asperity_height_std, .. } =
            scene.surface;
        let flow = file.flow(&file.options)?;
        let [moving, resting] = flow.peklenik_numbers;
        let title = format!("asperity {}, model {}", env!("CARGO_PKG_VERSION"), self.subject.id);
        let numbers = [
            ("eta", asperity_density / length.powi(2)),
            ("beta", asperity_radius * length),
            ("sigma", sigma * length),
            ("product", asperity_density * asperity_radius * sigma),
            ("sigma_z", asperity_height_std * length),
            ("modulus", scene.interface.equivalent_modulus / units.pascals),
            ("moving", moving),
            ("resting", resting),
            ("share", flow.share_at_rest),
        ];
        let numbers = numbers.map(|(name, value)| (name, rounded(value)));
        let conversion = units.conversion(0, "#");
        let texts = [
            ("title", &*title),
            ("converted", &conversion),
            ("length", units.length),
            ("stress", units.pressure),
        ];
        let blanks: Vec<(&str, &str)> = texts
            .into_iter()
            .chain(numbers.iter().map(|(name, value)| (*name, &**value)))
            .collect();
        Ok(filled(include_str!("forms/film.txt"), &blanks))
    }
}
