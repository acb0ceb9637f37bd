//! The isotropic spectrum of an area: moments, profiles, bands.

use std::f64::consts::{PI, TAU};
use std::num::NonZeroU32;

use crate::{AbelIntegral, Convention, ConversionError, Moments, PowerLaw, ProfilePsd, Psd};

use crate::random_surfaces::conversion::{self, Conversion};
use crate::random_surfaces::error::RandomSurfaceError;
use crate::random_surfaces::grading::before_knot;
use crate::random_surfaces::surface::profile_moments;

/// Relative excess of a band over the spectrum that counts as rounding.
const ROUNDING: f64 = 1e-9;
/// Most growth of the wavevector over a piece of a weighted spectrum.
const MOST_GROWTH: f64 = 1.03;

/// The spectrum Ciso \[m^4\] of an isotropic surface over a band, <h^2> = (1/2 pi) Int q Ciso dq: a power law between
/// neighbouring wavevectors, and zero outside the band.
///
/// Moments, the spectrum of profiles and surfaces are exact for this piecewise power law.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaSpectrum {
    /// Pieces by rising wavevector, without overlaps; between two that do not touch there is no roughness.
    pieces: Vec<PowerLaw>,
    longest_m: f64,
    shortest_m: f64,
    conversion: Conversion,
}

impl AreaSpectrum {
    /// Converts the spectrum of profiles to that of their surface, Ciso(q) = -2 Int_q^inf C1D'(p) (p^2 - q^2)^(-1/2) dp
    /// (the inverse of Jacobs, Junge & Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5:013001, Eq. 2.17). A surface that is
    /// known, as that of a table of areas, is taken as it is.
    ///
    /// C1D is continued above its last sample with its last slope (at least as steep as 1/q), because profiles of a surface have
    /// no sharp cutoff; Ciso covers the wavevectors of the samples, and between two it has their heights and gradient. Rises of
    /// C1D that would make Ciso negative are levelled, see [`AreaSpectrum::conversion`].
    ///
    /// # Errors
    /// [`RandomSurfaceError::TooFewSamples`] for a single sample; [`RandomSurfaceError::EmptyBand`] if a known surface lacks the
    /// band.
    pub fn from_profile(profile: &ProfilePsd) -> Result<Self, RandomSurfaceError> {
        if let Some(surface) = profile.surface() {
            let (longest_m, shortest_m) = (profile.longest_wavelength_m(), profile.shortest_wavelength_m());
            return surface.cut(longest_m.min(surface.longest_m), shortest_m.max(surface.shortest_m));
        }
        let (pieces, conversion) = conversion::of_profile(profile)?;
        let (longest_m, shortest_m) = (profile.longest_wavelength_m(), profile.shortest_wavelength_m());
        Self::from_pieces(pieces, longest_m, shortest_m, conversion)
    }

    /// Builds the spectrum from samples in any convention. Samples of areas are joined by power laws; samples of
    /// profiles are converted by [`AreaSpectrum::from_profile`].
    ///
    /// # Errors
    /// As [`AreaSpectrum::from_profile`].
    pub fn from_psd(psd: &Psd) -> Result<Self, RandomSurfaceError> {
        // A factor exists only among conventions of areas, or among those of profiles.
        let factor: Result<f64, ConversionError> = psd.convention().factor_to(Convention::Ciso);
        let Ok(factor) = factor else {
            let factor = psd.convention().factor_to(Convention::C1D).unwrap_or(1.0);
            let c1d_m3 = psd.values().iter().map(|value| factor * value).collect();
            return Self::from_profile(&ProfilePsd::new(psd.wavelengths_m().to_vec(), c1d_m3)?);
        };
        let points = psd.wavelengths_m().iter().zip(psd.values());
        let points: Vec<(f64, f64)> =
            points.map(|(wavelength_m, value)| (TAU / wavelength_m, factor * value)).collect();
        let pieces = points.windows(2).map(|pair| PowerLaw::through(pair[0], pair[1])).collect();
        let (longest_m, shortest_m) = (psd.wavelengths_m()[0], psd.wavelengths_m()[psd.len() - 1]);
        Self::from_pieces(pieces, longest_m, shortest_m, Conversion::default())
    }

    /// Builds the spectrum from pieces by rising wavevector within the band, at least one.
    pub(crate) fn from_pieces(
        pieces: Vec<PowerLaw>,
        longest_m: f64,
        shortest_m: f64,
        conversion: Conversion,
    ) -> Result<Self, RandomSurfaceError> {
        if pieces.is_empty() {
            return Err(RandomSurfaceError::EmptyBand { longest_m, shortest_m });
        }
        Ok(Self { pieces, longest_m, shortest_m, conversion })
    }

