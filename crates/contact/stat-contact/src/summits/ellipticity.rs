//! Average over the difference of a summit's curvatures, at a given mean of them.
//!
//! With the mean t and the half difference r of the principal curvatures, Nayak's density has (t^2 - r^2) 3r/m4
//! exp(-3 r^2/(2 m4)). With rho = r/t and x = 3 t^2/(2 m4) the area and the force of a sphere are multiplied by
//!
//! ```text
//! h(x) = Int_0^1 rho (1 - rho^2) f(rho) exp(-x rho^2) d rho,
//! ```
//!
//! with f the factors of Hertz's ellipse. Both depend on x alone: they are integrated once, at Chebyshev points, and
//! then evaluated by polynomials.

use std::sync::LazyLock;

use asperity::HertzEllipse;
use numerics::GaussLegendre;

use crate::gaussian::polynomial::value;

/// Terms of the polynomials: with more, the rounding of the interpolated values shows.
const TERMS: usize = 36;
/// The polynomials are of (x - MIDDLE)/(x + MIDDLE), and need the fewest terms with this one.
const MIDDLE: f64 = 16.0;

/// Factors by which the spread of r multiplies the area and the force of spheres.
pub(crate) struct Ellipticity {
    area: [f64; TERMS],
    force: [f64; TERMS],
}

impl Ellipticity {
    /// The only table, computed at its first use.
    pub fn table() -> &'static Self {
        static TABLE: LazyLock<Ellipticity> = LazyLock::new(Ellipticity::new);
        &TABLE
    }

    /// Returns h(x) of area and of force for x >= 0, within 1e-13 of them; about 1/(2x) for large x.
    pub fn at(&self, x: f64) -> [f64; 2] {
        let reciprocal = 1.0 / (x + MIDDLE);
        let t = (x - MIDDLE) * reciprocal;
        [value(&self.area, t) * reciprocal, value(&self.force, t) * reciprocal]
    }

    fn new() -> Self {
        let nodes = nodes();
        let values = chebyshev_points().map(|t| {
            let x = MIDDLE * (1.0 + t) / (1.0 - t);
            let integrals = nodes.iter().fold([0.0; 2], |[area, force], node| {
                let share = (-x * node.rho_squared).exp();
                [area + node.area * share, force + node.force * share]
            });
            integrals.map(|integral| (x + MIDDLE) * integral)
        });
        Ellipticity {
            area: polynomial(&values.map(|[area, _]| area)),
            force: polynomial(&values.map(|[_, force]| force)),
        }
    }
}

/// Node of the rule over rho, with the weight of everything but the exponential.
struct Node {
    rho_squared: f64,
    area: f64,
    force: f64,
}

/// Nodes of a rule over ln((1 + rho)/(1 - rho))/2 = ln(k1/k2)/2, in which the integrand is smooth up to the
/// slenderest ellipses; finer towards rho = 0, where the exponential of a large x confines it.
fn nodes() -> Vec<Node> {
    const ENDS: [f64; 8] = [0.0, 0.01, 0.04, 0.16, 0.64, 2.0, 5.0, 14.0];
    let rule = GaussLegendre::new(24);
    let node = |(eta, weight): (f64, f64)| {
        let ellipse = HertzEllipse::from_curvatures(2.0 * eta);
        let rho = eta.tanh();
        let spheres = weight * rho * eta.cosh().powi(-4);
        Node {
            rho_squared: rho * rho,
            area: spheres * ellipse.area_factor(),
            force: spheres * ellipse.force_factor(),
        }
    };
    ENDS.windows(2).flat_map(|ends| rule.over(ends[0], ends[1]).map(node).collect::<Vec<_>>()).collect()
}

fn chebyshev_points() -> [f64; TERMS] {
    std::array::from_fn(|at| angle(at).cos())
}

fn angle(at: usize) -> f64 {
    std::f64::consts::PI * (at as f64 + 0.5) / TERMS as f64
}

/// The polynomial through values at the Chebyshev points, lowest power first. Its coefficients fall fast enough for
/// powers to lose nothing.
fn polynomial(values: &[f64; TERMS]) -> [f64; TERMS] {
    let coefficient = |degree: usize| {
        let sum: f64 =
            values.iter().enumerate().map(|(at, value)| value * (degree as f64 * angle(at)).cos()).sum();
        sum * if degree == 0 { 1.0 } else { 2.0 } / TERMS as f64
    };
    let mut powers = [0.0; TERMS];
    // Powers of T_k and of the polynomial before.
    let (mut last, mut before) = ([0.0; TERMS], [0.0; TERMS]);
    last[0] = 1.0;
    for degree in 0..TERMS {
        let weight = coefficient(degree);
        powers.iter_mut().zip(&last).for_each(|(power, of_last)| *power += weight * of_last);
        // T_1 = t, and T_(k+1) = 2 t T_k - T_(k-1).
        let factor = if degree == 0 { 1.0 } else { 2.0 };
        let shifted = |power: usize| if power == 0 { 0.0 } else { last[power - 1] };
        let next = std::array::from_fn(|power| factor * shifted(power) - before[power]);
        (before, last) = (last, next);
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_averages_agree_with_twenty_digits() {
        for (x, area, force) in EXACT {
            let [computed_area, computed_force] = Ellipticity::table().at(x);
            assert!((computed_area / area - 1.0).abs() < 1e-13, "{x}: {computed_area:e}");
            assert!((computed_force / force - 1.0).abs() < 1e-13, "{x}: {computed_force:e}");
        }
    }

    /// x, h of the area, h of the force.
    const EXACT: [(f64, f64, f64); 7] = [
        (0.0, 0.321_607_862_453_541_9, 0.301_986_495_759_879_6),
        (0.125, 0.306_405_732_031_283_2, 0.288_212_428_697_568_1),
        (1.0, 0.224_549_079_573_402_73, 0.213_564_477_121_584_02),
        (7.5, 0.061_344_316_865_298, 0.060_430_443_052_967_01),
        (40.0, 0.012_324_386_133_908_286, 0.012_290_017_442_228_418),
        (1000.0, 0.000_499_722_098_588_044_7, 0.000_499_666_564_675_594_3),
        (1e8, 4.999_999_972_222_222e-9, 4.999_999_966_666_666e-9),
    ];
}
