//! Reading of heights from a file and the metadata beside it.

use scans::{
    IGNORED, LengthUnit, MeasurementMetadata, Probe, ScanFile, ScanFormat, ScanOptions, ScanSize, read_scans,
};
use sha2::{Digest, Sha256};
use spectrum::{ReadOptions, read_psd};
use units::printable::hexadecimal;

use crate::error::{ScanProblem, TopographyError};
use crate::files::{Files, file_name};
use crate::request::{ScanRequest, TipRadius};

/// Names of metadata files that describe the scans in their folder.
pub const METADATA_FILES: [&str; 2] = ["meta.yml", "index.json"];

/// Bytes of heights that are hashed together.
const HASHED_TOGETHER: usize = 1 << 12;

/// Scans in memory: those of one file, or heights from elsewhere.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// The scans.
    pub scans: Vec<ScanFile>,
    /// SHA-256 in hexadecimal digits: of the file, or of the heights \[m\] row by row as little-endian doubles with
    /// missing points as 0.
    pub sha256: String,
}

impl Loaded {
    /// Reads the scans in a file.
    ///
    /// # Errors
    /// [`TopographyError`] with the file, and with place, value and bound where they apply.
    pub fn read(request: &ScanRequest, files: &dyn Files) -> Result<Self, TopographyError> {
        load(request, files)
    }

    /// Takes heights that come from no file.
    #[must_use]
    pub fn from_heights(scan: ScanFile) -> Self {
        let mut hash = Sha256::new();
        // In blocks: an update for each height would cost more than the hash.
        let mut block = Vec::with_capacity(HASHED_TOGETHER + size_of::<f64>());
        for height_m in scan.scan.heights_m() {
            block.extend(height_m.unwrap_or(0.0).to_le_bytes());
            if block.len() >= HASHED_TOGETHER {
                hash.update(&block);
                block.clear();
            }
        }
        hash.update(&block);
        Loaded { sha256: hexadecimal(hash.finalize()), scans: vec![scan] }
    }
}

/// Reads the scans in a file.
pub(crate) fn load(request: &ScanRequest, files: &dyn Files) -> Result<Loaded, TopographyError> {
    let loaded = load_heights(request, &bytes_of_scans(request, files)?, files)?;
    let is_optical = |scan: &ScanFile| scan.probe == Some(Probe::Microscope);
    if request.tip_radius.and_then(TipRadius::known_m).is_some_and(|radius_m| radius_m > 0.0)
        && loaded.scans.iter().any(is_optical)
    {
        return Err(TopographyError::for_file(&request.path, ScanProblem::NoTip));
    }
    Ok(loaded)
}

/// Reads the first scan of a file that nobody described: of a text the unit and the size are taken for micrometres and
/// a metre. `None` if the file is a spectrum, a scene, or no scan.
#[must_use]
pub fn heights_in(name: &str, bytes: &[u8]) -> Option<ScanFile> {
    if holds_a_spectrum(bytes, &ReadOptions::default()) || is_scene(bytes) {
        return None;
    }
    let options = ScanOptions {
        fallback_unit: Some(LengthUnit::MICROMETRE),
        fallback_size: Some(ScanSize { x_m: 1.0, y_m: None }),
        ..ScanOptions::default()
    };
    read_scans(bytes, file_name(name), &options).ok()?.into_iter().next()
}

/// Returns true if a file holds heights, by its content.
#[must_use]
pub fn holds_heights(name: &str, bytes: &[u8]) -> bool {
    match ScanFormat::recognise(bytes) {
        Some(ScanFormat::Workbook) | None => heights_in(name, bytes).is_some(),
        Some(_) => true,
    }
}

/// Returns true for the text of a scene.
fn is_scene(bytes: &[u8]) -> bool {
    const LOOKED_AT: usize = 1 << 16;
    bytes[..bytes.len().min(LOOKED_AT)]
        .split(|&byte| byte == b'\n')
        .any(|line| line.trim_ascii() == b"[surface]")
}

