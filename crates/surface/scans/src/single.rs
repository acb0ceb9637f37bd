//! Files with one scan, packed or not.

#[cfg(not(feature = "archives"))]
use std::borrow::Cow;

use crate::assemble::{assembled, chosen, names_of_heights};
use crate::channel::{Channel, UNNAMED, numbered};
use crate::error::ScanReadError;
use crate::file::ScanFile;
use crate::format::ScanFormat;
use crate::measure::Measure;
use crate::options::ScanOptions;
use crate::readers::{reader_of, unknown_format};
#[cfg(feature = "archives")]
pub(crate) use crate::unpacked::unpacked;

/// Returns the bytes themselves: this build unpacks nothing.
#[cfg(not(feature = "archives"))]
pub(crate) fn unpacked<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Cow<'b, [u8]>, ScanReadError> {
    Ok(bytes.into())
}

/// Reads a file with one scan, packed or not: anything but a container.
#[cfg(feature = "container")]
pub(crate) fn read_one(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<ScanFile, ScanReadError> {
    read_unpacked(&unpacked(bytes, options)?, name, options)
}

/// Reads a file with one scan that is not packed as a whole, by the channel that is asked for, which must hold lengths.
pub(crate) fn read_unpacked(
    bytes: &[u8],
    name: &str,
    options: &ScanOptions,
) -> Result<ScanFile, ScanReadError> {
    let reader = reader_of(bytes).ok_or_else(|| unknown_format(bytes, name))?;
    let channels = numbered((reader.channels)(bytes, options)?);
    let with_heights = names_of_heights(&channels);
    let channel = chosen(reader.format, channels, options)?;
    refuse_no_length(reader.format, &channel, &with_heights)?;
    let mut file = assembled(reader.format, channel, &with_heights, name, options)?;
    if file.measure == Measure::Length {
        let channel = file.channel.as_deref().unwrap_or(UNNAMED);
        file.notes.push(format!(
            "channel '{channel}' holds lengths that are not heights of the surface: they are read as asked for"
        ));
    }
    Ok(file)
}

/// Refuses volts and degrees where they would be taken for metres.
fn refuse_no_length(
    format: ScanFormat,
    channel: &Channel<'_>,
    with_heights: &[String],
) -> Result<(), ScanReadError> {
    match channel.measure() {
        Measure::Height | Measure::Length => Ok(()),
        Measure::Other(unit) => Err(ScanReadError::NoHeights {
            format,
            channel: channel.name.clone().unwrap_or_else(|| UNNAMED.to_owned()),
            unit,
            channels: with_heights.to_vec(),
        }),
    }
}
