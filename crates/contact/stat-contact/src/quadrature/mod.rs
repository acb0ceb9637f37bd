//! Integrals over the heights of the asperities.
//!
//! p(d) = eta Int_0^inf F(w) g(d + w) dw, and likewise with the area A (Greenwood & Williamson 1966). The law is
//! costly and does not depend on d; the density is cheap and does. So a [`Frame`](frames::Frame) holds the law's values at the nodes
//! of a quadrature that [`build`] has laid around one separation, and sums them against the density at any separation
//! nearby. A search for the separation that carries a load therefore evaluates the law once, not once per step.

pub mod build;
pub mod frames;
pub mod panels;
pub mod rules;

use asperity::elementary;

/// Range of separations, in units of sigma_s, that one quadrature serves.
///
/// The cells are fixed. Every search that ends in a cell ends on the same quadrature, and so on the same digits,
/// whatever its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    index: f64,
}

impl Cell {
    /// Width of a cell: absolute at negative separations, relative to 1 + u at positive ones, where the density in
    /// contact is narrower by that factor.
    const WIDTH: f64 = 0.1;

    /// Arbitrary cell, for quadratures that serve every cell.
    pub const ANY: Cell = Cell { index: 0.0 };

    /// Cell of a separation.
    pub fn containing(u: f64) -> Cell {
        let position = if u > 0.0 { elementary::ln_1p(u) } else { u };
        Cell { index: (position / Self::WIDTH).round() }
    }

    /// Separation in the middle of the cell.
    pub fn centre(self) -> f64 {
        Self::separation(self.index)
    }

    /// Smallest separation in the cell.
    pub fn nearest(self) -> f64 {
        Self::separation(self.index - 0.5)
    }

    /// Largest separation in the cell.
    pub fn farthest(self) -> f64 {
        Self::separation(self.index + 0.5)
    }

    /// True if another cell is next to this one.
    pub fn is_beside(self, other: Cell) -> bool {
        (self.index - other.index).abs() == 1.0
    }

    /// True if the separations of this cell are smaller than those of another cell.
    pub fn is_nearer_than(self, other: Cell) -> bool {
        self.index < other.index
    }

    fn separation(index: f64) -> f64 {
        let position = index * Self::WIDTH;
        if position > 0.0 { elementary::exp_m1(position) } else { position }
    }
}

/// Required precision of a quadrature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Precision {
    /// Relative error aimed at.
    pub tolerance: f64,
    /// -ln of the relative error of a rule.
    pub digits: f64,
    /// Drop of the density, as -ln of its largest value, below which it is left out.
    pub drop: f64,
}

impl Precision {
    pub const FINEST: f64 = 1e-13;
    pub const COARSEST: f64 = 1e-2;

    /// Creates the precision for a relative tolerance, limited to what doubles and the rules can do.
    pub fn new(tolerance: f64) -> Self {
        let tolerance = tolerance.clamp(Self::FINEST, Self::COARSEST);
        let digits = -elementary::ln(tolerance);
        // At a tenth of the tolerance rules are worth their nodes: fewer panels have to be refined.
        const SPARE_DIGITS: f64 = 2.5;
        // The part left out of a response like s^2 is drop^2/2 exp(-drop), less than the tolerance.
        const SPARE_DROP: f64 = 2.0;
        let drop = digits + 2.0 * elementary::ln(digits) + SPARE_DROP;
        Precision { tolerance, digits: digits + SPARE_DIGITS, drop }
    }

    /// Returns the precision that separations around u need. Far below the mean plane ln p goes like ln(-u), and a
    /// search needs its slope and its curvature, which are means of heights of the order of 1/u and 1/u^2.
    pub fn around(self, u: f64) -> Self {
        // Tolerance over the curvature of ln p.
        const SHARE: f64 = 0.1;
        let depth = u.min(0.0);
        // Dividing by zero would leave a flag of the processor set.
        if depth == 0.0 {
            return self;
        }
        let curvature = SHARE / (depth * depth);
        if self.tolerance <= curvature { self } else { Self::new(curvature) }
    }
}

/// Relative error to report for integrals at the separation u, from the errors of their rules and of the parts left
/// out.
pub(crate) fn error_estimate(rules: f64, u: f64) -> f64 {
    // Rounding of sums of a hundred positive terms, and of the law in each.
    const ROUNDING: f64 = 1e-14;
    // With this factor the estimate bounds the error in 999 of 1000 reference states, and half lie within some forty
    // of it.
    const CAUTION: f64 = 4.0;
    // Far below the mean plane the interference has no more digits than u, and ln p changes by some units for one
    // unit of u.
    const UNITS: f64 = 8.0;
    let digits_of_u = UNITS * f64::EPSILON * (-u).max(0.0);
    CAUTION * rules + ROUNDING + digits_of_u
}

/// Integrals at one separation, over the reference density there.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub pressure_pa: f64,
    pub area_fraction: f64,
    /// Means of the height u + s, its square and its cube, weighted by load.
    mean_heights: [f64; 3],
}

impl Sums {
    /// Creates sums from pressure, area fraction, and means of the height u + s, its square and its cube, weighted by
    /// load.
    pub fn new(pressure_pa: f64, area_fraction: f64, mean_heights: [f64; 3]) -> Self {
        Sums { pressure_pa, area_fraction, mean_heights }
    }

    /// Derivative of ln p by u.
    pub fn log_pressure_slope(&self) -> f64 {
        -self.mean_heights[0]
    }

    /// First, second and third derivative of ln p by u.
    pub fn log_pressure_slopes(&self) -> [f64; 3] {
        let [mean, square, cube] = self.mean_heights;
        [-mean, square - mean * mean - 1.0, mean * (3.0 * square - 2.0 * mean * mean) - cube]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_contains_its_separations() {
        for u in [-1e4, -60.0, -0.03, 0.0, 0.07, 1.0, 59.9, 1e5] {
            let cell = Cell::containing(u);
            assert!(cell.nearest() <= u && u <= cell.farthest(), "{u}");
            assert_eq!(Cell::containing(cell.centre()), cell);
        }
    }

    #[test]
    fn the_tolerance_is_limited_to_reachable_ones() {
        assert_eq!(Precision::new(0.0), Precision::new(1e-13));
        assert_eq!(Precision::new(7.0), Precision::new(1e-2));
        assert!(Precision::new(1e-6).drop < Precision::new(1e-12).drop);
    }
}
