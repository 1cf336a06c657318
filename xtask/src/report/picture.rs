//! The two pictures, each from the text of its csv.

use anyhow::Result;

use super::hard::BEFORE;
use super::sheet::{Sheet, worse};
use crate::draw::{
    Along, Arrangement, Axis, Band, Cell, Colour, CurveStyle, Dash, Figure, Legend, Marker, Matrix,
    Panel, Shape, draw, draw_matrix,
};

/// Errors above this have no digit worth the name.
const WRONG: f64 = 1e-2;
/// The ends of the axis; what is beyond stands at the end. Names have room at the right.
const ERRORS: (f64, f64) = (1e-16, 1e4);

/// How each method is drawn.
const METHODS: [(&str, Marker, Colour); 10] = [
    ("compiled", Marker::filled(Shape::Circle), Colour::BLACK),
    ("rule", Marker::filled(Shape::Square), Colour::BLUE),
    ("gauss-kronrod", Marker::open(Shape::Diamond), Colour::VERMILLION),
    ("tanh-sinh", Marker::filled(Shape::Triangle), Colour::GREEN),
    ("gauss-legendre-split", Marker::open(Shape::Nabla), Colour::INDIGO),
    ("gauss-legendre-64", Marker::open(Shape::Square), Colour::WINE),
    ("trapezoid-1001", Marker::open(Shape::Plus), Colour::WINE),
    ("simpson", Marker::open(Shape::Cross), Colour::WINE),
    ("scipy", Marker::open(Shape::Circle), Colour::DARK_GREY),
    ("gsl", Marker::filled(Shape::Diamond), Colour::GREY),
];

/// Whose rows are summed up in which panel.
const PANELS: [(&str, &str, &[&str]); 2] = [
    ("upright", "asperities upright: GW to AF", &[]),
    ("angles", "normals spread over angles: Gao, AT", &["gao", "at", "at-additive", "at-overlap"]),
];

/// The panel of a model.
fn panel_of(model: &str) -> &'static str {
    PANELS.iter().find(|panel| panel.2.contains(&model)).map_or(PANELS[0].0, |panel| panel.0)
}

/// Median of times against worst of errors, for each method and setting over all models and
/// quantities of a panel: `panel,method,error,time`.
fn summary(csv: &str) -> Result<String> {
    let sheet = Sheet::new(csv);
    let [model, quantity, method, tolerance, time, error] =
        ["model", "quantity", "method", "tolerance", "median_ns", "max_relative_error"]
            .map(|name| sheet.column(name));
    let (model, quantity, method, tolerance, time, error) =
        (model?, quantity?, method?, tolerance?, time?, error?);
    // A method without a tolerance is told apart by how many of its rows came before.
    let mut groups: Vec<([String; 3], &str, Vec<f64>)> = vec![];
    let mut before = (String::new(), 0);
    for row in sheet.rows() {
        let own = format!("{} {} {}", row[model], row[quantity], row[method]);
        before = if before.0 == own { (own, before.1 + 1) } else { (own, 0) };
        let setting = match row[tolerance] {
            "" => before.1.to_string(),
            tolerance => tolerance.to_owned(),
        };
        if row[error].is_empty() {
            continue;
        }
        let key = [panel_of(row[model]).to_owned(), row[method].to_owned(), setting];
        let number: f64 = row[time].parse()?;
        match groups.iter_mut().find(|group| group.0 == key) {
            Some((_, worst, times)) => {
                *worst = worse(worst, row[error]);
                times.push(number);
            }
            None => groups.push((key, row[error], vec![number])),
        }
    }
    let mut text = String::from("panel,method,error,time\n");
    for ([panel, method, _], worst, mut times) in groups {
        // A word has no place on the axis: the table says it.
        let Ok(worst) = worst.parse::<f64>() else { continue };
        times.sort_by(f64::total_cmp);
        let (worst, median) = (worst.clamp(ERRORS.0, ERRORS.1), times[times.len() / 2]);
        text.push_str(&format!("{panel},{method},{worst:e},{median:e}\n"));
    }
    Ok(text)
}

/// Time against error at a glance.
///
/// # Errors
/// A csv that is not `speed-vs-error.csv`.
pub fn frontier(csv: &str, machine: &str) -> Result<String> {
    let summary = summary(csv)?;
    let sheet = Sheet::new(&summary);
    let drawn = |panel: &str, method: &str| {
        sheet.rows().iter().any(|row| row[0] == panel && row[1] == method)
    };
    let mut panels = vec![];
    for (key, title, _) in PANELS {
        let x = Axis::new("error", "worst relative error on the hard grid").log();
        let y = Axis::new("time", "median time of an evaluation (ns)").log();
        let mut panel = Panel::new(x.range(ERRORS.0, ERRORS.1), y.range(10.0, 2e6));
        panel.title = title.into();
        panel.curve_column = "method".into();
        panel.only = Some(("panel".into(), key.into()));
        panel.legend = Legend::Direct;
        panel.bands = vec![Band::new(Along::X, WRONG, f64::INFINITY, "wrong")];
        for (method, marker, colour) in METHODS {
            if drawn(key, method) {
                let line = CurveStyle {
                    line: Some(Dash::Solid),
                    marker: None,
                    colour: colour.tint(0.5),
                    ..CurveStyle::points(method, "", marker, colour)
                };
                panel.curves.push(line);
            }
        }
        for (method, marker, colour) in METHODS {
            if drawn(key, method) {
                panel.curves.push(CurveStyle::points(method, method, marker, colour));
            }
        }
        if !panel.curves.is_empty() {
            panels.push(panel);
        }
    }
    let figure = Figure {
        title: "Time against error of a height integral".into(),
        caption: vec![
            "A marker is one setting of a method: the median of its times over all models and quantities of the panel, and the worst of its errors. Times on d/σ_z from -1 to 6 and w_c/σ_z from 0.003 to 3; errors on the hard cases with Gaussian heights, d/σ_z from -3 to 40 and w_c/σ_z from 10⁻⁸ to 10⁴, relative to the sum of the sizes of signed parts. Settings that do not converge somewhere are not drawn; scipy and gsl have the laws that are sums of powers.".into(),
            "gauss-legendre-64, trapezoid-1001 and simpson are what published scripts do, in plain doubles and blind to the kinks of the law; the other classical methods are scaled against underflow and split at the kinks. Laws of Gao and AT are sampled from their tables.".into(),
            format!("{machine}."),
        ],
        panels,
        arrangement: Arrangement::Stacked,
        allow_undrawn: false,
        ..Figure::default()
    };
    draw(&figure, &summary)
}

