//! A map of numbers as an image, with a scale bar for its lengths and a bar of colours.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::canvas::{Canvas, Rect, Type, picture};
use crate::error::PlotError;
use crate::layout::{caption_lines, draw_caption, draw_title, lines_height};
use crate::size::{EDGE, LABEL, SMALL, TICK, TITLE, WIDTH};
use crate::style::BLACK;
use crate::text::{CAPITAL, LINE, number, stepped, wrap};

/// A map to be drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Map {
    /// A line above.
    pub title: String,
    /// Paragraphs below; each is wrapped.
    pub caption: Vec<String>,
    /// Row by row from the top; values of 0 and below, or with a `bottom` only those that are
    /// missing (NaN), are blank.
    pub values: Vec<f64>,
    /// Values in a row.
    pub columns: usize,
    /// Length of the rows and of the columns.
    pub size: [f64; 2],
    /// The unit of these lengths.
    pub unit: String,
    /// The quantity of the colours, with its unit.
    pub label: String,
    /// The value of the darkest colour; larger values have the same colour.
    pub top: f64,
    /// The value of the other end of the colours instead of 0, as for heights; then the darkest
    /// colour is there and `top` has the lightest.
    pub bottom: Option<f64>,
    /// What white means, below the bar of colours; empty for nothing.
    pub white: String,
    /// What values of the `top` and above mean, which then have a colour of their own; empty for
    /// none.
    pub full: String,
    /// Names of places in an svg, each in shares of the rows and of the columns from the top left.
    pub marks: Vec<(String, [f64; 2])>,
    /// Width in pixels of a small picture, whose letters keep their size.
    pub width: Option<f64>,
}

impl Map {
    /// The place of a value between the ends of the colours, from light to dark.
    fn share(&self, value: f64) -> f64 {
        match self.bottom {
            Some(bottom) => (self.top - value) / (self.top - bottom),
            None => value / self.top,
        }
    }
}

/// Longest and highest image.
const LARGEST: [f64; 2] = [620.0, 600.0];
/// The bar of colours.
const BAR: f64 = 18.0;
const BAR_GAP: f64 = 24.0;
/// Room of the numbers beside it.
const TICKS: f64 = 50.0;
/// From light to dark, distinct in grey and for colour-blind readers: the colours of `inferno`
/// (matplotlib, public domain) without the light end, which is too close to white.
const COLOURS: [[u8; 3]; 6] =
    [[252, 195, 65], [249, 140, 10], [221, 81, 58], [147, 38, 103], [66, 10, 104], [0, 0, 4]];

/// Unlike all of them: values that are full.
const FULL: [u8; 3] = [0, 158, 180];
/// Of marks: unlike all of them, too.
const MARK: &str = "#0050E0";
/// Rounding of a value that is full.
const FULLY: f64 = 1e-9;

/// Draws a map; returns the text of an svg.
///
/// # Errors
/// When the values do not fill whole rows, or when a length or the top of the colours is not
/// positive.
pub fn draw_map(map: &Map) -> Result<String, PlotError> {
    check(map)?;
    let (width, edge) = (map.width.unwrap_or(WIDTH), map.width.map_or(EDGE, |_| 0.0));
    let title = wrap(&map.title, TITLE, width - 2.0 * EDGE);
    let top = edge + title.len() as f64 * TITLE * LINE + 6.0;
    let beside = if map.label.is_empty() { TICKS } else { TICKS + LABEL * LINE };
    let room = width - 2.0 * edge - BAR_GAP - BAR - beside;
    let placed = Placed::new(map, (2.0 * edge, top), LARGEST.map(|side| side.min(room)));
    let caption = caption_lines(&map.caption);
    let caption_top = placed.below + 14.0 + LABEL * LINE + 12.0;
    picture(&map.title, (width, caption_top + lines_height(&caption) + EDGE), |canvas| {
        draw_title(canvas, &title);
        placed.draw(canvas)?;
        draw_caption(canvas, &caption, caption_top);
        Ok(())
    })
}

/// A map with its bars at a place in a picture.
pub(crate) struct Placed<'a> {
    map: &'a Map,
    frame: Rect,
    scale: f64,
    /// Where map and bar of colours end; a scale bar is below.
    below: f64,
}

impl<'a> Placed<'a> {
    /// A map with its top left corner at a point and at most so large, without its bars.
    pub(crate) fn new(map: &'a Map, (left, top): (f64, f64), largest: [f64; 2]) -> Self {
        let scale = (largest[0] / map.size[0]).min(largest[1] / map.size[1]);
        let frame = Rect::sized(left, top, map.size[0] * scale, map.size[1] * scale);
        Self { map, frame, scale, below: frame.bottom.max(top + 160.0) }
    }

