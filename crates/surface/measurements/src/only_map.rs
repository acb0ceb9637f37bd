//! The one map of a file, for areal spectra and boundary elements.

use scans::{HeightMap, MissingPoints, Scan, ScanFile};
use topography::{GapTreatment, TransformError, map_of, without_gaps};

use crate::error::{ScanProblem, TopographyError};
use crate::request::ScanRequest;

/// Returns the one scan of a file, and its missing points if they are kept; `not_one` makes the error for another number of scans.
pub(crate) fn only_scan(
    request: &ScanRequest,
    mut scans: Vec<ScanFile>,
    gaps: GapTreatment,
    not_one: fn(usize) -> ScanProblem,
) -> Result<(ScanFile<Scan>, MissingPoints), TopographyError> {
    match (scans.pop(), scans.len()) {
        (Some(file), 0) if gaps == GapTreatment::Keep => Ok(with_zeros(file)),
        (Some(file), 0) => without_gaps(file, gaps)
            .map(|file| (file, MissingPoints::default()))
            .map_err(|error| untransformed(request, error)),
        (file, others) => {
            Err(TopographyError::for_file(&request.path, not_one(others + usize::from(file.is_some()))))
        }
    }
}

/// Puts 0 in the place of missing points, and returns them.
fn with_zeros(file: ScanFile) -> (ScanFile<Scan>, MissingPoints) {
    let missing = file.scan.missing_points().clone();
    let zeros = vec![0.0; missing.count()];
    let filled = file.try_map(|scan| scan.filled(&zeros)).expect("a height of 0 for each missing point");
    (filled, missing)
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
