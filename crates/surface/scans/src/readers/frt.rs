//! MicroProf of FRT, `.frt`: a list of numbered blocks, as Gwyddion's user guide and reader describe it. Lengths are in
//! m.

use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, Samples, refuse_many, shortened};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Order, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Frt;
const MAGIC: &[u8] = b"FRTM_GLIDERV";
/// Mark of missing points.
const MISSING: f64 = 1.0;

mod block {
    pub(super) const TOPOGRAPHY: u16 = 0x0b;
    pub(super) const COMMENT: u16 = 0x65;
    pub(super) const GRID: u16 = 0x66;
    pub(super) const SIZE: u16 = 0x67;
    pub(super) const SCALE: u16 = 0x6c;
    pub(super) const TEXT: u16 = 0x77;
    pub(super) const IMAGES: u16 = 0x7d;
}

mod image {
    pub(super) const BOTTOM_SENSOR: u32 = 0x1000_0000;
    /// Kinds of images of lengths with their names.
    pub(super) const HEIGHTS: [(u32, &str); 4] =
        [(0x4, "Topography"), (0x80, "Thickness"), (0x800, "Sample thickness"), (0x1000, "AFM")];
    pub(super) const OTHERS: [(u32, &str); 9] = [
        (0x1, "Piezo"),
        (0x2, "Intensity"),
        (0x8, "Real part"),
        (0x10, "Imaginary part"),
        (0x40, "Camera"),
        (0x100, "Picture"),
        (0x200, "Absolute value"),
        (0x400, "Phase"),
        (0x2000, "Quality"),
    ];
}

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// A part of the file with its place.
#[derive(Clone, Copy)]
struct Block<'b> {
    id: u16,
    cursor: Cursor<'b>,
    size: usize,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let blocks = blocks(bytes)?;
    let find = |id: u16, what: &str| {
        let found = blocks.iter().find(|block| block.id == id).map(|block| block.cursor);
        found.ok_or_else(|| {
            let mend = "the file holds no heights, or is damaged: export it again";
            FORMAT.missing(FilePlace::File, format!("block 0x{id:02x}, {what}"), mend)
        })
    };
    let mut size = find(block::SIZE, "the size")?;
    let size = ScanSize { x_m: size.f64("the size along x")?, y_m: Some(size.f64("the size along y")?) };
    let mut scale = find(block::SCALE, "the scale of heights")?;
    scale.skip(4, "the range")?;
    let scale = scale.f64("the scale of heights")?;
    let comment = blocks.iter().filter(|block| [block::COMMENT, block::TEXT].contains(&block.id));
    let free_text = comment
        .filter_map(|block| block.cursor.rest().get(..block.size).map(latin1))
        .filter(|text| !text.is_empty())
        .collect::<Vec<_>>()
        .join("\n");
    let free_text = shortened(free_text, MOST_TEXT);
    let mut images = Vec::new();
    if let Some(data) = blocks.iter().find(|block| block.id == block::TOPOGRAPHY) {
        let mut grid = find(block::GRID, "the number of points")?;
        images.push(Image::read(0x4, &mut grid, data.cursor, data.size)?);
    }
    if let Some(list) = blocks.iter().find(|block| block.id == block::IMAGES) {
        list_images(list, &mut images)?;
    }
    if images.is_empty() {
        find(block::TOPOGRAPHY, "the heights")?;
    }
    let mut channels: Vec<Channel> = Vec::new();
    for image in images {
        let name = image.name();
        let repeated = channels
            .iter()
            .filter(|channel| channel.name.as_deref().is_some_and(|other| other.starts_with(&name)));
        let repeated = repeated.count();
        let name = if repeated == 0 { name } else { format!("{name} {}", repeated + 1) };
        channels.push(Channel { free_text: free_text.clone(), ..image.channel(name, size, scale) });
    }
    Ok(channels)
}

