//! Material ratio: Smr, the Sk family and volumes of ISO 25178-2, and their counterparts for profiles.

use crate::relief::ScaleLimitedSurface;

/// Share of the heights in the window that the core line is fitted to.
const WINDOW: f64 = 0.4;

/// Relative difference of falls below which two windows are equally flat, for a reader and for rounding.
const TIE: f64 = 1e-3;
const ROUNDING: f64 = 1e-13;

/// Height over the share of heights at or above it, linear between the sorted heights: the k-th highest of N stands at
/// k/(N - 1).
#[derive(Clone, Debug)]
pub struct MaterialRatioCurve {
    /// Heights \[m\] from the highest to the lowest.
    heights_m: Vec<f64>,
}

/// The core of a surface, and what rises above and reaches below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Core {
    /// Sk: depth of the core \[m\].
    pub depth_m: f64,
    /// Spk: height of the peaks \[m\].
    pub peaks_m: f64,
    /// Svk: depth of the valleys \[m\].
    pub valleys_m: f64,
    /// Smr1: share of heights above the core.
    pub peak_share: f64,
    /// Smr2: share of heights above the valleys.
    pub valley_share: f64,
    /// True if a window apart from the one that was taken, the first, is as flat: a wave of sines has one at its peaks and one in its
    /// valleys.
    pub has_twin: bool,
}

/// The flattest window of the curve, between two ratios.
struct Flattest {
    from: f64,
    to: f64,
    has_twin: bool,
}

impl MaterialRatioCurve {
    /// Sorts the heights.
    #[must_use]
    pub fn new(relief: &ScaleLimitedSurface) -> Self {
        let mut heights_m: Vec<f64> = relief.heights_m().flatten().collect();
        heights_m.sort_unstable_by(|a, b| b.total_cmp(a));
        MaterialRatioCurve { heights_m }
    }

    /// Returns the share of the points at or above a height \[m\] from the mean: Smr(c), Rmr(c).
    #[must_use]
    pub fn share_at_or_above(&self, height_m: f64) -> f64 {
        self.heights_m.partition_point(|other_m| *other_m >= height_m) as f64 / self.heights_m.len() as f64
    }

    /// Computes the height \[m\] at a material ratio from 0 to 1.
    #[must_use]
    pub fn height_m(&self, ratio: f64) -> f64 {
        let place = ratio * self.last();
        let below = (place as usize).min(self.heights_m.len() - 1);
        let above = (below + 1).min(self.heights_m.len() - 1);
        self.heights_m[below] + (place - below as f64) * (self.heights_m[above] - self.heights_m[below])
    }

    /// Computes Vm(p), the material above the height at a ratio, as volume over area \[m\].
    #[must_use]
    pub fn material_m(&self, ratio: f64) -> f64 {
        self.integral_m(0.0, ratio) - ratio * self.height_m(ratio)
    }

    /// Computes Vv(p), the void below the height at a ratio, as volume over area \[m\].
    #[must_use]
    pub fn void_m(&self, ratio: f64) -> f64 {
        (1.0 - ratio) * self.height_m(ratio) - self.integral_m(ratio, 1.0)
    }

    /// Fits the core: the flattest 40 % of the curve, the first on ties, and the least-squares line in it.
    #[must_use]
    pub fn core(&self) -> Core {
        let Flattest { from, to, has_twin } = self.flattest();
        let (level_m, slope_m) = self.line(from, to);
        let middle = 0.5 * (from + to);
        let (upper_m, lower_m) = (level_m - slope_m * middle, level_m + slope_m * (1.0 - middle));
        let peak_share = self.ratio_at(upper_m);
        let valley_share = self.last_ratio_at(lower_m);
        let mean_depth_m = |area_m: f64, share: f64| if share > 0.0 { 2.0 * area_m / share } else { 0.0 };
        let peaks_m = self.integral_m(0.0, peak_share) - peak_share * upper_m;
        let valleys_m = (1.0 - valley_share) * lower_m - self.integral_m(valley_share, 1.0);
        Core {
            depth_m: upper_m - lower_m,
            peaks_m: mean_depth_m(peaks_m, peak_share),
            valleys_m: mean_depth_m(valleys_m, 1.0 - valley_share),
            peak_share,
            valley_share,
            has_twin,
        }
    }

