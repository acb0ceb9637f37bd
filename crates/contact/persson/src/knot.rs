//! A spectrum as the sums over its waves take it: the variance of the flattening pressure at its samples.

/// A place along the spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeparationKnot {
    /// Wavevector q > 0 \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Variance V >= 0 of the flattening pressure up to there \[Pa^2\].
    pub variance_pa2: f64,
    /// e of dV/dq ~ q^(e-1) between here and the next knot; 3 and the exponent of C1D.
    pub variance_exponent: f64,
}
