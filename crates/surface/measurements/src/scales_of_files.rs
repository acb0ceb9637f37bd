//! Rms gradient and curvature of the scans in files down to each wavelength.

use roughness::{Evaluation, GradientAndCurvature, ScaleParameters, scale_parameters};
use scans::ScanFile;
use tables::Table;

use crate::error::TopographyError;
use crate::evaluated::EvaluatedScan;
use crate::files::Files;
use crate::request::ScanRequest;

/// The rms gradient and curvature of the scans in some files, down to each wavelength.
#[derive(Debug)]
#[non_exhaustive]
pub struct ScalesOfFiles {
    /// The scans in the order of the files, with rows from long to short wavelengths.
    scans: Vec<EvaluatedScan<Vec<ScaleParameters>>>,
    /// Files without a result, with the error of each.
    pub unreadable: Vec<TopographyError>,
}

impl ScalesOfFiles {
    /// Evaluates the scans that a spectrum would be made of, after form and filters. A file that cannot be evaluated is listed in
    /// [`ScalesOfFiles::unreadable`].
    #[must_use]
    pub fn read(requests: &[ScanRequest], files: &dyn Files, evaluation: &Evaluation) -> Self {
        let of = |request: &ScanRequest, scan: &ScanFile| evaluated(request, scan, evaluation);
        let (scans, unreadable) = EvaluatedScan::of_files(requests, files, of);
        ScalesOfFiles { scans, unreadable }
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
        let scans = vec![evaluated(request, scan, evaluation)?];
        Ok(ScalesOfFiles { scans, unreadable: Vec::new() })
    }

    /// Makes a table with the columns `file, channel, wavelength_m, rms_gradient_spectrum, rms_gradient_heights,
    /// rms_curvature_spectrum_per_m, rms_curvature_heights_per_m`; cells without a value are empty.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = || self.scans.iter().flat_map(|scan| scan.found.iter().map(move |row| (scan, row)));
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

    /// Lists what a reader should know of the scans, a sentence each without a full stop. With points missing there is no spectrum.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let of = |scan: &EvaluatedScan<_>| {
            let incomplete = scan.left_out().map(|note| format!("{note}, and no spectrum"));
            scan.notes().chain(incomplete).collect::<Vec<_>>()
        };
        self.scans.iter().flat_map(of).collect()
    }
}

fn evaluated(
    request: &ScanRequest,
    scan: &ScanFile,
    evaluation: &Evaluation,
) -> Result<EvaluatedScan<Vec<ScaleParameters>>, TopographyError> {
    EvaluatedScan::new(request, scan, evaluation, |relief| scale_parameters(relief, scan.is_periodic))
}
