//! Surface that repeats itself.

use parallel::Progress;

use crate::contact::Contact;
use crate::elements::{Elements, unit_wave_number_per_m};
use crate::loading::Loading;
use crate::problem::Operators;
use crate::transform::Convolution;
use crate::{Grid, HalfSpaceError};

/// Boundary elements under a rigid rough surface that repeats itself along x and y.
///
/// A wave of pressure of the wave vector q displaces the half-space by 2/(E* |q|) times its pressure (Westergaard
/// 1939); displacements have a mean of 0. Plans and buffers are kept between loads.
pub struct PeriodicElements {
    elements: Elements,
}

impl PeriodicElements {
    /// Lays out the elements under `heights_m`, row by row; high points touch first.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights that do not match the points, are not finite, or exceed 1e30 m.
    pub fn new(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Ok(Self { elements: Elements::new(grid, true, heights_m, || operators(&grid))? })
    }

    /// Grid of points.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        self.elements.grid()
    }

    /// Presses the surface with a mean pressure; `progress` receives [`PROGRESS_STEPS`](crate::PROGRESS_STEPS) steps.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a load, modulus, saturation or tolerance out of bounds, for a load that cannot be
    /// carried below the saturation, and if `progress` cancels.
    pub fn press(&mut self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.elements.press(loading, progress)
    }

    /// Returns the mean pressure that closes the bodies by 1 m from a state in equilibrium, -dp/du \[Pa/m\], with u
    /// the distance of the mean planes; `None` if the whole surface touches and no gap is left to close.
    ///
    /// The points in contact stay together and no other joins, which is exact for a small change of load. Where
    /// points flow, this is the elastic stiffness on unloading (which electrical and thermal contact depend on); on
    /// loading it is less. One linear problem, solved by conjugate gradients to 1e-8.
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

/// Operators of a grid: displacements of pressures and pressures of displacements, in units of the grid's longest
/// wave.
fn operators(grid: &Grid) -> Operators {
    let map = [grid.rows(), grid.columns()];
    let wave_number = wave_number(*grid);
    Operators {
        compliance: Convolution::new(map, map, |row, column| match (row, column) {
            (0, 0) => 0.0,
            _ => 1.0 / wave_number(row, column),
        }),
        preconditioner: Convolution::new(map, map, wave_number),
    }
}

/// Wave number |q| of a wave with given periods along y and x, in units of the longest wave.
pub(crate) fn wave_number(grid: Grid) -> impl Fn(usize, usize) -> f64 + Copy {
    let unit_per_m = unit_wave_number_per_m(&grid);
    let along_y = std::f64::consts::TAU / grid.length_y_m() / unit_per_m;
    let along_x = std::f64::consts::TAU / grid.length_x_m() / unit_per_m;
    move |row, column| (row as f64 * along_y).hypot(column as f64 * along_x)
}
