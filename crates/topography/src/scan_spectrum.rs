//! Heights become a spectrum, limited to the band that shows the surface.

use scans::{Probe, Scan, ScanFile, ScanFormat};
use spectrum::ProfilePsd;

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
        let limits = recipe.limits(given, &file);
        let band = ReliableBand::of(&file.scan, limits)?;
        let spectrum = line_spectrum(&file.scan, preparation);
        refuse_flat(&file.scan, &spectrum)?;
        let reliable = spectrum.profile(&band)?;
        let checks = Checks::of(&file.scan, &spectrum, preparation, file.is_periodic);
        let band_end = band_end(&band, limits, given, may_have_a_tip(&file));
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
        if self.band_end == BandEnd::PixelsWithoutTip {
            remarks.push(ScanRemark::TipUnknown { shortest_m: self.band.shortest_m });
        }
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

/// Which of the limits of a band is the longest.
fn band_end(band: &ReliableBand, limits: BandLimits, given: BandLimits, may_have_a_tip: bool) -> BandEnd {
    let ends = |limit_m: Option<f64>| limit_m.is_some_and(|limit_m| limit_m == band.shortest_m);
    match limits.tip_radius_m {
        Some(radius_m) if ends(band.tip_m) => BandEnd::Tip { radius_m },
        _ if ends(given.shortest_m) => BandEnd::Given,
        _ if ends(band.user_m) => BandEnd::Resolution,
        None if limits.shortest_m.is_none() && may_have_a_tip => BandEnd::PixelsWithoutTip,
        _ => BandEnd::Pixels,
    }
}

/// Whether a tip may have touched the surface: not of a microscope, nor of heights that repeat themselves, which were
/// computed.
fn may_have_a_tip(file: &ScanFile) -> bool {
    file.probe != Some(Probe::Microscope) && !file.is_periodic
}
