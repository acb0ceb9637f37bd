//! Scans of files, each with what was evaluated of its heights.

use roughness::{Evaluation, ScaleLimitedSurface};
use scans::ScanFile;
use units::display::counted;

use crate::channels::channel;
use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::load;
use crate::request::ScanRequest;

/// A scan with what was evaluated of its heights.
#[derive(Debug)]
pub(crate) struct EvaluatedScan<T> {
    /// The file.
    pub file: String,
    /// The channel; empty if the file names none.
    pub channel: String,
    /// Number of points without a height.
    pub missing: usize,
    /// Assumptions made on reading.
    read: Vec<String>,
    pub found: T,
}

impl<T> EvaluatedScan<T> {
    /// Evaluates a scan in memory, after form and filters.
    pub fn new(
        request: &ScanRequest,
        scan: &ScanFile,
        evaluation: &Evaluation,
        of: impl FnOnce(&ScaleLimitedSurface) -> T,
    ) -> Result<Self, TopographyError> {
        let relief = ScaleLimitedSurface::new(&scan.scan, evaluation)
            .map_err(|error| TopographyError::for_file(&request.path, ScanProblem::Relief(error)))?;
        Ok(EvaluatedScan {
            file: request.path.clone(),
            channel: channel(request, scan),
            missing: relief.missing(),
            read: scan.notes.clone(),
            found: of(&relief),
        })
    }

    /// Evaluates the scans that a spectrum would be made of, and lists the files that cannot be evaluated.
    pub fn of_files(
        requests: &[ScanRequest],
        files: &dyn Files,
        of: impl Fn(&ScanRequest, &ScanFile) -> Result<Self, TopographyError>,
    ) -> (Vec<Self>, Vec<TopographyError>) {
        let (mut scans, mut unreadable) = (Vec::new(), Vec::new());
        for request in requests {
            let loaded = request.check_takes(&ScanRequest::OF_HEIGHTS).and_then(|()| load(request, files));
            let evaluated = loaded.and_then(|loaded| {
                loaded.scans.iter().map(|scan| of(request, scan)).collect::<Result<Vec<_>, _>>()
            });
            match evaluated {
                Ok(of_file) => scans.extend(of_file),
                Err(error) => unreadable.push(error),
            }
        }
        (scans, unreadable)
    }

    /// Returns the name of the scan: its file, and its channel if the file names one.
    pub fn title(&self) -> String {
        match self.channel.as_str() {
            "" => self.file.clone(),
            channel => format!("{}, {channel}", self.file),
        }
    }

    /// Lists the assumptions made on reading.
    pub fn notes(&self) -> impl Iterator<Item = String> {
        self.read.iter().map(|note| format!("{}: {note}", self.title()))
    }

    /// Says how many points have no height, if any.
    pub fn left_out(&self) -> Option<String> {
        let points = counted(self.missing, "point");
        (self.missing > 0).then(|| format!("{}: {points} without a height left out", self.title()))
    }
}
