//! The two-dimensional spectrum of a map.

use scans::Scan;
use topography::{RadialBin, Recipe, ReliableBand};

use super::error::{ScanProblem, TopographyError};
use super::load::{Loaded, load};
use super::request::ScanRequest;
use crate::files::Files;
use tables::Table;

/// The two-dimensional spectrum of a map, averaged radially.
pub struct AreaSpectrum {
    /// `wavelength_m, wavevector_rad_per_m, Ciso_m4, modes`, from long to short wavelengths, as far as it shows the surface.
    pub table: Table,
    /// How it was made: the file with its SHA-256, and what was done to the heights.
    pub provenance: String,
    /// What reading took for granted.
    pub notes: Vec<String>,
}

/// The spectrum of the one map in a file.
///
/// # Errors
/// [`TopographyError`] where the file holds no map, or several.
pub fn areal_spectrum(
    request: &ScanRequest,
    files: &dyn Files,
    recipe: &Recipe,
) -> Result<AreaSpectrum, TopographyError> {
    let refused = |problem| TopographyError::of_file(&request.path, problem);
    let transform = |error| refused(ScanProblem::Transform { scan: None, error });
    let Loaded { scans, sha256 } = load(request, files)?;
    let [file] = &scans[..] else {
        return Err(refused(ScanProblem::NotOneMap(scans.len())));
    };
    let Scan::Map(map) = &file.scan else {
        return Err(refused(ScanProblem::LineHasNoArea));
    };
    let preparation = recipe.preparation(file.is_periodic);
    let band = ReliableBand::of(&file.scan, recipe.limits(request.limits(), file)).map_err(transform)?;
    let spectrum = topography::areal_spectrum(map, preparation);
    let shown = spectrum.ciso(&band).map_err(transform)?;
    let modes = |wavelength_m: &f64| {
        let q = std::f64::consts::TAU / wavelength_m;
        let near = |bin: &&RadialBin| (bin.wavevector_rad_per_m / q - 1.0).abs() < 1e-9;
        spectrum.bins().iter().find(near).map(|bin| bin.modes as f64)
    };
    let wavelengths_m = shown.wavelengths_m();
    let table = Table::default()
        .with_numbers("wavelength_m", wavelengths_m.iter().copied())
        .with_numbers("wavevector_rad_per_m", wavelengths_m.iter().map(|l| std::f64::consts::TAU / l))
        .with_numbers("Ciso_m4", shown.values().iter().copied())
        .with_numbers("modes", wavelengths_m.iter().map(modes).collect::<Vec<_>>());
    let provenance = format!(
        "map: {} ({}), SHA-256 {sha256}, detrend {}, window {}",
        request.path, file.format, preparation.detrend, preparation.window
    );
    Ok(AreaSpectrum { table, provenance, notes: file.notes.clone() })
}
