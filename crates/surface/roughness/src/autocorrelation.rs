//! Autocorrelation of maps: Sal and Str of ISO 25178-2.

use std::f64::consts::PI;

use numerics::transforms::{Complex, Precision};
use units::named;

use crate::relief::ScaleLimitedSurface;

/// Value of the autocorrelation at which heights count as unrelated.
const UNRELATED: f64 = 0.2;
/// Directions over half a turn.
const DIRECTIONS: usize = 180;
/// Steps along a direction for each distance of neighbouring points.
const STEPS_PER_POINT: f64 = 20.0;
/// Lags beyond those that are searched, which the cubic interpolation needs.
const MARGIN: usize = 2;

/// AutocorrelationNormalisation of the sum over pairs of points at a lag.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AutocorrelationNormalisation {
    /// By the number of pairs at that lag.
    Unbiased,
    /// By the number of all points, which shortens long lags.
    Biased,
}

named!(AutocorrelationNormalisation, "normalisation", {
    Unbiased => "unbiased autocorrelation", Biased => "biased autocorrelation"
});

/// Lags at which the autocorrelation first falls to 0.2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Shortest over all directions: Sal \[m\]; none where no direction falls so far.
    pub shortest_m: Option<f64>,
    /// Longest over all directions \[m\]; none where some direction does not fall so far.
    pub longest_m: Option<f64>,
    /// Shortest lag \[m\] at which a search ended without result; that of half the shorter side where none did.
    pub searched_m: f64,
}

/// Sums of products of heights, and numbers of pairs, at the lags of a map.
#[derive(Clone, Debug)]
pub struct Autocorrelation {
    /// Largest lags that are searched, in points: half of each side.
    largest: [usize; 2],
    spacing_m: [f64; 2],
    points: f64,
    /// Rows of lags along x from -(largest + margin), for lags along y from 0.
    products_m2: Vec<f64>,
    pairs: Vec<f64>,
}

impl Autocorrelation {
    /// Sums over all pairs of points that have a height. None for lines and for flat maps.
    #[must_use]
    pub fn of_map(relief: &ScaleLimitedSurface) -> Option<Self> {
        let (columns, rows) = relief.points();
        let (spacing_x_m, spacing_y_m) = relief.spacing_m();
        let (rows, spacing_y_m) = (rows?, spacing_y_m?);
        let (heights_m, measured) = relief.parts();
        let largest_m = heights_m.iter().fold(0.0f64, |largest, height_m| largest.max(height_m.abs()));
        if largest_m == 0.0 || columns < 4 || rows < 4 {
            return None;
        }
        let shape = Shape { columns, rows, lags: [columns / 2, rows / 2].map(|lag| lag + MARGIN) };
        let products_m2 = shape.sums_of_products(heights_m.iter().copied());
        let pairs = match measured {
            Some(measured) => {
                let counts = shape.sums_of_products(measured.iter().map(|has_height| f64::from(*has_height)));
                counts.into_iter().map(f64::round).collect()
            }
            None => shape.overlaps(),
        };
        let points = pairs[shape.lags[0]];
        Some(Autocorrelation {
            largest: [columns / 2, rows / 2],
            spacing_m: [spacing_x_m, spacing_y_m],
            points,
            products_m2,
            pairs,
        })
    }

    /// Searches every direction, degree by degree, for the first lag at which the autocorrelation falls to 0.2.
    #[must_use]
    pub fn reach(&self, normalisation: AutocorrelationNormalisation) -> Reach {
        let (mut shortest_m, mut longest_m) = (f64::INFINITY, 0.0f64);
        let mut searched_m = None::<f64>;
        for direction in 0..DIRECTIONS {
            match self.first_fall_m(PI * direction as f64 / DIRECTIONS as f64, normalisation) {
                Ok(lag_m) => (shortest_m, longest_m) = (shortest_m.min(lag_m), longest_m.max(lag_m)),
                Err(end_m) => searched_m = Some(searched_m.map_or(end_m, |other_m| other_m.min(end_m))),
            }
        }
        let half_m = [0, 1].map(|axis| self.largest[axis] as f64 * self.spacing_m[axis]);
        Reach {
            shortest_m: shortest_m.is_finite().then_some(shortest_m),
            longest_m: searched_m.is_none().then_some(longest_m),
            searched_m: searched_m.unwrap_or(half_m[0].min(half_m[1])),
        }
    }

