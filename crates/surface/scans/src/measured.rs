//! Measured heights, with missing points.

use crate::heights::{HeightMap, NonuniformLineScan, Scan, ScanError, UniformLineScan};
use crate::missing_points::MissingPoints;

/// A scan as an instrument gives it, with its missing points. [`MeasuredScan::complete`] refuses a scan that has to be
/// mended first.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredScan {
    /// Heights of missing points are 0 and never shown.
    scan: Scan,
    missing: MissingPoints,
}

impl From<Scan> for MeasuredScan {
    fn from(scan: Scan) -> Self {
        Self { scan, missing: MissingPoints::default() }
    }
}

impl MeasuredScan {
    /// A scan with missing points; the heights that it holds there are ignored.
    pub fn with_missing_points(scan: Scan, missing: MissingPoints) -> Self {
        Self { scan, missing }
    }

    /// Returns the missing points.
    #[must_use]
    pub fn missing_points(&self) -> &MissingPoints {
        &self.missing
    }

    /// Number of points along x and, of a map, along y; of parallel lines the number of lines.
    #[must_use]
    pub fn points(&self) -> (usize, Option<usize>) {
        match &self.scan {
            Scan::UniformLine(line) => (line.heights_m().len(), None),
            Scan::NonuniformLine(line) => (line.heights_m().len(), None),
            Scan::Map(map) => (map.columns(), Some(map.rows())),
            Scan::Lines(lines) => (lines.points(), Some(lines.lines())),
        }
    }

    /// Distances in m of neighbouring points along x and, of a map, along y; of unevenly spaced points, none of which
    /// is missing, the mean.
    #[must_use]
    pub fn spacing_m(&self) -> (f64, Option<f64>) {
        match &self.scan {
            Scan::UniformLine(line) => (line.spacing_m(), None),
            Scan::NonuniformLine(line) => (line.mean_spacing_m(), None),
            Scan::Map(map) => (map.spacing_x_m(), Some(map.spacing_y_m())),
            Scan::Lines(lines) => (lines.spacing_m(), None),
        }
    }

    /// Size in m along x and, of a map, along y: points times spacing, of unevenly spaced points from the first to the
    /// last.
    #[must_use]
    pub fn size_m(&self) -> (f64, Option<f64>) {
        match &self.scan {
            Scan::UniformLine(line) => (line.length_m(), None),
            Scan::NonuniformLine(line) => (line.length_m(), None),
            Scan::Map(map) => {
                (map.spacing_x_m() * map.columns() as f64, Some(map.spacing_y_m() * map.rows() as f64))
            }
            Scan::Lines(lines) => (lines.length_m(), None),
        }
    }

    /// Positions in m of unevenly spaced points; none of any other scan.
    #[must_use]
    pub fn positions_m(&self) -> Option<&[f64]> {
        match &self.scan {
            Scan::NonuniformLine(line) => Some(line.positions_m()),
            _ => None,
        }
    }

    /// The heights in m, row after row, where there are any.
    pub fn heights_m(&self) -> impl ExactSizeIterator<Item = Option<f64>> {
        let height = |(index, &height_m): (usize, &f64)| (!self.missing.contains(index)).then_some(height_m);
        self.stored_m().iter().enumerate().map(height)
    }

    /// All heights in m, row after row; none if a point is missing.
    #[must_use]
    pub fn complete_heights_m(&self) -> Option<&[f64]> {
        self.missing.is_empty().then(|| self.stored_m())
    }

    /// The height in m of a point, where it has one.
    #[inline]
    #[must_use]
    pub fn height_m(&self, index: usize) -> Option<f64> {
        self.stored_m().get(index).copied().filter(|_| !self.missing.contains(index))
    }

    /// Returns the scan if no point is missing.
    ///
    /// # Errors
    /// [`ScanError::MissingPoints`] with their number.
    pub fn complete(self) -> Result<Scan, ScanError> {
        match self.missing.indices().next() {
            None => Ok(self.scan),
            Some(first) => {
                let place = self.place(first);
                Err(ScanError::MissingPoints {
                    missing: self.missing.count(),
                    points: self.stored_m().len(),
                    place,
                })
            }
        }
    }

