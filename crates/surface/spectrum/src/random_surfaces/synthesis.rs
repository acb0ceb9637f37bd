//! Random surfaces with a given spectrum.

use std::f64::consts::TAU;

use numerics::transforms::Complex64;
use serde::{Deserialize, Serialize};
use units::{Bound, named};

use crate::random_surfaces::area_spectrum::AreaSpectrum;
use crate::random_surfaces::error::RandomSurfaceError;
use crate::random_surfaces::fourier::HalfSpectrum;
use crate::random_surfaces::modes::{Draw, Draws};
use crate::random_surfaces::surface::{RandomSurface, profile_moments};

/// Relative distance outside the band that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Randomness of a surface: phases alone, or phases and moduli.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Phases {
    /// Random phases; every wave has the amplitude of the spectrum, so that each surface has the variance and slope of
    /// the spectrum.
    #[default]
    FixedModulus,
    /// Random phases and moduli: heights are a Gaussian process, and variance and slope scatter between surfaces.
    Gaussian,
}

named!(Phases, "phases", { FixedModulus => "fixed-modulus", Gaussian => "gaussian" });

/// A periodic grid with the seed of the surfaces on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Synthesis {
    /// Points along x, the columns.
    pub points_x: usize,
    /// Points along y, the rows.
    pub points_y: usize,
    /// Length along x \[m\].
    pub length_x_m: f64,
    /// Length along y \[m\].
    pub length_y_m: f64,
    /// The seed; it gives the same surfaces on every grid over the same lengths.
    pub seed: u64,
    /// Randomness of phases and moduli.
    pub phases: Phases,
}

impl Synthesis {
    /// Describes a square grid of `points` points and `length_m` \[m\] a side.
    #[must_use]
    pub fn square(points: usize, length_m: f64, seed: u64, phases: Phases) -> Self {
        Self { points_x: points, points_y: points, length_x_m: length_m, length_y_m: length_m, seed, phases }
    }
}

impl AreaSpectrum {
    /// Makes the surface of a seed and a realisation: the sum of all waves of the box within the band, a ring in the
    /// plane of wavevectors, sampled at the points of the grid.
    ///
    /// A wave with the wavevector q has the mean square amplitude Ciso(q)/(L_x L_y), so that <h^2> approaches
    /// (1/2 pi) Int q Ciso dq in a large box (Jacobs, Junge & Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5:013001,
    /// section 2).
    ///
    /// Random numbers belong to the wave, so the surface is the same on every grid that holds the band. They are words
    /// of a stream of ChaCha with 8 rounds. Its key is the seed and the realisation (eight bytes each, the lowest
    /// first) and the sixteen bytes `truearea surface`; its nonce of 64 bits is the row of the wave, 2 n for n >= 0 and
    /// -2 n - 1 below. The wave exp(i (2 pi m x/L_x + 2 pi n y/L_y)), m > 0 or m = 0 < n, has the words 4 m to 4 m + 3:
    /// two numbers of 64 bits, the lower half first. The upper 53 bits of each are a number in [0, 1). The first is the
    /// phase in turns; from the second, u, a random modulus is sqrt(-ln(1 - u)) times the mean one.
    ///
    /// # Errors
    /// [`RandomSurfaceError::BandTooWide`] if a side is shorter than the longest wavelength or has fewer than two points per
    /// shortest wavelength; [`RandomSurfaceError::NoModes`] if no wave of the box lies in the band; [`RandomSurfaceError::Bounds`]
    /// for lengths that are not finite and above 0; [`RandomSurfaceError::Points`] for no points or more than `u32::MAX`.
    pub fn surface(
        &self,
        synthesis: &Synthesis,
        realisation: u64,
    ) -> Result<RandomSurface, RandomSurfaceError> {
        let Synthesis { points_x, points_y, length_x_m, length_y_m, seed, phases } = *synthesis;
        self.check(synthesis)?;
        let waves = Waves::new(self, length_x_m, length_y_m);
        let draws = Draws::new(seed, realisation);
        let mut spectrum = HalfSpectrum::new(points_y, points_x);
        let mut sums = [0.0; 3];
        for n in waves.rows() {
            let mut of_row = [0.0; 3];
            let columns = waves.columns(n);
            for (m, draw) in columns.clone().zip(draws.row(n, columns.start)) {
                let q_rad_per_m = waves.wavevector(m, n);
                if !waves.holds(q_rad_per_m) {
                    continue;
                }
                let amplitude = waves.amplitude(q_rad_per_m, &draw, phases);
                let square_m2 = 2.0 * amplitude.norm_sqr();
                let q2 = q_rad_per_m * q_rad_per_m;
                of_row = [of_row[0] + square_m2, of_row[1] + q2 * square_m2, of_row[2] + q2 * q2 * square_m2];
                spectrum.add(m, n, amplitude);
            }
            sums = std::array::from_fn(|i| sums[i] + of_row[i]);
        }
        if sums[0] == 0.0 {
            let (longest_m, shortest_m) = (self.longest_m(), self.shortest_m());
            return Err(RandomSurfaceError::NoModes { longest_m, shortest_m, length_x_m, length_y_m });
        }
        let moments = profile_moments(self.shortest_m(), sums);
        Ok(RandomSurface { points_x, points_y, length_x_m, length_y_m, heights_m: spectrum.sum(), moments })
    }

