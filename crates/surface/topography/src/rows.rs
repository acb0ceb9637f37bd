//! The lines of a scan, independent of how they were measured.

use crate::detrend::{Detrend, Trend};
use scans::{HeightMap, NonuniformLineScan, ParallelLines, Scan, UniformLineScan};

/// Rows per block: few enough to spread over threads, enough to outweigh handing a block over.
pub(crate) const BLOCK_ROWS: usize = 64;

/// Lines of equal length, wherever their heights lie.
pub(crate) trait HeightRows {
    /// Number of points of a line.
    fn points(&self) -> usize;
    /// Number of lines.
    fn count(&self) -> usize;
    /// Height of a point of a line \[m\].
    fn height_m(&self, row: usize, point: usize) -> f64;
    /// Hands over all lines with their numbers, in their order.
    fn for_each_row(&self, each: impl FnMut(usize, &[f64]));
}

/// A line of its own.
impl HeightRows for &[f64] {
    fn points(&self) -> usize {
        self.len()
    }

    fn count(&self) -> usize {
        1
    }

    fn height_m(&self, _row: usize, point: usize) -> f64 {
        self[point]
    }

    fn for_each_row(&self, mut each: impl FnMut(usize, &[f64])) {
        each(0, self);
    }
}

impl HeightRows for Rows<'_> {
    fn points(&self) -> usize {
        self.points
    }

    fn count(&self) -> usize {
        self.heights_m.len() / self.points
    }

    fn height_m(&self, row: usize, point: usize) -> f64 {
        self.heights_m[row * self.points + point]
    }

    fn for_each_row(&self, mut each: impl FnMut(usize, &[f64])) {
        self.iter().enumerate().for_each(|(row, heights_m)| each(row, heights_m));
    }
}

/// The columns of a map as lines, a few of them copied at a time.
pub(crate) struct Columns<'a>(pub(crate) &'a HeightMap);

impl Columns<'_> {
    /// Columns copied together: a cache line of every row.
    const BLOCK: usize = 8;
}

impl HeightRows for Columns<'_> {
    fn points(&self) -> usize {
        self.0.rows()
    }

    fn count(&self) -> usize {
        self.0.columns()
    }

    fn height_m(&self, row: usize, point: usize) -> f64 {
        self.0.heights_m()[point * self.0.columns() + row]
    }

    fn for_each_row(&self, mut each: impl FnMut(usize, &[f64])) {
        let (points, columns) = (self.points(), self.count());
        let mut block_m = vec![0.0; points * Self::BLOCK.min(columns)];
        for first in (0..columns).step_by(Self::BLOCK) {
            let block = first..columns.min(first + Self::BLOCK);
            for (point, row_m) in self.0.heights_m().chunks_exact(columns).enumerate() {
                for (at, height_m) in row_m[block.clone()].iter().enumerate() {
                    block_m[at * points + point] = *height_m;
                }
            }
            for (row, line_m) in block.zip(block_m.chunks_exact(points)) {
                each(row, line_m);
            }
        }
    }
}

/// Lines of equal length with evenly spaced points.
#[derive(Clone, Copy)]
pub(crate) struct Rows<'a> {
    pub(crate) heights_m: &'a [f64],
    pub(crate) points: usize,
    pub(crate) spacing_m: f64,
    /// Lines that share a trend.
    trend_of: TrendOf,
}

#[derive(Clone, Copy)]
enum TrendOf {
    Line,
    Map,
    LinesApart,
}

/// The lines of a scan, evenly spaced or not.
pub(crate) enum Lines<'a> {
    Even(Rows<'a>),
    Uneven(&'a NonuniformLineScan),
}

impl<'a> Lines<'a> {
    pub(crate) fn from_scan(scan: &'a Scan) -> Self {
        match scan {
            Scan::UniformLine(line) => Self::Even(Rows::from_line(line)),
            Scan::Map(map) => Self::Even(Rows::from_map(map)),
            Scan::Lines(lines) => Self::Even(Rows::from_lines(lines)),
            Scan::NonuniformLine(line) => Self::Uneven(line),
        }
    }
}

impl<'a> Rows<'a> {
    pub(crate) fn from_lines(lines: &'a ParallelLines) -> Self {
        let (points, spacing_m) = (lines.points(), lines.spacing_m());
        Self { heights_m: lines.heights_m(), points, spacing_m, trend_of: TrendOf::LinesApart }
    }

    pub(crate) fn from_line(line: &'a UniformLineScan) -> Self {
        let heights_m = line.heights_m();
        let (points, spacing_m) = (heights_m.len(), line.spacing_m());
        Self { heights_m, points, spacing_m, trend_of: TrendOf::Line }
    }

    pub(crate) fn from_map(map: &'a HeightMap) -> Self {
        let (points, spacing_m) = (map.columns(), map.spacing_x_m());
        Self { heights_m: map.heights_m(), points, spacing_m, trend_of: TrendOf::Map }
    }

    /// Fits the trend of the lines. A plane needs the distance of the lines; without it each line has its own straight
    /// line.
    pub(crate) fn trend(&self, detrend: Detrend) -> Trend {
        match (self.trend_of, detrend) {
            (TrendOf::Line, _) => Trend::from_line(self.heights_m, detrend),
            (TrendOf::LinesApart, Detrend::Plane) => Trend::from_rows(self, Detrend::Line),
            (TrendOf::Map | TrendOf::LinesApart, _) => Trend::from_rows(self, detrend),
        }
    }

    pub(crate) fn length_m(&self) -> f64 {
        self.spacing_m * self.points as f64
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = &'a [f64]> + use<'a> {
        self.heights_m.chunks_exact(self.points)
    }

    /// Yields the lines of a block with their numbers.
    pub(crate) fn block(&self, block: usize) -> impl Iterator<Item = (usize, &'a [f64])> + use<'a> {
        self.iter().enumerate().skip(block * BLOCK_ROWS).take(BLOCK_ROWS)
    }
}
