//! Heights of one surface to be pressed.

use crate::boundary::Boundary;
use crate::half_space::{Contact, Elements, Grid, HalfSpaceError, Loading, OpenPaths, Sides, open_paths};
use crate::outline::Outline;
use asperity::LayerCompliance;
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};

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
    /// True at each missing point, row by row; empty if there is none. Missing points never touch, and their heights mean nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub is_missing: Vec<bool>,
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
        let rms = |pairs: &mut dyn Iterator<Item = (usize, usize)>, run_m: f64| {
            let has_height = |point: usize| self.is_missing.get(point) != Some(&true);
            let measured = pairs.filter(|&(one, next)| has_height(one) && has_height(next));
            let rises_m = measured.map(|(one, next)| self.heights_m[next] - self.heights_m[one]);
            let (sum, count) = rises_m
                .fold((0.0, 0usize), |(sum, count), rise_m| (sum + (rise_m / run_m).powi(2), count + 1));
            (sum / count.max(1) as f64).sqrt()
        };
        let (points, columns) = (self.heights_m.len(), self.columns.max(1));
        let mut along_x = (1..points).filter(|point| point % columns != 0).map(|point| (point - 1, point));
        let mut along_y = (columns..points).map(|point| (point - columns, point));
        let spacings_m = self.spacings_m();
        [rms(&mut along_x, spacings_m[0]), rms(&mut along_y, spacings_m[1])]
    }

    /// Returns every second point of every second row; `None` if a side is odd.
    #[must_use]
    pub fn every_second_point(&self) -> Option<Self> {
        self.every_second_column_from(0)
    }

    /// Returns every second point of a map, from the half of its columns that is higher on average: then the mirror image of a map
    /// has the mirror image of its points, and exchanged faces the same area.
    pub(crate) fn every_second_of_map(&self) -> Option<Self> {
        let [even, odd] = [self.every_second_column_from(0)?, self.every_second_column_from(1)?];
        let sum_m = |half: &Self| half.heights_m.iter().sum::<f64>();
        let size_m: f64 = self.heights_m.iter().map(|height_m| height_m.abs()).sum();
        // Rounding does not decide between halves of one mean.
        Some(if sum_m(&odd) - sum_m(&even) > 1e-9 * size_m { odd } else { even })
    }

    fn every_second_column_from(&self, first: usize) -> Option<Self> {
        if !(self.rows.is_multiple_of(2) && self.columns.is_multiple_of(2)) {
            return None;
        }
        let (rows, columns) = (self.rows / 2, self.columns / 2);
        let heights_m = every_second(&self.heights_m, self.columns, first);
        let is_missing = every_second(&self.is_missing, self.columns, first);
        Some(Self { rows, columns, heights_m, is_missing, ..*self })
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
        let elements = match (self.boundary, layer) {
            (Boundary::Periodic, None) => Elements::periodic(self.grid()?, &self.heights_m),
            (Boundary::Free, None) => Elements::free(self.grid()?, &self.heights_m),
            (Boundary::Periodic, Some(layer)) => {
                Elements::periodic_on(self.grid()?, &self.heights_m, |wavevector_rad_per_m| {
                    layer.relative_at(wavevector_rad_per_m)
                })
            }
            (Boundary::Free, Some(_)) => Err(HalfSpaceError::FreeLayer),
        }?;
        if self.is_missing.is_empty() {
            return Ok(elements);
        }
        Ok(elements.on(&self.outline()?, &self.heights_m, &self.is_missing))
    }

    /// Returns the outline of the specimen on the map.
    ///
    /// # Errors
    /// [`HalfSpaceError`] if no point has a height, and for numbers of points and lengths out of their bounds.
    pub fn outline(&self) -> Result<Outline, HalfSpaceError> {
        let none_is_missing = vec![false; self.rows * self.columns];
        let is_missing = if self.is_missing.is_empty() { &none_is_missing } else { &self.is_missing };
        Outline::new(self.grid()?, self.boundary, is_missing)
    }

    /// Checks that every point has a height.
    pub(crate) fn check_whole(&self) -> Result<(), HalfSpaceError> {
        match self.is_missing.iter().filter(|is_missing| **is_missing).count() {
            0 => Ok(()),
            missing => Err(HalfSpaceError::MissingPoints { missing }),
        }
    }

    /// Open paths across the contact. The surroundings of a map that is not periodic, and of a specimen on it, are unknown, so no
    /// path leads through them; paths lead from edge to edge of the rectangle that the specimen fills.
    pub(crate) fn open_paths(&self, contact: &Contact) -> Result<OpenPaths, HalfSpaceError> {
        let sides = match self.boundary {
            Boundary::Periodic => Sides::Periodic,
            Boundary::Free => Sides::Walls,
        };
        let mut is_shut = contact.touching();
        if self.is_missing.is_empty() {
            return open_paths(&self.grid()?, sides, &is_shut);
        }
        let outline = self.outline()?;
        let is_inside = outline.is_inside();
        is_shut.iter_mut().zip(is_inside).for_each(|(is_shut, is_inside)| *is_shut |= !is_inside);
        let is_row = |row: &usize| is_inside[row * self.columns..][..self.columns].contains(&true);
        let is_column =
            |column: &usize| is_inside[*column..].iter().step_by(self.columns).any(|&inside| inside);
        let rows: Vec<usize> = (0..self.rows).filter(is_row).collect();
        let columns: Vec<usize> = (0..self.columns).filter(is_column).collect();
        let at = |&row: &usize| columns.iter().map(move |column| row * self.columns + column);
        let is_shut: Vec<bool> = rows.iter().flat_map(at).map(|point| is_shut[point]).collect();
        open_paths(&Grid::new(rows.len(), columns.len(), 1.0, 1.0)?, sides, &is_shut)
    }

    /// Returns the grid of its points.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers of points and lengths out of their bounds.
    pub fn grid(&self) -> Result<Grid, HalfSpaceError> {
        Grid::new(self.rows, self.columns, self.length_x_m, self.length_y_m)
    }
}

/// Every second value of every second row, from a column on.
fn every_second<T: Copy>(values: &[T], columns: usize, first: usize) -> Vec<T> {
    let rows = values.chunks_exact(columns).step_by(2);
    rows.flat_map(|row| row[first..].iter().step_by(2).copied()).collect()
}
