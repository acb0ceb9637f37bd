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

/// Change from one grid to the next, and the vectors of the next.
struct Level {
    change: Change,
    coarse: Coarse,
}

/// Load and values of a grid, and the vectors of the iteration there.
struct Coarse {
    load: Vec<f64>,
    values: Vec<f64>,
    /// Values of the first step, and what flows out under those of both.
    first: Vec<f64>,
    outflow: Vec<f64>,
    second_outflow: Vec<f64>,
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
        first_graph(&self.levels)
    }

    /// Approximates the values of a load.
    pub(super) fn solve(&mut self, load: &[f64], values: &mut [f64]) {
        cycle(&mut self.levels, load, values);
    }
}

impl Level {
    fn new(change: Change, next: usize) -> Self {
        let [load, values] = [(); 2].map(|()| vec![0.0; next]);
        let coarse =
            Coarse { load, values, first: Vec::new(), outflow: Vec::new(), second_outflow: Vec::new() };
        Level { change, coarse }
    }
}

/// The graph of the first level, if its points are merged.
fn first_graph(levels: &[Level]) -> Option<&Graph> {
    levels.first().and_then(|level| match &level.change {
        Change::Merging(merging) => Some(&merging.graph),
        Change::Elimination(_) => None,
    })
}

/// Approximates the values of a load: exactly at eliminated points; by a sweep forwards, the next grid, and a sweep backwards at
/// merged ones.
fn cycle(levels: &mut [Level], load: &[f64], values: &mut [f64]) {
    let [Level { change, coarse }, coarser @ ..] = levels else { return };
    match change {
        Change::Elimination(elimination) => {
            elimination.reduce(load, &mut coarse.load);
            iterate(coarser, coarse);
            elimination.extend(load, &coarse.values, values);
        }
        Change::Merging(merging) => {
            merging.sweep_forwards_from_zero(load, values);
            merging.restrict(values, &mut coarse.load);
            iterate(coarser, coarse);
            for (value, &parent) in values.iter_mut().zip(&merging.parents) {
                *value += coarse.values[parent as usize];
            }
            merging.sweep_backwards(load, values);
        }
    }
}

/// Approximates the values of a load: by a cycle, or on merged points by at most two steps of flexible conjugate gradients, which
/// overwrite the load.
fn iterate(levels: &mut [Level], coarse: &mut Coarse) {
    let Coarse { load, values, first, outflow, second_outflow } = coarse;
    let apply = |levels: &[Level], values: &[f64], outflow: &mut Vec<f64>| {
        outflow.resize(values.len(), 0.0);
        if let Some(graph) = first_graph(levels) {
            graph.apply(values, outflow);
        }
    };
    if first_graph(levels).is_none() {
        cycle(levels, load, values);
        return;
    }
    first.resize(load.len(), 0.0);
    cycle(levels, load, first);
    apply(levels, first, outflow);
    let (energy, before) = (dot(first, outflow), dot(load, load));
    if energy <= 0.0 {
        values.fill(0.0);
        return;
    }
    let mut length = dot(first, load) / energy;
    load.iter_mut().zip(&*outflow).for_each(|(load, outflow)| *load -= length * outflow);
    if dot(load, load) <= ENOUGH * ENOUGH * before {
        values.iter_mut().zip(&*first).for_each(|(value, first)| *value = length * first);
        return;
    }
    cycle(levels, load, values);
    apply(levels, values, second_outflow);
    let (shared, fall) = (dot(values, outflow), dot(values, load));
    let left = dot(values, second_outflow) - shared * shared / energy;
    let second = if left > 0.0 { fall / left } else { 0.0 };
    length -= shared * second / energy;
    values.iter_mut().zip(&*first).for_each(|(value, first)| *value = length * first + second * *value);
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
        Merging { graph, resistances, parents }
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
