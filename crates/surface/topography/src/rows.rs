//! The lines of a scan, independent of how they were measured.

use crate::detrend::{Detrend, Trend};
use crate::height_rows::Slices;
use scans::{HeightMap, NonuniformLineScan, ParallelLines, Scan, UniformLineScan};

/// Rows per block: few enough to spread over threads, enough to outweigh handing a block over.
pub(crate) const BLOCK_ROWS: usize = 64;

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
            (TrendOf::LinesApart, Detrend::Plane) => Trend::from_rows(&self.slices(), Detrend::Line),
            (TrendOf::Map | TrendOf::LinesApart, _) => Trend::from_rows(&self.slices(), detrend),
        }
    }

    pub(crate) fn slices(&self) -> Slices<'a> {
        Slices { heights_m: self.heights_m, points: self.points }
    }

    pub(crate) fn count(&self) -> usize {
        self.heights_m.len() / self.points
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
