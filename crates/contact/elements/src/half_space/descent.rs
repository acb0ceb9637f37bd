//! Pressures in equilibrium: the convex problem of contact, solved by projected and preconditioned conjugate gradients.
//!
//! Among all pressures 0 <= p <= cap with the given mean the solution minimises (1/2) p.Kp - h.p; under a given offset d
//! it minimises (1/2) p.Kp - (h + d).p among pressures of any mean. Every step goes from p towards q = P(p + tau t), with a direction t among the free points and the projection P of `projection`.
//! The energy is minimised exactly between them, so it falls with every step on any surface. If q meets new bounds
//! and is itself better than p, the step goes all the way, so that many points leave and join at once. Once the set
//! of free points is found, these are the conjugate gradients of Stanley & Kato (1997) and Polonsky & Keer (1999),
//! preconditioned with |q|. If a direction does not lower the energy, the spectral projected gradients of Birgin,
//! Martinez & Raydan (2000) take over.
//!
//! One compliance and one preconditioner are applied per step: the gap is updated with K s for the actual change s of
//! the pressures, and is computed anew from them where accumulated rounding could matter, and at the end. K s is computed
//! in single precision, at half the cost: near equilibrium changes are small, and their rounding with them.

use multiversion::multiversion;

use crate::half_space::contact::Ending;
use crate::half_space::problem::{Held, Operators, Problem, State};
use crate::half_space::projection::bring_to_sum;
use crate::half_space::sums;

/// Outcome of a solve.
pub(crate) struct Outcome {
    /// Offset from which the gaps are counted.
    pub(crate) offset: f64,
    pub(crate) iterations: usize,
    pub(crate) operators: usize,
    pub(crate) residual: f64,
    pub(crate) ending: Ending,
}

/// State of a solve.
struct Descent<'a> {
    problem: &'a Problem<'a>,
    operators: &'a mut Operators,
    state: &'a mut State,
    /// Offset from which the gaps are counted.
    offset: f64,
    /// Mean pressure.
    mean: f64,
    /// Number of points that carry the cap and stay there.
    capped: usize,
    /// Length of the next step along a direction.
    length: f64,
    /// True if changes are displaced in single precision.
    is_rough: bool,
    /// Rounding of the gaps since they were computed anew, over the rms height.
    accumulated: f64,
    applied: usize,
}

/// Steps after which the gaps are computed anew, because they accumulate rounding.
const STEPS_UNTIL_RENEWED: usize = 100;

/// Rounding of the displacements of a change, over the largest of them.
const ROUNDING: f64 = 1e-15;

/// Rounding of the displacements of a change in single precision, over the largest of them.
const ROUGH_ROUNDING: f64 = 2e-7;

/// Mean pressures, in units of the problem, whose changes and displacements lie well within single precision.
const ROUGH_MEANS: std::ops::Range<f64> = 1e-15..1e15;

/// Accumulated rounding up to which the gaps are as good as computed anew.
const SETTLED: f64 = 1e-13;

/// Share of the residual up to which accumulated rounding needs no attention.
const NEGLIGIBLE_SHARE: f64 = 0.01;

/// Steps within which the residual must halve; otherwise rounding prevents it.
const STEPS_TO_HALVE: usize = 300;

/// Steps without half the residual before some go along the gap itself: the first [`PLAIN`] of every [`CYCLE`]. Bounds can turn
/// preconditioned directions into ones that hardly lower the energy, for ever, while projected gaps always lower it. In
/// between, conjugate directions need many steps in a row.
const PATIENCE: usize = 20;
const PLAIN: usize = 10;
const CYCLE: usize = 80;

