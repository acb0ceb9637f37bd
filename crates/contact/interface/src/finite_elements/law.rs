//! Law given by its points.

use crate::finite_elements::UnitSystem;

/// State of a rough surface under a nominal pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawPoint {
    /// Nominal pressure > 0 \[Pa\].
    pub pressure_pa: f64,
    /// Mean gap \[m\], of either sign: only differences matter.
    pub mean_gap_m: f64,
    /// Real over nominal area of contact.
    pub area_fraction: f64,
}

/// Pressure over overclosure, linear between its points.
///
/// The overclosure of a point is u_ref - u, with u its mean gap and u_ref that of the first point, which is taken as
/// first touch: the pressure at larger gaps is cut off. The second point has the smallest requested pressure and the
/// first one 1/e of it, so that an exponential law ends in its tangent.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ContactLaw {
    /// Points by rising pressure, at least three; the law is cut off at the first.
    pub points: Vec<LawPoint>,
    /// Requested relative error of the pressure.
    pub tolerance: f64,
    /// Largest relative error of the pressure found halfway between two points, from the second on.
    pub interpolation_error: f64,
}

impl ContactLaw {
    /// Point at which the law is cut off: its mean gap has the overclosure 0, and no pressure.
    #[must_use]
    pub fn cut(&self) -> LawPoint {
        self.points[0]
    }

    /// Overclosure \[m\] at a mean gap \[m\].
    #[must_use]
    pub fn overclosure_m(&self, mean_gap_m: f64) -> f64 {
        self.cut().mean_gap_m - mean_gap_m
    }

    /// Pressure \[Pa\] of the table at an overclosure \[m\]: 0 before first touch; beyond the last point the last
    /// line is continued.
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
        // In this order nothing underflows: the share has digits wherever the lengths have.
        low_pa + (high_pa - low_pa) * ((overclosure_m - low_m) / (high_m - low_m))
    }

    /// Pressure and overclosure of every point in the given units: both 0 at first.
    pub fn rows(&self, units: UnitSystem) -> impl Iterator<Item = (f64, f64)> {
        let cut = std::iter::once((0.0, 0.0));
        cut.chain(self.points.iter().skip(1).map(move |point| {
            (units.pressure(point.pressure_pa), units.length(self.overclosure_m(point.mean_gap_m)))
        }))
    }
}
