//! The trend that is subtracted from evenly spaced heights.

use serde::{Deserialize, Serialize};

use crate::height_rows::{HeightRows, Slices};
use crate::sums::{Spread, dot, sum_of, sums_of};
use scans::{HeightMap, MeasuredScan, Scan, UniformLineScan};
use units::named;

/// Trend subtracted from the heights before they are transformed, fitted by least squares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Detrend {
    /// The mean of a line or of the whole map.
    Mean,
    /// A straight line; for a map one per row, which also removes drift between rows and, with it, wavelengths across
    /// them.
    Line,
    /// A plane through the whole map; a straight line for a line scan and for each line cut out of a map.
    #[default]
    Plane,
}

named!(Detrend, "detrending", { Mean => "mean", Line => "line", Plane => "plane" });

/// Subtracts the trend of a map and returns the heights \[m\] row by row.
#[must_use]
pub fn detrended_m(map: &HeightMap, detrend: Detrend) -> Vec<f64> {
    let trend = Trend::from_map(map, detrend);
    let (columns, factors) = (map.columns(), vec![1.0; map.columns()]);
    let mut rest_m = vec![0.0; map.heights_m().len()];
    let rows = map.heights_m().chunks_exact(columns).zip(rest_m.chunks_exact_mut(columns));
    rows.enumerate().for_each(|(row, (heights_m, rest_m))| {
        trend.subtract(row, heights_m, &factors, rest_m);
    });
    rest_m
}

/// Subtracts the least-squares plane of a map, or line of a profile, through the points that have a height \[m\].
///
/// Equals [`detrended_m`] where no point is missing; then the fit is not separable in x and y.
#[must_use]
pub fn without_form_m(scan: &MeasuredScan) -> Vec<Option<f64>> {
    Form::fit(scan).removed_m(scan).collect()
}

/// Subtracts the trend of a map through the points that have a height \[m\].
#[must_use]
pub fn without_trend_m(map: &MeasuredScan, detrend: Detrend) -> Vec<Option<f64>> {
    let heights_m: Vec<Option<f64>> = map.heights_m().collect();
    let less_mean = |heights_m: &[Option<f64>]| {
        let (sum_m, count) =
            heights_m.iter().flatten().fold((0.0, 0.0), |(sum, count), height| (sum + height, count + 1.0));
        heights_m.iter().map(|height_m| height_m.map(|height_m| height_m - sum_m / count)).collect::<Vec<_>>()
    };
    let less_line = |row: &[Option<f64>]| {
        let missing = (0..row.len()).filter(|&at| row[at].is_none()).collect();
        let known_m = row.iter().map(|height_m| height_m.unwrap_or(0.0)).collect();
        let line = UniformLineScan::new(1.0, known_m).expect("a row of a map is a line");
        without_form_m(&MeasuredScan::with_missing_points(Scan::UniformLine(line), missing))
    };
    match detrend {
        Detrend::Mean => less_mean(&heights_m),
        Detrend::Line => heights_m.chunks(map.points().0).flat_map(less_line).collect(),
        Detrend::Plane => without_form_m(map),
    }
}

/// The least-squares plane or line through the points of a scan that have a height.
#[derive(Debug, Clone, Copy, Default)]
pub struct Form {
    /// The height \[m\] in the middle of the scan.
    level_m: f64,
    /// The rise \[m\] from point to point along x and along y.
    slopes_m: [f64; 2],
}

impl Form {
    /// Fits the form of a scan; zero where no point has a height.
    #[must_use]
    pub fn fit(scan: &MeasuredScan) -> Self {
        // From the first height, then twice: the second fit removes what rounding left of a steep plane.
        let Some(pivot_m) = scan.heights_m().flatten().next() else { return Form::default() };
        let pivot = Form { level_m: pivot_m, slopes_m: [0.0; 2] };
        let first = pivot.plus(pivot.of_rest(scan));
        first.plus(first.of_rest(scan))
    }

