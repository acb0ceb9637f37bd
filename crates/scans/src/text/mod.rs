//! Scans as text: profiles, one column of heights, points and matrices.

mod columns;
mod grid;
mod header;
mod profile;
mod style;

use crate::choice_of_size;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::file::Reading;
use crate::heights::Scan;
use crate::options::ScanOptions;
use columns::Columns;
use header::Header;
use style::FORMAT;

/// Reads a scan by its number of columns: 1 heights, 2 a profile `x h`, 3 points `x y h`, more a matrix. A header with
/// both sizes of a map makes any number of columns a matrix.
pub(crate) fn read(bytes: &[u8], options: &ScanOptions) -> Result<Reading, ScanReadError> {
    let text = style::decode(bytes)?;
    let columns = Columns::read(&text)?;
    let header = Header::read(&text, &columns)?;
    let mut notes = Vec::new();
    let channel = header.channel(options)?;
    let scan = match columns.count {
        1 => heights(columns.values, &header, options, &mut notes)?,
        2 if !header.is_matrix() => profile::read(&text, &columns, &header, options, &mut notes)?,
        3 if !header.is_matrix() => grid::read(&text, &columns, &header, options, &mut notes)?,
        _ => matrix(columns, &header, options, &mut notes)?,
    };
    let mut reading = Reading::new(scan, notes);
    reading.channels = channel.iter().cloned().collect();
    reading.channel = channel;
    Ok(reading)
}

/// Heights at even spacing along a line.
fn heights(
    mut values: Vec<f64>,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Scan, ScanReadError> {
    let units = Units::of(options, header.lateral_unit(), header.height_unit(0), notes);
    let to_m = units.height_to_m(FORMAT)?;
    let stated = header.size(values.len(), 0, &units)?;
    let size = choice_of_size::size(options, stated, notes)
        .ok_or(ScanReadError::NoSize { format: FORMAT, what: "how long the line of heights is" })?;
    values.iter_mut().for_each(|value| *value = to_m(*value));
    size.line(values)
}

/// Heights row after row.
fn matrix(
    columns: Columns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Scan, ScanReadError> {
    let Columns { count, mut values, .. } = columns;
    let units = Units::of(options, header.lateral_unit(), header.map_height_unit(), notes);
    let to_m = units.height_to_m(FORMAT)?;
    let stated = header.size(count, values.len() / count, &units)?;
    let size = choice_of_size::size(options, stated, notes)
        .ok_or(ScanReadError::NoSize { format: FORMAT, what: "how large the map is" })?;
    values.iter_mut().for_each(|value| *value = to_m(*value));
    size.map(count, values, notes)
}
