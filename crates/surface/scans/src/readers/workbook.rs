//! Workbooks, `.xlsx`. Every sheet with numbers is read like a text of its cells: two columns, points, or a matrix.
//!
//! Workbooks that surface testers of Mitutoyo export have a layout of their own: a sheet `DATA` with results in its
//! first column and a profile in its fifth and sixth, and a sheet `Certificate` with the conditions of the measurement.
//! There the unit of positions is that of the cut-off, the unit of heights that of the results, as SurfaceTopography
//! takes them.

use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{DataRef, Reader as _, Xlsx, XlsxError};

use crate::archive::{Archive, is_named_in, is_zip};
use crate::channel::{Channel, Lateral, Quantity, Samples, UnitsBy};
use crate::choice_of_units::Units;
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use crate::readers::even_axis::even_spacing;
use crate::readers::text::channels_of_text;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Workbook;
const INDEX: &str = "xl/workbook.xml";
/// Most bytes that a workbook may unpack to. The library takes some ten times as many for texts of one letter; a
/// profile of a hundred thousand points takes ten million.
const LARGEST: u64 = 1 << 26;
const DATA: &str = "DATA";
const CONDITIONS: &str = "Certificate";
/// Columns of the sheet of data, from 0.
const RESULT_COLUMN: u32 = 0;
const POSITION_COLUMN: u32 = 4;
const HEIGHT_COLUMN: u32 = 5;
/// Most characters of texts that are looked at.
const MOST_TEXT: usize = 10_000;
/// The share of a spacing by which positions, which are stored as computed, may lie off even ones.
const ROUNDING: f64 = 1e-6;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// Any workbook; one of spectra is a scan as little as a text of spectra is.
fn recognises(bytes: &[u8]) -> bool {
    is_zip(bytes) && is_named_in(bytes, INDEX)
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    refuse_what_swells(bytes, options)?;
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
    let names = workbook.sheet_names();
    match [DATA, CONDITIONS].iter().all(|sheet| names.iter().any(|name| name == sheet)) {
        true => Ok(vec![channel_of_tester(&mut workbook, options)?]),
        false => channels_of_sheets(&mut workbook, &names, options),
    }
}

/// A channel for every sheet with numbers.
fn channels_of_sheets<'b>(
    workbook: &mut Xlsx<Cursor<&[u8]>>,
    names: &[String],
    options: &ScanOptions,
) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let (mut channels, mut room) = (Vec::new(), LARGEST as usize);
    let mut refused = ScanReadError::NoRows;
    for sheet in names {
        let read = text_of_sheet(workbook, sheet, &mut room)?;
        // A sheet is whole, unlike a text without a line end.
        match channels_of_text(&(read + "\n"), options) {
            Ok(found) => {
                let is_one = found.len() == 1;
                channels.extend(found.into_iter().map(|channel| Channel {
                    name: match channel.name {
                        Some(column) if !is_one => Some(format!("{sheet}: {column}")),
                        name => name.or(Some(sheet.clone())),
                    },
                    ..channel
                }));
            }
            Err(ScanReadError::NoRows) => {}
            Err(ScanReadError::NoUnit { what, .. }) => {
                refused = ScanReadError::NoUnit { format: FORMAT, what }
            }
            Err(error) => refused = error,
        }
    }
    if channels.is_empty() { Err(refused) } else { Ok(channels) }
}

