//! A surface on a periodic grid.

use spectrum::Moments;

/// Heights of zero mean on a periodic grid, row by row along x, with the moments of the waves that they are the sum of.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    pub(crate) points_x: usize,
    pub(crate) points_y: usize,
    pub(crate) length_x_m: f64,
    pub(crate) length_y_m: f64,
    pub(crate) heights_m: Vec<f64>,
    pub(crate) moments: Moments,
}

impl Surface {
    /// Points along x, the columns.
    #[must_use]
    pub fn points_x(&self) -> usize {
        self.points_x
    }

    /// Points along y, the rows.
    #[must_use]
    pub fn points_y(&self) -> usize {
        self.points_y
    }

    /// Length along x \[m\].
    #[must_use]
    pub fn length_x_m(&self) -> f64 {
        self.length_x_m
    }

    /// Length along y \[m\].
    #[must_use]
    pub fn length_y_m(&self) -> f64 {
        self.length_y_m
    }

    /// Heights \[m\], the one at column x and row y at y * points_x + x.
    #[must_use]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// Its heights alone.
    #[must_use]
    pub fn into_heights_m(self) -> Vec<f64> {
        self.heights_m
    }

    /// The moments of its profiles in the mean over all directions, by the sum over its own waves; they do not depend on
    /// the grid.
    #[must_use]
    pub fn moments(&self) -> Moments {
        self.moments
    }

    /// Mean square of its own gradient, by the sum over its waves.
    #[must_use]
    pub fn mean_square_gradient(&self) -> f64 {
        2.0 * self.moments.m2
    }

    /// The same surface with all heights `factor` times as large.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.heights_m.iter_mut().for_each(|height_m| *height_m *= factor);
        let Moments { m0_m2, m2, m4_per_m2, .. } = &mut self.moments;
        for moment in [m0_m2, m2, m4_per_m2] {
            *moment *= factor * factor;
        }
        self
    }

    /// The same surface at every second point of every second row: what the same seed gives on that grid. `None` where the
    /// points of a side are odd.
    #[must_use]
    pub fn every_second_point(&self) -> Option<Self> {
        if !(self.points_x.is_multiple_of(2) && self.points_y.is_multiple_of(2)) {
            return None;
        }
        let rows = self.heights_m.chunks_exact(self.points_x).step_by(2);
        let heights_m = rows.flat_map(|row| row.iter().step_by(2).copied()).collect();
        Some(Self { points_x: self.points_x / 2, points_y: self.points_y / 2, heights_m, ..*self })
    }
}
