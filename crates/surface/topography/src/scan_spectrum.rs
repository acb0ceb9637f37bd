//! The spectrum of a scan in its reliable band.

use scans::{IGNORED, Scan, ScanAxis, ScanFile, ScanFormat};
use spectrum::ProfilePsd;
use units::{Remark, RemarkCode, RemarkLevel};

use crate::band_end::{FoundBand, band_of};
use crate::checks::Checks;
use crate::direction::{Direction, has_two, turned};
use crate::line::LineSpectrum;
use crate::lines::rows_spectrum;
use crate::median_lines::{LEAST_LINES, median_spectrum};
use crate::narrow_lines::{Peak, peaks};
use crate::noise_floor::{NoiseFloor, noise_floor};
use crate::piecewise::nonuniform_line_spectrum;
use crate::recipe::{LineAverage, Recipe};
use crate::remark::BandEnd;
use crate::rows::Lines;
use crate::{BandLimits, Preparation, ReliableBand, TransformError};

/// Ratio of rms to largest height below which a scan is flat to rounding.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A scan and its spectrum.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ScanSpectrum {
    /// The name of the measurement.
    pub name: String,
    /// Format of the file.
    pub format: ScanFormat,
    /// Name of the channel, if the file names channels.
    pub channel: Option<String>,
    /// Preparation of the heights.
    pub preparation: Preparation,
    /// The whole spectrum.
    pub spectrum: LineSpectrum,
    /// Reliable band.
    pub band: ReliableBand,
    /// Limit of the band at its short end.
    pub band_end: BandEnd,
    /// Remarks on a tip of unknown radius, and on a radius found in the text of the file.
    pub tip_remarks: Vec<Remark>,
    /// Noise floor of the instrument, if it shows.
    pub noise_floor: Option<NoiseFloor>,
    /// The spectrum in the reliable band.
    pub reliable: ProfilePsd,
    /// Narrow lines of the spectrum.
    pub(crate) peaks: Vec<Peak>,
    /// Checks of the spectrum.
    pub checks: Checks,
    /// Axis of the lines, if the map has a spectrum along each.
    pub axis: Option<ScanAxis>,
    /// Fast axis of the instrument, if the file states it.
    pub fast_axis: Option<ScanAxis>,
    /// Assumptions of the reader, one sentence each.
    pub notes: Vec<String>,
}

/// Computes the spectrum C1D of any scan; for a map the mean over its rows.
pub fn line_spectrum(scan: &Scan, preparation: Preparation) -> LineSpectrum {
    match Lines::from_scan(scan) {
        Lines::Even(rows) => rows_spectrum(rows, preparation),
        Lines::Uneven(line) => nonuniform_line_spectrum(line, preparation),
    }
}

impl ScanSpectrum {
    /// Computes the spectrum of a scan. `given` limits have precedence over those of the file, and these over the
    /// recipe.
    ///
    /// # Errors
    /// [`TransformError`] for limits that are not lengths, heights that are flat or overflow, and a band without bins.
    pub fn new(file: ScanFile<Scan>, given: BandLimits, recipe: &Recipe) -> Result<Self, TransformError> {
        Self::from_file(&file, given, recipe)
    }

    /// Computes the spectra of a scan along the axes of the recipe: one or two for a map, one for a line. Of two, the
    /// one along x comes first, and their names end in the axis.
    ///
    /// # Errors
    /// As [`ScanSpectrum::new`], and [`TransformError::NoLines`] if missing points left no line along y.
    pub fn per_direction(
        file: ScanFile<Scan>,
        given: BandLimits,
        recipe: &Recipe,
    ) -> Result<Vec<Self>, TransformError> {
        match recipe.direction {
            Direction::X => Ok(vec![Self::new(file, given, recipe)?]),
            Direction::Y => Ok(vec![Self::new(turned(file)?, given, recipe)?]),
            Direction::Both if !has_two(&file.scan) => Ok(vec![Self::new(turned(file)?, given, recipe)?]),
            Direction::Both => {
                let along_x = Self::from_file(&file, given, recipe)?.named_along(ScanAxis::X);
                let along_y = Self::new(turned(file)?, given, recipe)?.named_along(ScanAxis::Y);
                Ok(vec![along_x, along_y])
            }
        }
    }

