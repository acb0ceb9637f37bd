//! The Gaussian filter of ISO 16610-21 and -61: transmission 2^(-(lc/lambda)^2), 50 % at the cut-off lc.

use std::f64::consts::{LN_2, PI};
use std::sync::Arc;

use numerics::transforms::{Complex, ComplexToReal, RealToComplex};

/// Half the extent of the weights, in standard deviations.
const EXTENT: f64 = 4.0;

/// Returns the standard deviation \[m\] of the weights of a filter, lc sqrt(ln 2/2)/pi.
fn standard_deviation_m(cutoff_m: f64) -> f64 {
    cutoff_m * (0.5 * LN_2).sqrt() / PI
}

/// A filter for rows of equally many points.
///
/// Beyond its ends a row goes on as its mirror image about the edge, so that the mean of the weights is a product in the
/// transform of the row and its image.
pub(crate) struct GaussianFilter {
    points: usize,
    transmission: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
}

impl GaussianFilter {
    /// Makes a filter for rows of `points` points `spacing_m` apart.
    pub fn new(points: usize, spacing_m: f64, cutoff_m: f64) -> Self {
        let period = 2 * points;
        let (forward, backward) =
            (numerics::transforms::forward_of_real(period), numerics::transforms::inverse_to_real(period));
        let deviation = standard_deviation_m(cutoff_m) / spacing_m;
        let reach = (EXTENT * deviation + 0.5) as usize;
        let weight = |offset: usize| (-0.5 * (offset as f64 / deviation).powi(2)).exp();
        let sum = 1.0 + 2.0 * (1..=reach).map(weight).sum::<f64>();
        let mut weights = vec![0.0; period];
        weights[0] = 1.0 / sum;
        for offset in 1..=reach {
            for place in [offset % period, (period - offset % period) % period] {
                weights[place] += weight(offset) / sum;
            }
        }
        let mut transmission = forward.make_output_vec();
        forward.process(&mut weights, &mut transmission).expect("the buffers come from the plan");
        let transmission = transmission.iter().map(|value| value.re / period as f64).collect();
        GaussianFilter { points, transmission, forward, backward }
    }

    /// Replaces each value by the weighted mean around it.
    pub fn smooth(&self, row: &mut [f64], buffers: &mut Buffers) {
        let Buffers { mirrored, transform } = buffers;
        mirrored[..self.points].copy_from_slice(row);
        mirrored[self.points..].copy_from_slice(row);
        mirrored[self.points..].reverse();
        self.forward.process(mirrored, transform).expect("the buffers come from the plan");
        transform.iter_mut().zip(&self.transmission).for_each(|(value, factor)| *value *= factor);
        // Symmetric rows have real transforms up to their phase; rounding must not reach the two real bins.
        for end in [0, self.points] {
            transform[end].im = 0.0;
        }
        self.backward.process(transform, mirrored).expect("the buffers come from the plan");
        row.copy_from_slice(&mirrored[..self.points]);
    }

    /// Makes the buffers that [`GaussianFilter::smooth`] needs.
    pub fn buffers(&self) -> Buffers {
        Buffers { mirrored: self.forward.make_input_vec(), transform: self.forward.make_output_vec() }
    }
}

/// Working space of a filter.
pub(crate) struct Buffers {
    mirrored: Vec<f64>,
    transform: Vec<Complex<f64>>,
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn smoothed(row: &[f64], spacing_m: f64, cutoff_m: f64) -> Vec<f64> {
        let filter = GaussianFilter::new(row.len(), spacing_m, cutoff_m);
        let mut row = row.to_vec();
        filter.smooth(&mut row, &mut filter.buffers());
        row
    }

    #[test]
    fn the_weights_are_those_of_a_sum_over_mirrored_points() {
        let row: Vec<f64> = (0..37).map(|i| f64::from(i * i % 11)).collect();
        // The longest reaches beyond two lengths of the row.
        for cutoff in [0.3, 2.0, 9.0, 130.0] {
            let deviation = cutoff * (0.5 * LN_2).sqrt() / PI;
            let reach = (4.0 * deviation + 0.5) as i64;
            let at = |index: i64| {
                let within = index.rem_euclid(74);
                row[usize::try_from(if within < 37 { within } else { 73 - within }).unwrap()]
            };
            let weight = |offset: i64| (-0.5 * (offset as f64 / deviation).powi(2)).exp();
            let sum: f64 = (-reach..=reach).map(weight).sum();
            for (index, found) in smoothed(&row, 1.0, cutoff).into_iter().enumerate() {
                let expected: f64 = (-reach..=reach).map(|k| weight(k) * at(index as i64 + k)).sum();
                assert_relative_eq!(found, expected / sum, max_relative = 1e-8, epsilon = 1e-13);
            }
        }
    }

    #[test]
    fn half_of_a_wave_at_the_cutoff_passes() {
        let points = 4000;
        let wave = |i: usize| (PI * (i as f64 + 0.5) / 100.0).cos();
        let row: Vec<f64> = (0..points).map(wave).collect();
        for (cutoff_m, passed) in [(200e-9, 0.5), (400e-9, 0.0625), (100e-9, 0.5f64.powf(0.25))] {
            for (index, found) in smoothed(&row, 1e-9, cutoff_m).into_iter().enumerate() {
                assert!((found - passed * wave(index)).abs() < 1e-4, "{cutoff_m}: {found}");
            }
        }
    }
}