/// The cells of a sheet as lines with tabs, rows of the sheet as lines. A chart has none.
fn text_of_sheet(
    workbook: &mut Xlsx<Cursor<&[u8]>>,
    sheet: &str,
    room: &mut usize,
) -> Result<String, ScanReadError> {
    let mut cells = match workbook.worksheet_cells_reader(sheet) {
        Err(XlsxError::NotAWorksheet(_)) => return Ok(String::new()),
        other => other.map_err(damaged)?,
    };
    let mut rows: BTreeMap<u32, BTreeMap<u32, String>> = BTreeMap::new();
    while let Some(cell) = cells.next_cell().map_err(damaged)? {
        let (row, column) = cell.get_position();
        let field = field_of(cell.get_value());
        if !field.is_empty() {
            take_room(room, field.len())?;
            rows.entry(row).or_default().insert(column, field);
        }
    }
    let first = rows.values().filter_map(|cells| cells.keys().next()).min().copied().unwrap_or(0);
    let (mut text, mut lines) = (String::new(), 0);
    for (row, cells) in rows {
        let mut column = first;
        take_room(room, (row - lines) as usize)?;
        text.extend((lines..row).map(|_| '\n'));
        lines = row;
        for (at, field) in cells {
            take_room(room, (at - column) as usize)?;
            text.extend((column..at).map(|_| '\t'));
            text += &field;
            column = at;
        }
    }
    Ok(text)
}

/// Takes bytes off those that the texts of a workbook may have.
fn take_room(room: &mut usize, bytes: usize) -> Result<(), ScanReadError> {
    let too_large =
        || ScanReadError::ArchiveTooLarge { what: "the workbook".to_owned(), bound: LARGEST, unit: "bytes" };
    *room = room.checked_sub(bytes).ok_or_else(too_large)?;
    Ok(())
}

/// A cell as a field of a line. Numbers have twelve digits: sums of spacings are off in the last ones of a double, and
/// positions shall be even to the digits that they have.
fn field_of(value: &DataRef) -> String {
    match value {
        DataRef::Float(number) => {
            let rounded: f64 = format!("{number:.11e}").parse().unwrap_or(*number);
            if rounded == 0.0 || (1e-4..1e15).contains(&rounded.abs()) {
                rounded.to_string()
            } else {
                format!("{rounded:e}")
            }
        }
        DataRef::Int(number) => number.to_string(),
        DataRef::Error(_) => "nan".to_owned(),
        _ => text_of(value).map_or_else(String::new, |text| text.trim().replace(['\t', '\n', '\r'], " ")),
    }
}

/// The profile of a surface tester.
fn channel_of_tester<'b>(
    workbook: &mut Xlsx<Cursor<&[u8]>>,
    options: &ScanOptions,
) -> Result<Channel<'b>, ScanReadError> {
    let mut notes = Vec::new();
    let conditions = Conditions::read(workbook)?;
    let profile = Profile::read(workbook)?;
    let units = Units::choose(options, conditions.cut_off_unit, profile.result_unit, &mut notes);
    let (length_to_m, height_to_m) = (units.length_to_m(FORMAT)?, units.height_to_m(FORMAT)?);
    let (positions, heights): (Vec<f64>, Vec<Option<f64>>) =
        profile.points.into_values().filter_map(|(position, height)| Some((position?, height))).unzip();
    if let Some(pair) = positions.windows(2).find(|pair| pair[0] >= pair[1]) {
        return Err(bad("a position", pair[1], &format!("above the one before, {}", pair[0])));
    }
    let range = positions.last().zip(positions.first()).map_or(0.0, |(last, first)| last - first);
    let lateral = match even_spacing(&positions, ROUNDING * range / positions.len().max(1) as f64) {
        Some(spacing) => Lateral::Spacing { x_m: length_to_m(spacing), y_m: None },
        None => Lateral::Positions(positions.iter().map(|&position| length_to_m(position)).collect()),
    };
    let decoded: Decoded = heights.into_iter().map(|height| height.map(&height_to_m)).collect();
    let samples = Samples::Decoded { columns: decoded.values.len(), decoded };
    let channel = Channel::new(None, Quantity::HEIGHTS_IN_M, lateral, samples);
    let free_text = conditions.text;
    Ok(Channel { units: UnitsBy::Reader, probe: Some(Probe::Tip), free_text, notes, ..channel })
}

/// Unpacks every file once and lets it go: the library holds files whole, and the sizes that an archive states need not
/// be true.
fn refuse_what_swells(bytes: &[u8], options: &ScanOptions) -> Result<(), ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound().min(LARGEST))?;
    let paths: Vec<String> = archive.paths().map(str::to_owned).collect();
    paths.iter().try_for_each(|path| archive.read(path).map(|_| ()))
}

