//! Load on a surface, or the distance that it is pressed to, and its material.

use units::{Bound, OutOfBounds};

use crate::half_space::HalfSpaceError;
use crate::half_space::contact::TOUCHING;

/// Relative distance from the saturation within which a point yields.
const FLOWING: f64 = 1e-9;

/// Load, material, and tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loading {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Load over the nominal area \[Pa\]: that of the grid, or of the specimen on it.
    pub nominal_pressure_pa: f64,
    /// Pressure at which the surface yields, an indentation hardness \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Largest [`residual`](crate::half_space::ContactNumbers::residual), above 0 and at most 0.1.
    pub tolerance: f64,
}

impl Loading {
    /// Checks the numbers before a solve.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers out of their bounds, and for a load that is not below the saturation.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        check_modulus_and_tolerance(self.contact_modulus_pa, self.tolerance)?;
        Bound::Magnitude.check("nominal pressure in Pa", self.nominal_pressure_pa)?;
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

/// Distance that two bodies are pressed to, whatever load that takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Approach {
    /// Distance \[m\] of the mean planes of a periodic surface and the half-space: the mean gap, less the mean depth that
    /// has yielded.
    MeanGapM(f64),
    /// Distance \[m\] by which the bodies approach from where the highest point touches.
    IndentationM(f64),
}

/// Distance, material, and tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Distance that is held.
    pub approach: Approach,
    /// Pressure at which the surface yields, an indentation hardness \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Largest [`residual`](crate::half_space::ContactNumbers::residual), above 0 and at most 0.1.
    pub tolerance: f64,
}

impl Closing {
    /// Checks the numbers before a solve.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers out of their bounds.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        check_modulus_and_tolerance(self.contact_modulus_pa, self.tolerance)?;
        match self.approach {
            Approach::MeanGapM(gap_m) => Bound::Magnitude.check("mean gap in m", gap_m)?,
            Approach::IndentationM(depth_m) => Bound::Magnitude.check("indentation in m", depth_m)?,
        };
        if let Some(saturation_pa) = self.saturation_pa {
            Bound::Magnitude.check("saturation in Pa", saturation_pa)?;
        }
        Ok(())
    }
}

fn check_modulus_and_tolerance(contact_modulus_pa: f64, tolerance: f64) -> Result<(), OutOfBounds> {
    Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
    Bound::LeftOpen { above: 0.0, at_most: 0.1 }.check("tolerance", tolerance)?;
    Ok(())
}
