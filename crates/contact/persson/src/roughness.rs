//! Input of the theory: moments and gradients of the roughness up to each cutoff.

use std::f64::consts::TAU;

use asperity::LayerCompliance;

use crate::layered::mean_square_stiffening;
use crate::stretch::share_of_power_law;

/// Samples of a spectrum, from long to short wavelengths, with the derived quantities that the theory needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    places: Vec<Place>,
    /// Displacement of a layer under waves, if one of the bodies is a layer.
    pub(crate) layer: Option<LayerCompliance>,
    /// True if a cutoff cuts the surface, false if it cuts the spectrum of profiles.
    pub(crate) is_of_surface: bool,
}

/// Roughness up to one cutoff.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Place {
    /// Wavelength \[m\] as given.
    pub wavelength_m: f64,
    /// Wavevector q \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Mean square gradient h'^2 of the surface up to q.
    pub mean_square_gradient: f64,
    /// Moments m0 \[m^2\], m2 and m4 \[1/m^2\] of profiles up to q.
    pub moments: [f64; 3],
    /// Nayak's alpha = m0 m4/m2^2 of profiles up to q; infinite at the first place.
    pub alpha: f64,
    /// Amplitude of the scale \[m\].
    pub amplitude_m: f64,
    /// Exponent e of dV/dq ~ q^(e-1) between here and the next place.
    pub variance_exponent: f64,
    /// Exponent e of dh'^2/dq ~ q^(e-1) between here and the next place; on a layer V has another one.
    gradient_exponent: f64,
    /// Mean square gradient up to q, each wave times (E*(q)/E*)^2: what V is made of. On a half-space it is the plain one.
    stiffened_gradient: f64,
}

/// Sample of a spectrum with the moments of the roughness above its wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughnessSample {
    /// Wavelength > 0 \[m\].
    pub wavelength_m: f64,
    /// Spectral density C1D > 0 at the wavelength \[m^3\].
    pub c1d_m3: f64,
    /// Moments m0 \[m^2\], m2 and m4 \[1/m^2\] of profiles from the first sample up to here; 0 at the first.
    pub moments: [f64; 3],
    /// Amplitude of the scale, the depth of a Nix-Gao hardness \[m\].
    pub amplitude_m: f64,
}

impl Roughness {
    /// Creates the roughness from samples that go from long to short wavelengths. If a cutoff cuts the surface, `of_surface` are
    /// the mean square gradients of its waves from the first sample to each of them; otherwise those of profiles count, 2 m2.
    ///
    /// # Panics
    /// If there are fewer gradients than samples.
    #[must_use]
    pub fn new(samples: &[RoughnessSample], of_surface: Option<&[f64]>) -> Self {
        let exponent = |pair: &[RoughnessSample]| {
            (pair[1].c1d_m3 / pair[0].c1d_m3).ln() / (pair[0].wavelength_m / pair[1].wavelength_m).ln()
        };
        let exponents: Vec<f64> = samples.windows(2).map(exponent).collect();
        let gradient_exponent =
            |at: usize| exponents.get(at).or(exponents.last()).map_or(3.0, |exponent| 3.0 + exponent);
        let place = |(at, sample): (usize, &RoughnessSample)| {
            let mean_square_gradient =
                of_surface.map_or(2.0 * sample.moments[1], |mean_squares| mean_squares[at]);
            Place {
                wavelength_m: sample.wavelength_m,
                wavevector_rad_per_m: TAU / sample.wavelength_m,
                mean_square_gradient,
                moments: sample.moments,
                alpha: nayak(sample.moments),
                amplitude_m: sample.amplitude_m,
                variance_exponent: gradient_exponent(at),
                gradient_exponent: gradient_exponent(at),
                stiffened_gradient: mean_square_gradient,
            }
        };
        Roughness {
            places: samples.iter().enumerate().map(place).collect(),
            layer: None,
            is_of_surface: of_surface.is_some(),
        }
    }

    /// Returns the roughness between bodies one of which is a layer: flattening a wave takes E*(q) in place of E*, so that
    /// dV = E*(q)^2 dh'^2/4 and mean gap and stiffness take dv/(q E*(q)). Gradients and moments stay those of the surface.
    #[must_use]
    pub fn on_layer(mut self, layer: LayerCompliance) -> Self {
        let mut stiffened = 0.0;
        for at in 1..self.places.len() {
            let (start, end) = (self.places[at - 1], self.places[at]);
            let wavevectors = [start, end].map(|place| place.wavevector_rad_per_m);
            let (mean_square, grown) = mean_square_stiffening(&layer, wavevectors, start.gradient_exponent);
            self.places[at - 1].variance_exponent = start.gradient_exponent + grown;
            stiffened += mean_square * (end.mean_square_gradient - start.mean_square_gradient);
            self.places[at].stiffened_gradient = stiffened;
        }
        self.layer = Some(layer);
        self
    }

