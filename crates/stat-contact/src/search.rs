//! The separation that carries a pressure.
//!
//! Everything is in u = d/sigma_s and ln p, which is nearly a parabola of u. Pressure falls with u wherever u > 0, whatever
//! the law: dp/du is eta Int F(s) g'(u+s) ds, and g' is negative there. Elsewhere p turns at most as often as F does, the
//! Gaussian being variation diminishing: a force with one maximum makes a pressure with one, whose far side holds the
//! larger separation, and only a force that steps down or dips between two rises has to be scanned.

use numerics::zero_in_bracket;

use crate::asperities::Course;
use crate::cell::Cell;
use crate::far::FAR;
use crate::frame::Sums;
use crate::frames::Frames;
use crate::gaussian::{log_reference_density, reference_density};

/// Steps after which a search ends in any case; each halves a bracket or better.
const MOST_STEPS: usize = 60;
/// Steps on rough quadratures, before fine ones are built.
const MOST_ROUGH_STEPS: usize = 12;
/// Where a search begins that has no start: light loads are the common ones.
const USUAL_SEPARATION: f64 = 2.0;
/// Standard deviations beyond which a feature of the law no longer shows.
const OUT_OF_SIGHT: f64 = 9.0;

/// A search for a pressure, which is carried no farther below the mean plane than [`FAR`].
pub(crate) struct Search<'s, 'a> {
    pub frames: &'s mut Frames<'a>,
    pub pressure_pa: f64,
}

/// A separation, and the cell on whose frame it carries the pressure.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    pub cell: Cell,
    pub u: f64,
}

/// A state to start from.
#[derive(Clone, Copy)]
pub(crate) struct Neighbour {
    pub u: f64,
    /// The integrals there, where they are known.
    pub sums: Option<Sums>,
}

/// Where a search has ended.
struct Settled {
    found: Found,
    /// Whether it came from another cell.
    moved: bool,
}

