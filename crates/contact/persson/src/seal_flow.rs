//! Flow through a seal under any load, from the flow factors of its effective medium under a few.

use std::sync::OnceLock;

use crate::gap_distribution::GapDistribution;
use crate::sealing::{PercolationThreshold, SealingLaw};

/// Loads at which flow factors are computed, once they are needed: ln(p/(p_tight - p)) from here on, in equal steps.
const LIGHTEST: f64 = -24.0;
const STEP: f64 = 1.0;
const COUNT: usize = 31;

/// Flow factors phi = s/ubar^3 of a seal over p/p_tight, with the conductance s of the effective medium and the mean gap ubar of the
/// theory. Seals of nearly the same spectrum, such as draws of it, share them: gap and tight pressure are their own.
#[derive(Debug)]
pub struct SealFlow {
    law: SealingLaw,
    threshold: PercolationThreshold,
    nodes: [OnceLock<Node>; COUNT],
}

/// Logarithms of conductances over the cube of the mean gap under one load.
#[derive(Debug, Clone, Copy)]
struct Node {
    ln_medium: f64,
    ln_parallel: f64,
}

/// Conductance of the gaps of a seal, the cube of the parallel slot that lets as much through.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SealConductance {
    /// That of the effective medium \[m^3\].
    pub medium_m3: f64,
    /// The mean cube of the gap \[m^3\]: all gaps side by side along the flow, which is the most that passes.
    pub parallel_m3: f64,
}

impl SealFlow {
    /// Creates the flow of a seal; nothing is computed yet.
    #[must_use]
    pub fn new(law: &SealingLaw) -> Self {
        SealFlow { law: law.clone(), threshold: law.threshold(), nodes: [const { OnceLock::new() }; COUNT] }
    }

    /// Computes the conductance of a seal of this one's shape under p/p_tight > 0, with its mean gap ubar > 0 \[m\]; `None` where it is
    /// tight.
    #[must_use]
    pub fn conductance(&self, pressure_over_tight: f64, mean_gap_m: f64) -> Option<SealConductance> {
        if pressure_over_tight.is_nan() || pressure_over_tight >= 1.0 {
            return None;
        }
        let slot_m3 = mean_gap_m.powi(3);
        let [medium, parallel] = self.flow_factors(pressure_over_tight);
        let parallel_m3 = parallel * slot_m3;
        Some(SealConductance { medium_m3: (medium * slot_m3).min(parallel_m3), parallel_m3 })
    }

    /// Interpolates both factors by cubics in their logarithms.
    fn flow_factors(&self, pressure_over_tight: f64) -> [f64; 2] {
        let last = (COUNT - 1) as f64;
        let place = ((pressure_over_tight / (1.0 - pressure_over_tight)).ln() - LIGHTEST) / STEP;
        let place = place.clamp(0.0, last);
        let first = (place.floor() - 1.0).clamp(0.0, last - 3.0);
        let at = place - first;
        let mut ln_factors = [0.0; 2];
        for node in 0..4 {
            let others = (0..4).filter(|&other| other != node);
            let weight = others.fold(1.0, |weight, other| {
                weight * (at - f64::from(other)) / (f64::from(node) - f64::from(other))
            });
            let Node { ln_medium, ln_parallel } = self.node(first as usize + node as usize);
            ln_factors[0] += weight * ln_medium;
            ln_factors[1] += weight * ln_parallel;
        }
        ln_factors.map(f64::exp)
    }

    fn node(&self, node: usize) -> Node {
        let compute = || {
            let odds = (LIGHTEST + STEP * node as f64).exp();
            let pressure_pa = odds / (1.0 + odds) * self.law.tight_pressure_pa();
            let gaps = GapDistribution::new(&self.law, pressure_pa);
            let slot_m3 = self.law.mean_gap_m(pressure_pa).powi(3);
            let ln_of = |cube_m3: f64| (cube_m3 / slot_m3).max(f64::MIN_POSITIVE).ln();
            Node {
                ln_medium: ln_of(gaps.effective_cube_m3(self.threshold)),
                ln_parallel: ln_of(gaps.mean_power(3)),
            }
        };
        *self.nodes[node].get_or_init(compute)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::EnergyFactor;
    use crate::roughness::{Roughness, RoughnessSample};

    /// Seal of C1D ~ q^-2.6 over two decades, with heights of this factor.
    fn seal(heights: f64) -> SealingLaw {
        let wavevector = |at: i32| 1e4 * 10f64.powf(f64::from(at) / 20.0);
        let sample = |at: i32| RoughnessSample {
            wavelength_m: std::f64::consts::TAU / wavevector(at),
            c1d_m3: heights * heights * 1e-9 * wavevector(at).powf(-2.6),
            moments: [0.0; 3],
            amplitude_m: 0.0,
        };
        let samples: Vec<RoughnessSample> = (0..=40).map(sample).collect();
        let gradient =
            |at: i32| 1e-6 * heights * heights * (wavevector(at).powf(0.4) - wavevector(0).powf(0.4));
        let gradients: Vec<f64> = (0..=40).map(gradient).collect();
        let roughness = Roughness::new(&samples, Some(&gradients));
        SealingLaw::new(&roughness, 1e11, EnergyFactor::ALMQVIST, None, PercolationThreshold::SIMULATED)
    }

    #[test]
    fn the_conductance_is_that_of_the_distribution_between_its_nodes() {
        let law = seal(1.0);
        let flow = SealFlow::new(&law);
        let mut before = f64::INFINITY;
        for share in [1e-7, 3e-4, 0.013, 0.11, 0.37, 0.62, 0.88, 0.97] {
            let pressure_pa = share * law.tight_pressure_pa();
            let found = flow.conductance(share, law.mean_gap_m(pressure_pa)).unwrap();
            let gaps = GapDistribution::new(&law, pressure_pa);
            assert!((found.parallel_m3 / gaps.mean_power(3) - 1.0).abs() < 0.02, "{share}: {found:?}");
            let (found, direct) = (found.medium_m3, gaps.effective_cube_m3(law.threshold()));
            assert!((found / direct - 1.0).abs() < 0.02, "{share}: {found:e} {direct:e}");
            assert!(found < before, "{share}");
            before = found;
        }
        for share in [1.0, 2.0] {
            assert_eq!(flow.conductance(share, 1e-6), None);
        }
        let almost =
            flow.conductance(1.0 - 1e-12, law.mean_gap_m(law.tight_pressure_pa())).unwrap().medium_m3;
        assert!(almost > 0.0 && almost < before);
    }

    #[test]
    fn seals_of_one_shape_share_flow_factors_and_scale_with_their_heights() {
        let (law, higher) = (seal(1.0), seal(1.1));
        let flow = SealFlow::new(&law);
        let of = |law: &SealingLaw| {
            flow.conductance(0.2, law.mean_gap_m(0.2 * law.tight_pressure_pa())).unwrap().medium_m3
        };
        assert!((of(&higher) / of(&law) / 1.331 - 1.0).abs() < 1e-9);
        // Four nodes were computed, and shared.
        assert_eq!(flow.nodes.iter().filter(|node| node.get().is_some()).count(), 4);
    }
}
