//! Heights become a spectrum, limited to the band that shows the surface.

use std::path::Path;

use rayon::prelude::*;
use scans::{HeightMap, Scan, ScanFile, ScanFormat};
use spectrum::ProfilePsd;
use topography::{
    LineSpectrum, LineSums, MapLines, Preparation, ReliableBand, nonuniform_line_spectrum,
    uniform_line_spectrum,
};

use super::checks::Checks;
use super::load::load;
use super::request::{Recipe, ScanRequest};
use crate::failure::Failure;

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
    /// Reads a file, relative to `folder`, and transforms every scan in it.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file and what is wrong with it.
    pub fn of_file(request: &ScanRequest, folder: &Path, recipe: &Recipe) -> Result<Vec<Self>, Failure> {
        let loaded = load(request, folder)?;
        let scan = |scan: ScanFile| {
            let name = scan.name.clone();
            let blame = |error: topography::TransformError| {
                Failure::Input(match name == request.path {
                    true => format!("{name}: {error}"),
                    false => format!("{}, {name}: {error}", request.path),
                })
            };
            let found = Self::of_scan(scan, request, &loaded.sha256, recipe).map_err(blame)?;
            if found.spectrum.variance_m2().is_finite() {
                return Ok(found);
            }
            let message = "the variance of the heights is beyond the range of numbers; check their unit";
            Err(Failure::Input(format!("{}: {message}", request.path)))
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
    let sums: Vec<LineSums> = (0..lines.blocks()).into_par_iter().map(|block| lines.block(block)).collect();
    lines.spectrum(&sums)
}
