//! Material and loads under which surfaces are pressed.

use half_space::{HalfSpaceError, Loading};

/// Material, loads and tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Pressing {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Nominal pressures \[Pa\], in the order of the results.
    pub pressures_pa: Vec<f64>,
    /// Pressure at which the surface yields, an indentation hardness \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Largest residual: sum of p|g| over the sum of p h_rms, above 0 and at most 0.1.
    pub tolerance: f64,
    /// True to compute the stiffness, which costs about half a solve more.
    pub stiffness: bool,
}

impl Pressing {
    /// Default tolerance: areas are then exact to a point or two.
    pub const TOLERANCE: f64 = 1e-6;

    /// Creates an elastic material of a contact modulus \[Pa\], without loads, and without the stiffness.
    #[must_use]
    pub fn elastic(contact_modulus_pa: f64) -> Self {
        Self {
            contact_modulus_pa,
            pressures_pa: Vec::new(),
            saturation_pa: None,
            tolerance: Self::TOLERANCE,
            stiffness: false,
        }
    }

    /// Checks the numbers before any surface is made.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers out of their bounds, and for a load that is not below the saturation.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        (0..self.pressures_pa.len()).try_for_each(|load| self.loading(load).check())
    }

    /// Loading for one of the loads, by its index.
    pub(crate) fn loading(&self, load: usize) -> Loading {
        Loading {
            contact_modulus_pa: self.contact_modulus_pa,
            nominal_pressure_pa: self.pressures_pa[load],
            saturation_pa: self.saturation_pa,
            tolerance: self.tolerance,
        }
    }
}
