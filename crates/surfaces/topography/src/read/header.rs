//! Headers of text files, in English, German and French.

use super::scan::PixelSize;
use super::table::{Delimiter, NumberTable};
use crate::error::{refuse, refuse_line};
use crate::unit::{length, quantity, unit, unit_in};
use crate::{LengthUnit, TopographyError};

const WIDTH: &[&str] = &["width", "breite", "largeur"];
const HEIGHT: &[&str] = &["height", "h\u{f6}he", "hoehe", "hauteur"];
const PIXEL: &[&str] = &[
    "pixel size",
    "pixel_size",
    "pixelsize",
    "pixelgr\u{f6}\u{df}e",
    "pixelgroesse",
    "taille de pixel",
    "taille du pixel",
];

/// The header above the numbers.
#[derive(Default)]
pub(super) struct Header {
    /// Unit of the heights, after their factor.
    unit: Option<LengthUnit>,
    /// Factor of the heights.
    pub(super) factor: Option<f64>,
    /// Width and height \[m\].
    pub(super) size: [Option<f64>; 2],
    pub(super) pixel_size: PixelSize,
    /// Units over the columns, without an index.
    columns: Vec<Option<LengthUnit>>,
    /// Whether the first column counts the rows.
    pub(super) index: bool,
    /// Whether the third column tells which points of a profile are valid.
    pub(super) validity: bool,
}

impl Header {
    pub(super) fn read(table: &NumberTable) -> Result<Self, TopographyError> {
        let mut header = Self::default();
        // A unit that is no length, such as rad, needs a factor.
        let mut other_unit = None;
        for (line, text) in &table.header {
            let bare = text.trim_start_matches(['#', '%', '\\', '/', '*', '"', ' ']);
            let Some((key, value)) = bare.split_once([':', '=']) else { continue };
            let value = value.trim().trim_end_matches('"');
            let wrong = |required: &str| refuse_line(*line, bare, required);
            let positive = || length(value).ok_or_else(|| wrong("a length, for example 10 um,"));
            let key = key.trim().to_lowercase();
            let is = |names: &[&str]| names.contains(&key.as_str());
            if is(WIDTH) {
                header.size[0] = Some(positive()?);
            } else if is(HEIGHT) {
                header.size[1] = Some(positive()?);
            } else if is_unit_of_heights(&key) {
                match unit(value) {
                    Some(unit) => header.unit = header.unit.or(Some(unit)),
                    None => {
                        let required = "a unit of length, or a conversion factor of the heights,";
                        other_unit = Some(wrong(required));
                    }
                }
            } else if is(PIXEL) {
                header.pixel_size = pixel_size(value).ok_or_else(|| wrong("a length above 0"))?;
            } else if is_factor(&key) {
                let required =
                    "the factor from the heights to a unit of length, as in (-> m)=1e-9,";
                let (factor, unit) = factor(&key, value).ok_or_else(|| wrong(required))?;
                (header.factor, header.unit) = (Some(factor), Some(unit));
            }
        }
        if let Some(error) = other_unit.filter(|_| header.factor.is_none()) {
            return Err(error);
        }
        header.read_columns(table);
        Ok(header)
    }

    /// The last lines may name the columns, in one line, or their units in a second one.
    fn read_columns(&mut self, table: &NumberTable) {
        if table.columns > 3 {
            return;
        }
        for (_, text) in table.header.iter().rev().take(3) {
            let text = text.trim_start_matches(['#', '%', '\\', '/', '*']);
            let Some(names) = names(text, table) else { continue };
            let lower = |at: usize| names.get(at).map(|name| name.trim().to_lowercase());
            self.index |= lower(0).is_some_and(|name| matches!(name.as_str(), "index" | "#"));
            self.validity |= lower(2).is_some_and(|name| name == "valid");
            let units: Vec<_> = names.iter().map(|name| unit_in(name)).collect();
            if self.columns.is_empty() && units.iter().any(Option::is_some) {
                self.columns = units;
            }
        }
        if self.index && !self.columns.is_empty() {
            self.columns.remove(0);
        }
    }

