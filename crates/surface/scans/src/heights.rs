//! Measured heights: line scans at even or uneven spacing, and maps.

use thiserror::Error;
use units::display::length;

/// Heights at even spacing along a line: at least two, all within 1e30 m.
#[derive(Clone, Debug, PartialEq)]
pub struct UniformLineScan {
    spacing_m: f64,
    pub(crate) heights_m: Vec<f64>,
}

/// Heights at uneven positions along a line: at least two, all within 1e30 m, the positions strictly rising.
#[derive(Clone, Debug, PartialEq)]
pub struct NonuniformLineScan {
    positions_m: Vec<f64>,
    heights_m: Vec<f64>,
}

/// Heights on a grid: at least two columns and two rows, all within 1e30 m.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    columns: usize,
    spacing_x_m: f64,
    spacing_y_m: f64,
    pub(crate) heights_m: Vec<f64>,
}

/// Parallel lines of equally many evenly spaced points: what is left of a map or a line without the points that have no
/// height. How far the lines are apart is not known.
#[derive(Clone, Debug, PartialEq)]
pub struct ParallelLines {
    spacing_m: f64,
    points: usize,
    heights_m: Vec<f64>,
    across: Option<Box<ParallelLines>>,
}

/// A scan of any kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Scan {
    /// Evenly spaced along a line.
    UniformLine(UniformLineScan),
    /// Unevenly spaced along a line.
    NonuniformLine(NonuniformLineScan),
    /// On a grid.
    Map(HeightMap),
    /// Lines cut out of a map or a line with missing points.
    Lines(ParallelLines),
}

/// Error of samples that form no scan. Points, rows and columns are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ScanError {
    /// Fewer than two points, or rows, or columns.
    #[error("building a scan: the number of {what} is {found}, it must be at least 2")]
    TooFew {
        /// Name of the quantity counted.
        what: &'static str,
        /// Number found.
        found: usize,
    },
    /// A spacing that is not a length, or an absurd one.
    #[error(
        "building a scan: the {what} is {}, it must be above 0 and within 1e-60 to 1e60 m; check the size of the scan and its unit",
        length(*.value)
    )]
    BadSpacing {
        /// Name of the spacing.
        what: &'static str,
        /// Its value in m.
        value: f64,
    },
    /// Points without a height in what has to be a whole scan.
    #[error(
        "building a scan: {missing} of {points} points have no height, the first in {place}; have them filled, or cut them out"
    )]
    MissingPoints {
        /// Number of points without a height.
        missing: usize,
        /// Number of points.
        points: usize,
        /// Place of the first of them.
        place: String,
    },
    /// A height that is not a finite number.
    #[error("building a scan: the height of {place} is not a finite number; leave the point out")]
    UndefinedHeight {
        /// Place of the point or field.
        place: String,
    },
    /// A height that no surface has.
    #[error(
        "building a scan: the height of {place} is {}, it must be within 1e30 m; check the unit of the heights",
        length(*.height_m)
    )]
    AbsurdHeight {
        /// Place of the point or field.
        place: String,
        /// The height in m.
        height_m: f64,
    },
    /// Positions and heights, or rows, of different lengths.
    #[error("building a scan: {heights} heights do not fill {what}")]
    LengthMismatch {
        /// Number of heights.
        heights: usize,
        /// Points that they should fill.
        what: String,
    },
    /// Positions that do not rise.
    #[error(
        "building a scan: the position of point {point} is {position_m} m, that of the point before {before_m} m; positions must rise"
    )]
    PositionsDoNotRise {
        /// The offending point.
        point: usize,
        /// Its position in m.
        position_m: f64,
        /// Position of the point before in m.
        before_m: f64,
    },
}

impl UniformLineScan {
    /// Heights in m every `spacing_m` > 0.
    ///
    /// # Errors
    /// [`ScanError`] for fewer than two heights, an undefined one, or a bad spacing.
    pub fn new(spacing_m: f64, heights_m: Vec<f64>) -> Result<Self, ScanError> {
        refuse_few("points", heights_m.len())?;
        refuse_bad_spacing("spacing", spacing_m)?;
        refuse_undefined(&heights_m, |index| format!("point {}", index + 1))?;
        Ok(Self { spacing_m, heights_m })
    }

    /// Distance of neighbouring points in m.
    #[inline]
    pub fn spacing_m(&self) -> f64 {
        self.spacing_m
    }

    /// Heights in m.
    #[inline]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// Length of the scan in m: that of its period, one spacing more than from the first to the last point.
    pub fn length_m(&self) -> f64 {
        self.spacing_m * self.heights_m.len() as f64
    }
}

