//! The waves of a measured map, and random surfaces with the same waves.

use std::f64::consts::TAU;

use numerics::transforms::Complex64;

use crate::random_surfaces::fourier::HalfSpectrum;
use crate::random_surfaces::modes::Draws;
use crate::random_surfaces::surface::{RandomSurface, profile_moments};

/// A map made periodic, as a sum of waves.
///
/// Heights at opposite edges of a scan do not match. The periodic part of the map is used (Moisan 2011, J. Math.
/// Imaging Vis. 39:161): the map minus the smoothest surface with the same steps across the edges. No window or mirror
/// then changes the roughness inside. The mean is dropped.
#[derive(Clone, Debug)]
pub struct MapWaves {
    points_x: usize,
    points_y: usize,
    length_x_m: f64,
    length_y_m: f64,
    /// Wavenumbers along x and y, one half of the plane, with the amplitude \[m\] of exp(i q r).
    waves: Vec<(usize, i64, Complex64)>,
    shortest_m: f64,
}

impl MapWaves {
    /// Decomposes heights \[m\], row by row with `points_x` per row, on a box of the given lengths \[m\].
    ///
    /// Keeps waves with at least `least_points` grid points per wavelength. A periodic map is used unchanged; from any
    /// other a plane should have been subtracted.
    ///
    /// # Panics
    /// If the heights do not fill whole rows, at least one.
    #[must_use]
    pub fn new(
        heights_m: &[f64],
        points_x: usize,
        [length_x_m, length_y_m]: [f64; 2],
        is_periodic: bool,
        least_points: f64,
    ) -> Self {
        assert!(points_x > 0 && !heights_m.is_empty() && heights_m.len().is_multiple_of(points_x));
        let points_y = heights_m.len() / points_x;
        let amplitudes = match is_periodic {
            true => amplitudes(heights_m, points_x),
            false => periodic_part(heights_m, points_x),
        };
        // A wave with `least_points` per wavelength has |(2 m/points_x, 2 n/points_y)| = 2/least_points.
        let longest = (0.5 * least_points).recip();
        let held = |m: i64, n: i64| {
            let (x, y) = (2.0 * m as f64 / points_x as f64, 2.0 * n as f64 / points_y as f64);
            (m, n) != (0, 0) && x.hypot(y) <= longest * (1.0 + 1e-12)
        };
        let mut waves = Vec::new();
        let (half_x, half_y) = ((points_x as i64 - 1) / 2, (points_y as i64 - 1) / 2);
        for n in -half_y..=half_y {
            for m in i64::from(n <= 0)..=half_x {
                if held(m, n) {
                    let row = n.rem_euclid(points_y as i64) as usize;
                    waves.push((m as usize, n, amplitudes[row * points_x + m as usize]));
                }
            }
        }
        let spacing_m = (length_x_m / points_x as f64).max(length_y_m / points_y as f64);
        let shortest_m = least_points * spacing_m;
        MapWaves { points_x, points_y, length_x_m, length_y_m, waves, shortest_m }
    }

    /// Drops waves shorter than a wavelength \[m\].
    #[must_use]
    pub fn down_to(mut self, shortest_m: f64) -> Self {
        let [x_m, y_m] = [self.length_x_m, self.length_y_m];
        let length_m = |m: usize, n: i64| (m as f64 / x_m).hypot(n as f64 / y_m).recip();
        self.waves.retain(|(m, n, _)| length_m(*m, *n) >= (1.0 - 1e-9) * shortest_m);
        self
    }

    /// Returns the map as the sum of its kept waves.
    #[must_use]
    pub fn surface(&self) -> RandomSurface {
        self.summed(|amplitude, _| amplitude)
    }

    /// Returns a Gaussian surface of the same waves: the amplitudes of the map with random phases. Seed and realisation
    /// act as in [`AreaSpectrum::surface`](crate::random_surfaces::AreaSpectrum::surface).
    #[must_use]
    pub fn twin(&self, seed: u64, realisation: u64) -> RandomSurface {
        self.summed_with(Draws::new(seed, realisation), |amplitude, turn| {
            let (sine, cosine) = libm::sincos(TAU * turn);
            Complex64::new(cosine, sine) * amplitude.norm()
        })
    }

    fn summed(&self, of: impl Fn(Complex64, f64) -> Complex64) -> RandomSurface {
        self.summed_with(Draws::new(0, 0), of)
    }

    fn summed_with(&self, draws: Draws, of: impl Fn(Complex64, f64) -> Complex64) -> RandomSurface {
        let mut spectrum = HalfSpectrum::new(self.points_y, self.points_x);
        let mut sums = [0.0; 3];
        // Waves are stored row by row, and so are their random numbers.
        for row in self.waves.chunk_by(|a, b| a.1 == b.1) {
            let (first, n, _) = row[0];
            let places = row.iter().zip(draws.row(n, first));
            for (&(m, n, amplitude), draw) in places {
                let amplitude = of(amplitude, draw.turn);
                let q2 =
                    (TAU * m as f64 / self.length_x_m).powi(2) + (TAU * n as f64 / self.length_y_m).powi(2);
                let square_m2 = 2.0 * amplitude.norm_sqr();
                sums = [sums[0] + square_m2, sums[1] + q2 * square_m2, sums[2] + q2 * q2 * square_m2];
                spectrum.add(m, n, amplitude);
            }
        }
        RandomSurface {
            points_x: self.points_x,
            points_y: self.points_y,
            length_x_m: self.length_x_m,
            length_y_m: self.length_y_m,
            heights_m: spectrum.sum(),
            moments: profile_moments(self.shortest_m, sums),
        }
    }
}

