//! A file becomes heights, with what lies beside it.

use std::path::{Path, PathBuf};

use scans::{
    LengthUnit, MeasurementMetadata, Mend, ScanFile, ScanOption, ScanOptions, ScanReadError, ScanSize,
    read_metadata, read_scans,
};
use sha2::{Digest, Sha256};
use spectrum::{ReadOptions, read_psd};

use super::request::ScanRequest;
use crate::failure::Failure;
use crate::output::{Place, utf8};

/// Files that describe the scans beside them.
const METADATA_FILES: [&str; 2] = ["meta.yml", "index.json"];

/// The scans of one file.
pub(super) struct Loaded {
    pub scans: Vec<ScanFile>,
    /// SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
}

/// Reads the scans in a file, relative to `folder`.
pub(super) fn load(request: &ScanRequest, folder: &Path) -> Result<Loaded, Failure> {
    let path = folder.join(&request.path);
    let bytes = Place::File(path.clone()).read()?;
    if read_psd(&bytes[..], &ReadOptions::default()).is_ok() {
        let message = "this file holds a power spectrum, not heights; give it as a PSD: psd = \"...\" in a scene, or to moments, \
                       stacked and the like";
        return Err(Failure::Input(format!("{}: {message}", request.path)));
    }
    // What the file and its metadata say counts; what was given stands in where they say nothing.
    let options = ScanOptions {
        channel: request.channel.clone(),
        metadata: metadata_beside(&path)?,
        fallback_unit: request.unit,
        fallback_size: request.size_m.map(|x_m| ScanSize { x_m, y_m: None }),
        ..ScanOptions::default()
    };
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let scans = read_scans(&bytes, &name, &options)
        .map_err(|error| Failure::Input(format!("{}: {error}{}", request.path, mended(&error))))?;
    Ok(Loaded { scans, sha256: format!("{:x}", Sha256::digest(&bytes)) })
}

/// The option that mends an error, in words that follow it.
fn mended(error: &ScanReadError) -> String {
    match error.mend() {
        Some(Mend::Give(ScanOption::Unit)) => format!("; say it with --unit ({})", LengthUnit::accepted()),
        Some(Mend::Give(ScanOption::Size)) => "; say it with --size".to_owned(),
        Some(Mend::Give(ScanOption::Channel)) => "; name one that holds heights with --channel".to_owned(),
        Some(Mend::LeaveOut(ScanOption::Unit)) => "; leave out --unit".to_owned(),
        Some(Mend::LeaveOut(ScanOption::Size)) => "; leave out --size".to_owned(),
        _ => String::new(),
    }
}

/// What a `meta.yml` or `index.json` in the same folder says of a file, where there is one that names it.
fn metadata_beside(path: &Path) -> Result<Option<MeasurementMetadata>, Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    for beside in METADATA_FILES {
        let beside: PathBuf = folder.join(beside);
        if !beside.is_file() || beside == path {
            continue;
        }
        let shown = beside.display().to_string();
        let bytes = Place::File(beside).read()?;
        let text = utf8(&bytes, &shown, "metadata")?;
        // Other programs have files of these names, too.
        if !text.contains(&name) {
            continue;
        }
        let entries =
            read_metadata(text, &shown).map_err(|error| Failure::Input(format!("{shown}: {error}")))?;
        if let Some(entry) = entries.into_iter().find(|entry| entry.names_file(&name)) {
            return Ok(Some(entry));
        }
    }
    Ok(None)
}
