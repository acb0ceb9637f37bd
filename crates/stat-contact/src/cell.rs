//! Which separations share a quadrature, and how fine it has to be.

use asperity::elementary;

/// How fine a quadrature has to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Precision {
    /// Relative error aimed at.
    pub tolerance: f64,
    /// -ln of the relative error of a rule.
    pub digits: f64,
    /// The density below exp(-drop) of its largest is left out.
    pub drop: f64,
}

impl Precision {
    pub const FINEST: f64 = 1e-13;
    pub const COARSEST: f64 = 1e-2;

    /// For what is known in closed form.
    pub const EXACT: Precision = Precision { tolerance: 0.0, digits: f64::INFINITY, drop: f64::INFINITY };

    /// The precision for a relative tolerance, held within what doubles and the rules can do.
    pub fn new(tolerance: f64) -> Self {
        let tolerance = tolerance.clamp(Self::FINEST, Self::COARSEST);
        let digits = -elementary::ln(tolerance);
        // What is left out of a response like s^2 is drop^2/2 exp(-drop), less than the tolerance.
        Precision { tolerance, digits: digits + 2.5, drop: digits + 2.0 * elementary::ln(digits) + 2.0 }
    }

    /// The precision that a cell needs: far below the mean plane ln p goes like ln(-u), and a search has to see its slope
    /// and its curvature, which are means of heights of the order of 1/u and 1/u^2.
    pub fn in_cell(self, cell: Cell) -> Self {
        const SHARE: f64 = 0.1;
        let depth = cell.centre().min(0.0);
        let curvature = SHARE / (depth * depth);
        if self.tolerance <= curvature { self } else { Self::new(curvature) }
    }
}

/// The relative error to state of integrals at the separation u, from that of their rules and of what they leave out.
pub(crate) fn error_estimate(rules: f64, u: f64) -> f64 {
    const ROUNDING: f64 = 1e-14;
    // With it the estimate bounds the error in 999 of 1000 reference states, and half lie within some forty of it.
    const CAUTION: f64 = 4.0;
    // Far below the mean plane the interference has no more digits than u.
    let digits_of_u = 8.0 * f64::EPSILON * (-u).max(0.0);
    CAUTION * rules + ROUNDING + digits_of_u
}

/// A range of separations, in units of sigma_s, that one quadrature serves.
///
/// The cells are fixed. Every search that ends in a cell ends on the same quadrature, and so on the same digits,
/// wherever it came from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    index: f64,
}

impl Cell {
    /// Width of a cell: absolute among negative separations, relative to 1 + u among positive ones, where the
    /// density in contact is that much narrower.
    const WIDTH: f64 = 0.1;

    /// Any of them, where it does not matter which.
    pub const ANY: Cell = Cell { index: 0.0 };

    /// The cell of a separation.
    pub fn of(u: f64) -> Cell {
        let position = if u > 0.0 { elementary::ln_1p(u) } else { u };
        Cell { index: (position / Self::WIDTH).round() }
    }

    /// The separation in its middle.
    pub fn centre(self) -> f64 {
        Self::separation(self.index)
    }

    /// The smallest separation in it.
    pub fn nearest(self) -> f64 {
        Self::separation(self.index - 0.5)
    }

    /// The largest separation in it.
    pub fn farthest(self) -> f64 {
        Self::separation(self.index + 0.5)
    }

    /// Whether another cell is next to this one.
    pub fn is_beside(self, other: Cell) -> bool {
        (self.index - other.index).abs() == 1.0
    }

    /// Whether its separations are smaller than those of another cell.
    pub fn is_nearer_than(self, other: Cell) -> bool {
        self.index < other.index
    }

    fn separation(index: f64) -> f64 {
        let position = index * Self::WIDTH;
        if position > 0.0 { elementary::exp_m1(position) } else { position }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_holds_the_separations_that_it_is_the_cell_of() {
        for u in [-1e4, -60.0, -0.03, 0.0, 0.07, 1.0, 59.9, 1e5] {
            let cell = Cell::of(u);
            assert!(cell.nearest() <= u && u <= cell.farthest(), "{u}");
            assert_eq!(Cell::of(cell.centre()), cell);
        }
    }

    #[test]
    fn the_tolerance_is_held_within_reach() {
        assert_eq!(Precision::new(0.0), Precision::new(1e-13));
        assert_eq!(Precision::new(7.0), Precision::new(1e-2));
        assert!(Precision::new(1e-6).drop < Precision::new(1e-12).drop);
    }
}