/// Where each method breaks: families down, methods across.
///
/// # Errors
/// A csv that is not `hard-cases.csv`.
pub fn hard_cases(csv: &str) -> Result<String> {
    let sheet = Sheet::new(csv);
    let family = sheet.column("family")?;
    let methods: Vec<(usize, &str)> =
        sheet.head().iter().copied().enumerate().skip(BEFORE.len()).collect();
    let mut families = sheet.values("family")?;
    families.sort_by_key(|name| *name != super::cases::ORDINARY);
    let mut cells = vec![];
    for name in &families {
        let rows: Vec<_> = sheet.rows().iter().filter(|row| row[family] == *name).collect();
        let cell = |(column, _): &(usize, &str)| {
            cell(rows.iter().map(|row| row[*column]).filter(|error| !error.is_empty()).collect())
        };
        cells.push(methods.iter().map(cell).collect());
    }
    let matrix = Matrix {
        title: "Where each method breaks: worst relative error".into(),
        caption: vec![
            "Below it, in how many cases of the family the error is above 10⁻⁶ or there is no number. “zero”: 0 for what is not 0; “not-converged”: the method says so itself. Errors are relative to the sum of the sizes of signed parts, against references computed another way. “Ordinary” are three scenes of engineering surfaces; their references for Gao and AT hold 5·10⁻¹³.".into(),
            "Asked of compiled, rule, gauss-kronrod, tanh-sinh, scipy and gsl: 10⁻¹⁰; gauss-legendre-split has 128 points between kinks. These are scaled and split at the kinks; gauss-legendre-64, trapezoid-1001 and simpson are what published scripts do. scipy and gsl have the laws that are sums of powers.".into(),
        ],
        columns: methods.iter().map(|(_, name)| (*name).to_owned()).collect(),
        rows: families.iter().map(|name| (*name).to_owned()).collect(),
        cells,
    };
    draw_matrix(&matrix)
}

/// Errors above this count as off.
const OFF: f64 = 1e-6;

fn cell(errors: Vec<&str>) -> Cell {
    let Some(worst) = errors.iter().copied().reduce(worse) else {
        return Cell { text: "–".into(), ..Cell::default() };
    };
    let off = |error: &&&str| error.parse::<f64>().map_or(true, |error| error > OFF);
    let note = format!("{} of {}", errors.iter().filter(off).count(), errors.len());
    let Ok(number) = worst.parse::<f64>() else {
        return Cell { text: worst.to_owned(), note, shade: 1.0 };
    };
    // White at 1e-14, dark at 1, and light for long: half way up there are still seven digits.
    let shade = ((number.max(1e-300).log10() + 14.0) / 14.0).clamp(0.0, 1.0);
    Cell { text: typeset(worst), note, shade: 0.9 * shade.powf(1.4) }
}

/// `1.5e-7` as 1.5·10⁻⁷.
fn typeset(number: &str) -> String {
    let Some((digits, exponent)) = number.split_once('e') else { return number.to_owned() };
    match exponent.parse() {
        Ok(0) | Err(_) => digits.to_owned(),
        Ok(exponent) => format!("{digits}·{}", crate::draw::power_of_ten(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "model,quantity,method,tolerance,median_ns,max_relative_error,evaluations
ke,force,compiled,1e-3,30,1e-6,4
ke,force,compiled,1e-5,40,1e-8,8
ke,force,gauss-legendre-split,,900,1e-3,48
ke,force,gauss-legendre-split,,1800,1e-5,96
ke,force,build-law,1e-3,900,,
jg,force,compiled,1e-3,60,2e-5,4
jg,force,compiled,1e-5,50,not-converged,8
jg,force,gauss-legendre-split,,700,1e-2,48
jg,force,gauss-legendre-split,,1900,1e-6,96
";

    #[test]
    fn a_marker_is_the_median_time_and_the_worst_error_of_one_setting() -> Result<()> {
        let expected = "panel,method,error,time
upright,compiled,2e-5,6e1
upright,gauss-legendre-split,1e-2,9e2
upright,gauss-legendre-split,1e-5,1.9e3
";
        assert_eq!(summary(CSV)?, expected);
        let svg = frontier(CSV, "a machine")?;
        assert!(svg.contains("gauss-legendre-split") && svg.contains("a machine."));
        Ok(())
    }

    #[test]
    fn a_cell_tells_the_worst_and_how_many_are_off() {
        let number = cell(vec!["1.0e-12", "2.5e-3", "1.0e-14"]);
        assert_eq!((&*number.text, &*number.note), ("2.5·10⁻³", "1 of 3"));
        let failure = cell(vec!["zero", "2.5e-3", "1.0e-14"]);
        assert_eq!((&*failure.text, &*failure.note), ("zero", "2 of 3"));
        assert!(failure.shade > number.shade && number.shade > cell(vec!["1.0e-12"]).shade);
        assert_eq!(cell(vec![]).text, "–");
    }
}
