//! Barber's analogy between stiffness and conductance.

use units::{Bound, OutOfBounds};

use super::spot::modulus;
use super::{Conductivities, Resistivities, Spot};

/// Ratio K/E*: the stiffness of an interface per nominal area over the contact modulus, the only mechanical input of
/// conductance. K = -dp/du is the elastic stiffness against a small change of load, in excess of that of the bodies.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct RelativeStiffness {
    per_m: f64,
}

impl RelativeStiffness {
    /// Creates the ratio of a stiffness K \[Pa/m\] and a contact modulus E* \[Pa\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(stiffness_pa_per_m: f64, contact_modulus_pa: f64) -> Result<Self, OutOfBounds> {
        let stiffness_pa_per_m = Bound::Magnitude.check("stiffness in Pa/m", stiffness_pa_per_m)?;
        Ok(RelativeStiffness { per_m: stiffness_pa_per_m / modulus(contact_modulus_pa)? })
    }

    /// Creates the ratio of a light load, where K = p/u_0, from a nominal pressure p \[Pa\], a contact modulus E*
    /// \[Pa\] and the length u_0 \[m\] over which the pressure falls by a factor e as the surfaces part.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless all are positive and within thirty decades of 1.
    pub fn from_light_load(
        nominal_pressure_pa: f64,
        contact_modulus_pa: f64,
        decay_length_m: f64,
    ) -> Result<Self, OutOfBounds> {
        let pressure_pa = Bound::Magnitude.check("nominal pressure in Pa", nominal_pressure_pa)?;
        let length_m = Bound::Magnitude.check("decay length in m", decay_length_m)?;
        Ok(RelativeStiffness { per_m: pressure_pa / modulus(contact_modulus_pa)? / length_m })
    }

    /// Ratio K/E* \[1/m\].
    #[must_use]
    pub fn per_m(&self) -> f64 {
        self.per_m
    }

    /// Electrical conductance G = 2 K/(E* (rho1 + rho2)) \[S/m^2\].
    #[must_use]
    pub fn electrical_conductance_s_per_m2(&self, resistivities: &Resistivities) -> f64 {
        2.0 * self.per_m / resistivities.sum_ohm_m()
    }

    /// Thermal conductance h_c = k_s K/E* \[W/(m^2 K)\], k_s the harmonic mean of the conductivities.
    #[must_use]
    pub fn thermal_conductance_w_per_m2_k(&self, conductivities: &Conductivities) -> f64 {
        self.per_m * conductivities.harmonic_mean_w_per_m_k()
    }

    /// Circular spot that conducts as much as a nominal area A_0 \[m^2\], for results in ohms and K/W: its radius is
    /// K A_0/(2 E*).
    ///
    /// # Errors
    /// [`OutOfBounds`] unless the area is positive and within thirty decades of 1.
    pub fn equivalent_spot(&self, nominal_area_m2: f64) -> Result<Spot, OutOfBounds> {
        let area_m2 = Bound::Magnitude.check("nominal area in m^2", nominal_area_m2)?;
        Ok(Spot::from_relative_stiffness_m(self.per_m * area_m2))
    }
}
