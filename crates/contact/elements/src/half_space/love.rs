//! Displacements under a pressed rectangle (Love 1929), as factors of waves over a padded grid.

use numerics::transforms::{Complex, Fft};

use crate::half_space::Grid;

/// Factors of the waves of a grid that is padded with zeros to twice its size, so that no load meets its own image.
pub(crate) struct LoveFactors {
    /// Factors of waves along y from 0 to the shortest, for each wave along x.
    factors: Vec<f64>,
    rows: usize,
}

impl LoveFactors {
    /// Rows and columns of the padded grid.
    pub(crate) fn period(grid: &Grid) -> [usize; 2] {
        [2 * grid.rows(), 2 * grid.columns()]
    }

    /// Creates the factors of displacements in m times pi E*, over the pressure of one element, divided by `unit_m`.
    pub(crate) fn new(grid: &Grid, unit_m: f64) -> Self {
        let [period_rows, period_columns] = Self::period(grid);
        let (rows, columns) = (grid.rows() + 1, grid.columns() + 1);
        let spacing = [grid.length_x_m() / grid.columns() as f64, grid.length_y_m() / grid.rows() as f64];
        let mut along_x = Cosines::new(period_columns);
        let mut along_y = Cosines::new(period_rows);
        // Rows first, then columns: the coefficients are even along both.
        let mut by_row = vec![0.0; rows * columns];
        let mut line = vec![0.0; columns];
        for (row, by_row) in by_row.chunks_exact_mut(columns).enumerate() {
            for (column, value) in line.iter_mut().enumerate() {
                *value = displacement_of_rectangle(column as f64, row as f64, spacing) / unit_m;
            }
            along_x.transform(&line, by_row);
        }
        let mut factors = vec![0.0; rows * columns];
        let mut line = vec![0.0; rows];
        for (column, factors) in factors.chunks_exact_mut(rows).enumerate() {
            line.iter_mut()
                .zip(by_row[column..].iter().step_by(columns))
                .for_each(|(to, &value)| *to = value);
            along_y.transform(&line, factors);
        }
        Self { factors, rows }
    }

    /// Factor of the wave with `row` periods along y and `column` periods along x.
    pub(crate) fn factor(&self, row: usize, column: usize) -> f64 {
        self.factors[column * self.rows + row]
    }
}

/// Transform of an even sequence, stored as its first half and the middle.
struct Cosines {
    plan: std::sync::Arc<dyn Fft<f64>>,
    values: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Cosines {
    fn new(period: usize) -> Self {
        let plan = numerics::transforms::forward(period);
        let scratch = vec![Complex::default(); plan.get_inplace_scratch_len()];
        Self { plan, values: vec![Complex::default(); period], scratch }
    }

    fn transform(&mut self, half: &[f64], into: &mut [f64]) {
        let period = self.values.len();
        for (at, value) in self.values.iter_mut().enumerate() {
            *value = Complex::new(half[at.min(period - at)], 0.0);
        }
        self.plan.process_with_scratch(&mut self.values, &mut self.scratch);
        into.iter_mut().zip(&self.values).for_each(|(to, value)| *to = value.re);
    }
}

/// Displacement times pi E* over pressure \[m\], at a distance in elements from the middle of a pressed element.
///
/// Love, A. E. H. (1929), Philosophical Transactions A 228, 377; Johnson (1985), Contact Mechanics, equation 3.25.
fn displacement_of_rectangle(columns: f64, rows: f64, [dx_m, dy_m]: [f64; 2]) -> f64 {
    let [left, right] = [(columns - 0.5) * dx_m, (columns + 0.5) * dx_m];
    let [low, high] = [(rows - 0.5) * dy_m, (rows + 0.5) * dy_m];
    (corner(right, high) - corner(left, high)) - (corner(right, low) - corner(left, low))
}

/// Integral of 1/r over x and y, up to terms that cancel; no corner of an element lies on an axis through a middle.
fn corner(x_m: f64, y_m: f64) -> f64 {
    x_m * (y_m / x_m.abs()).asinh() + y_m * (x_m / y_m.abs()).asinh()
}

#[cfg(test)]
mod tests {
    use super::displacement_of_rectangle;

    #[test]
    fn a_pressed_square_agrees_with_its_exact_middle_and_with_a_distant_point_load() {
        // Middle of a square of side a: 4 a ln(1 + sqrt 2), over pi E* (Johnson 1985, section 3.3).
        let middle_m = displacement_of_rectangle(0.0, 0.0, [2.0, 2.0]);
        assert!((middle_m - 8.0 * (1.0 + 2.0f64.sqrt()).ln()).abs() < 1e-14);
        // At a distance the load is a point: area over distance.
        let far_m = displacement_of_rectangle(300.0, 400.0, [1.0, 1.0]);
        assert!((far_m * 500.0 - 1.0).abs() < 1e-6, "{far_m}");
    }
}