    /// Cuts the spectrum to the band from a longest to a shortest wavelength \[m\]; Ciso is zero outside.
    ///
    /// # Errors
    /// [`RandomSurfaceError::BeyondSpectrum`] if the band extends beyond the spectrum, [`RandomSurfaceError::EmptyBand`] if no
    /// roughness is left.
    pub fn cut(&self, longest_m: f64, shortest_m: f64) -> Result<Self, RandomSurfaceError> {
        if longest_m.is_nan() || shortest_m.is_nan() || longest_m <= shortest_m {
            return Err(RandomSurfaceError::EmptyBand { longest_m, shortest_m });
        }
        if longest_m > self.longest_m * (1.0 + ROUNDING) || shortest_m < self.shortest_m * (1.0 - ROUNDING) {
            let (spectrum_longest_m, spectrum_shortest_m) = (self.longest_m, self.shortest_m);
            return Err(RandomSurfaceError::BeyondSpectrum {
                longest_m,
                shortest_m,
                spectrum_longest_m,
                spectrum_shortest_m,
            });
        }
        let (longest_m, shortest_m) = (longest_m.min(self.longest_m), shortest_m.max(self.shortest_m));
        let (first, last) = (TAU / longest_m, TAU / shortest_m);
        let pieces = self.pieces.iter().filter_map(|piece| piece.between(first, last)).collect();
        Self::from_pieces(pieces, longest_m, shortest_m, self.conversion)
    }

    /// Multiplies Ciso by a smooth weight above 0, a function of the wavevector \[rad/m\].
    ///
    /// Pieces are divided so that the wavevector grows by at most 3 % over each, with power laws between their ends: a weight
    /// such as q^4 tanh(q)^2 is met within 2e-4.
    #[must_use]
    pub fn weighted(&self, weight: impl Fn(f64) -> f64) -> Self {
        let value = |piece: &PowerLaw, q_rad_per_m: f64| {
            (q_rad_per_m, piece.value_at(q_rad_per_m) * weight(q_rad_per_m))
        };
        let divided = |piece: &PowerLaw| {
            let growth = piece.end_rad_per_m / piece.start_rad_per_m;
            let parts = (growth.ln() / MOST_GROWTH.ln()).ceil().max(1.0);
            let ends = (0..=parts as usize).map(|at| match at as f64 / parts {
                1.0 => piece.end_rad_per_m,
                share => piece.start_rad_per_m * growth.powf(share),
            });
            let points: Vec<(f64, f64)> = ends.map(|q_rad_per_m| value(piece, q_rad_per_m)).collect();
            points.windows(2).map(|pair| PowerLaw::through(pair[0], pair[1])).collect::<Vec<_>>()
        };
        Self { pieces: self.pieces.iter().flat_map(divided).collect(), ..*self }
    }

    /// The longest wavelength of the band \[m\].
    #[must_use]
    pub fn longest_m(&self) -> f64 {
        self.longest_m
    }

    /// The shortest wavelength of the band \[m\].
    #[must_use]
    pub fn shortest_m(&self) -> f64 {
        self.shortest_m
    }

    /// Smoothing and clipping that noise required in the conversion from profiles.
    #[must_use]
    pub fn conversion(&self) -> Conversion {
        self.conversion
    }

    /// Ciso \[m^4\] at a wavevector \[rad/m\].
    #[must_use]
    pub fn ciso_m4(&self, q_rad_per_m: f64) -> f64 {
        let at = self.pieces.partition_point(|piece| piece.end_rad_per_m < q_rad_per_m);
        match self.pieces.get(at) {
            Some(piece) if piece.start_rad_per_m <= q_rad_per_m => piece.value_at(q_rad_per_m),
            _ => 0.0,
        }
    }

    /// Variance of the heights \[m^2\], (1/2 pi) Int q Ciso dq.
    #[must_use]
    pub fn mean_square_height_m2(&self) -> f64 {
        self.mean_square(1)
    }

    /// Mean square of the gradient, h'^2 = (1/2 pi) Int q^3 Ciso dq.
    #[must_use]
    pub fn mean_square_gradient(&self) -> f64 {
        self.mean_square(3)
    }

