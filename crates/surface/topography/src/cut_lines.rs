//! Lines without missing points, cut out of scans.

use scans::{MeasuredScan, ParallelLines, ScanAxis};

use crate::error::TransformError;

/// Smallest number of points of a stretch: wavelengths from L/2 to L/8 are left between the flagged first bin and twice
/// the distance of two points.
pub(crate) const LEAST_POINTS: usize = 16;
/// Share of the measured points in whole lines from which only these are used; they keep the long wavelengths.
const ENOUGH: f64 = 0.5;

/// Lines cut out of a scan.
pub(crate) struct Cut {
    pub(crate) lines: ParallelLines,
    /// True if all lines are as long as the scan, along either axis.
    pub(crate) is_whole: bool,
}

/// Cuts out the lines along x without missing points and, for a map, also those along y if there are any.
pub(crate) fn cut(scan: &MeasuredScan) -> Result<Cut, TransformError> {
    let ((columns, rows), (spacing_x_m, spacing_y_m)) = (scan.points(), scan.spacing_m());
    let of_rows = Lines { scan, axis: ScanAxis::X, count: rows.unwrap_or(1), points: columns, columns };
    let along_x = of_rows.cut(spacing_x_m)?;
    let (Some(rows), Some(spacing_y_m)) = (rows, spacing_y_m) else { return Ok(along_x) };
    let of_columns = Lines { scan, axis: ScanAxis::Y, count: columns, points: rows, columns };
    Ok(match of_columns.cut(spacing_y_m) {
        Ok(along_y) => Cut {
            lines: along_x.lines.with_across(along_y.lines),
            is_whole: along_x.is_whole && along_y.is_whole,
        },
        Err(_) => along_x, // a later request for lines along y is refused
    })
}

/// The lines of a scan along an axis.
struct Lines<'a> {
    scan: &'a MeasuredScan,
    axis: ScanAxis,
    count: usize,
    points: usize,
    columns: usize,
}

/// Neighbouring points of a line that all have a height.
#[derive(Clone, Copy)]
struct Stretch {
    line: usize,
    first: usize,
    points: usize,
}

impl Lines<'_> {
    fn cut(&self, spacing_m: f64) -> Result<Cut, TransformError> {
        let stretches = self.stretches();
        let measured: usize = stretches.iter().map(|stretch| stretch.points).sum();
        let whole = stretches.iter().filter(|stretch| stretch.points == self.points).count() * self.points;
        let is_whole = whole as f64 >= ENOUGH * measured as f64 && self.points >= LEAST_POINTS;
        let points = match is_whole {
            true => self.points,
            false => best_length(&stretches)
                .ok_or(TransformError::NoLines { axis: self.axis, least: LEAST_POINTS })?,
        };
        let mut heights_m = Vec::new();
        for stretch in stretches {
            for piece in 0..stretch.points / points {
                let first = stretch.first + piece * points;
                heights_m.extend((first..first + points).filter_map(|at| self.height_m(stretch.line, at)));
            }
        }
        Ok(Cut { lines: ParallelLines::new(points, spacing_m, heights_m)?, is_whole })
    }

    fn height_m(&self, line: usize, at: usize) -> Option<f64> {
        self.scan.height_m(match self.axis {
            ScanAxis::X => line * self.columns + at,
            ScanAxis::Y => at * self.columns + line,
        })
    }

    fn stretches(&self) -> Vec<Stretch> {
        let mut stretches: Vec<Stretch> = Vec::new();
        for line in 0..self.count {
            let mut points = 0;
            // One place beyond the end closes the last stretch.
            for at in 0..=self.points {
                if at < self.points && self.height_m(line, at).is_some() {
                    points += 1;
                } else if points > 0 {
                    stretches.push(Stretch { line, first: at - points, points });
                    points = 0;
                }
            }
        }
        stretches
    }
}

/// Finds the piece length in points that keeps most points; the longest of several.
fn best_length(stretches: &[Stretch]) -> Option<usize> {
    let mut lengths: Vec<usize> = stretches.iter().map(|stretch| stretch.points).collect();
    lengths.sort_unstable_by(|a, b| b.cmp(a));
    let kept = lengths.iter().enumerate().map(|(longer, &points)| (points, points * (longer + 1)));
    let best = kept.filter(|&(points, _)| points >= LEAST_POINTS);
    best.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(points, _)| points)
}
