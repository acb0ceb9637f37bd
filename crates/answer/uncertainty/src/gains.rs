//! The gain and slope of every instrument: the uncertainty of their calibrations, reduced by overlaps.

use chacha20::rand_core::Rng;
use rand_distr::{Distribution, StandardNormal};

use crate::results::InstrumentInput;

/// The standard uncertainties of an instrument before its overlaps, about 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Prior {
    /// The standard uncertainty of the gain of ln C: twice that of the height scale.
    pub gain_sd: f64,
    /// The standard uncertainty of the exponent.
    pub slope_sd: f64,
}

impl Prior {
    pub fn new(instrument: &InstrumentInput) -> Self {
        Prior { gain_sd: 2.0 * instrument.z_calibration, slope_sd: instrument.slope_uncertainty }
    }
}

/// The observed difference of the gains of two instruments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Observation {
    /// Both instruments, by index.
    pub instruments: [usize; 2],
    /// The mean of ln(q/q_i) over the wavelengths that they share, for each.
    pub ln_q: [f64; 2],
    /// The mean of ln(C_first/C_second) there.
    pub difference: f64,
    /// Its variance from the scatter of the scans.
    pub variance: f64,
}

/// The gains and slopes of all instruments: normal, conditioned on one overlap after the other.
#[derive(Debug, Clone)]
pub(crate) struct Gains {
    priors: Vec<Prior>,
    /// Each overlap, and the change of every parameter by it.
    updates: Vec<(Observation, Vec<f64>)>,
    /// The mean gain and slope of each instrument.
    pub mean: Vec<[f64; 2]>,
    /// The variances of the gains after all overlaps.
    variances: Vec<f64>,
}

impl Gains {
    pub fn new(priors: &[Prior], observations: &[Observation]) -> Self {
        let sds: Vec<f64> = priors.iter().flat_map(|prior| [prior.gain_sd, prior.slope_sd]).collect();
        let size = sds.len();
        let mut covariance = vec![vec![0.0; size]; size];
        for (at, sd) in sds.iter().enumerate() {
            covariance[at][at] = sd * sd;
        }
        let mut updates = Vec::new();
        for observation in observations {
            let seen = observation.coefficients(size);
            let with_seen: Vec<f64> = covariance.iter().map(|row| dot(row, &seen)).collect();
            let variance = dot(&with_seen, &seen) + observation.variance;
            // If neither instrument is uncertain, the observation teaches nothing about them.
            if dot(&with_seen, &seen) == 0.0 {
                continue;
            }
            for (row, of_row) in covariance.iter_mut().zip(&with_seen) {
                row.iter_mut().zip(&with_seen).for_each(|(cell, other)| *cell -= of_row * other / variance);
            }
            updates.push((*observation, with_seen.iter().map(|moved| moved / variance).collect()));
        }
        let variances = (0..priors.len()).map(|at| covariance[2 * at][2 * at].max(0.0)).collect();
        let mut gains =
            Gains { priors: priors.to_vec(), updates, mean: vec![[0.0; 2]; priors.len()], variances };
        gains.mean = gains.conditioned(vec![0.0; size], |_| 0.0);
        gains
    }

    /// Mean and standard uncertainty of the gain of an instrument.
    pub fn gain_of(&self, instrument: usize) -> [f64; 2] {
        [self.mean[instrument][0], self.variances[instrument].sqrt()]
    }

    /// True if any gain or slope is uncertain.
    pub fn scatter(&self) -> bool {
        self.priors.iter().any(|prior| prior.gain_sd > 0.0 || prior.slope_sd > 0.0)
    }

    /// The gains if the gain of one instrument were known exactly.
    pub fn without(&self, instrument: usize) -> Self {
        let mut priors = self.priors.clone();
        priors[instrument] = Prior { gain_sd: 0.0, slope_sd: 0.0 };
        let observations: Vec<Observation> =
            self.updates.iter().map(|(observation, _)| *observation).collect();
        Gains::new(&priors, &observations)
    }

