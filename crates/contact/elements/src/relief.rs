//! Heights of one surface to be pressed.

use crate::half_space::{Contact, Elements, Grid, HalfSpaceError, Loading, OpenPaths, Sides, open_paths};
use asperity::LayerCompliance;
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use units::named;

/// Boundary condition at the edges of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// The map repeats itself.
    Periodic,
    /// The map is surrounded by a half-space without load.
    Free,
}

named!(Boundary, "boundary", { Periodic => "periodic", Free => "free" });

/// Heights on a grid of rows along x, with a boundary condition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Relief {
    /// Number of points along y.
    pub rows: usize,
    /// Number of points along x.
    pub columns: usize,
    /// Length along x \[m\], `columns` spacings.
    pub length_x_m: f64,
    /// Length along y \[m\], `rows` spacings.
    pub length_y_m: f64,
    /// Heights \[m\], row by row, point (row, column) at row * columns + column; higher points touch first.
    pub heights_m: Vec<f64>,
    /// Boundary condition at the edges.
    pub boundary: Boundary,
}

impl Relief {
    /// Rms slope along x or y from neighbouring points, whichever is larger; 0 of a single point.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        let [along_x, along_y] = self.rms_slopes();
        along_x.max(along_y)
    }

    /// Rms gradient from neighbouring points along x and y.
    #[must_use]
    pub fn rms_gradient(&self) -> f64 {
        let [along_x, along_y] = self.rms_slopes();
        along_x.hypot(along_y)
    }

    fn rms_slopes(&self) -> [f64; 2] {
        let rms = |rises_m: &mut dyn Iterator<Item = f64>, run_m: f64| {
            let (sum, count) = rises_m
                .fold((0.0, 0usize), |(sum, count), rise_m| (sum + (rise_m / run_m).powi(2), count + 1));
            (sum / count.max(1) as f64).sqrt()
        };
        let rows = self.heights_m.chunks_exact(self.columns.max(1));
        let mut along_x = rows.flat_map(|row| row.windows(2).map(|pair| pair[1] - pair[0]));
        let mut along_y =
            self.heights_m.iter().zip(self.heights_m.iter().skip(self.columns)).map(|(a, b)| b - a);
        let spacings_m = self.spacings_m();
        [rms(&mut along_x, spacings_m[0]), rms(&mut along_y, spacings_m[1])]
    }

    /// Returns every second point of every second row; `None` if a side is odd.
    #[must_use]
    pub fn every_second_point(&self) -> Option<Self> {
        if !(self.rows.is_multiple_of(2) && self.columns.is_multiple_of(2)) {
            return None;
        }
        let rows = self.heights_m.chunks_exact(self.columns).step_by(2);
        let heights_m = rows.flat_map(|row| row.iter().step_by(2).copied()).collect();
        Some(Self { rows: self.rows / 2, columns: self.columns / 2, heights_m, ..*self })
    }

    /// Presses the relief once.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights or loads that cannot be pressed, and if `progress` cancels.
    pub fn press(&self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        self.elements(None)?.press(loading, progress)
    }

    /// Elements under the relief, on half-spaces or on a layer.
    pub(crate) fn elements(&self, layer: Option<&LayerCompliance>) -> Result<Elements, HalfSpaceError> {
        match (self.boundary, layer) {
            (Boundary::Periodic, None) => Elements::periodic(self.grid()?, &self.heights_m),
            (Boundary::Free, None) => Elements::free(self.grid()?, &self.heights_m),
            (Boundary::Periodic, Some(layer)) => {
                Elements::periodic_on(self.grid()?, &self.heights_m, |wavevector_rad_per_m| {
                    layer.relative_at(wavevector_rad_per_m)
                })
            }
            (Boundary::Free, Some(_)) => Err(HalfSpaceError::FreeLayer),
        }
    }

    /// Open paths across the contact. The surroundings of a map that is not periodic are unknown, so no path leads
    /// through them.
    pub(crate) fn open_paths(&self, contact: &Contact) -> Result<OpenPaths, HalfSpaceError> {
        let sides = match self.boundary {
            Boundary::Periodic => Sides::Periodic,
            Boundary::Free => Sides::Walls,
        };
        open_paths(&self.grid()?, sides, &contact.touching())
    }

    /// Returns the grid of its points.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers of points and lengths out of their bounds.
    pub fn grid(&self) -> Result<Grid, HalfSpaceError> {
        Grid::new(self.rows, self.columns, self.length_x_m, self.length_y_m)
    }
}
