//! A file of scans: recognised, read, and joined with what is said about it elsewhere.

use crate::error::ScanReadError;
use crate::format::{Magic, ScanFormat};
use crate::heights::Scan;
use crate::options::{ScanOptions, ScanSize};
use crate::{nanoscope, netcdf, text};

/// How far the size in the metadata may lie from that of the file before a note says so.
const SIZE_AGREEMENT: f64 = 1e-4;

/// A scan with what its file says about it.
#[derive(Clone, Debug, PartialEq)]
pub struct ScanFile {
    /// Name of the measurement where metadata give one, else that of the file.
    pub name: String,
    /// Format it was read from; within a container, that of the data file.
    pub format: ScanFormat,
    /// The heights.
    pub scan: Scan,
    /// The channel read, where the file names it.
    pub channel: Option<String>,
    /// The channels with heights that the file offers.
    pub channels: Vec<String>,
    /// Whether the heights repeat themselves beyond the scan.
    pub is_periodic: bool,
    /// Radius of the tip of the instrument, in m, above 0.
    pub tip_radius_m: Option<f64>,
    /// Smallest length that the instrument resolves, in m, above 0.
    pub resolution_m: Option<f64>,
    /// Assumptions made, and contradictions between the file, the options and the metadata, a sentence each.
    pub notes: Vec<String>,
}

/// What a reader finds in a file.
pub(crate) struct Reading {
    pub(crate) scan: Scan,
    pub(crate) channel: Option<String>,
    pub(crate) channels: Vec<String>,
    pub(crate) is_periodic: Option<bool>,
    pub(crate) tip_radius_m: Option<f64>,
    pub(crate) resolution_m: Option<f64>,
    pub(crate) notes: Vec<String>,
}

impl Reading {
    pub(crate) fn new(scan: Scan, notes: Vec<String>) -> Self {
        Self {
            scan,
            channel: None,
            channels: Vec::new(),
            is_periodic: None,
            tip_radius_m: None,
            resolution_m: None,
            notes,
        }
    }
}

/// Reads the scan in a file, or those in a container.
///
/// The format is told by the content: text (profiles `x h`, one column of heights, points `x y h`, matrices; decimal
/// commas where unambiguous), Nanoscope files with binary data, NetCDF-3 as contact.engineering writes it, X3P, and the
/// containers of contact.engineering. `name` is the name of the file, for messages. Memory is bounded by a small
/// multiple of the file, or of what a ZIP file unpacks to.
///
/// ```
/// use scans::{Scan, ScanOptions, read_scans};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let options = ScanOptions { unit: Some("µm".parse()?), ..ScanOptions::default() };
/// let scans = read_scans(b"0.0 0.125\n0.5 0.25\n1.0 0.125\n", "stylus.txt", &options)?;
/// let Scan::UniformLine(line) = &scans[0].scan else { panic!("evenly spaced") };
/// assert_eq!((line.spacing_m(), line.heights_m()[1]), (0.5e-6, 0.25e-6));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`ScanReadError`], with the place in the file, the value and the bound, for the first thing that is wrong.
pub fn read_scans(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Vec<ScanFile>, ScanReadError> {
    #[cfg(feature = "container")]
    if Magic::of(bytes) == Magic::Zip {
        let mut archive = crate::archive::Archive::open(bytes, options.unpacked_bound())?;
        if let Some(index) = crate::container::index_path(&archive) {
            return crate::container::read(&mut archive, &index, options);
        }
    }
    Ok(vec![read_one(bytes, name, options)?])
}

/// Reads a file with one scan: anything but a container.
pub(crate) fn read_one(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<ScanFile, ScanReadError> {
    let (format, reading) = match Magic::of(bytes) {
        Magic::Text => (ScanFormat::Text, text::read(bytes, options)?),
        Magic::Nanoscope => (ScanFormat::Nanoscope, nanoscope::read(bytes, options)?),
        Magic::NetCdf => (ScanFormat::NetCdf, netcdf::read(bytes, options)?),
        Magic::Zip => (ScanFormat::X3p, read_zip(bytes, name, options)?),
        Magic::Foreign(hint) => return Err(unknown(bytes, name, hint)),
    };
    Ok(joined(format, reading, name, options))
}

#[cfg(feature = "x3p")]
fn read_zip(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Reading, ScanReadError> {
    let mut archive = crate::archive::Archive::open(bytes, options.unpacked_bound())?;
    if crate::x3p::is_x3p(&archive) {
        return crate::x3p::read(&mut archive, options);
    }
    let hint = ": this ZIP file holds neither an X3P ('main.xml') nor a container ('meta.yml' or 'index.json'); unpack it";
    Err(unknown(bytes, name, hint))
}

#[cfg(not(feature = "x3p"))]
fn read_zip(bytes: &[u8], name: &str, _: &ScanOptions) -> Result<Reading, ScanReadError> {
    Err(unknown(bytes, name, ": this is a ZIP file, perhaps X3P, which this build does not read"))
}

fn unknown(bytes: &[u8], name: &str, hint: &'static str) -> ScanReadError {
    let start = match bytes {
        [] => "nothing (it is empty)".to_owned(),
        _ => format!("'{}'", bytes[..bytes.len().min(16)].escape_ascii()),
    };
    ScanReadError::UnknownFormat { name: name.to_owned(), start, hint }
}

fn joined(format: ScanFormat, reading: Reading, name: &str, options: &ScanOptions) -> ScanFile {
    let metadata = options.metadata.as_ref();
    let mut notes = reading.notes;
    if options.size.is_none() {
        notes.extend(metadata.and_then(|metadata| size_note(&reading.scan, metadata.size()?)));
    }
    ScanFile {
        name: metadata.map_or(name, |metadata| &metadata.name).to_owned(),
        format,
        scan: reading.scan,
        channel: reading.channel,
        channels: reading.channels,
        is_periodic: reading
            .is_periodic
            .or(metadata.and_then(|metadata| metadata.is_periodic))
            .unwrap_or(false),
        tip_radius_m: reading.tip_radius_m.or(metadata.and_then(|metadata| metadata.tip_radius_m)),
        resolution_m: reading.resolution_m.or(metadata.and_then(|metadata| metadata.resolution_m)),
        notes,
    }
}

/// Tells of a size in the metadata that is not that of the file.
fn size_note(scan: &Scan, stated: ScanSize) -> Option<String> {
    let (x_m, y_m) = match scan {
        Scan::UniformLine(line) => (line.length_m(), None),
        Scan::NonuniformLine(line) => (line.length_m(), None),
        Scan::Map(map) => {
            (map.spacing_x_m() * map.columns() as f64, Some(map.spacing_y_m() * map.rows() as f64))
        }
    };
    let agrees = |found: f64, stated: f64| (found - stated).abs() <= SIZE_AGREEMENT * stated.abs();
    let y_agrees = y_m.zip(stated.y_m).is_none_or(|(found, stated)| agrees(found, stated));
    (!agrees(x_m, stated.x_m) || !y_agrees).then(|| {
        let found = ScanSize { x_m, y_m };
        format!("the metadata give the size as {stated}, the file as {found}: the file counts")
    })
}
