//! The header of an object.

use super::FORMAT;
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::metadata::Probe;

/// First bytes of objects with plain counts ...
pub(super) const PLAIN: &[u8] = b"DIGITAL SURF";
/// ... and those whose counts are packed.
pub(super) const PACKED: &[u8] = b"DSCOMPRESSED";

/// The value of the field of formats on computers with the byte order of Motorola.
const MACINTOSH: u16 = 257;

/// Header of an object.
pub(super) struct Header {
    pub(super) is_packed: bool,
    pub(super) order: ByteOrder,
    /// Objects in the file, layers of each counted; only that of the first object counts.
    pub(super) objects: usize,
    kind: u16,
    acquisition: u16,
    pub(super) has_special_points: bool,
    pub(super) bits: u16,
    pub(super) lowest_count: i32,
    pub(super) columns: usize,
    /// 1 for a profile.
    pub(super) rows: usize,
    /// Along x and y in the first two of the units.
    pub(super) spacings: [f32; 2],
    /// Worth of a count in the third of the units.
    pub(super) scale: f64,
    pub(super) zero: f64,
    /// Quantity of the counts.
    pub(super) axis: String,
    pub(super) units: [String; 3],
    pub(super) inversion: Inversion,
    pub(super) packed_bytes: usize,
    pub(super) comment: String,
    /// Offset of the counts.
    pub(super) data: usize,
}

/// Processing of the heights of an object.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Inversion {
    None,
    Heights,
    /// And left and right exchanged.
    HeightsAndColumns,
    /// And top and bottom exchanged.
    HeightsAndRows,
}

impl Inversion {
    pub(super) fn turns_heights(self) -> bool {
        self != Self::None
    }
}

impl Header {
    /// Reads the header at a byte of the file, which begins with one of the two signatures.
    pub(super) fn read(bytes: &[u8], offset: usize) -> Result<Self, ScanReadError> {
        let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(offset);
        let is_packed = cursor.take(12, "the signature")? == PACKED;
        let order = match cursor.u16("the format")? {
            MACINTOSH => ByteOrder::Big,
            _ => ByteOrder::Little,
        };
        let mut cursor = Cursor::new(FORMAT, bytes, order).at(offset + 14);
        let objects = cursor.u16("the number of objects")?;
        cursor.skip(2, "the version")?;
        let kind_offset = cursor.at;
        let kind = cursor.u16("the type of the object")?;
        refuse_kind(kind, kind_offset)?;
        cursor.skip(60, "the names of object and operator")?;
        let layers = cursor.u16("the number of layers")?.max(1);
        let acquisition = cursor.u16("the type of the instrument")?;
        cursor.skip(2, "the range")?;
        let has_special_points = cursor.u16("the mark of special points")? == 1;
        cursor.skip(10, "the resolution")?;
        let bits_offset = cursor.at;
        let bits = cursor.u16("the bits of a point")?;
        if ![16, 32].contains(&bits) {
            return Err(cursor.bad(bits_offset, "the bits of a point", bits, "16 or 32"));
        }
        let lowest_count = cursor.i32("the lowest count")?;
        cursor.skip(4, "the highest count")?;
        let columns = cursor.count("the number of points of a line")?;
        let rows = cursor.count("the number of lines")?;
        cursor.skip(4, "the number of points")?;
        let spacings = [cursor.f32("the spacing along x")?, cursor.f32("the spacing along y")?];
        let scale_offset = cursor.at;
        let scale = cursor.f32("the height of a count")?;
        if !scale.is_finite() {
            let field = "the height of a count";
            return Err(cursor.bad(scale_offset, field, scale, "a finite number"));
        }
        cursor.skip(32, "the names of the lateral axes")?;
        let axis = cursor.text(16, "the name of the axis of heights")?;
        let units =
            [unit(&mut cursor, "along x")?, unit(&mut cursor, "along y")?, unit(&mut cursor, "of heights")?];
        cursor.skip(62, "the units to show")?;
        let inversion = match cursor.u16("the inversion")? {
            1 => Inversion::Heights,
            2 => Inversion::HeightsAndColumns,
            3 => Inversion::HeightsAndRows,
            _ => Inversion::None,
        };
        cursor.skip(32, "the time of the measurement")?;
        let packed_bytes = cursor.u32("the size of packed data")? as usize;
        cursor.skip(6, "unused bytes")?;
        let comment_bytes = usize::from(cursor.u16("the size of the comment")?);
        let private_bytes = usize::from(cursor.u16("the size of the private zone")?);
        cursor.skip(136, "the client zone and the lateral offsets")?;
        let zero = f64::from(cursor.f32("the offset of heights")?);
        cursor.skip(34, "the axis of the series")?;
        let comment = latin1(cursor.take(comment_bytes, "the comment")?);
        cursor.skip(private_bytes, "the private zone")?;
        Ok(Self {
            is_packed,
            order,
            objects: usize::from(objects.max(1)) * usize::from(layers),
            kind,
            acquisition,
            has_special_points,
            bits,
            lowest_count,
            columns,
            rows,
            spacings,
            scale: f64::from(scale),
            zero: if zero.is_finite() { zero } else { 0.0 },
            axis,
            units,
            inversion,
            packed_bytes,
            comment,
            data: cursor.at,
        })
    }

    /// Returns true if the object is a binary, grey or coloured image rather than a surface.
    pub(super) fn is_image(&self) -> bool {
        [3, 10, 12, 18].contains(&self.kind)
    }

    /// Returns the probe by the type of the instrument: gauges with a tip, then those with light.
    pub(super) fn probe(&self) -> Option<Probe> {
        match self.acquisition {
            1 | 5 | 6 | 7 => Some(Probe::Tip),
            2 | 8 | 9 | 10 => Some(Probe::Microscope),
            _ => None,
        }
    }
}

/// Objects whose numbers are not heights over an even line or map.
fn refuse_kind(kind: u16, offset: usize) -> Result<(), ScanReadError> {
    let found = match kind {
        6 | 9 => "a disc in polar coordinates",
        14 | 15 | 35 | 36 => "a force curve",
        17 => "a contour with positions of its own",
        20 | 21 => "a spectrum",
        _ => return Ok(()),
    };
    Err(FORMAT.unsupported(FilePlace::Byte(offset as u64), found, "export a surface or a profile"))
}

/// Old files write the micro sign with its byte in the code page of MS-DOS.
fn unit(cursor: &mut Cursor, what: &str) -> Result<String, ScanReadError> {
    let unit = cursor.text(16, &format!("the unit {what}"))?;
    Ok(if unit == "\u{e6}m" { "\u{b5}m".to_owned() } else { unit })
}
