//! Sums of a quadrature.

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