    /// Takes the heights of points away. Of unevenly spaced points, none of which is missing, nothing is left of them.
    ///
    /// # Errors
    /// [`ScanError`] if fewer than two unevenly spaced points are left.
    pub fn without_points(mut self, indices: &[usize]) -> Result<Self, ScanError> {
        if let Scan::NonuniformLine(line) = &self.scan {
            let gone: MissingPoints = indices.iter().copied().collect();
            let kept = |values: &[f64]| {
                let kept = values.iter().enumerate().filter(|(index, _)| !gone.contains(*index));
                kept.map(|(_, value)| *value).collect::<Vec<f64>>()
            };
            let line = NonuniformLineScan::new(kept(line.positions_m()), kept(line.heights_m()))?;
            return Ok(Scan::NonuniformLine(line).into());
        }
        indices.iter().for_each(|&index| self.missing.insert(index));
        Ok(self)
    }

    /// Fills the missing points with heights in m, in their order.
    ///
    /// # Errors
    /// [`ScanError`] for heights that are not finite, and for more or fewer of them than there are missing points.
    pub fn filled(self, heights_m: &[f64]) -> Result<Scan, ScanError> {
        if heights_m.len() != self.missing.count() {
            let what = format!("{} missing points", self.missing.count());
            return Err(ScanError::LengthMismatch { heights: heights_m.len(), what });
        }
        let put = |mut all_m: Vec<f64>| {
            self.missing.indices().zip(heights_m).for_each(|(index, height_m)| all_m[index] = *height_m);
            all_m
        };
        Ok(match self.scan {
            Scan::UniformLine(line) => {
                Scan::UniformLine(UniformLineScan::new(line.spacing_m(), put(line.heights_m))?)
            }
            Scan::Map(map) => {
                let (columns, x_m, y_m) = (map.columns(), map.spacing_x_m(), map.spacing_y_m());
                Scan::Map(HeightMap::new(columns, x_m, y_m, put(map.heights_m))?)
            }
            whole @ (Scan::NonuniformLine(_) | Scan::Lines(_)) => whole,
        })
    }

    fn stored_m(&self) -> &[f64] {
        match &self.scan {
            Scan::UniformLine(line) => line.heights_m(),
            Scan::NonuniformLine(line) => line.heights_m(),
            Scan::Map(map) => map.heights_m(),
            Scan::Lines(lines) => lines.heights_m(),
        }
    }

    /// A point in words, counted from 1.
    fn place(&self, index: usize) -> String {
        match &self.scan {
            Scan::Map(map) => {
                format!("row {}, column {}", index / map.columns() + 1, index % map.columns() + 1)
            }
            Scan::Lines(lines) => {
                format!("line {}, point {}", index / lines.points() + 1, index % lines.points() + 1)
            }
            _ => format!("point {}", index + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> MeasuredScan {
        let heights_m = vec![1.0, 2.0, 0.0, 4.0, 5.0, 0.0];
        let map = HeightMap::new(3, 1.0, 2.0, heights_m).unwrap();
        MeasuredScan::with_missing_points(Scan::Map(map), [2, 5].into_iter().collect())
    }

    #[test]
    fn missing_points_are_told_and_filled() {
        assert_eq!(map().heights_m().flatten().collect::<Vec<_>>(), [1.0, 2.0, 4.0, 5.0]);
        assert_eq!((map().height_m(1), map().height_m(2), map().height_m(6)), (Some(2.0), None, None));
        assert_eq!((map().points(), map().size_m()), ((3, Some(2)), (3.0, Some(4.0))));
        let refusal = map().complete().unwrap_err().to_string();
        assert!(
            refusal
                .starts_with("building a scan: 2 of 6 points have no height, the first in row 1, column 3")
        );
        let Scan::Map(filled) = map().filled(&[3.0, 6.0]).unwrap() else { panic!("a map") };
        assert_eq!(filled.heights_m(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert!(map().filled(&[3.0]).is_err() && map().filled(&[3.0, f64::NAN]).is_err());
    }
}
