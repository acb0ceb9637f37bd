//! Load on a surface and its material.

use units::Bound;

use crate::HalfSpaceError;

/// Load, material, and tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loading {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Load over the area of the grid \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Pressure at which the surface yields, an indentation hardness \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Largest [`residual`](crate::Contact::residual), above 0 and at most 0.1.
    pub tolerance: f64,
}

impl Loading {
    /// Checks the numbers before a solve.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers out of their bounds, and for a load that is not below the saturation.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        Bound::Magnitude.check("contact modulus in Pa", self.contact_modulus_pa)?;
        Bound::Magnitude.check("nominal pressure in Pa", self.nominal_pressure_pa)?;
        Bound::LeftOpen { above: 0.0, at_most: 0.1 }.check("tolerance", self.tolerance)?;
        if let Some(saturation_pa) = self.saturation_pa {
            Bound::Magnitude.check("saturation in Pa", saturation_pa)?;
            if saturation_pa <= self.nominal_pressure_pa {
                return Err(HalfSpaceError::CannotBeCarried {
                    nominal_pressure_pa: self.nominal_pressure_pa,
                    saturation_pa,
                });
            }
        }
        Ok(())
    }
}
