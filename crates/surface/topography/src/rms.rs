//! Root mean squares of derivatives.

use serde::Serialize;

/// Root mean square slope and curvature along scan lines.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RmsDerivatives {
    /// Root mean square slope.
    pub slope: f64,
    /// Root mean square second derivative in 1/m; `None` for a line of two points.
    pub curvature_per_m: Option<f64>,
}
