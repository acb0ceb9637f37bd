//! Scans as text: profiles, one column of heights, points and matrices.

mod body;
mod columns;
mod even_columns;
mod grid;
mod header;
mod heads;
mod keys;
mod labels;
mod lengths;
mod line;
mod preamble;
mod precision;
mod profile;
mod quotes;
mod roles;
mod sentinel;
mod separator;
mod style;
mod thousands;

use crate::channel::{Channel, Lateral, Quantity, Samples, UnitsBy};
use crate::choice_of_units::Units;
use crate::error::{FilePlace, ScanReadError};
use crate::foreign::ForeignFile;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use body::Body;
use columns::Columns;
use even_columns::is_even;
use grid::PointColumns;
use header::Header;
use labels::Labels;
use line::line_of_heights;
use profile::ProfileColumns;
use roles::{Layout, Roles, SURE};
use style::FORMAT;

pub(super) use style::decode;

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
    channels_of_text(quotes::unquoted(style::decode(bytes)?).as_ref(), options)
}

/// Reads the channels of a text: of a map or a line one, of a table one for each column of heights and of signals.
pub(super) fn channels_of_text<'b>(
    text: &str,
    options: &ScanOptions,
) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let body = Body::find(text).ok_or(ScanReadError::NoRows)?;
    let mut columns = Columns::read(&body)?;
    let header = Header::read(&body, &columns)?;
    if let Some(no_data) = header.no_data {
        columns.mark_missing(no_data);
    }
    let mut notes = Vec::new();
    if ends_within_a_number(text) && columns.ends_shorter() {
        notes.push("the last line has no line end; is the file cut off?".to_owned());
    }
    notes.extend(columns.edge_note());
    notes.extend(body.footer_note());
    notes.extend(columns.comma_note.clone());
    let length_m = body.preamble.take(columns.count, columns.rows(), &mut notes)?;
    notes.extend(header.unread_note());
    let is_profile = columns.count < 4 && columns.rows() >= SURE && is_even(&columns, 0);
    let is_map = header.is_matrix() && !is_profile
        || columns.count > 3 && options.size.is_some_and(|size| size.y_m.is_some());
    let labels = if columns.count > 3 { Labels::find(&columns, &header.heads) } else { None };
    if labels.is_none() {
        columns.refuse_words(&body)?;
    }
    let layout = match columns.count {
        1 => Layout::Map,
        _ if labels.is_some() => Layout::Map,
        _ => roles::decide(&columns, &header.heads, is_map, wanted_column(&columns, options), &mut notes)?,
    };
    let is_wrapped = layout == Layout::Map && header.is_wrapped_line(&columns);
    if is_wrapped {
        notes.push("the header states one line of so many points: its rows follow each other".to_owned());
    }
    let is_map = layout == Layout::Map && columns.count > 1 && !is_wrapped;
    if let Some(labels) = &labels {
        labels.take_off(&mut columns, &mut notes);
    }
    notes.extend(header.check_counts(&columns, is_map || is_wrapped)?);
    let finish = |name: Option<String>, quantity: Quantity, found: Found, notes: Vec<String>| {
        let stated_m = header.stated_m(matches!(found.lateral, Lateral::Size(_)));
        let samples = Samples::Decoded { columns: found.columns, decoded: found.heights_m };
        Channel {
            stated_m,
            units: UnitsBy::Reader,
            probe: header.stylus_radius_m.map(|_| Probe::Tip),
            tip_radius_m: header.stylus_radius_m,
            free_text: header.free_text().to_owned(),
            notes,
            ..Channel::new(name, quantity, found.lateral, samples)
        }
    };
    match layout {
        Layout::Map => {
            if let Some(line) = body.second_block() {
                let mend = "write each scan into a file of its own, or delete the empty lines";
                return Err(FORMAT.unsupported(FilePlace::Line(line), "a second block of numbers", mend));
            }
            if columns.count == 1 {
                preamble::refuse_odd_count(&columns.as_written(&body))?;
            }
            header.refuse_no_length(0)?;
            notes.extend(sentinel::note(columns.values.values.iter().copied()));
            let spacings = labels.and_then(|labels| labels.spacings);
            let found = matrix(columns, is_map, length_m, spacings, &header, options, &mut notes)?;
            Ok(vec![finish(header.channel.clone(), Quantity::HEIGHTS_IN_M, found, notes)])
        }
        Layout::Table(table) => {
            let is_one = table.heights.len() + table.signals.len() == 1;
            let wanted = wanted_column(&columns, options).is_some();
            let name = |column: usize| match &header.channel {
                Some(channel) if table.heights.len() == 1 => Some(channel.clone()),
                _ if is_one && !wanted && !(options.channel.is_some() && header.heads.is_named(column)) => {
                    None
                }
                _ => Some(header.heads.name(column)),
            };
            let mut channels = Vec::new();
            for &height in &table.heights {
                let mut notes = notes.clone();
                notes.extend(header.heads.factor_note(height));
                notes.extend(sentinel::note(columns.measured(height).flatten()));
                match of_table(&body, &columns, &table, height, &header, options, &mut notes) {
                    Ok(found) => channels.push(finish(name(height), Quantity::HEIGHTS_IN_M, found, notes)),
                    Err(error) if is_one => return Err(error),
                    // Others may be readable.
                    Err(error) => channels.push(Channel {
                        units: UnitsBy::Reader,
                        ..Channel::new(
                            name(height),
                            Quantity::HEIGHTS_IN_M,
                            Lateral::Unknown,
                            Samples::Unreadable(Box::new(error)),
                        )
                    }),
                }
            }
            for &signal in &table.signals {
                let unit = header.heads.foreign(signal).map_or_else(String::new, |(_, unit)| unit.to_owned());
                let values: Decoded = columns.measured(signal).collect();
                let found =
                    Found { columns: values.values.len(), lateral: Lateral::Unknown, heights_m: values };
                channels.push(finish(
                    Some(header.heads.name(signal)),
                    Quantity::Other(unit),
                    found,
                    Vec::new(),
                ));
            }
            Ok(channels)
        }
    }
}