    /// Finds the first window with the smallest fall. The fall is linear between the places where an end meets a point.
    fn flattest(&self) -> Flattest {
        let last = self.last();
        let starts = (0..self.heights_m.len()).map(|point| point as f64 / last);
        let ends = (0..self.heights_m.len()).map(|point| point as f64 / last - WINDOW);
        let fall_m = |from: f64| self.height_m(from) - self.height_m(from + WINDOW);
        let froms = starts.chain(ends).filter(|from| (0.0..=1.0 - WINDOW).contains(from));
        let falls: Vec<(f64, f64)> = froms.map(|from| (from, fall_m(from))).collect();
        let least_m = falls.iter().map(|(_, fall_m)| *fall_m).fold(f64::INFINITY, f64::min);
        let flat = |tie: f64| {
            let is_flat = move |fall_m: f64| fall_m <= least_m * (1.0 + tie);
            falls.iter().filter(move |(_, fall_m)| is_flat(*fall_m)).map(|(from, _)| *from)
        };
        let first = flat(ROUNDING).fold(f64::INFINITY, f64::min);
        let has_twin = flat(TIE).any(|from| (from - first).abs() >= WINDOW);
        Flattest { from: first, to: first + WINDOW, has_twin }
    }

    /// Fits the least-squares line to the curve between two ratios; its height \[m\] in the middle, and its slope \[m\].
    fn line(&self, from: f64, to: f64) -> (f64, f64) {
        let middle = 0.5 * (from + to);
        // From the height at one end: heights that are equal have no slope, not even of rounding.
        let origin_m = self.height_m(from);
        let (mut area_m, mut moment_m) = (0.0, 0.0);
        self.each_piece(from, to, |[left, right], [z_left_m, z_right_m]| {
            let (z_left_m, z_right_m) = (z_left_m - origin_m, z_right_m - origin_m);
            let width = right - left;
            let mean_m = 0.5 * (z_left_m + z_right_m);
            area_m += width * mean_m;
            moment_m +=
                width * (mean_m * (0.5 * (left + right) - middle) + (z_right_m - z_left_m) * width / 12.0);
        });
        let width = to - from;
        (origin_m + area_m / width, 12.0 * moment_m / width.powi(3))
    }

    /// Integrates the height \[m\] over the ratio.
    fn integral_m(&self, from: f64, to: f64) -> f64 {
        let mut sum_m = 0.0;
        self.each_piece(from, to, |[left, right], [z_left_m, z_right_m]| {
            sum_m += 0.5 * (right - left) * (z_left_m + z_right_m);
        });
        sum_m
    }

    /// Passes the straight pieces between two ratios, with the heights \[m\] at their ends.
    fn each_piece(&self, from: f64, to: f64, mut each: impl FnMut([f64; 2], [f64; 2])) {
        let last = self.last();
        let (mut left, mut left_m) = (from, self.height_m(from));
        let first_point = (from * last).floor() as usize + 1;
        for point in first_point..self.heights_m.len() {
            let right = point as f64 / last;
            if right >= to {
                break;
            }
            each([left, right], [left_m, self.heights_m[point]]);
            (left, left_m) = (right, self.heights_m[point]);
        }
        each([left, to], [left_m, self.height_m(to)]);
    }

    /// Computes the first ratio at which the curve is at or below a height \[m\]; 1 where it stays above.
    fn ratio_at(&self, height_m: f64) -> f64 {
        let point = self.heights_m.partition_point(|other_m| *other_m > height_m);
        if point == 0 {
            return 0.0;
        }
        let Some(below_m) = self.heights_m.get(point) else { return 1.0 };
        let above_m = self.heights_m[point - 1];
        (point as f64 - 1.0 + (above_m - height_m) / (above_m - below_m)) / self.last()
    }