    fn check(&self, synthesis: &Synthesis) -> Result<(), RandomSurfaceError> {
        let Synthesis { points_x, points_y, length_x_m, length_y_m, .. } = *synthesis;
        if points_x.checked_mul(points_y).is_none_or(|points| points == 0 || points > u32::MAX as usize) {
            return Err(RandomSurfaceError::Points { points_x, points_y });
        }
        for (points, length_m, name) in [
            (points_x, length_x_m, "the length of the box along x in m"),
            (points_y, length_y_m, "the length of the box along y in m"),
        ] {
            Bound::Magnitude.check(name, length_m)?;
            let (longest_m, shortest_m) = (self.longest_m(), self.shortest_m());
            let points_per_shortest = shortest_m / length_m * points as f64;
            if longest_m > length_m * (1.0 + ROUNDING) || points_per_shortest < 2.0 * (1.0 - ROUNDING) {
                return Err(RandomSurfaceError::BandTooWide { longest_m, shortest_m, points, length_m });
            }
        }
        Ok(())
    }
}

/// The waves of a box within the band of a spectrum.
struct Waves<'s> {
    spectrum: &'s AreaSpectrum,
    /// The wavevectors of the longest waves along x and y \[rad/m\].
    step_x: f64,
    step_y: f64,
    /// The ends of the band \[rad/m\].
    first: f64,
    last: f64,
    area_m2: f64,
}

impl<'s> Waves<'s> {
    fn new(spectrum: &'s AreaSpectrum, length_x_m: f64, length_y_m: f64) -> Self {
        Self {
            spectrum,
            step_x: TAU / length_x_m,
            step_y: TAU / length_y_m,
            first: TAU / spectrum.longest_m(),
            last: TAU / spectrum.shortest_m(),
            area_m2: length_x_m * length_y_m,
        }
    }

    /// Wavenumbers along y in ascending order.
    fn rows(&self) -> impl Iterator<Item = i64> {
        let highest = (self.last * (1.0 + ROUNDING) / self.step_y).floor() as i64;
        -highest..=highest
    }

    /// Wavenumbers along x that may lie in the band, for one half of the plane; the other half is its conjugate.
    fn columns(&self, n: i64) -> std::ops::Range<usize> {
        let along_y = (n as f64 * self.step_y).abs();
        let end = |q: f64| (q * q - along_y * along_y).max(0.0).sqrt() / self.step_x;
        // One more on either side, because the ends are rounded; `holds` decides for each wave.
        let least = (end(self.first).floor() as usize).saturating_sub(1).max(usize::from(n <= 0));
        least..end(self.last).ceil() as usize + 1
    }

    /// The length of a wavevector \[rad/m\].
    fn wavevector(&self, m: usize, n: i64) -> f64 {
        libm::hypot(m as f64 * self.step_x, n as f64 * self.step_y)
    }

    fn holds(&self, q_rad_per_m: f64) -> bool {
        (self.first * (1.0 - ROUNDING)..=self.last * (1.0 + ROUNDING)).contains(&q_rad_per_m)
    }

    fn amplitude(&self, q_rad_per_m: f64, draw: &Draw, phases: Phases) -> Complex64 {
        let mean_square_m2 = self.spectrum.ciso_m4(q_rad_per_m.clamp(self.first, self.last)) / self.area_m2;
        let share = match phases {
            Phases::FixedModulus => 1.0,
            Phases::Gaussian => -libm::log1p(-draw.share),
        };
        let (sine, cosine) = libm::sincos(TAU * draw.turn);
        Complex64::new(cosine, sine) * (mean_square_m2 * share).sqrt()
    }
}
