//! A map of numbers as an image, with a scale bar for its lengths and a bar of colours.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::canvas::{Canvas, Rect, Type, picture};
use crate::error::PlotError;
use crate::layout::{caption_lines, draw_caption, draw_title, lines_height};
use crate::size::{EDGE, LABEL, SMALL, TICK, TITLE, WIDTH};
use crate::style::BLACK;
use crate::text::{CAPITAL, LINE, number, wrap};

/// A map to be drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Map {
    /// A line above.
    pub title: String,
    /// Paragraphs below; each is wrapped.
    pub caption: Vec<String>,
    /// Row by row from the top; values of 0 and below are white.
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
}

/// Longest and highest image.
const LARGEST: [f64; 2] = [620.0, 600.0];
/// The bar of colours.
const BAR: f64 = 18.0;
/// From light to dark, distinct in grey and for colour-blind readers: the colours of `inferno`
/// (matplotlib, public domain) without the light end, which is too close to white.
const COLOURS: [[u8; 3]; 6] =
    [[252, 195, 65], [249, 140, 10], [221, 81, 58], [147, 38, 103], [66, 10, 104], [0, 0, 4]];

/// Draws a map; returns the text of an svg.
///
/// # Errors
/// When the values do not fill whole rows, or when a length or the top of the colours is not
/// positive.
pub fn draw_map(map: &Map) -> Result<String, PlotError> {
    check(map)?;
    let scale = (LARGEST[0] / map.size[0]).min(LARGEST[1] / map.size[1]);
    let title = wrap(&map.title, TITLE, WIDTH - 2.0 * EDGE);
    let top = EDGE + title.len() as f64 * TITLE * LINE + 6.0;
    let frame = Rect::sized(2.0 * EDGE, top, map.size[0] * scale, map.size[1] * scale);
    let caption = caption_lines(&map.caption);
    let below = frame.bottom.max(top + 160.0);
    let caption_top = below + 14.0 + LABEL * LINE + 12.0;
    let image = format!("data:image/png;base64,{}", STANDARD.encode(pixels(map)?));
    picture(&map.title, (WIDTH, caption_top + lines_height(&caption) + EDGE), |canvas| {
        draw_title(canvas, &title);
        canvas.image(&frame, &image);
        canvas.outline(&frame, BLACK, 1.0);
        draw_scale_bar(canvas, map, scale, (frame.left, below + 14.0));
        draw_colours(canvas, map, &Rect::sized(frame.right + 24.0, top, BAR, below - top));
        draw_caption(canvas, &caption, caption_top);
        Ok(())
    })
}

/// The map alone, without lengths and colours beside it, as a png of one pixel a value.
///
/// # Errors
/// Those of [`draw_map`].
pub fn map_png(map: &Map) -> Result<Vec<u8>, PlotError> {
    check(map)?;
    pixels(map)
}

fn check(map: &Map) -> Result<(), PlotError> {
    if map.columns == 0 || map.values.is_empty() || !map.values.len().is_multiple_of(map.columns) {
        let rows = map.values.len().checked_div(map.columns).unwrap_or(0);
        return Err(PlotError::Cells { rows, columns: map.columns });
    }
    for (axis, high) in [("lengths", map.size[0]), ("lengths", map.size[1]), (&map.label, map.top)]
    {
        if !(high > 0.0 && high.is_finite()) {
            let required = "a range from 0 to a positive number";
            return Err(PlotError::Range { axis: axis.into(), low: 0.0, high, required });
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
    for k in 0..steps {
        let share = |k: usize| k as f64 / steps as f64;
        let corners = [(0.0, share(k)), (1.0, share(k)), (1.0, share(k + 1)), (0.0, share(k + 1))];
        let corners = corners.map(|corner| bar.at(corner));
        canvas.shade(&corners, &hex(colour(share(k))));
    }
    canvas.outline(bar, BLACK, 1.0);
    let step = round(map.top / 3.0);
    let decimals = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
    let ticks = (0..).map(|k| f64::from(k) * step).take_while(|tick| *tick <= map.top * 1.0001);
    for tick in ticks {
        let (x, y) = bar.at((1.0, tick / map.top));
        canvas.line(&[(x, y), (x + 5.0, y)], BLACK, 1.0, &[]);
        let text = format!("{tick:.decimals$}");
        let face = Type::new(TICK, BLACK, "start");
        canvas.text(&text, (x + 8.0, y + 0.5 * CAPITAL * TICK), face);
    }
    let middle = (bar.right + 62.0, 0.5 * (bar.top + bar.bottom));
    let face = Type { upward: true, ..Type::new(LABEL, BLACK, "middle") };
    canvas.text(&map.label, middle, face);
    let none = "white: no contact";
    canvas.text(
        none,
        (bar.left, bar.bottom + 14.0 + CAPITAL * SMALL),
        Type::new(SMALL, BLACK, "start"),
    );
}

/// The largest of 1, 2 and 5 times a power of ten up to a length.
fn round(most: f64) -> f64 {
    let power = 10f64.powf(most.log10().floor());
    [5.0, 2.0].into_iter().find(|k| k * power <= most).unwrap_or(1.0) * power
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

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// The values as a png of one pixel each. Colour 0 is white.
fn pixels(map: &Map) -> Result<Vec<u8>, PlotError> {
    let indices: Vec<u8> = map.values.iter().map(|value| index(value / map.top)).collect();
    let shades = (0..255).flat_map(|k| colour(f64::from(k) / 254.0));
    let palette: Vec<u8> = [255; 3].into_iter().chain(shades).collect();
    let rows = map.values.len() / map.columns;
    let mut bytes = vec![];
    let failed = |error: png::EncodingError| PlotError::Drawing(error.to_string());
    let too_large = |_| PlotError::Cells { rows, columns: map.columns };
    let width = u32::try_from(map.columns).map_err(too_large)?;
    let mut encoder = png::Encoder::new(&mut bytes, width, u32::try_from(rows).map_err(too_large)?);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette(palette);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&indices).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

/// The number of a colour: 0, white, for values of 0 and below.
fn index(share: f64) -> u8 {
    if share > 0.0 { 1 + (share.min(1.0) * 254.0).round() as u8 } else { 0 }
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
            ..Map::default()
        }
    }

    #[test]
    fn maps_have_bars_and_labels() {
        let svg = draw_map(&map()).unwrap();
        for word in ["where it touches", ">1 µm<", "pressure (GPa)", "white: no contact", ">0.2<"]
        {
            assert!(svg.contains(word), "{word}");
        }
        assert!(svg.contains("<image ") && svg.contains("image-rendering:pixelated"));
    }

    #[test]
    fn the_image_holds_the_values() {
        let bytes = map_png(&map()).unwrap();
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
    fn maps_that_cannot_be_are_refused() {
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
