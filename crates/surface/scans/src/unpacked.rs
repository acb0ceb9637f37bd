//! Files that are packed as a whole: gzip files, and ZIP files of one scan.

use std::borrow::Cow;
use std::io::Read;

use flate2::read::MultiGzDecoder;

use crate::archive::{Archive, is_named_in, is_zip};
use crate::error::ScanReadError;
use crate::foreign::ForeignFile;
use crate::format::ScanFormat;
use crate::metadata::file_name;
use crate::options::ScanOptions;
use crate::readers::reader_of;

/// Bytes unpacked of a file to recognise its format; headers are shorter.
const BEGINNING: u64 = 1 << 20;

/// The bytes that a reader gets: those of the file, or what is packed in it. One level is unpacked, no more.
///
/// A ZIP file that a reader knows is one of its own, and is left as it is.
pub(crate) fn unpacked<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Cow<'b, [u8]>, ScanReadError> {
    let bound = options.unpacked_bound();
    if let Some(wanted) =
        options.measurement.as_ref().filter(|_| !is_container(bytes) && !is_zip_of_files(bytes))
    {
        return Err(ScanReadError::OneMeasurement(wanted.clone()));
    }
    if is_gzip(bytes) {
        let found = gunzipped(bytes, bound)?;
        if found.len() as u64 > bound {
            let what = "the gzip file".to_owned();
            return Err(ScanReadError::ArchiveTooLarge { what, bound, unit: "bytes" });
        }
        return Ok(Cow::Owned(found));
    }
    if is_zip_of_files(bytes) {
        return Ok(only_scan(bytes, options)?.map_or(Cow::Borrowed(bytes), Cow::Owned));
    }
    Ok(Cow::Borrowed(bytes))
}

/// Returns the bytes that show the format of a file: its own, or the beginning of those packed in it.
pub(crate) fn recognisable(bytes: &[u8]) -> Cow<'_, [u8]> {
    let unpacked = if is_gzip(bytes) {
        gunzipped(bytes, BEGINNING).ok()
    } else if is_zip_of_files(bytes) {
        only_scan(bytes, &ScanOptions::default()).ok().flatten()
    } else {
        None
    };
    unpacked.map_or(Cow::Borrowed(bytes), Cow::Owned)
}

fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x1f\x8b\x08")
}

/// Returns true for a ZIP file without a format of its own. Documents of office programs do not count.
fn is_zip_of_files(bytes: &[u8]) -> bool {
    is_zip(bytes)
        && !is_container(bytes)
        && reader_of(bytes).is_none()
        && !is_named_in(bytes, "[Content_Types].xml")
}

#[cfg(feature = "container")]
use crate::archive::is_container;

#[cfg(not(feature = "container"))]
fn is_container(_: &[u8]) -> bool {
    false
}

/// Unpacks up to one byte more than the bound; that byte shows that there are too many.
fn gunzipped(bytes: &[u8], bound: u64) -> Result<Vec<u8>, ScanReadError> {
    let mut found = Vec::new();
    match MultiGzDecoder::new(bytes).take(bound.saturating_add(1)).read_to_end(&mut found) {
        Ok(_) => Ok(found),
        Err(error) => {
            Err(ScanReadError::Zip { what: "the gzip file".to_owned(), problem: error.to_string() })
        }
    }
}

/// The one file of an archive that a reader knows by its content, or the one asked for; text, which may be a note
/// beside a scan, only where nothing else is known. None where the archive holds nothing that may be a scan.
fn only_scan(bytes: &[u8], options: &ScanOptions) -> Result<Option<Vec<u8>>, ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound())?;
    let paths: Vec<String> =
        archive.paths().filter(|path| !is_beside_files(path)).map(str::to_owned).collect();
    if let Some(wanted) = &options.measurement {
        let named = paths.iter().find(|path| *path == wanted || file_name(path) == file_name(wanted));
        return match named {
            Some(path) => archive.read(path).map(Some),
            None => Err(no_file(format!("measurement '{wanted}'"), paths)),
        };
    }
    let (mut recognised, mut texts) = (Candidates::default(), Candidates::default());
    for path in paths {
        let content = archive.read(&path)?;
        match reader_of(&content).map(|reader| reader.format) {
            Some(ScanFormat::Text) => texts.add(path, content),
            Some(_) => recognised.add(path, content),
            None => {}
        }
    }
    // Texts beside the data of an instrument are no scans.
    if recognised.paths.is_empty()
        && let Some(kind @ ForeignFile::Instrument(_)) = ForeignFile::recognise(bytes)
    {
        return Err(ScanReadError::Foreign(kind));
    }
    let found = if recognised.paths.is_empty() { texts } else { recognised };
    if found.paths.len() > 1 {
        return Err(no_file("single scan in the ZIP file".to_owned(), found.paths));
    }
    Ok(found.first)
}

/// Files of one kind; the content of the first.
#[derive(Default)]
struct Candidates {
    paths: Vec<String>,
    first: Option<Vec<u8>>,
}

impl Candidates {
    fn add(&mut self, path: String, content: Vec<u8>) {
        self.paths.push(path);
        self.first.get_or_insert(content);
    }
}

/// Folders, and what file managers put beside files.
fn is_beside_files(path: &str) -> bool {
    path.ends_with('/') || path.starts_with("__MACOSX/") || file_name(path).starts_with('.')
}

fn no_file(wanted: String, channels: Vec<String>) -> ScanReadError {
    ScanReadError::NoChannel { format: ScanFormat::Container, wanted, channels }
}
