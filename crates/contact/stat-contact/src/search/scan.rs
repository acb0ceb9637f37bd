//! Slow and sure searches for crossings of the load.

use numerics::zero_in_bracket;

use super::bracket::Bracket;
use super::problem::{CellSolution, OUT_OF_SIGHT, Search};
use crate::far::FAR;
use crate::quadrature::Cell;

/// Position at which the pressure comes to be carried, from larger separations to smaller ones.
enum Crossing {
    /// Already at the first separation.
    AtTop,
    /// Between `low`, where it is carried, and `high`, where it is not.
    Between { low: f64, high: f64 },
    /// Nowhere down to this separation.
    NotAbove(f64),
}

/// Distances from a separation, each twice the last.
fn reaches(u: f64) -> impl Iterator<Item = f64> {
    // First distance, relative to 1 + |u|: a small part of a cell except far below.
    const NARROWEST: f64 = 1e-6;
    const MOST_DOUBLINGS: i32 = 60;
    (0..MOST_DOUBLINGS).map(move |doubling| NARROWEST * (1.0 + u.abs()) * 2f64.powi(doubling))
}

impl Search<'_, '_> {
    /// Crossing of the load nearest to a separation, on the quadrature of its cell; `None` if the load is missing
    /// from there down to the depth at which searches end.
    pub fn crossing_around(&mut self, u: f64) -> Option<CellSolution> {
        if self.missing_at(u) <= 0.0 {
            return Some(self.crossing_beyond(u));
        }
        let mut high = u;
        for reach in reaches(u) {
            let low = (u - reach).max(-FAR);
            if self.missing_at(low) <= 0.0 {
                return Some(self.bisect(low, high));
            }
            if low == -FAR {
                break;
            }
            high = low;
        }
        None
    }

    /// Crossing at a larger separation that is nearest to one that carries the load.
    pub fn crossing_beyond(&mut self, u: f64) -> CellSolution {
        let mut low = u;
        for reach in reaches(u) {
            let high = u + reach;
            if self.missing_at(high) > 0.0 {
                return self.bisect(low, high);
            }
            low = high;
        }
        // The last distance is past any separation whose pressure is above the smallest number.
        CellSolution { cell: Cell::containing(low), u: low }
    }

    /// Crossing between two separations; the nearer one carries the pressure or more, the other one less.
    fn bisect(&mut self, low: f64, high: f64) -> CellSolution {
        let u = zero_in_bracket(low, high, |u| self.missing_at(u));
        CellSolution { cell: Cell::containing(u), u }
    }

    /// Bracket of the largest solution for a force that steps down at an interference, in units of sigma_s.
    pub fn bracket_across(&mut self, step_down: f64) -> Bracket {
        let top = (OUT_OF_SIGHT - step_down).min(0.0);
        match self.crossing_below(top, -OUT_OF_SIGHT - step_down, |_| 0.0) {
            Crossing::AtTop => Bracket::between(top, f64::INFINITY),
            Crossing::Between { low, high } => Bracket::between(low, high),
            Crossing::NotAbove(high) => Bracket::between(f64::NEG_INFINITY, high),
        }
    }

    /// Largest separation for a force that dips between two rises and carries some pressures three times; `None` if
    /// it is u, the one already found.
    pub fn before_dip(&mut self, u: f64) -> Option<CellSolution> {
        // Stride across a dip: at least four, and ten for each factor e of the separation.
        const SHARE_OF_DIP: f64 = 0.25;
        const SHARE_OF_DEPTH: f64 = 0.1;
        let sigma_s_m = self.frames.sigma_s_m;
        let [from, to] = self.frames.asperities.dip_m()?.map(|at_m| at_m / sigma_s_m);
        let top = (OUT_OF_SIGHT - from).min(0.0);
        if u >= top {
            return None;
        }
        let bottom = (-OUT_OF_SIGHT - to).max(-FAR);
        let stride = |u: f64| (SHARE_OF_DEPTH * u.abs()).min(SHARE_OF_DIP * (to - from));
        match self.crossing_below(top, bottom, stride) {
            // Above the mean plane the pressure falls for good.
            Crossing::AtTop => self.crossing_around(top),
            Crossing::Between { low, high } => Some(self.bisect(low, high)),
            Crossing::NotAbove(_) => None,
        }
    }

    /// Largest separations from `top` down to `bottom` between which the pressure comes to be carried. The strides
    /// are those of the density, which smears out a step of the force, or longer ones; a maximum between two of them
    /// shows in the slopes.
    fn crossing_below(&mut self, top: f64, bottom: f64, longer: impl Fn(f64) -> f64) -> Crossing {
        const STRIDE: f64 = 0.5;
        let mut high = top;
        let mut at_high = self.pressure_at(high);
        if at_high.pa >= self.pressure_pa {
            return Crossing::AtTop;
        }
        while high > bottom {
            let low = high - longer(high).max(STRIDE);
            let at_low = self.pressure_at(low);
            if at_low.pa >= self.pressure_pa {
                return Crossing::Between { low, high };
            }
            if at_low.log_slope > 0.0 && at_high.log_slope <= 0.0 {
                let peak = zero_in_bracket(low, high, |u| self.pressure_at(u).log_slope);
                if self.pressure_at(peak).pa >= self.pressure_pa {
                    return Crossing::Between { low: peak, high };
                }
            }
            (high, at_high) = (low, at_low);
        }
        Crossing::NotAbove(high)
    }
}
