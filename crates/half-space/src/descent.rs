//! Pressures in equilibrium: the convex problem of contact, solved by projected and preconditioned conjugate gradients.
//!
//! Of all pressures 0 <= p <= cap with the given mean the right ones minimise (1/2) p.Kp - h.p. Every step runs from p
//! towards q = P(p + tau t), t being a direction among the free points and P the projection of `projection`, and the energy
//! is minimised exactly between them: it falls with every step, whatever the surface. Where q meets new bounds and is itself
//! better than p, the step goes all the way, so that points leave and join in numbers. Once the set of free points is found,
//! these are the conjugate gradients of Stanley & Kato (1997) and Polonsky & Keer (1999), preconditioned with |q|; where a
//! direction is none of descent it falls back on the spectral projected gradients of Birgin, Martinez & Raydan (2000).
//!
//! One compliance and one preconditioner are applied per step: the gap is kept up to date with K s for the very change s of
//! the pressures, and is computed anew from them only before it is believed.

use crate::contact::Ending;
use crate::projection::shift_to_sum;
use crate::sums;
use crate::transform::Convolution;

/// What is asked, in units in which the heights have a mean square of 1.
pub(crate) struct Problem<'a> {
    pub(crate) heights: &'a [f64],
    /// Mean pressure.
    pub(crate) mean: f64,
    /// The largest pressure a point carries; infinite where it is elastic throughout.
    pub(crate) cap: f64,
    pub(crate) tolerance: f64,
}

/// The two operators: displacements of pressures, and roughly the inverse.
pub(crate) struct Operators {
    pub(crate) compliance: Convolution<f64>,
    /// In single precision, since it only shapes directions.
    pub(crate) preconditioner: Convolution<f32>,
}

/// Maps in units of the problem, kept between solves.
pub(crate) struct State {
    pub(crate) pressures: Vec<f64>,
    /// u - h, from which the offset is not yet taken.
    pub(crate) gaps: Vec<f64>,
    /// The last change of the pressures, and the displacements it makes.
    change: Vec<f64>,
    response: Vec<f64>,
    /// The gap on free points, and what the preconditioner makes of it.
    gradient: Vec<f32>,
    /// Points that may change.
    free: Vec<u32>,
    /// Direction and trial of each of them.
    direction: Vec<f64>,
    trial: Vec<f64>,
}

/// How a solve ended.
pub(crate) struct Outcome {
    /// What the gaps are counted from.
    pub(crate) offset: f64,
    pub(crate) iterations: usize,
    pub(crate) operators: usize,
    pub(crate) residual: f64,
    pub(crate) ending: Ending,
}

impl State {
    pub(crate) fn new(points: usize) -> Self {
        Self {
            pressures: vec![0.0; points],
            gaps: vec![0.0; points],
            change: vec![0.0; points],
            response: vec![0.0; points],
            gradient: vec![0.0; points],
            free: Vec::with_capacity(points),
            direction: Vec::with_capacity(points),
            trial: Vec::with_capacity(points),
        }
    }
}

/// A solve under way.
struct Descent<'a> {
    problem: &'a Problem<'a>,
    operators: &'a mut Operators,
    state: &'a mut State,
    /// What the gaps are counted from.
    offset: f64,
    /// Points that carry the cap and stay there.
    capped: usize,
    /// Points with a gap that joined the free ones, being closed at no pressure or open at the cap.
    joined: usize,
    /// Length of the next step along a direction.
    length: f64,
    /// Whether `change` and `response` are those of a step.
    stepped: bool,
    applied: usize,
}

/// Steps after which the gaps are computed anew, since they gather rounding.
const STEPS_UNTIL_RENEWED: usize = 100;

/// Steps within which the residual must have halved; rounding stands in the way otherwise.
const STEPS_TO_HALVE: usize = 300;