    /// Mean square gradients of the waves down to each of some wavelengths \[m\], which run from long to short.
    #[must_use]
    pub fn mean_square_gradients(&self, wavelengths_m: &[f64]) -> Vec<f64> {
        let (mut pieces, mut sum) = (self.pieces.iter().peekable(), 0.0);
        let down_to = |wavelength_m: &f64| {
            // The rounding of a wavevector must not cut a piece that ends with it.
            let last = TAU / wavelength_m * (1.0 + ROUNDING);
            while let Some(piece) = pieces.next_if(|piece| piece.end_rad_per_m <= last) {
                sum += piece.integral(3);
            }
            let part = pieces.peek().and_then(|piece| piece.between(0.0, TAU / wavelength_m));
            (sum + part.map_or(0.0, |part| part.integral(3))) / TAU
        };
        wavelengths_m.iter().map(down_to).collect()
    }

    /// Mean square of the Laplacian \[1/m^2\], (1/2 pi) Int q^5 Ciso dq.
    #[must_use]
    pub fn mean_square_laplacian_per_m2(&self) -> f64 {
        self.mean_square(5)
    }

    /// Moments of the profiles of the surface: m0 = <h^2>, m2 = <|grad h|^2>/2 and m4 = (3/8) <(lap h)^2>; the factors
    /// are the means of cos^2 and cos^4 over all directions (Nayak 1971, J. Lubr. Technol. 93:398).
    #[must_use]
    pub fn moments(&self) -> Moments {
        let mean_squares =
            [self.mean_square_height_m2(), self.mean_square_gradient(), self.mean_square_laplacian_per_m2()];
        profile_moments(self.shortest_m, mean_squares)
    }

    /// Computes the spectrum of profiles of the surface, C1D(q) = (1/pi) Int_q^inf p Ciso(p) (p^2 - q^2)^(-1/2) dp
    /// (Jacobs, Junge & Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5:013001).
    ///
    /// The wavelengths \[m\] run from long to short, all above the shortest of the band. A profile crosses waves at a
    /// slant, so it also has waves longer than the longest of the band; its spectrum is level there.
    ///
    /// # Errors
    /// [`RandomSurfaceError::NoWaves`] for a wavelength at which C1D is zero; [`RandomSurfaceError::Samples`] for wavelengths that
    /// are not those of a spectrum.
    pub fn profile(&self, wavelengths_m: &[f64]) -> Result<ProfilePsd, RandomSurfaceError> {
        let integrand = |piece: &PowerLaw| PowerLaw {
            at_start: piece.at_start * piece.start_rad_per_m / PI,
            exponent: piece.exponent + 1.0,
            ..*piece
        };
        let integral = AbelIntegral::new(self.pieces.iter().map(integrand));
        let c1d_m3: Vec<f64> =
            wavelengths_m.iter().map(|wavelength_m| integral.from(TAU / wavelength_m)).collect();
        if let Some(row) = c1d_m3.iter().position(|&c1d_m3| c1d_m3 == 0.0) {
            let (wavelength_m, shortest_m) = (wavelengths_m[row], self.shortest_m);
            return Err(RandomSurfaceError::NoWaves { wavelength_m, shortest_m });
        }
        Ok(ProfilePsd::new(wavelengths_m.to_vec(), c1d_m3)?.with_surface(self.clone()))
    }

    /// Wavelengths \[m\] for sampling [`AreaSpectrum::profile`]: `per_decade` per decade, starting at `longest_m` if
    /// that lies above the band, and denser before both ends of the band, where C1D behaves like a square root.
    ///
    /// With 20 per decade from 100 times the longest wavelength of the band, the moments of the profile agree with
    /// those of the surface within 0.2 % in slopes, 0.5 % in curvatures and 1 % in heights (still longer waves are
    /// missing).
    #[must_use]
    pub fn profile_wavelengths_m(&self, longest_m: f64, per_decade: NonZeroU32) -> Vec<f64> {
        let (first, last) = (TAU / self.longest_m, TAU / self.shortest_m);
        let step = 10f64.ln() / f64::from(per_decade.get());
        let mut wavevectors = Vec::new();
        let mut up_to_knot = |from: f64, to: f64| {
            let closing_up = (to * (-1f64).exp()).max(from);
            let steps = ((closing_up / from).ln() / step).ceil();
            let at = |share: f64| from * (closing_up / from).powf(share);
            wavevectors.extend((0..steps as u32).map(|count| at(f64::from(count) / steps)));
            wavevectors.push(closing_up);
            wavevectors.extend(before_knot(closing_up, to, step));
        };
        if longest_m > self.longest_m {
            up_to_knot(TAU / longest_m, first);
        }
        up_to_knot(first, last);
        wavevectors.into_iter().map(|q_rad_per_m| TAU / q_rad_per_m).collect()
    }

    fn mean_square(&self, k: i32) -> f64 {
        self.pieces.iter().map(|piece| piece.integral(k)).sum::<f64>() / TAU
    }
}
