//! Files of Molecular Imaging's and Agilent's microscopes, `.mi`: lines of a key of fourteen letters and a value, then
//! the numbers of all channels, one after the other.
//!
//! The layout is that which Gwyddion's importer follows, whose author wrote it for the maker.

use crate::channel::{Channel, Lateral, Quantity, Samples, ScanAxis, refuse_many};
use crate::cursor::latin1;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{Decoded, NumberType, Order, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::MolecularImaging;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

const FIRST_KEY: &[u8] = b"fileType      ";
const KEY_BYTES: usize = FIRST_KEY.len();
/// Headers take some ten kilobytes; a file that goes on with lines beyond this is none.
const LONGEST: usize = 1 << 20;
/// Largest stored number of 16 bits, which stands for the range of a channel, also where the numbers are text.
const FULL_16: f64 = 32_768.0;
const FULL_32: f64 = 2_147_483_648.0;

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(FIRST_KEY)
}

/// Keys and values, those of the scan as a whole or of one channel.
type Entries = Vec<(String, String)>;

struct Header {
    scan: Entries,
    channels: Vec<Entries>,
    /// Encoding of the numbers.
    data: String,
    data_offset: usize,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let header = Header::read(bytes)?;
    let kind = get(&header.scan, "fileType").unwrap_or_default();
    if kind != "Image" {
        let mend = "export an image of heights";
        return Err(FORMAT.unsupported(FilePlace::Byte(0), format!("a file of type '{kind}'"), mend));
    }
    let columns = count(&header.scan, "xPixels")?;
    let rows = count(&header.scan, "yPixels")?;
    let points = columns.checked_mul(rows).ok_or_else(|| bad("xPixels", columns, "a smaller number"))?;
    let binary = match header.data.as_str() {
        "BINARY" | "" => Some((NumberType::I16, FULL_16)),
        "BINARY_32" => Some((NumberType::I32, FULL_32)),
        "ASCII" => None,
        other => return Err(bad("data", other, "BINARY, BINARY_32 or ASCII")),
    };
    let mut words = bytes.get(header.data_offset..).unwrap_or_default().split(u8::is_ascii_whitespace);
    let read = |(index, entries): (usize, &Entries)| {
        let samples = match binary {
            Some((number, full)) => range(entries).map(|range| {
                let before = points.saturating_mul(number.bytes()).saturating_mul(index);
                let raster =
                    Raster::within(number, columns, rows, bytes, header.data_offset.saturating_add(before));
                Samples::Raster(Raster { order: Order::RowsFromBottom, scale: range / full, ..raster })
            }),
            // Samples in text begin with the uppermost row.
            None => text_numbers(words.by_ref(), points, index)
                .and_then(|numbers| range(entries).map(|range| (numbers, range / FULL_16)))
                .map(|(numbers, scale)| {
                    let decoded = numbers.into_iter().map(|number| Some(number * scale)).collect::<Decoded>();
                    Samples::Decoded { columns, decoded }
                }),
        };
        channel(&header.scan, entries, rows, samples)
    };
    Ok(header.channels.iter().enumerate().map(read).collect())
}

impl Header {
    fn read(bytes: &[u8]) -> Result<Self, ScanReadError> {
        let mut header = Self { scan: Vec::new(), channels: Vec::new(), data: String::new(), data_offset: 0 };
        let head = bytes.get(..LONGEST).unwrap_or(bytes);
        for raw in head.split_inclusive(|&byte| byte == b'\n') {
            header.data_offset += raw.len();
            let (key, value) = raw.split_at(raw.len().min(KEY_BYTES));
            // Lines that begin with a blank go on with the value before.
            if key.trim_ascii().is_empty() || key.starts_with(b" ") {
                continue;
            }
            let (key, value) = (latin1(key), latin1(value));
            if key == "data" && raw.ends_with(b"\n") {
                header.data = value;
                return Ok(header);
            }
            if key == "bufferLabel" {
                header.channels.push(Vec::new());
                refuse_many(FORMAT, header.channels.len())?;
            }
            header.channels.last_mut().unwrap_or(&mut header.scan).push((key, value));
        }
        let mend = "the file is cut off: export it again";
        Err(FORMAT.missing(FilePlace::Byte(head.len() as u64), "line 'data' before it", mend))
    }
}

fn get<'e>(entries: &'e Entries, key: &str) -> Option<&'e str> {
    entries.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
}

fn require<'e>(entries: &'e Entries, key: &str) -> Result<&'e str, ScanReadError> {
    get(entries, key).ok_or_else(|| {
        FORMAT.missing(FilePlace::File, format!("'{key}' in the header"), "export the file again")
    })
}

fn count(entries: &Entries, key: &str) -> Result<usize, ScanReadError> {
    let text = require(entries, key)?;
    numbers::count(text).ok_or_else(|| bad(key, text, "a whole number above 0"))
}

/// Value of the largest number of a channel, in its unit.
fn range(entries: &Entries) -> Result<f64, ScanReadError> {
    let text = require(entries, "bufferRange")?;
    numbers::finite(text).ok_or_else(|| bad("bufferRange", text, "a number"))
}

fn bad(field: &str, value: impl ToString, bound: &str) -> ScanReadError {
    let mend = "the header is damaged: export the file again";
    FORMAT.bad(FilePlace::File, format!("'{field}'"), quoted(&value.to_string()), bound, mend)
}

/// The numbers of a channel from a file of text; nothing is set aside for those that are not there.
fn text_numbers<'b>(
    words: impl Iterator<Item = &'b [u8]>,
    points: usize,
    channel: usize,
) -> Result<Vec<f64>, ScanReadError> {
    let mut numbers = Vec::new();
    for word in words.filter(|word| !word.is_empty()).take(points) {
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        numbers.push(number.ok_or_else(|| {
            let field = format!("number {} of channel {}", numbers.len() + 1, channel + 1);
            bad(&field, latin1(word), "a number")
        })?);
    }
    if numbers.len() < points {
        let field = format!("channel {}", channel + 1);
        return Err(bad(&field, format!("{} numbers", numbers.len()), &format!("{points} numbers")));
    }
    Ok(numbers)
}

fn channel<'b>(
    scan: &Entries,
    entries: &Entries,
    rows: usize,
    samples: Result<Samples<'b>, ScanReadError>,
) -> Channel<'b> {
    let text = |key: &str| get(entries, key).unwrap_or_default();
    let label = text("bufferLabel");
    let quantity = Quantity::named(label, text("bufferUnit"), LengthUnit::parse(text("bufferUnit")));
    let name = match text("trace") {
        "" => label.to_owned(),
        trace => format!("{label} ({trace})"),
    };
    let length_m = |key: &str| numbers::positive(get(scan, key)?.parse().ok()?);
    let lateral = match (length_m("xLength"), length_m("yLength").filter(|_| rows > 1)) {
        (Some(x_m), y_m) if rows == 1 || y_m.is_some() => Lateral::Size(ScanSize { x_m, y_m }),
        _ => Lateral::Unknown,
    };
    let samples = samples.unwrap_or_else(|error| Samples::Unreadable(Box::new(error)));
    Channel {
        probe: Some(Probe::Tip),
        fast_axis: (rows > 1).then_some(ScanAxis::X),
        free_text: get(scan, "comment").unwrap_or_default().to_owned(),
        ..Channel::new(Some(name), quantity, lateral, samples)
    }
}
