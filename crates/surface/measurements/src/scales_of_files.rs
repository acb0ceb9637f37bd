//! Rms gradient and curvature of the scans in files down to each wavelength.

use roughness::{Evaluation, GradientAndCurvature, ScaleLimitedSurface, ScaleParameters, scale_parameters};
use scans::ScanFile;
use tables::Table;

use crate::channels::channel;
use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::load;
use crate::request::ScanRequest;
use crate::roughness_of_files::left_out;

/// The rms gradient and curvature of the scans in some files, down to each wavelength.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct ScalesOfFiles {
    /// The scans, in the order of the files.
    pub scans: Vec<ScalesOfScan>,
    /// Files without a result, with the error of each.
    pub unreadable: Vec<TopographyError>,
}

/// The rms gradient and curvature of a scan down to each wavelength.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScalesOfScan {
    /// The file.
    pub file: String,
    /// The channel; empty if the file names none.
    pub channel: String,
    /// The rows, from long to short wavelengths.
    pub rows: Vec<ScaleParameters>,
    /// Number of points without a height: with any, there is no spectrum.
    pub missing: usize,
}

impl ScalesOfFiles {
    /// Evaluates the scans that a spectrum would be made of, after form and filters. A file that cannot be evaluated is listed in
    /// [`ScalesOfFiles::unreadable`].
    #[must_use]
    pub fn read(requests: &[ScanRequest], files: &dyn Files, evaluation: &Evaluation) -> Self {
        let mut found = ScalesOfFiles::default();
        for request in requests {
            let of_file = || -> Result<Vec<ScalesOfScan>, TopographyError> {
                let loaded = load(request, files)?;
                loaded.scans.iter().map(|scan| ScalesOfScan::new(request, scan, evaluation)).collect()
            };
            match of_file() {
                Ok(scans) => found.scans.extend(scans),
                Err(error) => found.unreadable.push(error),
            }
        }
        found
    }

    /// Evaluates a scan in memory.
    ///
    /// # Errors
    /// [`TopographyError`] if no heights are left to evaluate.
    pub fn of_scan(
        request: &ScanRequest,
        scan: &ScanFile,
        evaluation: &Evaluation,
    ) -> Result<Self, TopographyError> {
        let scan = ScalesOfScan::new(request, scan, evaluation)?;
        Ok(ScalesOfFiles { scans: vec![scan], unreadable: Vec::new() })
    }

    /// Makes a table with the columns `file, channel, wavelength_m, rms_gradient_spectrum, rms_gradient_heights,
    /// rms_curvature_spectrum_per_m, rms_curvature_heights_per_m`; cells without a value are empty.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = || self.scans.iter().flat_map(|scan| scan.rows.iter().map(move |row| (scan, row)));
        let column = |of: fn(&ScaleParameters) -> Option<GradientAndCurvature>,
                      value: fn(GradientAndCurvature) -> f64| {
            rows().map(move |(_, row)| of(row).map(value))
        };
        let gradient = |found: GradientAndCurvature| found.rms_gradient;
        let curvature = |found: GradientAndCurvature| found.rms_curvature_per_m;
        Table::default()
            .with_text("file", rows().map(|(scan, _)| scan.file.clone()))
            .with_text("channel", rows().map(|(scan, _)| scan.channel.clone()))
            .with_numbers("wavelength_m", rows().map(|(_, row)| row.wavelength_m))
            .with_numbers("rms_gradient_spectrum", column(|row| row.from_spectrum, gradient))
            .with_numbers("rms_gradient_heights", column(|row| row.from_heights, gradient))
            .with_numbers("rms_curvature_spectrum_per_m", column(|row| row.from_spectrum, curvature))
            .with_numbers("rms_curvature_heights_per_m", column(|row| row.from_heights, curvature))
    }

    /// Lists what a reader should know of the scans, a sentence each without a full stop.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let incomplete = self.scans.iter().filter(|scan| scan.missing > 0);
        let note = |scan: &ScalesOfScan| {
            format!("{}, and no spectrum", left_out(&scan.file, &scan.channel, scan.missing))
        };
        incomplete.map(note).collect()
    }
}

impl ScalesOfScan {
    /// Evaluates a scan in memory.
    ///
    /// # Errors
    /// [`TopographyError`] if no heights are left to evaluate.
    pub fn new(
        request: &ScanRequest,
        scan: &ScanFile,
        evaluation: &Evaluation,
    ) -> Result<Self, TopographyError> {
        let relief = ScaleLimitedSurface::new(&scan.scan, evaluation)
            .map_err(|error| TopographyError::for_file(&request.path, ScanProblem::Relief(error)))?;
        Ok(ScalesOfScan {
            file: request.path.clone(),
            channel: channel(request, scan),
            rows: scale_parameters(&relief, scan.is_periodic),
            missing: relief.missing(),
        })
    }
}