    /// Returns the roughness with one wave more, longer than all others: a straight wave of a mean square height \[m^2\], in a narrow
    /// band that ends at its wavelength \[m\]. `None` if the roughness has waves as long, or none.
    #[must_use]
    pub fn with_long_wave(&self, wavelength_m: f64, mean_square_height_m2: f64) -> Option<Self> {
        /// Relative width of the band.
        const WIDTH: f64 = 1e-3;
        let first = self.places.first()?;
        let q = TAU / wavelength_m;
        if q * (1.0 + WIDTH) > first.wavevector_rad_per_m {
            return None;
        }
        // Profiles of an isotropic surface have half of its mean square gradient, and 3/8 of q^4 v.
        let moments = [1.0, 0.5 * q * q, 0.375 * q.powi(4)].map(|per_m2| per_m2 * mean_square_height_m2);
        let relative = self.layer.map_or(1.0, |layer| layer.relative_at(q));
        let mean_square_gradient = q * q * mean_square_height_m2;
        let stiffened_gradient = mean_square_gradient / (relative * relative);
        let begun = Place {
            wavelength_m: wavelength_m * (1.0 + WIDTH),
            wavevector_rad_per_m: q / (1.0 + WIDTH),
            mean_square_gradient: 0.0,
            moments: [0.0; 3],
            alpha: f64::INFINITY,
            amplitude_m: (2.0 * mean_square_height_m2).sqrt(),
            variance_exponent: 3.0,
            gradient_exponent: 3.0,
            stiffened_gradient: 0.0,
        };
        let ended = Place {
            wavelength_m,
            wavevector_rad_per_m: q,
            mean_square_gradient,
            moments,
            alpha: nayak(moments),
            stiffened_gradient,
            ..begun
        };
        let behind = self.places.iter().map(|place| {
            let moments = [0, 1, 2].map(|at| place.moments[at] + moments[at]);
            Place {
                moments,
                alpha: nayak(moments),
                mean_square_gradient: place.mean_square_gradient + mean_square_gradient,
                stiffened_gradient: place.stiffened_gradient + stiffened_gradient,
                ..*place
            }
        });
        Some(Roughness { places: [begun, ended].into_iter().chain(behind).collect(), ..self.clone() })
    }

    /// Cutoffs, from long to short wavelengths.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.places
    }
}

impl Roughness {
    /// Nayak's alpha of profiles up to a wavevector \[rad/m\] between two places, and dln(alpha)/dln(q). Outside of
    /// the places it is the constant value of the nearest one.
    pub(crate) fn alpha_at(&self, wavevector_rad_per_m: f64) -> [f64; 2] {
        let begun = self.places.partition_point(|place| place.wavevector_rad_per_m <= wavevector_rad_per_m);
        let pair = begun.checked_sub(1).and_then(|at| self.places.get(at..at + 2));
        let Some([start, end]) = pair else {
            let nearest = if begun == 0 { self.places.first() } else { self.places.last() };
            return [nearest.map_or(f64::INFINITY, |place| place.alpha), 0.0];
        };
        let ln_q = |to_rad_per_m: f64| (to_rad_per_m / start.wavevector_rad_per_m).ln();
        let (part_ln, whole_ln) = (ln_q(wavevector_rad_per_m), ln_q(end.wavevector_rad_per_m));
        // The moments grow by q^(k + exponent of C1D), the mean square gradient like m2.
        let grown = |at: usize, power: f64| {
            let [share, slope] = share_of_power_law(start.gradient_exponent + power, part_ln, whole_ln);
            let rise = end.moments[at] - start.moments[at];
            let moment = start.moments[at] + share * rise;
            (moment, if moment > 0.0 { slope * rise / moment } else { 0.0 })
        };
        let [(m0, m0_slope), (m2, m2_slope), (m4, m4_slope)] = [grown(0, -2.0), grown(1, 0.0), grown(2, 2.0)];
        [nayak([m0, m2, m4]), m0_slope + m4_slope - 2.0 * m2_slope]
    }
}

/// Computes m0 m4/m2^2.
fn nayak([m0, m2, m4]: [f64; 3]) -> f64 {
    if m2 > 0.0 { (m0 / m2) * (m4 / m2) } else { f64::INFINITY }
}

impl Place {
    /// Rms gradient h' of the surface up to this place.
    #[must_use]
    pub fn rms_gradient(&self) -> f64 {
        self.mean_square_gradient.sqrt()
    }

    /// Variance V = E*^2 h'^2/4 \[Pa^2\] of the pressure that flattens this roughness, under a contact modulus E*
    /// \[Pa\]; on a layer each wave counts with E*(q).
    #[must_use]
    pub fn variance_pa2(&self, contact_modulus_pa: f64) -> f64 {
        0.25 * contact_modulus_pa * contact_modulus_pa * self.stiffened_gradient
    }
}
