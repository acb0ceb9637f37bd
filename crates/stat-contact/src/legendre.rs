//! Gauss-Legendre rules, and what they tell about their own error.
//!
//! Nodes are the eigenvalues of the Jacobi matrix (Golub & Welsch 1969). The weights are not taken from its
//! eigenvectors, whose small components keep only absolute accuracy, but from the Christoffel sum
//! 1/sum p_k(x)^2 over the orthonormal polynomials, which has positive terms only.

use std::sync::OnceLock;

use faer::{Mat, Side};
use wide::f64x2;

use crate::nodes::LANES;

/// The rules that exist, by their number of nodes: spaced so that rounding a wish up costs little.
const SIZES: [usize; 17] = [2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 24, 28, 34, MOST];
/// Nodes of the largest rule.
const MOST: usize = 40;

/// A Gauss-Legendre rule on [-1, 1], a row for each property of its nodes.
pub(crate) struct Rule {
    pub x: Vec<f64>,
    pub weights: Vec<f64>,
    /// (2k+1)/2 P_k(x) for two degrees k of about half the highest, and for the two highest: summed over the weighted
    /// values of a function they give its Legendre coefficients. In lanes, zero where those outnumber the nodes.
    pub probes: Vec<[f64x2; 4]>,
    /// (2k+1)/2 P_k(x) of every degree k below their number, node by node.
    polynomials: Vec<f64>,
}

impl Rule {
    /// The smallest rule of at least `nodes` nodes, or the largest there is. Computed at its first use.
    pub fn of_at_least(nodes: usize) -> &'static Rule {
        static RULES: [OnceLock<Rule>; SIZES.len()] = [const { OnceLock::new() }; SIZES.len()];
        let index = SIZES.iter().position(|&size| size >= nodes).unwrap_or(SIZES.len() - 1);
        RULES[index].get_or_init(|| Rule::new(SIZES[index]))
    }

    fn new(size: usize) -> Rule {
        let off_diagonal = |k: usize| k as f64 / ((2 * k - 1) as f64 * (2 * k + 1) as f64).sqrt();
        let jacobi = Mat::from_fn(size, size, |i, j| match i.abs_diff(j) {
            1 => off_diagonal(i.max(j)),
            _ => 0.0,
        });
        let eigenvalues =
            jacobi.self_adjoint_eigenvalues(Side::Lower).expect("a tridiagonal matrix of finite numbers");
        // The eigenvalues are good to some 2e-15; one Newton step takes the nodes to rounding, and with them the weights.
        let x: Vec<f64> = (0..size)
            .map(|i| newton_step(size, 0.5 * (eigenvalues[i] - eigenvalues[size - 1 - i])))
            .collect();
        let scaled = |x: f64| {
            let legendre = legendre_polynomials(x, size).into_iter().enumerate();
            legendre.map(|(k, value)| (k as f64 + 0.5) * value).collect::<Vec<f64>>()
        };
        let weight = |x: f64| {
            let legendre = legendre_polynomials(x, size);
            1.0 / legendre.iter().enumerate().map(|(k, p)| (k as f64 + 0.5) * p * p).sum::<f64>()
        };
        let half = size / 2;
        let probes = |x: &[f64]| {
            [half, half - 1, size - 1, size - 2].map(|k| {
                let mut lanes = [0.0; LANES];
                lanes.iter_mut().zip(x).for_each(|(lane, &x)| *lane = scaled(x)[k]);
                f64x2::new(lanes)
            })
        };
        Rule {
            weights: x.iter().copied().map(weight).collect(),
            probes: x.chunks(LANES).map(probes).collect(),
            polynomials: x.iter().copied().flat_map(scaled).collect(),
            x,
        }
    }

    /// The number of its nodes.
    pub fn count(&self) -> usize {
        self.x.len()
    }

    /// The integral from x to 1 of the polynomial with these weighted values at the nodes.
    pub fn integral_above(&self, x: f64, weighted_values: impl Iterator<Item = f64>) -> f64 {
        let count = self.count();
        let mut coefficients = [0.0; MOST];
        for (row, value) in self.polynomials.chunks_exact(count).zip(weighted_values) {
            for (sum, polynomial) in coefficients.iter_mut().zip(row) {
                *sum += value * polynomial;
            }
        }
        // The integral of P_k is (P_(k-1)(x) - P_(k+1)(x))/(2k+1), and that of P_0 is 1 - x.
        let (mut before, mut last) = (1.0, x);
        let mut integral = (1.0 - x) * coefficients[0];
        for (k, coefficient) in coefficients[..count].iter().enumerate().skip(1) {
            let n = k as f64;
            let next = ((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0);
            integral += coefficient * (before - next) / (2.0 * n + 1.0);
            (before, last) = (last, next);
        }
        integral
    }
}

/// A zero of P_n from a value near it: P_n' = n (P_(n-1) - x P_n)/(1 - x^2).
fn newton_step(n: usize, x: f64) -> f64 {
    let legendre = legendre_polynomials(x, n + 1);
    let slope = n as f64 * (legendre[n - 1] - x * legendre[n]) / ((1.0 - x) * (1.0 + x));
    x - legendre[n] / slope
}

/// P_0(x) to P_{count-1}(x).
fn legendre_polynomials(x: f64, count: usize) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for k in 1..count.saturating_sub(1) {
        let (n, last, before) = (k as f64, values[k], values[k - 1]);
        values.push(((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0));
    }
    values.truncate(count);
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_integrates_the_polynomials_it_must() {
        for size in SIZES {
            let rule = Rule::of_at_least(size);
            assert_eq!(rule.count(), size);
            for degree in 0..2 * size {
                let terms =
                    rule.x.iter().zip(&rule.weights).map(|(x, weight)| weight * x.powi(degree as i32));
                let sum: f64 = terms.sum();
                let exact = if degree % 2 == 0 { 2.0 / (degree + 1) as f64 } else { 0.0 };
                assert!((sum - exact).abs() < 2e-15, "{size} nodes, degree {degree}: {sum} against {exact}");
            }
        }
    }

    #[test]
    fn the_outermost_weights_keep_their_relative_accuracy() {
        // Outermost node and weight of the 40-point rule to 20 digits.
        let rule = Rule::of_at_least(40);
        let (x, weight) = (rule.x[39], rule.weights[39]);
        assert!((x - 0.998_237_709_710_559_2).abs() < 3e-16, "{x:e}");
        assert!((weight / 0.004_521_277_098_533_191 - 1.0).abs() < 3e-13, "{weight:e}");
    }

    #[test]
    fn a_rule_of_the_wished_size_or_the_next_larger_is_given() {
        assert_eq!(Rule::of_at_least(0).count(), 2);
        assert_eq!(Rule::of_at_least(9).count(), 10);
        assert_eq!(Rule::of_at_least(1000).count(), 40);
    }
}