    fn from_file(file: &ScanFile<Scan>, given: BandLimits, recipe: &Recipe) -> Result<Self, TransformError> {
        let preparation = recipe.preparation(file.is_periodic);
        let FoundBand { band, end: band_end, tip_remarks } = band_of(file, given, recipe)?;
        let mut spectrum = line_spectrum(&file.scan, preparation);
        refuse_flat(&file.scan, &spectrum)?;
        let mut notes = file.notes.clone();
        if recipe.line_average == LineAverage::Median {
            match Lines::from_scan(&file.scan) {
                Lines::Even(rows) if rows.count() >= LEAST_LINES => {
                    spectrum = median_spectrum(rows, spectrum, preparation);
                }
                _ => notes
                    .push(format!("{IGNORED}the median over lines: it takes {LEAST_LINES} of them or more")),
            }
        }
        let reliable = spectrum.profile(&band)?;
        let checks = Checks::new(&file.scan, &spectrum, preparation, file.is_periodic);
        Ok(ScanSpectrum {
            name: file.name.clone(),
            format: file.format,
            channel: file.channel.clone(),
            preparation,
            noise_floor: noise_floor(&spectrum),
            peaks: peaks(&spectrum, preparation.window),
            spectrum,
            band,
            band_end,
            tip_remarks,
            reliable,
            checks,
            axis: None,
            fast_axis: file.fast_axis,
            notes,
        })
    }

    fn named_along(mut self, axis: ScanAxis) -> Self {
        self.name += match axis {
            ScanAxis::X => ", along x",
            ScanAxis::Y => ", along y",
        };
        self.axis = Some(axis);
        self
    }

    /// Collects remarks on the spectrum, including passed checks.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = readings(&self.notes);
        let (longest_m, shortest_m) =
            (self.reliable.longest_wavelength_m(), self.reliable.shortest_wavelength_m());
        let band = Remark::new(RemarkCode::Band).with("longest_m", longest_m).with("shortest_m", shortest_m);
        remarks.push(band.with("end", self.band_end.to_string()));
        remarks.extend(self.tip_remarks.iter().cloned());
        let is_used = |floor: &NoiseFloor| floor.wavelength_m > shortest_m;
        remarks.extend(self.noise_floor.filter(is_used).map(|floor| {
            let remark = Remark::new(RemarkCode::NoiseFloor).with("c1d_m3", floor.c1d_m3);
            remark.with("wavelength_m", floor.wavelength_m)
        }));
        remarks.extend(self.checks.remarks());
        remarks
    }

    /// Returns true if a remark is a warning.
    #[must_use]
    pub fn is_doubtful(&self) -> bool {
        self.remarks().iter().any(|remark| remark.level == RemarkLevel::Caution)
    }
}

/// Returns remarks on the assumptions of a reader, and on options that a scan has no use for.
#[must_use]
pub fn readings(notes: &[String]) -> Vec<Remark> {
    let code = |note: &str| match note.starts_with(scans::IGNORED) {
        true => RemarkCode::ScanOptionIgnored,
        false => RemarkCode::ScanReading,
    };
    notes.iter().map(|note| Remark::new(code(note)).with("text", note.as_str())).collect()
}

/// Refuses heights that detrending reduces to rounding, and those whose squares overflow.
fn refuse_flat(scan: &Scan, spectrum: &LineSpectrum) -> Result<(), TransformError> {
    let heights_m = match Lines::from_scan(scan) {
        Lines::Even(rows) => rows.heights_m,
        Lines::Uneven(line) => line.heights_m(),
    };
    let variance_m2 = spectrum.variance_m2;
    if !variance_m2.is_finite() {
        return Err(TransformError::BeyondNumbers);
    }
    let largest_m = heights_m.iter().fold(0.0, |largest: f64, height_m| largest.max(height_m.abs()));
    let rms_m = variance_m2.sqrt();
    if rms_m > ROUNDING * largest_m { Ok(()) } else { Err(TransformError::Flat { rms_m, largest_m }) }
}
