//! Draws of a spectrum from a file with standard errors.

use chacha20::rand_core::Rng;
use rand_distr::{Distribution, StandardNormal};
use spectrum::ProfilePsd;

use crate::results::SpectrumErrors;

/// Decades of wavelength over which errors are correlated, as exp(-distance/length). Files do not state it, and
/// independent errors of every bin would make moments look far more certain than they are.
pub const CORRELATION_DECADES: f64 = 0.5;

/// An uncertain spectrum.
#[derive(Debug)]
pub(crate) struct ErrorsOfSpectrum {
    psd: ProfilePsd,
    /// The standard deviation of ln C at each wavelength; samples without an error take that of the nearest sample with
    /// one.
    sd: Vec<f64>,
    /// The correlation with the wavelength before.
    with_last: Vec<f64>,
    /// The errors, for the report.
    pub description: SpectrumErrors,
}

impl ErrorsOfSpectrum {
    /// The errors of a spectrum with this name; `None` if it has no standard errors.
    pub fn from_spectrum(psd: &ProfilePsd, name: &str) -> Option<Self> {
        let errors_m3 = psd.standard_errors_m3()?;
        // A log-normal value of the median C and the standard deviation u has the variance ln((1 + sqrt(1 + 4 (u/C)^2))/2) of
        // its logarithm.
        let sd = |(value_m3, error_m3): (&f64, &Option<f64>)| {
            let relative = error_m3.unwrap_or(0.0) / value_m3;
            (0.5 * (1.0 + (1.0 + 4.0 * relative * relative).sqrt())).ln().sqrt()
        };
        let known: Vec<f64> = psd.c1d_m3().iter().zip(errors_m3).map(sd).collect();
        let sd = with_neighbours(&known, errors_m3);
        let decades = |pair: &[f64]| (pair[0] / pair[1]).log10();
        let steps = psd.wavelengths_m().windows(2).map(|pair| (-decades(pair) / CORRELATION_DECADES).exp());
        let description = SpectrumErrors {
            name: name.to_owned(),
            samples: known.iter().filter(|sd| **sd > 0.0).count(),
            of: sd.len(),
            correlation_decades: CORRELATION_DECADES,
            are_assumed: false,
        };
        let with_last = std::iter::once(0.0).chain(steps).collect();
        (description.samples > 0).then(|| ErrorsOfSpectrum { psd: psd.clone(), sd, with_last, description })
    }

    /// Marks the errors as assumed.
    pub fn assumed(self) -> Self {
        ErrorsOfSpectrum { description: SpectrumErrors { are_assumed: true, ..self.description }, ..self }
    }

    /// Draws the deviations of ln C: a normal process along ln q, each step correlated with the last.
    pub fn deviations(&self, numbers: &mut impl Rng) -> Vec<f64> {
        let mut last = 0.0;
        let mut next = |(sd, correlation): (&f64, &f64)| {
            let fresh: f64 = StandardNormal.sample(numbers);
            last = correlation * last + (1.0 - correlation * correlation).sqrt() * fresh;
            sd * last
        };
        self.sd.iter().zip(&self.with_last).map(&mut next).collect()
    }

    /// The spectrum with these deviations.
    pub fn psd(&self, deviations: &[f64]) -> Option<ProfilePsd> {
        let moved = self.psd.c1d_m3().iter().zip(deviations).map(|(c1d_m3, off)| c1d_m3 * off.exp());
        self.psd.with_values(moved.collect()).ok()
    }

    /// The spectrum as it is.
    pub fn centre(&self) -> &ProfilePsd {
        &self.psd
    }
}

/// Fills missing standard deviations from the nearest samples that have one: no sample is exact for want of a stated
/// error.
fn with_neighbours(sd: &[f64], errors_m3: &[Option<f64>]) -> Vec<f64> {
    let known: Vec<usize> = (0..sd.len()).filter(|&at| errors_m3[at].is_some()).collect();
    let nearest =
        |at: usize| known.iter().copied().min_by_key(|other| other.abs_diff(at)).map_or(0.0, |at| sd[at]);
    (0..sd.len()).map(nearest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::group::Group;
    use crate::random::Streams;
    use spectrum::{Convention, Psd};

    #[test]
    fn deviations_have_the_sd_and_the_correlation_that_are_told() {
        let wavelengths_m: Vec<f64> = (0..6).map(|at| 10f64.powf(-5.0 - 0.1 * f64::from(at))).collect();
        let psd = Psd::new(wavelengths_m, vec![2.0; 6], Convention::C1D).unwrap();
        let errors = vec![Some(0.2), Some(0.2), None, Some(0.2), Some(0.2), Some(0.2)];
        let psd = psd.with_standard_errors(errors).unwrap().profile().unwrap();
        let found = ErrorsOfSpectrum::from_spectrum(&psd, "x").unwrap();
        assert_eq!((found.description.samples, found.description.of), (5, 6));
        let draws: Vec<Vec<f64>> =
            (0..20_000).map(|draw| found.deviations(&mut Streams::new(3).of(Group::Scans, draw))).collect();
        let mean = |of: &dyn Fn(&Vec<f64>) -> f64| draws.iter().map(of).sum::<f64>() / draws.len() as f64;
        // (u/C)^2 = 0.01 makes a variance of the logarithm of 0.00985.
        let variance = mean(&|draw| draw[0] * draw[0]);
        assert!((variance / 0.009_852 - 1.0).abs() < 0.03, "{variance}");
        assert!((mean(&|draw| draw[5] * draw[5]) / 0.009_852 - 1.0).abs() < 0.03);
        // Half a decade apart: e^-1.
        assert!((mean(&|draw| draw[0] * draw[5]) / variance - (-1f64).exp()).abs() < 0.03);
        // The third has none of its own: that of its neighbours.
        assert!((mean(&|draw| draw[2] * draw[2]) / 0.009_852 - 1.0).abs() < 0.03);
        let sd_of_values = mean(&|draw| (2.0 * draw[0].exp() - 2.0).powi(2)).sqrt();
        assert!((sd_of_values / 0.2 - 1.0).abs() < 0.03);
    }
}