    /// The unit of the heights, in this column if the columns have units.
    pub(super) fn heights(&self, column: Option<usize>) -> Option<LengthUnit> {
        let over = column.and_then(|column| self.columns.get(column).copied().flatten());
        if self.factor.is_some() { self.unit } else { over.or(self.unit) }
    }

    /// The distance of points in the units over the columns of positions.
    pub(super) fn distance(&self, size: [f64; 2]) -> Result<PixelSize, TopographyError> {
        let unit = |column: usize| self.columns.get(column).copied().flatten();
        let areal = self.columns.len() > 2 && !self.validity;
        match if areal { [unit(0), unit(1)] } else { [unit(0); 2] } {
            [Some(x), Some(y)] => {
                Ok(PixelSize::Metres([size[0] * x.metres(), size[1] * y.metres()]))
            }
            [None, None] => Ok(PixelSize::InUnit(size)),
            _ => {
                let found = "a unit over one of the columns x and y";
                Err(refuse("header", found, "units over both or over neither"))
            }
        }
    }
}

/// Whether a key names the unit of the heights, and not, for example, that of the lengths:
/// `unit`, `z-unit`, `exported image units`, `Einheit der Werte`, `unité de valeur`.
fn is_unit_of_heights(key: &str) -> bool {
    let unit = |word: &str| {
        let word = word.strip_suffix('s').unwrap_or(word);
        matches!(
            word,
            "unit" | "unit\u{e9}" | "einheit" | "einheiten" | "werteinheit" | "werteinheiten"
        )
    };
    let of_heights = |word: &str| {
        let english = matches!(word, "value" | "data" | "exported" | "image" | "height" | "z");
        english || matches!(word, "der" | "werte" | "de" | "des" | "valeur" | "valeurs")
    };
    let words = || key.split([' ', '-']);
    words().any(unit) && words().all(|word| unit(word) || of_heights(word))
}

/// Whether a key names a factor of the heights, and not, for example, a magnification factor.
fn is_factor(key: &str) -> bool {
    let has = |words: &[&str]| words.iter().any(|word| key.contains(word));
    let of_heights = ["height", "conversion", "scale", "scaling", "data", "value", "umrechnung"];
    let of_others = ["skal", "h\u{f6}he", "hoehe", "hauteur", "\u{e9}chelle"];
    has(&["factor", "faktor", "facteur"])
        && (has(&of_heights) || has(&of_others) || key.starts_with('z'))
}

/// The names over the columns, if the line has as many.
fn names(text: &str, table: &NumberTable) -> Option<Vec<String>> {
    let delimiters = [table.delimiter, Delimiter(b',')];
    let split = |delimiter: &Delimiter| {
        let names: Vec<_> = delimiter
            .fields(text.as_bytes())
            .map(|name| String::from_utf8_lossy(name).into_owned())
            .collect();
        // A delimiter may end the line.
        let names = match names.split_last() {
            Some((last, rest)) if last.is_empty() && rest.len() >= table.columns => rest.to_vec(),
            _ => names,
        };
        (names.len() == table.columns).then_some(names)
    };
    let bracketed = || {
        let parts: Vec<_> = text.split_inclusive([']', ')']).map(str::to_owned).collect();
        (parts.len() == table.columns).then_some(parts)
    };
    // A unit over each column, whatever separates the numbers.
    let units =
        || split(&Delimiter(b' ')).filter(|names| names.iter().all(|name| unit(name).is_some()));
    delimiters.iter().find_map(split).or_else(bracketed).or_else(units)
}

fn pixel_size(value: &str) -> Option<PixelSize> {
    let (size, unit) = quantity(value)?;
    if size <= 0.0 {
        return None;
    }
    Some(match unit {
        Some(unit) => PixelSize::Metres([size * unit.metres(); 2]),
        None => PixelSize::InUnit([size; 2]),
    })
}

