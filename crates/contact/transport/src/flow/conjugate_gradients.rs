//! Iterative solution of the flow: conjugate gradients, preconditioned by multigrid.

use numerics::parallel::Progress;

use crate::flow::elimination::{Elimination, eliminate};
use crate::flow::graph::Graph;
use crate::flow::multigrid::{Multigrid, dot};
use crate::flow::network::{Network, norm};
use crate::flow::{Correction, FlowError, POWER_TOLERANCE, PROGRESS_STEPS, TOLERANCE};

/// Steps after which the iteration has stalled.
const MOST_STEPS: usize = 300;

/// Conjugate gradients on the points that are left after the elimination of those with few ties.
pub(super) struct Iteration<'p> {
    /// Number of steps so far.
    pub steps: usize,
    eliminations: Vec<Elimination>,
    multigrid: Multigrid,
    /// Scale of residuals.
    driven: f64,
    progress: &'p dyn Progress,
    reported: usize,
}

impl<'p> Iteration<'p> {
    pub(super) fn new(network: &Network, progress: &'p dyn Progress) -> Self {
        let mut eliminations = Vec::new();
        let graph = eliminate(Graph::of_network(network), |elimination| eliminations.push(elimination));
        let multigrid = Multigrid::new(graph);
        Iteration { eliminations, multigrid, driven: network.driven(), steps: 0, progress, reported: 0 }
    }

    /// Solves for a load that takes away from a power.
    pub(super) fn solve(&mut self, load: Vec<f64>, power: f64) -> Result<Correction, FlowError> {
        let mut loads = vec![load];
        for elimination in &self.eliminations {
            let mut reduced = vec![0.0; elimination.kept()];
            elimination.reduce(&loads[loads.len() - 1], &mut reduced);
            loads.push(reduced);
        }
        let load = loads.pop().unwrap_or_default();
        let eliminated = self.eliminations.iter().zip(&loads);
        let mut fall: f64 = eliminated.map(|(elimination, load)| elimination.fall(load)).sum();
        let reduced = self.solve_reduced(load, power)?;
        let mut pressures = reduced.pressures;
        fall += reduced.fall;
        for (elimination, load) in self.eliminations.iter().zip(&loads).rev() {
            let mut extended = vec![0.0; load.len()];
            elimination.extend(load, &pressures, &mut extended);
            pressures = extended;
        }
        Ok(Correction { pressures, fall })
    }

    fn solve_reduced(&mut self, mut left: Vec<f64>, power: f64) -> Result<Correction, FlowError> {
        let count = left.len();
        let [mut pressures, mut improved, mut direction, mut outflow] = [(); 4].map(|()| vec![0.0; count]);
        let (mut last_fall, mut last_length) = (0.0, 0.0);
        // Rounding hides a smaller part of the power at the start; the next round knows it.
        let (mut power_left, least_power) = (power, 1e-10 * power);
        let mut first_fall = None;
        while self.steps < MOST_STEPS {
            if self.progress.is_cancelled() {
                return Err(FlowError::Cancelled);
            }
            let size = norm(&left) / self.driven;
            self.multigrid.solve(&left, &mut improved);
            let fall = dot(&improved, &left);
            let whole = *first_fall.get_or_insert(fall);
            if size <= TOLERANCE && fall <= POWER_TOLERANCE * power_left.max(least_power) {
                return Ok(Correction { pressures, fall: whole });
            }
            let kept =
                if last_fall > 0.0 { -last_length * dot(&improved, &outflow) / last_fall } else { 0.0 };
            direction
                .iter_mut()
                .zip(&improved)
                .for_each(|(direction, improved)| *direction = kept * *direction + improved);
            let Some(graph) = self.multigrid.graph() else { break };
            graph.apply(&direction, &mut outflow);
            let (energy, slope) = (dot(&direction, &outflow), dot(&direction, &left));
            if !(energy > 0.0 && slope > 0.0) {
                break;
            }
            let length = slope / energy;
            pressures
                .iter_mut()
                .zip(&direction)
                .for_each(|(pressure, direction)| *pressure += length * direction);
            left.iter_mut().zip(&outflow).for_each(|(left, outflow)| *left -= length * outflow);
            power_left -= length * slope;
            (last_fall, last_length) = (fall, length);
            self.steps += 1;
            self.report(size);
        }
        Err(FlowError::Stalled)
    }

    /// Reports the steps that are left.
    pub(super) fn report_end(&mut self) {
        self.progress.advance(PROGRESS_STEPS - std::mem::replace(&mut self.reported, PROGRESS_STEPS));
    }

    /// Reports how far a residual has fallen on the way to the tolerance.
    fn report(&mut self, size: f64) {
        let way = size.clamp(TOLERANCE, 1.0).ln() / TOLERANCE.ln();
        let steps = ((way * PROGRESS_STEPS as f64) as usize).clamp(self.reported, PROGRESS_STEPS);
        self.progress.advance(steps - self.reported);
        self.reported = steps;
    }
}
