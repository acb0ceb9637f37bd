//! Files of Nanoscope and Dimension atomic force microscopes, with binary data, from version 4.3 on.

mod grid;
mod header;
mod image;
mod scaled;

use crate::channel::{Channel, Lateral, Quantity, Samples, ScanAxis, refuse_many};
use crate::error::{FilePlace, ScanReadError};
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use header::FORMAT;
use header::Header;
use image::Image;
use units::LengthUnit;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    let starts = [b"\\*File list".as_slice(), b"\\*EC File list"];
    starts.iter().any(|start| bytes.get(..start.len()).is_some_and(|head| head.eq_ignore_ascii_case(start)))
}

/// The images, each from its top as the instrument shows it.
fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let header = Header::read(bytes)?;
    refuse_other_modes(&header)?;
    refuse_many(FORMAT, header.images().count())?;
    Ok(header.images().map(|section| channel(&Image::new(&header, section), bytes)).collect())
}

fn channel<'b>(image: &Image<'_>, bytes: &'b [u8]) -> Channel<'b> {
    let label = Some(image.label());
    let quantity = match (image.is_named_after_height(), image.scale_m_per_count()) {
        (true, _) => Quantity::HEIGHTS_IN_M,
        (false, Ok(_)) => Quantity::OtherLength(LengthUnit::METRE),
        (false, Err(_)) => Quantity::Other(image.unit()),
    };
    // Values that are not lengths are scaled by counts of the full scale.
    let scale = match &quantity {
        Quantity::Other(_) => Ok(image.scale_per_count().unwrap_or(1.0)),
        _ => image.scale_m_per_count(),
    };
    let read = || -> Result<_, ScanReadError> {
        let grid = image.grid()?;
        let raster = grid.raster(bytes, scale?)?;
        Ok((grid, raster))
    };
    let (lateral, samples, notes) = match read() {
        Ok((grid, raster)) => {
            let size = ScanSize { x_m: grid.size_m[0], y_m: Some(grid.size_m[1]) };
            (Lateral::Size(size), Samples::Raster(raster), grid.notes)
        }
        Err(error) => (Lateral::Unknown, Samples::Unreadable(Box::new(error)), Vec::new()),
    };
    Channel {
        probe: Some(Probe::Tip),
        // Images lie in the frame of the scan, however it is turned on the sample.
        fast_axis: Some(ScanAxis::X),
        free_text: image.note(),
        notes,
        ..Channel::new(label, quantity, lateral, samples)
    }
}

/// Force curves and unevenly spaced profiles have image sections that hold no map.
fn refuse_other_modes(header: &Header) -> Result<(), ScanReadError> {
    let refuse = |offset: u64, found: &str| {
        Err(FORMAT.unsupported(FilePlace::Byte(offset), found, "export an image of heights"))
    };
    let mode = header.any("Operating mode");
    if let Some(mode) = mode.as_ref().filter(|mode| mode.text == "Force") {
        return refuse(mode.offset, "a force curve");
    }
    match header.file_list("Start context") {
        Some(start) if start.text == "FOL" => refuse(start.offset, "a force curve"),
        Some(start) if start.text.ends_with("VAR") && mode.is_none_or(|mode| mode.text != "Force Volume") => {
            refuse(start.offset, "a set of unevenly spaced profiles")
        }
        _ => Ok(()),
    }
}
