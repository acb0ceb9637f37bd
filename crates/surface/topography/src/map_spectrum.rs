//! The two-dimensional spectrum of a map in its reliable band.

use scans::{HeightMap, Scan, ScanFile};
use spectrum::Psd;
use units::Remark;

use crate::band_end::{FoundBand, band_of};
use crate::recipe::Recipe;
use crate::scan_spectrum::readings;
use crate::{ArealSpectrum, BandLimits, Preparation, TransformError, areal_spectrum};

/// The two-dimensional spectrum of a map, averaged radially.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct MapSpectrum {
    /// Preparation of the heights.
    pub preparation: Preparation,
    /// The whole spectrum.
    pub spectrum: ArealSpectrum,
    /// The spectrum in the reliable band.
    pub reliable: Psd,
    /// Remarks on the spectrum.
    pub remarks: Vec<Remark>,
}

/// Returns the map of a scan; `None` for a line.
///
/// # Errors
/// [`TransformError::LinesHaveNoArea`] for lines that were cut out of a map.
pub fn map_of(scan: &Scan) -> Result<Option<&HeightMap>, TransformError> {
    match scan {
        Scan::Map(map) => Ok(Some(map)),
        Scan::Lines(_) => Err(TransformError::LinesHaveNoArea),
        Scan::UniformLine(_) | Scan::NonuniformLine(_) => Ok(None),
    }
}

impl MapSpectrum {
    /// Computes the spectrum of the map in a file; `given` limits have precedence as for a
    /// [`ScanSpectrum`](crate::ScanSpectrum).
    ///
    /// # Errors
    /// [`TransformError`] for limits that are not lengths, and a band without bins.
    pub fn new(
        map: &HeightMap,
        file: &ScanFile<Scan>,
        given: BandLimits,
        recipe: &Recipe,
    ) -> Result<Self, TransformError> {
        let preparation = recipe.preparation(file.is_periodic);
        let FoundBand { band, tip_remarks, .. } = band_of(file, given, recipe)?;
        let spectrum = areal_spectrum(map, preparation);
        let reliable = spectrum.ciso(&band)?;
        let mut remarks = readings(&file.notes);
        remarks.extend(tip_remarks);
        Ok(MapSpectrum { preparation, spectrum, reliable, remarks })
    }

    /// Number of modes averaged at a wavelength \[m\]; `None` if no bin has it.
    #[must_use]
    pub fn modes_at(&self, wavelength_m: f64) -> Option<u64> {
        let q = std::f64::consts::TAU / wavelength_m;
        let bins = self.spectrum.bins.iter();
        bins.map(|bin| (bin.wavevector_rad_per_m, bin.modes))
            .find(|(wavevector, _)| (wavevector / q - 1.0).abs() < 1e-9)
            .map(|(_, modes)| modes)
    }
}
