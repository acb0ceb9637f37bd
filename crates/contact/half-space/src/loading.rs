//! Load on a surface and its material.

use units::Bound;

use crate::HalfSpaceError;
use crate::contact::TOUCHING;

/// Relative distance from the saturation within which a point yields.
const FLOWING: f64 = 1e-9;

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

    /// Returns true if a point with this pressure \[Pa\] counts as in contact.
    #[must_use]
    pub fn touches_at(&self, pressure_pa: f64) -> bool {
        pressure_pa > TOUCHING * self.nominal_pressure_pa
    }

    /// Returns true if a point with this pressure \[Pa\] counts as yielding.
    #[must_use]
    pub fn yields_at(&self, pressure_pa: f64) -> bool {
        self.saturation_pa.is_some_and(|saturation_pa| pressure_pa >= saturation_pa * (1.0 - FLOWING))
    }
}