struct Conditions {
    cut_off_unit: Option<LengthUnit>,
    /// All that is written there, a line each row.
    text: String,
}

impl Conditions {
    fn read(workbook: &mut Xlsx<Cursor<&[u8]>>) -> Result<Self, ScanReadError> {
        let mut rows: BTreeMap<u32, Vec<String>> = BTreeMap::new();
        let mut room = MOST_TEXT;
        visit(workbook, CONDITIONS, |row, _, value| {
            if let Some(text) = text_of(value).filter(|text| text.len() < room) {
                room -= text.len();
                rows.entry(row).or_default().push(text.trim().to_owned());
            }
        })?;
        let cut_off = rows.values().flat_map(|row| row.windows(2)).find_map(|pair| match pair {
            [name, value] if name.eq_ignore_ascii_case("Cut-Off") => Some(value),
            _ => None,
        });
        let cut_off_unit = cut_off.and_then(|value| unit_behind_number(value));
        Ok(Self {
            cut_off_unit,
            text: rows.into_values().map(|row| row.join(" ")).collect::<Vec<_>>().join("\n"),
        })
    }
}

#[derive(Default)]
struct Profile {
    /// Position and height by row.
    points: BTreeMap<u32, (Option<f64>, Option<f64>)>,
    /// The unit of the first result, a mean height.
    result_unit: Option<LengthUnit>,
}

impl Profile {
    fn read(workbook: &mut Xlsx<Cursor<&[u8]>>) -> Result<Self, ScanReadError> {
        let mut profile = Self::default();
        visit(workbook, DATA, |row, column, value| match column {
            RESULT_COLUMN if profile.result_unit.is_none() => {
                // `Ra 0.018 µm`
                let value =
                    text_of(value).and_then(|text| text.trim().split_once(' ')).map(|(_, value)| value);
                profile.result_unit = value.and_then(unit_behind_number);
            }
            POSITION_COLUMN => profile.points.entry(row).or_default().0 = number_of(value),
            HEIGHT_COLUMN => profile.points.entry(row).or_default().1 = number_of(value),
            _ => {}
        })?;
        Ok(profile)
    }
}

/// Visits the filled cells of a sheet with their row and column, from 0.
fn visit(
    workbook: &mut Xlsx<Cursor<&[u8]>>,
    sheet: &str,
    mut visit: impl FnMut(u32, u32, &DataRef),
) -> Result<(), ScanReadError> {
    let mut cells = workbook.worksheet_cells_reader(sheet).map_err(damaged)?;
    while let Some(cell) = cells.next_cell().map_err(damaged)? {
        let (row, column) = cell.get_position();
        visit(row, column, cell.get_value());
    }
    Ok(())
}

fn text_of<'v>(value: &'v DataRef) -> Option<&'v str> {
    match value {
        DataRef::String(text) => Some(text),
        DataRef::SharedString(text) => Some(text),
        _ => None,
    }
}

fn number_of(value: &DataRef) -> Option<f64> {
    match value {
        DataRef::Float(number) => Some(*number).filter(|number| number.is_finite()),
        DataRef::Int(number) => Some(*number as f64),
        _ => text_of(value)
            .and_then(|text| text.trim().replace(',', ".").parse().ok())
            .filter(|number: &f64| number.is_finite()),
    }
}

/// The unit in texts such as `0.8mm` and ` 0.018  µm `.
fn unit_behind_number(text: &str) -> Option<LengthUnit> {
    let text = text.trim();
    let at = text.find(|character: char| !character.is_ascii_digit() && !"+-., ".contains(character))?;
    if at == 0 { None } else { LengthUnit::parse_instrument(text.get(at..)?.trim()) }
}

fn damaged(error: XlsxError) -> ScanReadError {
    ScanReadError::Zip { what: "the workbook".to_owned(), problem: error.to_string() }
}

fn bad(field: &str, value: impl ToString, bound: &str) -> ScanReadError {
    FORMAT.bad(FilePlace::Element(DATA.to_owned()), field, value, bound, "export the measurement again")
}
