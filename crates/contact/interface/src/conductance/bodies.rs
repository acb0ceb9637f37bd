//! Thermal and electrical properties of the two bodies.

use units::{Bound, OutOfBounds};

/// Thermal conductivities of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Conductivities {
    first_w_per_m_k: f64,
    second_w_per_m_k: f64,
}

impl Conductivities {
    /// Creates the conductivities of two bodies \[W/(m K)\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(first_w_per_m_k: f64, second_w_per_m_k: f64) -> Result<Self, OutOfBounds> {
        let check = |value| Bound::Magnitude.check("thermal conductivity in W/(m K)", value);
        Ok(Conductivities {
            first_w_per_m_k: check(first_w_per_m_k)?,
            second_w_per_m_k: check(second_w_per_m_k)?,
        })
    }

    /// Harmonic mean k_s = 2 k1 k2/(k1 + k2) \[W/(m K)\].
    #[must_use]
    pub fn harmonic_mean_w_per_m_k(&self) -> f64 {
        2.0 * self.first_w_per_m_k * (self.second_w_per_m_k / (self.first_w_per_m_k + self.second_w_per_m_k))
    }
}

/// Electrical resistivities of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Resistivities {
    first_ohm_m: f64,
    second_ohm_m: f64,
}

impl Resistivities {
    /// Creates the resistivities of two bodies \[ohm m\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(first_ohm_m: f64, second_ohm_m: f64) -> Result<Self, OutOfBounds> {
        let check = |value| Bound::Magnitude.check("electrical resistivity in ohm m", value);
        Ok(Resistivities { first_ohm_m: check(first_ohm_m)?, second_ohm_m: check(second_ohm_m)? })
    }

    /// Returns conductivities 1/rho, with which laws of heat are laws of current, in S/m for W/(m K).
    #[must_use]
    pub fn conductivities(&self) -> Conductivities {
        Conductivities { first_w_per_m_k: 1.0 / self.first_ohm_m, second_w_per_m_k: 1.0 / self.second_ohm_m }
    }

    /// Sum of the resistivities rho1 + rho2 \[ohm m\].
    #[must_use]
    pub fn sum_ohm_m(&self) -> f64 {
        self.first_ohm_m + self.second_ohm_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worse_conductor_decides() {
        let alike = Conductivities::new(20.0, 20.0).unwrap();
        assert_eq!(alike.harmonic_mean_w_per_m_k(), 20.0);
        let unlike = Conductivities::new(1e-3, 4e8).unwrap();
        assert!((unlike.harmonic_mean_w_per_m_k() / 2e-3 - 1.0).abs() < 1e-11);
    }

    #[test]
    fn properties_out_of_bounds_are_refused_by_name() {
        let error = Conductivities::new(20.0, 0.0).unwrap_err().to_string();
        assert_eq!(error, "thermal conductivity in W/(m K) is 0; it must be finite and greater than 0");
        assert!(Resistivities::new(f64::NAN, 1e-8).unwrap_err().to_string().contains("resistivity in ohm m"));
    }
}
