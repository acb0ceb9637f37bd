//! Heights as they are pressed.

use half_space::{
    Contact, FreeElements, Grid, HalfSpaceError, Loading, OpenPaths, PeriodicElements, Sides, open_paths,
};
use parallel::Progress;
use serde::{Deserialize, Serialize};
use units::named;

/// What lies beyond the edges of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// The same map again, without end.
    Periodic,
    /// A half-space without load.
    Free,
}

named!(Boundary, "boundary", { Periodic => "periodic", Free => "free" });

/// Heights on a grid of rows along x, and what lies beyond its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    /// Points along y.
    pub rows: usize,
    /// Points along x.
    pub columns: usize,
    /// Length along x \[m\], `columns` spacings.
    pub length_x_m: f64,
    /// Length along y \[m\], `rows` spacings.
    pub length_y_m: f64,
    /// Heights \[m\], row by row, the one at (row, column) at row * columns + column; higher points touch first.
    pub heights_m: Vec<f64>,
    /// What lies beyond the edges.
    pub boundary: Boundary,
}

impl Relief {
    /// Every second point of every second row; `None` where a side is odd.
    #[must_use]
    pub fn every_second_point(&self) -> Option<Self> {
        if !(self.rows.is_multiple_of(2) && self.columns.is_multiple_of(2)) {
            return None;
        }
        let rows = self.heights_m.chunks_exact(self.columns).step_by(2);
        let heights_m = rows.flat_map(|row| row.iter().step_by(2).copied()).collect();
        Some(Self { rows: self.rows / 2, columns: self.columns / 2, heights_m, ..*self })
    }

    /// Presses it once.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights or loads that cannot be pressed, and where the work is ended from outside.
    pub fn press(&self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        let grid = self.grid()?;
        match self.boundary {
            Boundary::Periodic => PeriodicElements::new(grid, &self.heights_m)?.press(loading, progress),
            Boundary::Free => FreeElements::new(grid, &self.heights_m)?.press(loading, progress),
        }
    }

    /// Presses it once, and asks how much more pressure would close the bodies by 1 m \[Pa/m\]: `None` where no gap is left
    /// to close.
    ///
    /// # Errors
    /// As [`Relief::press`].
    pub fn press_with_stiffness(
        &self,
        loading: &Loading,
        progress: &dyn Progress,
    ) -> Result<(Contact, Option<f64>), HalfSpaceError> {
        let (grid, modulus_pa) = (self.grid()?, loading.contact_modulus_pa);
        Ok(match self.boundary {
            Boundary::Periodic => {
                let mut elements = PeriodicElements::new(grid, &self.heights_m)?;
                let contact = elements.press(loading, progress)?;
                let stiffness_pa_per_m = elements.stiffness_pa_per_m(&contact, modulus_pa, progress)?;
                (contact, stiffness_pa_per_m)
            }
            Boundary::Free => {
                let mut elements = FreeElements::new(grid, &self.heights_m)?;
                let contact = elements.press(loading, progress)?;
                let stiffness_pa_per_m = elements.stiffness_pa_per_m(&contact, modulus_pa, progress)?;
                (contact, stiffness_pa_per_m)
            }
        })
    }

    /// Where what is not in contact crosses it. Beside a map that is not repeated nobody knows of a way, and none is taken.
    pub(crate) fn open_paths(&self, contact: &Contact) -> Result<OpenPaths, HalfSpaceError> {
        let sides = match self.boundary {
            Boundary::Periodic => Sides::Periodic,
            Boundary::Free => Sides::Walls,
        };
        open_paths(&self.grid()?, sides, &contact.touching())
    }

    fn grid(&self) -> Result<Grid, HalfSpaceError> {
        Grid::new(self.rows, self.columns, self.length_x_m, self.length_y_m)
    }
}
