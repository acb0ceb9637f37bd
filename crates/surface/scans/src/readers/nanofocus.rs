//! NanoFocus confocal microscopes, `.nms`: a header of fixed length without a name of its own, as SurfaceTopography
//! reads it, then heights as sixteen-bit parts of a range in µm.

use crate::channel::Channel;
use crate::cursor::{ByteOrder, Cursor};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::NanoFocus;
const RANGE_OFFSET: usize = 16;
const GRID_OFFSET: usize = 1368;
const HEADER_BYTES: usize = 3468;
/// The largest part of the range; the next number, the last of sixteen bits, stands for no height.
const LARGEST: f64 = 65534.0;
/// Points along an axis of any camera or stitched image, and sizes in mm and µm of anything under a microscope: a file
/// without a name of its own must make sense in full.
const MOST_POINTS: usize = 100_000;
const LARGEST_SPACING_MM: f64 = 10.0;
const LARGEST_HEIGHT_UM: f64 = 1e6;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    let Ok(header) = Header::read(bytes) else { return false };
    let is_spacing = |spacing: f64| spacing > 1e-9 && spacing < LARGEST_SPACING_MM;
    let is_height = |height: f64| height.abs() < LARGEST_HEIGHT_UM;
    let data = header.columns.saturating_mul(header.rows).saturating_mul(2);
    (2..=MOST_POINTS).contains(&header.columns)
        && (1..=MOST_POINTS).contains(&header.rows)
        && is_spacing(header.spacing_x_mm)
        && is_spacing(header.spacing_y_mm)
        && is_height(header.lowest_um)
        && is_height(header.highest_um)
        && header.lowest_um < header.highest_um
        && bytes.len() >= HEADER_BYTES.saturating_add(data)
}

struct Header {
    lowest_um: f64,
    highest_um: f64,
    columns: usize,
    rows: usize,
    spacing_x_mm: f64,
    spacing_y_mm: f64,
}

impl Header {
    fn read(bytes: &[u8]) -> Result<Self, ScanReadError> {
        let mut range = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(RANGE_OFFSET);
        let mut grid = range.at(GRID_OFFSET);
        Ok(Self {
            lowest_um: range.f64("the lowest height")?,
            highest_um: range.f64("the highest height")?,
            columns: grid.count("the number of columns")?,
            rows: grid.count("the number of rows")?,
            spacing_x_mm: grid.f64("the spacing along x")?,
            spacing_y_mm: grid.f64("the spacing along y")?,
        })
    }
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let Header { lowest_um, highest_um, columns, rows, spacing_x_mm, spacing_y_mm } = Header::read(bytes)?;
    let size = ScanSize {
        x_m: LengthUnit::MILLIMETRE.to_m(spacing_x_mm * columns as f64),
        y_m: Some(LengthUnit::MILLIMETRE.to_m(spacing_y_mm * rows as f64)),
    };
    let raster = Raster {
        scale: LengthUnit::MICROMETRE.to_m((highest_um - lowest_um) / LARGEST),
        zero: LengthUnit::MICROMETRE.to_m(lowest_um),
        missing: MissingMark::AtLeast(LARGEST + 1.0),
        ..Raster::within(NumberType::U16, columns, rows, bytes, HEADER_BYTES)
    };
    Ok(vec![Channel { probe: Some(Probe::Microscope), ..Channel::heights_in_m("", size, raster) }])
}
