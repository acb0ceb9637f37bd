//! Heights become a spectrum, limited to the band that shows the surface.

use scans::{Axis, Scan, ScanFile, ScanFormat};
use spectrum::ProfilePsd;

use crate::band_end::{FoundBand, band_of};
use crate::checks::Checks;
use crate::direction::{Direction, has_two, turned};
use crate::noise_floor::{NoiseFloor, noise_floor};
use crate::recipe::Recipe;
use crate::remark::{BandEnd, ScanRemark, Severity};
use crate::rows::Lines;
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
    /// Where the radius of the tip comes from, and what there is to say of a tip that nobody knows.
    pub of_tip: Vec<ScanRemark>,
    /// The noise of the instrument, where it shows.
    pub noise_floor: Option<NoiseFloor>,
    /// The spectrum at these.
    pub reliable: ProfilePsd,
    /// How far it can be believed.
    pub checks: Checks,
    /// Along which axis of its map the lines run, where there is a spectrum along each.
    pub axis: Option<Axis>,
    /// Along which axis the instrument scanned, where the file says so.
    pub fast_axis: Option<Axis>,
    /// What reading took for granted, a sentence each.
    pub notes: Vec<String>,
}

impl ScanSpectrum {
    /// The spectrum of a scan. What is `given` of its instrument counts before what the file says of it, and that before the
    /// recipe.
    ///
    /// # Errors
    /// [`TransformError`] for limits that are no lengths, heights that are flat or beyond numbers, and a band without a bin.
    pub fn of(file: ScanFile<Scan>, given: BandLimits, recipe: &Recipe) -> Result<Self, TransformError> {
        Self::of_file(&file, given, recipe)
    }

    /// The spectra of a scan along the axes that the recipe asks for: of a map one or two, of a line the one there is. Of two
    /// the one along x comes first, and their names end in the axis.
    ///
    /// # Errors
    /// As of [`ScanSpectrum::of`], and [`TransformError::NoLines`] where gaps left no line along y.
    pub fn of_directions(
        file: ScanFile<Scan>,
        given: BandLimits,
        recipe: &Recipe,
    ) -> Result<Vec<Self>, TransformError> {
        match recipe.direction {
            Direction::X => Ok(vec![Self::of(file, given, recipe)?]),
            Direction::Y => Ok(vec![Self::of(turned(file)?, given, recipe)?]),
            Direction::Both if !has_two(&file.scan) => Ok(vec![Self::of(turned(file)?, given, recipe)?]),
            Direction::Both => {
                let along_x = Self::of_file(&file, given, recipe)?.named_along(Axis::X);
                let along_y = Self::of(turned(file)?, given, recipe)?.named_along(Axis::Y);
                Ok(vec![along_x, along_y])
            }
        }
    }

    fn of_file(file: &ScanFile<Scan>, given: BandLimits, recipe: &Recipe) -> Result<Self, TransformError> {
        let preparation = recipe.preparation(file.is_periodic);
        let FoundBand { band, end: band_end, of_tip } = band_of(file, given, recipe)?;
        let spectrum = line_spectrum(&file.scan, preparation);
        refuse_flat(&file.scan, &spectrum)?;
        let reliable = spectrum.profile(&band)?;
        let checks = Checks::of(&file.scan, &spectrum, preparation, file.is_periodic);
        Ok(ScanSpectrum {
            name: file.name.clone(),
            format: file.format,
            channel: file.channel.clone(),
            preparation,
            noise_floor: noise_floor(&spectrum),
            spectrum,
            band,
            band_end,
            of_tip,
            reliable,
            checks,
            axis: None,
            fast_axis: file.fast_axis,
            notes: file.notes.clone(),
        })
    }

    fn named_along(mut self, axis: Axis) -> Self {
        self.name += match axis {
            Axis::X => ", along x",
            Axis::Y => ", along y",
        };
        self.axis = Some(axis);
        self
    }

    /// What is worth knowing about it, passed checks too.
    #[must_use]
    pub fn remarks(&self) -> Vec<ScanRemark> {
        let mut remarks: Vec<ScanRemark> = self.notes.iter().cloned().map(ScanRemark::Reading).collect();
        let (longest_m, shortest_m) =
            (self.reliable.longest_wavelength_m(), self.reliable.shortest_wavelength_m());
        remarks.push(ScanRemark::Band { longest_m, shortest_m, end: self.band_end });
        remarks.extend(self.of_tip.iter().cloned());
        let is_used = |floor: &NoiseFloor| floor.wavelength_m > shortest_m;
        remarks.extend(self.noise_floor.filter(is_used).map(ScanRemark::NoiseFloor));
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
    let heights_m = match Lines::of(scan) {
        Lines::Even(rows) => rows.heights_m,
        Lines::Uneven(line) => line.heights_m(),
    };
    let variance_m2 = spectrum.variance_m2();
    if !variance_m2.is_finite() {
        return Err(TransformError::BeyondNumbers);
    }
    let largest_m = heights_m.iter().fold(0.0, |largest: f64, height_m| largest.max(height_m.abs()));
    let rms_m = variance_m2.sqrt();
    if rms_m > ROUNDING * largest_m { Ok(()) } else { Err(TransformError::Flat { rms_m, largest_m }) }
}
