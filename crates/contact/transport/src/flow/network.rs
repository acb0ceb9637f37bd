//! Points of a gap that flow reaches, and the ties between them.

use crate::GapField;
use crate::flow::lattice::{Lattice, Parts};
use crate::flow::{Ends, FlowDirection, SolvedFlow};

/// Index of a missing point.
pub(super) const NONE: u32 = u32::MAX;

/// Tie between two points that carry flow, or between one and a reservoir.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tie {
    /// The unknown where the tie begins; [`NONE`] for the reservoir before the first.
    pub from: u32,
    /// The unknown where it ends; [`NONE`] for the reservoir behind the last.
    pub to: u32,
    /// Flow per pressure difference, in units of the slot's.
    pub conductance: f64,
    /// Fall of the mean pressure from one to the other: 1 per point along the flow, 0 across.
    pub fall: f64,
}

/// Points that carry flow, and their ties. A mean gradient of 1 per point drives the flow; the pressures are what is left.
#[derive(Default)]
pub(super) struct Network {
    /// One unknown of each connected part that no reservoir holds: its pressure is 0.
    pub held: Vec<u32>,
    /// Point of the grid of each unknown.
    places: Vec<u32>,
    /// Unknown behind each along the flow, with the conductance of the tie; [`NONE`] with one for the last reservoir.
    next: Vec<u32>,
    along: Vec<f64>,
    /// Unknown beside each, with the conductance of the tie.
    beside: Vec<u32>,
    across: Vec<f64>,
    /// Unknowns at the first reservoir, with the conductances of their ties.
    inlets: Vec<(u32, f64)>,
}

impl Network {
    pub(super) fn new(gap: &GapField<'_>, lattice: &Lattice) -> Self {
        let ends = lattice.ends;
        let mean_m = gap.mean_gap_m();
        let cubes: Vec<f64> = (0..lattice.points).map(|point| (gap.gap_m(point) / mean_m).powi(3)).collect();
        let is_open = |point: usize| cubes[point] > 0.0;
        let mut parts = Parts::new(lattice, is_open);
        let mut network = Network::default();
        let mut unknowns = vec![NONE; lattice.points];
        let mut is_held = vec![false; lattice.points + 1];
        for point in (0..lattice.points).filter(|&point| is_open(point)) {
            let (root, _) = parts.root(point as u32);
            if parts.leads_through[root as usize] {
                let unknown = network.places.len() as u32;
                if ends == Ends::Periodic && !std::mem::replace(&mut is_held[root as usize], true) {
                    network.held.push(unknown);
                }
                unknowns[point] = unknown;
                network.places.push(point as u32);
            }
        }
        let ratio = lattice.ratio;
        let harmonic =
            |one: usize, other: usize| 2.0 * cubes[one] * cubes[other] / (cubes[one] + cubes[other]);
        for (unknown, point) in network.places.iter().map(|&place| place as usize).enumerate() {
            if ends == Ends::Reservoirs && lattice.is_first(point) {
                network.inlets.push((unknown as u32, 2.0 * ratio * cubes[point]));
            }
            let (next, beside) = (lattice.next(point), lattice.beside(point));
            let (to, along) = match ends {
                Ends::Reservoirs if lattice.is_last(point) => (NONE, 2.0 * ratio * cubes[point]),
                _ if unknowns[next] == NONE => (NONE, 0.0),
                _ => (unknowns[next], ratio * harmonic(point, next)),
            };
            network.next.push(to);
            network.along.push(along);
            network.beside.push(unknowns[beside]);
            network.across.push(if unknowns[beside] == NONE { 0.0 } else { harmonic(point, beside) / ratio });
        }
        network
    }

    /// Number of unknowns.
    pub(super) fn count(&self) -> usize {
        self.places.len()
    }

