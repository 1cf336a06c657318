//! The report of a measured surface: its map, and its curves.

use asperity_topography::{Glance, MaterialRatio, Parameters, Topography};

use crate::canvas::{Type, picture};
use crate::draw;
use crate::error::PlotError;
use crate::figure::{Axis, Figure, Mark, Panel};
use crate::layout::Layout;
use crate::map::{Map, Placed, check};
use crate::panel::plots;
use crate::size::{LABEL, WIDTH};
use crate::style::{BLACK, Curve};
use crate::text::{CAPITAL, legible, number};

/// The most points of the map on a side, in a picture of its own and on a page.
const MAP: [usize; 2] = [800, 400];
/// Place of the map beside the left edge of its panel, and room for its bar of colours.
const OUT: f64 = 44.0;
const BAR: f64 = 92.0;
/// Colours end at so many standard deviations.
const SPREAD: f64 = 4.0;

/// Draws a levelled and filtered surface with its report: its map, the density of its heights,
/// spectra, slope and curvature against scale; returns the text of an svg. With a title, it has a
/// [caption](caption_of_surface) as well; without one, the page around it has.
///
/// # Errors
/// The errors of [`draw`](crate::draw) and [`draw_map`](crate::draw_map).
pub fn draw_surface(
    surface: &Topography,
    glance: &Glance,
    title: Option<&str>,
) -> Result<String, PlotError> {
    let csv = surface.curves_csv(glance);
    let (heights, columns) = surface.coarse(MAP[usize::from(title.is_none())]);
    let [dx, dy] = surface.pixel_size();
    let size = [surface.columns() as f64 * dx, surface.rows() as f64 * dy];
    let there = || heights.iter().copied().filter(|z| !z.is_nan());
    let n = there().count().max(1) as f64;
    let mean = there().sum::<f64>() / n;
    let wide = SPREAD * (there().map(|z| (z - mean).powi(2)).sum::<f64>() / n).sqrt();
    let lowest = there().fold(f64::INFINITY, f64::min);
    let highest = there().fold(f64::NEG_INFINITY, f64::max);
    // Spikes would leave one colour for all else.
    let (low, high) = (lowest.max(mean - wide), highest.min(mean + wide));
    let (height, of_height) = legible(high - low, "m");
    let (length, of_length) = legible(size[0].max(size[1]) / 10.0, "m");
    let white = if heights.iter().any(|z| z.is_nan()) { "blank: missing" } else { "" };
    let map = Map {
        values: heights.iter().map(|z| z / height).collect(),
        columns,
        size: size.map(|side| side / length),
        unit: of_length,
        label: format!("height ({of_height})"),
        top: high / height,
        bottom: Some(low / height),
        white: white.into(),
        ..Map::default()
    };
    check(&map)?;
    let mut figure = figure(glance, &csv, height, &of_height);
    if let Some(title) = title {
        // Underscores of file names lower no letters.
        figure.title = title.replace('_', "_\u{200b}");
        figure.caption = caption_of_surface(surface, glance);
    }
    if low > lowest || high < highest {
        let text =
            format!("Colours of the map end at {SPREAD} standard deviations of the heights.");
        figure.caption.push(text);
    }
    let plots = plots(&figure, &csv)?;
    let layout = Layout::new(&figure, &plots);
    picture(&figure.title, (WIDTH, layout.height), |canvas| {
        layout.draw(canvas);
        let mut each = plots.iter().zip(&layout.frames);
        if let Some((plot, frame)) = each.next() {
            let room = [frame.width() + OUT - BAR, frame.height()];
            Placed::new(&map, (frame.left - OUT, frame.top), room).draw(canvas)?;
            let top = frame.top - plot.above() + CAPITAL * LABEL;
            let face = Type { bold: true, ..Type::new(LABEL, BLACK, "start") };
            canvas.text("(a) map", (frame.left - OUT, top), face);
        }
        each.try_for_each(|(plot, frame)| plot.draw(canvas, frame))
    })
}

