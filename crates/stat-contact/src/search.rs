//! The separation that carries a pressure.
//!
//! Everything is in u = d/sigma_s and ln p, which is nearly a parabola of u. Pressure falls with u wherever u > 0, whatever
//! the law: dp/du is eta Int F(s) g'(u+s) ds, and g' is negative there. Elsewhere p turns at most as often as F does, the
//! Gaussian being variation diminishing: a force with one maximum makes a pressure with one, whose far side holds the
//! larger separation, and only a force that steps down between two rises has to be scanned.

use crate::asperities::{Asperities, Course};
use crate::cell::{Cell, Precision};
use crate::far::FAR;
use crate::frame::{Frame, Sums};
use crate::gaussian::{log_reference_density, reference_density};
use crate::root::in_bracket;

/// Steps after which a search ends in any case; each halves a bracket or better.
const MOST_STEPS: usize = 60;
/// Steps on rough quadratures, before fine ones are built.
const MOST_ROUGH_STEPS: usize = 12;
/// Where a search begins that has no start: light loads are the common ones.
const USUAL_SEPARATION: f64 = 2.0;
/// Standard deviations beyond which a feature of the law no longer shows.
const OUT_OF_SIGHT: f64 = 9.0;

/// A search for a pressure, which is carried no farther below the mean plane than [`FAR`].
pub(crate) struct Search<'a> {
    pub asperities: &'a dyn Asperities,
    pub sigma_s_m: f64,
    pub pressure_pa: f64,
    pub precision: Precision,
}

/// Where it ended, and what it cost.
pub(crate) struct Found<'a> {
    pub frame: Frame<'a>,
    pub u: f64,
    pub evaluations: usize,
}

/// Separations between which the solution lies: ln p is above the target at `low`, below it at `high`.
#[derive(Clone, Copy)]
struct Bracket {
    low: f64,
    high: f64,
    /// What a quadrature may misplace the solution by, relative to 1 + |u|.
    margin: f64,
}

impl Bracket {
    const EVERYTHING: Bracket =
        Bracket { low: f64::NEG_INFINITY, high: f64::INFINITY, margin: Self::ROUGH_MARGIN };
    const ROUGH_MARGIN: f64 = 0.02;
    /// Small enough for bisection to end in one cell, be it a million standard deviations below the mean plane.
    const FINE_MARGIN: f64 = 1e-8;

    fn holds(&self, u: f64) -> bool {
        self.low <= u && u <= self.high
    }

    /// Takes note that pressure is missing at u, or in excess. The margin keeps the bracket, which is there to stop runaway
    /// steps, from cutting off the solution of the next quadrature, which differs by the error of this one.
    fn narrow(&mut self, u: f64, missing: f64) {
        let margin = self.margin * (1.0 + u.abs());
        if missing > 0.0 {
            self.high = self.high.min(u + margin);
        } else {
            self.low = self.low.max(u - margin);
        }
    }

    /// `next` where it is inside; else the middle, or a stride towards an end that is not known yet.
    fn hold(&self, u: f64, next: f64, missing: f64) -> f64 {
        let stride = 8.0 + u.abs();
        let next = if next.is_nan() { -missing.signum() * f64::INFINITY } else { next };
        // A step across most of the bracket tells little: where the pressure jumps, steps from both sides would go on
        // landing at each other's ends.
        let longest = (0.75 * (self.high - self.low)).max(2.0 * self.margin * (1.0 + u.abs())).min(stride);
        if self.low <= next && next <= self.high && (next - u).abs() <= longest {
            next
        } else if self.low.is_finite() && self.high.is_finite() {
            0.5 * (self.low + self.high)
        } else {
            (u - missing.signum() * stride).clamp(self.low, self.high)
        }
    }
}

