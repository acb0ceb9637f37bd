//! The one map of a file, for areal spectra and boundary elements.

use scans::{HeightMap, Scan, ScanFile};
use topography::{GapTreatment, TransformError, map_of, without_gaps};

use crate::error::{ScanProblem, TopographyError};
use crate::request::ScanRequest;

/// Returns the one scan of a file, without missing points; `not_one` makes the error for another number of scans.
pub(crate) fn only_scan(
    request: &ScanRequest,
    mut scans: Vec<ScanFile>,
    gaps: GapTreatment,
    not_one: fn(usize) -> ScanProblem,
) -> Result<ScanFile<Scan>, TopographyError> {
    match (scans.pop(), scans.len()) {
        (Some(file), 0) => without_gaps(file, gaps).map_err(|error| untransformed(request, error)),
        (file, others) => {
            Err(TopographyError::for_file(&request.path, not_one(others + usize::from(file.is_some()))))
        }
    }
}

/// Returns the map of a scan; `no_map` is the error for a line.
pub(crate) fn map_in<'f>(
    request: &ScanRequest,
    file: &'f ScanFile<Scan>,
    no_map: ScanProblem,
) -> Result<&'f HeightMap, TopographyError> {
    let map = map_of(&file.scan).map_err(|error| untransformed(request, error))?;
    map.ok_or_else(|| TopographyError::for_file(&request.path, no_map))
}

/// Makes the error of a file with one scan that cannot be transformed.
pub(crate) fn untransformed(request: &ScanRequest, error: TransformError) -> TopographyError {
    TopographyError::for_file(&request.path, ScanProblem::Transform { scan: None, error })
}
