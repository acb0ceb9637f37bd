//! Headers of a binary wave: grid, units, places of numbers and texts.

use crate::cursor::{ByteOrder, Cursor, latin1, latin1_at_most};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::raster::{NumberType, Raster};

/// The format whose reader this is, for messages.
pub(super) const FORMAT: ScanFormat = ScanFormat::Igor;

/// Waves have up to so many dimensions.
const DIMENSIONS: usize = 4;
/// Length of the name of an element of a dimension, with the zero byte behind it.
const LABEL_BYTES: usize = 32;
/// Bytes of a note that are looked at; those of instruments take some ten kilobytes.
const LONGEST_NOTE: usize = 1 << 20;
/// Length of the header behind the one with the version.
const OLD_WAVE_BYTES: usize = 110;
const WAVE_BYTES: usize = 320;

/// A wave as its headers describe it.
#[derive(Default)]
pub(super) struct Wave {
    pub(super) name: String,
    /// Points along each dimension; 0 from the first that it does not have on.
    pub(super) points: [usize; DIMENSIONS],
    /// Distance of neighbours along each dimension, in its unit.
    pub(super) steps: [f64; DIMENSIONS],
    pub(super) step_units: [String; DIMENSIONS],
    pub(super) value_unit: String,
    pub(super) note: String,
    /// Names of the elements of each dimension, where it has any.
    pub(super) labels: [Vec<String>; DIMENSIONS],
    type_code: u16,
    type_offset: usize,
    order: Option<ByteOrder>,
    data_offset: usize,
}

/// The version and the order of bytes of a file whose sums are right.
pub(super) fn version(bytes: &[u8]) -> Option<(u16, ByteOrder)> {
    let first = *bytes.first_chunk()?;
    // The version is below 256: the byte that is not 0 tells the order.
    let (version, order) = match first {
        [0, version] => (u16::from(version), ByteOrder::Big),
        [version, 0] => (u16::from(version), ByteOrder::Little),
        _ => return None,
    };
    let headers = bytes.get(..header_bytes(version)?)?;
    let (pairs, _) = headers.as_chunks::<2>();
    let word = |pair: &[u8; 2]| match order {
        ByteOrder::Little => u16::from_le_bytes(*pair),
        ByteOrder::Big => u16::from_be_bytes(*pair),
    };
    let sum = pairs.iter().map(word).fold(0u16, u16::wrapping_add);
    (sum == 0).then_some((version, order))
}

/// Length of both headers of a version.
fn header_bytes(version: u16) -> Option<usize> {
    Some(match version {
        1 => 8 + OLD_WAVE_BYTES,
        2 => 16 + OLD_WAVE_BYTES,
        3 => 20 + OLD_WAVE_BYTES,
        5 => 64 + WAVE_BYTES,
        _ => return None,
    })
}

impl Wave {
    pub(super) fn read(bytes: &[u8]) -> Result<Self, ScanReadError> {
        let Some((version, order)) = version(bytes) else {
            let found = "a file whose headers do not have the sum that they should";
            return Err(FORMAT.unsupported(FilePlace::File, found, "save the wave again from Igor"));
        };
        let cursor = Cursor::new(FORMAT, bytes, order).at(2);
        let mut wave = if version == 5 { Self::read_5(cursor)? } else { Self::read_old(cursor, version)? };
        wave.order = Some(order);
        wave.check_points(&cursor)?;
        Ok(wave)
    }

    /// Version 5, the first with more than one dimension.
    fn read_5(mut cursor: Cursor) -> Result<Self, ScanReadError> {
        cursor.skip(2, "the sum")?;
        let wave_bytes = size(&mut cursor, "the size of the wave")?;
        let formula_bytes = size(&mut cursor, "the size of the formula")?;
        let note_bytes = size(&mut cursor, "the size of the note")?;
        let value_unit_bytes = size(&mut cursor, "the size of the unit of the values")?;
        let unit_bytes = sizes(&mut cursor, "the size of the unit of a dimension")?;
        let label_bytes = sizes(&mut cursor, "the size of the labels of a dimension")?;
        let start = header_bytes(5).unwrap_or_default() - WAVE_BYTES;
        let mut cursor = cursor.at(start + 16);
        let type_offset = cursor.at;
        let type_code = cursor.u16("the type of the numbers")?;
        let mut wave = Self { type_code, type_offset, ..Self::default() };
        cursor.skip(10, "reserved bytes")?;
        wave.name = cursor.text(LABEL_BYTES, "the name of the wave")?;
        cursor.skip(8, "reserved bytes")?;
        wave.points = sizes(&mut cursor, "the number of points of a dimension")?;
        for step in &mut wave.steps {
            *step = cursor.f64("the step of a dimension")?;
        }
        cursor.skip(8 * DIMENSIONS, "the offsets of the dimensions")?;
        wave.value_unit = cursor.text(4, "the unit of the values")?;
        for unit in &mut wave.step_units {
            *unit = cursor.text(4, "the unit of a dimension")?;
        }
        wave.data_offset = start + WAVE_BYTES;
        let mut cursor = cursor.at(start.saturating_add(wave_bytes).saturating_add(formula_bytes));
        wave.note = latin1_at_most(cursor.take(note_bytes, "the note")?, LONGEST_NOTE);
        // Units of more than three letters stand behind the note.
        if value_unit_bytes > 0 {
            wave.value_unit = cursor.text(value_unit_bytes, "the unit of the values")?;
        }
        for (unit, bytes) in wave.step_units.iter_mut().zip(unit_bytes).filter(|(_, bytes)| *bytes > 0) {
            *unit = cursor.text(bytes, "the unit of a dimension")?;
        }
        for (labels, bytes) in wave.labels.iter_mut().zip(label_bytes) {
            // The first names the dimension as a whole.
            let (names, _) = cursor.take(bytes, "the labels of a dimension")?.as_chunks::<LABEL_BYTES>();
            labels.extend(names.iter().skip(1).map(|name| latin1(name)));
        }
        Ok(wave)
    }

