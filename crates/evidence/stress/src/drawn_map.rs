//! Small height maps of every kind.

use std::f64::consts::TAU;

use elements::half_space::{Grid, HalfSpaceError};

use crate::{Draw, Reach};

/// Heights on a small grid as plain numbers; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct SmallMap {
    /// Number of points along y.
    pub rows: usize,
    /// Number of points along x.
    pub columns: usize,
    /// Length along x \[m\].
    pub length_x_m: f64,
    /// Length along y \[m\].
    pub length_y_m: f64,
    /// Heights \[m\], row by row.
    pub heights_m: Vec<f64>,
}

impl SmallMap {
    /// Draws a map: one point to twelve a side, or a line.
    pub(crate) fn draw(draw: &mut Draw, reach: Reach) -> Self {
        let side = |draw: &mut Draw, most: f64| draw.between(1.0, most) as usize;
        let (rows, columns) = match draw.between(0.0, 1.0) {
            share if share < 0.15 => (1, side(draw, 65.0)),
            share if share < 0.3 => (side(draw, 65.0), 1),
            share if share < 0.6 => {
                let points = draw.one_of(&[2, 4, 8]);
                (points, points)
            }
            _ => (side(draw, 13.0), side(draw, 13.0)),
        };
        let (length, aspect, slope) = match reach {
            Reach::Usual => ((-8.0, -2.0), 0.3, (-4.0, 0.5)),
            _ => ((-12.0, 3.0), 1.5, (-12.0, 12.0)),
        };
        let spacing_x_m = reach.number(draw, length.0, length.1);
        let other_aspect = draw.decades(-aspect, aspect);
        let spacing_y_m = spacing_x_m * draw.one_of(&[1.0, other_aspect]);
        let rise_m = spacing_x_m * reach.number(draw, slope.0, slope.1);
        let heights_m = shape(draw, rows, columns).into_iter().map(|height| rise_m * height).collect();
        let mut map = SmallMap {
            rows,
            columns,
            length_x_m: columns as f64 * spacing_x_m,
            length_y_m: rows as f64 * spacing_y_m,
            heights_m,
        };
        if reach == Reach::Edge && draw.chance(0.3) {
            let point = (draw.between(0.0, map.heights_m.len() as f64)) as usize;
            map.heights_m[point] = draw.one_of(&[-1.0, 1.0]) * draw.edge();
        }
        if draw.chance(0.1) {
            let offset_m = rise_m * draw.one_of(&[-1.0, 1.0]) * draw.decades(-2.0, 8.0);
            map.heights_m.iter_mut().for_each(|height_m| *height_m += offset_m);
        }
        map
    }

    /// Swaps rows and columns.
    pub(crate) fn transposed(&self) -> Self {
        let places = (0..self.columns).flat_map(|column| (0..self.rows).map(move |row| (row, column)));
        SmallMap {
            rows: self.columns,
            columns: self.rows,
            length_x_m: self.length_y_m,
            length_y_m: self.length_x_m,
            heights_m: places.map(|(row, column)| self.heights_m[row * self.columns + column]).collect(),
        }
    }

    /// Rows in reverse order.
    pub(crate) fn mirrored(&self) -> Self {
        let rows = self.heights_m.chunks(self.columns).rev();
        SmallMap { heights_m: rows.flatten().copied().collect(), ..self.clone() }
    }

    /// Columns and rows moved around by some points.
    pub(crate) fn shifted(&self, by_rows: usize, by_columns: usize) -> Self {
        let at = |point: usize| {
            let (row, column) = (point / self.columns, point % self.columns);
            let (row, column) = ((row + by_rows) % self.rows, (column + by_columns) % self.columns);
            self.heights_m[row * self.columns + column]
        };
        SmallMap { heights_m: (0..self.heights_m.len()).map(at).collect(), ..self.clone() }
    }

    /// Heights and lengths times some factors.
    pub(crate) fn scaled(&self, height: f64, length: f64) -> Self {
        SmallMap {
            length_x_m: length * self.length_x_m,
            length_y_m: length * self.length_y_m,
            heights_m: self.heights_m.iter().map(|height_m| height * height_m).collect(),
            ..*self
        }
    }

    pub(crate) fn grid(&self) -> Result<Grid, HalfSpaceError> {
        Grid::new(self.rows, self.columns, self.length_x_m, self.length_y_m)
    }

    /// Pressure \[Pa\] of a wave of the rms height along the longer side, on a body of a contact modulus \[Pa\].
    pub(crate) fn wave_pa(&self, contact_modulus_pa: f64) -> f64 {
        let longer_m = self.length_x_m.max(self.length_y_m);
        0.5 * contact_modulus_pa * (TAU / longer_m * self.rms_m())
    }

    /// Root mean square \[m\] of the heights from their mean.
    pub(crate) fn rms_m(&self) -> f64 {
        let count = self.heights_m.len() as f64;
        let first_m = self.heights_m[0];
        let mean_m = first_m + self.heights_m.iter().map(|height_m| height_m - first_m).sum::<f64>() / count;
        let largest_m =
            self.heights_m.iter().fold(0.0f64, |most, height_m| most.max((height_m - mean_m).abs()));
        if largest_m == 0.0 {
            return 0.0;
        }
        let square = |height_m: &f64| ((height_m - mean_m) / largest_m).powi(2);
        largest_m * (self.heights_m.iter().map(square).sum::<f64>() / count).sqrt()
    }
}

/// Heights of the order of 1.
fn shape(draw: &mut Draw, rows: usize, columns: usize) -> Vec<f64> {
    let points = rows * columns;
    let place = draw.between(0.0, points as f64) as usize;
    let places = (0..points).map(|point| (point / columns, point % columns));
    match draw.between(0.0, 10.0) as usize {
        0 => vec![1.0; points],
        1 => (0..points).map(|point| f64::from(point == place)).collect(),
        2 => (0..points).map(|point| -f64::from(point == place)).collect(),
        3 => places.map(|(row, column)| f64::from((row + column) % 2 == 0)).collect(),
        4 => places.map(|(_, column)| f64::from(column < columns / 2)).collect(),
        5 => {
            let last = draw.one_of(&[f64::EPSILON, 1e-12, 1e-6]);
            (0..points).map(|_| 1.0 + last * draw.between(0.0, 3.0).floor()).collect()
        }
        6 => {
            let smallest = draw.one_of(&[5e-324, 1e-310, 1e-300]);
            (0..points).map(|_| smallest * draw.between(0.0, 4.0).floor()).collect()
        }
        7 => {
            let wave = |at: usize, of: usize| (TAU * at as f64 / of as f64).cos();
            places.map(|(row, column)| wave(row, rows) + wave(column, columns)).collect()
        }
        8 => (0..points).map(|_| draw.one_of(&[-1.0, 1.0]) * draw.decades(-6.0, 0.0)).collect(),
        _ => (0..points).map(|_| draw.between(-1.0, 1.0)).collect(),
    }
}
