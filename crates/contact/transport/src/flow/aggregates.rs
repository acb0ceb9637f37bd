//! Points merged in pairs along their strongest ties.

use crate::flow::graph::{Graph, GraphBuilder};
use crate::flow::network::NONE;

/// Pairings from one grid to the next: aggregates of up to 2^3 points.
const PAIRINGS: usize = 3;
/// Largest quality of a pair: the conductances of its ends in series, over that of its tie.
const WORST_QUALITY: f64 = 4.0;
/// Least share of the points that one grid has less than the one before.
const LEAST_FALL: f64 = 0.2;

/// Points merged to aggregates.
pub(super) struct Aggregates {
    /// Aggregate of each point.
    pub parents: Vec<u32>,
    /// Ties between aggregates.
    pub graph: Graph,
}

impl Aggregates {
    /// Merges the points of a graph. A pair is good if what ties it together is not weak against what a sweep over its single points
    /// has to move: the sum of all their conductances, also of those inside earlier pairs. Bad pairs are formed only if there are too
    /// few good ones.
    pub(super) fn new(graph: &Graph) -> Self {
        let mut worst = WORST_QUALITY;
        loop {
            let mut conductances: Vec<f64> = (0..graph.count()).map(|at| graph.conductance(at)).collect();
            let mut merged = Self::pairs(graph, &mut conductances, worst);
            for _ in 1..PAIRINGS {
                let Aggregates { parents, graph } = Self::pairs(&merged.graph, &mut conductances, worst);
                merged.parents.iter_mut().for_each(|parent| *parent = parents[*parent as usize]);
                merged.graph = graph;
            }
            let is_enough = merged.graph.count() as f64 <= (1.0 - LEAST_FALL) * graph.count() as f64;
            if is_enough || worst > 1e12 {
                return merged;
            }
            worst *= 4.0;
        }
    }

    /// Merges each point with the free neighbour with which it makes the best pair; sets the conductances of the pairs.
    fn pairs(graph: &Graph, conductances: &mut Vec<f64>, worst: f64) -> Self {
        let count = graph.count();
        let mut parents = vec![NONE; count];
        let mut members: Vec<[u32; 2]> = Vec::with_capacity(count);
        for at in 0..count {
            if parents[at] != NONE {
                continue;
            }
            let (mut best, mut least) = (NONE, worst);
            for (other, tie) in graph.ties(at).filter(|&(other, _)| parents[other] == NONE) {
                let (one, two) = (conductances[at], conductances[other]);
                let quality = one / (one + two) * two / tie;
                if quality <= least {
                    (best, least) = (other as u32, quality);
                }
            }
            let pair = members.len();
            parents[at] = pair as u32;
            // Pairs are fewer than the points so far.
            conductances[pair] = conductances[at];
            if best != NONE {
                parents[best as usize] = pair as u32;
                conductances[pair] += conductances[best as usize];
            }
            members.push([at as u32, best]);
        }
        conductances.truncate(members.len());
        let mut builder = GraphBuilder::with_capacity(members.len(), graph.tie_count());
        for (pair, points) in members.iter().enumerate() {
            let mut outlet = 0.0;
            for point in points.iter().filter(|&&point| point != NONE).map(|&point| point as usize) {
                outlet += graph.outlet(point);
                for (other, tie) in graph.ties(point).filter(|&(other, _)| parents[other] as usize != pair) {
                    builder.tie(parents[other], tie);
                }
            }
            builder.close(outlet);
        }
        Aggregates { parents, graph: builder.finish() }
    }
}
