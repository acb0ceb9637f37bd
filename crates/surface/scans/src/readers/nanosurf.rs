//! Files of Nanosurf, `.nid` and the older `.ezd`: a header in sections, then the numbers of all channels, one after
//! the other.
//!
//! The layout is that which Nanosurf's own reader, published under the MIT license, and Gwyddion's follow.

use crate::channel::{
    Channel, Lateral, MOST_TEXT, Quantity, Samples, ScanAxis, is_named_after_signal, refuse_many, shortened,
};
use crate::cursor::ByteOrder;
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use crate::readers::sections::Sections;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Nanosurf;
const FIRST: &str = "DataSet";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(b"[DataSet]\r\n") || bytes.starts_with(b"[DataSet]\n")
}

/// The channels in the order of their groups, which are the directions of the scan.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let header = Sections::read(FORMAT, bytes, '=', b"#!")?;
    // Offset of the next channel; known only if the sizes of all channels before it are.
    let mut next = Some(header.end);
    let free_text = free_text(&header);
    Ok(names(&header)?
        .iter()
        .map(|section| {
            let stored = Stored::read(&header, section);
            let offset = next;
            next = stored
                .as_ref()
                .ok()
                .zip(offset)
                .and_then(|(stored, offset)| offset.checked_add(stored.bytes()?));
            let raster = stored.and_then(|stored| stored.raster(&header, section, bytes, offset));
            channel(&header, section, raster, &free_text)
        })
        .collect())
}

/// The sections of the channels that there are; a group may have fewer than it has places for.
fn names(header: &Sections) -> Result<Vec<String>, ScanReadError> {
    let groups = header.count(FIRST, "GroupCount")?;
    let mut places = Vec::new();
    for (key, section) in header.entries(FIRST) {
        let place = key.strip_prefix("Gr").and_then(|key| key.split_once("-Ch"));
        let number = |text: &str| text.parse::<usize>().ok();
        let numbers = place.and_then(|(group, channel)| Some((number(group)?, number(channel)?)));
        let Some((group, channel)) = numbers else { continue };
        let count = header.get(FIRST, &format!("Gr{group}-Count")).and_then(number);
        let is_there = header.entries(section).next().is_some();
        if group < groups && count.is_some_and(|count| channel < count) && is_there {
            places.push((group, channel, section.to_owned()));
        }
    }
    refuse_many(FORMAT, places.len())?;
    places.sort();
    Ok(places.into_iter().map(|(_, _, section)| section).collect())
}

/// Storage of the numbers of a channel.
struct Stored {
    columns: usize,
    rows: usize,
    number: NumberType,
    byte_order: ByteOrder,
}

impl Stored {
    fn read(header: &Sections, section: &str) -> Result<Self, ScanReadError> {
        let mode = header.get(section, "SaveMode").unwrap_or("Binary");
        if mode != "Binary" {
            return Err(header.bad(section, "SaveMode", mode, "'Binary'"));
        }
        let bits = header.require(section, "SaveBits")?;
        let is_signed = header.get(section, "SaveSign").unwrap_or("Signed") == "Signed";
        let number = match (bits, is_signed) {
            ("8", true) => NumberType::I8,
            ("8", false) => NumberType::U8,
            ("16", true) => NumberType::I16,
            ("16", false) => NumberType::U16,
            ("32", true) => NumberType::I32,
            ("32", false) => NumberType::U32,
            _ => return Err(header.bad(section, "SaveBits", bits, "8, 16 or 32")),
        };
        let byte_order = match header.get(section, "SaveOrder").unwrap_or("Intel") {
            "Intel" => ByteOrder::Little,
            _ => ByteOrder::Big,
        };
        let (columns, rows) = (header.count(section, "Points")?, header.count(section, "Lines")?);
        Ok(Self { columns, rows, number, byte_order })
    }

    fn bytes(&self) -> Option<usize> {
        self.columns.checked_mul(self.rows)?.checked_mul(self.number.bytes())
    }

    /// Numbers from the bottom; the range of the counts maps to the range of the values.
    fn raster<'b>(
        &self,
        header: &Sections,
        section: &str,
        bytes: &'b [u8],
        offset: Option<usize>,
    ) -> Result<Raster<'b>, ScanReadError> {
        let offset = offset.ok_or_else(|| {
            FORMAT.unsupported(
                FilePlace::Element(format!("[{section}]")),
                "a channel behind one of unknown size",
                "export this channel alone",
            )
        })?;
        let range = header.number(section, "Dim2Range")?;
        let lowest =
            if header.get(section, "Dim2Min").is_some() { header.number(section, "Dim2Min")? } else { 0.0 };
        let is_signed = matches!(self.number, NumberType::I8 | NumberType::I16 | NumberType::I32);
        let raster = Raster::within(self.number, self.columns, self.rows, bytes, offset);
        Ok(Raster {
            byte_order: self.byte_order,
            order: Order::RowsFromBottom,
            scale: range / 256f64.powi(self.number.bytes() as i32),
            zero: if is_signed { lowest + range / 2.0 } else { lowest },
            ..raster
        })
    }
}

fn channel<'b>(
    header: &Sections,
    section: &str,
    raster: Result<Raster<'b>, ScanReadError>,
    free_text: &str,
) -> Channel<'b> {
    let text = |key: &str| header.get(section, key).unwrap_or_default();
    let (frame, signal) = (text("Frame"), text("Dim2Name"));
    let quantity = match LengthUnit::parse(text("Dim2Unit")) {
        // Curves of spectroscopy are measured over a point.
        Some(unit) if is_named_after_signal(signal) || frame.starts_with("Spec") => {
            Quantity::OtherLength(unit)
        }
        Some(unit) => Quantity::Heights(Some(unit)),
        None => Quantity::Other(text("Dim2Unit").to_owned()),
    };
    let rows = raster.as_ref().map_or(0, |raster| raster.rows);
    let samples = Samples::from(raster);
    let lateral = size(header, section, rows).map_or(Lateral::Unknown, Lateral::Size);
    Channel {
        probe: Some(Probe::Tip),
        fast_axis: (rows > 1).then_some(ScanAxis::X),
        free_text: free_text.to_owned(),
        ..Channel::new(Some(format!("{frame} ({signal})")), quantity, lateral, samples)
    }
}

/// The size of the image; lengths may be given downwards.
fn size(header: &Sections, section: &str, rows: usize) -> Option<ScanSize> {
    let along = |axis: usize| {
        let unit = LengthUnit::parse(header.get(section, &format!("Dim{axis}Unit"))?)?;
        numbers::positive(unit.to_m(header.number(section, &format!("Dim{axis}Range")).ok()?.abs()))
    };
    let x_m = along(0)?;
    let y_m = along(1).filter(|_| rows > 1);
    (rows <= 1 || y_m.is_some()).then_some(ScanSize { x_m, y_m })
}

/// Comments of the user, and the cantilever.
fn free_text(header: &Sections) -> String {
    const WORDS: [&str; 6] = ["comment", "remark", "note", "sample", "title", "cantilever type"];
    let mut lines: Vec<String> = header
        .entries("DataSet-Info")
        .filter(|(key, value)| {
            !value.is_empty() && WORDS.iter().any(|word| key.to_lowercase().contains(word))
        })
        .map(|(key, value)| format!("{key}: {value}\n"))
        .collect();
    lines.sort();
    shortened(lines.concat(), MOST_TEXT)
}
