//! HDF5: NetCDF-4 files in the layout of contact.engineering, `.datx` of Zygo, fast scans of JPK, and any other file whose datasets of
//! real numbers are taken for maps and lines without unit and size.
//!
//! The first index of such a map counts its rows, as in images.

mod content;
mod datx;
mod jpk;
mod netcdf4;

use crate::channel::{Channel, Lateral, Quantity};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::readers::Reader;
use content::{Content, Entry};

const FORMAT: ScanFormat = ScanFormat::Hdf5;
const SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(SIGNATURE)
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut content = Content::read(bytes, options)?;
    if content.entries.iter().any(datx::is_surface) {
        return datx::channels(&mut content);
    }
    if content.groups.iter().any(|(_, group)| jpk::is_measurement(group)) {
        return jpk::channels(&mut content);
    }
    if let Some(heights) = content.find("heights") {
        return netcdf4::channels(&mut content, heights, options);
    }
    plain(&mut content)
}

/// Every map, or where there is none every line.
fn plain<'b>(content: &mut Content) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let has_axes = |entry: &Entry, axes: usize| {
        let found = entry.axes();
        found.len() == axes && !found.contains(&0) && entry.number().is_some()
    };
    let axes = if content.entries.iter().any(|entry| has_axes(entry, 2)) { 2 } else { 1 };
    let wanted: Vec<usize> =
        (0..content.entries.len()).filter(|&at| has_axes(&content.entries[at], axes)).collect();
    let mut channels = Vec::new();
    for at in wanted {
        let name = content.entries[at].path.clone();
        let samples = content.raster(at).into();
        let mut channel = Channel::new(Some(name), Quantity::Heights(None), Lateral::Unknown, samples);
        if axes == 2 {
            channel
                .notes
                .push("the first index of the dataset is taken to count the rows of the map".to_owned());
        }
        channels.push(channel);
    }
    Ok(channels)
}
