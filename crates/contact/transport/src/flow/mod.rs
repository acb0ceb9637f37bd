//! Flow factors of a gap by Reynolds' equation, div(g^3 grad p) = 0 with the local gap g: Patir & Cheng (1978), ASME J. Lubr.
//! Technol. 100:12, on one field.
//!
//! The flow factor phi = <g^3 dp/dx>/(gbar^3 G) compares the flow under a mean pressure gradient G with that through a parallel
//! slot of the mean gap gbar, the mean over all points. Contact is impermeable. Points exchange fluid with their four neighbours,
//! through the harmonic mean of g^3.

mod aggregates;
mod cholesky;
mod conjugate_gradients;
mod elimination;
mod graph;
mod lattice;
mod multigrid;
mod network;

use numerics::parallel::{NestedProgress, Progress};
use serde::Serialize;
use thiserror::Error;

use crate::GapField;
use cholesky::Factors;
use conjugate_gradients::Iteration;
use lattice::Lattice;
use network::{Network, norm};

/// Number of points with flow up to which the direct solution is as fast as the iteration.
const DIRECT: usize = 100_000;
/// Number of points with flow up to which the direct solution has the memory, 1.5 GB, to stand in for an iteration that stalls.
const MOST_DIRECT: usize = 3_000_000;
/// Residual of a solution, relative to the flow under the mean gradient alone.
const TOLERANCE: f64 = 1e-8;
/// Power of what is left over that of the flow, as the solver estimates it: the relative error of the flow factor.
const POWER_TOLERANCE: f64 = 1e-12;
/// Solutions that correct each other.
const MOST_ROUNDS: usize = 8;
/// Number of progress steps of [`solve`].
pub const PROGRESS_STEPS: usize = 100;

/// Direction of the mean pressure gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FlowDirection {
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
pub struct SolvedFlow {
    /// Flow factor phi >= 0; exactly 0 where no path leads through.
    pub flow_factor: f64,
    /// Relative residual of the balance of every point, 1e-8 or what rounding leaves of it at most; 0 where no path leads through.
    pub residual: f64,
    /// Steps of the iteration; 0 for a direct solution.
    pub iterations: usize,
    /// Flow through each point along x and y over the mean flow; empty where no path leads through.
    pub flux: Vec<[f64; 2]>,
}

impl SolvedFlow {
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
    /// Rounding kept the solution from its tolerance.
    #[error(
        "flow through the gap: the balance of its points does not converge; smooth the field, or set gaps below 1e-4 of the mean to 0"
    )]
    Stalled,
    /// The work was cancelled.
    #[error("flow through the gap: ended before it was solved")]
    Cancelled,
}

/// Way to solve the balance of the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Sparse Cholesky factors: exact but for rounding, and fast on small fields.
    Direct,
    /// Conjugate gradients with multigrid, to a residual of 1e-8 and a flow factor within some 1e-12 of itself; memory and time grow
    /// with the number of points.
    Iterative,
}

/// Solves the flow through a gap along one direction, in [`PROGRESS_STEPS`] steps, by the method that suits the size of the field.
///
/// # Errors
/// [`FlowError`] if the equations have no solution in double precision, and if `progress` cancels.
pub fn solve(
    gap: &GapField<'_>,
    direction: FlowDirection,
    ends: Ends,
    progress: &dyn Progress,
) -> Result<SolvedFlow, FlowError> {
    let lattice = Lattice::new(gap.grid(), direction, ends);
    let network = Network::new(gap, &lattice);
    let is_small = network.count() <= DIRECT;
    let first = if is_small { Method::Direct } else { Method::Iterative };
    match network.solve(&lattice, first, progress) {
        Err(FlowError::Stalled) if is_small => network.solve(&lattice, Method::Iterative, progress),
        Err(FlowError::Stalled) if network.count() <= MOST_DIRECT => {
            network.solve(&lattice, Method::Direct, &NestedProgress(progress))
        }
        solved => solved,
    }
}