    /// Ties of the network.
    pub(super) fn ties(&self) -> impl Iterator<Item = Tie> + '_ {
        let inlets =
            self.inlets.iter().map(|&(to, conductance)| Tie { from: NONE, to, conductance, fall: 0.5 });
        let others = (0..self.count()).flat_map(|at| {
            let (next, from) = (self.next[at], at as u32);
            let fall = if next == NONE { 0.5 } else { 1.0 };
            [
                Tie { from, to: next, conductance: self.along[at], fall },
                Tie { from, to: self.beside[at], conductance: self.across[at], fall: 0.0 },
            ]
        });
        inlets.chain(others).filter(|tie| tie.conductance > 0.0)
    }

    /// Conductance from each unknown to the reservoirs.
    pub(super) fn outlets(&self) -> Vec<f64> {
        let mut outlets = vec![0.0; self.count()];
        for tie in self.ties() {
            match (tie.from, tie.to) {
                (NONE, at) | (at, NONE) => outlets[at as usize] += tie.conductance,
                _ => {}
            }
        }
        outlets
    }

    /// Returns the ties of an unknown with others, up to four; those that are missing lead to itself.
    pub(super) fn ties_of_points(&self) -> impl Fn(usize) -> [(u32, f64); 4] + '_ {
        let before = |ends: &[u32]| {
            let mut before: Vec<u32> = (0..ends.len() as u32).collect();
            for (at, &end) in ends.iter().enumerate().filter(|(_, end)| **end != NONE) {
                before[end as usize] = at as u32;
            }
            before
        };
        let (before, above) = (before(&self.next), before(&self.beside));
        move |at| {
            let own = at as u32;
            let is_tied = |end: u32| if end == NONE { own } else { end };
            [
                (before[at], self.along[before[at] as usize]),
                (is_tied(self.next[at]), self.along[at]),
                (above[at], self.across[above[at] as usize]),
                (is_tied(self.beside[at]), self.across[at]),
            ]
        }
    }

    /// Sum of what flows out of each unknown under pressures and the mean gradient.
    pub(super) fn outflow(&self, pressures: &[f64]) -> Vec<f64> {
        let mut outflow = vec![0.0; self.count()];
        for tie in self.ties() {
            let flow = flow_through(&tie, pressures);
            if tie.from != NONE {
                outflow[tie.from as usize] += flow;
            }
            if tie.to != NONE {
                outflow[tie.to as usize] -= flow;
            }
        }
        outflow
    }

    /// Norm of the flow under the mean gradient alone: the scale of residuals.
    pub(super) fn driven(&self) -> f64 {
        self.ties().map(|tie| (tie.conductance * tie.fall).powi(2)).sum::<f64>().sqrt()
    }

    /// Norm of what rounding leaves of the balance of the unknowns, at most.
    pub(super) fn rounding(&self, pressures: &[f64]) -> f64 {
        let mut sizes = vec![0.0; self.count()];
        let size = |unknown: u32| if unknown == NONE { 0.0 } else { pressures[unknown as usize].abs() };
        for tie in self.ties() {
            let whole = tie.conductance * (tie.fall + size(tie.from) + size(tie.to));
            for unknown in [tie.from, tie.to].into_iter().filter(|&unknown| unknown != NONE) {
                sizes[unknown as usize] += whole;
            }
        }
        f64::EPSILON * norm(&sizes)
    }

    /// Power that the flow dissipates under pressures and the mean gradient.
    pub(super) fn power(&self, pressures: &[f64]) -> f64 {
        self.ties().map(|tie| flow_through(&tie, pressures).powi(2) / tie.conductance).sum()
    }

    /// Flow under pressures. Its factor is the dissipated power, whose error is of second order in that of the pressures.
    pub(super) fn flow(&self, pressures: &[f64], lattice: &Lattice, iterations: usize) -> SolvedFlow {
        let outflow = self.outflow(pressures);
        let flow_factor = self.power(pressures) / lattice.power_of_slot();
        let mut flux = vec![[0.0; 2]; lattice.points];
        let mean = flow_factor * lattice.power_of_slot() / lattice.points as f64;
        for tie in self.ties() {
            let is_along_x = (tie.fall > 0.0) == (lattice.direction == FlowDirection::X);
            let flow = 0.5 * flow_through(&tie, pressures) / mean;
            for unknown in [tie.from, tie.to].into_iter().filter(|&unknown| unknown != NONE) {
                flux[self.places[unknown as usize] as usize][usize::from(!is_along_x)] += flow;
            }
        }
        let residual = norm(&outflow) / self.driven();
        SolvedFlow { flow_factor, residual, iterations, flux }
    }
}

/// Flow through a tie under pressures and the mean gradient.
fn flow_through(tie: &Tie, pressures: &[f64]) -> f64 {
    let at = |unknown: u32| if unknown == NONE { 0.0 } else { pressures[unknown as usize] };
    tie.conductance * (tie.fall + at(tie.from) - at(tie.to))
}

/// Euclidean norm.
pub(super) fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}
