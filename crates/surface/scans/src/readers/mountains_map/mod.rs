//! Documents of MountainsMap: `.mnt`.
//!
//! A compound file of Microsoft with the document in the stream `ScopedContents`, a tree of tagged entries, as the
//! reader of SurfaceTopography describes it. Surfaces are stored as they were measured, in packed counts; what the
//! document derives from them (levelled, filtered) is only named there.

mod entry;
mod packed;

use std::io::Read;

use entry::Entry;

use memchr::memmem;

use crate::channel::{Channel, Lateral, Quantity, Samples, refuse_many};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;
use crate::room::Room;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::MountainsMap;
const COMPOUND_FILE: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";
const STREAM: &str = "ScopedContents";

/// Classes of objects in a document.
const SURFACE: u32 = 9012;
const SURFACE_DATA: u32 = 9062;
const HEIGHTS: u32 = 9049;
const MASK: u32 = 9056;

/// In masks, a point with a height.
const MEASURED: u8 = 9;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// Names of streams are stored in UTF-16.
fn recognises(bytes: &[u8]) -> bool {
    let name: Vec<u8> = STREAM.encode_utf16().flat_map(u16::to_le_bytes).collect();
    bytes.starts_with(COMPOUND_FILE) && memmem::find(bytes, &name).is_some()
}

/// A channel for every surface that was measured.
fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let contents = contents(bytes)?;
    let mut room = Room::new(options.unpacked_bound());
    let mut channels = Vec::new();
    // The first eight bytes tell the length of the rest.
    let document = Entry::root(&contents).after(8, "the document")?.required(&[1, 0x2bd, 2, 1])?;
    for object in document.listed()? {
        if class(&object)? == Some(SURFACE) {
            refuse_many(FORMAT, channels.len() + 1)?;
            channels.extend(surface(&object, &mut room)?);
        }
    }
    if channels.is_empty() {
        let mend = "export the surface or profile from MountainsMap as SUR, PRO or X3P";
        return Err(FORMAT.unsupported(FilePlace::File, "a document without a measured surface", mend));
    }
    Ok(channels)
}

/// The stream of the document.
fn contents(bytes: &[u8]) -> Result<Vec<u8>, ScanReadError> {
    let bad = |error: std::io::Error| {
        FORMAT.bad(
            FilePlace::File,
            "the compound file",
            error.to_string(),
            format!("one with a stream '{STREAM}'"),
            "save the document again",
        )
    };
    let mut file = cfb::CompoundFile::open(std::io::Cursor::new(bytes)).map_err(bad)?;
    let stream = file.open_stream(STREAM).map_err(bad)?;
    let mut contents = Vec::new();
    // Nothing in a file is longer than the file.
    stream.take(bytes.len() as u64).read_to_end(&mut contents).map_err(bad)?;
    Ok(contents)
}

fn class(object: &Entry) -> Result<Option<u32>, ScanReadError> {
    object.optional(&[1, 1])?.map(|number| number.u32("the class of an object")).transpose()
}

/// The surface in an object; none where it holds no measurement of heights over a grid.
fn surface<'b>(object: &Entry, room: &mut Room) -> Result<Option<Channel<'b>>, ScanReadError> {
    let body = object.required(&[2])?;
    let Some(data) = body.optional(&[1])? else { return Ok(None) };
    if class(&data)? != Some(SURFACE_DATA) {
        return Ok(None);
    }
    let measurement = data.required(&[2, 0xffff])?;
    let (grid, Some(heights)) = (measurement.required(&[0xffff])?, measurement.optional(&[1])?) else {
        return Ok(None);
    };
    if class(&heights)? != Some(HEIGHTS) {
        return Ok(None);
    }
    let [x, y] = [ScanAxis::lateral(&grid, 1)?, ScanAxis::lateral(&grid, 2)?];
    let z = Scale::read(&measurement.required(&[2, 0xffff])?)?;
    let samples = match raster(&heights, &grid, [x.points, y.points], room) {
        Ok(raster) => Samples::Raster(Raster { scale: z.step, zero: z.origin, ..raster }),
        Err(error) => Samples::Unreadable(Box::new(error)),
    };
    let quantity = match z.is_length {
        true => Quantity::HEIGHTS_IN_M,
        false => Quantity::Other(z.unit),
    };
    let lateral = Lateral::spacings(x.spacing_m(), y.spacing_m(), y.points);
    let name = grid.optional(&[0xffff, 0xffff, 1])?.and_then(|name| name.text());
    let title = body.optional(&[0xffff, 4])?.and_then(|title| title.text());
    let name = name.filter(|name| !name.is_empty()).or_else(|| title.clone());
    let note =
        "the surface is as it was measured; what the document derives from it is not stored".to_owned();
    Ok(Some(Channel {
        free_text: title.unwrap_or_default(),
        notes: vec![note],
        ..Channel::new(name, quantity, lateral, samples)
    }))
}

