//! A surface on a periodic grid.

use crate::Moments;

/// Heights of zero mean on a periodic grid, row by row along x, with the moments of their waves.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RandomSurface {
    /// Points along x, the columns.
    pub points_x: usize,
    /// Points along y, the rows.
    pub points_y: usize,
    /// Length along x \[m\].
    pub length_x_m: f64,
    /// Length along y \[m\].
    pub length_y_m: f64,
    /// Heights \[m\]; column x and row y are at index y * points_x + x.
    pub heights_m: Vec<f64>,
    /// Moments of the profiles, averaged over all directions, as a sum over the waves of this surface. They do not
    /// depend on the grid.
    pub moments: Moments,
}

/// Moments of the profiles of an isotropic surface down to a shortest wavelength \[m\], from the mean squares of its heights,
/// gradient and Laplacian: m0 = <h^2>, m2 = <|grad h|^2>/2, m4 = (3/8) <(lap h)^2>. The factors are the means of cos^2 and
/// cos^4 over all directions (Nayak 1971, J. Lubr. Technol. 93:398).
pub(crate) fn profile_moments(wavelength_m: f64, [m0_m2, gradient, laplacian_per_m2]: [f64; 3]) -> Moments {
    Moments { wavelength_m, m0_m2, m2: 0.5 * gradient, m4_per_m2: 0.375 * laplacian_per_m2 }
}

impl RandomSurface {
    /// Mean square gradient, as a sum over the waves of this surface.
    #[must_use]
    pub fn mean_square_gradient(&self) -> f64 {
        2.0 * self.moments.m2
    }

    /// Multiplies all heights by `factor`.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.heights_m.iter_mut().for_each(|height_m| *height_m *= factor);
        let Moments { m0_m2, m2, m4_per_m2, .. } = &mut self.moments;
        for moment in [m0_m2, m2, m4_per_m2] {
            *moment *= factor * factor;
        }
        self
    }

    /// Keeps every second point of every second row, which equals the surface of the same seed on that grid. `None` if
    /// a side has an odd number of points.
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