    pub(crate) fn draw(&self, canvas: &Canvas) -> Result<(), PlotError> {
        let Self { map, frame, scale, below } = self;
        let image = format!("data:image/png;base64,{}", STANDARD.encode(pixels(map)?));
        canvas.image(frame, &image);
        canvas.outline(frame, BLACK, 1.0);
        for (k, (name, [along, down])) in map.marks.iter().enumerate() {
            let (x, y) = frame.at((*along, 1.0 - down));
            let around = Rect::sized(x - 6.0, y - 6.0, 12.0, 12.0);
            canvas.outline(&around, MARK, 2.5);
            // Names of one place stand below each other.
            let beside = (around.right + 3.0, y + k as f64 * TICK);
            canvas.text(name, beside, Type { bold: true, ..Type::new(TICK, MARK, "start") });
        }
        draw_scale_bar(canvas, map, *scale, (frame.left, below + 14.0));
        let bar = Rect::sized(frame.right + BAR_GAP, frame.top, BAR, below - frame.top);
        draw_colours(canvas, map, &bar);
        if !map.full.is_empty() {
            let swatch = Rect::sized(frame.left + 0.5 * frame.width(), below + 12.0, 12.0, 12.0);
            canvas.shape(&swatch.corners(), &hex(FULL), "");
            let baseline = (swatch.right + 6.0, swatch.bottom);
            canvas.text(&map.full, baseline, Type::new(TICK, BLACK, "start"));
        }
        Ok(())
    }
}

pub(crate) fn check(map: &Map) -> Result<(), PlotError> {
    if map.columns == 0 || map.values.is_empty() || !map.values.len().is_multiple_of(map.columns) {
        let rows = map.values.len().checked_div(map.columns).unwrap_or(0);
        return Err(PlotError::Cells { rows, columns: map.columns });
    }
    let low = map.bottom.unwrap_or(0.0);
    let lengths = map.size.map(|side| ("lengths", 0.0, side));
    for (axis, low, high) in lengths.into_iter().chain([(&*map.label, low, map.top)]) {
        if !(high > low && high.is_finite() && low.is_finite()) {
            let required = "a finite range from low (0, unless there is a bottom) to high";
            return Err(PlotError::Range { axis: axis.into(), low, high, required });
        }
    }
    Ok(())
}

/// A round length of at most a third of a row.
fn draw_scale_bar(canvas: &Canvas, map: &Map, scale: f64, (left, top): (f64, f64)) {
    let length = round(map.size[0] / 3.0);
    let right = left + length * scale;
    canvas.line(&[(left, top), (right, top)], BLACK, 3.0, &[]);
    let text = format!("{} {}", number(length), map.unit);
    let baseline = top + 6.0 + CAPITAL * TICK;
    canvas.text(&text, (left, baseline), Type::new(TICK, BLACK, "start"));
}

fn draw_colours(canvas: &Canvas, map: &Map, bar: &Rect) {
    let steps = 100;
    let low = map.bottom.unwrap_or(0.0);
    let range = map.top - low;
    for k in 0..steps {
        let share = |k: usize| k as f64 / steps as f64;
        let corners = [(0.0, share(k)), (1.0, share(k)), (1.0, share(k + 1)), (0.0, share(k + 1))];
        let corners = corners.map(|corner| bar.at(corner));
        let colour = hex(colour(map.share(low + range * share(k))));
        // Without gaps to its neighbours.
        canvas.shape(&corners, &colour, "shape-rendering=\"crispEdges\"");
    }
    canvas.outline(bar, BLACK, 1.0);
    let step = round(range / 3.0);
    let first = (low / step - 1e-4).ceil() as i64;
    let ticks = (first..).map(|k| k as f64 * step);
    for tick in ticks.take_while(|tick| *tick <= map.top + 1e-4 * range) {
        let (x, y) = bar.at((1.0, (tick - low) / range));
        canvas.line(&[(x, y), (x + 5.0, y)], BLACK, 1.0, &[]);
        let face = Type::new(TICK, BLACK, "start");
        canvas.text(&stepped(tick, step), (x + 8.0, y + 0.5 * CAPITAL * TICK), face);
    }
    let middle = (bar.right + 62.0, 0.5 * (bar.top + bar.bottom));
    let face = Type { upward: true, ..Type::new(LABEL, BLACK, "middle") };
    canvas.text(&map.label, middle, face);
    let below = (bar.left, bar.bottom + 14.0 + CAPITAL * SMALL);
    canvas.text(&map.white, below, Type::new(SMALL, BLACK, "start"));
}

/// The largest of 1, 2 and 5 times a power of ten up to a length.
fn round(most: f64) -> f64 {
    let power = 10f64.powf(most.log10().floor());
    [5.0, 2.0].into_iter().find(|k| k * power <= most).unwrap_or(1.0) * power
}

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// The colour of a share of the top, 0 to 1.
fn colour(share: f64) -> [u8; 3] {
    let at = share.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let k = (at as usize).min(COLOURS.len() - 2);
    let part = at - k as f64;
    std::array::from_fn(|c| {
        let [a, b] = [COLOURS[k][c], COLOURS[k + 1][c]].map(f64::from);
        (a + part * (b - a)).round() as u8
    })
}

