//! Coordinates in which integrals over the interference are smooth, and rules over them with estimates of their own error.

use std::sync::OnceLock;

use asperity::elementary;
use numerics::{GaussLegendre, legendre_integral_above, legendre_polynomials};

/// Number of nodes that are added up side by side.
pub(crate) const LANES: usize = 4;

/// Values of nodes side by side.
pub(crate) type Lanes = [f64; LANES];

/// Coordinate v that is root-like at the origin and linear far from it, in units of sigma_s: s = sqrt(c^2 + v^2) - c,
/// or s = v - u if the origin is out of reach.
///
/// Half-integer powers of s turn into v times even analytic functions, as under s = v^2. But the nearest
/// singularities lie at v = +-i c whatever the separation, and far from the origin equal steps in v are equal steps
/// in s. The trapezoidal rule then needs some 20 nodes at any separation; under s = v^2 it needs 28 around u = -6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Coordinate {
    Root {
        c: f64,
    },
    Height {
        u: f64,
    },
    /// s = v^power, for stretches over decades of s that do not reach the origin.
    Power {
        power: i32,
    },
}

impl Coordinate {
    /// Returns the coordinate around the separation u, for rules that resolve the integrand to exp(-digits) at every
    /// separation up to `farthest`, where the density at the singularity is the largest.
    ///
    /// The trapezoidal rule of step h sees the singularity at v = i c as exp(-2 pi c/h) times the density there, at s
    /// = -c: c is the smallest number, and so the one with the fewest nodes, for which that is below exp(-digits). If
    /// contacts at first touch are already that rare, the heights themselves are the coordinate, and keep their
    /// digits better.
    pub fn around(u: f64, farthest: f64, digits: f64) -> Self {
        // Compensates the growth of a response like s^(3/2) from the contacts, at 1/(1 + u), to the singularity.
        const MARGIN: f64 = 5.0;
        // Digits below which the heights themselves are the coordinate.
        const LEAST_LEVEL: f64 = 1.0;
        let margin = MARGIN + MARGIN * elementary::ln_1p(u.max(0.0));
        let level = digits + margin - 0.5 * farthest.min(0.0).powi(2);
        if level < LEAST_LEVEL {
            return Coordinate::Height { u };
        }
        let rise = (2.0 * digits).sqrt() - farthest;
        let root = (rise * rise + 2.0 * level).sqrt();
        Coordinate::Root { c: if rise > 0.0 { 2.0 * level / (rise + root) } else { root - rise } }
    }

    /// Returns the coordinate for a stretch from `low` to `high`. A law may have singularities at the origin, of
    /// powers of s: if the stretch covers decades, a power of the coordinate keeps them at a tenth of its length from
    /// it.
    pub fn between(self, low: f64, high: f64) -> Self {
        // A decade of the coordinate, whatever the decades of the interference.
        const LOG_RATIO_LEFT: f64 = 2.3;
        // Higher powers gather the nodes at the far end.
        const HIGHEST_POWER: f64 = 8.0;
        let power = if low > 0.0 { elementary::ln(high / low) / LOG_RATIO_LEFT } else { 0.0 };
        if power > 1.0 { Coordinate::Power { power: power.ceil().min(HIGHEST_POWER) as i32 } } else { self }
    }

    /// True for the coordinate of a stretch over decades.
    pub fn spans_decades(self) -> bool {
        matches!(self, Coordinate::Power { .. })
    }

    /// Step at which the trapezoidal rule integrates a unit Gaussian to exp(-digits).
    pub fn trapezoidal_step(digits: f64) -> f64 {
        std::f64::consts::PI * (2.0 / digits).sqrt()
    }

    /// The coordinate of an interference.
    pub fn at(self, s: f64) -> f64 {
        match self {
            Coordinate::Root { c } => (s * (s + 2.0 * c)).sqrt(),
            Coordinate::Height { u } => s + u,
            Coordinate::Power { power } => elementary::exp(elementary::ln(s) / f64::from(power)),
        }
    }

    /// The interferences at coordinates, and their derivatives.
    pub fn interferences(self, coordinates: &[f64], interferences: &mut [f64], slopes: &mut [f64]) {
        match self {
            Coordinate::Root { c } => {
                for ((&v, s), slope) in coordinates.iter().zip(interferences).zip(slopes) {
                    let root = (c * c + v * v).sqrt();
                    // One division for both v^2/(root + c) and v/root.
                    let quotient = v / (root * (root + c));
                    (*s, *slope) = (v * root * quotient, (root + c) * quotient);
                }
            }
            Coordinate::Height { u } => {
                for ((&v, s), slope) in coordinates.iter().zip(interferences).zip(slopes) {
                    (*s, *slope) = (v - u, 1.0);
                }
            }
            Coordinate::Power { power } => {
                // Multiplies row by row instead of raising each number to an unknown power.
                interferences.fill(1.0);
                for _ in 1..power {
                    interferences.iter_mut().zip(coordinates).for_each(|(below, v)| *below *= v);
                }
                for ((s, slope), v) in interferences.iter_mut().zip(slopes).zip(coordinates) {
                    *slope = f64::from(power) * *s;
                    *s *= v;
                }
            }
        }
    }
}

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
            probes: gauss.nodes.chunks(LANES).map(probes).collect(),
            polynomials: gauss.nodes.iter().copied().flat_map(scaled).collect(),
            gauss,
        }
    }

    /// Number of nodes.
    pub fn count(&self) -> usize {
        self.gauss.nodes.len()
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

    fn interference(coordinate: Coordinate, v: f64) -> (f64, f64) {
        let (mut s, mut slope) = ([0.0], [0.0]);
        coordinate.interferences(&[v], &mut s, &mut slope);
        (s[0], slope[0])
    }

    #[test]
    fn the_coordinate_inverts_the_interference_and_knows_its_slope() {
        for coordinate in [Coordinate::around(-3.0, -3.0, 30.0), Coordinate::around(60.0, 63.0, 30.0)] {
            for v in [1e-9, 0.1, 3.0, 40.0] {
                let (s, slope) = interference(coordinate, v);
                assert!((coordinate.at(s) / v - 1.0).abs() < 1e-14);
                let difference = interference(coordinate, v * (1.0 + 1e-6)).0
                    - interference(coordinate, v * (1.0 - 1e-6)).0;
                assert!((difference / (2e-6 * v) / slope - 1.0).abs() < 1e-9);
            }
        }
        let far = Coordinate::around(-60.0, -60.0, 30.0);
        assert_eq!(interference(far, far.at(61.0)), (61.0, 1.0));
    }

    #[test]
    fn a_rule_has_at_least_the_requested_size() {
        assert_eq!(Rule::of_at_least(0).count(), 2);
        assert_eq!(Rule::of_at_least(9).count(), 10);
        assert_eq!(Rule::of_at_least(1000).count(), 40);
    }
}
