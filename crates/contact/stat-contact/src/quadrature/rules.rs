//! Gauss-Legendre rules of panels, with estimates of their own error.

use std::sync::OnceLock;

use asperity::elementary;
use numerics::{GaussLegendre, legendre_integral_above, legendre_polynomials};

use super::nodes::{LANES, Lanes};

/// Numbers of nodes of the rules, spaced so that rounding up costs little.
const SIZES: [usize; 17] = [2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 24, 28, 34, MOST];
/// Number of nodes of the largest rule.
pub(crate) const MOST: usize = 40;

/// Gauss-Legendre rule on [-1, 1], and the Legendre polynomials at its nodes.
pub(crate) struct Rule {
    pub gauss: GaussLegendre,
    /// (2k+1)/2 P_k(x) for two degrees k of about half the highest, and for the two highest: summed over the weighted
    /// values of a function they give its Legendre coefficients. In lanes, padded with zeros.
    pub probes: Vec<[Lanes; 4]>,
    /// (2k+1)/2 P_k(x) of every degree k below the number of nodes, node by node.
    polynomials: Vec<f64>,
}

impl Rule {
    /// Returns the smallest rule of at least `nodes` nodes, or the largest there is. Computed at its first use.
    pub fn of_at_least(nodes: usize) -> &'static Rule {
        static RULES: [OnceLock<Rule>; SIZES.len()] = [const { OnceLock::new() }; SIZES.len()];
        let index = SIZES.iter().position(|&size| size >= nodes).unwrap_or(SIZES.len() - 1);
        RULES[index].get_or_init(|| Rule::new(SIZES[index]))
    }

    fn new(size: usize) -> Rule {
        let gauss = GaussLegendre::new(size);
        let scaled = |x: f64| {
            let legendre = legendre_polynomials(x, size).into_iter().enumerate();
            legendre.map(|(k, value)| (k as f64 + 0.5) * value).collect::<Vec<f64>>()
        };
        let half = size / 2;
        let probes = |x: &[f64]| {
            [half, half - 1, size - 1, size - 2].map(|k| {
                let mut lanes = [0.0; LANES];
                lanes.iter_mut().zip(x).for_each(|(lane, &x)| *lane = scaled(x)[k]);
                lanes
            })
        };
        Rule {
            probes: gauss.nodes().chunks(LANES).map(probes).collect(),
            polynomials: gauss.nodes().iter().copied().flat_map(scaled).collect(),
            gauss,
        }
    }

    /// Number of nodes.
    pub fn count(&self) -> usize {
        self.gauss.nodes().len()
    }

    /// The [`probes`](Self::probes) at one node.
    pub fn probes_at(&self, node: usize) -> [f64; 4] {
        let count = self.count();
        let polynomials = &self.polynomials[node * count..];
        [count / 2, count / 2 - 1, count - 1, count - 2].map(|k| polynomials[k])
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
        legendre_integral_above(x, &coefficients[..count])
    }
}

/// Estimated error of a rule of n nodes, from the whole of its sum, the Legendre coefficients that [`Rule::probes`]
/// give, and the share of their later fall that is counted on.
///
/// The rule errs by the coefficients beyond degree 2n. Their fall from degree n to 2n is extrapolated from that from
/// 0 to n/2 and on to n: as fast again and twice as far if they fall geometrically or faster, no further than from
/// n/2 to n behind an end-point power, where the fall levels off. It may level off later than n: three quarters of it
/// are counted on, or less by `onward`.
pub(crate) fn error_of_rule(whole: f64, [a, b, c, d]: [f64; 4], onward: f64) -> f64 {
    const COUNTED_ON: f64 = 0.75;
    // The coefficients must fall by at least a tenth of a factor e to degree n/2, or else the quotient of falls means
    // nothing.
    const LEAST_FIRST_FALL: f64 = 0.1;
    let (middle, high) = (a.abs().max(b.abs()), c.abs().max(d.abs()));
    if high == 0.0 {
        return 0.0;
    }
    let first_fall = elementary::ln(whole.abs() / middle).max(LEAST_FIRST_FALL);
    let second_fall = elementary::ln(middle / high).max(0.0);
    let falls = 1.0 + onward * (second_fall / first_fall).min(1.0);
    high * elementary::exp(-COUNTED_ON * second_fall * falls)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_has_at_least_the_requested_size() {
        assert_eq!(Rule::of_at_least(0).count(), 2);
        assert_eq!(Rule::of_at_least(9).count(), 10);
        assert_eq!(Rule::of_at_least(1000).count(), 40);
    }
}
