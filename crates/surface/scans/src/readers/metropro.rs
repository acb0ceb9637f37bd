//! Zygo MetroPro, of interferometers: `.dat`.
//!
//! A header of 834 or 4096 bytes, big-endian in the fields of use, then intensities, then phases, as the reference
//! guide of MetroPro lays it down (its appendix on data formats).

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;

const FORMAT: ScanFormat = ScanFormat::MetroPro;
/// Magic numbers of headers of format 1, 2 and 3.
const MAGICS: [&[u8]; 3] = [b"\x88\x1b\x03\x6f", b"\x88\x1b\x03\x70", b"\x88\x1b\x03\x71"];
/// The fields read lie within so many bytes, the length of the shortest header.
const SHORTEST_HEADER: usize = 834;
/// Phases from this one on mark points without a height.
const MISSING: f64 = 2_147_483_640.0;
/// Phases in a fringe, by the resolution of phases.
const PHASES: [f64; 3] = [4096.0, 32768.0, 131_072.0];

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    MAGICS.iter().any(|magic| bytes.starts_with(magic))
}

struct Header {
    bytes: usize,
    intensity_bytes: usize,
    columns: usize,
    rows: usize,
    texts: [String; 2],
    /// Height of a phase in m.
    scale_m: f64,
    /// 0 where it is unknown.
    spacing_m: f64,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let header = header(bytes)?;
    let offset = header.bytes.saturating_add(header.intensity_bytes);
    let raster = Raster {
        byte_order: ByteOrder::Big,
        scale: header.scale_m,
        missing: MissingMark::AtLeast(MISSING),
        ..Raster::within(NumberType::I32, header.columns, header.rows, bytes, offset)
    };
    let spacing_m = header.spacing_m;
    let lateral = match spacing_m.is_finite() && spacing_m > 0.0 {
        true => Lateral::Spacing { x_m: spacing_m, y_m: Some(spacing_m) },
        false => Lateral::Unknown,
    };
    let texts = header.texts.into_iter().filter(|text| !text.is_empty());
    Ok(vec![Channel {
        probe: Some(Probe::Microscope),
        free_text: texts.collect::<Vec<_>>().join("\n"),
        ..Channel::new(None, Quantity::HEIGHTS_IN_M, lateral, Samples::Raster(raster))
    }])
}

fn header(bytes: &[u8]) -> Result<Header, ScanReadError> {
    let start = Cursor::new(FORMAT, bytes, ByteOrder::Big);
    let at = |offset: usize| start.at(offset);
    let header_bytes = at(6).u32("the length of the header")? as usize;
    if header_bytes < SHORTEST_HEADER {
        let bound = format!("at least {SHORTEST_HEADER}");
        return Err(start.bad(6, "the length of the header", header_bytes, &bound));
    }
    let intensity_bytes = at(60).u32("the length of the intensities")? as usize;
    let mut size = at(68);
    let columns = usize::from(size.u16("the number of columns")?);
    let rows = usize::from(size.u16("the number of rows")?);
    if columns == 0 || rows == 0 {
        return Err(FORMAT.missing(
            FilePlace::Byte(68),
            format!("phase data ({columns} x {rows} points)"),
            "save the file with its phases, not with intensities alone",
        ));
    }
    let comment = at(80).text(82, "the comment")?;
    let mut optics = at(164);
    let interferometer = optics.f32("the scale factor of the interferometer")?;
    let wavelength_m = optics.f32("the wavelength")?;
    optics.skip(4, "the numerical aperture")?;
    let obliquity = optics.f32("the obliquity factor")?;
    optics.skip(4, "the magnification")?;
    let spacing_m = f64::from(optics.f32("the distance of points")?);
    let phases = phases(at(218))?;
    let is_turned = at(232).i16("the sign of heights")? != 0;
    let part = at(258).text(40, "the name of the part")?;
    let scale_m = f64::from(interferometer) * f64::from(obliquity) * f64::from(wavelength_m) / phases;
    if !scale_m.is_finite() || scale_m == 0.0 {
        let value = format!("{interferometer} x {wavelength_m} x {obliquity}");
        let field = "the scale factor times wavelength times obliquity";
        return Err(start.bad(164, field, &value, "a finite number other than 0"));
    }
    let scale_m = if is_turned { -scale_m } else { scale_m };
    let texts = [comment, part];
    Ok(Header { bytes: header_bytes, intensity_bytes, columns, rows, texts, scale_m, spacing_m })
}

fn phases(mut cursor: Cursor) -> Result<f64, ScanReadError> {
    let offset = cursor.at;
    let resolution = cursor.i16("the resolution of phases")?;
    let phases = usize::try_from(resolution).ok().and_then(|index| PHASES.get(index)).copied();
    phases.ok_or_else(|| cursor.bad(offset, "the resolution of phases", resolution, "0, 1 or 2"))
}