/// Computes pressures in equilibrium, into `state`, from even ones or from those of another load that `state` holds; `None` if
/// `watch`, which receives every residual, cancels.
pub(crate) fn descend(
    problem: &Problem,
    operators: &mut Operators,
    state: &mut State,
    goes_on: bool,
    mut watch: impl FnMut(f64) -> bool,
) -> Option<Outcome> {
    let (offset, mean) = match problem.held {
        Held::Mean(mean) => (0.0, mean),
        // A wave that closes as much as the surfaces overlap would carry about as much, in these units.
        Held::Offset(offset) => (offset, mean_overlap(problem.heights, offset).min(problem.cap)),
    };
    let mut descent = Descent {
        problem,
        operators,
        state,
        offset,
        mean,
        capped: 0,
        length: 1.0,
        is_rough: ROUGH_MEANS.contains(&mean),
        accumulated: 0.0,
        applied: 0,
    };
    if !(goes_on && descent.go_on()) {
        descent.start();
    }
    let mut residual = descent.look(0.0);
    let (mut iterations, mut renewed_at, mut best, mut best_at) = (0, 0, residual, 0);
    let ending = loop {
        if !watch(residual) {
            return None;
        }
        if residual < 0.5 * best {
            (best, best_at) = (residual, iterations);
        }
        if residual < problem.tolerance && descent.accumulated <= SETTLED {
            break Ending::Converged;
        }
        let is_due = descent.accumulated > NEGLIGIBLE_SHARE * residual;
        if residual < problem.tolerance || is_due || iterations - renewed_at >= STEPS_UNTIL_RENEWED {
            descent.renew();
            renewed_at = iterations;
            residual = descent.look(0.0);
            continue;
        }
        if iterations - best_at > STEPS_TO_HALVE {
            break Ending::Rounding;
        }
        let stalled = iterations - best_at;
        let Some(share) = descent.step(is_plain(stalled)) else {
            if renewed_at == iterations {
                break Ending::Rounding;
            }
            descent.renew();
            renewed_at = iterations;
            residual = descent.look(0.0);
            continue;
        };
        residual = descent.look(share);
        iterations += 1;
    };
    if ending == Ending::Rounding && renewed_at != iterations {
        descent.renew();
        residual = descent.look(0.0);
    }
    Some(Outcome { offset: descent.offset, iterations, operators: descent.applied, residual, ending })
}

/// Returns true if a step after so many without half the residual looks along the gap itself.
fn is_plain(stalled: usize) -> bool {
    stalled >= PATIENCE && (stalled - PATIENCE) % CYCLE < PLAIN
}

/// Mean overlap of the undeformed bodies.
fn mean_overlap(heights: &[f64], offset: f64) -> f64 {
    let [sum] = sums::over(heights.len(), |point| [(heights[point] + offset).max(0.0)]);
    sum / heights.len() as f64
}