/// Solves the flow through a gap along one direction by a method, in [`PROGRESS_STEPS`] steps.
///
/// # Errors
/// As [`solve`]; [`FlowError::Stalled`] also where the other method would reach its tolerance.
pub fn solve_by(
    method: Method,
    gap: &GapField<'_>,
    direction: FlowDirection,
    ends: Ends,
    progress: &dyn Progress,
) -> Result<SolvedFlow, FlowError> {
    let lattice = Lattice::new(gap.grid(), direction, ends);
    Network::new(gap, &lattice).solve(&lattice, method, progress)
}

/// Estimates the error of the factor of a flow that comes from the spacing of the points: its distance from the mean of the flows
/// through two fields of every second point, over the mean gap of the whole, plus half their difference. It costs about half a
/// solution.
///
/// Errors are of first order in the spacing, because contact ends between points: as much is left as half the spacing would change.
/// On 14 pressed random surfaces with two to four points to the shortest wave, whose limit is known from four times as many points, it
/// is 0.8 to 1.9 times the error for A up to 0.31, and 1.4 to 11 times from there to 0.37. None for a field less than four points wide
/// or long.
///
/// # Errors
/// As [`solve`].
pub fn spacing_error(
    flow_factor: f64,
    gap: &GapField<'_>,
    direction: FlowDirection,
    ends: Ends,
    progress: &dyn Progress,
) -> Result<Option<f64>, FlowError> {
    let mut factors = [0.0; 2];
    for (offset, factor) in factors.iter_mut().enumerate() {
        let Some(coarse) = gap.every_second(offset) else { return Ok(None) };
        let solved = solve(&coarse, direction, ends, &NestedProgress(progress))?;
        *factor = solved.flow_factor * (coarse.mean_gap_m() / gap.mean_gap_m()).powi(3);
    }
    let [one, other] = factors;
    Ok(Some((flow_factor - 0.5 * (one + other)).abs() + 0.5 * (one - other).abs()))
}

/// Pressures that take up a load, and the power that they take away from the flow.
struct Correction {
    pressures: Vec<f64>,
    fall: f64,
}

impl Network {
    fn solve(
        &self,
        lattice: &Lattice,
        method: Method,
        progress: &dyn Progress,
    ) -> Result<SolvedFlow, FlowError> {
        if progress.is_cancelled() {
            return Err(FlowError::Cancelled);
        }
        if self.count() == 0 {
            progress.advance(PROGRESS_STEPS);
            return Ok(SolvedFlow { flow_factor: 0.0, residual: 0.0, iterations: 0, flux: Vec::new() });
        }
        let (pressures, iterations) = match method {
            Method::Direct => {
                let factors = Factors::new(self)?;
                let pressures = self.balanced(|load, _| Ok(factors.solve(&load)))?;
                progress.advance(PROGRESS_STEPS);
                (pressures, 0)
            }
            Method::Iterative => {
                let mut iteration = Iteration::new(self, progress);
                let pressures = self.balanced(|load, power| iteration.solve(load, power));
                if pressures != Err(FlowError::Cancelled) {
                    iteration.report_end();
                }
                (pressures?, iteration.steps)
            }
        };
        Ok(self.flow(&pressures, lattice, iterations))
    }

    /// Pressures by a solution and its corrections, which mend the rounding of the earlier ones, until the next would change nothing.
    fn balanced(
        &self,
        mut solve: impl FnMut(Vec<f64>, f64) -> Result<Correction, FlowError>,
    ) -> Result<Vec<f64>, FlowError> {
        let mut pressures = vec![0.0; self.count()];
        for round in 0..MOST_ROUNDS {
            let load: Vec<f64> = self.outflow(&pressures).into_iter().map(|flow| -flow).collect();
            let (power, residual) = (self.power(&pressures), norm(&load));
            let least = f64::max(TOLERANCE * self.driven(), self.rounding(&pressures));
            let correction = solve(load, power)?;
            if round > 0 && residual <= least && correction.fall <= POWER_TOLERANCE * power {
                return Ok(pressures);
            }
            let corrected = pressures.iter_mut().zip(correction.pressures);
            corrected.for_each(|(pressure, correction)| *pressure += correction);
        }
        Err(FlowError::Stalled)
    }
}
