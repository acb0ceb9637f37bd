//! Flats so far below the mean plane that the spread of the heights is negligible.
//!
//! At u = d/sigma_s the spread changes the response by a relative 1/u^2. From a million standard deviations down this
//! is below rounding, while the heights themselves lose their digits to u: there every asperity is taken at the mean
//! height.

use numerics::{minimum_in_bracket, zero_in_bracket};

use crate::ContactState;
use crate::asperities::answers::{Asperities, Course, Response};

/// Depth below the mean plane, in units of sigma_s, from which on asperities are taken at the mean height.
pub(crate) const FAR: f64 = 1e6;

/// Golden sections of a bracket: 0.618^90 of any is below rounding.
const STEPS: usize = 90;

/// A population without spread.
pub(crate) struct FarBelow<'a> {
    asperities: &'a dyn Asperities,
    sigma_s_m: f64,
}

impl<'a> FarBelow<'a> {
    pub fn new(asperities: &'a dyn Asperities, sigma_s_m: f64) -> Self {
        FarBelow { asperities, sigma_s_m }
    }

    /// State at a separation; `None` unless it is far below.
    pub fn at_separation(&self, separation_m: f64) -> Option<ContactState> {
        (separation_m < -FAR * self.sigma_s_m).then(|| self.state(separation_m))
    }

    /// State at a separation far below. The error of leaving out the spread is seen by comparing three heights: next
    /// to nothing where the law is smooth, up to a share of a kink or a jump beside one.
    pub fn state(&self, separation_m: f64) -> ContactState {
        // Standard deviations that hold nearly all heights.
        const REACH: f64 = 3.0;
        let [low, mean, high] = [-REACH, 0.0, REACH]
            .map(|shift| self.asperities.at_interference(shift.mul_add(self.sigma_s_m, -separation_m)));
        let bend = |of: fn(&Response) -> f64| (of(&low) - 2.0 * of(&mean) + of(&high)).abs() / of(&mean);
        let neglected = bend(|at| at.pressure_pa).max(bend(|at| at.area_fraction));
        ContactState::without_spread(separation_m, &mean, neglected)
    }

    /// Largest separation \[m\] that carries a pressure; `None` unless it is far below.
    pub fn separation_m(&self, log_pressure: f64) -> Option<f64> {
        let nearest_m = FAR * self.sigma_s_m;
        let missing = |log_m: f64| log_pressure - self.log_response(log_m);
        if missing(nearest_m.ln()) <= 0.0 {
            return None;
        }
        if let Some(top_m) = self.top_before_dip_m().filter(|top_m| missing(top_m.ln()) <= 0.0) {
            return Some(-zero_in_bracket(nearest_m.ln(), top_m.ln(), missing).exp());
        }
        let deepest_m = match self.asperities.course(self.sigma_s_m) {
            Course::Rises => self.deep_enough_m(missing)?,
            Course::Peaks { .. } => self.peak_m().filter(|peak_m| missing(peak_m.ln()) <= 0.0)?,
            Course::StepsDown { at_m } => {
                // Far enough from the step for the rounding of logarithms.
                let top_m = at_m * (1.0 - 1e-13);
                let on_near_side = top_m > nearest_m && missing(top_m.ln()) <= 0.0;
                if on_near_side { top_m } else { self.deep_enough_m(missing)? }
            }
        };
        Some(-zero_in_bracket(nearest_m.ln(), deepest_m.ln(), missing).exp())
    }

    /// Interference \[m\] of the maximum before a dip of the force; `None` unless it is far below.
    fn top_before_dip_m(&self) -> Option<f64> {
        let [from_m, to_m] = self.asperities.dip_m()?;
        let low = from_m.max(FAR * self.sigma_s_m).ln();
        (low < to_m.ln())
            .then(|| minimum_in_bracket(low, to_m.ln(), STEPS, |log_m| -self.log_response(log_m)).exp())
    }

    /// Interference \[m\] at which no pressure is missing; `None` if the pressure is never reached.
    fn deep_enough_m(&self, missing: impl Fn(f64) -> f64) -> Option<f64> {
        // Three decades at a time; eighty strides exhaust the doubles.
        const STRIDE: f64 = 1e3;
        const MOST_STRIDES: i32 = 80;
        (1..MOST_STRIDES)
            .map(|stride| FAR * self.sigma_s_m * STRIDE.powi(stride))
            .find(|depth_m| missing(depth_m.ln()) <= 0.0)
    }

    /// Highest pressure \[Pa\]; `None` unless it is carried far below.
    pub fn highest_pressure_pa(&self) -> Option<f64> {
        self.peak_m().map(|peak_m| self.asperities.at_interference(peak_m).pressure_pa)
    }

    /// Interference \[m\] of the highest response, by golden sections between the nearest far interference and one
    /// beyond which the response is known to fall; `None` unless it is far below.
    fn peak_m(&self) -> Option<f64> {
        let (low, high) = ((FAR * self.sigma_s_m).ln(), self.asperities.falls_from_m()?.ln());
        (low < high).then(|| minimum_in_bracket(low, high, STEPS, |log_m| -self.log_response(log_m)).exp())
    }

    fn log_response(&self, log_interference: f64) -> f64 {
        self.asperities.at_interference(log_interference.exp()).pressure_pa.ln()
    }
}