/// The blocks of a file, whose sizes take eight bytes from version 1.01 on.
fn blocks(bytes: &[u8]) -> Result<Vec<Block<'_>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(MAGIC.len());
    let version = cursor.text(4, "the version")?;
    let is_wide = match version.as_str() {
        "1.00" => false,
        "1.01" => true,
        _ => return Err(cursor.bad(MAGIC.len(), "the version", format!("'{version}'"), "1.00 or 1.01")),
    };
    let count = cursor.u16("the number of blocks")?;
    let mut blocks = Vec::new();
    for _ in 0..count {
        let id = cursor.u16("a block")?;
        let size = if is_wide { cursor.u64("a block")? } else { u64::from(cursor.u32("a block")?) };
        let size = usize::try_from(size).unwrap_or(usize::MAX);
        blocks.push(Block { id, cursor, size });
        cursor.skip(size, &format!("block 0x{id:02x}"))?;
    }
    Ok(blocks)
}

/// The images of a list, without the copy of the topography that has a block of its own.
fn list_images<'b>(list: &Block<'b>, images: &mut Vec<Image<'b>>) -> Result<(), ScanReadError> {
    let mut cursor = list.cursor;
    let end = cursor.at.saturating_add(list.size);
    cursor.skip(8, "the list of images")?;
    while cursor.at + 16 < end {
        let kind = cursor.u32("the kind of an image")?;
        let mut grid = cursor;
        cursor.skip(12, "the number of points of an image")?;
        let image = Image::read(kind, &mut grid, cursor, end - cursor.at)?;
        cursor.skip(image.data.len(), "an image")?;
        if !images.iter().any(|other| other.data == image.data && other.columns == image.columns) {
            images.push(image);
        }
        refuse_many(FORMAT, images.len())?;
    }
    Ok(())
}

struct Image<'b> {
    kind: u32,
    columns: usize,
    rows: usize,
    number: NumberType,
    data: &'b [u8],
    offset: usize,
}

impl<'b> Image<'b> {
    fn read(kind: u32, grid: &mut Cursor, mut data: Cursor<'b>, size: usize) -> Result<Self, ScanReadError> {
        let (columns, rows) = (grid.count("the number of columns")?, grid.count("the number of rows")?);
        let at = grid.at;
        let number = match grid.u32("the bits of a height")? {
            16 => NumberType::U16,
            32 => NumberType::I32,
            other => return Err(grid.bad(at, "the bits of a height", other, "16 or 32")),
        };
        let offset = data.at;
        let needed = columns.saturating_mul(rows).saturating_mul(number.bytes());
        if needed > size {
            let bound = format!("at least the {needed} bytes of {columns} x {rows} points");
            return Err(data.bad(offset, "the size of the block", size, &bound));
        }
        Ok(Self { kind, columns, rows, number, data: data.take(needed, "an image")?, offset })
    }

    fn height_name(&self) -> Option<&'static str> {
        image::HEIGHTS.iter().find(|(flag, _)| self.kind & flag != 0).map(|(_, name)| *name)
    }

    fn name(&self) -> String {
        let other = image::OTHERS.iter().find(|(flag, _)| self.kind & flag != 0).map(|(_, name)| *name);
        let name = self.height_name().or(other).unwrap_or("Image");
        let sensor = if self.kind & image::BOTTOM_SENSOR == 0 { "" } else { " (bottom sensor)" };
        format!("{name}{sensor}")
    }

    /// Rows are stored from the lowest one up.
    fn channel(self, name: String, size: ScanSize, scale: f64) -> Channel<'b> {
        let is_height = self.height_name().is_some();
        let is_afm = self.height_name() == Some("AFM");
        let raster = Raster {
            order: Order::RowsFromBottom,
            scale: if is_height { scale } else { 1.0 },
            missing: MissingMark::Equal(MISSING),
            ..Raster::new(self.number, self.columns, self.rows, self.data, self.offset)
        };
        let quantity = match self.height_name() {
            Some("Topography" | "AFM") => Quantity::HEIGHTS_IN_M,
            Some(_) => Quantity::OtherLength(LengthUnit::METRE),
            None => Quantity::Other(String::new()),
        };
        let probe = Some(if is_afm { Probe::Tip } else { Probe::Microscope });
        let lateral = Lateral::Size(size);
        Channel { probe, ..Channel::new(Some(name), quantity, lateral, Samples::Raster(raster)) }
    }
}