/// The column, from 0, that the caller wants by its number: `column 2` or `2`.
fn wanted_column(columns: &Columns, options: &ScanOptions) -> Option<usize> {
    let wanted = options.channel.as_deref()?;
    let number = wanted.strip_prefix("column ").unwrap_or(wanted);
    numbers::count(number).filter(|number| *number <= columns.count).map(|number| number - 1)
}

/// A column of heights over the positions of its table.
fn of_table(
    body: &Body<'_>,
    columns: &Columns,
    table: &Roles,
    height: usize,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    match (table.positions, table.position_of(height)) {
        ([Some(x), Some(y)], _) => {
            let places = PointColumns { x, y, height };
            grid::read(body, columns, places, header, options, notes)
        }
        (_, Some(position)) => {
            let profile = ProfileColumns { position, height, mask: table.mask };
            profile::read(body, columns, profile, header, options, notes)
        }
        (_, None) => {
            let is_sized = options.size.or(options.fallback_size).or(options.metadata_size()).is_some();
            if let Some(&in_its_place) = table.signals.iter().find(|_| !is_sized) {
                header.refuse_no_length(in_its_place)?;
            }
            let heights: Decoded = columns.measured(height).collect();
            line_of_heights(heights, header.height_unit(height), None, header, options, notes)
        }
    }
}

/// Returns true if the text ends in what may be the first digits of a longer number.
fn ends_within_a_number(text: &str) -> bool {
    text.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+' | 'e' | 'E'))
}

/// Heights row after row, or along a line, which a preamble may give the length of.
fn matrix(
    columns: Columns,
    is_map: bool,
    length_m: Option<f64>,
    spacings: Option<[f64; 2]>,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let Columns { count, mut values, .. } = columns;
    let (height_unit, factor) = header.map_heights();
    if !is_map {
        return line_of_heights(values, height_unit, length_m, header, options, notes);
    }
    let units = Units::choose(options, header.lateral_unit, height_unit, notes);
    let to_m = units.height_to_m(FORMAT)?;
    let size = header.size(count, values.values.len() / count, &units)?;
    values.values.iter_mut().for_each(|value| *value = to_m(*value * factor));
    let lateral = match (size, spacings) {
        (Some(size), _) => Lateral::Size(size),
        (None, Some([x, y])) => {
            let length_to_m = units.length_to_m(FORMAT)?;
            Lateral::Spacing { x_m: length_to_m(x), y_m: Some(length_to_m(y)) }
        }
        (None, None) => Lateral::Unknown,
    };
    Ok(Found { columns: count, lateral, heights_m: values })
}