    /// Draws gain and slope of every instrument. Each overlap is drawn with its scatter and moves a draw of the prior
    /// as it moves the mean, which makes it a draw of the posterior (Matheron's rule).
    pub fn draw(&self, numbers: &mut impl Rng) -> Vec<[f64; 2]> {
        let mut normal = || -> f64 { StandardNormal.sample(numbers) };
        let before: Vec<f64> = self
            .priors
            .iter()
            .flat_map(|prior| [prior.gain_sd, prior.slope_sd])
            .map(|sd| if sd > 0.0 { sd * normal() } else { 0.0 })
            .collect();
        self.conditioned(before, |variance| variance.sqrt() * normal())
    }

    fn conditioned(&self, mut parameters: Vec<f64>, mut scatter: impl FnMut(f64) -> f64) -> Vec<[f64; 2]> {
        for (observation, moves) in &self.updates {
            let seen = dot(&observation.coefficients(parameters.len()), &parameters);
            let off = observation.difference + scatter(observation.variance) - seen;
            parameters.iter_mut().zip(moves).for_each(|(parameter, moved)| *parameter += moved * off);
        }
        parameters.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}

impl Observation {
    /// The coefficients of the difference for gain and slope of each instrument.
    fn coefficients(&self, size: usize) -> Vec<f64> {
        let mut coefficients = vec![0.0; size];
        for ((instrument, ln_q), sign) in self.instruments.iter().zip(self.ln_q).zip([1.0, -1.0]) {
            coefficients[2 * instrument] = sign;
            coefficients[2 * instrument + 1] = sign * ln_q;
        }
        coefficients
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::group::Group;
    use crate::random::Streams;

    const PRIORS: [Prior; 2] =
        [Prior { gain_sd: 0.06, slope_sd: 0.0 }, Prior { gain_sd: 0.03, slope_sd: 0.01 }];

    fn observed(variance: f64) -> Observation {
        Observation { instruments: [0, 1], ln_q: [1.0, -1.0], difference: 0.1, variance }
    }

    #[test]
    fn an_exact_overlap_ties_the_gains_together() {
        let gains = Gains::new(&PRIORS, &[observed(0.0)]);
        for draw in 0..20 {
            let [first, second] = gains.draw(&mut Streams::new(1).of(Group::Instruments, draw))[..] else {
                panic!("two instruments")
            };
            assert!((first[0] - (second[0] - second[1]) - 0.1).abs() < 1e-15);
            assert_eq!(first[1], 0.0);
        }
        assert!((gains.gain_of(0)[0] / gains.gain_of(1)[0] + 4.0).abs() < 1e-12);
    }

    #[test]
    fn draws_have_the_mean_and_the_variance_that_are_told() {
        let gains = Gains::new(&PRIORS, &[observed(1e-3)]);
        let draws: Vec<f64> = (0..20_000)
            .map(|draw| gains.draw(&mut Streams::new(1).of(Group::Instruments, draw))[0][0])
            .collect();
        let mean = draws.iter().sum::<f64>() / 2e4;
        let sd = (draws.iter().map(|draw| (draw - mean).powi(2)).sum::<f64>() / 2e4).sqrt();
        let [told_mean, told_sd] = gains.gain_of(0);
        // The posterior by hand: 0.0036/(0.0036 + 0.0009 + 0.0001 + 0.001) of the difference.
        assert!((told_mean - 0.1 * 0.0036 / 0.0056).abs() < 1e-15);
        assert!((mean - told_mean).abs() < 3.0 * told_sd / 141.0 && (sd / told_sd - 1.0).abs() < 0.02);
    }

    #[test]
    fn what_is_certain_stays_so() {
        let certain = Prior { gain_sd: 0.0, slope_sd: 0.0 };
        let gains = Gains::new(&[certain, certain], &[observed(0.0)]);
        assert!(!gains.scatter());
        assert_eq!(gains.draw(&mut Streams::new(1).of(Group::Instruments, 0)), [[0.0; 2]; 2]);
    }
}
