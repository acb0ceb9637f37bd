//! A scan as read, joined with what is said about it elsewhere.

use crate::channel::Axis;
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::heights::Scan;
use crate::measure::Measure;
use crate::measured::Measured;
use crate::metadata::Probe;

/// A scan with what its file says about it: as measured, or, where `S` is a [`Scan`], whole.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScanFile<S = Measured> {
    /// Name of the measurement where metadata give one, else that of the file.
    pub name: String,
    /// Format it was read from; within a container, that of the data file.
    pub format: ScanFormat,
    /// The heights.
    pub scan: S,
    /// What they measure: heights in m, unless another channel was asked for or is visited.
    pub measure: Measure,
    /// The channel read, where the file names it.
    pub channel: Option<String>,
    /// The channels with heights that the file offers.
    pub channels: Vec<String>,
    /// Along which axis of a map the instrument scanned its lines, where the file says so.
    pub fast_axis: Option<Axis>,
    /// Whether the heights repeat themselves beyond the scan.
    pub is_periodic: bool,
    /// Whether the instrument has a tip, where the file says so or the format is that of instruments with one.
    pub probe: Option<Probe>,
    /// Radius of the tip of the instrument, in m, above 0.
    pub tip_radius_m: Option<f64>,
    /// Smallest length that the instrument resolves, in m, above 0.
    pub resolution_m: Option<f64>,
    /// What people wrote into the file or its metadata: comments and descriptions, which may tell of the tip.
    pub free_text: String,
    /// Assumptions made, and contradictions between the file, the options and the metadata, a sentence each.
    pub notes: Vec<String>,
}

impl<S> ScanFile<S> {
    /// The same file with what becomes of its heights.
    ///
    /// # Errors
    /// That of the change.
    pub fn try_map<T, E>(self, change: impl FnOnce(S) -> Result<T, E>) -> Result<ScanFile<T>, E> {
        Ok(ScanFile {
            name: self.name,
            format: self.format,
            scan: change(self.scan)?,
            measure: self.measure,
            channel: self.channel,
            channels: self.channels,
            fast_axis: self.fast_axis,
            is_periodic: self.is_periodic,
            probe: self.probe,
            tip_radius_m: self.tip_radius_m,
            resolution_m: self.resolution_m,
            free_text: self.free_text,
            notes: self.notes,
        })
    }
}

impl ScanFile {
    /// The file of a scan without gaps.
    ///
    /// # Errors
    /// [`ScanReadError::Scan`] with their number, where there are any.
    pub fn complete(self) -> Result<ScanFile<Scan>, ScanReadError> {
        self.try_map(|scan| scan.complete().map_err(ScanReadError::Scan))
    }
}
