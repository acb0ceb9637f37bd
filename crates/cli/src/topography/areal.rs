//! The two-dimensional spectrum of a map.

use std::path::Path;

use rayon::prelude::*;
use scans::{HeightMap, Scan};
use topography::{ArealRows, ArealSpectrum, ArealSums, ArealTransform, Preparation, ReliableBand};

use super::load::{Loaded, load};
use super::request::{Recipe, ScanRequest};
use crate::failure::Failure;
use crate::table::Table;

/// The two-dimensional spectrum of a map, averaged radially.
pub struct AreaSpectrum {
    /// `wavelength_m, wavevector_rad_per_m, Ciso_m4, modes`, from long to short wavelengths, as far as it shows the surface.
    pub table: Table,
    /// How it was made: the file with its SHA-256, and what was done to the heights.
    pub provenance: String,
    /// What reading took for granted.
    pub notes: Vec<String>,
}

/// The spectrum of the one map in a file, relative to `folder`.
///
/// # Errors
/// [`Failure::Input`] where the file holds no map, or several.
pub fn areal_spectrum(
    request: &ScanRequest,
    folder: &Path,
    recipe: &Recipe,
) -> Result<AreaSpectrum, Failure> {
    let refused = |what: String| Failure::Input(format!("{}: {what}", request.path));
    let Loaded { scans, sha256 } = load(request, folder)?;
    let [file] = &scans[..] else {
        return Err(refused(format!("{} scans; an areal spectrum is that of one map", scans.len())));
    };
    let Scan::Map(map) = &file.scan else {
        return Err(refused("a line scan has no areal spectrum; leave --areal out".to_owned()));
    };
    let preparation = recipe.preparation(file.is_periodic);
    let band = ReliableBand::of(&file.scan, request.limits(file, recipe))
        .map_err(|error| refused(error.to_string()))?;
    let spectrum = transformed(map, preparation);
    let shown = spectrum.ciso(&band).map_err(|error| refused(error.to_string()))?;
    let modes = |wavelength_m: &f64| {
        let q = std::f64::consts::TAU / wavelength_m;
        let near = |bin: &&topography::RadialBin| (bin.wavevector_rad_per_m / q - 1.0).abs() < 1e-9;
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

/// The spectrum of a map, on all threads, with the same digits on any number of them.
fn transformed(map: &HeightMap, preparation: Preparation) -> ArealSpectrum {
    let transform = ArealTransform::new(map, preparation);
    let rows: Vec<ArealRows> =
        (0..transform.row_blocks()).into_par_iter().map(|block| transform.rows(block)).collect();
    let sums: Vec<ArealSums> =
        (0..transform.column_blocks()).into_par_iter().map(|block| transform.columns(&rows, block)).collect();
    transform.spectrum(&rows, &sums)
}