    /// Computes the last ratio at which the curve is at or above a height \[m\]; 0 where it stays below.
    fn last_ratio_at(&self, height_m: f64) -> f64 {
        let point = self.heights_m.partition_point(|other_m| *other_m >= height_m);
        let (Some(before), Some(below_m)) = (point.checked_sub(1), self.heights_m.get(point)) else {
            return if point == 0 { 0.0 } else { 1.0 };
        };
        let above_m = self.heights_m[before];
        (before as f64 + (above_m - height_m) / (above_m - below_m)) / self.last()
    }

    /// Place of the lowest height.
    fn last(&self) -> f64 {
        (self.heights_m.len().max(2) - 1) as f64
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;
    use scans::{Scan, UniformLineScan};
    use statrs::distribution::{ContinuousCDF, Normal};

    use crate::relief::{Evaluation, FormRemoval};

    use super::*;

    fn curve(heights_m: Vec<f64>) -> MaterialRatioCurve {
        let scan = Scan::UniformLine(UniformLineScan::new(1e-6, heights_m).unwrap());
        let evaluation = Evaluation { form: FormRemoval::None, ..Evaluation::default() };
        MaterialRatioCurve::new(&ScaleLimitedSurface::new(&scan.into(), &evaluation).unwrap())
    }

    #[test]
    fn gaussian_heights_have_the_values_of_their_distribution() {
        let points = 200_000;
        let normal = Normal::standard();
        let heights =
            (0..points).map(|i| normal.inverse_cdf((f64::from(i) + 0.5) / f64::from(points))).collect();
        let curve = curve(heights);
        let Core { depth_m, peaks_m, valleys_m, peak_share, valley_share, has_twin } = curve.core();
        assert!(!has_twin);
        // Integrals of the normal distribution.
        for (found, expected) in [
            (depth_m, 2.573_956),
            (peaks_m, 0.945_031),
            (valleys_m, 0.945_031),
            (peak_share, 0.099_050_9),
            (valley_share, 0.900_949_1),
            (curve.material_m(0.1), 0.047_343_2),
            (curve.material_m(0.8) - curve.material_m(0.1), 0.905_915_7),
            (curve.void_m(0.1) - curve.void_m(0.8), 1.217_257_1),
            (curve.void_m(0.8), 0.111_637_7),
        ] {
            assert_relative_eq!(found, expected, max_relative = 3e-4);
        }
        assert_relative_eq!(curve.share_at_or_above(0.0), 0.5);
        assert_relative_eq!(
            curve.void_m(0.3),
            curve.material_m(0.3) + curve.height_m(0.3),
            max_relative = 1e-4
        );
    }

    #[test]
    fn a_ramp_is_all_core_and_a_flat_line_has_none() {
        let ramp = curve((0..101).map(|i| f64::from(i) * 1e-8).collect());
        let Core { depth_m, peaks_m, valleys_m, peak_share, valley_share, .. } = ramp.core();
        assert_relative_eq!(depth_m, 1e-6, max_relative = 1e-12);
        assert!(peaks_m.abs() < 1e-15 && valleys_m.abs() < 1e-15, "{peaks_m} {valleys_m}");
        assert!(peak_share < 1e-12 && valley_share > 1.0 - 1e-12);
        let flat = curve(vec![1e-9; 10]).core();
        assert_eq!((flat.depth_m, flat.peaks_m, flat.valleys_m), (0.0, 0.0, 0.0));
    }

    #[test]
    fn a_sine_has_a_core_at_its_peaks_and_as_flat_a_twin_in_its_valleys() {
        let points = 4000;
        let sine = (0..points).map(|i| (TAU * (f64::from(i) + 0.5) / f64::from(points)).sin());
        let Core { peaks_m, valleys_m, has_twin, .. } = curve(sine.collect()).core();
        assert!(has_twin);
        assert!(peaks_m < 1e-3, "{peaks_m}");
        assert_relative_eq!(valleys_m, 0.443_918, max_relative = 1e-3);
    }
}
