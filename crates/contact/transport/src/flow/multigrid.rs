//! Multigrid preconditioner of the flow: in turns, points with few ties are eliminated and the others merged along their strongest
//! ties (Livne & Brandt 2012, SIAM J. Sci. Comput. 34:B499; Notay 2010, Electron. Trans. Numer. Anal. 37:123).

use crate::flow::aggregates::Aggregates;
use crate::flow::elimination::{Elimination, eliminate};
use crate::flow::graph::Graph;

/// Fall of the residual by one step of a coarse grid that spares the second.
const ENOUGH: f64 = 0.25;

/// Grids of fewer and fewer points.
pub(super) struct Multigrid {
    levels: Vec<Level>,
}

/// Change from one grid to the next, with load and values of the next.
struct Level {
    change: Change,
    load: Vec<f64>,
    values: Vec<f64>,
}

enum Change {
    Elimination(Elimination),
    Merging(Merging),
}

/// Points merged to aggregates.
struct Merging {
    graph: Graph,
    /// Inverse of the conductance of each point.
    resistances: Vec<f64>,
    /// Aggregate of each point.
    parents: Vec<u32>,
    /// Values of the first step, and the outflows of both steps, of the iteration on this grid.
    first: Vec<f64>,
    outflow: Vec<f64>,
    second_outflow: Vec<f64>,
}

impl Multigrid {
    /// Creates the grids below a graph.
    pub(super) fn new(mut graph: Graph) -> Self {
        let mut levels = Vec::new();
        while graph.count() > 0 {
            let aggregates = Aggregates::new(&graph);
            let count = aggregates.graph.count();
            let merging = Merging::new(graph, aggregates.parents);
            levels.push(Level::new(Change::Merging(merging), count));
            graph = eliminate(aggregates.graph, |elimination| {
                let kept = elimination.kept();
                levels.push(Level::new(Change::Elimination(elimination), kept));
            });
        }
        Multigrid { levels }
    }

    /// The graph above all grids; none without points.
    pub(super) fn graph(&self) -> Option<&Graph> {
        self.levels.first().and_then(|level| match &level.change {
            Change::Merging(merging) => Some(&merging.graph),
            Change::Elimination(_) => None,
        })
    }

    /// Approximates the values of a load.
    pub(super) fn solve(&mut self, load: &[f64], values: &mut [f64]) {
        cycle(&mut self.levels, load, values);
    }
}

impl Level {
    fn new(change: Change, next: usize) -> Self {
        Level { change, load: vec![0.0; next], values: vec![0.0; next] }
    }
}

/// Approximates the values of a load: exactly at eliminated points; by a sweep forwards, the next grid, and a sweep backwards at
/// merged ones.
fn cycle(levels: &mut [Level], load: &[f64], values: &mut [f64]) {
    let [Level { change, load: coarse_load, values: coarse_values }, coarser @ ..] = levels else { return };
    match change {
        Change::Elimination(elimination) => {
            elimination.reduce(load, coarse_load);
            iterate(coarser, coarse_load, coarse_values);
            elimination.extend(load, coarse_values, values);
        }
        Change::Merging(merging) => {
            merging.sweep_forwards_from_zero(load, values);
            merging.restrict(values, coarse_load);
            iterate(coarser, coarse_load, coarse_values);
            for (value, &parent) in values.iter_mut().zip(&merging.parents) {
                *value += coarse_values[parent as usize];
            }
            merging.sweep_backwards(load, values);
        }
    }
}

/// Approximates the values of a load; on merged points by one or two steps of flexible conjugate gradients, which overwrite the load.
fn iterate(levels: &mut [Level], load: &mut [f64], values: &mut [f64]) {
    let Some(Change::Merging(merging)) = levels.first_mut().map(|level| &mut level.change) else {
        cycle(levels, load, values);
        return;
    };
    let mut first = std::mem::take(&mut merging.first);
    cycle(levels, load, &mut first);
    // Always there: the first level is a merging.
    let Some(Change::Merging(merging)) = levels.first_mut().map(|level| &mut level.change) else { return };
    merging.graph.apply(&first, &mut merging.outflow);
    let (energy, before) = (dot(&first, &merging.outflow), dot(load, load));
    let length = if energy > 0.0 { dot(&first, load) / energy } else { 0.0 };
    load.iter_mut().zip(&merging.outflow).for_each(|(load, outflow)| *load -= length * outflow);
    let (mut one, mut two) = (length, 0.0);
    if energy > 0.0 && dot(load, load) > ENOUGH * ENOUGH * before {
        cycle(levels, load, values);
        let Some(Change::Merging(merging)) = levels.first_mut().map(|level| &mut level.change) else {
            return;
        };
        merging.graph.apply(values, &mut merging.second_outflow);
        let (shared, fall) = (dot(values, &merging.outflow), dot(values, load));
        let left = dot(values, &merging.second_outflow) - shared * shared / energy;
        if left > 0.0 {
            two = fall / left;
            one -= shared * two / energy;
        }
    } else {
        values.fill(0.0);
    }
    values.iter_mut().zip(&first).for_each(|(value, first)| *value = one * first + two * *value);
    if let Some(Change::Merging(merging)) = levels.first_mut().map(|level| &mut level.change) {
        merging.first = first;
    }
}

/// Sum of the products of two vectors, in eight partial sums.
pub(super) fn dot(one: &[f64], other: &[f64]) -> f64 {
    let ((ones, one), (others, other)) = (one.as_chunks::<8>(), other.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (one, other) in ones.iter().zip(others) {
        for (sum, (one, other)) in sums.iter_mut().zip(one.iter().zip(other)) {
            *sum += one * other;
        }
    }
    sums.iter().sum::<f64>() + one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>()
}

impl Merging {
    fn new(graph: Graph, parents: Vec<u32>) -> Self {
        let count = graph.count();
        let resistance = |conductance: f64| if conductance > 0.0 { conductance.recip() } else { 0.0 };
        let resistances = (0..count).map(|at| resistance(graph.conductance(at))).collect();
        let [first, outflow, second_outflow] = [(); 3].map(|()| vec![0.0; count]);
        Merging { graph, resistances, parents, first, outflow, second_outflow }
    }

    /// Runs a Gauss-Seidel sweep from zero: later neighbours are still 0.
    fn sweep_forwards_from_zero(&self, load: &[f64], values: &mut [f64]) {
        for (at, (load, resistance)) in load.iter().zip(&self.resistances).enumerate() {
            values[at] = (load + self.graph.inflow_of_earlier(at, values)) * resistance;
        }
    }

    /// Sums over each aggregate what the forward sweep leaves: the inflow of later neighbours.
    fn restrict(&self, values: &[f64], coarse_load: &mut [f64]) {
        coarse_load.fill(0.0);
        for (at, &parent) in self.parents.iter().enumerate() {
            coarse_load[parent as usize] += self.graph.inflow_of_later(at, values);
        }
    }

    fn sweep_backwards(&self, load: &[f64], values: &mut [f64]) {
        for (at, (load, resistance)) in load.iter().zip(&self.resistances).enumerate().rev() {
            values[at] = (load + self.graph.inflow(at, values)) * resistance;
        }
    }
}
