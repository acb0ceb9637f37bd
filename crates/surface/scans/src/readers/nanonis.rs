//! Images of Nanonis controllers, `.sxm`: tags between colons, each with lines of values, a table of channels, then
//! big-endian single-precision numbers in physical units, an image for each direction of a channel.
//!
//! The layout is that which Gwyddion's importer and nanonispy follow.

use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, ScanAxis, refuse_many, shortened};
use crate::cursor::ByteOrder;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use memchr::memmem;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Nanonis;
const BEGINNING: &[u8] = b":NANONIS_VERSION:";
/// The last tag, and the bytes before the numbers.
const END: &[u8] = b":SCANIT_END:";
const DATA: &[u8] = b"\x1a\x04";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(BEGINNING)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let end = memmem::find(bytes, END).ok_or_else(|| missing("tag SCANIT_END"))?;
    let start = memmem::find(&bytes[end..], DATA).ok_or_else(|| missing("mark before the numbers"))?;
    let header = Header::parse(&bytes[..end]);
    let kind = header.line("SCANIT_TYPE")?;
    if !kind.split_whitespace().eq(["FLOAT", "MSBFIRST"]) {
        return Err(bad("SCANIT_TYPE", kind, "FLOAT MSBFIRST"));
    }
    let [columns, rows] = header.pair("SCAN_PIXELS", numbers::count, "two whole numbers above 0")?;
    let positive = |text: &str| numbers::finite(text).and_then(numbers::positive);
    let [x_m, y_m] = header.pair("SCAN_RANGE", positive, "two lengths in m")?;
    let lateral = Lateral::Size(ScanSize { x_m, y_m: Some(y_m) });
    let order = match header.line("SCAN_DIR")? {
        "up" => Order::RowsFromBottom,
        "down" => Order::RowsFromTop,
        other => return Err(bad("SCAN_DIR", other, "up or down")),
    };
    let free_text = shortened(header.tag("COMMENT").unwrap_or_default().trim().to_owned(), MOST_TEXT);
    let images = header.images()?;
    refuse_many(FORMAT, images.len())?;
    let first = end + start + DATA.len();
    let bytes_each = columns.saturating_mul(rows).saturating_mul(NumberType::F32.bytes());
    let channel = |(at, image): (usize, Image)| {
        let offset = first.saturating_add(bytes_each.saturating_mul(at));
        let raster = Raster {
            order,
            byte_order: ByteOrder::Big,
            is_mirrored: image.is_backward,
            ..Raster::within(NumberType::F32, columns, rows, bytes, offset)
        };
        // A scan that was stopped has no numbers in its last lines, an image that is cut off none at all.
        let samples = raster.check(FORMAT).map(|()| raster).into();
        let direction = if image.is_backward { "Backward" } else { "Forward" };
        let quantity = Quantity::named(&image.name, &image.unit, LengthUnit::parse(&image.unit));
        let name = Some(format!("{} ({direction})", image.name));
        Channel {
            probe: Some(Probe::Tip),
            fast_axis: Some(ScanAxis::X),
            free_text: free_text.clone(),
            ..Channel::new(name, quantity, lateral.clone(), samples)
        }
    };
    Ok(images.into_iter().enumerate().map(channel).collect())
}

/// An image of a channel in one direction.
struct Image {
    name: String,
    unit: String,
    is_backward: bool,
}

/// The tags with the lines behind each.
struct Header(Vec<(String, String)>);

impl Header {
    fn parse(bytes: &[u8]) -> Self {
        let text = String::from_utf8_lossy(bytes);
        let mut tags: Vec<(String, String)> = Vec::new();
        for line in text.lines() {
            let name = line.trim_end().strip_prefix(':').and_then(|line| line.strip_suffix(':'));
            match (name, tags.last_mut()) {
                (Some(name), _) => tags.push((name.to_owned(), String::new())),
                (None, Some((_, lines))) => lines.extend([line, "\n"]),
                (None, None) => {}
            }
        }
        Self(tags)
    }

    fn tag(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(own, _)| own == name).map(|(_, lines)| lines.as_str())
    }

    fn line(&self, name: &str) -> Result<&str, ScanReadError> {
        self.tag(name).map(str::trim).ok_or_else(|| missing(&format!("tag {name}")))
    }

    fn pair<T>(
        &self,
        name: &str,
        parse: fn(&str) -> Option<T>,
        bound: &str,
    ) -> Result<[T; 2], ScanReadError> {
        let line = self.line(name)?;
        let mut numbers = line.split_whitespace().map(parse);
        match (numbers.next().flatten(), numbers.next().flatten(), numbers.next()) {
            (Some(x), Some(y), None) => Ok([x, y]),
            _ => Err(bad(name, line, bound)),
        }
    }

    /// The images in the order of their numbers, by the table of channels.
    fn images(&self) -> Result<Vec<Image>, ScanReadError> {
        const TABLE: &str = "DATA_INFO";
        let table = self.tag(TABLE).ok_or_else(|| missing("tag DATA_INFO"))?;
        let mut images = Vec::new();
        for line in table.lines().skip(1).filter(|line| !line.trim().is_empty()) {
            let cells: Vec<&str> = line.split('\t').map(str::trim).filter(|cell| !cell.is_empty()).collect();
            let [_, name, unit, direction, ..] = cells[..] else {
                return Err(bad(TABLE, line.trim(), "channel, name, unit and direction"));
            };
            let directions: &[bool] = match direction {
                "both" => &[false, true],
                "forward" => &[false],
                "backward" => &[true],
                other => return Err(bad(TABLE, other, "both, forward or backward")),
            };
            images.extend(directions.iter().map(|&is_backward| Image {
                name: name.replace('_', " "),
                unit: unit.to_owned(),
                is_backward,
            }));
        }
        Ok(images)
    }
}

fn missing(field: &str) -> ScanReadError {
    FORMAT.missing(FilePlace::File, field, "export the file again")
}

fn bad(tag: &str, text: &str, bound: &str) -> ScanReadError {
    FORMAT.bad(FilePlace::Element(tag.to_owned()), "the text", quoted(text), bound, "export the file again")
}
