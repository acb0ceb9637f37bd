//! The one map of a file, for whoever wants its area and no lines.

use scans::{HeightMap, Scan, ScanFile};
use topography::{GapTreatment, TransformError, map_of, without_gaps};

use crate::error::{ScanProblem, TopographyError};
use crate::request::ScanRequest;

/// The one scan of a file, without gaps; `not_one` says what is wrong with so many others.
pub(crate) fn only_scan(
    request: &ScanRequest,
    mut scans: Vec<ScanFile>,
    gaps: GapTreatment,
    not_one: fn(usize) -> ScanProblem,
) -> Result<ScanFile<Scan>, TopographyError> {
    match (scans.pop(), scans.len()) {
        (Some(file), 0) => without_gaps(file, gaps).map_err(|error| untransformed(request, error)),
        (file, others) => {
            Err(TopographyError::of_file(&request.path, not_one(others + usize::from(file.is_some()))))
        }
    }
}

/// The map that a scan is; `no_map` says what is wrong with a line.
pub(crate) fn map_in<'f>(
    request: &ScanRequest,
    file: &'f ScanFile<Scan>,
    no_map: ScanProblem,
) -> Result<&'f HeightMap, TopographyError> {
    let map = map_of(&file.scan).map_err(|error| untransformed(request, error))?;
    map.ok_or_else(|| TopographyError::of_file(&request.path, no_map))
}

/// The heights of a file with one scan cannot be transformed.
pub(crate) fn untransformed(request: &ScanRequest, error: TransformError) -> TopographyError {
    TopographyError::of_file(&request.path, ScanProblem::Transform { scan: None, error })
}
