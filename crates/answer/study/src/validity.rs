//! Bounds beyond which no method here describes a contact: slopes, strengths and strains.

/// The largest rms pressure of full contact, E* h'/2, over E*: beyond it slopes are too steep for a linear-elastic half-space.
pub const SMALL_SLOPE_PRESSURE: f64 = 0.1;

/// The rms gradient h' at which [`SMALL_SLOPE_PRESSURE`] is reached.
pub const SMALL_SLOPE_GRADIENT: f64 = 2.0 * SMALL_SLOPE_PRESSURE;

/// Young's modulus over the ideal strength, about the most that a solid bears.
pub const MODULUS_OVER_IDEAL_STRENGTH: f64 = 10.0;

/// E* over the largest pressure at which strains are small enough for linear elasticity.
pub const MODULUS_OVER_LARGEST_PRESSURE: f64 = 3.0;
