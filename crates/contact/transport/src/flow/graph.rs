//! Points with ties to each other and to reservoirs.

use crate::flow::network::Network;

/// Points and their ties, each tie listed at both of its ends.
pub(super) struct Graph {
    /// Index of the first tie of each point, and the number of ties.
    starts: Vec<u32>,
    /// Index of the first tie of each point that leads to a later one.
    middles: Vec<u32>,
    /// Neighbours of each point in ascending order.
    neighbours: Vec<u32>,
    /// Conductances of the ties.
    ties: Vec<f64>,
    /// Conductance from each point to the reservoirs.
    outlets: Vec<f64>,
}

/// Builds a graph point by point.
pub(super) struct GraphBuilder {
    graph: Graph,
    row: Vec<(u32, f64)>,
}

impl GraphBuilder {
    /// Creates a graph without points, with room for some.
    pub(super) fn with_capacity(points: usize, ties: usize) -> Self {
        let mut starts = Vec::with_capacity(points + 1);
        starts.push(0);
        let graph = Graph {
            starts,
            middles: Vec::with_capacity(points),
            neighbours: Vec::with_capacity(ties),
            ties: Vec::with_capacity(ties),
            outlets: Vec::with_capacity(points),
        };
        GraphBuilder { graph, row: Vec::new() }
    }

    /// Adds a tie of the next point; ties to one neighbour add up.
    pub(super) fn tie(&mut self, to: u32, conductance: f64) {
        match self.row.iter_mut().find(|(known, _)| *known == to) {
            Some((_, sum)) => *sum += conductance,
            None => self.row.push((to, conductance)),
        }
    }

    /// Closes the next point, with its conductance to the reservoirs.
    pub(super) fn close(&mut self, outlet: f64) {
        let GraphBuilder { graph, row } = self;
        row.sort_unstable_by_key(|&(other, _)| other);
        let own = graph.outlets.len() as u32;
        graph.middles.push((graph.ties.len() + row.partition_point(|&(other, _)| other < own)) as u32);
        for (other, tie) in row.drain(..) {
            graph.neighbours.push(other);
            graph.ties.push(tie);
        }
        graph.starts.push(graph.ties.len() as u32);
        graph.outlets.push(outlet);
    }

    /// Returns the graph.
    pub(super) fn finish(mut self) -> Graph {
        self.graph.neighbours.shrink_to_fit();
        self.graph.ties.shrink_to_fit();
        self.graph
    }
}

impl Graph {
    /// Creates the graph of a network.
    pub(super) fn of_network(network: &Network) -> Self {
        let outlets = network.outlets();
        let mut builder = GraphBuilder::with_capacity(outlets.len(), 4 * outlets.len());
        let ties = network.ties_of_points();
        for (at, outlet) in outlets.into_iter().enumerate() {
            ties(at)
                .into_iter()
                .filter(|&(other, _)| other != at as u32)
                .for_each(|(other, tie)| builder.tie(other, tie));
            builder.close(outlet);
        }
        builder.finish()
    }

    /// Number of points.
    pub(super) fn count(&self) -> usize {
        self.outlets.len()
    }

    /// Number of ties, counted at both ends.
    pub(super) fn tie_count(&self) -> usize {
        self.ties.len()
    }

    /// Number of ties of a point.
    pub(super) fn degree(&self, at: usize) -> usize {
        (self.starts[at + 1] - self.starts[at]) as usize
    }

    /// Ties of a point.
    pub(super) fn ties(&self, at: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.between(self.starts[at], self.starts[at + 1])
    }

    fn between(&self, start: u32, end: u32) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = start as usize..end as usize;
        let neighbours = self.neighbours[range.clone()].iter().map(|&other| other as usize);
        neighbours.zip(self.ties[range].iter().copied())
    }

    /// Conductance from a point to the reservoirs.
    pub(super) fn outlet(&self, at: usize) -> f64 {
        self.outlets[at]
    }

    /// Sum of the conductances of a point.
    pub(super) fn conductance(&self, at: usize) -> f64 {
        self.ties(at).map(|(_, tie)| tie).sum::<f64>() + self.outlets[at]
    }

    /// Inflow from all neighbours of a point that has no value itself.
    pub(super) fn inflow(&self, at: usize, values: &[f64]) -> f64 {
        self.ties(at).map(|(other, tie)| tie * values[other]).sum()
    }

    /// Inflow from earlier neighbours alone.
    pub(super) fn inflow_of_earlier(&self, at: usize, values: &[f64]) -> f64 {
        self.between(self.starts[at], self.middles[at]).map(|(other, tie)| tie * values[other]).sum()
    }

    /// Inflow from later neighbours alone.
    pub(super) fn inflow_of_later(&self, at: usize, values: &[f64]) -> f64 {
        self.between(self.middles[at], self.starts[at + 1]).map(|(other, tie)| tie * values[other]).sum()
    }

    /// Sets `outflow` to the flow out of each point under `values`.
    pub(super) fn apply(&self, values: &[f64], outflow: &mut [f64]) {
        for (at, (outflow, &own)) in outflow.iter_mut().zip(values).enumerate() {
            let flow: f64 = self.ties(at).map(|(other, tie)| tie * (own - values[other])).sum();
            *outflow = flow + self.outlets[at] * own;
        }
    }
}
