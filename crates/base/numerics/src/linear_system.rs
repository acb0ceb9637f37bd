//! Small dense systems of linear equations, on the stack.

/// Solves a system by Gaussian elimination with partial pivoting; `None` if the matrix, given by rows, is singular.
#[must_use]
pub fn solve<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    for column in 0..N {
        let larger = |best: usize, row: usize| match matrix[row][column].abs() > matrix[best][column].abs() {
            true => row,
            false => best,
        };
        let pivot = (column..N).fold(column, larger);
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let above = matrix[column];
        if above[column] == 0.0 {
            return None;
        }
        for row in column + 1..N {
            let factor = matrix[row][column] * above[column].recip();
            for (value, above) in matrix[row].iter_mut().zip(above).skip(column) {
                *value -= factor * above;
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..N).rev() {
        right[row] /= matrix[row][row];
        for above in 0..row {
            right[above] -= matrix[above][row] * right[row];
        }
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_is_solved_with_its_rows_in_any_order() {
        // Hilbert's matrix of three rows, whose inverse has whole numbers.
        let rows = [
            [1.0, 1.0 / 2.0, 1.0 / 3.0],
            [1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0],
            [1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0],
        ];
        for [a, b, c] in [[0, 1, 2], [2, 0, 1], [1, 2, 0]] {
            let found =
                solve([rows[a], rows[b], rows[c]], [a, b, c].map(|row| f64::from(u8::from(row == 0))))
                    .unwrap();
            for (found, expected) in found.iter().zip([9.0, -36.0, 30.0]) {
                assert!((found / expected - 1.0).abs() < 1e-13, "{found} {expected}");
            }
        }
    }

    #[test]
    fn a_zero_on_the_diagonal_is_pivoted_and_a_singular_matrix_is_refused() {
        assert_eq!(solve([[0.0, 2.0], [4.0, 0.0]], [6.0, 8.0]), Some([2.0, 3.0]));
        assert_eq!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0]), None);
    }
}