    /// Iterates over the heights \[m\] from the form, row by row.
    pub fn removed_m(self, scan: &MeasuredScan) -> impl Iterator<Item = Option<f64>> + '_ {
        places(scan)
            .zip(scan.heights_m())
            .map(move |(at, height_m)| height_m.map(|height_m| height_m - self.height_m(at[0], at[1])))
    }

    fn height_m(self, x: f64, y: f64) -> f64 {
        self.level_m + self.slopes_m[0] * x + self.slopes_m[1] * y
    }

    fn plus(self, other: Form) -> Self {
        let slopes_m = [0, 1].map(|axis| self.slopes_m[axis] + other.slopes_m[axis]);
        Form { level_m: self.level_m + other.level_m, slopes_m }
    }

    /// Fits evenly spaced heights from this form: both slopes and the level are independent of one another.
    fn of_even_rest(self, heights_m: &[f64], columns: usize) -> Self {
        let (x, y) = (centred(columns), centred(heights_m.len() / columns));
        let sums_m = heights_m.chunks_exact(columns).zip(&y).map(|(heights_m, &y)| {
            sums_of(heights_m, &x, |height_m, x| {
                let rest_m = height_m - self.height_m(x, y);
                [rest_m, rest_m * x]
            })
        });
        let (sums_m, rises_m): (Vec<f64>, Vec<f64>) = sums_m.map(|[sum_m, rise_m]| (sum_m, rise_m)).unzip();
        let same = |value: f64| value;
        let slope_m = |rise_m: f64, squares: f64| if squares > 0.0 { rise_m / squares } else { 0.0 };
        let [x_squares, y_squares] = [&x, &y].map(|at| sum_of(at, |at| at * at));
        Form {
            level_m: sum_of(&sums_m, same) / heights_m.len() as f64,
            slopes_m: [
                slope_m(sum_of(&rises_m, same), y.len() as f64 * x_squares),
                slope_m(dot(&y, &sums_m), x.len() as f64 * y_squares),
            ],
        }
    }

    /// Fits the heights from this form.
    fn of_rest(self, scan: &MeasuredScan) -> Self {
        if let Some(heights_m) = evenly_spaced_m(scan) {
            return self.of_even_rest(heights_m, scan.points().0);
        }
        let (mut count, mut at_sum, mut products) = (0.0, [0.0; 2], [0.0; 3]);
        let (mut height_sum_m, mut rises_m) = (0.0, [0.0; 2]);
        for ([x, y], height_m) in places(scan).zip(self.removed_m(scan)) {
            let Some(height_m) = height_m else { continue };
            count += 1.0;
            at_sum = [at_sum[0] + x, at_sum[1] + y];
            products = [products[0] + x * x, products[1] + x * y, products[2] + y * y];
            height_sum_m += height_m;
            rises_m = [rises_m[0] + x * height_m, rises_m[1] + y * height_m];
        }
        let [x, y] = at_sum.map(|sum| sum / count);
        let mean_m = height_sum_m / count;
        let [xx, xy, yy] =
            [products[0] / count - x * x, products[1] / count - x * y, products[2] / count - y * y];
        let [xz, yz] = [rises_m[0] / count - x * mean_m, rises_m[1] / count - y * mean_m];
        let determinant = xx * yy - xy * xy;
        let slopes_m = match determinant > 1e-9 * xx * yy {
            true => [(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant],
            // All points lie on one line: the slope along its longer extent is all there is.
            false if xx >= yy => [if xx > 0.0 { xz / xx } else { 0.0 }, 0.0],
            false => [0.0, yz / yy],
        };
        Form { level_m: mean_m - slopes_m[0] * x - slopes_m[1] * y, slopes_m }
    }
}

/// All heights \[m\] of evenly spaced points; none if one is missing.
fn evenly_spaced_m(scan: &MeasuredScan) -> Option<&[f64]> {
    scan.complete_heights_m().filter(|heights_m| scan.positions_m().is_none() && !heights_m.is_empty())
}

/// Places in steps from the middle.
fn centred(points: usize) -> Vec<f64> {
    (0..points).map(|at| at as f64 - 0.5 * (points as f64 - 1.0)).collect()
}

/// Iterates over the places of all points in steps from the middle of the scan, row by row.
fn places(scan: &MeasuredScan) -> impl Iterator<Item = [f64; 2]> + '_ {
    let (columns, rows) = scan.points();
    let rows = rows.unwrap_or(1);
    let middle = |points: usize| 0.5 * (points as f64 - 1.0);
    let step_m = scan.spacing_m().0;
    let x = move |column: usize| match scan.positions_m() {
        Some(positions_m) => (positions_m[column] - positions_m[0]) / step_m - middle(columns),
        None => column as f64 - middle(columns),
    };
    (0..rows).flat_map(move |row| (0..columns).map(move |column| [x(column), row as f64 - middle(rows)]))
}