/// A direction of a grid.
struct ScanAxis {
    scale: Scale,
    points: usize,
}

impl ScanAxis {
    fn lateral(grid: &Entry, tag: u16) -> Result<Self, ScanReadError> {
        let axis = grid.required(&[tag, 0xffff])?;
        let points = axis.required(&[1])?.count("the number of points")?;
        Ok(Self { scale: Scale::read(&axis.required(&[0xffff])?)?, points })
    }

    fn spacing_m(&self) -> Option<f64> {
        let step_m = self.scale.step.abs();
        (self.scale.is_length && step_m.is_finite() && step_m > 0.0).then_some(step_m)
    }
}

/// Value of a count: in m where the unit is one of length, else in that unit.
struct Scale {
    step: f64,
    origin: f64,
    unit: String,
    is_length: bool,
}

impl Scale {
    /// The origin is given in the unit that is shown, the step in another.
    fn read(entry: &Entry) -> Result<Self, ScanReadError> {
        let step = entry.required(&[1])?.f64("the step of an axis")?;
        let text = |tag| Ok::<_, ScanReadError>(entry.optional(&[tag])?.and_then(|unit| unit.text()));
        let unit = text(2)?.unwrap_or_default();
        let shown = text(3)?.filter(|shown| !shown.is_empty()).unwrap_or_else(|| unit.clone());
        let origin = entry.optional(&[5])?.map(|origin| origin.f64("the origin of an axis")).transpose()?;
        let origin = origin.filter(|origin| origin.is_finite()).unwrap_or(0.0);
        let lengths = LengthUnit::parse_instrument(&unit).zip(LengthUnit::parse_instrument(&shown));
        Ok(match lengths {
            Some((own, shown)) => {
                Self { step: own.to_m(step), origin: shown.to_m(origin), unit, is_length: true }
            }
            None => Self { step, origin, unit, is_length: false },
        })
    }
}

/// Counts row after row, and a mask with a border of one point.
fn raster<'b>(
    heights: &Entry,
    grid: &Entry,
    [columns, rows]: [usize; 2],
    room: &mut Room,
) -> Result<Raster<'b>, ScanReadError> {
    let points = columns.saturating_mul(rows);
    let counts = packed::array(&heights.required(&[2])?, points, &[4, 2], room)?;
    let number = if counts.element_bytes == 4 { NumberType::I32 } else { NumberType::I16 };
    let mask = grid.optional(&[3])?;
    let missing = match mask {
        Some(mask) if class(&mask)? == Some(MASK) => missing(&mask, [columns, rows], room)?,
        _ => MissingMark::None,
    };
    Ok(Raster { missing, ..Raster::new(number, columns, rows, counts.bytes, heights.offset) })
}

fn missing<'b>(
    mask: &Entry,
    [columns, rows]: [usize; 2],
    room: &mut Room,
) -> Result<MissingMark<'b>, ScanReadError> {
    let [width, height] = [columns.saturating_add(2), rows.saturating_add(2)];
    let points = width.saturating_mul(height);
    let marks = packed::array(&mask.required(&[2, 5, 2])?, points, &[1], room)?;
    let inner = marks.bytes.chunks_exact(width).skip(1).take(rows);
    let marks = inner.flat_map(|row| row.iter().skip(1).take(columns));
    Ok(MissingMark::Flagged(marks.map(|&mark| u8::from(mark != MEASURED)).collect()))
}
