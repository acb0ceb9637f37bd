//! Searches that find crossings of the load slowly and surely.

use numerics::zero_in_bracket;

use super::bracket::Bracket;
use super::problem::{Found, OUT_OF_SIGHT, Search};
use crate::far::FAR;
use crate::quadrature::cell::Cell;

/// Where the pressure comes to be carried, from larger separations to smaller ones.
enum Crossing {
    /// It is at the first separation already.
    AtTop,
    /// At `low` and not at `high`.
    Between { low: f64, high: f64 },
    /// Nowhere down to this separation.
    NotAbove(f64),
}

/// Distances from a separation, each twice the last.
fn reaches(u: f64) -> impl Iterator<Item = f64> {
    // Of the first one, relative to 1 + |u|: a small part of a cell unless that is far below.
    const NARROWEST: f64 = 1e-6;
    const MOST_DOUBLINGS: i32 = 60;
    (0..MOST_DOUBLINGS).map(move |doubling| NARROWEST * (1.0 + u.abs()) * 2f64.powi(doubling))
}

impl Search<'_, '_> {
    /// The crossing of the load nearest to a separation, on the quadrature of its cell; `None` where the load is missing from
    /// there down to the depth at which searches end.
    pub fn crossing_around(&mut self, u: f64) -> Option<Found> {
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

    /// The crossing nearest to a separation that carries the load, at a larger one.
    pub fn crossing_beyond(&mut self, u: f64) -> Found {
        let mut low = u;
        for reach in reaches(u) {
            let high = u + reach;
            if self.missing_at(high) > 0.0 {
                return self.bisect(low, high);
            }
            low = high;
        }
        // The last reach is past any separation at which a pressure is above the smallest number.
        Found { cell: Cell::of(low), u: low }
    }

    /// The crossing between two separations, the nearer of which carries the pressure or more, and the other one does not.
    fn bisect(&mut self, low: f64, high: f64) -> Found {
        let u = zero_in_bracket(low, high, |u| self.missing_at(u));
        Found { cell: Cell::of(u), u }
    }

    /// The bracket of the largest solution for a force that steps down at an interference, in units of sigma_s.
    pub fn bracket_across(&mut self, step_down: f64) -> Bracket {
        let top = (OUT_OF_SIGHT - step_down).min(0.0);
        match self.crossing_below(top, -OUT_OF_SIGHT - step_down, |_| 0.0) {
            Crossing::AtTop => Bracket::between(top, f64::INFINITY),
            Crossing::Between { low, high } => Bracket::between(low, high),
            Crossing::NotAbove(high) => Bracket::between(f64::NEG_INFINITY, high),
        }
    }

    /// A force that dips between two rises carries some pressures thrice: the largest of these separations, where the one
    /// that was found, u, may be another.
    pub fn before_dip(&mut self, u: f64) -> Option<Found> {
        // Strides across a dip: at least four, and ten for each factor e of the separation.
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

    /// The largest separations from `top` down to `bottom` between which the pressure comes to be carried. The strides are
    /// those of the density, by which a step of the force is smeared out, or longer ones; a maximum between two of them
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
