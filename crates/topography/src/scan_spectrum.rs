//! Heights become a spectrum, limited to the band that shows the surface.

use scans::{Scan, ScanFile, ScanFormat};
use spectrum::ProfilePsd;

use crate::band_end::{band_of, tip_remark};
use crate::checks::Checks;
use crate::recipe::Recipe;
use crate::remark::{BandEnd, ScanRemark, Severity};
use crate::{BandLimits, LineSpectrum, Preparation, ReliableBand, TransformError, line_spectrum};

/// Heights that differ by no more than this share of the largest one are as flat as numbers can tell.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A scan and its spectrum.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ScanSpectrum {
    /// The name of the measurement.
    pub name: String,
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
    /// What ends them at the short end.
    pub band_end: BandEnd,
    /// The spectrum at these.
    pub reliable: ProfilePsd,
    /// How far it can be believed.
    pub checks: Checks,
    /// What reading took for granted, a sentence each.
    pub notes: Vec<String>,
}

impl ScanSpectrum {
    /// The spectrum of a scan. What is `given` of its instrument counts before what the file says of it, and that before the
    /// recipe.
    ///
    /// # Errors
    /// [`TransformError`] for limits that are no lengths, heights that are flat or beyond numbers, and a band without a bin.
    pub fn of(file: ScanFile, given: BandLimits, recipe: &Recipe) -> Result<Self, TransformError> {
        let preparation = recipe.preparation(file.is_periodic);
        let (band, band_end) = band_of(&file, given, recipe)?;
        let spectrum = line_spectrum(&file.scan, preparation);
        refuse_flat(&file.scan, &spectrum)?;
        let reliable = spectrum.profile(&band)?;
        let checks = Checks::of(&file.scan, &spectrum, preparation, file.is_periodic);
        Ok(ScanSpectrum {
            name: file.name,
            format: file.format,
            channel: file.channel,
            preparation,
            spectrum,
            band,
            band_end,
            reliable,
            checks,
            notes: file.notes,
        })
    }

    /// What is worth knowing about it, passed checks too.
    #[must_use]
    pub fn remarks(&self) -> Vec<ScanRemark> {
        let mut remarks: Vec<ScanRemark> = self.notes.iter().cloned().map(ScanRemark::Reading).collect();
        let (longest_m, shortest_m) =
            (self.reliable.longest_wavelength_m(), self.reliable.shortest_wavelength_m());
        remarks.push(ScanRemark::Band { longest_m, shortest_m, end: self.band_end });
        remarks.extend(tip_remark(&self.band, self.band_end));
        remarks.extend(self.checks.remarks());
        remarks
    }

    /// Whether anything about it calls for a warning.
    #[must_use]
    pub fn is_doubtful(&self) -> bool {
        self.remarks().iter().any(|remark| remark.severity() == Severity::Warning)
    }
}

/// Refuses heights that a trend takes away to rounding, and those whose squares overflow.
fn refuse_flat(scan: &Scan, spectrum: &LineSpectrum) -> Result<(), TransformError> {
    let heights_m = match scan {
        Scan::UniformLine(line) => line.heights_m(),
        Scan::NonuniformLine(line) => line.heights_m(),
        Scan::Map(map) => map.heights_m(),
    };
    let variance_m2 = spectrum.variance_m2();
    if !variance_m2.is_finite() {
        return Err(TransformError::BeyondNumbers);
    }
    let largest_m = heights_m.iter().fold(0.0, |largest: f64, height_m| largest.max(height_m.abs()));
    let rms_m = variance_m2.sqrt();
    if rms_m > ROUNDING * largest_m { Ok(()) } else { Err(TransformError::Flat { rms_m, largest_m }) }
}
