//! Grid of an image of a Nanoscope file: number of points, spacing, place of the counts.

use super::header::{Header, Section, Value};
use super::scaled::lengths;
use crate::error::ScanReadError;
use crate::raster::{NumberType, Order, Raster};

/// From this version on counts take four bytes, whatever `Bytes/pixel` says; that still sets their scale.
const FOUR_BYTE_VERSION: u32 = 0x0920_0000;

/// Place of the counts of an image, and the area that they cover.
pub(crate) struct Grid {
    pub(crate) columns: usize,
    rows: usize,
    /// Along x and y, above 0.
    pub(crate) size_m: [f64; 2],
    offset: Value,
    bytes_per_count: usize,
    header_end: usize,
    pub(crate) notes: Vec<String>,
}

impl Grid {
    /// The grid of the image in a section.
    pub(crate) fn read(
        header: &Header,
        section: &Section,
        bytes_per_pixel: usize,
    ) -> Result<Self, ScanReadError> {
        let points = Points::read(header, section, bytes_per_pixel)?;
        let mut notes = Vec::from_iter(points.note.clone());
        let size_m = size_m(header, section, &points, &mut notes)?;
        let Points { columns, rows, bytes_per_count, .. } = points;
        let offset = section.require("Data offset")?;
        Ok(Self { columns, rows, size_m, offset, bytes_per_count, header_end: header.end, notes })
    }

    /// Returns the place of the numbers; the image is stored from its bottom.
    pub(crate) fn raster<'b>(&self, bytes: &'b [u8], scale: f64) -> Result<Raster<'b>, ScanReadError> {
        let Self { columns, rows, bytes_per_count, header_end, .. } = *self;
        let offset = self.offset.text.parse().ok().filter(|&offset: &usize| offset >= header_end);
        let offset = offset.ok_or_else(|| {
            self.offset.bad(&format!("a whole number from {header_end} on, where the header ends"))
        })?;
        let number = if bytes_per_count == 4 { NumberType::I32 } else { NumberType::I16 };
        let raster = Raster::within(number, columns, rows, bytes, offset);
        Ok(Raster { order: Order::RowsFromBottom, scale, ..raster })
    }
}

/// The points that the data of an image hold.
struct Points {
    columns: usize,
    rows: usize,
    /// Size in the section of the image, where it differs from that of the data.
    planned: [usize; 2],
    bytes_per_count: usize,
    note: Option<String>,
}

impl Points {
    fn read(header: &Header, section: &Section, bytes_per_pixel: usize) -> Result<Self, ScanReadError> {
        let columns = section.require("Samps/line")?.count()?;
        let rows = section.require("Number of lines")?.count()?;
        let length = section.require("Data length")?;
        let bytes = length.count()?;
        let takes = |columns: usize, rows: usize, each: usize| {
            columns.checked_mul(rows).and_then(|count| count.checked_mul(each))
        };
        let mut bytes_per_count = bytes_per_pixel;
        if version(header) >= FOUR_BYTE_VERSION
            && takes(columns, rows, 4).is_some_and(|needed| bytes >= needed)
        {
            bytes_per_count = 4;
        }
        let needed = takes(columns, rows, bytes_per_count);
        let planned = [columns, rows];
        let mut points = Self { columns, rows, planned, bytes_per_count, note: None };
        if needed == Some(bytes) {
            return Ok(points);
        }
        // Some versions leave the resolution planned for the image in its section; that of the scan then fills the
        // data.
        let of_scan = |key| header.scan_list(key).and_then(|value| value.count().ok());
        if let Some((scan_columns, scan_rows)) = of_scan("Samps/line").zip(of_scan("Lines"))
            && takes(scan_columns, scan_rows, bytes_per_count) == Some(bytes)
        {
            (points.columns, points.rows) = (scan_columns, scan_rows);
            points.note = Some(format!(
                "the image is said to have {columns} x {rows} points, but its data have the {scan_columns} x {scan_rows} \
                 of the scan, which count"
            ));
            return Ok(points);
        }
        match needed {
            Some(needed) if needed < bytes => {
                points.note = Some(format!(
                    "the data of the image take {needed} of the {bytes} bytes set aside for them"
                ));
                Ok(points)
            }
            _ => Err(length.bad(&format!(
                "at least the {} bytes of {columns} x {rows} points of {bytes_per_count} bytes",
                needed.map_or("too many".to_owned(), |needed| needed.to_string())
            ))),
        }
    }
}

fn version(header: &Header) -> u32 {
    let version = header.file_list("Version").map(|value| value.text).unwrap_or_default();
    u32::from_str_radix(version.trim_start_matches("0x"), 16).unwrap_or(0)
}

/// The size of the image along x and y.
///
/// Newer versions give the slow axis of the scan apart, and rightly only there. Older ones give it beside the fast
/// axis, or give that of the fast axis for both with an aspect ratio that is not 1. Such points are as far apart along
/// both axes, whatever the ratio: Gwyddion and pySPM agree on files with 0.51216:1 and 2:1.
fn size_m(
    header: &Header,
    section: &Section,
    points: &Points,
    notes: &mut Vec<String>,
) -> Result<[f64; 2], ScanReadError> {
    let [x_m, y_m] = lengths(&section.require("Scan size")?)?;
    let of_scan = header.scan_list("Scan size").zip(header.scan_list("Slow axis size"));
    let aspect = section.get("Aspect ratio");
    let is_square = aspect.as_ref().is_none_or(|aspect| ratio_of_sides(aspect).is_none());
    let lines = header.scan_list("Lines").and_then(|lines| lines.count().ok());
    let measured =
        lines.filter(|&lines| points.rows < lines).map_or(1.0, |lines| points.rows as f64 / lines as f64);
    let [planned_columns, planned_rows] = points.planned.map(|points| points as f64);
    let [columns, rows] = [points.columns as f64 / planned_columns, points.rows as f64 / planned_rows];
    if let Some((fast, slow)) = of_scan {
        return Ok([lengths(&fast)?[0], lengths(&slow)?[0] * if is_square { 1.0 } else { measured }]);
    }
    if x_m == y_m && !is_square {
        let aspect = aspect.map(|aspect| aspect.text).unwrap_or_default();
        notes.push(format!(
            "the file gives one size for both axes and an aspect ratio of {aspect}: points are taken to be as far apart \
             along both"
        ));
        return Ok([x_m * columns, x_m / planned_columns * points.rows as f64]);
    }
    Ok([x_m * columns, y_m * rows])
}

/// Ratio of the length of lines to the size across them, `2` of `2:1`; none for a square.
fn ratio_of_sides(aspect: &Value) -> Option<f64> {
    let (along, across) = aspect.text.split_once(':')?;
    let side = |text: &str| text.trim().parse::<f64>().ok();
    let ratio = side(along)? / side(across)?;
    (ratio.is_finite() && ratio > 0.0 && ratio != 1.0).then_some(ratio)
}
