//! Correlations for surfaces with plastic contact: Cooper, Mikic & Yovanovich (1969), Int. J. Heat Mass Transfer
//! 12:279; Yovanovich (1982), Prog. Astronaut. Aeronaut. 83:83.
//!
//! h_c = c k_s (m/sigma) (P/H)^n, with m the mean absolute slope and sigma the rms height of the two surfaces together.

use std::f64::consts::FRAC_2_PI;

use serde::{Deserialize, Serialize};
use units::{Bound, OutOfBounds, named};

use super::Conductivities;

/// Correlation by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum PlasticCorrelation {
    /// Cooper, Mikic & Yovanovich (1969): c = 1.45, n = 0.985.
    CooperMikicYovanovich,
    /// Yovanovich (1982), the one in handbooks: c = 1.25, n = 0.95.
    Yovanovich,
}

named!(PlasticCorrelation, "correlation", {
    CooperMikicYovanovich => "cooper-mikic-yovanovich",
    Yovanovich => "yovanovich",
});

/// Rms height and mean absolute slope of a surface whose spectrum is cut off. The slope grows with every wave that is
/// included, and the correlations with it, although heat flow does not.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CutSurface {
    rms_height_m: f64,
    mean_absolute_slope: f64,
}

/// Ratio P/H of a nominal pressure to the hardness of the softer body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PressureRatio(f64);

impl CutSurface {
    /// Creates a surface from an rms height sigma \[m\] and a mean absolute slope m of profiles.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(rms_height_m: f64, mean_absolute_slope: f64) -> Result<Self, OutOfBounds> {
        Ok(CutSurface {
            rms_height_m: Bound::Magnitude.check("rms height in m", rms_height_m)?,
            mean_absolute_slope: Bound::Magnitude.check("mean absolute slope", mean_absolute_slope)?,
        })
    }

    /// Creates a surface from an rms height \[m\] and an rms slope of profiles, sqrt(m2); the mean absolute slope of
    /// Gaussian heights is sqrt(2/pi) of that.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn from_rms_slope(rms_height_m: f64, rms_slope: f64) -> Result<Self, OutOfBounds> {
        let rms_slope = Bound::Magnitude.check("rms slope", rms_slope)?;
        Self::new(rms_height_m, FRAC_2_PI.sqrt() * rms_slope)
    }

    /// Rms height sigma \[m\].
    #[must_use]
    pub fn rms_height_m(&self) -> f64 {
        self.rms_height_m
    }

    /// Mean absolute slope m.
    #[must_use]
    pub fn mean_absolute_slope(&self) -> f64 {
        self.mean_absolute_slope
    }
}

impl PressureRatio {
    /// Range of P/H of the correlations.
    pub const FITTED: [f64; 2] = [1e-6, 0.023];

    /// Creates the ratio of a nominal pressure and an indentation hardness \[Pa\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(nominal_pressure_pa: f64, hardness_pa: f64) -> Result<Self, OutOfBounds> {
        let pressure_pa = Bound::Magnitude.check("nominal pressure in Pa", nominal_pressure_pa)?;
        Ok(PressureRatio(pressure_pa / Bound::Magnitude.check("hardness in Pa", hardness_pa)?))
    }

    /// Ratio P/H.
    #[must_use]
    pub fn value(self) -> f64 {
        self.0
    }

    /// Returns true if the ratio lies within the range of the correlations; outside they are extrapolated.
    #[must_use]
    pub fn is_fitted(self) -> bool {
        let [least, most] = Self::FITTED;
        (least..=most).contains(&self.0)
    }
}

impl PlasticCorrelation {
    /// Conductance h_c \[W/(m^2 K)\].
    #[must_use]
    pub fn conductance_w_per_m2_k(
        self,
        conductivities: &Conductivities,
        surface: &CutSurface,
        pressure: PressureRatio,
    ) -> f64 {
        let (factor, exponent) = match self {
            PlasticCorrelation::CooperMikicYovanovich => (1.45, 0.985),
            PlasticCorrelation::Yovanovich => (1.25, 0.95),
        };
        let slope_per_m = surface.mean_absolute_slope / surface.rms_height_m;
        factor * conductivities.harmonic_mean_w_per_m_k() * slope_per_m * libm::pow(pressure.0, exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pressure_outside_the_range_is_flagged_not_refused() {
        let is_fitted = |ratio: f64| PressureRatio::new(ratio * 3e9, 3e9).unwrap().is_fitted();
        assert_eq!([1e-7, 1e-3, 0.03].map(is_fitted), [false, true, false]);
    }

    #[test]
    fn names_parse_to_their_correlations() {
        for correlation in PlasticCorrelation::ALL {
            assert_eq!(correlation.name().parse(), Ok(*correlation));
        }
    }
}