impl Descent<'_> {
    /// Sets the same pressure at all points that are not left out.
    fn start(&mut self) {
        let heights = self.problem.heights;
        let State { pressures, change, response, free, .. } = &mut *self.state;
        change.fill(0.0);
        response.fill(0.0);
        free.clear();
        free.extend((0u32..).zip(heights).filter_map(|(point, height)| height.is_finite().then_some(point)));
        let are_all = free.len() == heights.len();
        if are_all {
            pressures.fill(self.mean);
        } else {
            pressures.fill(0.0);
            let share = heights.len() as f64 / free.len() as f64;
            free.iter().for_each(|&point| pressures[point as usize] = share * self.mean);
        }
        if self.operators.uniform_displaces || !are_all {
            self.renew();
        } else {
            self.state.gaps.iter_mut().zip(self.problem.heights).for_each(|(gap, height)| *gap = -height);
        }
    }

    /// Brings pressures of another load to the mean of this one; false if the points that they press cannot carry it.
    fn go_on(&mut self) -> bool {
        let cap = self.problem.cap;
        let State { pressures, change, response, free, trial, .. } = &mut *self.state;
        free.clear();
        free.extend(
            (0u32..).zip(&*pressures).filter_map(|(point, &pressure)| (pressure > 0.0).then_some(point)),
        );
        let sum = self.mean * pressures.len() as f64;
        if free.is_empty() || cap * free.len() as f64 <= sum {
            return false;
        }
        let [carried] = sums::over(free.len(), |at| [pressures[free[at] as usize]]);
        trial.clear();
        trial.extend(free.iter().map(|&point| sum / carried * pressures[point as usize]));
        bring_to_sum(trial, cap, sum);
        free.iter().zip(&*trial).for_each(|(&point, &pressure)| pressures[point as usize] = pressure);
        change.fill(0.0);
        response.fill(0.0);
        self.renew();
        true
    }

    /// Computes the gaps of the pressures anew, without accumulated rounding.
    fn renew(&mut self) {
        self.operators.compliance.apply(&self.state.pressures, &mut self.state.gaps);
        self.applied += 1;
        self.accumulated = 0.0;
        self.state.gaps.iter_mut().zip(self.problem.heights).for_each(|(gap, height)| *gap -= height);
    }

    /// Takes `share` of the tried change, and updates the offset, the gaps, the free points, and the residual.
    fn look(&mut self, share: f64) -> f64 {
        self.take(share);
        let (overlap, opening) = self.close_gaps(share);
        let carried = self.mean * self.problem.heights.len() as f64;
        // Nothing touches before the first points join.
        let unbalanced = if carried > 0.0 { self.gather_gradient() / carried } else { 0.0 };
        unbalanced.max(overlap / OVERLAP_SHARE).max(opening / OVERLAP_SHARE)
    }

    /// Updates the pressures by `share` of the change, and the offset, the mean gap of the points between the bounds; or the
    /// mean pressure where the offset is held.
    fn take(&mut self, share: f64) {
        let cap = self.problem.cap;
        let tiny = self.problem.rounding_of_pressure(self.mean);
        let full = cap - tiny;
        let State { pressures, gaps, change, response, free, .. } = &mut *self.state;
        let [sum, count] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let pressure = pressures[point] + share * change[point];
            let gap = gaps[point] + share * response[point];
            let (pressure, terms) = match pressure {
                low if low <= tiny => (0.0, [0.0; 2]),
                high if high >= full => (cap, [0.0; 2]),
                between => (between, [gap, 1.0]),
            };
            pressures[point] = pressure;
            terms
        });
        match self.problem.held {
            Held::Mean(_) => {
                self.offset = if count > 0.0 { sum / count } else { self.offset_without_free_points(share) };
            }
            Held::Offset(_) => {
                let pressures = &self.state.pressures;
                let [sum] = sums::over(pressures.len(), |point| [pressures[point]]);
                self.mean = sum / pressures.len() as f64;
            }
        }
    }

    /// Offset if no point lies between the bounds: midway between the offsets that the points at either bound need.
    fn offset_without_free_points(&self, share: f64) -> f64 {
        let State { pressures, gaps, response, .. } = &*self.state;
        let (mut open, mut sunk) = (f64::INFINITY, f64::NEG_INFINITY);
        for ((&pressure, &gap), &response) in pressures.iter().zip(gaps).zip(response) {
            let gap = gap + share * response;
            if pressure == 0.0 {
                open = open.min(gap);
            } else {
                sunk = sunk.max(gap);
            }
        }
        if open < f64::INFINITY { 0.5 * (open + sunk) } else { sunk }
    }

    /// Updates the gaps by `share` of the change, and gathers the points that may change: those between the bounds, and
    /// those at a bound that keeps them from closing a gap. Returns the largest overlap without pressure, and the
    /// largest gap at the cap.
    fn close_gaps(&mut self, share: f64) -> (f64, f64) {
        let State { pressures, gaps, response, free, .. } = &mut *self.state;
        let bounds = Bounds { cap: self.problem.cap, offset: self.offset };
        let closed = close_gaps(&bounds, share, pressures, response, gaps, free);
        self.capped = closed.capped;
        ((bounds.offset - closed.least).max(0.0), (closed.largest - bounds.offset).max(0.0))
    }

    /// Gathers the gap on the free points, 0 on the others; returns the sum of p|g| over the points between the
    /// bounds.
    fn gather_gradient(&mut self) -> f64 {
        let (cap, offset) = (self.problem.cap, self.offset);
        let State { pressures, gaps, gradient, free, .. } = &mut *self.state;
        gradient.fill(0.0);
        let [unbalanced] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let (pressure, gap) = (pressures[point], gaps[point] - offset);
            gradient[point] = gap as f32;
            [if pressure < cap { pressure * gap.abs() } else { 0.0 }]
        });
        unbalanced
    }

    /// Finds a change that lowers the energy, and the share of it to take; `None` if rounding leaves none. With
    /// `is_plain` it first looks along the gap itself.
    fn step(&mut self, is_plain: bool) -> Option<f64> {
        let aim = if is_plain { self.aim_along_gap() } else { None };
        let aim = aim.or_else(|| self.aim_along_preconditioned()).or_else(|| self.aim_along_gap())?;
        Some(self.search(&aim))
    }

    /// Aims along the preconditioned gap, with and without the last change.
    fn aim_along_preconditioned(&mut self) -> Option<Aim> {
        self.precondition();
        let memory = self.memory();
        self.aim_along_conjugate(&memory)
            .or_else(|| self.aim_along_conjugate(&Memory { kept: 0.0, ..memory }))
    }

    /// Turns the gaps of free points into pressures that would about close them.
    fn precondition(&mut self) {
        let gradient = &mut self.state.gradient;
        let uniform = match self.problem.held {
            Held::Mean(_) => 0.0,
            // The wave number of a uniform gap is 0, and only this part changes the load of all points together.
            Held::Offset(_) => {
                gradient.iter().map(|gap| f64::from(*gap)).sum::<f64>() / gradient.len() as f64
            }
        };
        self.operators.preconditioner.apply_in_place(gradient);
        if uniform != 0.0 {
            gradient.iter_mut().for_each(|pressure| *pressure += uniform as f32);
        }
    }

    /// Weight of the last change in the next direction.
    fn memory(&self) -> Memory {
        let offset = self.offset;
        let State { gaps, gradient, change, response, free, .. } = &*self.state;
        let [z, zr, r, s, sr, g, gz, gs] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let (z, s, r) = (f64::from(gradient[point]), change[point], response[point]);
            let gap = gaps[point] - offset;
            [z, z * r, r, s, s * r, gap, gap * z, gap * s]
        });
        // A change of the offset that costs nothing is taken out where the load is held.
        let count = match self.problem.held {
            Held::Mean(_) => free.len() as f64,
            Held::Offset(_) => f64::INFINITY,
        };
        let curvature = sr - s / count * r;
        let kept = if curvature > 0.0 { (zr - z / count * r) / curvature } else { 0.0 };
        let (fall, fall_of_change) = (gz - z / count * g, s / count * g - gs);
        let kept = if fall + kept * fall_of_change > LEAST_FALL * fall { kept } else { 0.0 };
        Memory { kept, mean_gradient: z / count, mean_change: s / count }
    }

    /// Aims along the preconditioned gap plus the kept part of the last change.
    fn aim_along_conjugate(&mut self, memory: &Memory) -> Option<Aim> {
        let Memory { kept, mean_gradient, mean_change } = *memory;
        let length = self.length;
        let State { pressures, change, gradient, free, trial, .. } = &mut *self.state;
        let mean = kept * mean_change - mean_gradient;
        trial.clear();
        trial.extend(free.iter().map(|&point| {
            let point = point as usize;
            pressures[point] + length * (kept * change[point] - f64::from(gradient[point]) - mean)
        }));
        self.aim()
    }

    /// Aims along the gap itself, with the length from the last curvature.
    fn aim_along_gap(&mut self) -> Option<Aim> {
        let offset = self.offset;
        let State { pressures, gaps, change, response, free, trial, .. } = &mut *self.state;
        let [ss, sr] = sums::over(change.len(), |point| {
            [change[point] * change[point], change[point] * response[point]]
        });
        let length = if sr > 0.0 { ss / sr } else { 1.0 };
        trial.clear();
        trial.extend(free.iter().map(|&point| {
            let point = point as usize;
            pressures[point] + length * (offset - gaps[point])
        }));
        self.aim()
    }

    /// Brings the trial between the bounds and to the load; `None` if the energy does not fall that way.
    fn aim(&mut self) -> Option<Aim> {
        let Problem { held, cap, heights, .. } = *self.problem;
        let offset = self.offset;
        let State { pressures, gaps, free, trial, .. } = &mut *self.state;
        match held {
            Held::Mean(mean) => {
                let elsewhere = if self.capped == 0 { 0.0 } else { self.capped as f64 * cap };
                bring_to_sum(trial, cap, mean * heights.len() as f64 - elsewhere);
            }
            Held::Offset(_) => trial.iter_mut().for_each(|pressure| *pressure = pressure.clamp(0.0, cap)),
        }
        let [slope, at_bounds] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let aimed = trial[at];
            let change = aimed - pressures[point];
            trial[at] = change;
            let bound = change != 0.0 && (aimed == 0.0 || aimed == cap);
            [(gaps[point] - offset) * change, if bound { 1.0 } else { 0.0 }]
        });
        (slope < 0.0).then_some(Aim { slope, meets_bounds: at_bounds > 0.0 })
    }

    /// Turns the trial into a change and its response, and returns the best share of it.
    fn search(&mut self, aim: &Aim) -> f64 {
        let State { change, response, gradient, free, trial, .. } = &mut *self.state;
        change.fill(0.0);
        free.iter().zip(&*trial).for_each(|(&point, &step)| change[point as usize] = step);
        if self.is_rough {
            gradient.iter_mut().zip(&*change).for_each(|(rough, change)| *rough = *change as f32);
            let Operators { rough_compliance, preconditioner, .. } = &mut *self.operators;
            rough_compliance.apply_in_place_within(preconditioner, gradient);
            response.iter_mut().zip(&*gradient).for_each(|(response, rough)| *response = f64::from(*rough));
        } else {
            self.operators.compliance.apply(change, response);
        }
        let rounding = if self.is_rough { ROUGH_ROUNDING } else { ROUNDING } * largest(response);
        self.applied += 1;
        let [curvature] = sums::over(free.len(), |at| [trial[at] * response[free[at] as usize]]);
        let best = if curvature > 0.0 { -aim.slope / curvature } else { 1.0 };
        self.length =
            (self.length * best.clamp(1.0 / LARGEST_FACTOR, LARGEST_FACTOR)).clamp(SHORTEST, LONGEST);
        let share = match best {
            far if far > FULL_STEP_MIN && aim.meets_bounds => 1.0,
            // Limited at once: rounding in the sum of the change grows with the factor.
            far if far > 1.0 => far.min(self.reach()).min(LARGEST_FACTOR),
            near => near,
        };
        self.accumulated += share * rounding;
        share
    }

    /// Largest multiple of the change before a point meets a bound.
    fn reach(&self) -> f64 {
        let cap = self.problem.cap;
        let State { pressures, free, trial, .. } = &*self.state;
        free.iter().zip(trial).fold(f64::INFINITY, |reach, (&point, &change)| {
            let pressure = pressures[point as usize];
            let way = if change < 0.0 { -pressure } else { cap - pressure };
            if change == 0.0 { reach } else { reach.min(way / change) }
        })
    }
}

