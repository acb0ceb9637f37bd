//! Files with one scan: recognised and read.

use crate::error::ScanReadError;
use crate::file::{Reading, ScanFile, joined};
use crate::format::{Magic, ScanFormat};
use crate::options::ScanOptions;
use crate::{nanoscope, netcdf, text};

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
