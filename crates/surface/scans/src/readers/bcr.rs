//! BCR-STM and BCRF of Image Metrology, which many programs exchange: `.bcr`, `.bcrf`.
//!
//! Keys and values in a header of 2048 or 4096 characters, in Latin-1 or UTF-16, then counts of two bytes or
//! floating-point numbers row after row, as the help of SPIP lays it down and the readers of Gwyddion and
//! SurfaceTopography take it.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::ByteOrder;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Bcr;
/// Characters of a header without a length.
const HEADER_CHARACTERS: usize = 2048;
/// Characters of a header that are looked at; what pads a longer one holds no keys.
const LONGEST_CHARACTERS: usize = 1 << 18;
/// Characters that include the line with the format.
const FIRST_CHARACTERS: usize = 64;
const FORMAT_KEY: &str = "fileformat";
/// Counts and floating-point numbers that mark points without a height.
const MISSING_COUNT: f64 = 32767.0;
const MISSING_NUMBER: f64 = 1.7e38;
/// Lengths are in this unit where a file names none.
const UNIT: LengthUnit = LengthUnit::NANOMETRE;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// Storage of the characters of a header.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Encoding {
    Latin1,
    Utf16(ByteOrder),
}

fn recognises(bytes: &[u8]) -> bool {
    let header = Header::parse(bytes, encoding(bytes), FIRST_CHARACTERS);
    header.entries.first().is_some_and(|(key, value)| key == FORMAT_KEY && value.starts_with("bcr"))
}

fn encoding(bytes: &[u8]) -> Encoding {
    match bytes {
        [0xff, 0xfe, ..] => Encoding::Utf16(ByteOrder::Little),
        [0xfe, 0xff, ..] => Encoding::Utf16(ByteOrder::Big),
        [_, 0, ..] => Encoding::Utf16(ByteOrder::Little),
        [0, _, ..] => Encoding::Utf16(ByteOrder::Big),
        _ => Encoding::Latin1,
    }
}

impl Encoding {
    fn character_bytes(self) -> usize {
        match self {
            Self::Latin1 => 1,
            Self::Utf16(_) => 2,
        }
    }

    fn decoded(self, bytes: &[u8]) -> String {
        let unit = match self {
            Self::Latin1 => return bytes.iter().map(|&byte| char::from(byte)).collect(),
            Self::Utf16(ByteOrder::Little) => u16::from_le_bytes,
            Self::Utf16(ByteOrder::Big) => u16::from_be_bytes,
        };
        let units: Vec<u16> = bytes.as_chunks().0.iter().copied().map(unit).collect();
        String::from_utf16_lossy(&units).trim_start_matches('\u{feff}').to_owned()
    }
}

/// Keys in lower case with their values, in the order of the file.
struct Header {
    entries: Vec<(String, String)>,
}

impl Header {
    fn parse(bytes: &[u8], encoding: Encoding, characters: usize) -> Self {
        let length = characters.saturating_mul(encoding.character_bytes()).min(bytes.len());
        let text = encoding.decoded(bytes.get(..length).unwrap_or_default());
        let text = text.split('\0').next().unwrap_or_default();
        let lines = text.lines().filter(|line| !line.starts_with(['%', '#']));
        let entry = |line: &str| {
            let (key, value) = line.split_once('=')?;
            Some((key.trim().to_lowercase(), value.trim().to_owned()))
        };
        Self { entries: lines.filter_map(entry).collect() }
    }

    /// A value that is given.
    fn get(&self, key: &str) -> Option<&str> {
        let found = self.entries.iter().find(|(own, _)| own == key)?;
        Some(found.1.as_str()).filter(|value| !value.is_empty())
    }

    fn number(&self, key: &str) -> Option<f64> {
        numbers::finite(self.get(key)?)
    }

    fn count(&self, key: &str) -> Result<usize, ScanReadError> {
        let value = self.get(key).ok_or_else(|| {
            FORMAT.missing(FilePlace::File, format!("'{key}' in the header"), "export the file again")
        })?;
        numbers::count(value).ok_or_else(|| bad(key, value, "a whole number above 0"))
    }

    fn length_unit(&self, key: &str) -> Option<LengthUnit> {
        self.get(key).map_or(Some(UNIT), LengthUnit::parse_instrument)
    }
}

fn bad(key: &str, value: &str, bound: &str) -> ScanReadError {
    let mend = "export the file again";
    FORMAT.bad(FilePlace::File, format!("'{key}' in the header"), quoted(value), bound, mend)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let encoding = encoding(bytes);
    let start = Header::parse(bytes, encoding, HEADER_CHARACTERS);
    let characters = start.get("headersize").map_or(Ok(HEADER_CHARACTERS), |_| start.count("headersize"))?;
    let header = Header::parse(bytes, encoding, characters.min(LONGEST_CHARACTERS));
    let offset = characters.saturating_mul(encoding.character_bytes());
    let mut notes = Vec::new();
    let quantity = match (header.length_unit("zunit"), header.get("zunit")) {
        (None, Some(unit)) => Quantity::Other(unit.to_owned()),
        (unit, _) => Quantity::Heights(Some(unit.unwrap_or(UNIT))),
    };
    let raster = raster(&header, bytes, offset, &mut notes)?;
    let lateral = lateral(&header, raster.rows);
    Ok(vec![Channel { notes, ..Channel::new(None, quantity, lateral, Samples::Raster(raster)) }])
}

fn raster<'b>(
    header: &Header,
    bytes: &'b [u8],
    offset: usize,
    notes: &mut Vec<String>,
) -> Result<Raster<'b>, ScanReadError> {
    let [columns, rows] = [header.count("xpixels")?, header.count("ypixels")?];
    // The number of points without a height, in some files their mark; where it is 0 there are none.
    let has_missing = header.number("voidpixels") != Some(0.0);
    let (number, scale, missing) = match header.get(FORMAT_KEY).unwrap_or_default() {
        "bcrstm" | "bcrstm_unicode" => {
            let scale = header.number("bit2nm").filter(|&scale| scale != 0.0);
            if scale.is_none() {
                notes.push("the file does not say the height of a count; it is taken to be 1".to_owned());
            }
            (NumberType::I16, scale.unwrap_or(1.0), MissingMark::Equal(MISSING_COUNT))
        }
        "bcrf" | "bcrf_unicode" => (NumberType::F32, 1.0, MissingMark::AtLeast(MISSING_NUMBER)),
        other => return Err(bad(FORMAT_KEY, other, "bcrstm or bcrf")),
    };

    Ok(Raster {
        byte_order: match header.number("intelmode") {
            Some(0.0) => ByteOrder::Big,
            _ => ByteOrder::Little,
        },
        scale,
        missing: if has_missing { missing } else { MissingMark::None },
        ..Raster::within(number, columns, rows, bytes, offset)
    })
}

/// The lengths of rows and columns, as many spacings as they have points.
fn lateral(header: &Header, rows: usize) -> Lateral {
    let length_m =
        |length: &str, unit: &str| numbers::positive(header.length_unit(unit)?.to_m(header.number(length)?));
    match (length_m("xlength", "xunit"), length_m("ylength", "yunit")) {
        (Some(x_m), _) if rows == 1 => Lateral::Size(ScanSize { x_m, y_m: None }),
        (Some(x_m), Some(y_m)) => Lateral::Size(ScanSize { x_m, y_m: Some(y_m) }),
        _ => Lateral::Unknown,
    }
}
