//! The scans of one instrument in the bins of the composite, and their draws.
//!
//! The mean of n scans is drawn as JCGM 101:2008, 6.4.9, draws the mean of n repeated indications: with deviations of
//! Student's t with n - 1 degrees of freedom. One normal number multiplies the whole deviation of a scan (a bootstrap
//! with normal multipliers), so the draws keep the correlations of the scans along the wavevector.
//!
//! The scatter of single lines by their Fourier bins is not drawn in this way: its distribution is known (chi-squared),
//! and it is independent from bin to bin. Only the scatter between places beyond it is.

use chacha20::rand_core::Rng;
use rand_distr::{ChiSquared, Distribution, StandardNormal};
use statrs::function::gamma::digamma;

use crate::student::StudentFactors;

/// An instrument in the bins of the composite.
#[derive(Debug)]
pub(crate) struct InstrumentBins {
    /// The number of places measured, or of the parts of one map that represent them.
    pub units: usize,
    /// Standard deviation of ln C between places, for bins with only one place.
    pub place_sd: f64,
    /// True for one place only, which parts of its map may represent.
    pub is_one_place: bool,
    /// Its data in each bin; `None` for a bin out of its reach.
    pub bins: Vec<Option<InstrumentBin>>,
}

/// The data of an instrument in one bin.
#[derive(Debug)]
pub(crate) struct InstrumentBin {
    /// The share of the composite's mean that its scans have.
    pub weight: f64,
    /// ln(q/q_i), q_i in the middle of the instrument's band.
    pub ln_q: f64,
    /// Mean of ln C over its scans at the wavelength of the composite's bin, without the excess.
    pub ln_mean: f64,
    /// Part of ln C that window and trend have added.
    pub excess: f64,
    /// The number of places with a scan that reaches the bin.
    pub places: usize,
    /// The deviations of the scan of each place, or of each part of the map, from that mean.
    pub deviations: Vec<(usize, f64)>,
    /// The scatter that the deviations do not show.
    pub beside: Beside,
}

/// Scatter that the deviations of a bin do not show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Beside {
    /// No further scatter.
    Nothing,
    /// A single scan scatters by its own Fourier bins, with these degrees of freedom and the bias of its logarithm.
    OwnBins { degrees_of_freedom: f64, bias: f64 },
    /// The mean over several places scatters by the Fourier bins of each, with these degrees of freedom.
    OwnBinsOfPlaces { degrees_of_freedom: f64, places: usize },
    /// Parts of a map lie side by side and are alike at long wavelengths: this variance is missing.
    Variance(f64),
}

impl Beside {
    /// The variance; for a single scan, that of its logarithm.
    pub fn variance(self) -> f64 {
        match self {
            Beside::Nothing => 0.0,
            Beside::OwnBins { degrees_of_freedom, .. } => variance_of_logarithm(degrees_of_freedom),
            Beside::OwnBinsOfPlaces { degrees_of_freedom, places } => {
                variance_of_logarithm(degrees_of_freedom) / places as f64
            }
            Beside::Variance(variance) => variance,
        }
    }

    fn draw(self, numbers: &mut impl Rng) -> f64 {
        match self {
            Beside::Nothing => 0.0,
            Beside::OwnBins { degrees_of_freedom, bias } => match ChiSquared::new(degrees_of_freedom) {
                Ok(chi_squared) => bias - (chi_squared.sample(numbers) / degrees_of_freedom).ln(),
                Err(_) => 0.0, // no degrees of freedom below 2 come here
            },
            Beside::OwnBinsOfPlaces { degrees_of_freedom, places } => {
                match ChiSquared::new(degrees_of_freedom) {
                    Ok(chi_squared) => {
                        let half = 0.5 * degrees_of_freedom;
                        let bias = digamma(half) - half.ln();
                        let mut deviation = || bias - (chi_squared.sample(numbers) / degrees_of_freedom).ln();
                        (0..places).map(|_| deviation()).sum::<f64>() / places as f64
                    }
                    Err(_) => 0.0, // degrees of freedom are at least 1
                }
            }
            Beside::Variance(variance) => variance.sqrt() * normal(numbers),
        }
    }
}

impl InstrumentBins {
    /// True if its scans scatter.
    pub fn scatters(&self) -> bool {
        let of_bin = |bin: &InstrumentBin| {
            self.place_sd > 0.0 && self.is_one_place
                || bin.beside != Beside::Nothing
                || bin.deviations.iter().any(|(_, deviation)| *deviation != 0.0)
        };
        self.bins.iter().flatten().any(of_bin)
    }

    /// Draws the deviation of ln C in every bin; 0 out of reach.
    pub fn draw(&self, numbers: &mut impl Rng) -> Vec<f64> {
        let factors = StudentFactors::draw(self.units, numbers);
        let multipliers: Vec<f64> = (0..self.units).map(|_| normal(numbers)).collect();
        let of_place = self.place_sd * normal(numbers);
        let of_bin = |bin: &InstrumentBin, numbers: &mut _| {
            let scans = bin.deviations.len();
            let sum: f64 = bin.deviations.iter().map(|(unit, off)| multipliers[*unit] * off).sum();
            let between = if scans < 2 { 0.0 } else { factors.of(scans) * sum / standard_error_root(scans) };
            let place = if scans < 2 || self.is_one_place { of_place } else { 0.0 };
            between + place + bin.beside.draw(numbers)
        };
        let bins = self.bins.iter();
        bins.map(|bin| bin.as_ref().map_or(0.0, |bin| of_bin(bin, numbers))).collect()
    }
}

/// sqrt(n (n - 1)), which makes the standard error of the mean of n values of the root of the sum of their squares.
pub(crate) fn standard_error_root(values: usize) -> f64 {
    ((values * (values - 1)) as f64).sqrt()
}

fn normal(numbers: &mut impl Rng) -> f64 {
    StandardNormal.sample(numbers)
}

/// The variance of the logarithm of a mean of n degrees of freedom, psi'(n/2): of Euler and Maclaurin from 6 on, and the
/// recurrence below (Abramowitz & Stegun 6.4.6, 6.4.12).
pub(crate) fn variance_of_logarithm(degrees_of_freedom: f64) -> f64 {
    let (mut x, mut sum) = (0.5 * degrees_of_freedom, 0.0);
    while x < 6.0 {
        sum += 1.0 / (x * x);
        x += 1.0;
    }
    let square = 1.0 / (x * x);
    let series = 1.0 / 6.0 - square * (1.0 / 30.0 - square * (1.0 / 42.0 - square / 30.0));
    sum + 1.0 / x + 0.5 * square + square / x * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_of_one_bin_scatters_as_it_should() {
        // psi'(1) = pi^2/6, psi'(1/2) = pi^2/2, psi'(25) as tabulated.
        let pi_squared = std::f64::consts::PI.powi(2);
        assert!((variance_of_logarithm(2.0) - pi_squared / 6.0).abs() < 1e-9);
        assert!((variance_of_logarithm(1.0) - pi_squared / 2.0).abs() < 1e-9);
        assert!((variance_of_logarithm(50.0) - 0.040_810_663_257_237_57).abs() < 1e-12);
    }
}
