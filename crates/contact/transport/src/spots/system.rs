//! Currents of discs that see each other, at one potential.

use faer::prelude::Solve;
use faer::{Col, Mat, Side};

/// Most discs for which the system is factorised; beyond, conjugate gradients are faster.
const MOST_FACTORISED: usize = 2000;

/// Relative residual at which the iteration ends.
const TOLERANCE: f64 = 1e-8;

/// Most steps of the iteration, which needs some tens.
const MOST_STEPS: usize = 1000;

/// The matrix is not positive definite: some current would run against the voltage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Indefinite;

/// Solves sum_j R_ij I_j = 1, scaled by the diagonal, which must be positive; `between(i, j)` with j < i gives the rest.
pub(super) fn currents(own: &[f64], between: impl Fn(usize, usize) -> f64) -> Result<Vec<f64>, Indefinite> {
    if own.iter().any(|&own| own <= 0.0) {
        return Err(Indefinite);
    }
    let scales: Vec<f64> = own.iter().map(|own| own.sqrt().recip()).collect();
    let scaled_between = |row: usize, column: usize| between(row, column) * scales[row] * scales[column];
    let scaled = if own.len() <= MOST_FACTORISED {
        factorised(&scales, scaled_between)
    } else {
        Packed::new(own.len(), scaled_between).solve(&scales)
    }?;
    Ok(scaled.iter().zip(&scales).map(|(current, scale)| current * scale).collect())
}

/// Solves the scaled system by Cholesky factors.
fn factorised(scales: &[f64], between: impl Fn(usize, usize) -> f64) -> Result<Vec<f64>, Indefinite> {
    let count = scales.len();
    let matrix = Mat::from_fn(count, count, |row, column| match row.cmp(&column) {
        std::cmp::Ordering::Less => 0.0,
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Greater => between(row, column),
    });
    let factors = matrix.llt(Side::Lower).map_err(|_| Indefinite)?;
    let solution = factors.solve(Col::from_fn(count, |at| scales[at]));
    Ok((0..count).map(|at| solution[at]).collect())
}

/// Symmetric matrix with a diagonal of 1: its lower half in single precision, 2 bytes for each pair of rows and columns.
struct Packed {
    count: usize,
    lower: Vec<f32>,
}

impl Packed {
    fn new(count: usize, between: impl Fn(usize, usize) -> f64) -> Self {
        let mut lower = Vec::with_capacity(count * count.saturating_sub(1) / 2);
        for row in 1..count {
            lower.extend((0..row).map(|column| between(row, column) as f32));
        }
        Packed { count, lower }
    }

    /// Multiplies the matrix with a vector.
    fn multiply(&self, values: &[f64], into: &mut [f64]) {
        into.copy_from_slice(values);
        let mut rest = &self.lower[..];
        for row in 1..self.count {
            let (entries, others) = rest.split_at(row);
            rest = others;
            let value = values[row];
            let (into_before, into_from) = into.split_at_mut(row);
            // Eight sums that do not wait for each other.
            let mut sums = [0.0; 8];
            let (entries, last) = entries.as_chunks::<8>();
            let (before, last_before) = values[..row].as_chunks::<8>();
            let (into_before, into_last) = into_before.as_chunks_mut::<8>();
            for ((entries, before), into) in entries.iter().zip(before).zip(into_before) {
                for lane in 0..8 {
                    let entry = f64::from(entries[lane]);
                    sums[lane] += entry * before[lane];
                    into[lane] += entry * value;
                }
            }
            for ((&entry, before), into) in last.iter().zip(last_before).zip(into_last) {
                sums[0] += f64::from(entry) * before;
                *into += f64::from(entry) * value;
            }
            into_from[0] += sums.iter().sum::<f64>();
        }
    }

    /// Solves the system by conjugate gradients.
    fn solve(&self, load: &[f64]) -> Result<Vec<f64>, Indefinite> {
        let product = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
        let mut solution = vec![0.0; self.count];
        let mut response = vec![0.0; self.count];
        let (mut residual, mut direction) = (load.to_vec(), load.to_vec());
        let mut square = product(&residual, &residual);
        let end = TOLERANCE.powi(2) * square;
        for _ in 0..MOST_STEPS {
            if square <= end {
                return Ok(solution);
            }
            self.multiply(&direction, &mut response);
            let curvature = product(&direction, &response);
            if curvature <= 0.0 {
                return Err(Indefinite);
            }
            let length = square / curvature;
            for at in 0..self.count {
                solution[at] += length * direction[at];
                residual[at] -= length * response[at];
            }
            let next = product(&residual, &residual);
            direction
                .iter_mut()
                .zip(&residual)
                .for_each(|(direction, residual)| *direction = residual + next / square * *direction);
            square = next;
        }
        Err(Indefinite)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_solvers_agree_and_notice_an_indefinite_matrix() {
        let own: Vec<f64> = (0..60).map(|at| 1.0 + f64::from(at % 7)).collect();
        for (coupling, is_definite) in [(0.3, true), (9.0, false)] {
            let between = |row: usize, column: usize| {
                coupling / (1.0 + (row - column) as f64) / (own[row] * own[column]).sqrt()
            };
            let scales = vec![1.0; own.len()];
            let [factors, steps] = [factorised(&scales, between), Packed::new(60, between).solve(&scales)];
            assert_eq!([factors.is_ok(), steps.is_ok()], [is_definite; 2]);
            if let (Ok(factors), Ok(steps)) = (factors, steps) {
                assert!(factors.iter().zip(steps).all(|(one, other)| (one - other).abs() < 1e-6));
            }
        }
    }
}
