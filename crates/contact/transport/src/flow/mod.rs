//! Flow factors of a gap by Reynolds' equation, div(g^3 grad p) = 0 with the local gap g: Patir & Cheng (1978), ASME J. Lubr.
//! Technol. 100:12, on one field.
//!
//! The flow factor phi = <g^3 dp/dx>/(gbar^3 G) compares the flow under a mean pressure gradient G with that through a parallel
//! slot of the mean gap gbar, the mean over all points. Contact is impermeable. Points exchange fluid with their four neighbours,
//! through the harmonic mean of g^3.

mod cholesky;
mod network;

use numerics::parallel::Progress;
use serde::Serialize;
use thiserror::Error;

use crate::GapField;
use network::Network;

/// Number of progress steps of [`solve`].
pub const PROGRESS_STEPS: usize = 100;

/// Direction of the mean pressure gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// Along x, from column to column.
    X,
    /// Along y, from row to row.
    Y,
}

/// Condition at the two ends of the field along the flow. The sides repeat themselves in either case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ends {
    /// The field repeats itself, and so does the flow.
    #[default]
    Periodic,
    /// A reservoir feeds every open point of the first row or column, and another drains the last.
    Reservoirs,
}

/// Flow through a gap along one direction.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Flow {
    /// Flow factor phi >= 0; exactly 0 where no path leads through.
    pub flow_factor: f64,
    /// Relative residual of the balance of every point; 0 where no path leads through.
    pub residual: f64,
    /// Steps of the iteration; 0 for a direct solution.
    pub iterations: usize,
    /// Flow through each point along x and y over the mean flow; empty where no path leads through.
    pub flux: Vec<[f64; 2]>,
}

impl Flow {
    /// Returns true if a path leads through.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.flow_factor > 0.0
    }
}

/// Reason why a flow was not solved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FlowError {
    /// The balance of the points could not be factorised.
    #[error(
        "flow through the gap: the balance of its points is singular; smooth the field, or raise gaps below 1e-6 of the mean gap to 0"
    )]
    Singular,
    /// The work was cancelled.
    #[error("flow through the gap: ended before it was solved")]
    Cancelled,
}

/// Solves the flow through a gap along one direction, in [`PROGRESS_STEPS`] steps.
///
/// # Errors
/// [`FlowError`] if the equations have no solution in double precision, and if `progress` cancels.
pub fn solve(
    gap: &GapField<'_>,
    direction: Direction,
    ends: Ends,
    progress: &dyn Progress,
) -> Result<Flow, FlowError> {
    let network = Network::new(gap, direction, ends);
    if progress.is_cancelled() {
        return Err(FlowError::Cancelled);
    }
    if network.is_closed() {
        progress.advance(PROGRESS_STEPS);
        return Ok(Flow { flow_factor: 0.0, residual: 0.0, iterations: 0, flux: Vec::new() });
    }
    let pressures = cholesky::pressures(&network)?;
    progress.advance(PROGRESS_STEPS);
    Ok(network.flow(&pressures))
}
