//! Matrices of MATLAB, `.mat` of version 5 (`save -v6` and `-v7`), as MathWorks' description of the format has it:
//! elements with a tag each, single ones packed by zlib, matrices column after column.
//!
//! A matrix of real numbers is a map, its rows along y, or a line where it has one row or column; fields of a single
//! structure are looked into. Unit and size are asked for.

#[cfg(feature = "archives")]
use std::io::Read;

use crate::channel::{Channel, Lateral, Quantity, Samples, refuse_many};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use crate::room::Room;

const FORMAT: ScanFormat = ScanFormat::Matlab;
const BEGINNING: &[u8] = b"MATLAB 5.0 MAT-file";
const HEADER_BYTES: usize = 128;
/// Bytes of the header that show the order of bytes.
const ORDER_OFFSET: usize = 126;
/// Elements begin at multiples of these bytes.
const ALIGNMENT: usize = 8;
/// Structures within structures that are looked into.
const DEEPEST: usize = 4;

/// Types of elements.
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Classes of matrices: structures, and the first and last class of numbers.
const STRUCTURE: u32 = 2;
const NUMBERS: std::ops::RangeInclusive<u32> = 6..=15;
/// The flag of complex numbers, and that of truth values.
const COMPLEX: u32 = 0x800;
const LOGICAL: u32 = 0x200;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(BEGINNING)
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let order = match bytes.get(ORDER_OFFSET..HEADER_BYTES) {
        Some(b"IM") => ByteOrder::Little,
        Some(b"MI") => ByteOrder::Big,
        _ => return Err(FORMAT.missing(FilePlace::File, "header of 128 bytes", "export the file again")),
    };
    let mut found = Matrices::default();
    let mut room = Room::new(options.unpacked_bound());
    let mut cursor = Cursor::new(FORMAT, bytes, order).at(HEADER_BYTES);
    while !cursor.rest().is_empty() {
        let element = Element::read(&mut cursor)?;
        if element.kind != COMPRESSED {
            found.add(&element, order, "", 0)?;
            continue;
        }
        let unpacked = inflated(element.bytes, &mut room)?;
        let element = Element::read(&mut Cursor::new(FORMAT, &unpacked, order))?;
        // What was unpacked does not outlive the file: its numbers are kept.
        let mut packed = Matrices::default();
        packed.add(&element, order, "", 0)?;
        packed.0.into_iter().for_each(|matrix| found.0.push(matrix.owned()));
    }
    refuse_many(FORMAT, found.0.len())?;
    let has_maps = found.0.iter().any(|matrix| matrix.columns > 1 && matrix.rows > 1);
    let wanted = found.0.into_iter().filter(|matrix| !has_maps || (matrix.columns > 1 && matrix.rows > 1));
    Ok(wanted.map(Matrix::channel).collect())
}

#[cfg(feature = "archives")]
fn inflated(packed: &[u8], room: &mut Room) -> Result<Vec<u8>, ScanReadError> {
    let mut unpacked = Vec::new();
    let decoder = flate2::read::ZlibDecoder::new(packed);
    let problem = |error: std::io::Error| ScanReadError::Zip {
        what: "a variable of the MATLAB file".to_owned(),
        problem: error.to_string(),
    };
    decoder.take(room.left.saturating_add(1)).read_to_end(&mut unpacked).map_err(problem)?;
    room.take(unpacked.len() as u64, || "the MATLAB file".to_owned())?;
    Ok(unpacked)
}

#[cfg(not(feature = "archives"))]
fn inflated(_: &[u8], _: &mut Room) -> Result<Vec<u8>, ScanReadError> {
    Err(FORMAT.unsupported(FilePlace::File, "a packed variable", "save the file with the option -v6"))
}

/// An element: its type and its bytes, with their offset.
struct Element<'b> {
    kind: u32,
    bytes: &'b [u8],
    offset: usize,
}

impl<'b> Element<'b> {
    /// Reads an element; the cursor then is at the next one. Up to four bytes stand within the tag.
    fn read(cursor: &mut Cursor<'b>) -> Result<Self, ScanReadError> {
        let start = cursor.at;
        let kind = cursor.u32("the type of an element")?;
        if kind >> 16 != 0 {
            let offset = cursor.at;
            let length = (kind >> 16) as usize;
            let bytes = cursor.take(4, "a small element")?.get(..length);
            let bytes =
                bytes.ok_or_else(|| cursor.bad(start, "the size of a small element", length, "at most 4"))?;
            return Ok(Self { kind: kind & 0xffff, bytes, offset });
        }
        let length = cursor.u32("the size of an element")? as usize;
        let offset = cursor.at;
        let bytes = cursor.take(length, "an element")?;
        // Packed elements are not padded, nor is the last of a file.
        if kind != COMPRESSED {
            let padding = length.next_multiple_of(ALIGNMENT) - length;
            cursor.at += padding.min(cursor.rest().len());
        }
        Ok(Self { kind, bytes, offset })
    }
}

