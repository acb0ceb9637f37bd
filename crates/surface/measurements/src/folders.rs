//! Folders given in place of scans.

use units::printable::listed;

use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::{METADATA_FILES, holds_heights};
use crate::request::ScanRequest;

/// Requests with every folder replaced by the scans in it.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct ScansInFolders {
    /// The scans, those of a folder by name and with its options.
    pub requests: Vec<ScanRequest>,
    /// Index of the request that each comes from.
    pub origins: Vec<usize>,
    /// Files of the folders that are not scans.
    pub skipped: Vec<String>,
}

impl ScansInFolders {
    /// Looks into the folders among some requests.
    ///
    /// # Errors
    /// [`TopographyError`] for a folder that cannot be read or holds no scan.
    pub fn find(requests: &[ScanRequest], files: &dyn Files) -> Result<Self, TopographyError> {
        let mut found = Self::default();
        for (origin, request) in requests.iter().enumerate() {
            let blame = |problem| TopographyError {
                request: Some(origin),
                ..TopographyError::for_file(&request.path, problem)
            };
            let failed = |error| blame(ScanProblem::Reading(error));
            let Some(names) = files.list(&request.path).map_err(failed)? else {
                found.add(origin, request.clone());
                continue;
            };
            let before = found.requests.len();
            for name in names.into_iter().filter(|name| !METADATA_FILES.contains(&name.as_str())) {
                let path = format!("{}/{name}", request.path.trim_end_matches(['/', '\\']));
                if holds_heights(&name, &files.read(&path).map_err(failed)?) {
                    found.add(origin, ScanRequest { path, ..request.clone() });
                } else {
                    found.skipped.push(path);
                }
            }
            if found.requests.len() == before {
                return Err(blame(ScanProblem::NoScanInFolder));
            }
        }
        Ok(found)
    }

    fn add(&mut self, origin: usize, request: ScanRequest) {
        self.requests.push(request);
        self.origins.push(origin);
    }

    /// Names the skipped files in a sentence; `None` if there are none.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        (!self.skipped.is_empty()).then(|| format!("skipped, as no scans: {}", listed(&self.skipped, "")))
    }
}
