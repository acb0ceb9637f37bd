//! Files of Nanoscope and Dimension atomic force microscopes, with binary data, from version 4.3 on.

mod header;
mod image;

use crate::choice_of_size;
use crate::choice_of_units::{own_scale_note, refuse_unit};
use crate::error::{Place, ScanReadError};
use crate::file::Reading;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::scan_size::ScanSize;
use header::FORMAT;
use header::Header;
use image::Image;

/// Reads the channel asked for, else the image that the metadata chose, else the first named after the height.
///
/// The rows of the map run from the top of the image, as the instrument shows it, to the bottom.
pub(crate) fn read(bytes: &[u8], options: &ScanOptions) -> Result<Reading, ScanReadError> {
    refuse_unit(FORMAT, options)?;
    let header = Header::read(bytes)?;
    refuse_other_modes(&header)?;
    let images: Vec<Image> = header.images().map(|section| Image::of(&header, section)).collect();
    let image = choose(&images, options)?;
    let grid = image.grid()?;
    let to_m = image.scale_m_per_count()?;
    let mut notes: Vec<String> = own_scale_note(options).into_iter().collect();
    notes.extend(grid.note.clone());
    let heights_m = grid.heights(bytes, to_m)?;
    let stated = ScanSize { x_m: grid.size_m[0], y_m: Some(grid.size_m[1]) };
    let size = choice_of_size::size(options, Some(stated), &mut notes).unwrap_or(stated);
    let scan = size.map(grid.columns, heights_m, &mut notes)?;
    let mut reading = Reading::new(scan, notes);
    reading.channels = images.iter().filter(|image| image.is_length()).map(Image::label).collect();
    reading.channel = Some(image.label());
    reading.probe = Some(Probe::Tip);
    Ok(reading)
}

fn choose<'i, 'h>(images: &'i [Image<'h>], options: &ScanOptions) -> Result<&'i Image<'h>, ScanReadError> {
    let none = |wanted: String| ScanReadError::NoChannel {
        format: FORMAT,
        wanted,
        channels: images.iter().map(Image::label).collect(),
    };
    if let Some(wanted) = &options.channel {
        let named = |image: &&Image| image.label() == *wanted;
        let found = images.iter().find(named).or_else(|| images.iter().find(|image| image.name() == *wanted));
        return found.ok_or_else(|| none(format!("channel '{wanted}'")));
    }
    if let Some(source) = options.metadata.as_ref().and_then(|metadata| metadata.data_source) {
        return images.get(source).ok_or_else(|| none(format!("image number {source}, counted from 0")));
    }
    let heights = || images.iter().filter(|image| image.is_named_after_height());
    // Where none can be scaled, the first will say why.
    let found = heights().find(|image| image.is_length()).or_else(|| heights().next());
    found.ok_or_else(|| none("channel of heights".to_owned()))
}

/// Force curves and unevenly spaced profiles have image sections that hold no map.
fn refuse_other_modes(header: &Header) -> Result<(), ScanReadError> {
    let refuse = |offset: u64, found: &str| {
        Err(ScanReadError::Unsupported {
            format: FORMAT,
            place: Place::Byte(offset),
            found: found.to_owned(),
            mend: "export an image of heights",
        })
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