impl NonuniformLineScan {
    /// Heights in m at strictly rising positions in m.
    ///
    /// # Errors
    /// [`ScanError`] for fewer than two points, lengths that differ, an undefined height, or positions that do not
    /// rise.
    pub fn new(positions_m: Vec<f64>, heights_m: Vec<f64>) -> Result<Self, ScanError> {
        refuse_few("points", heights_m.len())?;
        if positions_m.len() != heights_m.len() {
            let what = format!("{} positions", positions_m.len());
            return Err(ScanError::LengthMismatch { heights: heights_m.len(), what });
        }
        refuse_undefined(&heights_m, |index| format!("point {}", index + 1))?;
        let rises = |pair: &[f64]| pair[0].is_finite() && pair[1].is_finite() && pair[0] < pair[1];
        if let Some(at) = positions_m.windows(2).position(|pair| !rises(pair)) {
            let (before_m, position_m) = (positions_m[at], positions_m[at + 1]);
            return Err(ScanError::PositionsDoNotRise { point: at + 2, position_m, before_m });
        }
        Ok(Self { positions_m, heights_m })
    }

    /// Positions in m, strictly rising.
    #[inline]
    pub fn positions_m(&self) -> &[f64] {
        &self.positions_m
    }

    /// Heights in m.
    #[inline]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// Distance in m from the first to the last point.
    pub fn length_m(&self) -> f64 {
        self.positions_m[self.positions_m.len() - 1] - self.positions_m[0]
    }

    /// Mean distance in m of neighbouring points.
    pub fn mean_spacing_m(&self) -> f64 {
        self.length_m() / (self.positions_m.len() - 1) as f64
    }
}

impl HeightMap {
    /// Heights in m, row after row of `columns` each; neighbours are `spacing_x_m` apart within a row, and the rows
    /// `spacing_y_m`.
    ///
    /// # Errors
    /// [`ScanError`] for fewer than two rows or columns, an incomplete row, an undefined height, or a bad spacing.
    pub fn new(
        columns: usize,
        spacing_x_m: f64,
        spacing_y_m: f64,
        heights_m: Vec<f64>,
    ) -> Result<Self, ScanError> {
        refuse_few("columns", columns)?;
        if !heights_m.len().is_multiple_of(columns) {
            return Err(ScanError::LengthMismatch {
                heights: heights_m.len(),
                what: format!("rows of {columns} columns"),
            });
        }
        refuse_few("rows", heights_m.len() / columns)?;
        refuse_bad_spacing("spacing along x", spacing_x_m)?;
        refuse_bad_spacing("spacing along y", spacing_y_m)?;
        refuse_undefined(&heights_m, |index| {
            format!("row {}, column {}", index / columns + 1, index % columns + 1)
        })?;
        Ok(Self { columns, spacing_x_m, spacing_y_m, heights_m })
    }

    /// Number of columns: points along x, the fast scan direction.
    #[inline]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows: points along y.
    #[inline]
    pub fn rows(&self) -> usize {
        self.heights_m.len() / self.columns
    }

    /// Distance in m of neighbours within a row.
    #[inline]
    pub fn spacing_x_m(&self) -> f64 {
        self.spacing_x_m
    }

    /// Distance in m of neighbouring rows.
    #[inline]
    pub fn spacing_y_m(&self) -> f64 {
        self.spacing_y_m
    }

    /// Heights in m, row after row.
    #[inline]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// The middle of the map, at most so many points along each side, two at least.
    #[must_use]
    pub fn middle(&self, most_points: usize) -> Self {
        let most_points = most_points.max(2);
        let kept = |points: usize| {
            let count = points.min(most_points);
            let first = (points - count) / 2;
            first..first + count
        };
        let columns = kept(self.columns);
        let rows = self.heights_m.chunks_exact(self.columns).skip(kept(self.rows()).start);
        let heights_m =
            rows.take(kept(self.rows()).len()).flat_map(|row| row[columns.clone()].iter().copied()).collect();
        Self { columns: columns.len(), heights_m, ..*self }
    }

    /// Exchanges x and y: the rows of the result run across those of this map.
    #[must_use]
    pub fn turned(&self) -> Self {
        Self {
            columns: self.rows(),
            spacing_x_m: self.spacing_y_m,
            spacing_y_m: self.spacing_x_m,
            heights_m: transposed(&self.heights_m, self.columns),
        }
    }
}

impl ParallelLines {
    /// Heights in m, line after line of so many `points` each, which are `spacing_m` > 0 apart.
    ///
    /// # Errors
    /// [`ScanError`] for fewer than two points, an incomplete line, an undefined height, or a bad spacing.
    pub fn new(points: usize, spacing_m: f64, heights_m: Vec<f64>) -> Result<Self, ScanError> {
        refuse_few("points of a line", points)?;
        if heights_m.is_empty() || !heights_m.len().is_multiple_of(points) {
            let what = format!("lines of {points} points");
            return Err(ScanError::LengthMismatch { heights: heights_m.len(), what });
        }
        refuse_bad_spacing("spacing", spacing_m)?;
        refuse_undefined(&heights_m, |index| {
            format!("line {}, point {}", index / points + 1, index % points + 1)
        })?;
        Ok(Self { spacing_m, points, heights_m, across: None })
    }

    /// Adds the lines that were cut out of the same map along y.
    #[must_use]
    pub fn with_across(self, across: Self) -> Self {
        Self { across: Some(Box::new(across)), ..self }
    }