impl<'a> Search<'a> {
    /// The largest separation that carries the pressure, `None` where none does. `start` only saves work.
    pub fn run(&self, start: Option<f64>) -> Option<Found<'a>> {
        let mut found = self.find(start);
        if let Some(near) = &mut found {
            if self.is_carried_by(near) {
                return found;
            }
            if let Some(bisected) = self.bisect_around(near.u) {
                return Some(bisected);
            }
        }
        match self.peak() {
            Some(peak) if self.pressure_pa <= self.pressure_and_slope(peak).0 => self.bisect_around(peak),
            Some(_) => None,
            None => found,
        }
    }

    /// Whether a search has converged. Near a maximum, and between several, its parabolas may not lead to the load.
    fn is_carried_by(&self, found: &mut Found) -> bool {
        const CLOSE: f64 = 1e-11;
        let sums = found.frame.sums_at(found.u);
        self.missing(found.u, &sums).abs() <= CLOSE + 8.0 * f64::EPSILON * self.pressure_pa.ln().abs()
    }

    /// The crossing of the load nearest to a separation, each on the quadrature of its cell: slow and sure.
    fn bisect_around(&self, u: f64) -> Option<Found<'a>> {
        const NARROWEST: f64 = 1e-6;
        const MOST_DOUBLINGS: i32 = 60;
        let mut evaluations = 0;
        // The last halvings go to and fro between two cells, or stay in one.
        let mut frames: [Option<(Cell, Frame)>; 2] = [None, None];
        let mut missing = |u: f64| {
            let cell = Cell::of(u);
            if frames[0].as_ref().is_none_or(|(of, _)| *of != cell) {
                frames.swap(0, 1);
            }
            if frames[0].as_ref().is_none_or(|(of, _)| *of != cell) {
                let frame = Frame::for_cell(self.asperities, self.sigma_s_m, cell, self.precision);
                evaluations += frame.evaluations;
                frames[0] = Some((cell, frame));
            }
            let (_, frame) = frames[0].as_mut().expect("the frame of the cell");
            let sums = frame.sums_at(u);
            self.missing(u, &sums)
        };
        let mut last_high = None;
        let bracket = (0..MOST_DOUBLINGS).find_map(|doubling| {
            let reach = NARROWEST * (1.0 + u.abs()) * 2f64.powi(doubling);
            let (low, high) = (last_high.unwrap_or((u - reach).max(-FAR)), u + reach);
            if missing(high) > 0.0 {
                return (missing(low) <= 0.0).then_some((low, high));
            }
            last_high = Some(high);
            None
        });
        let u = bracket.map(|(low, high)| in_bracket(low, high, &mut missing))?;
        let frame = Frame::for_cell(self.asperities, self.sigma_s_m, Cell::of(u), self.precision);
        Some(Found { evaluations: evaluations + frame.evaluations, frame, u })
    }

    fn find(&self, start: Option<f64>) -> Option<Found<'a>> {
        let near = start.unwrap_or(USUAL_SEPARATION);
        match self.asperities.course(self.sigma_s_m) {
            Course::StepsDown { at_m } if at_m < FAR * self.sigma_s_m => {
                let bracket = self.scan_across(at_m / self.sigma_s_m);
                self.solve(near.clamp(bracket.low, bracket.high), bracket)
            }
            // From a fixed start, so that it is always the same maximum.
            Course::Peaks { certain: false } => self.solve(USUAL_SEPARATION, Bracket::EVERYTHING),
            _ => self.solve(near, Bracket::EVERYTHING),
        }
    }

    /// The highest pressure \[Pa\] that a separation carries, or its limit.
    pub fn highest_pressure_pa(&self) -> f64 {
        match self.peak() {
            Some(peak) => self.pressure_and_slope(peak).0,
            None => self.asperities.highest_response_pa(),
        }
    }

    /// For a force with a maximum: the separation at which the pressure has it.
    fn peak(&self) -> Option<f64> {
        let edge = self.far_edge()?;
        let rises_at_edge = self.pressure_and_slope(edge).1 > 0.0;
        Some(if rises_at_edge { in_bracket(edge, 0.0, |u| self.pressure_and_slope(u).1) } else { edge })
    }

    /// For a force with a maximum: a separation beyond which the pressure only falls as the surfaces approach, or where
    /// the search ends.
    fn far_edge(&self) -> Option<f64> {
        Some((-OUT_OF_SIGHT - self.asperities.falls_from_m()? / self.sigma_s_m).max(-FAR))
    }

    /// The bracket of the largest solution for a force that steps down at an interference. The steps are those of the
    /// density, by which the step of the force is smeared out; a maximum between two of them shows in the slopes.
    fn scan_across(&self, step_down: f64) -> Bracket {
        let mut high = (OUT_OF_SIGHT - step_down).min(0.0);
        let (pressure_pa, mut slope_at_high) = self.pressure_and_slope(high);
        if pressure_pa >= self.pressure_pa {
            return Bracket { low: high, ..Bracket::EVERYTHING };
        }
        while high > -OUT_OF_SIGHT - step_down {
            let mut low = high - 0.5;
            let (mut pressure_pa, slope) = self.pressure_and_slope(low);
            if slope > 0.0 && slope_at_high <= 0.0 && pressure_pa < self.pressure_pa {
                let peak = in_bracket(low, high, |u| self.pressure_and_slope(u).1);
                if self.pressure_and_slope(peak).0 >= self.pressure_pa {
                    (low, pressure_pa) = (peak, f64::INFINITY);
                }
            }
            if pressure_pa >= self.pressure_pa {
                return Bracket { low, high, ..Bracket::EVERYTHING };
            }
            (high, slope_at_high) = (low, slope);
        }
        Bracket { high, ..Bracket::EVERYTHING }
    }

    /// Pressure \[Pa\] and derivative of ln p by u, each separation on the quadrature of its cell.
    fn pressure_and_slope(&self, u: f64) -> (f64, f64) {
        let mut frame = Frame::for_cell(self.asperities, self.sigma_s_m, Cell::of(u), self.precision);
        let sums = frame.sums_at(u);
        (sums.pressure_pa * reference_density(u), sums.log_pressure_slopes()[0])
    }

    fn solve(&self, start: f64, bracket: Bracket) -> Option<Found<'a>> {
        let (near, rough_evaluations) = self.approach(start, bracket);
        let found = self.settle(near, bracket)?;
        Some(Found { evaluations: found.evaluations + rough_evaluations, ..found })
    }

    /// Gets within a few percent of a standard deviation, on quadratures of a few nodes.
    fn approach(&self, start: f64, mut bracket: Bracket) -> (f64, usize) {
        let (mut u, mut evaluations) = (start, 0);
        for _ in 0..MOST_ROUGH_STEPS {
            let mut frame = Frame::rough(self.asperities, self.sigma_s_m, u);
            evaluations += frame.evaluations;
            let Some(next) = self.next(u, &frame.sums_at(u), &mut bracket) else { break };
            let step = next - u;
            u = next;
            // Steps converge with the fourth power, on the scale of 1 + |u|; cells are as wide as their separation is positive.
            let left = step.abs() * (step / (1.0 + u.abs())).abs().powi(3);
            if left < 0.005 * (1.0 + u.max(0.0)) {
                break;
            }
        }
        (u, evaluations)
    }

    /// Solves on the quadrature of the cell that the solution lies in.
    fn settle(&self, mut u: f64, bracket: Bracket) -> Option<Found<'a>> {
        let mut bracket = Bracket { margin: Bracket::FINE_MARGIN, ..bracket };
        let mut evaluations = 0;
        let mut cell = Cell::of(u);
        let mut left = None;
        for step in 0.. {
            let mut frame = Frame::for_cell(self.asperities, self.sigma_s_m, cell, self.precision);
            evaluations += frame.evaluations;
            // At the centre of its cell a quadrature is summed already, and a rough separation is no nearer the solution;
            // one that another cell has found is.
            let centre = cell.centre();
            let start = if left.is_none() && bracket.holds(centre) { centre } else { u };
            u = self.solve_on(&mut frame, start, &mut bracket)?;
            let next = Cell::of(u);
            // Two neighbouring cells may each place the solution just beyond their common edge; the nearer one has it.
            let undecided = left == Some(next) && next.is_beside(cell);
            if next == cell || (undecided && cell.is_nearer_than(next)) || step == MOST_STEPS {
                return Some(Found { frame, u, evaluations });
            }
            left = Some(cell);
            cell = next;
        }
        unreachable!("the last step returns")
    }

    /// The solution on a quadrature, or a separation that needs another one; `None` above the highest pressure.
    fn solve_on(&self, frame: &mut Frame, start: f64, bracket: &mut Bracket) -> Option<f64> {
        const LAST_STEP: f64 = 1e-4;
        let mut u = start;
        for _ in 0..MOST_STEPS {
            let next = self.next(u, &frame.sums_at(u), bracket)?;
            let step = next - u;
            u = next;
            // The error of a step is the fourth power of the one before: the next one would not show.
            if step.abs() < LAST_STEP * (1.0 + u.max(0.0)) || !frame.serves(u) {
                break;
            }
        }
        Some(u)
    }

    /// How much ln p falls short of the target at u. The quotient of the pressures keeps the digits that their logarithms
    /// would round off, which near complete contact are all that tells one separation from another.
    fn missing(&self, u: f64, sums: &Sums) -> f64 {
        let quotient = self.pressure_pa / sums.pressure_pa;
        let log_quotient =
            if quotient.is_normal() { quotient.ln() } else { self.pressure_pa.ln() - sums.pressure_pa.ln() };
        log_quotient - log_reference_density(u)
    }

    /// Where the parabola through ln p at u meets the target, or its tangent where it does not, bent as ln p is.
    fn next(&self, u: f64, sums: &Sums, bracket: &mut Bracket) -> Option<f64> {
        let missing = self.missing(u, sums);
        let [slope, curvature, third] = sums.log_pressure_slopes();
        if let Some(edge) = self.far_edge() {
            if missing > 0.0 && u < edge {
                // The slope may be lost in rounding here; the peak has to be looked up.
                if self.pressure_pa > self.highest_pressure_pa() {
                    return None;
                }
                bracket.narrow(u, -1.0);
                return Some(bracket.hold(u, f64::NAN, -1.0));
            }
            if slope >= 0.0 || (curvature < 0.0 && slope * slope < -2.0 * missing * curvature) {
                return Self::next_to_peak(u, missing, [slope, curvature], bracket);
            }
        }
        bracket.narrow(u, missing);
        let discriminant = (slope * slope + 2.0 * missing * curvature).max(0.25 * slope * slope);
        let step = 2.0 * missing / (slope - discriminant.sqrt());
        // One step of Newton's from there on the cubic: with it most searches sum the density twice, without it thrice.
        let bend = third * step * step / 6.0 * step / (slope + step * (curvature + 0.5 * third * step));
        let step = if bend.abs() < 0.25 * step.abs() { step - bend } else { step };
        Some(bracket.hold(u, u + step, missing))
    }

    /// Where u lies on the near side of the peak, or the parabola through ln p does not reach the target: the far side of
    /// the parabola where that meets the target, else its peak; `None` where u is at the peak, and that is too low.
    fn next_to_peak(
        u: f64,
        missing: f64,
        [slope, curvature]: [f64; 2],
        bracket: &mut Bracket,
    ) -> Option<f64> {
        const AT_THE_PEAK: f64 = 1e-4;
        // Seen from its near side the solution lies beyond the peak, as if there were too much pressure.
        let missing_here = if slope >= 0.0 { -1.0 } else { missing };
        bracket.narrow(u, missing_here);
        if curvature >= 0.0 {
            return Some(bracket.hold(u, f64::NAN, missing_here));
        }
        let discriminant = slope * slope + 2.0 * missing * curvature;
        let step = -(slope + discriminant.max(0.0).sqrt()) / curvature;
        if discriminant < 0.0 && step.abs() < AT_THE_PEAK * (1.0 + u.abs()) {
            return None;
        }
        Some(bracket.hold(u, u + step, missing_here))
    }
}
