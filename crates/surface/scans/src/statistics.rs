//! Statistics of the heights of a scan.

use crate::measured::MeasuredScan;

/// Sums over the points of a scan that have a height; nothing is subtracted but the mean.
///
/// Roughness parameters, which begin with the removal of form, are `topography::HeightParameters`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// The mean height in m.
    pub mean_m: f64,
    /// Root mean square height in m about the mean.
    pub rms_height_m: f64,
    /// Height in m of the highest point above the lowest.
    pub peak_to_valley_m: f64,
    /// Root mean square slope along x, from neighbours that both have a height; none without such neighbours.
    pub rms_slope_x: Option<f64>,
    /// Root mean square slope of a map along y, from neighbours that both have a height.
    pub rms_slope_y: Option<f64>,
}

impl Statistics {
    /// Computes the statistics of a scan; none where no point has a height.
    #[must_use]
    pub fn from_scan(scan: &MeasuredScan) -> Option<Self> {
        let heights = || scan.heights_m().flatten();
        let count = heights().count();
        if count == 0 {
            return None;
        }
        // About the first height: sums of heights far from zero would lose their digits.
        let first_m = heights().next()?;
        let mean_m = first_m + heights().map(|height_m| height_m - first_m).sum::<f64>() / count as f64;
        let variance_m2 = heights().map(|height_m| (height_m - mean_m).powi(2)).sum::<f64>() / count as f64;
        let (lowest_m, highest_m) = heights()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height_m| {
                (height_m.min(low), height_m.max(high))
            });
        let (columns, rows) = scan.points();
        let rows = rows.unwrap_or(1);
        let (spacing_x_m, spacing_y_m) = scan.spacing_m();
        let along = |run_m: &dyn Fn(usize) -> f64, step: usize, is_last: &dyn Fn(usize) -> bool| {
            let mut squares = (0.0, 0usize);
            for index in (0..columns * rows).filter(|&index| !is_last(index)) {
                if let (Some(here_m), Some(next_m)) = (scan.height_m(index), scan.height_m(index + step)) {
                    squares.0 += ((next_m - here_m) / run_m(index)).powi(2);
                    squares.1 += 1;
                }
            }
            (squares.1 > 0).then(|| (squares.0 / squares.1 as f64).sqrt())
        };
        let run_x_m = |index: usize| match scan.positions_m() {
            Some(positions_m) => positions_m[index + 1] - positions_m[index],
            None => spacing_x_m,
        };
        let rms_slope_y = spacing_y_m
            .and_then(|spacing_y_m| along(&|_| spacing_y_m, columns, &|index| index / columns + 1 == rows));
        Some(Self {
            mean_m,
            rms_height_m: variance_m2.sqrt(),
            peak_to_valley_m: highest_m - lowest_m,
            rms_slope_x: along(&run_x_m, 1, &|index| index % columns + 1 == columns),
            rms_slope_y,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heights::{HeightMap, NonuniformLineScan, Scan};

    #[test]
    fn missing_points_take_no_part() {
        let map = HeightMap::new(3, 1.0, 2.0, vec![0.0, 2.0, 99.0, 4.0, 6.0, 8.0]).unwrap();
        let found = Statistics::from_scan(&MeasuredScan::with_missing_points(
            Scan::Map(map),
            [2].into_iter().collect(),
        ))
        .unwrap();
        assert_eq!((found.mean_m, found.peak_to_valley_m), (4.0, 8.0));
        assert!((found.rms_height_m - 8f64.sqrt()).abs() < 1e-15);
        assert_eq!((found.rms_slope_x, found.rms_slope_y), (Some(2.0), Some(2.0)));
    }

    #[test]
    fn slopes_of_uneven_lines_know_their_distances() {
        let line = NonuniformLineScan::new(vec![0.0, 1.0, 3.0], vec![0.0, 1.0, 7.0]).unwrap();
        let found = Statistics::from_scan(&Scan::NonuniformLine(line).into()).unwrap();
        assert_eq!((found.rms_slope_x, found.rms_slope_y), (Some(5f64.sqrt()), None));
    }
}
