//! Gwyddion `.gwy`: a container of named objects, among them fields of heights.
//!
//! The layout follows Gwyddion's description of its format.

use std::collections::BTreeMap;

use asperity_core::{Code, Finding};

use super::sample::{Bytes, Sample};
use super::scan::{Scan, points, positive, select};
use crate::error::{damaged, excerpt, refuse};
use crate::{LengthUnit, TopographyError};

pub(super) const MAGIC: &[u8] = b"GWYP";

pub(super) fn scan(bytes: &[u8], channel: Option<&str>) -> Result<Scan, TopographyError> {
    let rest =
        bytes.strip_prefix(MAGIC).ok_or_else(|| damaged("gwy", "it does not begin with GWYP"))?;
    let Some((b"GwyContainer", items)) = Bytes(rest).object() else {
        return Err(damaged("gwy", "it has no whole GwyContainer"));
    };
    // Of each channel the data, the mask and the title.
    let mut channels = BTreeMap::<u32, [Option<&[u8]>; 3]>::new();
    each(items, |name, item| {
        let key = name.strip_prefix('/').and_then(|name| name.split_once('/'));
        let Some((Ok(number), key)) = key.map(|(number, key)| (number.parse(), key)) else {
            return;
        };
        let (at, bytes) = match (key, item) {
            ("data", Item::Object(b"GwyDataField", data)) => (0, data),
            ("mask", Item::Object(b"GwyDataField", mask)) => (1, mask),
            ("data/title", Item::Text(title)) => (2, title),
            _ => return,
        };
        channels.entry(number).or_default()[at] = Some(bytes);
    })?;
    let (mut names, mut fields, mut others) = (vec![], vec![], vec![]);
    for (number, [data, mask, title]) in channels {
        let Some(field) = data.map(Field::read).transpose()? else { continue };
        let name = title.map_or_else(
            || format!("channel {number}"),
            |title| String::from_utf8_lossy(title).trim().to_owned(),
        );
        match field.units[1].parse().ok() {
            None if !field.units[1].trim().is_empty() => {
                others.push(format!("{name} [{}]", field.units[1]))
            }
            unit => {
                names.push(name);
                fields.push((field, mask, unit));
            }
        }
    }
    if fields.is_empty() {
        let found = format!("no heights among {}", others.join(", "));
        return Err(refuse("gwy si_unit_z", found, "a channel with a unit of length"));
    }
    let (at, note) = select(&names, channel)?;
    let (field, mask, unit) = fields.swap_remove(at);
    field.scan(mask.map(Field::read).transpose()?, unit, note)
}

/// A `GwyDataField`, not yet decoded.
#[derive(Default)]
struct Field<'a> {
    resolution: [i32; 2],
    size: [f64; 2],
    /// Of lengths and of heights.
    units: [String; 2],
    data: &'a [u8],
}

impl<'a> Field<'a> {
    fn read(items: &'a [u8]) -> Result<Self, TopographyError> {
        let mut field = Self::default();
        let mut units = [&[][..]; 2];
        each(items, |name, item| match (name, item) {
            ("xres", Item::Whole(n)) => field.resolution[0] = n,
            ("yres", Item::Whole(n)) => field.resolution[1] = n,
            ("xreal", Item::Real(length)) => field.size[0] = length,
            ("yreal", Item::Real(length)) => field.size[1] = length,
            ("si_unit_xy", Item::Object(_, unit)) => units[0] = unit,
            ("si_unit_z", Item::Object(_, unit)) => units[1] = unit,
            ("data", Item::Reals(data)) => field.data = data,
            _ => {}
        })?;
        for (items, name) in units.into_iter().zip(&mut field.units) {
            each(items, |key, item| {
                if let ("unitstr", Item::Text(text)) = (key, item) {
                    *name = excerpt(&String::from_utf8_lossy(text));
                }
            })?;
        }
        Ok(field)
    }