    /// Versions 1 to 3, with one dimension.
    fn read_old(mut cursor: Cursor, version: u16) -> Result<Self, ScanReadError> {
        let wave_bytes = size(&mut cursor, "the size of the wave")?;
        let note_bytes = if version == 1 { 0 } else { size(&mut cursor, "the size of the note")? };
        let start = header_bytes(version).unwrap_or_default() - OLD_WAVE_BYTES;
        let mut cursor = cursor.at(start);
        let type_offset = cursor.at;
        let type_code = cursor.u16("the type of the numbers")?;
        let mut wave = Self { type_code, type_offset, ..Self::default() };
        cursor.skip(4, "reserved bytes")?;
        wave.name = cursor.text(20, "the name of the wave")?;
        cursor.skip(8, "reserved bytes")?;
        wave.value_unit = cursor.text(4, "the unit of the values")?;
        wave.step_units[0] = cursor.text(4, "the unit of the dimension")?;
        wave.points[0] = size(&mut cursor, "the number of points")?;
        cursor.skip(2, "reserved bytes")?;
        wave.steps[0] = cursor.f64("the step of the dimension")?;
        wave.data_offset = start + OLD_WAVE_BYTES;
        // The size of the wave counts the padding behind the numbers.
        let cursor = cursor.at(start.saturating_add(wave_bytes));
        let note = cursor.rest();
        wave.note = latin1_at_most(note.get(..note_bytes).unwrap_or(note), LONGEST_NOTE);
        Ok(wave)
    }

    /// Refuses a wave without points, and numbers beyond the end of the file.
    fn check_points(&self, cursor: &Cursor) -> Result<(), ScanReadError> {
        let used: Vec<usize> = self.points.iter().copied().take_while(|&points| points > 0).collect();
        let number = self.number(cursor)?;
        let product = used.iter().try_fold(number.bytes(), |all, &points| all.checked_mul(points));
        let mut data = cursor.at(self.data_offset);
        match product {
            Some(bytes) if !used.is_empty() => data.skip(bytes, &format!("a wave of {used:?} points")),
            _ => {
                let found = format!("{:?}", self.points);
                Err(data.bad(
                    self.data_offset,
                    "the number of points of the dimensions",
                    &found,
                    "at least one",
                ))
            }
        }
    }

    fn number(&self, cursor: &Cursor) -> Result<NumberType, ScanReadError> {
        Ok(match self.type_code {
            0x02 => NumberType::F32,
            0x04 => NumberType::F64,
            0x08 => NumberType::I8,
            0x10 => NumberType::I16,
            0x20 => NumberType::I32,
            0x80 => NumberType::I64,
            0x48 => NumberType::U8,
            0x50 => NumberType::U16,
            0x60 => NumberType::U32,
            0xc0 => NumberType::U64,
            code => {
                let bound = "2, 4, 8, 16, 32 or 128, with 64 added where there is no sign: texts and complex numbers are no \
                             heights";
                return Err(cursor.bad(self.type_offset, "the type of the numbers", code, bound));
            }
        })
    }

    /// The numbers of one layer of so many columns and rows; the first is the lowest row.
    pub(super) fn raster<'b>(
        &self,
        bytes: &'b [u8],
        columns: usize,
        rows: usize,
        layer: usize,
    ) -> Result<Raster<'b>, ScanReadError> {
        let order = self.order.unwrap_or(ByteOrder::Little);
        let number = self.number(&Cursor::new(FORMAT, bytes, order))?;
        let before = columns.saturating_mul(rows).saturating_mul(layer).saturating_mul(number.bytes());
        let offset = self.data_offset.saturating_add(before);
        let raster = Raster::within(number, columns, rows, bytes, offset);
        Ok(Raster { byte_order: order, order: crate::raster::Order::RowsFromBottom, ..raster })
    }
}

/// A size or count of four bytes.
fn size(cursor: &mut Cursor, what: &str) -> Result<usize, ScanReadError> {
    let offset = cursor.at;
    let size = cursor.i32(what)?;
    usize::try_from(size).map_err(|_| cursor.bad(offset, what, size, "at least 0"))
}

fn sizes(cursor: &mut Cursor, what: &str) -> Result<[usize; DIMENSIONS], ScanReadError> {
    let mut sizes = [0; DIMENSIONS];
    for found in &mut sizes {
        *found = size(cursor, what)?;
    }
    Ok(sizes)
}
