//! Arrays of NumPy: `.npy` as NumPy's documentation of `numpy.lib.format` lays it down, and `.npz`, a ZIP file of them.
//!
//! The first index of a map counts its rows, as in images. An array has neither unit nor size.

#[cfg(feature = "archives")]
use crate::channel::refuse_many;
use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;

const FORMAT: ScanFormat = ScanFormat::Numpy;
const MAGIC: &[u8] = b"\x93NUMPY";
/// Headers of arrays of numbers take some hundred bytes.
const LONGEST_HEADER: usize = 1 << 16;
#[cfg(feature = "archives")]
const SUFFIX: &str = ".npy";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || is_archive(bytes)
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    if bytes.starts_with(MAGIC) {
        let array = Array::read(bytes)?;
        return Ok(vec![array.channel(None, bytes.get(array.data..).unwrap_or_default().into())]);
    }
    arrays(bytes, options)
}

/// Returns true if the first file of a ZIP file is an array.
#[cfg(feature = "archives")]
fn is_archive(bytes: &[u8]) -> bool {
    let length =
        bytes.get(26..28).and_then(|length| length.first_chunk()).map(|length| u16::from_le_bytes(*length));
    let name = length.and_then(|length| bytes.get(30..30 + usize::from(length)));
    crate::archive::is_zip(bytes) && name.is_some_and(|name| name.ends_with(SUFFIX.as_bytes()))
}

#[cfg(not(feature = "archives"))]
fn is_archive(_: &[u8]) -> bool {
    false
}

/// The arrays of an archive, each a channel; what is none, such as a name or a single number, is left out.
#[cfg(feature = "archives")]
fn arrays<'b>(bytes: &[u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut archive = crate::archive::Archive::open(bytes, options.unpacked_bound())?;
    let paths: Vec<String> =
        archive.paths().filter(|path| path.ends_with(SUFFIX)).map(str::to_owned).collect();
    refuse_many(FORMAT, paths.len())?;
    let mut channels = Vec::new();
    for path in paths {
        let name = path.strip_suffix(SUFFIX).unwrap_or(&path).to_owned();
        let mut content = archive.read(&path)?;
        let array = Array::read(&content)?;
        if array.shape.iter().product::<usize>() < 2 || array.numbers.is_none() {
            continue;
        }
        let data = content.split_off(array.data.min(content.len()));
        let channel = array.channel(Some(name.clone()), data.into());
        // Coordinates lie beside the heights they belong to.
        let is_coordinate = ["x", "y"].iter().any(|axis| name.eq_ignore_ascii_case(axis));
        let quantity = if is_coordinate { Quantity::Other(String::new()) } else { channel.quantity.clone() };
        channels.push(Channel { quantity, ..channel });
    }
    Ok(channels)
}

#[cfg(not(feature = "archives"))]
fn arrays<'b>(_: &[u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    Ok(Vec::new())
}

/// Header of an array.
struct Array {
    shape: Vec<usize>,
    /// None of arrays of other things than real numbers.
    numbers: Option<(NumberType, ByteOrder)>,
    /// The type as written.
    described: String,
    is_fortran: bool,
    /// Offset of the numbers.
    data: usize,
}

impl Array {
    fn read(bytes: &[u8]) -> Result<Self, ScanReadError> {
        let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little);
        cursor.skip(MAGIC.len(), "the beginning of the file")?;
        let version = cursor.u8("the version")?;
        cursor.skip(1, "the version")?;
        let length = match version {
            1 => usize::from(cursor.u16("the length of the header")?),
            2 | 3 => cursor.count("the length of the header")?,
            _ => return Err(cursor.bad(MAGIC.len(), "the version", version, "1, 2 or 3")),
        };
        let at = cursor.at;
        if length > LONGEST_HEADER {
            let bound = format!("at most {LONGEST_HEADER}");
            return Err(cursor.bad(at, "the length of the header", length, &bound));
        }
        let header = String::from_utf8_lossy(cursor.take(length, "the header")?).into_owned();
        let missing = |field: &str| {
            let mend = "save the array again";
            FORMAT.missing(FilePlace::Byte(at as u64), format!("entry '{field}' in the header"), mend)
        };
        let entry = |key: &str| {
            let (_, rest) = header.split_once(&format!("'{key}'"))?;
            rest.trim_start().strip_prefix(':').map(str::trim_start)
        };
        let shape = entry("shape").and_then(|text| text.strip_prefix('(')?.split_once(')'));
        let (shape, _) = shape.ok_or_else(|| missing("shape"))?;
        let lengths = shape.split(',').map(str::trim).filter(|length| !length.is_empty());
        let lengths: Result<Vec<usize>, _> = lengths.map(str::parse).collect();
        let bad_shape =
            || cursor.bad(at, "the shape", format!("({shape})"), "whole numbers whose product is one");
        let shape = lengths.map_err(|_| bad_shape())?;
        shape.iter().try_fold(1usize, |points, &length| points.checked_mul(length)).ok_or_else(bad_shape)?;
        let described = entry("descr").ok_or_else(|| missing("descr"))?;
        let quoted = described.strip_prefix('\'').and_then(|text| text.split_once('\''));
        let described = quoted.map_or("a structure", |(described, _)| described).to_owned();
        Ok(Self {
            numbers: numbers(&described),
            is_fortran: entry("fortran_order").ok_or_else(|| missing("fortran_order"))?.starts_with("True"),
            shape,
            described,
            data: cursor.at,
        })
    }

    /// A line or a map; axes of one point do not count.
    fn channel<'b>(&self, name: Option<String>, data: std::borrow::Cow<'b, [u8]>) -> Channel<'b> {
        let axes: Vec<usize> = self.shape.iter().copied().filter(|&length| length != 1).collect();
        let (rows, columns) = match axes[..] {
            [] => (1, 1),
            [columns] => (1, columns),
            [rows, columns] => (rows, columns),
            _ => (0, 0),
        };
        let found = match self.numbers {
            _ if columns == 0 || rows == 0 => Err(format!("an array of the shape {:?}", self.shape)),
            None => Err(format!("an array of the type '{}'", self.described)),
            Some(numbers) => Ok(numbers),
        };
        let samples = match found {
            Err(found) => Samples::Unreadable(Box::new(FORMAT.unsupported(
                FilePlace::File,
                found,
                "save one line or map of real numbers",
            ))),
            Ok((number, byte_order)) => {
                let order = if self.is_fortran { Order::ColumnsFromTop } else { Order::RowsFromTop };
                let raster = Raster::new(number, columns, rows, data, self.data);
                Samples::Raster(Raster { byte_order, order, ..raster })
            }
        };
        let mut channel = Channel::new(name, Quantity::Heights(None), Lateral::Unknown, samples);
        if rows > 1 {
            channel
                .notes
                .push("the first index of the array is taken to count the rows of the map".to_owned());
        }
        channel
    }
}

/// The type of an array of real numbers, such as `<f8`.
fn numbers(described: &str) -> Option<(NumberType, ByteOrder)> {
    let order = if described.starts_with('>') { ByteOrder::Big } else { ByteOrder::Little };
    let number = match described.trim_start_matches(['<', '>', '|', '=']) {
        "i1" => NumberType::I8,
        "u1" => NumberType::U8,
        "i2" => NumberType::I16,
        "u2" => NumberType::U16,
        "i4" => NumberType::I32,
        "u4" => NumberType::U32,
        "i8" => NumberType::I64,
        "u8" => NumberType::U64,
        "f4" => NumberType::F32,
        "f8" => NumberType::F64,
        "f2" => NumberType::F16,
        _ => return None,
    };
    Some((number, order))
}
