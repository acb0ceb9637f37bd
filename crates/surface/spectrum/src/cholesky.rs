//! The Cholesky factor of a 3 x 3 matrix, which suffices for a fit of three parameters.

/// Lower triangular matrix L with a positive diagonal such that L L^T is the matrix.
pub(crate) struct Cholesky {
    lower: [[f64; 3]; 3],
}

impl Cholesky {
    /// Factorises a symmetric matrix; `None` if it is not positive definite or not finite.
    pub(crate) fn new(matrix: [[f64; 3]; 3]) -> Option<Self> {
        let mut lower = [[0.0; 3]; 3];
        for row in 0..3 {
            for column in 0..=row {
                let before: f64 = (0..column).map(|k| lower[row][k] * lower[column][k]).sum();
                let rest = matrix[row][column] - before;
                lower[row][column] = if row > column { rest / lower[column][column] } else { rest.sqrt() };
            }
            if !(lower[row][row] > 0.0 && lower[row][row].is_finite()) {
                return None;
            }
        }
        Some(Self { lower })
    }

    /// The smallest number on the diagonal.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        (0..3).map(|i| self.lower[i][i]).fold(f64::INFINITY, f64::min)
    }

    /// Computes the inverse of the matrix, column by column by two substitutions.
    pub(crate) fn inverse(&self) -> [[f64; 3]; 3] {
        let lower = &self.lower;
        std::array::from_fn(|column| {
            let mut x = [0.0; 3];
            for row in 0..3 {
                let before: f64 = (0..row).map(|k| lower[row][k] * x[k]).sum();
                x[row] = (f64::from(u8::from(row == column)) - before) / lower[row][row];
            }
            for row in (0..3).rev() {
                let after: f64 = (row + 1..3).map(|k| lower[k][row] * x[k]).sum();
                x[row] = (x[row] - after) / lower[row][row];
            }
            x
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes_the_matrix() {
        let matrix = [[4.0, 2.0, -1.0], [2.0, 5.0, 0.5], [-1.0, 0.5, 3.0]];
        let inverse = Cholesky::new(matrix).unwrap().inverse();
        for (i, row) in matrix.iter().enumerate() {
            let product: [f64; 3] =
                std::array::from_fn(|j| row.iter().zip(&inverse).map(|(a, column)| a * column[j]).sum());
            let unit: [f64; 3] = std::array::from_fn(|j| f64::from(u8::from(i == j)));
            assert!(product.iter().zip(unit).all(|(found, unit)| (found - unit).abs() < 1e-15));
        }
        assert!(Cholesky::new([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_none());
        assert!(Cholesky::new([[f64::NAN; 3]; 3]).is_none());
    }
}
