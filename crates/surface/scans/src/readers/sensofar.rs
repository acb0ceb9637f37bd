//! Sensofar, PLu and S neox: `.plu` and `.apx`.
//!
//! A header of 500 bytes, then layers of floating-point numbers in µm, each before the pictures taken of it,
//! little-endian, as the readers of Gwyddion and SurfaceTopography take them.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Sensofar;
const HEADER_BYTES: usize = 500;
/// Points without a height hold this number.
const MISSING: f64 = 1_000_001.0;

/// Most profiles of a file, each of which is a channel; instruments take some tens.
const MOST_PROFILES: usize = 10_000;

const DAYS: [&[u8]; 7] = [b"Mon", b"Tue", b"Wed", b"Thu", b"Fri", b"Sat", b"Sun"];
const MONTHS: [&[u8]; 12] =
    [b"Jan", b"Feb", b"Mar", b"Apr", b"May", b"Jun", b"Jul", b"Aug", b"Sep", b"Oct", b"Nov", b"Dec"];

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// A file has no signature, but begins with a time such as `Fri Mar 10 16:35:59 2023`, filled up with zero bytes.
fn recognises(bytes: &[u8]) -> bool {
    let Some(time) = bytes.get(..128).filter(|_| bytes.len() > HEADER_BYTES) else { return false };
    let is_time = DAYS.contains(&&time[..3])
        && MONTHS.contains(&&time[4..7])
        && [3, 7, 10, 19].iter().all(|&at| time[at] == b' ')
        && [13, 16].iter().all(|&at| time[at] == b':')
        && [9, 11, 12, 14, 15, 17, 18, 20, 21, 22, 23].iter().all(|&at| time[at].is_ascii_digit());
    is_time && matches!(time[24..], [0, ..] | [b'\n', 0, ..])
}

/// Kind of content.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Image,
    /// One profile or several, each a row.
    Profiles,
    Topography,
    /// Profiles of the thickness of a layer.
    Thicknesses,
}

struct Header {
    comment: String,
    kind: Kind,
    /// Distances in µm of columns and rows.
    spacings: [f32; 2],
    layers: usize,
    pictures: usize,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little);
    let header = header(&mut cursor)?;
    let mut channels = Vec::new();
    for layer in 0..header.layers {
        // A file may hold fewer layers than it announces; what is there is read.
        if layer > 0 && cursor.rest().is_empty() {
            break;
        }
        let most = MOST_PROFILES.saturating_sub(channels.len());
        channels.extend(layer_channels(&mut cursor, &header, layer, most)?);
    }
    Ok(channels)
}

fn header(cursor: &mut Cursor) -> Result<Header, ScanReadError> {
    cursor.skip(132, "the time of the measurement")?;
    let comment = cursor.text(256, "the comment")?;
    cursor.skip(16, "the numbers of points")?;
    let spacings = [cursor.f32("the distance of columns")?, cursor.f32("the distance of rows")?];
    cursor.skip(16, "the offsets")?;
    let kind = kind(cursor)?;
    cursor.skip(57, "the settings of the scan")?;
    let layers = usize::from(cursor.u8("the number of layers")?);
    cursor.skip(2, "the version")?;
    let pictures = usize::from(cursor.u8("the number of pictures")?);
    cursor.skip(7, "the rest of the header")?;
    let comment = if comment == "(None)" { String::new() } else { comment };
    Ok(Header { comment, kind, spacings, layers: layers.max(1), pictures })
}

fn kind(cursor: &mut Cursor) -> Result<Kind, ScanReadError> {
    let offset = cursor.at;
    match cursor.u32("the type of the measurement")? {
        0 => Ok(Kind::Image),
        1 | 2 => Ok(Kind::Profiles),
        3 => Ok(Kind::Topography),
        5 => Ok(Kind::Thicknesses),
        other => Err(FORMAT.unsupported(
            FilePlace::Byte(offset as u64),
            format!("a measurement of type {other}"),
            "export a topography or a profile",
        )),
    }
}

/// The layer at the cursor, which moves on to the next: one channel, or one for each of several profiles.
fn layer_channels<'b>(
    cursor: &mut Cursor<'b>,
    header: &Header,
    layer: usize,
    most_profiles: usize,
) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let start = cursor.at;
    let rows = cursor.count("the number of rows")?;
    let columns = cursor.count("the number of columns")?;
    let (points_bytes, offset) = (cursor.rest(), cursor.at);
    let raster = Raster::new(NumberType::F32, columns, rows, points_bytes, offset);
    let raster = Raster { missing: MissingMark::Equal(MISSING), ..raster };
    let points = columns.checked_mul(rows);
    // The extreme values follow, then three bytes a point of each picture.
    let size = points.and_then(|points| points.checked_mul(4 + 3 * header.pictures)?.checked_add(8));
    *cursor = cursor.at(cursor.at.saturating_add(size.unwrap_or(usize::MAX)));
    if rows == 1 || matches!(header.kind, Kind::Image | Kind::Topography) {
        return Ok(vec![channel(header, format!("layer{layer}"), raster)]);
    }
    if rows > most_profiles {
        let bound = format!("at most {most_profiles}");
        return Err(cursor.bad(start, "the number of profiles", rows, &bound));
    }
    raster.check(FORMAT)?;
    let row_bytes = columns * NumberType::F32.bytes();
    let row = |row: usize| {
        let first = row * row_bytes;
        let bytes = points_bytes.get(first..).unwrap_or_default();
        let own = Raster { rows: 1, bytes: bytes.into(), offset: offset + first, ..raster.clone() };
        channel(header, format!("profile {} of layer{layer}", row + 1), own)
    };
    Ok((0..rows).map(row).collect())
}

fn channel<'b>(header: &Header, name: String, raster: Raster<'b>) -> Channel<'b> {
    let quantity = match header.kind {
        Kind::Image => Quantity::Other(String::new()),
        Kind::Thicknesses => Quantity::OtherLength(LengthUnit::MICROMETRE),
        Kind::Profiles | Kind::Topography => Quantity::Heights(Some(LengthUnit::MICROMETRE)),
    };
    Channel {
        probe: Some(Probe::Microscope),
        free_text: header.comment.clone(),
        ..Channel::new(Some(name), quantity, lateral(header, raster.rows), Samples::Raster(raster))
    }
}

fn lateral(header: &Header, rows: usize) -> Lateral {
    let in_m = |spacing: f32| numbers::positive(LengthUnit::MICROMETRE.to_m(f64::from(spacing.abs())));
    let [x_m, y_m] = header.spacings.map(in_m);
    Lateral::spacings(x_m, y_m, rows)
}
