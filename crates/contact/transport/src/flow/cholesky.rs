//! Direct solution of the flow: sparse Cholesky factors.

use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Col, Side};

use crate::flow::FlowError;
use crate::flow::network::{NONE, Network};

/// Pressures of the unknowns that balance the flow.
pub(super) fn pressures(network: &Network) -> Result<Vec<f64>, FlowError> {
    let count = network.count;
    let mut diagonal = vec![0.0; count];
    let mut triplets = Vec::with_capacity(count + network.ties.len());
    let is_held: Vec<bool> = {
        let mut is_held = vec![false; count];
        network.held.iter().for_each(|&unknown| is_held[unknown as usize] = true);
        is_held
    };
    let is_free = |unknown: u32| unknown != NONE && !is_held[unknown as usize];
    // A tie of a point with itself, around a field one point wide, changes nothing.
    for tie in network.ties.iter().filter(|tie| tie.from != tie.to) {
        for unknown in [tie.from, tie.to].into_iter().filter(|&unknown| is_free(unknown)) {
            diagonal[unknown as usize] += tie.conductance;
        }
        if is_free(tie.from) && is_free(tie.to) {
            let (low, high) = (tie.from.min(tie.to), tie.from.max(tie.to));
            triplets.push(Triplet::new(high, low, -tie.conductance));
        }
    }
    let scales: Vec<f64> =
        diagonal.iter().map(|&own| if own > 0.0 { own.sqrt().recip() } else { 1.0 }).collect();
    for Triplet { row, col, val } in &mut triplets {
        *val *= scales[*row as usize] * scales[*col as usize];
    }
    triplets.extend((0..count as u32).map(|unknown| Triplet::new(unknown, unknown, 1.0)));
    let matrix = SparseColMat::<u32, f64>::try_new_from_triplets(count, count, &triplets)
        .map_err(|_| FlowError::Singular)?;
    let factors = matrix.sp_cholesky(Side::Lower).map_err(|_| FlowError::Singular)?;
    let driven = network.outflow(&vec![0.0; count]);
    let load = Col::from_fn(count, |at| if is_held[at] { 0.0 } else { -driven[at] * scales[at] });
    let scaled = factors.solve(&load);
    Ok((0..count).map(|at| scaled[at] * scales[at]).collect())
}
