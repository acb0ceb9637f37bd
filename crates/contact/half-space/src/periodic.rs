//! A surface that repeats itself for ever.

use parallel::Progress;

use crate::contact::Contact;
use crate::elements::{Elements, unit_wave_number_per_m};
use crate::loading::Loading;
use crate::problem::Operators;
use crate::transform::Convolution;
use crate::{Grid, HalfSpaceError};

/// Boundary elements under a rigid rough surface that repeats itself along x and y.
///
/// A wave of pressure of the wave vector q displaces the half-space by 2/(E* |q|) times it (Westergaard 1939); displacements
/// have a mean of 0. Plans and buffers are kept between loads.
pub struct PeriodicElements {
    elements: Elements,
}

impl PeriodicElements {
    /// Lays out the elements under `heights_m`, row by row; high points touch first.
    ///
    /// # Errors
    /// Heights that are not as many as the points, not finite, or beyond 1e30 m.
    pub fn new(grid: Grid, heights_m: &[f64]) -> Result<Self, HalfSpaceError> {
        Ok(Self { elements: Elements::new(grid, true, heights_m, || operators(&grid))? })
    }

    /// The points.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        self.elements.grid()
    }

    /// Presses the surface with a mean pressure; `progress` is told of [`PROGRESS_STEPS`](crate::PROGRESS_STEPS) steps.
    ///
    /// # Errors
    /// A load, modulus, saturation or tolerance out of bounds; a load that cannot be carried below the saturation; the end of
    /// the work from outside.
    pub fn press(&mut self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.elements.press(loading, progress)
    }

    /// How much mean pressure closes the bodies by 1 m from a state in equilibrium, -dp/du in Pa/m, u being the distance of
    /// the mean planes; `None` where the whole surface touches and no gap is left to close.
    ///
    /// The points in contact stay together and no other joins, which is exact for a small change, elastic or flowing: where
    /// points flow, this is the elastic stiffness of a load taken off (as electrical and thermal contact see it), and a load
    /// added meets less. One linear problem of conjugate gradients, to 1e-8.
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

/// Displacement of pressures, and pressures of displacements, in units of the grid's longest wave.
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

/// |q| of so many waves along y and x, in units of the longest.
pub(crate) fn wave_number(grid: Grid) -> impl Fn(usize, usize) -> f64 + Copy {
    let unit_per_m = unit_wave_number_per_m(&grid);
    let along_y = std::f64::consts::TAU / grid.length_y_m() / unit_per_m;
    let along_x = std::f64::consts::TAU / grid.length_x_m() / unit_per_m;
    move |row, column| (row as f64 * along_y).hypot(column as f64 * along_x)
}
