//! Input of sums over waves: the variance of the flattening pressure at the samples of a spectrum.

/// Variance up to one wavevector of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeparationKnot {
    /// Wavevector q > 0 \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Variance V >= 0 of the flattening pressure up to q \[Pa^2\].
    pub variance_pa2: f64,
    /// Exponent e of dV/dq ~ q^(e-1) between here and the next knot: 3 plus the exponent of C1D.
    pub variance_exponent: f64,
}