    fn scan(
        &self,
        mask: Option<Field<'_>>,
        unit: Option<LengthUnit>,
        note: Option<Finding>,
    ) -> Result<Scan, TopographyError> {
        let [columns, rows] = self.resolution;
        let n = points(positive("gwy xres", columns)? as u64, positive("gwy yres", rows)? as u64)?;
        let mut heights = self.numbers(n)?;
        let scale = self.units[0].parse().ok().map(LengthUnit::metres);
        let wrong = || refuse("gwy si_unit_xy", format!("{:?}", self.units[0]), "a unit of length");
        let scale = scale.ok_or_else(wrong)?;
        let [width, height] = self.size;
        let pixel_size = [
            positive("gwy xreal", width)? / f64::from(columns) * scale,
            positive("gwy yreal", height)? / f64::from(rows) * scale,
        ];
        let mut notes: Vec<_> = note.into_iter().collect();
        if let Some(mask) = mask {
            let mut masked = 0;
            for (height, mask) in heights.iter_mut().zip(mask.numbers(n)?) {
                if mask > 0.5 {
                    (*height, masked) = (f64::NAN, masked + 1);
                }
            }
            let share = masked as f64 / n as f64;
            let text = format!("the mask of the file marks {:.3} % of the points", 100.0 * share);
            let advice = "these points are read as missing; remove the mask to keep them";
            notes.push(Finding::note(Code::Mask, "masked_share", share).fact(text).advice(advice));
        }
        Ok(Scan { notes, ..Scan::new(heights, columns as usize, unit, pixel_size) })
    }

    fn numbers(&self, n: usize) -> Result<Vec<f64>, TopographyError> {
        let numbers = Sample::new(*b"f8").decode(self.data);
        if numbers.len() != n {
            let [columns, rows] = self.resolution;
            let required = format!("{n}, for {columns} x {rows} points");
            return Err(refuse("gwy data", format!("{} numbers", numbers.len()), required));
        }
        Ok(numbers)
    }
}

/// A value of a container. The content of objects is not parsed.
enum Item<'a> {
    Whole(i32),
    Real(f64),
    Text(&'a [u8]),
    Reals(&'a [u8]),
    /// Name and items.
    Object(&'a [u8], &'a [u8]),
    Other,
}

/// Calls `with` for each named item.
fn each<'a>(items: &'a [u8], mut with: impl FnMut(&str, Item<'a>)) -> Result<(), TopographyError> {
    let mut items = Bytes(items);
    while !items.0.is_empty() {
        let named = items.text().and_then(|name| Some((name, items.item()?)));
        let (name, item) =
            named.ok_or_else(|| damaged("gwy", "an item of its container is broken"))?;
        with(&String::from_utf8_lossy(name), item);
    }
    Ok(())
}

impl<'a> Bytes<'a> {
    fn object(&mut self) -> Option<(&'a [u8], &'a [u8])> {
        let name = self.text()?;
        let size = self.count()?;
        Some((name, self.take(size)?))
    }

    fn item(&mut self) -> Option<Item<'a>> {
        let kind = *self.take(1)?.first()?;
        let mut array = |size: usize| {
            let n = self.count()?;
            self.take(n.checked_mul(size)?)
        };
        Some(match kind {
            b'D' => Item::Reals(array(8)?),
            b'Q' => array(8).map(|_| Item::Other)?,
            b'I' => array(4).map(|_| Item::Other)?,
            b'C' => array(1).map(|_| Item::Other)?,
            b'b' | b'c' => self.take(1).map(|_| Item::Other)?,
            b'q' => self.take(8).map(|_| Item::Other)?,
            b'i' => Item::Whole(self.number(*b"i4")? as i32),
            b'd' => Item::Real(self.number(*b"f8")?),
            b's' => Item::Text(self.text()?),
            b'o' => {
                let (name, items) = self.object()?;
                Item::Object(name, items)
            }
            b'S' | b'O' => {
                // Each takes a byte at least, so a false count ends with the bytes.
                for _ in 0..self.count()? {
                    if kind == b'S' { self.text().map(drop)? } else { self.object().map(drop)? }
                }
                Item::Other
            }
            _ => return None,
        })
    }
}