/// Bounds of the pressures, and the gap of points between them.
struct Bounds {
    cap: f64,
    offset: f64,
}

/// Gaps after a change of the pressures.
struct Closed {
    /// Number of points that carry the cap and stay there.
    capped: usize,
    /// Least gap without pressure.
    least: f64,
    /// Largest gap at the cap.
    largest: f64,
}

/// Adds `share` of the response to the gaps, and gathers the points that may change into `free`, in one pass over
/// the maps.
#[multiversion(targets("x86_64+avx2"))]
fn close_gaps(
    bounds: &Bounds,
    share: f64,
    pressures: &[f64],
    response: &[f64],
    gaps: &mut [f64],
    free: &mut Vec<u32>,
) -> Closed {
    const LANES: usize = 8;
    let Bounds { cap, offset } = *bounds;
    let points = pressures.len();
    free.resize(points, 0);
    let (mut gathered, mut capped) = (0, 0);
    let (mut least, mut largest) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    let mut gather = |first: usize, pressures: &[f64], gaps: &[f64]| {
        for (point, (&pressure, &gap)) in (first..).zip(pressures.iter().zip(gaps)) {
            let is_open = (pressure <= 0.0) & (gap >= offset);
            let is_sunk = (pressure >= cap) & (gap <= offset);
            // Written in any case, and kept if free: at the edges of spots a branch would be mispredicted.
            free[gathered] = point as u32;
            gathered += usize::from(!is_open & !is_sunk);
            capped += usize::from(is_sunk);
        }
    };
    let (all_pressures, rest) = pressures.as_chunks::<LANES>();
    let (all_gaps, gaps_of_rest) = gaps.as_chunks_mut::<LANES>();
    let (all_responses, responses_of_rest) = response.as_chunks::<LANES>();
    let lanes = all_pressures.iter().zip(all_gaps).zip(all_responses);
    for (at, ((pressures, gaps), responses)) in lanes.enumerate() {
        let mut open = 0.0;
        for lane in 0..LANES {
            let pressure = pressures[lane];
            let gap = gaps[lane] + share * responses[lane];
            gaps[lane] = gap;
            let without_pressure = if pressure <= 0.0 { gap } else { f64::INFINITY };
            let at_the_cap = if pressure >= cap { gap } else { f64::NEG_INFINITY };
            least[lane] = if without_pressure < least[lane] { without_pressure } else { least[lane] };
            largest[lane] = if at_the_cap > largest[lane] { at_the_cap } else { largest[lane] };
            let is_open = (pressure <= 0.0) & (gap >= offset);
            open += if is_open { 1.0 } else { 0.0 };
        }
        // Most points are open.
        if open < LANES as f64 {
            gather(LANES * at, pressures, gaps);
        }
    }
    for (((&pressure, gap), response), lane) in
        rest.iter().zip(&mut *gaps_of_rest).zip(responses_of_rest).zip(0..)
    {
        *gap += share * response;
        least[lane] = if pressure <= 0.0 { least[lane].min(*gap) } else { least[lane] };
        largest[lane] = if pressure >= cap { largest[lane].max(*gap) } else { largest[lane] };
    }
    gather(points - rest.len(), rest, gaps_of_rest);
    free.truncate(gathered);
    let least = least.into_iter().fold(f64::INFINITY, f64::min);
    let largest = largest.into_iter().fold(f64::NEG_INFINITY, f64::max);
    Closed { capped, least, largest }
}