    /// Walks in a direction; returns the lag \[m\] of the fall, or as an error the lag at which the search ends.
    fn first_fall_m(&self, direction: f64, normalisation: AutocorrelationNormalisation) -> Result<f64, f64> {
        let step_m = self.spacing_m[0].min(self.spacing_m[1]) / STEPS_PER_POINT;
        let (sin, cos) = direction.sin_cos();
        let per_step = [cos * step_m / self.spacing_m[0], sin * step_m / self.spacing_m[1]];
        let origin = self.value([0, 0], normalisation);
        let mut before = 1.0;
        for step in 1.. {
            let lag = per_step.map(|of_axis| of_axis * f64::from(step));
            if lag[0].abs() > self.largest[0] as f64 || lag[1] > self.largest[1] as f64 {
                return Err(step_m * f64::from(step - 1));
            }
            let value = self.interpolated(lag, normalisation) / origin;
            if value <= UNRELATED {
                return Ok(step_m * (f64::from(step) - (UNRELATED - value) / (before - value)));
            }
            before = value;
        }
        unreachable!("every direction leaves the map")
    }

    /// Interpolates by the cubic of the four points around a lag, along each axis.
    fn interpolated(&self, lag: [f64; 2], normalisation: AutocorrelationNormalisation) -> f64 {
        let base = lag.map(f64::floor);
        let [along_x, along_y] = [0, 1].map(|axis| cubic_weights(lag[axis] - base[axis]));
        let base = base.map(|lag| lag as isize);
        let mut sum = 0.0;
        for (dy, weight_y) in (-1..3).zip(along_y) {
            for (dx, weight_x) in (-1..3).zip(along_x) {
                sum += weight_x * weight_y * self.value([base[0] + dx, base[1] + dy], normalisation);
            }
        }
        sum
    }

    /// Returns the autocorrelation at a lag in points; opposite lags are equal.
    fn value(&self, [x, y]: [isize; 2], normalisation: AutocorrelationNormalisation) -> f64 {
        let [x, y] = if y < 0 { [-x, -y] } else { [x, y] };
        let reach = (self.largest[0] + MARGIN) as isize;
        let at = y as usize * (2 * reach as usize + 1) + (x + reach) as usize;
        let pairs = match normalisation {
            AutocorrelationNormalisation::Unbiased => self.pairs[at].max(1.0),
            AutocorrelationNormalisation::Biased => self.points,
        };
        self.products_m2[at] / pairs
    }
}

/// Weights of four evenly spaced points for a place between the inner two: the cubic with the slopes of central differences
/// (Keys, IEEE Trans. ASSP 29 (1981) 1153, Eq. (15)).
fn cubic_weights(t: f64) -> [f64; 4] {
    let (square, cube) = (t * t, t * t * t);
    [
        0.5 * (-cube + 2.0 * square - t),
        0.5 * (3.0 * cube - 5.0 * square + 2.0),
        0.5 * (-3.0 * cube + 4.0 * square + t),
        0.5 * (cube - square),
    ]
}

/// A map and the lags to sum over.
struct Shape {
    columns: usize,
    rows: usize,
    lags: [usize; 2],
}

impl Shape {
    /// Sums products of values at all lags, by transforms of the map with zeros behind it.
    fn sums_of_products(&self, values: impl Iterator<Item = f64>) -> Vec<f64> {
        let [wide, high] =
            [(self.columns, self.lags[0]), (self.rows, self.lags[1])].map(|(n, lag)| fast_size(n + lag));
        let (forward, backward) =
            (numerics::transforms::forward_of_real(wide), numerics::transforms::inverse_to_real(wide));
        let [down, up] = f64::plan_both_ways(high);
        let bins = wide / 2 + 1;
        let mut transform = vec![Complex::default(); bins * high];
        let mut row = forward.make_input_vec();
        let mut values = values;
        for bins in transform.chunks_exact_mut(bins).take(self.rows) {
            row.fill(0.0);
            row.iter_mut().take(self.columns).for_each(|value| *value = values.next().unwrap_or(0.0));
            forward.process(&mut row, bins).expect("the buffers come from the plan");
        }
        let mut column = vec![Complex::default(); high];
        for bin in 0..bins {
            let places = || (bin..).step_by(bins).take(high);
            column.iter_mut().zip(places()).for_each(|(value, place)| *value = transform[place]);
            down.process(&mut column);
            column.iter_mut().for_each(|value| *value = Complex::new(value.norm_sqr(), 0.0));
            up.process(&mut column);
            column.iter().zip(places()).for_each(|(value, place)| transform[place] = *value);
        }
        let scale = 1.0 / (wide as f64 * high as f64);
        let mut sums = Vec::with_capacity((2 * self.lags[0] + 1) * (self.lags[1] + 1));
        for bins in transform.chunks_exact_mut(bins).take(self.lags[1] + 1) {
            // The first and the last bin of a real row are real.
            bins[0].im = 0.0;
            if wide.is_multiple_of(2) {
                bins[wide / 2].im = 0.0;
            }
            backward.process(bins, &mut row).expect("the buffers come from the plan");
            let negative = (1..=self.lags[0]).rev().map(|lag| row[wide - lag]);
            let positive = (0..=self.lags[0]).map(|lag| row[lag]);
            sums.extend(negative.chain(positive).map(|sum| sum * scale));
        }
        sums
    }