/// Draws the material ratio curve of a surface from its csv, with the secant of least slope, the
/// line of the core and its ends; of a profile with the names of profiles.
///
/// # Errors
/// The errors of [`draw`](crate::draw).
pub fn draw_material_ratio(
    curve: &MaterialRatio,
    is_profile: bool,
    title: &str,
) -> Result<String, PlotError> {
    let csv = curve.csv();
    let [sk, spk, svk, smr1, smr2, ..] = curve.functional();
    let (height, of_height) = legible(curve.height(0.0) - curve.height(1.0), "m");
    let x = Axis::new("material_ratio", "material ratio (%)").times(100.0).range(0.0, 1.0);
    let y = Axis::new("height_m", &format!("height above the mean ({of_height})"));
    let mut panel = Panel::new(x, y.times(1.0 / height));
    let secant =
        Curve { every_point: true, ..Curve::new(1, "secant", "secant of least slope over 40 %") };
    let core = Curve::new(2, "core", "line of the core");
    panel.curves = vec![Curve::new(0, "curve", "material ratio curve"), secant, core];
    let letter = if is_profile { "R" } else { "S" };
    let mark = |name: &str, share: f64| {
        Mark::new(share, &format!("{letter}{name} {:.1} %", 100.0 * share))
    };
    panel.verticals = vec![mark("mr1", smr1), mark("mr2", smr2)];
    let [sk, spk, svk] = [sk, spk, svk].map(said);
    let caption = format!(
        "{letter}k = {sk}, {letter}pk = {spk}, {letter}vk = {svk}. The line of the core is fitted by least squares to the points under the secant; the curve has its heights at 0 and 100 % at {letter}mr1 and {letter}mr2."
    );
    draw(&Figure::new(&title.replace('_', "_\u{200b}"), &[&caption], vec![panel]), &csv)
}

/// Sentences below the picture of a surface.
#[must_use]
pub fn caption_of_surface(surface: &Topography, glance: &Glance) -> Vec<String> {
    let Parameters { sq, ssk, sku, .. } = glance.parameters;
    let [dx, dy] = surface.pixel_size().map(said);
    let (columns, rows) = (surface.columns(), surface.rows());
    let missing = 100.0 * surface.missing_share();
    let (filter, sq) = (&glance.filter, said(sq));
    let mut first = format!(
        "{columns} x {rows} points, {dx} x {dy} apart; {filter}; {missing:.2} % missing. Sq = {sq}, Ssk = {ssk:.2}, Sku = {sku:.2}."
    );
    if let Some((ratio, lay)) = glance.texture.and_then(|lay| Some((lay.ratio()?, lay.direction))) {
        first += &format!(
            " Rms slope across the lay over that along it: {ratio:.2}; lay at {lay:.0}° from the rows."
        );
    }
    let law = match &glance.power_law {
        Ok(law) if law.roll_off.or(law.cut_off).is_some() => Some(
            "Dashed in the radial spectrum: the wavelengths between which the power law holds."
                .into(),
        ),
        Err(reason) if !surface.is_profile() => Some(format!("No power law is drawn: {reason}.")),
        _ => None,
    };
    std::iter::once(first).chain(law).collect()
}

/// A length with three digits.
fn said(length: f64) -> String {
    let (of, name) = legible(length, "m");
    let digits = format!("{:.2e}", length / of).parse().map_or(String::new(), number);
    format!("{digits} {name}")
}

/// The panels of the csv, after one that keeps the place of the map.
fn figure(glance: &Glance, csv: &str, height: f64, of_height: &str) -> Figure {
    let has = |start: &str| csv.lines().any(|line| line.starts_with(start));
    let lines: &[_] = &[(2, "rows", "along rows"), (3, "columns", "along columns")];
    let law = glance.power_law.as_ref().ok();
    let name = law.map(|law| format!("power law, H = {:.2}", law.hurst)).unwrap_or_default();
    let distance = || Axis::new("x", "distance (µm)").times(1e6).log();
    let wave_number = || Axis::new("x", "wave number (rad/µm)").times(1e-6).log();
    let of_height = format!("height ({of_height})");
    let panels = [
        (
            ("histogram", "density of heights"),
            Axis::new("x", &of_height).times(1.0 / height),
            "density (1/m)",
            &[(0, "heights", "heights"), (1, "gaussian", "Gaussian of the same Sq")][..],
        ),
        (
            ("radial", "radial spectrum"),
            wave_number(),
            "C (m⁴)",
            &[(0, "radial", "radial spectrum"), (4, "law", &*name)],
        ),
        (("axial", "spectra of profiles"), wave_number(), "C (m³)", lines),
        (("slope", "slope against scale"), distance(), "rms slope", lines),
        (("curvature", "curvature against scale"), distance(), "rms curvature (1/m)", lines),
    ];
    let mut place =
        Panel::new(Axis::new("x", "").range(0.0, 1.0), Axis::new("y", "").range(0.0, 1.0));
    place.only = Some(("panel".into(), String::new()));
    let mut figure = Figure::new("", &[], vec![place]);
    figure.columns = 2;
    for ((key, title), x, y, all) in panels {
        if !has(&format!("{key},")) {
            continue;
        }
        let mut panel = Panel::new(x, Axis::new("y", y).log());
        panel.title = title.into();
        panel.only = Some(("panel".into(), key.into()));
        for (look, curve, label) in all {
            if has(&format!("{key},{curve},")) {
                let mut curve = Curve::new(*look, curve, label);
                curve.every_point = matches!(key, "slope" | "curvature");
                panel.curves.push(curve);
            }
        }
        if let ("radial", Some(law)) = (key, law) {
            let mark = |length: f64| Mark::new(std::f64::consts::TAU / length, &said(length));
            panel.verticals = law.roll_off.into_iter().chain(law.cut_off).map(mark).collect();
        }
        figure.panels.push(panel);
    }
    figure
}