/// Largest magnitude of the values.
#[multiversion(targets("x86_64+avx2"))]
fn largest(values: &[f64]) -> f64 {
    const LANES: usize = 4;
    let mut largest = [0.0f64; LANES];
    let (fours, rest) = values.as_chunks::<LANES>();
    let mut take = |lane: usize, value: f64| {
        let size = value.abs();
        largest[lane] = if size > largest[lane] { size } else { largest[lane] };
    };
    for four in fours {
        (0..LANES).for_each(|lane| take(lane, four[lane]));
    }
    rest.iter().enumerate().for_each(|(lane, value)| take(lane, *value));
    largest.into_iter().fold(0.0, f64::max)
}

/// Part of the last change s in the next direction t, chosen so that t does not undo s: t.Ks = 0.
struct Memory {
    kept: f64,
    /// Mean over the free points; without it they carry no load together.
    mean_gradient: f64,
    mean_change: f64,
}

/// Trial towards which the energy falls.
struct Aim {
    /// Initial rate of the fall.
    slope: f64,
    /// True if points that were between the bounds are at them.
    meets_bounds: bool,
}

/// Share from which a trial that meets bounds is taken whole: above a half the energy still falls, and points that
/// arrive at a bound are worth part of it.
const FULL_STEP_MIN: f64 = 0.7;