/// Computes the amplitudes \[m\] of a map, row by row.
fn amplitudes(heights_m: &[f64], columns: usize) -> Vec<Complex64> {
    let norm = (heights_m.len() as f64).recip();
    let mut values: Vec<Complex64> =
        heights_m.iter().map(|height_m| Complex64::new(norm * height_m, 0.0)).collect();
    transform(&mut values, columns);
    values
}

/// Computes the amplitudes \[m\] of the periodic part of a map (Moisan 2011).
fn periodic_part(heights_m: &[f64], columns: usize) -> Vec<Complex64> {
    let rows = heights_m.len() / columns;
    let mut steps = vec![0.0; heights_m.len()];
    for column in 0..columns {
        let (first, last) = (column, (rows - 1) * columns + column);
        let step = heights_m[last] - heights_m[first];
        steps[first] += step;
        steps[last] -= step;
    }
    for row in 0..rows {
        let (first, last) = (row * columns, (row + 1) * columns - 1);
        let step = heights_m[last] - heights_m[first];
        steps[first] += step;
        steps[last] -= step;
    }
    let turn = |k: usize, points: usize| 2.0 * libm::cos(TAU * k as f64 / points as f64) - 2.0;
    let periodic = |(at, (whole, steps)): (usize, (Complex64, Complex64))| {
        let laplacian = turn(at % columns, columns) + turn(at / columns, rows);
        if at == 0 { whole } else { whole - steps / laplacian }
    };
    let pairs = amplitudes(heights_m, columns).into_iter().zip(amplitudes(&steps, columns));
    pairs.enumerate().map(periodic).collect()
}

/// Computes the discrete Fourier transform in place; `columns` values per row.
fn transform(values: &mut [Complex64], columns: usize) {
    let rows = values.len() / columns;
    numerics::transforms::forward(columns).process(values);
    let along_columns = numerics::transforms::forward(rows);
    let mut column_values = vec![Complex64::ZERO; rows];
    for column in 0..columns {
        for (row, value) in column_values.iter_mut().enumerate() {
            *value = values[row * columns + column];
        }
        along_columns.process(&mut column_values);
        for (row, value) in column_values.iter().enumerate() {
            values[row * columns + column] = *value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDES_M: [f64; 2] = [3e-6, 2e-6];

    fn waves(columns: usize, rows: usize) -> Vec<f64> {
        let height = |x: usize, y: usize| {
            let (x, y) = (TAU * x as f64 / columns as f64, TAU * y as f64 / rows as f64);
            1e-9 * (2.0 * x + y).sin() + 3e-9 * (y - 1.0).cos() + 2e-9 * (x - 2.0 * y).cos()
        };
        (0..rows).flat_map(|y| (0..columns).map(move |x| height(x, y))).collect()
    }

    #[test]
    fn a_periodic_map_is_reproduced_for_even_and_odd_sides() {
        for (columns, rows) in [(24, 16), (25, 17), (24, 17)] {
            let heights_m = waves(columns, rows);
            let surface = MapWaves::new(&heights_m, columns, SIDES_M, true, 2.0).surface();
            for (found, expected) in surface.heights_m.iter().zip(&heights_m) {
                assert!((found - expected).abs() < 1e-22, "{found:e} {expected:e}");
            }
            let q2 = |m: f64, n: f64| (TAU * m / SIDES_M[0]).powi(2) + (TAU * n / SIDES_M[1]).powi(2);
            let gradient = 0.5 * (1e-18 * q2(2.0, 1.0) + 9e-18 * q2(0.0, 1.0) + 4e-18 * q2(1.0, -2.0));
            assert!((surface.mean_square_gradient() / gradient - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn an_arch_whose_ends_do_not_meet_leaves_its_roughness_and_no_step() {
        let (columns, rows) = (128, 96);
        let quarter = |at: usize| (0.25 * TAU * (at % columns) as f64 / columns as f64).sin();
        let rough = waves(columns, rows);
        let arched: Vec<f64> =
            rough.iter().enumerate().map(|(at, height_m)| height_m + 10e-9 * quarter(at)).collect();
        let gradient = |heights_m: &[f64], is_periodic: bool| {
            MapWaves::new(heights_m, columns, SIDES_M, is_periodic, 4.0).surface().mean_square_gradient()
        };
        let expected = gradient(&rough, true);
        assert!(
            (gradient(&arched, false) / expected - 1.0).abs() < 0.1,
            "{}",
            gradient(&arched, false) / expected
        );
        assert!(gradient(&arched, true) > 2.0 * expected);
    }

    #[test]
    fn a_twin_has_the_moments_of_the_map_and_other_heights() {
        let map = MapWaves::new(&waves(24, 16), 24, SIDES_M, true, 2.0);
        let [twin, again, other] = [(1, 0), (1, 0), (1, 1)].map(|(seed, at)| map.twin(seed, at));
        assert_eq!(twin, again);
        assert!(twin.heights_m != other.heights_m && twin.heights_m != map.surface().heights_m);
        assert!((twin.mean_square_gradient() / map.surface().mean_square_gradient() - 1.0).abs() < 1e-12);
    }
}