/// Whether a step on a rough quadrature has led near the solution: steps converge with the fourth power, on the scale of
/// 1 + |u|, and cells are as wide as their separation is positive.
fn is_near(u: f64, next: f64) -> bool {
    let step = (next - u).abs();
    let left = step * (step / (1.0 + next.abs())).powi(3);
    left < 0.005 * (1.0 + next.max(0.0))
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

    /// Where to begin in a cell: at its centre, where its quadrature is summed already, or as near to it as the bracket allows.
    fn inside(&self, cell: Cell) -> f64 {
        cell.centre().clamp(self.low, self.high)
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

impl Search<'_, '_> {
    /// The largest separation that carries the pressure, `None` where none does. A neighbour saves work, and changes no digit:
    /// what is found from it counts where the solution is the only one and lies in its cell beyond doubt.
    pub fn run(&mut self, neighbour: Option<Neighbour>) -> Option<Found> {
        if self.frames.are_one() {
            // Always from the same start, a few steps off: so the digits are always the same.
            let mut bracket = Bracket { margin: Bracket::FINE_MARGIN, ..Bracket::EVERYTHING };
            let u = self.solve_on(Cell::ANY, USUAL_SEPARATION, &mut bracket)?;
            return Some(Found { cell: Cell::ANY, u });
        }
        let found = neighbour.and_then(|neighbour| self.find_from(neighbour));
        let found = found.or_else(|| self.find_alone()).or_else(|| self.end())?;
        // Above the mean plane there is no other.
        if found.u >= 0.0 {
            return Some(found);
        }
        Some(self.before_dip(found.u).unwrap_or(found))
    }

    /// The end of the search, for a force with its maximum beyond: a load that is missing all the way is missing by rounding.
    fn end(&self) -> Option<Found> {
        let rises_on = self.frames.asperities.falls_from_m()? > FAR * self.frames.sigma_s_m;
        rises_on.then_some(Found { cell: Cell::of(-FAR), u: -FAR })
    }

    /// A force that dips between two rises carries some pressures thrice: the largest of these separations, where the one
    /// that was found, u, may be another.
    fn before_dip(&mut self, u: f64) -> Option<Found> {
        let sigma_s_m = self.frames.sigma_s_m;
        let [from, to] = self.frames.asperities.dip_m()?.map(|at_m| at_m / sigma_s_m);
        let top = (OUT_OF_SIGHT - from).min(0.0);
        if u >= top {
            return None;
        }
        let bottom = (-OUT_OF_SIGHT - to).max(-FAR);
        let [low, high] =
            self.crossing_below(top, bottom, |u| (0.1 * u.abs()).min(0.25 * (to - from))).ok()?;
        // Above the mean plane the pressure falls for good.
        if high.is_finite() { Some(self.bisect(low, high)) } else { self.bisect_around(top) }
    }

    fn find_from(&mut self, neighbour: Neighbour) -> Option<Found> {
        if !matches!(self.course(), Course::Rises | Course::Peaks { certain: true }) {
            return None;
        }
        let near = self.near(neighbour);
        let found = self.settle(near, Bracket::EVERYTHING)?;
        (self.is_carried_by(found) && self.leeway(found).is_some()).then_some(found)
    }

    /// Where to look for the solution on fine quadratures.
    fn near(&mut self, neighbour: Neighbour) -> f64 {
        let Some(sums) = neighbour.sums else { return self.approach(neighbour.u, Bracket::EVERYTHING) };
        let Some(next) = self.next(neighbour.u, &sums, &mut { Bracket::EVERYTHING }) else {
            return self.approach(neighbour.u, Bracket::EVERYTHING);
        };
        // A frame that is there costs less than a rough one.
        let is_near = is_near(neighbour.u, next) || self.frames.have(Cell::of(next));
        if is_near { next } else { self.approach(next, Bracket::EVERYTHING) }
    }

    fn find_alone(&mut self) -> Option<Found> {
        let found = self.find();
        if let Some(near) = found {
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
    fn is_carried_by(&mut self, Found { cell, u }: Found) -> bool {
        const CLOSE: f64 = 1e-11;
        let sums = self.frames.of(cell).sums_at(u);
        self.missing(u, &sums).abs() <= CLOSE + 8.0 * f64::EPSILON * self.pressure_pa.ln().abs()
    }

    /// How far off the quadratures may place the solution; `None` where that is no small part of a cell.
    fn leeway(&mut self, Found { cell, u }: Found) -> Option<f64> {
        const CAUTION: f64 = 4.0;
        const SMALL: f64 = 0.25;
        let slope = self.frames.of(cell).sums_at(u).log_pressure_slope();
        let leeway = -CAUTION * self.frames.precision.in_cell(cell).tolerance / slope;
        (0.0 < leeway && leeway < SMALL * (cell.farthest() - cell.nearest())).then_some(leeway)
    }

    /// The crossing of the load nearest to a separation, each on the quadrature of its cell: slow and sure.
    fn bisect_around(&mut self, u: f64) -> Option<Found> {
        const NARROWEST: f64 = 1e-6;
        const MOST_DOUBLINGS: i32 = 60;
        let mut last_high = None;
        let [low, high] = (0..MOST_DOUBLINGS).find_map(|doubling| {
            let reach = NARROWEST * (1.0 + u.abs()) * 2f64.powi(doubling);
            let (low, high) = (last_high.unwrap_or((u - reach).max(-FAR)), u + reach);
            if self.missing_at(high) > 0.0 {
                return (self.missing_at(low) <= 0.0).then_some([low, high]);
            }
            last_high = Some(high);
            None
        })?;
        Some(self.bisect(low, high))
    }

    /// The same between two separations, the nearer of which carries the pressure or more, and the other one does not.
    fn bisect(&mut self, low: f64, high: f64) -> Found {
        let u = zero_in_bracket(low, high, |u| self.missing_at(u));
        Found { cell: Cell::of(u), u }
    }

    /// How much pressure is missing at a separation, on the quadrature of its cell.
    fn missing_at(&mut self, u: f64) -> f64 {
        let sums = self.frames.sums_at(u);
        self.missing(u, &sums)
    }

    fn find(&mut self) -> Option<Found> {
        let bracket = match self.course() {
            Course::StepsDown { at_m } if at_m < FAR * self.frames.sigma_s_m => {
                self.scan_across(at_m / self.frames.sigma_s_m)
            }
            _ => Bracket::EVERYTHING,
        };
        let near = self.approach(USUAL_SEPARATION.clamp(bracket.low, bracket.high), bracket);
        self.settle(near, bracket)
    }

    fn course(&self) -> Course {
        self.frames.asperities.course(self.frames.sigma_s_m)
    }

    /// The highest pressure \[Pa\] that a separation carries, or its limit.
    pub fn highest_pressure_pa(&mut self) -> f64 {
        match self.peak() {
            Some(peak) => self.pressure_and_slope(peak).0,
            None => self.frames.asperities.highest_response_pa(),
        }
    }

    /// For a force with a maximum: the separation at which the pressure has it.
    fn peak(&mut self) -> Option<f64> {
        let edge = self.far_edge()?;
        let rises_at_edge = self.pressure_and_slope(edge).1 > 0.0;
        Some(if rises_at_edge { zero_in_bracket(edge, 0.0, |u| self.pressure_and_slope(u).1) } else { edge })
    }

    /// For a force with a maximum: a separation beyond which the pressure only falls as the surfaces approach, or where
    /// the search ends.
    fn far_edge(&self) -> Option<f64> {
        let falls_from = self.frames.asperities.falls_from_m()? / self.frames.sigma_s_m;
        Some((-OUT_OF_SIGHT - falls_from).max(-FAR))
    }

    /// The bracket of the largest solution for a force that steps down at an interference.
    fn scan_across(&mut self, step_down: f64) -> Bracket {
        let top = (OUT_OF_SIGHT - step_down).min(0.0);
        match self.crossing_below(top, -OUT_OF_SIGHT - step_down, |_| 0.0) {
            Ok([low, high]) => Bracket { low, high, ..Bracket::EVERYTHING },
            Err(high) => Bracket { high, ..Bracket::EVERYTHING },
        }
    }

    /// The largest separations from `top` down to `bottom` between which the pressure comes to be carried, without an upper
    /// end where it is at `top`; where it is not carried, the lowest that was tried. The strides are those of the density, by
    /// which a step of the force is smeared out, or longer ones; a maximum between two of them shows in the slopes.
    fn crossing_below(
        &mut self,
        top: f64,
        bottom: f64,
        longer: impl Fn(f64) -> f64,
    ) -> Result<[f64; 2], f64> {
        const STRIDE: f64 = 0.5;
        let mut high = top;
        let (pressure_pa, mut slope_at_high) = self.pressure_and_slope(high);
        if pressure_pa >= self.pressure_pa {
            return Ok([high, f64::INFINITY]);
        }
        while high > bottom {
            let mut low = high - longer(high).max(STRIDE);
            let (mut pressure_pa, slope) = self.pressure_and_slope(low);
            if slope > 0.0 && slope_at_high <= 0.0 && pressure_pa < self.pressure_pa {
                let peak = zero_in_bracket(low, high, |u| self.pressure_and_slope(u).1);
                if self.pressure_and_slope(peak).0 >= self.pressure_pa {
                    (low, pressure_pa) = (peak, f64::INFINITY);
                }
            }
            if pressure_pa >= self.pressure_pa {
                return Ok([low, high]);
            }
            (high, slope_at_high) = (low, slope);
        }
        Err(high)
    }

    /// Pressure \[Pa\] and derivative of ln p by u, each separation on the quadrature of its cell.
    fn pressure_and_slope(&mut self, u: f64) -> (f64, f64) {
        let sums = self.frames.sums_at(u);
        (sums.pressure_pa * reference_density(u), sums.log_pressure_slope())
    }

    /// Gets within a few percent of a standard deviation, on quadratures of a few nodes.
    fn approach(&mut self, start: f64, mut bracket: Bracket) -> f64 {
        let mut u = start;
        for _ in 0..MOST_ROUGH_STEPS {
            let sums = self.frames.rough_sums_at(u);
            let Some(next) = self.next(u, &sums, &mut bracket) else { break };
            let before = u;
            u = next;
            if is_near(before, next) {
                break;
            }
        }
        u
    }

    /// Solves on the quadrature of the cell that the solution lies in.
    ///
    /// From wherever it comes, it ends on the same quadrature with the same digits: it solves from the centre of the last cell
    /// even where it came from another one, and of two cells that both place the solution in themselves it takes the nearer.
    fn settle(&mut self, near: f64, bracket: Bracket) -> Option<Found> {
        let whole = Bracket { margin: Bracket::FINE_MARGIN, ..bracket };
        let Settled { found, moved } = self.move_to_cell(near, whole)?;
        let found = if moved { self.solve_again(found, whole).unwrap_or(found) } else { found };
        let Some(leeway) = self.leeway(found) else { return Some(found) };
        let edge = found.cell.nearest();
        if found.u - edge > leeway {
            return Some(found);
        }
        let nearer = Found { cell: Cell::of(edge - leeway), ..found };
        let nearer = self.solve_again(nearer, whole).filter(|at| found.u < edge || Cell::of(at.u) == at.cell);
        Some(nearer.unwrap_or(found))
    }

    /// Goes on from cell to cell until one places the solution in itself.
    fn move_to_cell(&mut self, near: f64, mut bracket: Bracket) -> Option<Settled> {
        let (mut u, mut cell) = (bracket.inside(Cell::of(near)), Cell::of(near));
        let mut from = None;
        for step in 0.. {
            u = self.solve_on(cell, u, &mut bracket)?;
            let next = Cell::of(u);
            // Two neighbouring cells may each place the solution just beyond their common edge; the nearer one has it.
            let undecided = from == Some(next) && next.is_beside(cell);
            if next == cell || (undecided && cell.is_nearer_than(next)) || step == MOST_STEPS {
                return Some(Settled { found: Found { cell, u }, moved: step > 0 });
            }
            from = Some(cell);
            cell = next;
        }
        unreachable!("the last step returns")
    }

    /// What has been found on a quadrature, found from the centre of its cell: the same but for rounding, or for what the bracket
    /// has cut off where two cells are at odds. `None` where that leads away.
    fn solve_again(&mut self, Found { cell, .. }: Found, mut bracket: Bracket) -> Option<Found> {
        let u = self.solve_on(cell, bracket.inside(cell), &mut bracket)?;
        (Cell::of(u) == cell || Cell::of(u).is_beside(cell)).then_some(Found { cell, u })
    }

    /// The solution on a quadrature, or a separation that needs another one; `None` above the highest pressure.
    fn solve_on(&mut self, cell: Cell, start: f64, bracket: &mut Bracket) -> Option<f64> {
        const LAST_STEP: f64 = 1e-4;
        let mut u = start;
        for _ in 0..MOST_STEPS {
            let frame = self.frames.of(cell);
            let sums = if u == frame.centre { frame.sums_at_centre() } else { frame.sums_at(u) };
            let next = self.next(u, &sums, bracket)?;
            let step = next - u;
            u = next;
            // The error of a step is the fourth power of the one before: the next one would not show.
            if step.abs() < LAST_STEP * (1.0 + u.max(0.0)) || !self.frames.of(cell).serves(u) {
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
    fn next(&mut self, u: f64, sums: &Sums, bracket: &mut Bracket) -> Option<f64> {
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