#[cfg(test)]
mod tests {
    use asperity_topography::Level;

    use super::*;

    /// Waves on 48 x 32 points, one of them missing, and one high spike.
    fn surface() -> Topography {
        let height = |k: usize| match k {
            99 => f64::NAN,
            777 => 5e-6,
            k => 1e-7 * ((0.7 * (k % 48) as f64).sin() + (0.4 * (k / 48) as f64).cos()),
        };
        Topography::new((0..48 * 32).map(height).collect(), 48, [1e-6; 2]).unwrap()
    }

    fn drawn(surface: &Topography, title: Option<&str>) -> Result<String, PlotError> {
        let glance = Glance::new(surface, Level::None, [None; 2], surface).unwrap();
        draw_surface(surface, &glance, title)
    }

    #[test]
    fn map_panels_marks_and_legend_are_drawn() {
        let svg = drawn(&surface(), Some("a_1 scan")).unwrap();
        for word in [
            "a_\u{200b}1 scan",
            "(a) map",
            ">10 µm<",
            "height (nm)",
            "blank: missing",
            "rad/µm",
            "along rows",
            "rms curvature",
            "48 x 32 points",
            "4 standard deviations",
        ] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(svg.contains("<image ") && !svg.contains("NaN") && !svg.contains("inf"));
        assert!(svg == drawn(&surface(), Some("a_1 scan")).unwrap());
        assert!(!drawn(&surface(), None).unwrap().contains("48 x 32 points"));
    }

    #[test]
    fn the_radial_spectrum_has_its_law_and_its_marks() {
        let surface = surface();
        let mut glance = Glance::new(&surface, Level::None, [None; 2], &surface).unwrap();
        let wave_number: Vec<f64> = (0..32).map(|k| 1e5 * 2f64.powf(f64::from(k) / 4.0)).collect();
        let mut spectra = glance.spectra.clone().unwrap();
        let mut radial = spectra.radial.clone().unwrap();
        radial.density = wave_number.iter().map(|q| (q / 4e5).max(1.0).powf(-3.6)).collect();
        radial.wave_number = wave_number;
        glance.power_law = asperity_topography::PowerLaw::fit(&radial);
        spectra.radial = Some(radial);
        glance.spectra = Some(spectra);
        let svg = draw_surface(&surface, &glance, None).unwrap();
        assert!(svg.contains("power law, H = 0.80") && svg.contains(">15.7 µm<"));
    }

    #[test]
    fn the_material_ratio_curve_has_its_secant_and_its_marks() {
        let curve = surface().material_ratio().unwrap();
        for (is_profile, names) in
            [(false, ["Smr1", "Smr2", "Sk ="]), (true, ["Rmr1", "Rmr2", "Rk ="])]
        {
            let svg = draw_material_ratio(&curve, is_profile, "a_1 scan").unwrap();
            assert!(names.iter().all(|name| svg.contains(name)), "{svg}");
            assert!(
                svg.contains("material ratio (%)") && svg.contains("height above the mean (µm)")
            );
            assert!(svg.contains("secant of least slope over 40 %") && !svg.contains("NaN"));
        }
    }

    #[test]
    fn panels_without_rows_are_left_out() {
        let profile = Topography::new(surface().heights()[..48].to_vec(), 48, [1e-6; 2]).unwrap();
        let svg = drawn(&profile, None).unwrap();
        assert!(!svg.contains("radial") && svg.contains("along rows"));
    }
}
