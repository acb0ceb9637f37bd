//! One module per format, with the recognition of its files and their channels.
//!
//! Four modules read no format of their own and help those that do: `even_axis` (positions on even axes and grids),
//! `measured_line` (lines with a position for every point), `sections` (headers in sections of keys and values) and
//! `tiff` (pages and tags). `container` holds files of other formats.

mod alicona;
mod bcr;
#[cfg(feature = "container")]
pub(crate) mod container;
mod digital_surf;
mod even_axis;
mod frt;
pub(crate) mod gsf;
mod gwyddion;
#[cfg(feature = "hdf5")]
mod hdf5;
mod igor;
mod jpk;
mod keyence;
#[cfg(feature = "archives")]
mod marwin;
mod matlab;
mod measured_line;
mod metropro;
mod molecular_imaging;
#[cfg(feature = "mountains")]
mod mountains_map;
mod nanofocus;
mod nanonis;
mod nanoscope;
mod nanosurf;
mod netcdf;
mod nt_mdt;
mod numpy;
mod omni_surf;
mod park;
mod sdf;
mod sections;
mod sensofar;
#[cfg(feature = "archives")]
mod sensofar_plux;
mod text;
mod tiff;
mod truemap;
mod vision64;
#[cfg(feature = "workbook")]
mod workbook;
mod wsxm;
mod wyko;
mod wyko_ascii;
#[cfg(feature = "x3p")]
mod x3p;
#[cfg(any(feature = "archives", feature = "x3p"))]
mod xml;
mod zeta;
mod zygo_xyz;

use crate::channel::Channel;
use crate::error::ScanReadError;
use crate::foreign::ForeignFile;
use crate::format::ScanFormat;
use crate::options::ScanOptions;

/// Recognises and reads the files of a format.
pub(crate) struct Reader {
    pub(crate) format: ScanFormat,
    /// True for a file that begins, or is built, as those of the format are; it may still be damaged.
    pub(crate) recognises: fn(&[u8]) -> bool,
    /// The channels of a file, in its order. Headers are read, numbers are not.
    pub(crate) channels: for<'b> fn(&'b [u8], &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError>,
}

/// The readers, the more certain of their files first; text, which may be anything, comes last.
pub(crate) const READERS: &[Reader] = &[
    alicona::READER,
    bcr::READER,
    digital_surf::READER,
    frt::READER,
    gsf::READER,
    gwyddion::READER,
    #[cfg(feature = "hdf5")]
    hdf5::READER,
    igor::READER,
    jpk::READER,
    keyence::READER,
    #[cfg(feature = "archives")]
    marwin::READER,
    matlab::READER,
    metropro::READER,
    molecular_imaging::READER,
    #[cfg(feature = "mountains")]
    mountains_map::READER,
    nanofocus::READER,
    nanonis::READER,
    nanoscope::READER,
    nanosurf::READER,
    netcdf::READER,
    nt_mdt::READER,
    numpy::READER,
    omni_surf::READER,
    park::READER,
    sdf::READER,
    sensofar::READER,
    #[cfg(feature = "archives")]
    sensofar_plux::READER,
    truemap::READER,
    vision64::READER,
    #[cfg(feature = "workbook")]
    workbook::READER,
    wsxm::READER,
    wyko::READER,
    wyko_ascii::READER,
    #[cfg(feature = "x3p")]
    x3p::READER,
    zeta::READER,
    zygo_xyz::READER,
    text::READER,
];

/// The reader of a file, by its content.
pub(crate) fn reader_of(bytes: &[u8]) -> Option<&'static Reader> {
    READERS.iter().find(|reader| (reader.recognises)(bytes))
}

/// Returns the error of a file that no reader knows.
pub(crate) fn unknown_format(bytes: &[u8], name: &str) -> ScanReadError {
    if let Some(kind) = ForeignFile::recognise(bytes) {
        return ScanReadError::Foreign(kind);
    }
    let start = match bytes {
        [] => "nothing (it is empty)".to_owned(),
        _ => format!("'{}'", bytes[..bytes.len().min(16)].escape_ascii()),
    };
    ScanReadError::UnknownFormat { name: name.to_owned(), start }
}
