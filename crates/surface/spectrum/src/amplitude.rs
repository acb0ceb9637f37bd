//! Amplitude and aspect ratio of each scale of a spectrum.

use std::f64::consts::FRAC_2_PI;

use serde::{Deserialize, Serialize};
use units::{Scale, named};

use crate::profile::ProfilePsd;

/// Equivalent noise bandwidth of the Hann window, in bins.
const HANN_NOISE_BANDWIDTH: f64 = 1.5;

/// Definition of the amplitude of each sampled wavelength of a spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AmplitudeDefinition {
    /// sqrt(C1D/(1.5 lambda)): Jackson & Jacobs, Eq. (5), independent of the spacing of the samples.
    #[default]
    Eq5,
    /// sqrt((2/pi) Int C1D dq) over the band between the geometric midpoints to the neighbouring samples; the first and
    /// last bands end at their sample. The squares add up to twice the variance of the heights.
    Parseval,
}

named!(AmplitudeDefinition, "amplitude definition", { Eq5 => "eq5", Parseval => "parseval" });

/// Computes the scales of a spectrum, one per sample, from long to short wavelengths.
///
/// [`AmplitudeDefinition::Parseval`] gives a spectrum of a single sample the amplitude 0: its band is empty.
pub fn amplitudes(psd: &ProfilePsd, definition: AmplitudeDefinition) -> Vec<Scale> {
    let amplitudes_m = match definition {
        AmplitudeDefinition::Eq5 => hann_amplitudes_m(psd),
        AmplitudeDefinition::Parseval => band_amplitudes_m(psd),
    };
    let scale = |(&wavelength_m, amplitude_m)| Scale { wavelength_m, amplitude_m };
    psd.wavelengths_m().iter().zip(amplitudes_m).map(scale).collect()
}

fn hann_amplitudes_m(psd: &ProfilePsd) -> Vec<f64> {
    let amplitude_m =
        |(wavelength_m, c1d_m3): (&f64, &f64)| (c1d_m3 / (HANN_NOISE_BANDWIDTH * wavelength_m)).sqrt();
    psd.wavelengths_m().iter().zip(psd.c1d_m3()).map(amplitude_m).collect()
}

fn band_amplitudes_m(psd: &ProfilePsd) -> Vec<f64> {
    let mut bands_m2 = vec![0.0; psd.len()];
    for (start, interval) in psd.intervals().enumerate() {
        let (long, short) = interval.halves();
        bands_m2[start] += long.integral(0);
        bands_m2[start + 1] += short.integral(0);
    }
    bands_m2.iter().map(|band_m2| (FRAC_2_PI * band_m2).sqrt()).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::moments::{Normalisation, cumulative_moments};

    #[test]
    fn eq5_gives_the_amplitude_and_aspect_ratio_of_the_steepest_uncd_scale() {
        // The reconstruction of the diamond spectrum is pinned to B = 0.0463 at 5.65 nm.
        let psd = ProfilePsd::from_samples(vec![5.65e-9, 4.487952e-9], vec![5.799607e-28, 3.447e-28]);
        let scale = amplitudes(&psd, AmplitudeDefinition::Eq5)[0];
        assert_relative_eq!(scale.amplitude_m, 2.615949942237998e-10, max_relative = 1e-15, epsilon = 0.0);
        assert_relative_eq!(scale.aspect_ratio(), 0.04629999897766368, max_relative = 1e-15);
    }

    #[test]
    fn the_squares_of_parseval_amplitudes_add_up_to_twice_the_variance() {
        let psd = ProfilePsd::from_samples(vec![3e-4, 1e-5, 4e-6, 2e-9], vec![1e-20, 3e-21, 5e-21, 1e-30]);
        let twice_variance_m2: f64 = amplitudes(&psd, AmplitudeDefinition::Parseval)
            .iter()
            .map(|scale| scale.amplitude_m.powi(2))
            .sum();
        let m0_m2 = cumulative_moments(&psd, Normalisation::Parseval)[2].m0_m2;
        assert_relative_eq!(twice_variance_m2 / 2.0, m0_m2, max_relative = 1e-14, epsilon = 0.0);
    }

    #[test]
    fn bands_meet_at_geometric_midpoints() {
        // A constant spectrum: the bands are differences of wavevectors.
        let psd = ProfilePsd::from_samples(vec![4.0, 1.0, 0.25], vec![1.0; 3]);
        let expected_q_rad_per_m =
            [0.5 - 0.25, 2.0 - 0.5, 4.0 - 2.0].map(|turns| turns * std::f64::consts::TAU);
        for (scale, band) in amplitudes(&psd, AmplitudeDefinition::Parseval).iter().zip(expected_q_rad_per_m)
        {
            assert_relative_eq!(scale.amplitude_m.powi(2), FRAC_2_PI * band, max_relative = 1e-14);
        }
    }
}