/// The trend of the rows of a map, or of a line.
pub(crate) struct Trend {
    /// Table of 0, 1, 2, ... along a row: conversions for each height would cost more than the arithmetic.
    index: Vec<f64>,
    /// The plane of all rows; with `None` each row has its own straight line, fitted when it is read.
    common: Option<Plane>,
}

/// A plane in two parts, so that an offset or slope a million times the roughness costs no digits.
///
/// The coarse slopes have so few bits that their products with an index are exact. The remainder has the size of the
/// roughness; the fine part is the least-squares plane through it, about its centre.
#[derive(Clone, Copy)]
struct Plane {
    pivot_m: f64,
    coarse: [f64; 2],
    level_m: f64,
    fine: [f64; 2],
    centre: [f64; 2],
}

impl Trend {
    pub(crate) fn from_map(map: &HeightMap, detrend: Detrend) -> Self {
        Self::from_rows(&Slices { heights_m: map.heights_m(), points: map.columns() }, detrend)
    }

    /// Fits the trend of lines that form a surface.
    pub(crate) fn from_rows(rows: &impl HeightRows, detrend: Detrend) -> Self {
        let sloped = match detrend {
            Detrend::Mean => Some([false, false]),
            Detrend::Line => None,
            Detrend::Plane => Some([true, true]),
        };
        Self::new(rows, sloped)
    }

    pub(crate) fn from_line(heights_m: &[f64], detrend: Detrend) -> Self {
        Self::new(&Slices::one(heights_m), Some([detrend != Detrend::Mean, false]))
    }

    fn new(rows: &impl HeightRows, sloped: Option<[bool; 2]>) -> Self {
        let index: Vec<f64> = (0..rows.points()).map(|column| column as f64).collect();
        let common = sloped.map(|sloped| Plane::fit(rows, &index, sloped));
        Self { index, common }
    }

    /// Subtracts the trend from a row, multiplies by `factors` and writes the result to `rest_m`; all have the length
    /// of a row.
    pub(crate) fn subtract(
        &self,
        row: usize,
        heights_m: &[f64],
        factors: &[f64],
        rest_m: &mut [f64],
    ) -> Spread {
        let (plane, row) = match self.common {
            Some(plane) => (plane, row),
            None => (Plane::fit(&Slices::one(heights_m), &self.index, [true, false]), 0),
        };
        let row_m = row as f64 * plane.coarse[1];
        let level_m = plane.level_m + plane.fine[1] * (row as f64 - plane.centre[1]);
        Spread::mapped([heights_m, &self.index, factors], rest_m, |[height_m, column, factor]| {
            let coarse_m = ((height_m - plane.pivot_m) - row_m) - column * plane.coarse[0];
            (coarse_m - (level_m + plane.fine[0] * (column - plane.centre[0]))) * factor
        })
    }
}

impl Plane {
    /// Fits the least-squares plane to rows as long as `index`; `sloped` allows slopes along x and y.
    fn fit(heights: &impl HeightRows, index: &[f64], sloped: [bool; 2]) -> Self {
        let (columns, rows) = (heights.points(), heights.count());
        let pivot_m = heights.height_m(0, 0);
        let corner_slope = |sloped: bool, row: usize, column: usize| {
            let steps = row + column;
            let rise_m = heights.height_m(row, column) - pivot_m;
            if sloped && steps > 0 { rise_m / steps as f64 } else { 0.0 }
        };
        let slopes = [corner_slope(sloped[0], 0, columns - 1), corner_slope(sloped[1], rows - 1, 0)];
        let coarse = Self {
            pivot_m,
            coarse: with_exact_products(slopes, [columns, rows]),
            level_m: 0.0,
            fine: [0.0; 2],
            centre: [columns, rows].map(|points| (points - 1) as f64 / 2.0),
        };
        coarse.refined(heights, index, sloped)
    }

