//! A file becomes heights, with what lies beside it.

use scans::{MeasurementMetadata, ScanFile, ScanOptions, ScanSize, read_scans};
use sha2::{Digest, Sha256};
use spectrum::{ReadOptions, read_psd};

use crate::error::{ScanProblem, TopographyError};
use crate::files::{Files, file_name};
use crate::request::ScanRequest;

/// Files that describe the scans beside them.
#[cfg(feature = "formats")]
pub const METADATA_FILES: [&str; 2] = ["meta.yml", "index.json"];

/// Scans whose heights are in memory: those of one file, or heights that were in none.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// The scans.
    pub scans: Vec<ScanFile>,
    /// SHA-256, in hexadecimal digits: of the file, or of the heights \[m\] row after row as little-endian doubles, gaps as 0.
    pub sha256: String,
}

impl Loaded {
    /// Reads the scans in a file.
    ///
    /// # Errors
    /// [`TopographyError`] that names the file, and place, value and bound where they are to blame.
    pub fn read(request: &ScanRequest, files: &dyn Files) -> Result<Self, TopographyError> {
        load(request, files)
    }

    /// Heights that were in no file.
    #[must_use]
    pub fn of_heights(scan: ScanFile) -> Self {
        let mut hash = Sha256::new();
        scan.scan.heights_m().for_each(|height_m| hash.update(height_m.unwrap_or(0.0).to_le_bytes()));
        Loaded { sha256: format!("{:x}", hash.finalize()), scans: vec![scan] }
    }
}

/// Reads the scans in a file.
pub(crate) fn load(request: &ScanRequest, files: &dyn Files) -> Result<Loaded, TopographyError> {
    load_heights(request, &bytes_of_scans(request, files)?, files)
}

/// The bytes of a file that is asked for as scans; a spectrum, which may be read as a line of heights, is refused.
pub(crate) fn bytes_of_scans(request: &ScanRequest, files: &dyn Files) -> Result<Vec<u8>, TopographyError> {
    let blame = |problem: ScanProblem| TopographyError::of_file(&request.path, problem);
    let bytes = files.read(&request.path).map_err(|error| blame(ScanProblem::Reading(error)))?;
    if holds_a_spectrum(&bytes, &ReadOptions::default()) {
        return Err(blame(ScanProblem::HoldsASpectrum));
    }
    Ok(bytes)
}

/// Whether a file can be read as a spectrum. Of a large text the first lines tell: spectra are short, and a map in text would be
/// read whole for nothing.
#[must_use]
pub fn holds_a_spectrum(bytes: &[u8], options: &ReadOptions) -> bool {
    const TELLING: usize = 1 << 20;
    let is_archive = bytes.starts_with(b"PK");
    let told_by = match bytes.get(..TELLING) {
        Some(first) if !is_archive => {
            let end = first.iter().rposition(|&byte| byte == b'\n');
            &first[..end.map_or(first.len(), |end| end + 1)]
        }
        _ => bytes,
    };
    read_psd(told_by, options).is_ok()
}

/// Reads the scans in the bytes of a file that is known to hold heights.
pub(crate) fn load_heights(
    request: &ScanRequest,
    bytes: &[u8],
    files: &dyn Files,
) -> Result<Loaded, TopographyError> {
    let scans = read_scans(bytes, file_name(&request.path), &options(request, files)?)
        .map_err(|error| TopographyError::of_file(&request.path, ScanProblem::Format(Box::new(error))))?;
    Ok(Loaded { scans, sha256: format!("{:x}", Sha256::digest(bytes)) })
}

/// What the file and its metadata say counts; what was given stands in where they say nothing.
pub(crate) fn options(request: &ScanRequest, files: &dyn Files) -> Result<ScanOptions, TopographyError> {
    Ok(ScanOptions {
        channel: request.channel.clone(),
        measurement: request.measurement.clone(),
        metadata: metadata_beside(&request.path, files)?,
        fallback_unit: request.unit,
        fallback_size: request.size_m.map(|x_m| ScanSize { x_m, y_m: None }),
        ..ScanOptions::default()
    })
}

/// What a `meta.yml` or `index.json` in the same folder says of a file: nothing where these cannot be read.
#[cfg(not(feature = "formats"))]
fn metadata_beside(_: &str, _: &dyn Files) -> Result<Option<MeasurementMetadata>, TopographyError> {
    Ok(None)
}

/// What a `meta.yml` or `index.json` in the same folder says of a file, where there is one that names it.
#[cfg(feature = "formats")]
fn metadata_beside(path: &str, files: &dyn Files) -> Result<Option<MeasurementMetadata>, TopographyError> {
    let name = file_name(path);
    for beside in METADATA_FILES.into_iter().filter(|beside| *beside != name) {
        let folder = &path[..path.len() - name.len()];
        let blame = |problem: ScanProblem| TopographyError::of_file(&format!("{folder}{beside}"), problem);
        let bytes = files.read_beside(path, beside).map_err(|error| blame(ScanProblem::Reading(error)))?;
        let Some(bytes) = bytes else { continue };
        let text = std::str::from_utf8(&bytes).map_err(|error| {
            let before = &bytes[..error.valid_up_to()];
            blame(ScanProblem::NotText { line: 1 + before.iter().filter(|&&byte| byte == b'\n').count() })
        })?;
        // Other programs have files of these names, too.
        if !text.contains(name) {
            continue;
        }
        let entries = scans::read_metadata(text.trim_start_matches('\u{feff}'), beside)
            .map_err(|error| blame(ScanProblem::Format(Box::new(error))))?;
        if let Some(entry) = entries.into_iter().find(|entry| entry.names_file(name)) {
            return Ok(Some(entry));
        }
    }
    Ok(None)
}
