//! Points with few ties, eliminated exactly: the star of their ties becomes the mesh between its tips.

use crate::flow::graph::{Graph, GraphBuilder};
use crate::flow::network::NONE;

/// Share of the points below which elimination ends.
const LEAST_SHARE: f64 = 0.05;
/// Ties of a point that is eliminated from a large graph: its mesh has no more than half as many again.
const MOST_TIES: usize = 4;
/// Points of a graph that is eliminated as a whole.
const SMALL: usize = 300;

/// One set of eliminated points, none of them neighbours.
pub(super) struct Elimination {
    /// Points that are kept.
    kept: Vec<u32>,
    eliminated: Vec<u32>,
    /// Inverse of the conductance of each eliminated point.
    resistances: Vec<f64>,
    /// Index of the first tip of each, and the number of tips.
    starts: Vec<u32>,
    /// Index of each tip among the kept points, with its share of the load.
    tips: Vec<(u32, f64)>,
}

/// Eliminates points with few ties while there are many of them, and the whole of a small graph; returns the graph that is left.
pub(super) fn eliminate(mut graph: Graph, mut found: impl FnMut(Elimination)) -> Graph {
    while graph.count() > 0 {
        let is_small = graph.count() < SMALL;
        let fewest = (0..graph.count()).map(|at| graph.degree(at)).min().unwrap_or(0);
        let most = if is_small { fewest.max(MOST_TIES) } else { MOST_TIES };
        let (elimination, reduced) = Elimination::new(&graph, most);
        if !is_small && (elimination.eliminated.len() as f64) < LEAST_SHARE * graph.count() as f64 {
            break;
        }
        found(elimination);
        graph = reduced;
    }
    graph
}

impl Elimination {
    /// Eliminates points with at most `most` ties. Conductances are sums of positive terms, so that rounding stays relative.
    fn new(graph: &Graph, most: usize) -> (Self, Graph) {
        const OUT: u32 = NONE;
        let count = graph.count();
        let mut places = vec![0; count];
        let (mut kept, mut eliminated) = (Vec::with_capacity(count), Vec::new());
        for at in 0..count {
            if graph.degree(at) <= most && graph.ties(at).all(|(other, _)| places[other] != OUT) {
                places[at] = OUT;
                eliminated.push(at as u32);
            } else {
                places[at] = kept.len() as u32;
                kept.push(at as u32);
            }
        }
        let (mut starts, mut tips, mut resistances) = (vec![0], Vec::new(), Vec::new());
        let mut resistance_at = vec![0.0; count];
        for point in eliminated.iter().map(|&point| point as usize) {
            let conductance = graph.conductance(point);
            let resistance = if conductance > 0.0 { conductance.recip() } else { 0.0 };
            tips.extend(graph.ties(point).map(|(tip, tie)| (places[tip], tie * resistance)));
            starts.push(tips.len() as u32);
            resistances.push(resistance);
            resistance_at[point] = resistance;
        }
        let mut builder = GraphBuilder::with_capacity(kept.len(), graph.tie_count());
        for point in kept.iter().map(|&point| point as usize) {
            let mut outlet = graph.outlet(point);
            for (other, tie) in graph.ties(point) {
                if places[other] != OUT {
                    builder.tie(places[other], tie);
                    continue;
                }
                let share = tie * resistance_at[other];
                outlet += share * graph.outlet(other);
                for (tip, second) in graph.ties(other).filter(|&(tip, _)| tip != point) {
                    builder.tie(places[tip], share * second);
                }
            }
            builder.close(outlet);
        }
        (Elimination { kept, eliminated, resistances, starts, tips }, builder.finish())
    }

    /// Number of points that are kept.
    pub(super) fn kept(&self) -> usize {
        self.kept.len()
    }

    fn tips(&self, at: usize) -> &[(u32, f64)] {
        &self.tips[self.starts[at] as usize..self.starts[at + 1] as usize]
    }

    /// Sets the load of the kept points.
    pub(super) fn reduce(&self, load: &[f64], reduced: &mut [f64]) {
        for (reduced, &point) in reduced.iter_mut().zip(&self.kept) {
            *reduced = load[point as usize];
        }
        for (at, &point) in self.eliminated.iter().enumerate() {
            let own = load[point as usize];
            self.tips(at).iter().for_each(|&(tip, share)| reduced[tip as usize] += share * own);
        }
    }

    /// Power that a load takes away at the eliminated points.
    pub(super) fn fall(&self, load: &[f64]) -> f64 {
        let eliminated = self.eliminated.iter().zip(&self.resistances);
        eliminated.map(|(&point, resistance)| load[point as usize] * load[point as usize] * resistance).sum()
    }

    /// Sets the values of all points from their load and the values of the kept ones.
    pub(super) fn extend(&self, load: &[f64], reduced: &[f64], values: &mut [f64]) {
        for (&value, &point) in reduced.iter().zip(&self.kept) {
            values[point as usize] = value;
        }
        for (at, (&point, resistance)) in self.eliminated.iter().zip(&self.resistances).enumerate() {
            let tips: f64 = self.tips(at).iter().map(|&(tip, share)| share * reduced[tip as usize]).sum();
            values[point as usize] = load[point as usize] * resistance + tips;
        }
    }
}
