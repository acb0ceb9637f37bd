//! Points of a gap that flow reaches, and the ties between them.

use crate::GapField;
use crate::flow::{Direction, Ends, Flow};

/// Index of a point that carries no flow.
pub(super) const NONE: u32 = u32::MAX;

/// Tie between two points that carry flow, or between one and a reservoir.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tie {
    /// The point where the tie begins; [`NONE`] for the reservoir before the first.
    pub from: u32,
    /// The point where it ends; [`NONE`] for the reservoir behind the last.
    pub to: u32,
    /// Flow per pressure difference, in units of the slot's.
    pub conductance: f64,
    /// Fall of the mean pressure from one to the other: 1 per point along the flow, 0 across.
    pub fall: f64,
}

/// Points that carry flow, and their ties. A mean gradient of 1 per point drives the flow; the pressures are what is left.
pub(super) struct Network {
    /// Unknown of each point of the grid; [`NONE`] for those that carry no flow.
    pub unknowns: Vec<u32>,
    /// Number of unknowns.
    pub count: usize,
    /// Ties.
    pub ties: Vec<Tie>,
    /// One unknown of each connected part that no reservoir holds: its pressure is 0.
    pub held: Vec<u32>,
    along: usize,
    flow_of_slot: f64,
    direction: Direction,
    /// Point before each end of a tie, in the grid: to spread the flux.
    places: Vec<[u32; 2]>,
}

/// Parts of a field that are connected, each point with its offset from the root of its part in turns around the field.
struct Parts {
    parents: Vec<u32>,
    turns: Vec<i32>,
    /// True for roots of parts that lead around the field along the flow.
    leads_through: Vec<bool>,
}

impl Parts {
    fn new(points: usize) -> Self {
        Parts {
            parents: (0..points as u32).collect(),
            turns: vec![0; points],
            leads_through: vec![false; points],
        }
    }

    /// Finds the root of a point and its turns from there, and shortens the way.
    fn root(&mut self, point: u32) -> (u32, i32) {
        let (mut root, mut turns) = (point, 0);
        while self.parents[root as usize] != root {
            turns += self.turns[root as usize];
            root = self.parents[root as usize];
        }
        let (mut at, mut left) = (point, turns);
        while self.parents[at as usize] != root && at != root {
            let (next, own) = (self.parents[at as usize], self.turns[at as usize]);
            self.parents[at as usize] = root;
            self.turns[at as usize] = left;
            left -= own;
            at = next;
        }
        (root, turns)
    }

    /// Connects two points, with `turns` around the field from the first to the second.
    fn connect(&mut self, one: u32, other: u32, turns: i32) {
        let ((root, own), (second, others)) = (self.root(one), self.root(other));
        // The second root lies own + turns - others turns from the first.
        let between = own + turns - others;
        if root == second {
            self.leads_through[root as usize] |= between != 0;
            return;
        }
        self.parents[second as usize] = root;
        self.turns[second as usize] = between;
        self.leads_through[root as usize] |= self.leads_through[second as usize];
    }
}

