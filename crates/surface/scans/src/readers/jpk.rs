//! Image scans of JPK Instruments, `.jpk` and `.jpk-qi-image`: TIFF with a page a channel, described by tags of the
//! maker's own.
//!
//! The layout is that which Gwyddion's importer, written by the maker, and SurfaceTopography's reader follow. The first
//! page is a thumbnail, which may have calibrations as channels do.

use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, ScanAxis, shortened};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{Order, Raster};
use crate::readers::Reader;
use crate::readers::tiff::{Page, Tiff, first_page};
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Jpk;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

/// Tags of the whole scan, on the first page.
const COMMENT: u16 = 0x8005;
const SAMPLE: u16 = 0x8007;
const CANTILEVER_COMMENT: u16 = 0x8010;
const SIZES: [u16; 2] = [0x8042, 0x8043];
const POINTS: [u16; 2] = [0x8046, 0x8047];

/// Tags of a channel.
const IS_REFLECTED: u16 = 0x8045;
const CHANNEL: u16 = 0x8050;
const IS_RETRACE: u16 = 0x8051;
const CHANNEL_NAME: u16 = 0x8052;
const SLOTS: u16 = 0x8080;
const DEFAULT_SLOT: u16 = 0x8081;

/// Marks of the page that is a picture.
const SUBFILE_TYPE: u16 = 254;
const REDUCED: u32 = 1;
const THUMBNAIL: &str = "thumbnail";

/// A slot is one way to make values of the numbers: so many tags from this one on for each.
const FIRST_SLOT: u16 = 0x8090;
const SLOT_TAGS: u16 = 0x30;
const SLOT_UNIT: u16 = 0x12;
const SLOT_SCALING: u16 = 0x13;
const SLOT_MULTIPLIER: u16 = 0x14;
const SLOT_OFFSET: u16 = 0x15;

fn recognises(bytes: &[u8]) -> bool {
    first_page(FORMAT, bytes).is_some_and(|page| SIZES.iter().all(|&tag| page.number(tag).is_some()))
}

/// The pages that hold a channel.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let tiff = Tiff::read(FORMAT, bytes)?;
    let Some(first) = tiff.pages.first() else { return Ok(Vec::new()) };
    let size_m =
        SIZES.map(|tag| first.number(tag).map(f64::abs).filter(|size| size.is_finite() && *size > 0.0));
    let lateral = match size_m {
        [Some(x_m), Some(y_m)] => Lateral::Size(ScanSize { x_m, y_m: Some(y_m) }),
        _ => Lateral::Unknown,
    };
    let texts = [COMMENT, SAMPLE, CANTILEVER_COMMENT].into_iter().filter_map(|tag| first.text(tag));
    let free_text = texts.filter(|text| !text.is_empty()).map(|text| text + "\n").collect();
    let free_text = shortened(free_text, MOST_TEXT);
    let mut left = bytes.len();
    let pages = tiff.pages.iter().filter(|page| !is_picture(page, first));
    let named = pages.filter_map(|page| Some((page, name(page)?)));
    let channels = named.map(|(page, name)| Channel {
        probe: Some(Probe::Tip),
        fast_axis: Some(ScanAxis::X),
        free_text: free_text.clone(),
        ..channel(page, name, lateral.clone(), &mut left)
    });
    Ok(channels.collect())
}

/// Returns true for a picture of the scan: marked as a reduced image, named so, or of another size than the grid.
fn is_picture(page: &Page, first: &Page) -> bool {
    let is_reduced = page.number(SUBFILE_TYPE).is_some_and(|flags| flags as u32 & REDUCED != 0);
    let grid = POINTS.map(|tag| first.number(tag).filter(|&points| points > 0.0));
    let [width, length] = page.size();
    let is_other = grid[0].is_some_and(|points| Some(points) != width)
        || grid[1].is_some_and(|points| Some(points) != length);
    is_reduced || is_other || page.text(CHANNEL).is_some_and(|name| name == THUMBNAIL)
}

/// Name of a channel, with the direction of the scan.
fn name(page: &Page) -> Option<String> {
    page.number(SLOTS)?;
    let name = page.text(CHANNEL_NAME).filter(|name| !name.is_empty()).or_else(|| page.text(CHANNEL))?;
    let direction = if page.number(IS_RETRACE).is_some_and(|flag| flag != 0.0) { "Retrace" } else { "Trace" };
    Some(format!("{name} ({direction})"))
}

fn channel<'b>(page: &Page<'b>, name: String, lateral: Lateral, left: &mut usize) -> Channel<'b> {
    let slot = default_slot(page);
    let unit = slot.and_then(|slot| page.text(slot + SLOT_UNIT)).unwrap_or_default();
    let quantity = Quantity::named(&name, &unit, LengthUnit::parse(&unit));
    let samples = raster(page, slot, left).into();
    Channel::new(Some(name), quantity, lateral, samples)
}

/// The first tag of the slot that is to be used.
fn default_slot(page: &Page) -> Option<u16> {
    let wanted = page.text(DEFAULT_SLOT)?;
    let tags = (FIRST_SLOT..=u16::MAX - SLOT_TAGS).step_by(usize::from(SLOT_TAGS));
    let count = page.number(SLOTS)? as usize;
    tags.take(count).find(|&tag| page.text(tag).is_some_and(|name| name == wanted))
}

/// The numbers; the first line scanned is the lowest unless the grid is reflected.
fn raster<'b>(page: &Page<'b>, slot: Option<u16>, left: &mut usize) -> Result<Raster<'b>, ScanReadError> {
    let slot = slot.ok_or_else(|| missing("slot for the values of the channel, tag 32897"))?;
    let scaling = page.text(slot + SLOT_SCALING).unwrap_or_default();
    if scaling != "LinearScaling" {
        return Err(FORMAT.unsupported(
            FilePlace::File,
            format!("a channel with the scaling '{scaling}'"),
            "choose a linear calibration of the channel and save it again",
        ));
    }
    let scale = page.number(slot + SLOT_MULTIPLIER).filter(|scale| scale.is_finite());
    let scale = scale.ok_or_else(|| missing("multiplier of the channel"))?;
    let zero = page.number(slot + SLOT_OFFSET).filter(|zero| zero.is_finite()).unwrap_or(0.0);
    let is_reflected = page.number(IS_REFLECTED).is_some_and(|flag| flag != 0.0);
    let order = if is_reflected { Order::RowsFromTop } else { Order::RowsFromBottom };
    Ok(Raster { order, scale, zero, ..page.raster(left)? })
}

fn missing(field: &str) -> ScanReadError {
    FORMAT.missing(FilePlace::File, field, "export the file again")
}
