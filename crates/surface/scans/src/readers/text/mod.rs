//! Scans as text: profiles, one column of heights, points and matrices.

mod columns;
mod grid;
mod header;
mod keys;
mod lengths;
mod precision;
mod profile;
mod style;

use crate::channel::{Channel, Lateral, Quantity, Samples, UnitsBy};
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::foreign::ForeignFile;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use columns::Columns;
use header::Header;
use profile::Roles;
use style::FORMAT;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// By the first bytes alone; what comes later is refused with its line.
fn recognises(bytes: &[u8]) -> bool {
    const UTF16_MARKS: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];
    if UTF16_MARKS.iter().any(|mark| bytes.starts_with(mark)) {
        let start = bytes.get(..bytes.len().min(512)).unwrap_or_default();
        return style::decode(start).is_ok_and(|text| {
            !text.chars().any(|character| character < ' ' && !"\t\n\r\x0c".contains(character))
        });
    }
    let is_binary = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0c".contains(byte);
    !bytes.iter().take(512).any(is_binary) && ForeignFile::recognise(bytes).is_none()
}

/// Scan in m, before its size is known.
struct Found {
    columns: usize,
    lateral: Lateral,
    heights_m: Decoded,
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    Ok(vec![channel_of_text(&style::decode(bytes)?, options)?])
}

/// Reads the one channel of a text. Its number of columns decides: 1 heights, 2 a profile `x h`, 3 points `x y h` (or a
/// profile with a column that counts its points or says which of them count), more a matrix. A header with both sizes
/// of a map makes any number of columns a matrix.
pub(super) fn channel_of_text<'b>(text: &str, options: &ScanOptions) -> Result<Channel<'b>, ScanReadError> {
    let columns = Columns::read(text)?;
    let header = Header::read(text, &columns)?;
    let mut notes = Vec::new();
    if ends_within_a_number(text) {
        notes.push("the last line has no line end; is the file cut off?".to_owned());
    }
    notes.extend(header.check_counts(&columns, columns.count > 3 || header.is_matrix())?);
    let found = match columns.count {
        1 => matrix(columns, false, &header, options, &mut notes)?,
        2 if !header.is_matrix() => {
            let roles = Roles { position: 0, height: 1, validity: None };
            profile::read(text, &columns, roles, &header, options, &mut notes)?
        }
        3 if header.has_validity => {
            let roles = Roles { position: 0, height: 1, validity: Some(2) };
            profile::read(text, &columns, roles, &header, options, &mut notes)?
        }
        3 if !header.is_matrix() && counts_points(&columns, &header) => {
            notes.push("the first column counts the points: the others are a profile".to_owned());
            let roles = Roles { position: 1, height: 2, validity: None };
            profile::read(text, &columns, roles, &header, options, &mut notes)?
        }
        3 if !header.is_matrix() => grid::read(text, &columns, &header, options, &mut notes)?,
        _ => matrix(columns, true, &header, options, &mut notes)?,
    };
    let samples = Samples::Decoded { columns: found.columns, decoded: found.heights_m };
    let stated_m = header.stated_m(matches!(found.lateral, Lateral::Size(_)));
    let channel = Channel::new(header.channel.clone(), Quantity::HEIGHTS_IN_M, found.lateral, samples);
    Ok(Channel {
        stated_m,
        units: UnitsBy::Reader,
        probe: header.stylus_radius_m.map(|_| Probe::Tip),
        tip_radius_m: header.stylus_radius_m,
        free_text: header.free_text().to_owned(),
        notes,
        ..channel
    })
}

/// Returns true if the text ends in what may be the first digits of a longer number.
fn ends_within_a_number(text: &str) -> bool {
    text.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+' | 'e' | 'E'))
}

/// Returns true if the first of three columns only counts the rows: it rises by one from row to row, and either it is
/// named so, or the second column rises or falls throughout as no coordinate of a map does.
fn counts_points(columns: &Columns, header: &Header) -> bool {
    let rises_by_one = |column: Vec<f64>| column.windows(2).all(|pair| pair[1] - pair[0] == 1.0);
    let second: Vec<f64> = columns.column(1).collect();
    columns.rows() > 2
        && rises_by_one(columns.column(0).collect())
        && (header.has_index || second.is_sorted_by(|a, b| a < b) || second.is_sorted_by(|a, b| a > b))
}

/// Heights row after row, or along a line.
fn matrix(
    columns: Columns,
    is_map: bool,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let Columns { count, mut values, .. } = columns;
    let (height_unit, factor) = header.map_heights();
    let units = Units::choose(options, header.lateral_unit, height_unit, notes);
    let to_m = units.height_to_m(FORMAT)?;
    let points = values.values.len();
    let (columns, rows) = if is_map { (count, points / count) } else { (points, 0) };
    let size = header.size(columns, rows, &units)?;
    values.values.iter_mut().for_each(|value| *value = to_m(*value * factor));
    Ok(Found { columns, lateral: size.map_or(Lateral::Unknown, Lateral::Size), heights_m: values })
}
