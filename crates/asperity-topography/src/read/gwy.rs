//! Gwyddion `.gwy`: a container of named objects, among them fields of heights.
//!
//! The layout follows Gwyddion's description of its format.

use std::collections::BTreeMap;

use asperity_core::Finding;

use super::refusal::gwy as refuse;
use super::scan::{PixelSize, Scan, points, select};
use super::units;
use crate::error::excerpt;
use crate::{LengthUnit, TopographyError};

const MAGIC: &[u8] = b"GWYP";

pub(super) fn scan(bytes: &[u8], channel: Option<&str>) -> Result<Scan, TopographyError> {
    let rest = bytes
        .strip_prefix(MAGIC)
        .ok_or_else(|| refuse("file", "something else", "a file that begins with GWYP"))?;
    let Some((b"GwyContainer", items)) = Bytes(rest).object() else {
        return Err(refuse("container", "no whole object", "an object GwyContainer"));
    };
    let mut channels = BTreeMap::<u32, Channel<'_>>::new();
    each(items, |name, item| {
        let Some((number, key)) = name.strip_prefix('/').and_then(|name| name.split_once('/'))
        else {
            return;
        };
        let Ok(number) = number.parse() else { return };
        match (key, item) {
            ("data", Item::Object(b"GwyDataField", data)) => {
                channels.entry(number).or_default().data = Some(data);
            }
            ("mask", Item::Object(b"GwyDataField", data)) => {
                channels.entry(number).or_default().mask = Some(data);
            }
            ("data/title", Item::Text(title)) => {
                channels.entry(number).or_default().title = Some(title);
            }
            _ => {}
        }
    })?;
    let (mut names, mut fields, mut others) = (vec![], vec![], vec![]);
    for (number, Channel { data, mask, title }) in channels {
        let Some(field) = data.map(Field::read).transpose()? else { continue };
        let name = title.map_or_else(
            || format!("channel {number}"),
            |title| String::from_utf8_lossy(title).trim().to_owned(),
        );
        match units::unit(&field.unit_z) {
            Some(unit) => {
                names.push(name);
                fields.push((field, mask, unit));
            }
            None => others.push(format!("{name} [{}]", field.unit_z)),
        }
    }
    if fields.is_empty() {
        let found = format!("no heights among {}", others.join(", "));
        return Err(refuse("si_unit_z", found, "a channel with a unit of length"));
    }
    let (at, note) = select(&names, channel)?;
    let (field, mask, unit) = fields.swap_remove(at);
    field.scan(mask.map(Field::read).transpose()?, unit, note)
}

/// The objects of a channel.
#[derive(Default)]
struct Channel<'a> {
    data: Option<&'a [u8]>,
    mask: Option<&'a [u8]>,
    title: Option<&'a [u8]>,
}

/// A `GwyDataField`, not yet decoded.
#[derive(Default)]
struct Field<'a> {
    resolution: [i32; 2],
    size: [f64; 2],
    unit_xy: String,
    unit_z: String,
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
        for (items, name) in units.into_iter().zip([&mut field.unit_xy, &mut field.unit_z]) {
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
        unit: LengthUnit,
        note: Option<Finding>,
    ) -> Result<Scan, TopographyError> {
        let [columns, rows] = self.resolution;
        let count = |n: i32, field| {
            let positive = u64::try_from(n).ok().filter(|n| *n > 0);
            positive.ok_or_else(|| refuse(field, n.to_string(), "at least 1"))
        };
        let n = points(count(columns, "xres")?, count(rows, "yres")?)?;
        let mut heights = self.numbers(n)?;
        let scale = units::unit(&self.unit_xy).map(LengthUnit::metres).ok_or_else(|| {
            refuse("si_unit_xy", format!("{:?}", self.unit_xy), "a unit of length")
        })?;
        for (size, field) in self.size.into_iter().zip(["xreal", "yreal"]) {
            if !(size.is_finite() && size > 0.0) {
                return Err(refuse(field, size.to_string(), "a finite length above 0"));
            }
        }
        let pixel_size = [self.size[0] / f64::from(columns), self.size[1] / f64::from(rows)];
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
            notes.push(
                Finding::note("mask", "masked_share", share)
                    .fact(text)
                    .advice("these points are read as missing; remove the mask to keep them"),
            );
        }
        let pixel_size = PixelSize::Metres(pixel_size.map(|size| size * scale));
        Ok(Scan { heights, columns: columns as usize, unit: Some(unit), pixel_size, notes })
    }

    fn numbers(&self, n: usize) -> Result<Vec<f64>, TopographyError> {
        let (numbers, rest) = self.data.as_chunks();
        if numbers.len() != n || !rest.is_empty() {
            let [columns, rows] = self.resolution;
            let required = format!("{n}, for {columns} x {rows} points");
            return Err(refuse("data", format!("{} numbers", numbers.len()), &required));
        }
        Ok(numbers.iter().map(|number| f64::from_le_bytes(*number)).collect())
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
            named.ok_or_else(|| refuse("container", "a broken item", "whole items"))?;
        with(&String::from_utf8_lossy(name), item);
    }
    Ok(())
}

/// Bytes not yet parsed; `None` where they end too early.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, n: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(n)?;
        self.0 = rest;
        Some(taken)
    }

    fn chunk<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (chunk, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*chunk)
    }

    fn count(&mut self) -> Option<usize> {
        self.chunk().map(|n| u32::from_le_bytes(n) as usize)
    }

    /// A text that ends with a zero.
    fn text(&mut self) -> Option<&'a [u8]> {
        let end = self.0.iter().position(|byte| *byte == 0)?;
        let text = self.take(end);
        self.take(1)?;
        text
    }

    fn object(&mut self) -> Option<(&'a [u8], &'a [u8])> {
        let name = self.text()?;
        let size = self.count()?;
        Some((name, self.take(size)?))
    }

    fn item(&mut self) -> Option<Item<'a>> {
        let [kind] = self.chunk()?;
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
            b'i' => Item::Whole(i32::from_le_bytes(self.chunk()?)),
            b'd' => Item::Real(f64::from_le_bytes(self.chunk()?)),
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