/// Pressures in equilibrium, into `state`; `None` where `watch`, which is told every residual, ends it.
pub(crate) fn descend(
    problem: &Problem,
    operators: &mut Operators,
    state: &mut State,
    mut watch: impl FnMut(f64) -> bool,
) -> Option<Outcome> {
    let mut descent = Descent {
        problem,
        operators,
        state,
        offset: 0.0,
        capped: 0,
        joined: 0,
        length: 1.0,
        stepped: false,
        applied: 0,
    };
    descent.start();
    let mut residual = descent.look(0.0);
    let (mut iterations, mut renewed_at, mut best, mut best_at) = (0, 0, residual, 0);
    let ending = loop {
        if !watch(residual) {
            return None;
        }
        if residual < 0.5 * best {
            (best, best_at) = (residual, iterations);
        }
        if residual < problem.tolerance || iterations - renewed_at >= STEPS_UNTIL_RENEWED {
            if residual < problem.tolerance && renewed_at == iterations {
                break Ending::Converged;
            }
            descent.renew();
            renewed_at = iterations;
            residual = descent.look(0.0);
            continue;
        }
        if iterations - best_at > STEPS_TO_HALVE {
            break Ending::Rounding;
        }
        let Some(share) = descent.step() else {
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
    if renewed_at != iterations {
        descent.renew();
        residual = descent.look(0.0);
    }
    Some(Outcome { offset: descent.offset, iterations, operators: descent.applied, residual, ending })
}

impl Descent<'_> {
    /// The same pressure everywhere.
    fn start(&mut self) {
        let points = self.problem.heights.len();
        self.state.pressures.fill(self.problem.mean);
        self.state.change.fill(0.0);
        self.state.response.fill(0.0);
        self.state.free.clear();
        self.state.free.extend(0..points as u32);
        self.renew();
    }

    /// The gaps of the pressures, free of gathered rounding.
    fn renew(&mut self) {
        self.operators.compliance.apply(&self.state.pressures, &mut self.state.gaps);
        self.applied += 1;
        self.state.gaps.iter_mut().zip(self.problem.heights).for_each(|(gap, height)| *gap -= height);
    }

    /// Takes `share` of the change that was tried, and looks where it has led: the offset, the free points, their gaps, and
    /// the residual.
    fn look(&mut self, share: f64) -> f64 {
        self.take(share);
        self.offset = self.offset_after(share);
        self.classify(share)
    }

    /// The pressures after `share` of the change.
    fn take(&mut self, share: f64) {
        if share == 0.0 {
            return;
        }
        let (cap, tiny) = (self.problem.cap, SNAP * self.problem.mean);
        let State { pressures, change, free, .. } = &mut *self.state;
        for &point in &*free {
            let pressure = pressures[point as usize] + share * change[point as usize];
            pressures[point as usize] = if pressure <= tiny {
                0.0
            } else if pressure >= cap * (1.0 - SNAP) {
                cap
            } else {
                pressure
            };
        }
    }

    /// The mean gap of the points between the bounds; where there are none, midway between what the others ask for.
    fn offset_after(&self, share: f64) -> f64 {
        let State { pressures, gaps, response, free, .. } = &*self.state;
        let cap = self.problem.cap;
        let [sum, count] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let between = pressures[point] > 0.0 && pressures[point] < cap;
            if between { [gaps[point] + share * response[point], 1.0] } else { [0.0; 2] }
        });
        if count > 0.0 {
            return sum / count;
        }
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

    /// The gaps after `share` of the change, and which points are free under them.
    fn classify(&mut self, share: f64) -> f64 {
        let Problem { mean, cap, heights, .. } = *self.problem;
        let offset = self.offset;
        let State { pressures, gaps, response, gradient, free, .. } = &mut *self.state;
        free.clear();
        let (mut overlap, mut opening) = (0.0f64, 0.0f64);
        (self.capped, self.joined) = (0, 0);
        let (capped, joined) = (&mut self.capped, &mut self.joined);
        let [unbalanced] = sums::over(heights.len(), |point| {
            gaps[point] += share * response[point];
            let (pressure, gap) = (pressures[point], gaps[point] - offset);
            let mut term = 0.0;
            let is_free = if pressure <= 0.0 {
                overlap = overlap.max(-gap);
                *joined += usize::from(gap < 0.0);
                gap < 0.0
            } else if pressure >= cap {
                opening = opening.max(gap);
                *joined += usize::from(gap > 0.0);
                *capped += usize::from(gap <= 0.0);
                gap > 0.0
            } else {
                term = pressure * gap.abs();
                true
            };
            gradient[point] = 0.0;
            if is_free {
                gradient[point] = gap as f32;
                free.push(point as u32);
            }
            [term]
        });
        let load = mean * heights.len() as f64;
        (unbalanced / load).max(overlap / OVERLAP_SHARE).max(opening / OVERLAP_SHARE)
    }

    /// Finds a change that lowers the energy, and the share of it to take; `None` where rounding leaves none.
    fn step(&mut self) -> Option<f64> {
        self.operators.preconditioner.apply_in_place(&mut self.state.gradient);
        let memory = self.conjugation();
        let found = self.aim(Direction::Conjugate(memory))
            || (memory != 0.0 && self.aim(Direction::Conjugate(0.0)))
            || self.aim(Direction::Spectral);
        found.then(|| self.search())
    }

    /// How much of the last change the next direction keeps, so that it does not undo it: t.Ks = 0.
    fn conjugation(&self) -> f64 {
        if !self.stepped {
            return 0.0;
        }
        let State { gradient, change, response, free, .. } = &*self.state;
        let [ones, z, zr, r, s, sr] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let (z, s, r) = (f64::from(gradient[point]), change[point], response[point]);
            [1.0, z, z * r, r, s, s * r]
        });
        let curvature = sr - s / ones * r;
        if curvature > 0.0 { (zr - z / ones * r) / curvature } else { 0.0 }
    }

    /// Aims along a direction, into `trial`; whether the energy falls that way.
    fn aim(&mut self, direction: Direction) -> bool {
        let length = self.fill_direction(direction);
        let Problem { mean, cap, heights, .. } = *self.problem;
        let State { pressures, gaps, free, direction, trial, .. } = &mut *self.state;
        trial.clear();
        trial.extend(free.iter().zip(&*direction).map(|(&point, t)| pressures[point as usize] + length * t));
        let elsewhere = if self.capped == 0 { 0.0 } else { self.capped as f64 * cap };
        let shift = shift_to_sum(trial, cap, mean * heights.len() as f64 - elsewhere);
        let offset = self.offset;
        let [slope] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            let aimed = (trial[at] + shift).clamp(0.0, cap);
            trial[at] = aimed;
            [(gaps[point] - offset) * (aimed - pressures[point])]
        });
        slope < 0.0
    }

    /// The direction on the free points; returns how far to go along it.
    fn fill_direction(&mut self, kind: Direction) -> f64 {
        let State { gaps, change, response, gradient, free, direction, .. } = &mut *self.state;
        direction.clear();
        match kind {
            Direction::Conjugate(memory) => {
                let [z, s] = sums::over(free.len(), |at| {
                    let point = free[at] as usize;
                    [f64::from(gradient[point]), change[point]]
                });
                let mean = (memory * s - z) / free.len() as f64;
                direction.extend(free.iter().map(|&point| {
                    memory * change[point as usize] - f64::from(gradient[point as usize]) - mean
                }));
                self.length
            }
            Direction::Spectral => {
                let offset = self.offset;
                direction.extend(free.iter().map(|&point| offset - gaps[point as usize]));
                let [ss, sr] = sums::over(change.len(), |point| {
                    [change[point] * change[point], change[point] * response[point]]
                });
                if sr > 0.0 { ss / sr } else { 1.0 }
            }
        }
    }

    /// Turns the trial into a change and its response, and finds the share of it that is best.
    fn search(&mut self) -> f64 {
        let Problem { cap, .. } = *self.problem;
        let State { pressures, gaps, change, response, free, trial, .. } = &mut *self.state;
        change.fill(0.0);
        let (mut reach, mut bounded) = (f64::INFINITY, false);
        for (&point, &aimed) in free.iter().zip(&*trial) {
            let pressure = pressures[point as usize];
            let step = aimed - pressure;
            change[point as usize] = step;
            if step < 0.0 {
                reach = reach.min(-pressure / step);
                bounded |= aimed == 0.0;
            } else if step > 0.0 && cap < f64::INFINITY {
                reach = reach.min((cap - pressure) / step);
                bounded |= aimed == cap;
            }
        }
        self.operators.compliance.apply(change, response);
        self.applied += 1;
        let offset = self.offset;
        let [slope, curvature] = sums::over(free.len(), |at| {
            let point = free[at] as usize;
            [(gaps[point] - offset) * change[point], change[point] * response[point]]
        });
        let best = if curvature > 0.0 { -slope / curvature } else { 1.0 };
        self.length =
            (self.length * best.clamp(1.0 / LARGEST_FACTOR, LARGEST_FACTOR)).clamp(SHORTEST, LONGEST);
        self.stepped = true;
        if bounded && best > 0.5 { 1.0 } else { best.min(reach) }
    }
}

/// Where a step may point.
#[derive(Clone, Copy)]
enum Direction {
    /// Along the preconditioned gap, and so much of the last change.
    Conjugate(f64),
    /// Along the gap, by the curvature met last.
    Spectral,
}

/// Overlaps count for a tenth of what unbalanced gaps do.
const OVERLAP_SHARE: f64 = 10.0;

/// Pressures so near to a bound are at it.
const SNAP: f64 = 1e-14;

/// How much longer or shorter than the last a step may be tried.
const LARGEST_FACTOR: f64 = 2.0;

/// The preconditioner inverts the compliance up to this.
const SHORTEST: f64 = 0.05;
const LONGEST: f64 = 20.0;
