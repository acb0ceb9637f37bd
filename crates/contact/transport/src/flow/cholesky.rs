//! Direct solution of the flow: sparse Cholesky factors.

use faer::prelude::Solve;
use faer::sparse::linalg::solvers::Llt;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Col, Side};

use crate::flow::multigrid::dot;
use crate::flow::network::{NONE, Network};
use crate::flow::{Correction, FlowError};

/// Factors of the balance of a network, scaled to a diagonal of 1.
pub(super) struct Factors {
    factors: Llt<u32, f64>,
    scales: Vec<f64>,
    is_held: Vec<bool>,
}

impl Factors {
    pub(super) fn new(network: &Network) -> Result<Self, FlowError> {
        let count = network.count();
        let mut diagonal = vec![0.0; count];
        let mut triplets = Vec::with_capacity(3 * count);
        let mut is_held = vec![false; count];
        network.held.iter().for_each(|&unknown| is_held[unknown as usize] = true);
        let is_free = |unknown: u32| unknown != NONE && !is_held[unknown as usize];
        // A tie of a point with itself, around a field one point wide, changes nothing.
        for tie in network.ties().filter(|tie| tie.from != tie.to) {
            for unknown in [tie.from, tie.to].into_iter().filter(|&unknown| is_free(unknown)) {
                diagonal[unknown as usize] += tie.conductance;
            }
            if is_free(tie.from) && is_free(tie.to) {
                triplets.push(Triplet::new(tie.from.max(tie.to), tie.from.min(tie.to), -tie.conductance));
            }
        }
        let scales: Vec<f64> =
            diagonal.iter().map(|&own| if own > 0.0 { own.sqrt().recip() } else { 1.0 }).collect();
        for Triplet { row, col, val } in &mut triplets {
            *val *= scales[*row as usize] * scales[*col as usize];
        }
        triplets.extend((0..count as u32).map(|unknown| Triplet::new(unknown, unknown, 1.0)));
        let matrix = SparseColMat::<u32, f64>::try_new_from_triplets(count, count, &triplets)
            .map_err(|_| FlowError::Stalled)?;
        let factors = matrix.sp_cholesky(Side::Lower).map_err(|_| FlowError::Stalled)?;
        Ok(Factors { factors, scales, is_held })
    }

    /// Pressures under which the unknowns take up a load.
    pub(super) fn solve(&self, load: &[f64]) -> Correction {
        let scaled = |at: usize| if self.is_held[at] { 0.0 } else { load[at] * self.scales[at] };
        let solved = self.factors.solve(&Col::from_fn(load.len(), scaled));
        let pressures: Vec<f64> =
            self.scales.iter().enumerate().map(|(at, scale)| solved[at] * scale).collect();
        Correction { fall: dot(&pressures, load), pressures }
    }
}