    fn refined(mut self, heights: &impl HeightRows, index: &[f64], sloped: [bool; 2]) -> Self {
        let (columns, rows) = (heights.points(), heights.count());
        let x: Vec<f64> = index.iter().map(|column| column - self.centre[0]).collect();
        let (mut row_sums_m, mut row_tilts_m) = (vec![0.0; rows], vec![0.0; rows]);
        heights.for_each_row(|row, heights_m| {
            let row_m = row as f64 * self.coarse[1];
            let rest_m = |height_m, column| ((height_m - self.pivot_m) - row_m) - column * self.coarse[0];
            [row_sums_m[row], row_tilts_m[row]] = sums_of(heights_m, index, |height_m, column| {
                let rest_m = rest_m(height_m, column);
                [rest_m, rest_m * (column - self.centre[0])]
            });
        });
        let same = |value: f64| value;
        self.level_m = sum_of(&row_sums_m, same) / (rows * columns) as f64;
        if sloped[0] {
            self.fine[0] = sum_of(&row_tilts_m, same) / (rows as f64 * sum_of(&x, |x| x * x));
        }
        if sloped[1] {
            let y: Vec<f64> = (0..rows).map(|row| row as f64 - self.centre[1]).collect();
            self.fine[1] = dot(&y, &row_sums_m) / (columns as f64 * sum_of(&y, |y| y * y));
        }
        self
    }
}

/// Rounds slopes so that products with indices below `points`, and their sums, are exact.
fn with_exact_products(slopes: [f64; 2], points: [usize; 2]) -> [f64; 2] {
    let largest = slopes[0].abs() * points[0] as f64 + slopes[1].abs() * points[1] as f64;
    let unit = 2f64.powi(largest.log2().ceil().max(-900.0) as i32 - 52);
    slopes.map(|slope| (slope / unit).round() * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Heights on a coarse binary grid, so that adding a large plane to them is exact.
    fn dyadic(points: usize) -> Vec<f64> {
        (0..points).map(|i| ((i * i * 37 + i * 11) % 1009) as f64 / 1024.0 - 0.5).collect()
    }

    fn rest(heights: &[f64], columns: usize, detrend: Detrend) -> Vec<f64> {
        detrended_m(&HeightMap::new(columns, 1.0, 1.0, heights.to_vec()).unwrap(), detrend)
    }

    #[test]
    fn an_offset_and_slopes_a_million_times_the_roughness_cost_no_digits() {
        let (columns, rows) = (64, 48);
        let rough = dyadic(columns * rows);
        for (detrend, slope) in [(Detrend::Mean, 0.0), (Detrend::Line, 12345.0), (Detrend::Plane, 12345.0)] {
            let plane = |i: usize| 1e6 + slope * (i % columns) as f64 - slope * 0.75 * (i / columns) as f64;
            let tilted: Vec<f64> = rough.iter().enumerate().map(|(i, h)| h + plane(i)).collect();
            let expected = rest(&rough, columns, detrend);
            for (expected, found) in expected.iter().zip(rest(&tilted, columns, detrend)) {
                assert!((expected - found).abs() < 1e-14, "{detrend}: {expected} against {found}");
            }
        }
    }

    #[test]
    fn detrended_heights_have_neither_mean_nor_slope() {
        let (columns, rows) = (31, 20);
        let rest = rest(&dyadic(columns * rows), columns, Detrend::Plane);
        let moment = |weight: &dyn Fn(usize) -> f64| -> f64 {
            rest.iter().enumerate().map(|(i, h)| weight(i) * h).sum::<f64>() / rest.len() as f64
        };
        assert!(moment(&|_| 1.0).abs() < 1e-15);
        assert!(moment(&|i| (i % columns) as f64 - 15.0).abs() < 1e-14);
        assert!(moment(&|i| (i / columns) as f64 - 9.5).abs() < 1e-14);
    }

    #[test]
    fn form_of_complete_maps_is_their_plane() {
        let (columns, rows) = (31, 20);
        let tilted = |(i, h): (usize, &f64)| h + 3.0 * (i % columns) as f64 - 0.7 * (i / columns) as f64;
        let heights: Vec<f64> = dyadic(columns * rows).iter().enumerate().map(tilted).collect();
        let map = HeightMap::new(columns, 1.0, 1.0, heights).unwrap();
        let expected = detrended_m(&map, Detrend::Plane);
        let found = without_form_m(&scans::Scan::Map(map).into());
        for (expected, found) in expected.iter().zip(found) {
            assert!((expected - found.unwrap()).abs() < 1e-13);
        }
    }

    #[test]
    fn a_flat_line_leaves_zeros() {
        for heights in [[3.0; 5], [0.0; 5]] {
            let mut rest = [1.0; 5];
            Trend::from_line(&heights, Detrend::Line).subtract(0, &heights, &[1.0; 5], &mut rest);
            assert_eq!(rest, [0.0; 5]);
        }
    }
}
