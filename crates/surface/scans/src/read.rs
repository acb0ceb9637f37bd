//! Reading of files: one scan, those of a container, or every channel.

use crate::assemble::{assembled, chosen, names_of_heights};
use crate::channel::{Channel, numbered};
use crate::error::ScanReadError;
use crate::file::ScanFile;
use crate::measure::Measure;
use crate::options::ScanOptions;
use crate::readers::{reader_of, unknown_format};
use crate::single::{read_unpacked, unpacked};

/// Reads the scan in a file, or those in a container.
///
/// The content decides on the [`ScanFormat`](crate::ScanFormat), also inside gzip files and ZIP files of one scan. Of
/// several channels the one asked for is read, else the first of heights; a channel without lengths is refused. `name`
/// is the name of the file, for messages. Memory is bounded by a small multiple of the file, or of its unpacked size.
///
/// ```
/// use scans::{Scan, ScanOptions, read_scans};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let options = ScanOptions { unit: Some("µm".parse()?), ..ScanOptions::default() };
/// let scans = read_scans(b"0.0 0.125\n0.5 0.25\n1.0 0.125\n", "stylus.txt", &options)?;
/// let Scan::UniformLine(line) = scans[0].scan.clone().complete()? else { panic!("evenly spaced") };
/// assert_eq!((line.spacing_m(), line.heights_m()[1]), (0.5e-6, 0.25e-6));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`ScanReadError`], with the place in the file, the value and the bound, for the first thing that is wrong.
pub fn read_scans(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Vec<ScanFile>, ScanReadError> {
    let bytes = &*unpacked(bytes, options)?;
    #[cfg(feature = "container")]
    if let Some(scans) = crate::readers::container::read(bytes, options) {
        return scans;
    }
    Ok(vec![read_unpacked(bytes, name, options)?])
}

/// Visits every channel of heights of a file, with `all_channels` every channel. Only one of them is in memory at a
/// time. Values that are not lengths keep the unit of their channel, see [`ScanFile::measure`]. Of a container, the
/// scans are visited.
///
/// # Errors
/// [`ScanReadError`] for a file that no reader knows, or without the channels that are visited; the visitor gets the error of a single channel.
pub fn visit_channels(
    bytes: &[u8],
    name: &str,
    options: &ScanOptions,
    all_channels: bool,
    mut visit: impl FnMut(Result<ScanFile, ScanReadError>),
) -> Result<(), ScanReadError> {
    let bytes = &*unpacked(bytes, options)?;
    #[cfg(feature = "container")]
    if let Some(scans) = crate::readers::container::read(bytes, options) {
        scans?.into_iter().for_each(|scan| visit(Ok(scan)));
        return Ok(());
    }
    let reader = reader_of(bytes).ok_or_else(|| unknown_format(bytes, name))?;
    let channels = numbered((reader.channels)(bytes, options)?);
    let with_heights = names_of_heights(&channels);
    if options.channel.is_some() {
        let channel = chosen(reader.format, channels, options)?;
        visit(assembled(reader.format, channel, &with_heights, name, options));
        return Ok(());
    }
    if !all_channels && !channels.iter().any(Channel::is_heights) {
        // Its error names the channels that there are.
        return chosen(reader.format, channels, options).map(|_| ());
    }
    let is_wanted = |measure: &Measure| all_channels || *measure == Measure::Height;
    for channel in channels.into_iter().filter(|channel| is_wanted(&channel.measure())) {
        visit(assembled(reader.format, channel, &with_heights, name, options));
    }
    Ok(())
}
