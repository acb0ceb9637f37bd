//! Places on a relief from its middle, where balls and cylinders stand.

use crate::relief::{Boundary, Relief};

impl Relief {
    /// Spacings along x and y \[m\].
    pub(crate) fn spacings_m(&self) -> [f64; 2] {
        [self.length_x_m / self.columns as f64, self.length_y_m / self.rows as f64]
    }

    /// Places of the points from the middle of the map, row by row \[m\].
    pub(crate) fn places_m(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let (rows, columns) = (self.rows, self.columns);
        let [spacing_x_m, spacing_y_m] = self.spacings_m();
        let place_m = |at: usize, count: usize, spacing_m| (at as f64 + 0.5 - 0.5 * count as f64) * spacing_m;
        (0..rows * columns).map(move |point| {
            (place_m(point % columns, columns, spacing_x_m), place_m(point / columns, rows, spacing_y_m))
        })
    }

    /// Returns the relief less a shape over the places from its middle.
    pub(crate) fn less(&self, boundary: Boundary, shape_m: impl Fn(f64, f64) -> f64) -> Self {
        let heights_m = self.heights_m.iter().zip(self.places_m());
        let heights_m = heights_m.map(|(height_m, (x_m, y_m))| height_m - shape_m(x_m, y_m)).collect();
        Self { heights_m, boundary, ..*self }
    }

    /// Rms height about the mean \[m\].
    pub(crate) fn rms_height_m(&self) -> f64 {
        let count = self.heights_m.len() as f64;
        let mean_m = self.heights_m.iter().sum::<f64>() / count;
        let squares = self.heights_m.iter().map(|height_m| (height_m - mean_m).powi(2));
        (squares.sum::<f64>() / count).sqrt()
    }
}
