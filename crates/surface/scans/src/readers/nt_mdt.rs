//! Files of NT-MDT, `.mdt`: frames one after the other, of which those of scanned images are read.
//!
//! The layout is that which Gwyddion's importer and SurfaceTopography's reader follow. Frames of curves, texts and of
//! the newer kind that describes its own dimensions are passed over.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::NtMdt;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

const MAGIC: &[u8] = &[0x01, 0xb0, 0x93, 0xff];
/// Offset of the first frame.
const FIRST_FRAME: usize = 33;
const FRAME_HEADER_BYTES: usize = 22;
const SCANNED: u16 = 0;
/// Most bytes of a title that are shown.
const MOST_TITLE: usize = 100;

/// The signals by their number.
const SIGNALS: [&str; 19] = [
    "Height",
    "DFL",
    "Lateral F",
    "Bias V",
    "Current",
    "FB-Out",
    "MAG",
    "MAG*Sin",
    "MAG*Cos",
    "RMS",
    "CalcMag",
    "Phase1",
    "Phase2",
    "CalcPhase",
    "Ex1",
    "Ex2",
    "HvX",
    "HvY",
    "Snap Back",
];

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let file = Cursor::new(FORMAT, bytes, ByteOrder::Little);
    let last = file.at(12).u16("the number of the last frame")?;
    let mut channels = Vec::new();
    let mut frame = file.at(FIRST_FRAME);
    for _ in 0..=last {
        let start = frame.at;
        let size = frame.u32("the size of a frame")? as usize;
        let kind = frame.u16("the kind of a frame")?;
        if size < FRAME_HEADER_BYTES {
            let bound = format!("at least {FRAME_HEADER_BYTES}");
            return Err(file.bad(start, "the size of a frame", size, &bound));
        }
        if kind == SCANNED {
            channels.extend(scanned(bytes, file.at(start), size)?);
        }
        frame = file.at(start.saturating_add(size));
    }
    if channels.is_empty() {
        let mend = "export an image of heights";
        return Err(FORMAT.unsupported(FilePlace::File, "a file without a frame of a scanned image", mend));
    }
    Ok(channels)
}

/// Origin, step and unit of an axis.
struct Scale {
    origin: f64,
    step: f64,
    unit: i16,
}

impl Scale {
    fn read(cursor: &mut Cursor) -> Result<Self, ScanReadError> {
        let origin = cursor.f32("the origin of an axis")?.into();
        Ok(Self {
            origin,
            step: cursor.f32("the step of an axis")?.into(),
            unit: cursor.i16("the unit of an axis")?,
        })
    }

    /// Distance of neighbours; its sign is the direction of the scan.
    fn spacing_m(&self) -> Option<f64> {
        numbers::positive(length_unit(self.unit)?.to_m(self.step.abs()))
    }
}

/// The image of a frame; frames of points alone have none.
fn scanned<'b>(
    bytes: &'b [u8],
    mut cursor: Cursor<'b>,
    size: usize,
) -> Result<Option<Channel<'b>>, ScanReadError> {
    let start = cursor.at;
    let own = bytes.get(..start.saturating_add(size)).unwrap_or(bytes);
    cursor.skip(FRAME_HEADER_BYTES - 2, "the header of a frame")?;
    let variables_bytes = usize::from(cursor.u16("the size of the variables of a frame")?);
    let (x, y, z) = (Scale::read(&mut cursor)?, Scale::read(&mut cursor)?, Scale::read(&mut cursor)?);
    let signal = usize::from(cursor.u8("the signal of a frame")?);
    let mut mode = cursor.at(start + FRAME_HEADER_BYTES + variables_bytes);
    mode.skip(2, "the mode of a frame")?;
    let columns = usize::from(mode.u16("the number of columns")?);
    let rows = usize::from(mode.u16("the number of rows")?);
    let dots = usize::from(mode.u16("the number of points of curves")?);
    if columns == 0 || rows == 0 {
        return Ok(None);
    }
    if dots > 0 {
        mode.skip(14 + 16 * dots, "the points of curves")?;
    }
    let raster = Raster {
        order: Order::RowsFromBottom,
        // Without a step the numbers are those of the converter.
        scale: if z.step.is_finite() && z.step != 0.0 { z.step } else { 1.0 },
        zero: if z.origin.is_finite() { z.origin } else { 0.0 },
        ..Raster::within(NumberType::I16, columns, rows, own, mode.at)
    };
    let signal = SIGNALS.get(signal).map_or_else(|| format!("signal {signal}"), |name| (*name).to_owned());
    let quantity = Quantity::named(&signal, other_unit(z.unit), length_unit(z.unit));
    let name = match title(own, mode.at.saturating_add(columns * rows * 2)) {
        Some(title) => format!("{signal} ({title})"),
        None => signal,
    };
    let lateral = match (x.spacing_m(), y.spacing_m()) {
        (Some(x_m), Some(y_m)) => Lateral::Spacing { x_m, y_m: Some(y_m) },
        _ => Lateral::Unknown,
    };
    let channel = Channel::new(Some(name), quantity, lateral, Samples::Raster(raster));
    Ok(Some(Channel { probe: Some(Probe::Tip), ..channel }))
}

/// The title behind the numbers of a frame, in the code page of Cyrillic: its length in bytes, then its letters.
fn title(frame: &[u8], offset: usize) -> Option<String> {
    let mut cursor = Cursor::new(FORMAT, frame, ByteOrder::Little).at(offset);
    let length = cursor.u32("the length of the title").ok()? as usize;
    let letters = cursor.take(length, "the title").ok()?;
    let letter = |&byte: &u8| match byte {
        0xc0.. => char::from_u32(0x410 + u32::from(byte - 0xc0)).unwrap_or(char::REPLACEMENT_CHARACTER),
        // A comma would end the name where a channel is asked for.
        b',' => ' ',
        0x20..0x7f => char::from(byte),
        _ => ' ',
    };
    let title: String = letters.iter().take(MOST_TITLE).map(letter).collect();
    Some(title.trim().to_owned()).filter(|title| !title.is_empty())
}

fn length_unit(code: i16) -> Option<LengthUnit> {
    Some(match code {
        -5 => LengthUnit::METRE,
        -4 => LengthUnit::CENTIMETRE,
        -3 => LengthUnit::MILLIMETRE,
        -2 => LengthUnit::MICROMETRE,
        -1 => LengthUnit::NANOMETRE,
        0 => LengthUnit::ANGSTROM,
        _ => return None,
    })
}

fn other_unit(code: i16) -> &'static str {
    match code {
        1 => "nA",
        2 => "V",
        4 => "kHz",
        5 => "deg",
        6 => "%",
        9 => "s",
        _ => "",
    }
}
