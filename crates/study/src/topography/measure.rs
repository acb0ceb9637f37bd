//! Heights become a spectrum, limited to the band that shows the surface.

use scans::{HeightMap, Scan, ScanFile, ScanFormat};
use spectrum::ProfilePsd;
use topography::{
    LineSpectrum, LineSums, MapLines, Preparation, ReliableBand, nonuniform_line_spectrum,
    uniform_line_spectrum,
};

use super::checks::Checks;
use super::error::{ScanProblem, TopographyError};
use super::load::load;
use super::request::{Recipe, ScanRequest};
use crate::files::Files;

/// A scan and its spectrum.
#[derive(Debug, Clone)]
pub struct ScanSpectrum {
    /// The name of the measurement.
    pub name: String,
    /// The file it comes from, as typed.
    pub file: String,
    /// SHA-256 of that file, in hexadecimal digits.
    pub sha256: String,
    /// The file's format.
    pub format: ScanFormat,
    /// The channel read, where the file has names for them.
    pub channel: Option<String>,
    /// What was done to the heights.
    pub preparation: Preparation,
    /// The whole spectrum.
    pub spectrum: LineSpectrum,
    /// The wavelengths that show the surface.
    pub band: ReliableBand,
    /// The spectrum at these.
    pub reliable: ProfilePsd,
    /// How far it can be believed.
    pub checks: Checks,
    /// What reading took for granted.
    pub notes: Vec<String>,
}

impl ScanSpectrum {
    /// Reads a file, and transforms every scan in it.
    ///
    /// # Errors
    /// [`TopographyError`] that names the file and what is wrong with it.
    pub fn of_file(
        request: &ScanRequest,
        files: &dyn Files,
        recipe: &Recipe,
    ) -> Result<Vec<Self>, TopographyError> {
        let loaded = load(request, files)?;
        let scan = |scan: ScanFile| {
            let name = scan.name.clone();
            let blame = |error: topography::TransformError| {
                let scan = (name != request.path).then_some(name);
                TopographyError::of_file(&request.path, ScanProblem::Transform { scan, error })
            };
            let found = Self::of_scan(scan, request, &loaded.sha256, recipe).map_err(blame)?;
            if found.spectrum.variance_m2().is_finite() {
                return Ok(found);
            }
            Err(TopographyError::of_file(&request.path, ScanProblem::VarianceBeyondNumbers))
        };
        loaded.scans.into_iter().map(scan).collect()
    }

    fn of_scan(
        file: ScanFile,
        request: &ScanRequest,
        sha256: &str,
        recipe: &Recipe,
    ) -> Result<Self, topography::TransformError> {
        let preparation = recipe.preparation(file.is_periodic);
        let band = ReliableBand::of(&file.scan, request.limits(&file, recipe))?;
        let spectrum = line_spectrum(&file.scan, preparation);
        let reliable = spectrum.profile(&band)?;
        let checks = Checks::of(&file.scan, &spectrum, preparation, file.is_periodic);
        Ok(ScanSpectrum {
            name: file.name,
            file: request.path.clone(),
            sha256: sha256.to_owned(),
            format: file.format,
            channel: file.channel,
            preparation,
            spectrum,
            band,
            reliable,
            checks,
            notes: file.notes,
        })
    }
}

/// The spectrum of a scan; the rows of a map on all threads, with the same digits on any number of them.
fn line_spectrum(scan: &Scan, preparation: Preparation) -> LineSpectrum {
    match scan {
        Scan::UniformLine(line) => uniform_line_spectrum(line, preparation),
        Scan::NonuniformLine(line) => nonuniform_line_spectrum(line, preparation),
        Scan::Map(map) => map_spectrum(map, preparation),
    }
}

fn map_spectrum(map: &HeightMap, preparation: Preparation) -> LineSpectrum {
    let lines = MapLines::new(map, preparation);
    let sums: Vec<LineSums> = parallel::map_indices(lines.blocks(), |block| lines.block(block));
    lines.spectrum(&sums)
}