/// The factor and the unit that it leads to, which the key or the value states.
fn factor(key: &str, value: &str) -> Option<(f64, LengthUnit)> {
    let (factor, own) = quantity(value)?;
    let target = key.rsplit("->").next().filter(|target| target.len() < key.len());
    let target = target.and_then(|target| unit(target.trim().trim_end_matches(')')));
    Some((factor, own.or(target).or_else(|| unit_in(key))?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Result<Header, TopographyError> {
        Header::read(&NumberTable::parse(text.as_bytes())?)
    }

    #[test]
    fn headers_have_three_languages() {
        for text in [
            "# Width: 10 um\n# Height: 4 um\n# Value units: nm\n1 2 3 4\n",
            "# Kanal: Z\n# Breite: 10,0 \u{b5}m\n# H\u{f6}he: 4 um\n# Einheit: nm\n1 2 3 4\n",
            "# Canal : Z\n# Largeur : 10 um\n# Hauteur\u{a0}: 4 um\n# Unit\u{e9}s : nm\n1 2 3 4\n",
        ] {
            let header = header(text).unwrap();
            let [width, height] = header.size.map(|size| (1e9 * size.unwrap()).round() as u32);
            assert_eq!((width, height), (10_000, 4000), "{text}");
            assert_eq!(header.heights(None), Some(LengthUnit::Nanometre), "{text}");
        }
    }

    #[test]
    fn factors_and_pixel_sizes_are_used_or_refused() {
        let head = "pixel size=3.5e-007 m\ndata unit=rad\n";
        let whole = header(&format!("{head}height conversion factor (-> m)=2.5e-008\n1 2 3 4\n"));
        let whole = whole.unwrap();
        assert_eq!(whole.heights(None), Some(LengthUnit::Metre));
        assert_eq!(whole.factor, Some(2.5e-8));
        assert_eq!(whole.pixel_size, PixelSize::Metres([3.5e-7; 2]));
        let message = |text: String| header(&text).err().unwrap().to_string();
        let rad = message(format!("{head}1 2 3 4\n"));
        assert!(rad.starts_with("line 2: \"data unit=rad\""), "{rad}");
        let bare = message(format!("{head}height factor=2\n1 2 3 4\n"));
        assert!(bare.starts_with("line 3: \"height factor=2\""), "{bare}");
        assert!(header("magnification factor=50\n1 2 3 4\n").unwrap().factor.is_none());
        let none = message("pixel size=0 um\n1 2 3 4\n".to_owned());
        assert!(none.starts_with("line 1: \"pixel size=0 um\""), "{none}");
    }

    #[test]
    fn columns_have_names_and_units() {
        use LengthUnit::{Micrometre, Millimetre, Nanometre};
        for (text, units) in [
            ("x [mm]; z [nm]\n1;2\n", [Some(Millimetre), Some(Nanometre)]),
            ("x [mm] z [nm]\n1 2\n", [Some(Millimetre), Some(Nanometre)]),
            ("X_(microns),y1\n1,2\n", [Some(Micrometre), None]),
            ("um nm\n2\n1, 2\n3, 4\n", [Some(Micrometre), Some(Nanometre)]),
            ("index,x in um, z in nm\n0,1,2\n", [Some(Micrometre), Some(Nanometre)]),
            ("Lateral um,Raw Micrometer,\n1,2,\n", [Some(Micrometre), Some(Micrometre)]),
        ] {
            let found = header(text).unwrap();
            assert_eq!(found.columns, units, "{text}");
            assert_eq!(found.index, text.starts_with("index"), "{text}");
        }
        let found = header("X;Y;valid\n[mm];[mm];[1/0]\n1;2;1\n").unwrap();
        assert!(found.validity && found.heights(Some(1)) == Some(Millimetre));
    }
}
