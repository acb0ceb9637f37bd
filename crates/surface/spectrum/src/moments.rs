//! Spectral moments against the short-wavelength cutoff.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use crate::approximate::approximate;
use crate::interval::Interval;
use crate::profile::ProfilePsd;
use units::named;

/// The factor before the integral of a spectral moment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    /// 1/pi; m0 is then the variance of the heights (Parseval's theorem for C1D).
    #[default]
    Parseval,
    /// 1, as printed in Jackson & Jacobs, Eq. (1): rms height and slope come out sqrt(pi) times too large.
    AsPrinted,
}

named!(Normalisation, "normalisation", { Parseval => "parseval", AsPrinted => "as-printed" });

impl Normalisation {
    /// Returns the dimensionless factor.
    pub const fn factor(self) -> f64 {
        match self {
            Self::Parseval => 1.0 / PI,
            Self::AsPrinted => 1.0,
        }
    }
}

/// The moments m_k = norm x Int q^k C1D dq from the longest wavelength of the spectrum down to a cutoff.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Moments {
    /// The cutoff: the shortest wavelength included, in m.
    pub wavelength_m: f64,
    /// Variance of the heights in m^2.
    pub m0_m2: f64,
    /// Variance of the slopes along a profile, dimensionless.
    pub m2: f64,
    /// Variance of the second derivatives along a profile, in 1/m^2.
    pub m4_per_m2: f64,
}

approximate!(Moments { wavelength_m, m0_m2, m2, m4_per_m2 });

impl Moments {
    /// Root mean square height in m.
    pub fn rms_height_m(&self) -> f64 {
        self.m0_m2.sqrt()
    }

    /// Root mean square slope of a profile: Jackson & Jacobs, Eq. (2).
    pub fn rms_slope(&self) -> f64 {
        self.m2.sqrt()
    }

    /// Root mean square gradient of an isotropic surface, sqrt(2) times the slope of its profiles.
    pub fn rms_gradient(&self) -> f64 {
        (2.0 * self.m2).sqrt()
    }
}

/// Computes the moments for every cutoff from the second sampled wavelength on, one entry fewer than samples.
///
/// Jackson & Jacobs, Eq. (1), exact for a spectrum that is a power law between its samples.
pub fn cumulative_moments(psd: &ProfilePsd, normalisation: Normalisation) -> Vec<Moments> {
    accumulate(psd.intervals(), normalisation)
}

/// Computes the moments for every sampled cutoff above `cutoff_wavelength_m` \[m\] and, last, for that cutoff itself.
///
/// Empty if the cutoff is not below the longest wavelength. A cutoff below the shortest wavelength ends at the
/// shortest, because the spectrum holds nothing beyond it.
pub fn cumulative_moments_to(
    psd: &ProfilePsd,
    normalisation: Normalisation,
    cutoff_wavelength_m: f64,
) -> Vec<Moments> {
    accumulate(psd.intervals().map_while(|interval| interval.down_to(cutoff_wavelength_m)), normalisation)
}

/// Computes Int C1D dq \[m^2\] and Int q^2 C1D dq between each two neighbouring samples, from long to short wavelengths.
pub fn interval_integrals(psd: &ProfilePsd) -> Vec<[f64; 2]> {
    psd.intervals().map(|interval| [interval.integral(0), interval.integral(2)]).collect()
}

fn accumulate(intervals: impl Iterator<Item = Interval>, normalisation: Normalisation) -> Vec<Moments> {
    let norm = normalisation.factor();
    let mut sums = [CompensatedSum::default(); 3];
    intervals
        .map(|interval| {
            let [m0_m2, m2, m4_per_m2] =
                [0, 2, 4].map(|k| norm * sums[k / 2].add(interval.integral(k as i32)));
            Moments { wavelength_m: interval.end_wavelength_m(), m0_m2, m2, m4_per_m2 }
        })
        .collect()
}

/// Neumaier's compensated sum; its error does not grow with the number of terms.
#[derive(Clone, Copy, Default)]
struct CompensatedSum {
    sum: f64,
    compensation: f64,
}

impl CompensatedSum {
    /// Adds a term and returns the sum so far.
    fn add(&mut self, term: f64) -> f64 {
        let sum = self.sum + term;
        self.compensation +=
            if self.sum.abs() >= term.abs() { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
        sum + self.compensation
    }
}