    /// Numbers of pairs of points at all lags of a map without missing points.
    fn overlaps(&self) -> Vec<f64> {
        let along = |points: usize, lag: usize| points.saturating_sub(lag) as f64;
        let lags_x = || (1..=self.lags[0]).rev().chain(0..=self.lags[0]);
        let of_row = |y: usize| lags_x().map(move |x| along(self.columns, x) * along(self.rows, y));
        (0..=self.lags[1]).flat_map(of_row).collect()
    }
}

/// The next size that has no prime factor above 5.
fn fast_size(least: usize) -> usize {
    let is_fast = |size: &usize| {
        let mut rest = *size;
        for factor in [2, 3, 5] {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
        }
        rest == 1
    };
    (least..).find(is_fast).expect("a power of two follows")
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;
    use scans::{HeightMap, MeasuredScan, MissingPoints, Scan};

    use crate::relief::{Evaluation, FormRemoval};

    use super::*;

    fn relief(
        columns: usize,
        rows: usize,
        height_m: impl Fn(f64, f64) -> f64,
        missing: MissingPoints,
    ) -> ScaleLimitedSurface {
        let heights_m =
            (0..columns * rows).map(|at| height_m((at % columns) as f64, (at / columns) as f64)).collect();
        let map = Scan::Map(HeightMap::new(columns, 1e-6, 2e-6, heights_m).unwrap());
        let evaluation = Evaluation { form: FormRemoval::None, ..Evaluation::default() };
        ScaleLimitedSurface::new(&MeasuredScan::with_missing_points(map, missing), &evaluation).unwrap()
    }

    #[test]
    fn sums_are_those_of_all_pairs() {
        let missing: MissingPoints = [3usize, 17, 40].into_iter().collect();
        let rough = relief(9, 7, |x, y| (3.1 * x + 1.3 * y * y).sin(), missing);
        let found = Autocorrelation::of_map(&rough).unwrap();
        for (x, y) in [(0isize, 0isize), (2, 1), (-3, 2), (4, -3), (-4, 0)] {
            let (mut sum, mut pairs) = (0.0, 0.0);
            for row in 0..7isize {
                for column in 0..9isize {
                    let other = (row + y, column + x);
                    if !(0..7).contains(&other.0) || !(0..9).contains(&other.1) {
                        continue;
                    }
                    let height = |(row, column): (isize, isize)| rough.height_m((row * 9 + column) as usize);
                    if let (Some(one), Some(two)) = (height((row, column)), height(other)) {
                        sum += one * two;
                        pairs += 1.0;
                    }
                }
            }
            let value = found.value([x, y], AutocorrelationNormalisation::Unbiased);
            assert_relative_eq!(value, sum / pairs, max_relative = 1e-11, epsilon = 1e-14);
            let value = found.value([x, y], AutocorrelationNormalisation::Biased);
            assert_relative_eq!(value, sum / 60.0, max_relative = 1e-11, epsilon = 1e-14);
        }
    }

    #[test]
    fn a_wave_falls_along_its_direction_and_not_across_it() {
        // cos(2 pi tau/L) = 0.2 at tau = 0.2179 L.
        let ridges = relief(4000, 30, |x, _| (TAU * (x + 0.5) / 40.0).cos(), MissingPoints::default());
        let reach = Autocorrelation::of_map(&ridges).unwrap().reach(AutocorrelationNormalisation::Unbiased);
        assert_relative_eq!(reach.shortest_m.unwrap(), 0.2f64.acos() / TAU * 40e-6, max_relative = 3e-3);
        assert_eq!(reach.longest_m, None);
        assert_relative_eq!(reach.searched_m, 30e-6, max_relative = 0.02);
    }

    #[test]
    fn an_isotropic_field_has_a_texture_near_one_and_a_stretched_one_its_ratio() {
        // Sums of waves in all directions with one wavelength: the autocorrelation is a Bessel function of the lag.
        let field = |stretch: f64| {
            let waves: Vec<[f64; 3]> = (0..60)
                .map(|i| {
                    let angle = PI * f64::from(i) / 60.0;
                    [angle.cos(), angle.sin() / stretch, f64::from(i * i % 17)]
                })
                .collect();
            let height_m = move |x: f64, y: f64| {
                waves.iter().map(|[a, b, phase]| (TAU / 20.0 * (a * x + b * 2.0 * y) + phase).cos()).sum()
            };
            let reach = Autocorrelation::of_map(&relief(400, 300, height_m, MissingPoints::default()))
                .unwrap()
                .reach(AutocorrelationNormalisation::Unbiased);
            reach.shortest_m.unwrap() / reach.longest_m.unwrap()
        };
        assert!(field(1.0) > 0.9, "{}", field(1.0));
        assert_relative_eq!(field(3.0), 1.0 / 3.0, max_relative = 0.1);
    }
}
