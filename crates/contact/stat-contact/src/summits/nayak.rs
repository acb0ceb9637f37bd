//! Summits of an isotropic Gaussian surface: Nayak (1971).

use asperity::{AsperityError, Bound};

/// Heights and curvatures of the summits of an isotropic Gaussian surface, from the moments of its profiles (Nayak
/// 1971; `docs/theory/models.md`, section 3.6).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct NayakSummits {
    m0_m2: f64,
    m2: f64,
    m4_per_m2: f64,
    alpha: f64,
}

impl NayakSummits {
    /// Range of alpha of a surface: 1.5 belongs to waves of a single length.
    pub const ALPHA: Bound = Bound::AtLeast(1.5);

    /// Creates the summits of a surface whose profiles have mean squares of height m0 \[m^2\], slope m2, and
    /// curvature m4 \[m^-2\].
    ///
    /// # Errors
    /// [`AsperityError`] unless all three are positive and within thirty decades of 1 ([`Bound::Magnitude`]), and
    /// alpha = m0 m4/m2^2 is at least 1.5 ([`ALPHA`](Self::ALPHA)): no isotropic Gaussian surface has a smaller one.
    pub fn new(m0_m2: f64, m2: f64, m4_per_m2: f64) -> Result<Self, AsperityError> {
        let m0_m2 = Bound::Magnitude.check("mean square height of profiles in m^2", m0_m2)?;
        let m2 = Bound::Magnitude.check("mean square slope of profiles", m2)?;
        let m4_per_m2 = Bound::Magnitude.check("mean square curvature of profiles in m^-2", m4_per_m2)?;
        let alpha = Self::ALPHA.check("alpha = m0 m4/m2^2 of a surface", alpha(m0_m2, m2, m4_per_m2))?;
        Ok(NayakSummits { m0_m2, m2, m4_per_m2, alpha })
    }

    /// Mean square height of profiles, m0 \[m^2\].
    #[must_use]
    pub fn m0_m2(&self) -> f64 {
        self.m0_m2
    }

    /// Mean square slope of profiles, m2; half the mean square gradient of the surface.
    #[must_use]
    pub fn m2(&self) -> f64 {
        self.m2
    }

    /// Mean square curvature of profiles, m4 \[m^-2\].
    #[must_use]
    pub fn m4_per_m2(&self) -> f64 {
        self.m4_per_m2
    }

    /// Breadth of the spectrum, alpha = m0 m4/m2^2, at least 1.5.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Summits per nominal area \[m^-2\], m4/(6 pi sqrt(3) m2) (Nayak 1971).
    #[must_use]
    pub fn density_per_m2(&self) -> f64 {
        self.m4_per_m2 / (6.0 * std::f64::consts::PI * 3f64.sqrt() * self.m2)
    }
}

/// Computes alpha; a value below 1.5 by rounding alone is taken as 1.5.
fn alpha(m0_m2: f64, m2: f64, m4_per_m2: f64) -> f64 {
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let alpha = (m0_m2 / m2) * (m4_per_m2 / m2);
    if (alpha / 1.5 - 1.0).abs() <= ROUNDING { 1.5 } else { alpha }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_narrower_spectrum_than_any_surface_has_is_refused_by_alpha() {
        let error = NayakSummits::new(1e-18, 0.01, 1.4e14).unwrap_err();
        assert_eq!(error.bound, NayakSummits::ALPHA);
        assert!((error.value - 1.4).abs() < 1e-15);
        assert_eq!(
            error.to_string(),
            format!("alpha = m0 m4/m2^2 of a surface is {}; it must be finite and at least 1.5", error.value)
        );
        // Rounding of the three moments of a single wave.
        let wave = NayakSummits::new(0.3e-18, 0.1 * 0.3, 1.5 * 0.1 * 0.3 * 0.1e18).unwrap();
        assert_eq!(wave.alpha(), 1.5);
    }

    #[test]
    fn moments_out_of_bounds_are_named() {
        let error = NayakSummits::new(1e-18, 0.0, 1e14).unwrap_err();
        assert_eq!(
            error.to_string(),
            "mean square slope of profiles is 0; it must be finite and greater than 0"
        );
        assert!(NayakSummits::new(f64::NAN, 0.1, 1e14).is_err());
    }
}
