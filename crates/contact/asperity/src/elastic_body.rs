//! An isotropic elastic body.

use crate::{AsperityError, Bound};

/// Isotropic elastic body with checked constants.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ElasticBody {
    youngs_modulus_pa: f64,
    poisson_ratio: f64,
}

impl ElasticBody {
    /// Range of Poisson's ratio in which an isotropic body is stable; 0.5 is incompressible.
    pub const POISSON_RATIO: Bound = Bound::LeftOpen { above: -1.0, at_most: 0.5 };

    /// Creates a body of Young's modulus E \[Pa\] and Poisson's ratio nu.
    ///
    /// # Errors
    /// [`AsperityError`] unless E is positive and within thirty decades of 1, and nu lies in (-1, 0.5].
    pub fn new(youngs_modulus_pa: f64, poisson_ratio: f64) -> Result<Self, AsperityError> {
        Ok(ElasticBody {
            youngs_modulus_pa: Bound::Magnitude.check("Young's modulus in Pa", youngs_modulus_pa)?,
            poisson_ratio: Self::POISSON_RATIO.check("Poisson's ratio", poisson_ratio)?,
        })
    }

    /// Young's modulus E \[Pa\], above 0.
    #[must_use]
    pub fn youngs_modulus_pa(&self) -> f64 {
        self.youngs_modulus_pa
    }

    /// Poisson's ratio nu, in (-1, 0.5\].
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// Coefficient C = 1.295 exp(0.736 nu): the largest pressure under a sphere at first yield, over the yield
    /// strength (Jackson & Green 2005). Two bodies in contact yield at C S_y = min C(nu_i) S_y,i.
    #[must_use]
    pub fn spherical_yield_coefficient(&self) -> f64 {
        1.295 * (0.736 * self.poisson_ratio).exp()
    }

    /// Shear modulus G = E/(2 (1 + nu)) \[Pa\].
    #[must_use]
    pub fn shear_modulus_pa(&self) -> f64 {
        0.5 * self.youngs_modulus_pa / (1.0 + self.poisson_ratio)
    }

    /// Plane-strain modulus E/(1 - nu^2) \[Pa\].
    pub(crate) fn plane_strain_modulus_pa(&self) -> f64 {
        self.youngs_modulus_pa / ((1.0 - self.poisson_ratio) * (1.0 + self.poisson_ratio))
    }
}