impl Network {
    pub(super) fn new(gap: &GapField<'_>, direction: Direction, ends: Ends) -> Self {
        let grid = gap.grid();
        let (rows, columns, points) = (grid.rows(), grid.columns(), grid.points());
        let mean_m = gap.mean_gap_m();
        let cubes: Vec<f64> = (0..points).map(|point| (gap.gap_m(point) / mean_m).powi(3)).collect();
        let is_open = |point: usize| cubes[point] > 0.0;
        let right =
            |point: usize| if (point + 1).is_multiple_of(columns) { point + 1 - columns } else { point + 1 };
        let below = |point: usize| (point + columns) % points;
        let (step_x_m, step_y_m) = (grid.length_x_m() / columns as f64, grid.length_y_m() / rows as f64);
        let ratio = match direction {
            Direction::X => step_y_m / step_x_m,
            Direction::Y => step_x_m / step_y_m,
        };
        // Along the flow and across it.
        let (along, across, next, beside): (_, _, &dyn Fn(usize) -> usize, &dyn Fn(usize) -> usize) =
            match direction {
                Direction::X => (columns, rows, &right, &below),
                Direction::Y => (rows, columns, &below, &right),
            };
        let place = |point: usize| match direction {
            Direction::X => point % columns,
            Direction::Y => point / columns,
        };
        let is_end = |point: usize| place(point) + 1 == along;
        let mut parts = Parts::new(points + 1);
        let reservoir = points as u32;
        for point in (0..points).filter(|&point| is_open(point)) {
            if is_open(beside(point)) {
                parts.connect(point as u32, beside(point) as u32, 0);
            }
            match ends {
                Ends::Periodic if is_open(next(point)) => {
                    parts.connect(point as u32, next(point) as u32, i32::from(is_end(point)));
                }
                Ends::Reservoirs if !is_end(point) && is_open(next(point)) => {
                    parts.connect(point as u32, next(point) as u32, 0);
                }
                Ends::Reservoirs if is_end(point) => parts.connect(point as u32, reservoir, 1),
                _ => {}
            }
            if ends == Ends::Reservoirs && place(point) == 0 {
                parts.connect(reservoir, point as u32, 0);
            }
        }
        let mut unknowns = vec![NONE; points];
        let (mut count, mut held, mut is_held) = (0, Vec::new(), vec![false; points + 1]);
        for point in (0..points).filter(|&point| is_open(point)) {
            let (root, _) = parts.root(point as u32);
            if parts.leads_through[root as usize] {
                if ends == Ends::Periodic && !std::mem::replace(&mut is_held[root as usize], true) {
                    held.push(count as u32);
                }
                unknowns[point] = count as u32;
                count += 1;
            }
        }
        let harmonic =
            |one: usize, other: usize| 2.0 * cubes[one] * cubes[other] / (cubes[one] + cubes[other]);
        let (mut ties, mut places) = (Vec::new(), Vec::new());
        let mut tie = |from: usize, to: usize, conductance: f64, fall: f64| {
            let unknown = |point: usize| unknowns.get(point).copied().unwrap_or(NONE);
            ties.push(Tie { from: unknown(from), to: unknown(to), conductance, fall });
            places.push([from as u32, to as u32]);
        };
        for point in (0..points).filter(|&point| unknowns[point] != NONE) {
            if ends == Ends::Reservoirs && place(point) == 0 {
                tie(usize::MAX, point, 2.0 * ratio * cubes[point], 0.5);
            }
            if ends == Ends::Reservoirs && is_end(point) {
                tie(point, usize::MAX, 2.0 * ratio * cubes[point], 0.5);
            } else if is_open(next(point)) {
                tie(point, next(point), ratio * harmonic(point, next(point)), 1.0);
            }
            if is_open(beside(point)) {
                tie(point, beside(point), harmonic(point, beside(point)) / ratio, 0.0);
            }
        }
        Network { unknowns, count, ties, held, along, flow_of_slot: across as f64 * ratio, direction, places }
    }

    /// Returns true if no path leads through.
    pub(super) fn is_closed(&self) -> bool {
        self.count == 0
    }

    /// Sum of what flows out of each unknown under the mean gradient and pressures.
    pub(super) fn outflow(&self, pressures: &[f64]) -> Vec<f64> {
        let mut outflow = vec![0.0; self.count];
        for tie in &self.ties {
            let flow = self.flow_through(tie, pressures);
            if tie.from != NONE {
                outflow[tie.from as usize] += flow;
            }
            if tie.to != NONE {
                outflow[tie.to as usize] -= flow;
            }
        }
        outflow
    }

    fn flow_through(&self, tie: &Tie, pressures: &[f64]) -> f64 {
        let at = |unknown: u32| if unknown == NONE { 0.0 } else { pressures[unknown as usize] };
        tie.conductance * (tie.fall + at(tie.from) - at(tie.to))
    }

    /// Flow under pressures. Its factor is the dissipated power, whose error is of second order in that of the pressures.
    pub(super) fn flow(&self, pressures: &[f64]) -> Flow {
        let outflow = self.outflow(pressures);
        // Flow of the mean gradient alone through each tie.
        let driven: Vec<f64> = self.ties.iter().map(|tie| tie.conductance * tie.fall).collect();
        let norm = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>().sqrt();
        let power: f64 =
            self.ties.iter().map(|tie| self.flow_through(tie, pressures).powi(2) / tie.conductance).sum();
        let flow_factor = power / self.along as f64 / self.flow_of_slot;
        let points = self.unknowns.len();
        let mut flux = vec![[0.0; 2]; points];
        for (tie, places) in self.ties.iter().zip(&self.places) {
            let is_along_x = (tie.fall > 0.0) == (self.direction == Direction::X);
            let flow = 0.5 * self.flow_through(tie, pressures);
            for &place in places.iter().filter(|&&place| (place as usize) < points) {
                flux[place as usize][usize::from(!is_along_x)] += flow;
            }
        }
        let residual = norm(&outflow) / norm(&driven);
        let mean = flow_factor * self.flow_of_slot / points as f64 * self.along as f64;
        flux.iter_mut().flatten().for_each(|flow| *flow /= mean);
        Flow { flow_factor, residual, iterations: 0, flux }
    }
}
