//! Friction of a contact of a known area: Bowden & Tabor (1950), The Friction and Lubrication of Solids.
//!
//! F/A_0 = tau A/A_0 and mu = tau A/(p A_0). The shear strength tau is an input; roughness does not determine it.

use units::{Bound, OutOfBounds};

/// Contact about to slide.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SlidingContact {
    shear_strength_pa: f64,
    area_fraction: f64,
    nominal_pressure_pa: f64,
}

impl SlidingContact {
    /// Creates a contact with the shear strength tau \[Pa\], the share A/A_0 of the nominal area in contact, and the
    /// nominal pressure p \[Pa\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless tau and p are positive and within thirty decades of 1, and the share lies in \[0, 1\].
    pub fn new(
        shear_strength_pa: f64,
        area_fraction: f64,
        nominal_pressure_pa: f64,
    ) -> Result<Self, OutOfBounds> {
        let share = Bound::Within { at_least: 0.0, at_most: 1.0 };
        Ok(SlidingContact {
            shear_strength_pa: Bound::Magnitude.check("shear strength in Pa", shear_strength_pa)?,
            area_fraction: share.check("share in contact", area_fraction)?,
            nominal_pressure_pa: Bound::Magnitude.check("nominal pressure in Pa", nominal_pressure_pa)?,
        })
    }

    /// Friction stress F/A_0 = tau A/A_0 \[Pa\].
    #[must_use]
    pub fn friction_stress_pa(&self) -> f64 {
        self.shear_strength_pa * self.area_fraction
    }

    /// Friction coefficient mu = tau A/(p A_0).
    #[must_use]
    pub fn friction_coefficient(&self) -> f64 {
        self.friction_stress_pa() / self.nominal_pressure_pa
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_in_proportion_to_the_load_is_amontons_law() {
        let at = |pressure_pa: f64| SlidingContact::new(20e6, pressure_pa / 400e6, pressure_pa).unwrap();
        assert!((at(1e6).friction_coefficient() - 0.05).abs() < 1e-15);
        assert!((at(40e6).friction_coefficient() - 0.05).abs() < 1e-15);
        assert!((at(40e6).friction_stress_pa() - 2e6).abs() < 1e-8);
    }

    #[test]
    fn shares_outside_of_zero_to_one_are_refused() {
        let error = SlidingContact::new(20e6, 1.5, 1e6).unwrap_err().to_string();
        assert_eq!(error, "share in contact is 1.5; it must be from 0 to 1");
    }
}
