//! The isotropic spectrum of an area: moments, profiles, bands.

use std::f64::consts::{PI, TAU};
use std::num::NonZeroU32;

use crate::surface_waves::SurfaceWaves;
use crate::{AbelIntegral, Convention, Moments, PowerLaw, ProfilePsd, Psd};

use crate::random_surfaces::conversion::{self, Conversion};
use crate::random_surfaces::error::RandomSurfaceError;
use crate::random_surfaces::grading::before_knot;
use crate::random_surfaces::surface::profile_moments;

/// Relative excess of a band over the spectrum that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// The spectrum Ciso \[m^4\] of an isotropic surface over a band, <h^2> = (1/2 pi) Int q Ciso dq: a power law between
/// neighbouring wavevectors, and zero outside the band.
///
/// Moments, the spectrum of profiles and surfaces are exact for this piecewise power law.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaSpectrum {
    pub(crate) waves: SurfaceWaves,
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
        if let Some(waves) = profile.surface.as_deref() {
            let (longest_m, shortest_m) = (profile.longest_wavelength_m(), profile.shortest_wavelength_m());
            let whole = Self { waves: waves.clone(), conversion: Conversion::default() };
            return whole.cut(longest_m.min(waves.longest_m), shortest_m.max(waves.shortest_m));
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
        let Some(waves) = psd.surface() else {
            let factor = psd.convention().factor_to(Convention::C1D).unwrap_or(1.0);
            let c1d_m3 = psd.values().iter().map(|value| factor * value).collect();
            return Self::from_profile(&ProfilePsd::new(psd.wavelengths_m().to_vec(), c1d_m3)?);
        };
        Ok(Self { waves, conversion: Conversion::default() })
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
        Ok(Self { waves: SurfaceWaves { pieces, longest_m, shortest_m }, conversion })
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
        if longest_m > self.waves.longest_m * (1.0 + ROUNDING)
            || shortest_m < self.waves.shortest_m * (1.0 - ROUNDING)
        {
            let (spectrum_longest_m, spectrum_shortest_m) = (self.waves.longest_m, self.waves.shortest_m);
            return Err(RandomSurfaceError::BeyondSpectrum {
                longest_m,
                shortest_m,
                spectrum_longest_m,
                spectrum_shortest_m,
            });
        }
        let (longest_m, shortest_m) =
            (longest_m.min(self.waves.longest_m), shortest_m.max(self.waves.shortest_m));
        let (first, last) = (TAU / longest_m, TAU / shortest_m);
        let pieces = self.waves.pieces.iter().filter_map(|piece| piece.between(first, last)).collect();
        Self::from_pieces(pieces, longest_m, shortest_m, self.conversion)
    }

    /// Multiplies Ciso by a smooth weight above 0, a function of the wavevector \[rad/m\], such as q^4 tanh(q)^2, within 2e-4.
    #[must_use]
    pub fn weighted(&self, weight: impl Fn(f64) -> f64) -> Self {
        Self { waves: self.waves.weighted(weight), conversion: self.conversion }
    }

    /// The longest wavelength of the band \[m\].
    #[must_use]
    pub fn longest_m(&self) -> f64 {
        self.waves.longest_m
    }

    /// The shortest wavelength of the band \[m\].
    #[must_use]
    pub fn shortest_m(&self) -> f64 {
        self.waves.shortest_m
    }

    /// Smoothing and clipping that noise required in the conversion from profiles.
    #[must_use]
    pub fn conversion(&self) -> Conversion {
        self.conversion
    }

    /// Ciso \[m^4\] at a wavevector \[rad/m\].
    #[must_use]
    pub fn ciso_m4(&self, q_rad_per_m: f64) -> f64 {
        self.waves.piece_at(q_rad_per_m).map_or(0.0, |piece| piece.value_at(q_rad_per_m))
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
        let (mut pieces, mut sum) = (self.waves.pieces.iter().peekable(), 0.0);
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
        profile_moments(self.waves.shortest_m, mean_squares)
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
        let integral = AbelIntegral::new(self.waves.pieces.iter().map(integrand));
        let c1d_m3: Vec<f64> =
            wavelengths_m.iter().map(|wavelength_m| integral.from(TAU / wavelength_m)).collect();
        if let Some(row) = c1d_m3.iter().position(|&c1d_m3| c1d_m3 == 0.0) {
            let (wavelength_m, shortest_m) = (wavelengths_m[row], self.waves.shortest_m);
            return Err(RandomSurfaceError::NoWaves { wavelength_m, shortest_m });
        }
        Ok(ProfilePsd::new(wavelengths_m.to_vec(), c1d_m3)?.with_surface(self.waves.clone()))
    }

    /// Wavelengths \[m\] for sampling [`AreaSpectrum::profile`]: `per_decade` per decade, starting at `longest_m` if
    /// that lies above the band, and denser before both ends of the band, where C1D behaves like a square root.
    ///
    /// With 20 per decade from 100 times the longest wavelength of the band, the moments of the profile agree with
    /// those of the surface within 0.2 % in slopes, 0.5 % in curvatures and 1 % in heights (still longer waves are
    /// missing).
    #[must_use]
    pub fn profile_wavelengths_m(&self, longest_m: f64, per_decade: NonZeroU32) -> Vec<f64> {
        let (first, last) = (TAU / self.waves.longest_m, TAU / self.waves.shortest_m);
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
        if longest_m > self.waves.longest_m {
            up_to_knot(TAU / longest_m, first);
        }
        up_to_knot(first, last);
        wavevectors.into_iter().map(|q_rad_per_m| TAU / q_rad_per_m).collect()
    }

    fn mean_square(&self, k: i32) -> f64 {
        self.waves.pieces.iter().map(|piece| piece.integral(k)).sum::<f64>() / TAU
    }
}
