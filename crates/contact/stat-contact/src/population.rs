//! Asperities of one curvature with Gaussian heights (Greenwood & Williamson 1966).

use asperity::{AsperityError, Bound};

use crate::{PartialMoment, SummitHeights};

/// Asperities of one radius, spread evenly over the nominal area, with Gaussian heights of zero mean (Greenwood &
/// Williamson 1966). They can be derived from a spectrum by McCool's parameters (`docs/theory/models.md`, section 1.5).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Population {
    radius_m: f64,
    density_per_m2: f64,
    sigma_s_m: f64,
}

impl Population {
    /// Creates a population of summit radius R \[m\], eta asperities per nominal area \[m^-2\], and heights of
    /// standard deviation sigma_s \[m\] about their own mean.
    ///
    /// # Errors
    /// [`AsperityError`] unless all three are positive and within thirty decades of 1 ([`Bound::Magnitude`]).
    pub fn new(radius_m: f64, density_per_m2: f64, sigma_s_m: f64) -> Result<Self, AsperityError> {
        Ok(Population {
            radius_m: Bound::Magnitude.check("asperity radius in m", radius_m)?,
            density_per_m2: Bound::Magnitude.check("asperity density in m^-2", density_per_m2)?,
            sigma_s_m: Bound::Magnitude
                .check("standard deviation of the asperity heights in m", sigma_s_m)?,
        })
    }

    /// Summit radius R \[m\], above 0.
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Number of asperities per nominal area, eta \[m^-2\], above 0.
    #[must_use]
    pub fn density_per_m2(&self) -> f64 {
        self.density_per_m2
    }

    /// Standard deviation of the asperity heights, sigma_s \[m\], above 0.
    #[must_use]
    pub fn sigma_s_m(&self) -> f64 {
        self.sigma_s_m
    }

    /// Computes how many asperities per nominal area \[m^-2\] touch a flat at a separation \[m\].
    #[must_use]
    pub fn contacts_per_m2(&self, separation_m: f64, heights: SummitHeights) -> f64 {
        let x = separation_m / self.sigma_s_m;
        self.density_per_m2
            * match heights {
                SummitHeights::Gaussian => PartialMoment::Zeroth.above(x),
                SummitHeights::Exponential => (-x.max(0.0)).exp(),
            }
    }

    /// Computes the plasticity index psi = (E*/H) sqrt(sigma_s/R) under a contact modulus E* and a hardness H > 0 \[Pa\]: below 0.6
    /// hardly an asperity flows, above 1 most do (Greenwood & Williamson 1966).
    #[must_use]
    pub fn plasticity_index(&self, contact_modulus_pa: f64, hardness_pa: f64) -> f64 {
        contact_modulus_pa / hardness_pa * (self.sigma_s_m / self.radius_m).sqrt()
    }

    /// Returns the sinusoid with this density of peaks and this curvature at them: its wavelength lambda \[m\], eta =
    /// 2/lambda^2 (Jackson & Jacobs, Eq. 6), and amplitude Delta \[m\], Delta = (lambda/2 pi)^2/R (Eq. 7).
    pub(crate) fn sinusoid_m(&self) -> (f64, f64) {
        let wavelength_m = (2.0 / self.density_per_m2).sqrt();
        let inverse_wavenumber_m = wavelength_m / std::f64::consts::TAU;
        (wavelength_m, inverse_wavenumber_m * (inverse_wavenumber_m / self.radius_m))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_out_of_bounds_is_named() {
        let error = Population::new(1e-6, 1e12, 0.0).unwrap_err();
        assert_eq!(
            error.to_string(),
            "standard deviation of the asperity heights in m is 0; it must be finite and greater than 0"
        );
        assert!(Population::new(f64::NAN, 1e12, 1e-9).is_err());
        assert!(Population::new(1e-6, f64::INFINITY, 1e-9).is_err());
    }

    #[test]
    fn the_sinusoid_has_the_density_and_the_curvature_of_the_asperities() {
        let (wavelength_m, amplitude_m) = Population::new(2e-6, 5e11, 1e-9).unwrap().sinusoid_m();
        let curvature_per_m = amplitude_m * (std::f64::consts::TAU / wavelength_m).powi(2);
        assert!((2.0 / wavelength_m.powi(2) / 5e11 - 1.0).abs() < 1e-14);
        assert!((curvature_per_m * 2e-6 - 1.0).abs() < 1e-14);
    }
}
