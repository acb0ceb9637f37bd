//! Surface of finite size on an infinite half-space.

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

/// Boundary elements under a rigid surface of finite size, alone on the half-space.
///
/// Each element carries a uniform pressure and displaces all others by Love's coefficients (1929); zeros pad the grid
/// to twice its size, so that no load meets its own image. The nominal pressure is the force over the area of the
/// grid. Points at the edge of a map carry load here, like those of a punch: results for a map cut from a larger
/// surface are not comparable with those of a periodic one.
pub struct FreeElements {
    elements: Elements,
}

impl FreeElements {
    /// Lays out the elements under `heights_m`, row by row; high points touch first.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights that do not match the points, are not finite, or exceed 1e30 m.
    pub fn new(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Ok(Self { elements: Elements::new(grid, false, heights_m, || operators(&grid))? })
    }

    /// Grid of points.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        self.elements.grid()
    }

    /// Presses the surface with a force over the area of the grid; `progress` receives
    /// [`PROGRESS_STEPS`](crate::PROGRESS_STEPS) steps.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a load, modulus, saturation or tolerance out of bounds, for a load that cannot be
    /// carried below the saturation, and if `progress` cancels.
    pub fn press(&mut self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.elements.press(loading, progress)
    }

    /// Returns the pressure that closes the bodies by 1 m from a state in equilibrium \[Pa/m\]: see
    /// [`PeriodicElements::stiffness_pa_per_m`](crate::PeriodicElements::stiffness_pa_per_m). Always present here.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a contact of another grid, for a modulus out of bounds, and if `progress` cancels.
    pub fn stiffness_pa_per_m(
        &mut self,
        contact: &Contact,
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, HalfSpaceError> {
        self.elements.stiffness_pa_per_m(contact, contact_modulus_pa, progress)
    }
}

/// Operators of a grid: displacements by Love's coefficients; directions are preconditioned by the waves of the grid,
/// without padding.
fn operators(grid: &Grid) -> Operators {
    let map = [grid.rows(), grid.columns()];
    // The unit of pressure makes one wave of the unit's height along the longer side: E* q/2, in which E* cancels.
    let love = LoveFactors::new(grid, 2.0 * PI / unit_wave_number_per_m(grid));
    Operators {
        compliance: Convolution::new(map, LoveFactors::period(grid), |row, column| love.factor(row, column)),
        preconditioner: Convolution::new(map, map, wave_number(*grid)),
    }
}
