//! A scan as read, with its metadata.

use crate::channel::ScanAxis;
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::heights::Scan;
use crate::measure::Measure;
use crate::measured::MeasuredScan;
use crate::metadata::Probe;
use crate::missing_points::MissingPoints;
use crate::scan_size::ScanSize;

/// A scan with the metadata of its file: as measured, or complete where `S` is a [`Scan`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScanFile<S = MeasuredScan> {
    /// Name of the measurement where metadata give one, else that of the file.
    pub name: String,
    /// Format it was read from; within a container, that of the data file.
    pub format: ScanFormat,
    /// The heights.
    pub scan: S,
    /// Quantity measured: heights in m, unless another channel was asked for or is visited.
    pub measure: Measure,
    /// The channel read, where the file names it.
    pub channel: Option<String>,
    /// The channels with heights that the file offers.
    pub channels: Vec<String>,
    /// Axis of a map along which the instrument scanned its lines, where the file states it.
    pub fast_axis: Option<ScanAxis>,
    /// True if the heights repeat themselves beyond the scan.
    pub is_periodic: bool,
    /// The probe, where the file states it or the format has only one kind.
    pub probe: Option<Probe>,
    /// Radius of the tip of the instrument, in m, above 0.
    pub tip_radius_m: Option<f64>,
    /// Smallest length that the instrument resolves, in m, above 0.
    pub resolution_m: Option<f64>,
    /// Comments and descriptions by people, in the file or its metadata; they may mention the tip.
    pub free_text: String,
    /// Assumptions made, and contradictions between the file, the options and the metadata, a sentence each.
    pub notes: Vec<String>,
}

impl<S> ScanFile<S> {
    /// Replaces the scan and keeps everything else.
    ///
    /// # Errors
    /// The error of `change`.
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
    /// A line of so many evenly spaced heights \[m\] that are in memory; values at missing points are ignored,
    /// but finite.
    ///
    /// # Errors
    /// [`ScanReadError::Scan`] for heights and sizes that make no line.
    pub fn of_line(
        name: String,
        size: ScanSize,
        heights_m: Vec<f64>,
        missing: MissingPoints,
    ) -> Result<Self, ScanReadError> {
        let line = size.line(heights_m)?;
        Ok(Self::in_memory(name, MeasuredScan::with_missing_points(line, missing), Vec::new()))
    }

    /// A map of heights \[m\] that are in memory, row after row of so many columns; values at missing
    /// points are ignored, but finite.
    ///
    /// # Errors
    /// [`ScanReadError::Scan`] for heights and sizes that make no map.
    pub fn of_map(
        name: String,
        size: ScanSize,
        columns: usize,
        heights_m: Vec<f64>,
        missing: MissingPoints,
    ) -> Result<Self, ScanReadError> {
        let mut notes = Vec::new();
        let map = size.map(columns, heights_m, &mut notes)?;
        Ok(Self::in_memory(name, MeasuredScan::with_missing_points(map, missing), notes))
    }

    fn in_memory(name: String, scan: MeasuredScan, notes: Vec<String>) -> Self {
        ScanFile {
            name,
            format: ScanFormat::Memory,
            scan,
            measure: Measure::Height,
            channel: None,
            channels: Vec::new(),
            fast_axis: None,
            is_periodic: false,
            probe: None,
            tip_radius_m: None,
            resolution_m: None,
            free_text: String::new(),
            notes,
        }
    }

    /// The file of a scan without missing points.
    ///
    /// # Errors
    /// [`ScanReadError::Scan`] with their number, where there are any.
    pub fn complete(self) -> Result<ScanFile<Scan>, ScanReadError> {
        self.try_map(|scan| scan.complete().map_err(ScanReadError::Scan))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_in_memory_make_scans() {
        let size = ScanSize { x_m: 4.0, y_m: Some(6.0) };
        let missing: MissingPoints = [1].into_iter().collect();
        let map =
            ScanFile::of_map("a".to_owned(), size, 2, vec![1.0, 0.0, 3.0, 4.0, 5.0, 6.0], missing).unwrap();
        assert_eq!((map.scan.points(), map.scan.spacing_m()), ((2, Some(3)), (2.0, Some(2.0))));
        assert_eq!((map.scan.height_m(1), map.scan.height_m(2)), (None, Some(3.0)));
        assert_eq!((map.format.to_string(), map.notes.len()), ("memory".to_owned(), 0));
        let line = ScanFile::of_line("b".to_owned(), size, vec![1.0, 2.0], MissingPoints::default()).unwrap();
        assert_eq!((line.scan.points(), line.scan.size_m()), ((2, None), (4.0, None)));
        let message = |found: Result<ScanFile, ScanReadError>| found.unwrap_err().to_string();
        let of_columns =
            |columns| ScanFile::of_map("c".to_owned(), size, columns, vec![0.0; 6], MissingPoints::default());
        assert!(message(of_columns(0)).contains("the number of columns is 0"));
        assert!(message(of_columns(6)).contains("the number of rows is 1"));
        let none = ScanFile::of_line("d".to_owned(), size, Vec::new(), MissingPoints::default());
        assert!(message(none).contains("the number of points is 0"));
    }
}
