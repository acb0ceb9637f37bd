//! Fourier sums over scattered points by a fast transform: Dutt & Rokhlin, SIAM J. Sci. Comput. 14 (1993) 1368, with the
//! kernel of Barnett, Magland & af Klinteberg, SIAM J. Sci. Comput. 41 (2019) C479, Eqs. (1.8) and (3.10).

use std::f64::consts::{PI, TAU};

use numerics::GaussLegendre;
use numerics::transforms::Complex;

/// Points of the regular grid for each wavevector, positive and negative.
const OVERSAMPLING: usize = 4;
/// Points of the grid to which each scattered point contributes; the sums are then good to about 1e-14 of Sum |c|.
const WIDTH: usize = 13;
/// Exponent of the kernel exp(b [sqrt(1 - z^2) - 1]), -1 < z < 1: 0.97 pi WIDTH [1 - 1/(2 OVERSAMPLING)].
const EXPONENT: f64 = 0.97 * PI * (WIDTH as f64) * (1.0 - 0.5 / OVERSAMPLING as f64);
/// Nodes of the rule that transforms the kernel, some five radians wide.
const KERNEL_NODES: usize = 60;

/// Weights spread onto a regular grid over one turn, for Sum c e^(-2 pi i n t) with n from 0 to a count.
pub(crate) struct ScatteredSums {
    grid: Vec<f64>,
    count: usize,
}

impl ScatteredSums {
    /// Prepares sums for n below `count`, at least 1.
    pub(crate) fn new(count: usize) -> Self {
        let points = (2 * OVERSAMPLING * count).max(2 * WIDTH).next_power_of_two();
        Self { grid: vec![0.0; points], count }
    }

    /// Adds a weight at a place in turns, from 0 to 1.
    pub(crate) fn add(&mut self, turns: f64, weight: f64) {
        let points = self.grid.len();
        let place = turns * points as f64;
        let first = (place - 0.5 * WIDTH as f64).ceil();
        let wrapped = (first + points as f64) as usize; // the place lies in 0..=points, so `first` is above -points
        for k in 0..WIDTH {
            let z = (first + k as f64 - place) / (0.5 * WIDTH as f64);
            self.grid[(wrapped + k) & (points - 1)] += weight * kernel(z);
        }
    }

    /// Computes the sums.
    pub(crate) fn finish(mut self) -> Vec<Complex<f64>> {
        let plan = numerics::transforms::forward_of_real(self.grid.len());
        let mut transformed = plan.make_output_vec();
        plan.process(&mut self.grid, &mut transformed).expect("the buffers come from the plan");
        let half_width = PI * WIDTH as f64 / self.grid.len() as f64; // in radians
        let rule = GaussLegendre::new(KERNEL_NODES);
        let nodes: Vec<(f64, f64)> =
            rule.over(0.0, 1.0).map(|(z, weight)| (z, 2.0 * weight * kernel(z))).collect();
        let kernel_transform = |n: usize| -> f64 {
            let angle = n as f64 * half_width;
            nodes.iter().map(|(z, weight)| weight * (angle * z).cos()).sum::<f64>() * half_width
        };
        let spacing = TAU / self.grid.len() as f64;
        transformed.truncate(self.count);
        transformed.iter().enumerate().map(|(n, sum)| sum * (spacing / kernel_transform(n))).collect()
    }
}

fn kernel(z: f64) -> f64 {
    (EXPONENT * ((1.0 - z * z).max(0.0).sqrt() - 1.0)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_added_one_by_one() {
        for count in [1, 2, 3, 50, 700] {
            let points: Vec<(f64, f64)> =
                (0..300).map(|i| (f64::from(i * i % 301) / 300.0, f64::from(i).sin())).collect();
            let mut sums = ScatteredSums::new(count);
            points.iter().for_each(|&(turns, weight)| sums.add(turns, weight));
            let size: f64 = points.iter().map(|(_, weight)| weight.abs()).sum();
            for (n, found) in sums.finish().into_iter().enumerate() {
                let expected: Complex<f64> = points
                    .iter()
                    .map(|&(turns, weight)| weight * Complex::cis(-TAU * (n as f64 * turns).fract()))
                    .sum();
                assert!((found - expected).norm() < 1e-14 * size, "{count}, {n}: {found} {expected}");
            }
        }
    }
}
