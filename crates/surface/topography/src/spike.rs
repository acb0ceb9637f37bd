//! Points far off all others of a scan.

use scans::{MeasuredScan, Scan};
use units::{Remark, RemarkCode};

/// Least distance of a spike from the median height, over the median distance.
const FAR: f64 = 1e3;
/// Largest share of points that are spikes, not steps.
const FEW: f64 = 1e-3;
/// Largest share of points of one height that are marks of missing points.
const MARKS: f64 = 0.5;
/// Number of points that tell the median.
const SAMPLED: usize = 1 << 16;

/// A point far off all others.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Spike {
    /// Row of a map, from 1.
    pub row: Option<usize>,
    /// Point of the line or the row, from 1; unknown where points were cut out.
    pub point: Option<usize>,
    /// Its height \[m\].
    pub height_m: f64,
    /// Its distance from the median height over the median distance.
    pub times: f64,
}

impl Spike {
    /// Finds the point farthest off the median, if it is far and as good as alone there, or all that are far have one
    /// height, as numbers in the place of missing points have.
    pub(crate) fn find(scan: &Scan) -> Option<Self> {
        let (heights_m, columns) = match scan {
            Scan::UniformLine(line) => (line.heights_m(), None),
            Scan::NonuniformLine(line) => (line.heights_m(), None),
            Scan::Map(map) => (map.heights_m(), Some(map.columns())),
            Scan::Lines(lines) => (lines.heights_m(), None),
        };
        let is_whole = !matches!(scan, Scan::Lines(_));
        Self::among(heights_m, |at| {
            (
                columns.map(|columns| at / columns + 1),
                is_whole.then_some(columns.map_or(at, |columns| at % columns) + 1),
            )
        })
    }

    /// Finds such a point among those that have a height.
    #[must_use]
    pub fn in_measured(scan: &MeasuredScan) -> Option<Self> {
        let (columns, rows) = scan.points();
        let named = |place: usize| match rows {
            Some(_) => (Some(place / columns + 1), Some(place % columns + 1)),
            None => (None, Some(place + 1)),
        };
        if let Some(heights_m) = scan.complete_heights_m() {
            return Self::among(heights_m, named);
        }
        let known = || scan.heights_m().enumerate().filter_map(|(place, height_m)| Some((place, height_m?)));
        let heights_m: Vec<f64> = known().map(|(_, height_m)| height_m).collect();
        Self::among(&heights_m, |at| named(known().nth(at).map_or(at, |(place, _)| place)))
    }

    /// Finds such a point; `place_of` gives its row and its place there.
    fn among(heights_m: &[f64], place_of: impl Fn(usize) -> (Option<usize>, Option<usize>)) -> Option<Self> {
        if heights_m.is_empty() {
            return None;
        }
        let sampled = heights_m.iter().step_by(heights_m.len().div_ceil(SAMPLED));
        let middle_m = median(sampled.clone().copied().collect());
        let usual_m = median(sampled.map(|height_m| (height_m - middle_m).abs()).collect());
        let is_far = |height_m: &f64| (height_m - middle_m).abs() > FAR * usual_m;
        let mut far = heights_m.iter().filter(|height_m| is_far(height_m)).peekable();
        let first_m = *far.peek()?;
        let (count, of_first) =
            far.fold((0, 0), |(all, alike), height_m| (all + 1, alike + usize::from(height_m == first_m)));
        let most = if of_first == count { MARKS } else { FEW };
        if usual_m <= 0.0 || count as f64 > (most * heights_m.len() as f64).max(1.0) {
            return None;
        }
        let distance_m = |at: usize| (heights_m[at] - middle_m).abs();
        let at = (0..heights_m.len()).rev().max_by(|a, b| distance_m(*a).total_cmp(&distance_m(*b)))?;
        let (row, point) = place_of(at);
        Some(Self { row, point, height_m: heights_m[at], times: distance_m(at) / usual_m })
    }

    /// The remark on it.
    pub(crate) fn remark(self) -> Remark {
        let remark = Remark::new(RemarkCode::Spike).with("height_m", self.height_m).with("times", self.times);
        let remark = self.point.into_iter().fold(remark, |remark, point| remark.with("point", point));
        self.row.into_iter().fold(remark, |remark, row| remark.with("row", row))
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use scans::{HeightMap, UniformLineScan};

    fn wave(points: usize) -> Vec<f64> {
        (0..points).map(|at| 1e-7 * (at as f64 * 0.7).sin()).collect()
    }

    #[test]
    fn a_point_far_off_is_found_and_steps_and_tilts_are_none() {
        let line = |heights_m| Scan::UniformLine(UniformLineScan::new(1e-6, heights_m).unwrap());
        let mut spiked = wave(1000);
        spiked[500] = 1.0;
        let spike = Spike::find(&line(spiked.clone())).unwrap();
        assert_eq!((spike.row, spike.point, spike.height_m), (None, Some(501), 1.0));
        assert!((1e7..2e7).contains(&spike.times), "{}", spike.times);
        let map = Scan::Map(HeightMap::new(100, 1e-6, 1e-6, spiked).unwrap());
        assert_eq!(Spike::find(&map).map(|spike| (spike.row, spike.point)), Some((Some(6), Some(1))));
        let gappy = MeasuredScan::with_missing_points(map, (0..200).collect());
        let spike = Spike::in_measured(&gappy).unwrap();
        assert_eq!((spike.row, spike.point, spike.height_m), (Some(6), Some(1), 1.0));
        // A third of all points, but of one height.
        let marked = wave(1000).into_iter().enumerate().map(|(at, m)| if at % 3 == 1 { -9999e-6 } else { m });
        assert_eq!(Spike::find(&line(marked.collect())).map(|spike| spike.point), Some(Some(2)));
        let step = wave(1000).into_iter().enumerate().map(|(at, height_m)| height_m + f64::from(at < 500));
        let tilted = wave(1000).into_iter().enumerate().map(|(at, height_m)| height_m + at as f64);
        for heights_m in [wave(1000), step.collect(), tilted.collect(), vec![0.0; 9]] {
            assert_eq!(Spike::find(&line(heights_m)), None);
        }
    }
}