    /// Distance of neighbouring points of a line in m.
    #[inline]
    pub fn spacing_m(&self) -> f64 {
        self.spacing_m
    }

    /// Number of points of each line.
    #[inline]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Number of lines.
    #[inline]
    pub fn lines(&self) -> usize {
        self.heights_m.len() / self.points
    }

    /// Heights in m, line after line.
    #[inline]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// Length of a line in m: that of its period, one spacing more than from the first to the last point.
    pub fn length_m(&self) -> f64 {
        self.spacing_m * self.points as f64
    }

    /// The lines across these, where there are any.
    pub fn across(&self) -> Option<&Self> {
        self.across.as_deref()
    }

    /// The lines across these as the only ones.
    pub fn into_across(self) -> Option<Self> {
        self.across.map(|across| *across)
    }
}

/// The columns of rows of so many values, one after the other.
pub(crate) fn transposed(values: &[f64], columns: usize) -> Vec<f64> {
    /// Values of a tile lie in the cache, whichever way they are gone through.
    const TILE: usize = 32;
    let rows = values.len() / columns;
    let mut turned = vec![0.0; values.len()];
    for first_row in (0..rows).step_by(TILE) {
        for first_column in (0..columns).step_by(TILE) {
            for row in first_row..rows.min(first_row + TILE) {
                for column in first_column..columns.min(first_column + TILE) {
                    turned[column * rows + row] = values[row * columns + column];
                }
            }
        }
    }
    turned
}

fn refuse_few(what: &'static str, found: usize) -> Result<(), ScanError> {
    if found < 2 { Err(ScanError::TooFew { what, found }) } else { Ok(()) }
}

/// Spacings of scans \[m\]: ratios and squares of them stay within double precision.
const SPACINGS_M: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Heights of scans \[m\]: their fourth powers, and squares of their slopes, stay within double precision.
const HEIGHTS_M: std::ops::RangeInclusive<f64> = -1e30..=1e30;

fn refuse_bad_spacing(what: &'static str, value: f64) -> Result<(), ScanError> {
    if SPACINGS_M.contains(&value) { Ok(()) } else { Err(ScanError::BadSpacing { what, value }) }
}

fn refuse_undefined(heights_m: &[f64], place: impl Fn(usize) -> String) -> Result<(), ScanError> {
    match heights_m.iter().position(|height_m| !HEIGHTS_M.contains(height_m)) {
        Some(index) if heights_m[index].is_finite() => {
            Err(ScanError::AbsurdHeight { place: place(index), height_m: heights_m[index] })
        }
        Some(index) => Err(ScanError::UndefinedHeight { place: place(index) }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_that_make_no_scan_are_refused() {
        let message = |error: ScanError| error.to_string();
        assert_eq!(
            message(UniformLineScan::new(1e-9, vec![1.0]).unwrap_err()),
            "building a scan: the number of points is 1, it must be at least 2"
        );
        assert_eq!(
            message(NonuniformLineScan::new(vec![0.0, 2.0, 1.0], vec![0.0; 3]).unwrap_err()),
            "building a scan: the position of point 3 is 1 m, that of the point before 2 m; positions must rise"
        );
        assert_eq!(
            message(HeightMap::new(2, 1.0, 1.0, vec![0.0, 0.0, 0.0, f64::NAN]).unwrap_err()),
            "building a scan: the height of row 2, column 2 is not a finite number; leave the point out"
        );
        assert!(HeightMap::new(2, 1.0, 1.0, vec![0.0; 5]).is_err());
        assert_eq!(
            message(ParallelLines::new(3, 1.0, vec![0.0; 4]).unwrap_err()),
            "building a scan: 4 heights do not fill lines of 3 points"
        );
        assert!(
            ParallelLines::new(3, 1.0, Vec::new()).is_err() && ParallelLines::new(1, 1.0, vec![0.0]).is_err()
        );
        assert!(UniformLineScan::new(0.0, vec![0.0; 2]).is_err());
    }

    #[test]
    fn heights_beyond_all_surfaces_are_refused() {
        let error = HeightMap::new(2, 1.0, 1.0, vec![0.0, 0.0, 1e31, 0.0]).unwrap_err();
        let place = "row 2, column 1".to_owned();
        assert_eq!(error, ScanError::AbsurdHeight { place, height_m: 1e31 });
        assert!(UniformLineScan::new(1.0, vec![-1e30, 1e30]).is_ok());
    }

    #[test]
    fn sizes_follow_from_points_and_spacings() {
        assert_eq!(UniformLineScan::new(0.5, vec![0.0; 4]).unwrap().length_m(), 2.0);
        let line = NonuniformLineScan::new(vec![1.0, 2.0, 4.0], vec![0.0; 3]).unwrap();
        assert_eq!((line.length_m(), line.mean_spacing_m()), (3.0, 1.5));
        let map = HeightMap::new(3, 1.0, 2.0, vec![0.0; 6]).unwrap();
        assert_eq!((map.columns(), map.rows()), (3, 2));
    }
}
