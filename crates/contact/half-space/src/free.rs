//! A surface that ends, on a half-space that goes on.

use std::f64::consts::PI;

use parallel::Progress;

use crate::contact::Contact;
use crate::elements::{Elements, unit_wave_number_per_m};
use crate::loading::Loading;
use crate::love::LoveFactors;
use crate::periodic::wave_number;
use crate::problem::Operators;
use crate::transform::Convolution;
use crate::{Grid, HalfSpaceError};

/// Boundary elements under a rigid surface of finite size, which is alone on the half-space.
///
/// Each element carries a uniform pressure and displaces all others by Love's coefficients (1929); zeros pad the grid to twice
/// its size, so that no load meets its own image. The nominal pressure is the force over the area of the grid. Points at the
/// edge of a map carry load here, as those of a punch do: what comes out for a map cut from a larger surface is not comparable
/// with that of a periodic one.
pub struct FreeElements {
    elements: Elements,
}

impl FreeElements {
    /// Lays out the elements under `heights_m`, row by row; high points touch first.
    ///
    /// # Errors
    /// Heights that are not as many as the points, not finite, or beyond 1e30 m.
    pub fn new(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Ok(Self { elements: Elements::new(grid, false, heights_m, || operators(&grid))? })
    }

    /// The points.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        self.elements.grid()
    }

    /// Presses the surface with a force over the area of the grid; `progress` is told of
    /// [`PROGRESS_STEPS`](crate::PROGRESS_STEPS) steps.
    ///
    /// # Errors
    /// A load, modulus, saturation or tolerance out of bounds; a load that cannot be carried below the saturation; the end of
    /// the work from outside.
    pub fn press(&mut self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.elements.press(loading, progress)
    }

    /// How much pressure closes the bodies by 1 m from a state in equilibrium, in Pa/m: see
    /// [`PeriodicElements::stiffness_pa_per_m`](crate::PeriodicElements::stiffness_pa_per_m). There is always one here.
    ///
    /// # Errors
    /// A contact of another grid, a modulus out of bounds, and the end of the work from outside.
    pub fn stiffness_pa_per_m(
        &mut self,
        contact: &Contact,
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, HalfSpaceError> {
        self.elements.stiffness_pa_per_m(contact, contact_modulus_pa, progress)
    }
}

/// Displacements by Love's coefficients; directions are shaped by the waves of the grid, without padding.
fn operators(grid: &Grid) -> Operators {
    let map = [grid.rows(), grid.columns()];
    // The unit of pressure makes one wave of the unit's height along the longer side: E* q/2, of which E* has gone.
    let love = LoveFactors::new(grid, 2.0 * PI / unit_wave_number_per_m(grid));
    Operators {
        compliance: Convolution::new(map, LoveFactors::period(grid), |row, column| love.factor(row, column)),
        preconditioner: Convolution::new(map, map, wave_number(*grid)),
    }
}
