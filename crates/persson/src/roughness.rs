//! A spectrum as the theory takes it: what each cutoff lets through.

use std::f64::consts::TAU;

use crate::variance::{Band, SpectrumSample, mean_square_gradients, spectral_exponents};

/// The samples of a spectrum, from long to short wavelengths, with what the theory needs at each.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    places: Vec<Place>,
}

/// One cutoff.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Place {
    /// Wavelength \[m\] as given.
    pub wavelength_m: f64,
    /// Wavevector q \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// h'^2 up to there.
    pub mean_square_gradient: f64,
    /// Nayak's alpha = m0 m4/m2^2 of profiles up to there; infinite at the first.
    pub alpha: f64,
    /// Amplitude of the scale \[m\].
    pub amplitude_m: f64,
    /// e of dV/dq ~ q^(e-1) from here to the next.
    pub variance_exponent: f64,
}

/// A sample of a spectrum with what is known of the roughness above its wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughnessSample {
    /// Wavelength > 0 \[m\].
    pub wavelength_m: f64,
    /// C1D > 0 there \[m^3\].
    pub c1d_m3: f64,
    /// m0 \[m^2\], m2 and m4 \[1/m^2\] of profiles, from the first sample up to here: 0 at the first.
    pub moments: [f64; 3],
    /// Amplitude of the scale, which a Nix-Gao hardness takes for the depth \[m\].
    pub amplitude_m: f64,
}

impl Roughness {
    /// The roughness of samples that come from long to short wavelengths. `beyond` are samples at shorter wavelengths
    /// (\[m\], \[m^3\]), which are no cutoffs but count where the surface is cut off.
    #[must_use]
    pub fn new(samples: &[RoughnessSample], beyond: &[(f64, f64)], band: Band) -> Self {
        let mut of_spectrum: Vec<SpectrumSample> = samples
            .iter()
            .map(|sample| SpectrumSample {
                wavevector_rad_per_m: TAU / sample.wavelength_m,
                c1d_m3: sample.c1d_m3,
                mean_square_slope: sample.moments[1],
            })
            .collect();
        let last_slope = of_spectrum.last().map_or(0.0, |last| last.mean_square_slope);
        of_spectrum.extend(beyond.iter().map(|&(wavelength_m, c1d_m3)| SpectrumSample {
            wavevector_rad_per_m: TAU / wavelength_m,
            c1d_m3,
            mean_square_slope: last_slope,
        }));
        let gradients = mean_square_gradients(&of_spectrum, band);
        let exponents = spectral_exponents(&of_spectrum);
        let place = |(at, sample): (usize, &RoughnessSample)| {
            let [m0, m2, m4] = sample.moments;
            Place {
                wavelength_m: sample.wavelength_m,
                wavevector_rad_per_m: TAU / sample.wavelength_m,
                mean_square_gradient: gradients[at],
                alpha: if m2 > 0.0 { (m0 / m2) * (m4 / m2) } else { f64::INFINITY },
                amplitude_m: sample.amplitude_m,
                variance_exponent: exponents.get(at).map_or(3.0, |exponent| 3.0 + exponent),
            }
        };
        Roughness { places: samples.iter().enumerate().map(place).collect() }
    }

    /// The cutoffs, from long to short wavelengths.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.places
    }
}

impl Place {
    /// Rms gradient h' of the surface up to here.
    #[must_use]
    pub fn rms_gradient(&self) -> f64 {
        self.mean_square_gradient.sqrt()
    }

    /// Variance V = E*^2 h'^2/4 \[Pa^2\] of the pressure that flattens it, under a contact modulus E* \[Pa\].
    #[must_use]
    pub fn variance_pa2(&self, contact_modulus_pa: f64) -> f64 {
        0.25 * contact_modulus_pa * contact_modulus_pa * self.mean_square_gradient
    }
}