/// Reads the bytes of a scan file; refuses a spectrum, which could be misread as a line of heights.
pub(crate) fn bytes_of_scans(request: &ScanRequest, files: &dyn Files) -> Result<Vec<u8>, TopographyError> {
    let blame = |problem: ScanProblem| TopographyError::for_file(&request.path, problem);
    let bytes = files.read(&request.path).map_err(|error| blame(ScanProblem::Reading(error)))?;
    if holds_a_spectrum(&bytes, &ReadOptions::default()) {
        return Err(blame(ScanProblem::HoldsASpectrum));
    }
    if is_scene(&bytes) {
        return Err(blame(ScanProblem::IsAScene));
    }
    Ok(bytes)
}

/// Returns true if a file can be read as a spectrum, or names one in its columns.
///
/// Only the first MiB of a large text is tried: spectra are short, and a whole map in text would be parsed for nothing.
#[must_use]
pub fn holds_a_spectrum(bytes: &[u8], options: &ReadOptions) -> bool {
    const TRIED_BYTES: usize = 1 << 20;
    let is_archive = bytes.starts_with(b"PK");
    let tried = match bytes.get(..TRIED_BYTES) {
        Some(first) if !is_archive => {
            let end = first.iter().rposition(|&byte| byte == b'\n');
            &first[..end.map_or(first.len(), |end| end + 1)]
        }
        _ => bytes,
    };
    read_psd(tried, options).map_or_else(|error| error.is_of_a_spectrum(), |_| true)
}

/// Reads the scans in the bytes of a file that is known to hold heights.
pub(crate) fn load_heights(
    request: &ScanRequest,
    bytes: &[u8],
    files: &dyn Files,
) -> Result<Loaded, TopographyError> {
    let mut scans = read_scans(bytes, file_name(&request.path), &options(request, files)?)
        .map_err(|error| TopographyError::for_file(&request.path, ScanProblem::Format(Box::new(error))))?;
    if request.gaps.is_some() && scans.iter().all(|scan| scan.scan.missing_points().is_empty()) {
        scans.iter_mut().for_each(|scan| scan.notes.push(format!("{IGNORED}gaps: no point is missing")));
    }
    Ok(Loaded { scans, sha256: hexadecimal(Sha256::digest(bytes)) })
}

/// Collects reading options: the file and its metadata have priority, the request fills in the rest.
pub(crate) fn options(request: &ScanRequest, files: &dyn Files) -> Result<ScanOptions, TopographyError> {
    Ok(ScanOptions {
        channel: request.channel.clone(),
        measurement: request.measurement.clone(),
        metadata: metadata_beside(&request.path, files)?,
        fallback_unit: request.unit,
        fallback_height_unit: request.height_unit,
        fallback_size: request.size_m.map(|x_m| ScanSize { x_m, y_m: None }),
        ..ScanOptions::default()
    })
}

/// Finds no metadata: this build cannot read `meta.yml` or `index.json`.
#[cfg(not(feature = "formats"))]
fn metadata_beside(_: &str, _: &dyn Files) -> Result<Option<MeasurementMetadata>, TopographyError> {
    Ok(None)
}

/// Finds the entry for a file in the `meta.yml` or `index.json` of its folder.
#[cfg(feature = "formats")]
fn metadata_beside(path: &str, files: &dyn Files) -> Result<Option<MeasurementMetadata>, TopographyError> {
    let name = file_name(path);
    for beside in METADATA_FILES.into_iter().filter(|beside| *beside != name) {
        let folder = &path[..path.len() - name.len()];
        let blame = |problem: ScanProblem| TopographyError::for_file(&format!("{folder}{beside}"), problem);
        let bytes = files.read_beside(path, beside).map_err(|error| blame(ScanProblem::Reading(error)))?;
        let Some(bytes) = bytes else { continue };
        let text = std::str::from_utf8(&bytes).map_err(|error| {
            let before = &bytes[..error.valid_up_to()];
            blame(ScanProblem::NotText { line: 1 + before.iter().filter(|&&byte| byte == b'\n').count() })
        })?;
        // Other programs use files of these names, too.
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
