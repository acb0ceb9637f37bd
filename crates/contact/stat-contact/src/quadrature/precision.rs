//! Precision of a quadrature and the error that it reports.

use asperity::elementary;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tolerance_is_limited_to_reachable_ones() {
        assert_eq!(Precision::new(0.0), Precision::new(1e-13));
        assert_eq!(Precision::new(7.0), Precision::new(1e-2));
        assert!(Precision::new(1e-6).drop < Precision::new(1e-12).drop);
    }
}
