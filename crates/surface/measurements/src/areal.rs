//! The two-dimensional spectrum of a map.

use topography::{Direction, GapTreatment, MapSpectrum, Recipe};

use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::{Loaded, load};
use crate::only_map::{map_in, only_scan, untransformed};
use crate::request::ScanRequest;
use tables::Table;
use units::Remark;

/// The two-dimensional spectrum of a map, averaged radially.
pub struct ArealTable {
    /// Columns `wavelength_m, wavevector_rad_per_m, Ciso_m4, modes`, from long to short wavelengths, within the
    /// reliable band.
    pub table: Table,
    /// Provenance: the file with its SHA-256, the detrending and the window.
    pub provenance: String,
    /// Assumptions of the reader, and doubts.
    pub remarks: Vec<Remark>,
}

/// Computes the two-dimensional spectrum of the one map in a file.
///
/// # Errors
/// [`TopographyError`] if the file holds no map or several, if the treatment of missing points left only lines, or if
/// the recipe asks for a direction.
pub fn areal_spectrum(
    request: &ScanRequest,
    files: &dyn Files,
    recipe: &Recipe,
) -> Result<ArealTable, TopographyError> {
    let recipe = &request.recipe(recipe);
    if recipe.direction != Direction::X || request.direction.is_some() {
        let problem = ScanProblem::AreaHasNoDirection(recipe.direction);
        return Err(TopographyError::for_file(&request.path, problem));
    }
    let Loaded { scans, sha256 } = load(request, files)?;
    // A spectrum needs a height at every point.
    let gaps = if recipe.gaps == GapTreatment::Keep { GapTreatment::Refuse } else { recipe.gaps };
    let (file, _) = only_scan(request, scans, gaps, ScanProblem::NotOneMap)?;
    let map = map_in(request, &file, ScanProblem::LineHasNoArea)?;
    let found = MapSpectrum::new(map, &file, request.limits(), recipe)
        .map_err(|error| untransformed(request, error))?;
    let wavelengths_m = found.reliable.wavelengths_m();
    let modes = |wavelength_m: &f64| found.modes_at(*wavelength_m).map(|modes| modes as f64);
    let table = Table::default()
        .with_numbers("wavelength_m", wavelengths_m.iter().copied())
        .with_numbers("wavevector_rad_per_m", wavelengths_m.iter().map(|l| std::f64::consts::TAU / l))
        .with_numbers("Ciso_m4", found.reliable.values().iter().copied())
        .with_numbers("modes", wavelengths_m.iter().map(modes).collect::<Vec<_>>());
    let provenance = format!(
        "map: {} ({}), SHA-256 {sha256}, detrend {}, window {}",
        request.path, file.format, found.preparation.detrend, found.preparation.window
    );
    let of_map = |remark: Remark| remark.about([file.name.as_str()]);
    Ok(ArealTable { table, provenance, remarks: found.remarks.into_iter().map(of_map).collect() })
}
