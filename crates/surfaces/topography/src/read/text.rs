//! Text files: bytes to lines, to blocks of a header and a table, to surfaces.

use super::blocks::{Block, blocks};
use super::header::{Header, HeaderLine};
use super::scan::{ReadOptions, Scan, listed, select};
use super::{lines, table};
use crate::TopographyError;
use crate::error::undecided;

pub(super) fn scan(bytes: &[u8], options: &ReadOptions) -> Result<Scan, TopographyError> {
    let mut tables = tables(bytes, options)?;
    let name = |(k, (header, _)): (usize, &(Header, Block))| match header.name() {
        Some(name) => name.to_owned(),
        None => format!("table {}", k + 1),
    };
    let names: Vec<String> = tables.iter().enumerate().map(name).collect();
    if let (None, Some((header, block))) = (&options.channel, tables.get(1)) {
        let line = header.lines.first().map_or(block.line, |first| first.line.min(block.line));
        let found = "a second table".to_owned();
        return Err(undecided(format!("line {line}"), found, "channel", &listed(&names)));
    }
    let (at, _) = select(&names, options.channel.as_deref())?;
    let (header, block) = tables.swap_remove(at);
    table::scan(block, &header, options)
}

/// The lines of all headers.
pub(super) fn header(
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Vec<HeaderLine>, TopographyError> {
    Ok(tables(bytes, options)?.into_iter().flat_map(|(header, _)| header.lines).collect())
}

fn tables(bytes: &[u8], options: &ReadOptions) -> Result<Vec<(Header, Block)>, TopographyError> {
    let mut tables = vec![];
    for block in blocks(&lines::decode(bytes)?, options)? {
        let header = Header::read(&block.header, block.delimiter);
        let blocks = match header.points()? {
            [None, None] => block.split(),
            _ => vec![block],
        };
        for block in blocks {
            tables.push((Header::read(&block.header, block.delimiter), block));
        }
    }
    Ok(tables)
}
