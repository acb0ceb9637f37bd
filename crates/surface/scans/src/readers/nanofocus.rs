//! NanoFocus confocal microscopes, `.nms`: a header of fixed length, then heights as sixteen-bit parts of a range in µm.
//!
//! Observed in real files: the header states the lowest and the highest count, 0 and 65535, both of which are heights,
//! and the spacing is in nm. SurfaceTopography takes the spacing for mm.

use crate::channel::Channel;
use crate::cursor::{ByteOrder, Cursor};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::NanoFocus;
const RANGE_OFFSET: usize = 16;
const GRID_OFFSET: usize = 1368;
const HEADER_BYTES: usize = 3468;
/// The count of the highest height; that of the lowest is 0.
const LARGEST: f64 = 65535.0;
/// Points along an axis of any camera or stitched image, and lengths of anything under a microscope: a file without a
/// signature must make sense in full.
const MOST_POINTS: usize = 100_000;
const SPACINGS_NM: std::ops::Range<f64> = 1.0..1e6;
const LARGEST_HEIGHT_UM: f64 = 1e6;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    let Ok(header) = Header::read(bytes) else { return false };
    let is_height = |height: f64| height.abs() < LARGEST_HEIGHT_UM;
    let data = header.columns.saturating_mul(header.rows).saturating_mul(2);
    (2..=MOST_POINTS).contains(&header.columns)
        && (1..=MOST_POINTS).contains(&header.rows)
        && SPACINGS_NM.contains(&header.spacing_x_nm)
        && SPACINGS_NM.contains(&header.spacing_y_nm)
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
    spacing_x_nm: f64,
    spacing_y_nm: f64,
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
            spacing_x_nm: grid.f64("the spacing along x")?,
            spacing_y_nm: grid.f64("the spacing along y")?,
        })
    }
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let Header { lowest_um, highest_um, columns, rows, spacing_x_nm, spacing_y_nm } = Header::read(bytes)?;
    let size = ScanSize {
        x_m: LengthUnit::NANOMETRE.to_m(spacing_x_nm * columns as f64),
        y_m: Some(LengthUnit::NANOMETRE.to_m(spacing_y_nm * rows as f64)),
    };
    let raster = Raster {
        scale: LengthUnit::MICROMETRE.to_m((highest_um - lowest_um) / LARGEST),
        zero: LengthUnit::MICROMETRE.to_m(lowest_um),
        ..Raster::within(NumberType::U16, columns, rows, bytes, HEADER_BYTES)
    };
    Ok(vec![Channel { probe: Some(Probe::Microscope), ..Channel::heights_in_m("", size, raster) }])
}
