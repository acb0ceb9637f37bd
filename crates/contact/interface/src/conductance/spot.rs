//! One circular contact: Holm (1967), Electric Contacts.

use units::{Bound, OutOfBounds};

use super::{Conductivities, Resistivities};

/// Circular spot between two half-spaces, or the one that conducts as much as an interface of many.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Spot {
    radius_m: f64,
}

impl Spot {
    /// Creates a spot of a radius \[m\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless it is positive and within thirty decades of 1.
    pub fn new(radius_m: f64) -> Result<Self, OutOfBounds> {
        Ok(Spot { radius_m: Bound::Magnitude.check("radius of a spot in m", radius_m)? })
    }

    /// Creates the spot of a relative stiffness (dF/d delta)/E* > 0 \[m\].
    pub(super) fn from_relative_stiffness_m(relative_stiffness_m: f64) -> Self {
        Spot { radius_m: 0.5 * relative_stiffness_m }
    }

    /// Radius a \[m\].
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Electrical resistance R = (rho1 + rho2)/(4 a) \[ohm\].
    #[must_use]
    pub fn electrical_resistance_ohm(&self, resistivities: &Resistivities) -> f64 {
        resistivities.sum_ohm_m() / (4.0 * self.radius_m)
    }

    /// Electrical conductance 1/R = 4 a/(rho1 + rho2) \[S\].
    #[must_use]
    pub fn electrical_conductance_s(&self, resistivities: &Resistivities) -> f64 {
        4.0 * self.radius_m / resistivities.sum_ohm_m()
    }

    /// Thermal resistance 1/(2 k_s a) \[K/W\], k_s the harmonic mean of the conductivities.
    #[must_use]
    pub fn thermal_resistance_k_per_w(&self, conductivities: &Conductivities) -> f64 {
        1.0 / self.thermal_conductance_w_per_k(conductivities)
    }

    /// Thermal conductance 2 k_s a \[W/K\].
    #[must_use]
    pub fn thermal_conductance_w_per_k(&self, conductivities: &Conductivities) -> f64 {
        2.0 * conductivities.harmonic_mean_w_per_m_k() * self.radius_m
    }
}

pub(super) fn modulus(contact_modulus_pa: f64) -> Result<f64, OutOfBounds> {
    Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)
}