/// A matrix of real numbers.
struct Matrix<'b> {
    name: String,
    columns: usize,
    rows: usize,
    raster: Raster<'b>,
}

#[derive(Default)]
struct Matrices<'b>(Vec<Matrix<'b>>);

impl<'b> Matrices<'b> {
    /// Adds a matrix, or those in the fields of a structure, under a name that begins so.
    fn add(
        &mut self,
        element: &Element<'b>,
        order: ByteOrder,
        path: &str,
        depth: usize,
    ) -> Result<(), ScanReadError> {
        if element.kind != MATRIX || element.bytes.is_empty() {
            return Ok(());
        }
        let mut cursor = Cursor::new(FORMAT, element.bytes, order);
        let flags = Element::read(&mut cursor)?;
        let flags = Cursor::new(FORMAT, flags.bytes, order).u32("the flags of a matrix")?;
        let dimensions = Element::read(&mut cursor)?;
        let mut sizes = Cursor::new(FORMAT, dimensions.bytes, order);
        let (rows, columns) = (sizes.u32("the number of rows")?, sizes.u32("the number of columns")?);
        let (rows, columns) = (rows as usize, columns as usize);
        let is_flat = sizes.rest().is_empty();
        let own = latin1(Element::read(&mut cursor)?.bytes);
        let name = if own.is_empty() { path.to_owned() } else { format!("{path}{own}") };
        let class = flags & 0xff;
        if class == STRUCTURE && rows == 1 && columns == 1 && is_flat && depth < DEEPEST {
            return self.add_fields(&mut cursor, order, &name, depth);
        }
        if !NUMBERS.contains(&class) || flags & (COMPLEX | LOGICAL) != 0 || !is_flat || rows.max(columns) < 2
        {
            return Ok(());
        }
        let data = Element::read(&mut cursor)?;
        // Numbers are stored in the smallest type that holds them, whatever their class is.
        let number = match data.kind {
            1 => NumberType::I8,
            2 => NumberType::U8,
            3 => NumberType::I16,
            4 => NumberType::U16,
            5 => NumberType::I32,
            6 => NumberType::U32,
            7 => NumberType::F32,
            9 => NumberType::F64,
            12 => NumberType::I64,
            13 => NumberType::U64,
            other => {
                return Err(cursor.bad(data.offset, "the type of the numbers", other, "1 to 7, 9, 12 or 13"));
            }
        };
        let is_line = rows == 1 || columns == 1;
        let (columns, rows) = if is_line { (rows.max(columns), 1) } else { (columns, rows) };
        let raster = Raster {
            byte_order: order,
            order: if is_line { Order::RowsFromTop } else { Order::ColumnsFromTop },
            ..Raster::new(number, columns, rows, data.bytes, data.offset)
        };
        refuse_many(FORMAT, self.0.len() + 1)?;
        self.0.push(Matrix { name, columns, rows, raster });
        Ok(())
    }

    fn add_fields(
        &mut self,
        cursor: &mut Cursor<'b>,
        order: ByteOrder,
        name: &str,
        depth: usize,
    ) -> Result<(), ScanReadError> {
        let length = Element::read(cursor)?;
        let length =
            Cursor::new(FORMAT, length.bytes, order).u32("the length of the names of fields")? as usize;
        let names = Element::read(cursor)?;
        for field in names.bytes.chunks(length.max(1)) {
            let path = format!("{name}.{}", latin1(field));
            self.add(&Element::read(cursor)?, order, &path, depth + 1)?;
        }
        Ok(())
    }
}

impl Matrix<'_> {
    fn owned(self) -> Matrix<'static> {
        let Self { name, columns, rows, raster } = self;
        let bytes = raster.bytes.into_owned();
        let copied = Raster::new(raster.number, columns, rows, bytes, raster.offset);
        Matrix {
            name,
            columns,
            rows,
            raster: Raster { byte_order: raster.byte_order, order: raster.order, ..copied },
        }
    }
}

impl<'b> Matrix<'b> {
    fn channel(self) -> Channel<'b> {
        let is_map = self.rows > 1;
        let samples = Samples::Raster(self.raster);
        let mut channel = Channel::new(Some(self.name), Quantity::Heights(None), Lateral::Unknown, samples);
        if is_map {
            channel.notes.push("the rows of the matrix are taken for those of the map".to_owned());
        }
        channel
    }
}
