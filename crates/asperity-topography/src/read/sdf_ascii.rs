//! The text form of SDF: `Name = value` lines, a line `*`, and numbers up to another `*`.

use super::refusal::sdf as refuse;
use super::sdf_header::Header;
use crate::TopographyError;

pub(super) fn read(bytes: &[u8]) -> Result<(Vec<f64>, Header), TopographyError> {
    let mut lines = bytes.split(|byte| *byte == b'\n').map(line);
    let first = lines.next().unwrap_or_default();
    let bcr = first.get(1..4).is_some_and(|family| family == b"BCR");
    let mut fields = Fields::default();
    for line in lines.by_ref() {
        let line = comment_free(line, bcr);
        if line == b"*" {
            break;
        }
        fields.add(line)?;
    }
    let header = fields.header(bcr)?;
    let n = header.points()?;
    // A number and its separator take two bytes.
    if n / 2 > bytes.len() {
        let required = format!("{n}, for {} x {} points", header.columns, header.rows);
        return Err(refuse("data", format!("{} bytes", bytes.len()), &required));
    }
    let mut heights = Vec::with_capacity(n);
    // Gwyddion does not end the data of a BCR file.
    let mut whole = bcr;
    for line in lines {
        let line = comment_free(line, bcr);
        if line == b"*" {
            whole = true;
            break;
        }
        for word in line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            heights.push(height(word).ok_or_else(|| {
                let found = String::from_utf8_lossy(word);
                refuse("data", found, "a finite number or BAD")
            })?);
        }
        if heights.len() > n {
            break;
        }
    }
    if heights.len() != n {
        let found = if heights.len() > n { "more".to_owned() } else { heights.len().to_string() };
        let required = format!("{n} numbers, for {} x {} points", header.columns, header.rows);
        return Err(refuse("data", found, &required));
    }
    if !whole {
        return Err(refuse("data", "the end of the file", "a line with * after the numbers"));
    }
    if bcr {
        header.mark(&mut heights)?;
    }
    Ok((heights, header))
}

fn line(line: &[u8]) -> &[u8] {
    line.trim_ascii()
}

/// The line without the comment that BCR-1.0 allows.
fn comment_free(line: &[u8], bcr: bool) -> &[u8] {
    let end = line.iter().position(|byte| bcr && *byte == b';').unwrap_or(line.len());
    line[..end].trim_ascii()
}

fn height(word: &[u8]) -> Option<f64> {
    if [&b"bad"[..], b"nan"].iter().any(|mark| word.eq_ignore_ascii_case(mark)) {
        return Some(f64::NAN);
    }
    let number: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    number.is_finite().then_some(number)
}

/// The fields of a header as far as they were found.
#[derive(Default)]
struct Fields {
    counts: [Option<u64>; 2],
    scales: [Option<f64>; 3],
    packing: [u8; 2],
    data_type: Option<u8>,
}

impl Fields {
    fn add(&mut self, line: &[u8]) -> Result<(), TopographyError> {
        let text = String::from_utf8_lossy(line);
        let Some((name, value)) = text.split_once('=') else { return Ok(()) };
        let value = value.trim();
        let count = |field| {
            let n = value.parse().map_err(|_| refuse(field, value, "a whole number"))?;
            Ok::<_, TopographyError>(Some(n))
        };
        let scale = |field| {
            let length = value.parse().map_err(|_| refuse(field, value, "a number"))?;
            Ok::<_, TopographyError>(Some(length))
        };
        let none = |field| match value.to_ascii_lowercase().as_str() {
            "null" | "none" => Ok(0),
            _ => value.parse().map_err(|_| refuse(field, value, "0: none")),
        };
        match name.trim().to_ascii_lowercase().as_str() {
            "numpoints" => self.counts[0] = count("NumPoints")?,
            "numprofiles" => self.counts[1] = count("NumProfiles")?,
            "xscale" => self.scales[0] = scale("Xscale")?,
            "yscale" => self.scales[1] = scale("Yscale")?,
            "zscale" => self.scales[2] = scale("Zscale")?,
            "compression" => self.packing[0] = none("Compression")?,
            "checktype" => self.packing[1] = none("CheckType")?,
            "datatype" => self.data_type = Some(data_type(value)?),
            _ => {}
        }
        Ok(())
    }

    fn header(self, bcr: bool) -> Result<Header, TopographyError> {
        let absent = |field| move || refuse(field, "nothing", "this field in the header");
        let [columns, rows] = self.counts;
        let [x, y, z] = self.scales;
        let rows = rows.ok_or_else(absent("NumProfiles"))?;
        let y = if rows == 1 { y.or(x) } else { y };
        Ok(Header {
            columns: columns.ok_or_else(absent("NumPoints"))?,
            rows,
            scales: [
                x.ok_or_else(absent("Xscale"))?,
                y.ok_or_else(absent("Yscale"))?,
                z.ok_or_else(absent("Zscale"))?,
            ],
            packing: self.packing,
            // Doubles, if the header does not say so: numbers of text have no other limits.
            data_type: self.data_type.unwrap_or(7),
            largest_is_missing: bcr,
        })
    }
}

fn data_type(value: &str) -> Result<u8, TopographyError> {
    let names = ["UCHAR", "UINTEGER", "ULONGINT", "FLOAT", "CHAR", "INTEGER", "LONGINT", "DOUBLE"];
    let named = names.iter().position(|name| value.eq_ignore_ascii_case(name));
    let number = named.map(|at| at as u8).or_else(|| value.parse().ok());
    number.ok_or_else(|| refuse("DataType", value, "0 to 7"))
}
