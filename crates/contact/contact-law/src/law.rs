//! A law by its points.

use crate::UnitSystem;

/// A rough surface under a nominal pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawPoint {
    /// Nominal pressure > 0 \[Pa\].
    pub pressure_pa: f64,
    /// Mean gap \[m\], of either sign: only differences of it count.
    pub mean_gap_m: f64,
    /// Real over nominal area of contact.
    pub area_fraction: f64,
}

/// Pressure against overclosure, straight between its points.
///
/// The overclosure of a point is u_ref - u, u being its mean gap and u_ref that of the first point, which stands for first
/// touch: what pressure there is at larger gaps is cut off. The smallest pressure asked for is that of the second point;
/// the first point is there at 1/e of it, so that a law that falls exponentially ends in its tangent.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLaw {
    pub(crate) points: Vec<LawPoint>,
    pub(crate) tolerance: f64,
    pub(crate) interpolation_error: f64,
}

impl ContactLaw {
    /// The points, by rising pressure; the first of them is where the law is cut off, and three at least.
    #[must_use]
    pub fn points(&self) -> &[LawPoint] {
        &self.points
    }

    /// The relative error of the pressure that was asked for.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The largest relative error of the pressure that was met halfway between two points, from the second on.
    #[must_use]
    pub fn interpolation_error(&self) -> f64 {
        self.interpolation_error
    }

    /// Where the law is cut off: the mean gap there has the overclosure 0, and no pressure.
    #[must_use]
    pub fn cut(&self) -> LawPoint {
        self.points[0]
    }

    /// The overclosure \[m\] at a mean gap \[m\].
    #[must_use]
    pub fn overclosure_m(&self, mean_gap_m: f64) -> f64 {
        self.cut().mean_gap_m - mean_gap_m
    }

    /// The pressure \[Pa\] of the table at an overclosure \[m\]: 0 before first touch, and beyond the last point on the last
    /// line.
    #[must_use]
    pub fn pressure_pa(&self, overclosure_m: f64) -> f64 {
        if overclosure_m <= 0.0 {
            return 0.0;
        }
        let row = |at: usize| {
            let point = &self.points[at];
            (self.overclosure_m(point.mean_gap_m), if at == 0 { 0.0 } else { point.pressure_pa })
        };
        let above = self.points.partition_point(|point| self.overclosure_m(point.mean_gap_m) < overclosure_m);
        let above = above.clamp(1, self.points.len() - 1);
        let ((low_m, low_pa), (high_m, high_pa)) = (row(above - 1), row(above));
        low_pa + (high_pa - low_pa) * (overclosure_m - low_m) / (high_m - low_m)
    }

    /// Pressure and overclosure of every point in these units: both 0 at first.
    pub fn rows(&self, units: UnitSystem) -> impl Iterator<Item = (f64, f64)> {
        let cut = std::iter::once((0.0, 0.0));
        cut.chain(self.points.iter().skip(1).map(move |point| {
            (units.pressure(point.pressure_pa), units.length(self.overclosure_m(point.mean_gap_m)))
        }))
    }
}