/// The values as a png of one pixel each. Colour 0 is clear.
fn pixels(map: &Map) -> Result<Vec<u8>, PlotError> {
    // With a bottom the lowest heights have a colour too, and only missing ones have none.
    let least = map.bottom.map_or(0.0, |_| f64::MIN_POSITIVE);
    // Colour 0 is for values of 0 and below, and for missing ones.
    let most = if map.full.is_empty() { 254.0 } else { 253.0 };
    let shade = |value: &f64| match map.share(*value).max(least) {
        share if !map.full.is_empty() && share > 1.0 - FULLY => 255,
        share if share > 0.0 && !value.is_nan() => 1 + (share.min(1.0) * most).round() as u8,
        _ => 0,
    };
    let indices: Vec<u8> = map.values.iter().map(shade).collect();
    let shades = (0..255).flat_map(|k| colour(f64::from(k) / 254.0));
    let mut palette: Vec<u8> = [255; 3].into_iter().chain(shades).collect();
    if !map.full.is_empty() {
        palette.splice(765.., FULL);
    }
    let rows = map.values.len() / map.columns;
    let mut bytes = vec![];
    let failed = |error: png::EncodingError| PlotError::Drawing(error.to_string());
    let too_large = |_| PlotError::Cells { rows, columns: map.columns };
    let width = u32::try_from(map.columns).map_err(too_large)?;
    let mut encoder = png::Encoder::new(&mut bytes, width, u32::try_from(rows).map_err(too_large)?);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette(palette);
    encoder.set_trns(vec![0]);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&indices).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> Map {
        Map {
            title: "where it touches".into(),
            values: vec![0.0, 0.5, 1.0, f64::NAN, -1.0, 2.0],
            columns: 3,
            size: [3.0, 2.0],
            unit: "µm".into(),
            label: "pressure (GPa)".into(),
            top: 1.0,
            white: "white: no contact".into(),
            marks: vec![("neck".into(), [0.5, 0.25])],
            ..Map::default()
        }
    }

    #[test]
    fn maps_have_bars_and_labels() {
        let svg = draw_map(&map()).unwrap();
        for word in
            ["where it touches", ">1 µm<", "pressure (GPa)", "white: no contact", ">0.2<", ">neck<"]
        {
            assert!(svg.contains(word), "{word}");
        }
        assert!(svg.contains("<image ") && svg.contains("image-rendering=\"pixelated\""));
        // What has no colour shows the ground.
        assert!(svg.contains("<rect class=\"ground\" "));
        let png = svg.split("base64,").nth(1).and_then(|text| text.split('"').next()).unwrap();
        let bytes = STANDARD.decode(png).unwrap();
        assert!(bytes.windows(4).any(|part| part == b"tRNS"));
    }

    #[test]
    fn the_image_holds_the_values() {
        let bytes = super::pixels(&map()).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::IDENTITY);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; 6];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, [0, 128, 255, 0, 0, 255]);
        assert_eq!(reader.info().palette.as_ref().map(|all| all.len()), Some(768));
    }

    /// Relative luminance falls with the value, so the map can be read in grey.
    #[test]
    fn colours_darken_and_stand_off_white() {
        let light = |k: u8| {
            let linear = |c: u8| (f64::from(c) / 255.0).powf(2.2);
            let [red, green, blue] = colour(f64::from(k) / 254.0).map(linear);
            0.2126 * red + 0.7152 * green + 0.0722 * blue
        };
        assert!(light(0) < 0.65);
        assert!((1..255).all(|k| light(k) < light(k - 1)));
    }

    #[test]
    fn round_numbers_are_1_2_and_5() {
        for (most, found) in [(1.0, 1.0), (4.9, 2.0), (7.0, 5.0), (0.013, 0.01), (333.0, 200.0)] {
            assert!((round(most) / found - 1.0).abs() < 1e-12, "{most}");
        }
    }

    #[test]
    fn heights_have_colours_below_zero_and_missing_ones_are_white() {
        let values = vec![-1.0, 0.0, 1.0, f64::NAN, -3.0, 3.0];
        let heights = Map { bottom: Some(-1.0), values, white: "white: missing".into(), ..map() };
        let mut decoder = png::Decoder::new(std::io::Cursor::new(super::pixels(&heights).unwrap()));
        decoder.set_transformations(png::Transformations::IDENTITY);
        let mut pixels = vec![0; 6];
        decoder.read_info().unwrap().next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, [255, 128, 1, 0, 255, 1]);
        let svg = draw_map(&heights).unwrap();
        assert!(svg.contains(">−0.5<") && svg.contains(">0.0<") && svg.contains("missing"));
    }

    #[test]
    fn maps_with_unfit_rows_or_lengths_are_refused() {
        for wrong in [
            Map { columns: 4, ..map() },
            Map { columns: 0, ..map() },
            Map { size: [0.0, 1.0], ..map() },
            Map { top: f64::NAN, ..map() },
        ] {
            assert!(draw_map(&wrong).is_err());
        }
    }
}