/// Factor by which overlaps count less than unbalanced gaps.
const OVERLAP_SHARE: f64 = 10.0;

/// Share of the fall along the preconditioned gap that the energy must keep along a conjugate direction. If the last
/// step did not end at the minimum along its direction, as when it met bounds, the conjugate direction may be zero
/// within rounding: always where the free points leave one direction only.
const LEAST_FALL: f64 = 1e-3;

/// Largest ratio of the lengths of successive trial steps.
const LARGEST_FACTOR: f64 = 2.0;

/// Relative wavelength down to which the preconditioner inverts the compliance.
const SHORTEST: f64 = 0.05;
const LONGEST: f64 = 20.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_closed_and_points_gathered_as_one_by_one() {
        // As many points as leave a part of a vector over; pressures at both bounds and between them.
        let points = 8 * 7 + 5;
        let bounds = Bounds { cap: 2.0, offset: 0.1 };
        let noise = |k: usize, step: usize| ((k * step) % 101) as f64 / 101.0;
        let pressures: Vec<f64> = (0..points).map(|k| (4.0 * noise(k, 37) - 1.0).clamp(0.0, 2.0)).collect();
        let response: Vec<f64> = (0..points).map(|k| noise(k, 29) - 0.5).collect();
        let before: Vec<f64> = (0..points).map(|k| noise(k, 71) - 0.4).collect();
        let (mut gaps, mut free) = (before.clone(), Vec::new());
        let closed = close_gaps(&bounds, 0.7, &pressures, &response, &mut gaps, &mut free);

        let gap = |k: usize| before[k] + 0.7 * response[k];
        let is_open = |k: usize| pressures[k] <= 0.0 && gap(k) >= bounds.offset;
        let is_sunk = |k: usize| pressures[k] >= bounds.cap && gap(k) <= bounds.offset;
        assert!((0..points).all(|k| gaps[k] == gap(k)));
        let expected: Vec<u32> =
            (0..points).filter(|&k| !is_open(k) && !is_sunk(k)).map(|k| k as u32).collect();
        assert!(free == expected && free.len() < points);
        assert_eq!(closed.capped, (0..points).filter(|&k| is_sunk(k)).count());
        let without_pressure = (0..points).filter(|&k| pressures[k] <= 0.0).map(gap);
        let at_the_cap = (0..points).filter(|&k| pressures[k] >= bounds.cap).map(gap);
        assert_eq!(closed.least, without_pressure.fold(f64::INFINITY, f64::min));
        assert_eq!(closed.largest, at_the_cap.fold(f64::NEG_INFINITY, f64::max));
    }
}
