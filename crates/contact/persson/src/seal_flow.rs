//! Flow through a seal under any load, from the flow factors of its effective medium under a few.

use std::sync::OnceLock;

use crate::gap_distribution::GapDistribution;
use crate::sealing::{PercolationThreshold, SealingLaw};

/// Loads at which flow factors are computed, once they are needed: ln(p/(p_tight - p)) from here on, in equal steps.
const LIGHTEST: f64 = -24.0;
const STEP: f64 = 0.5;
const COUNT: usize = 61;

/// Flow factors phi = s/ubar^3 of a seal over p/p_tight, with the conductance s of the effective medium and the mean gap ubar of the
/// theory. Seals of nearly the same spectrum, such as draws of it, share them: gap and tight pressure are their own.
#[derive(Debug)]
pub struct SealFlow {
    law: SealingLaw,
    threshold: PercolationThreshold,
    ln_factors: [OnceLock<f64>; COUNT],
}

impl SealFlow {
    /// Creates the flow of a seal; nothing is computed yet.
    #[must_use]
    pub fn new(law: &SealingLaw) -> Self {
        SealFlow {
            law: law.clone(),
            threshold: law.threshold(),
            ln_factors: [const { OnceLock::new() }; COUNT],
        }
    }

    /// Computes the conductance s \[m^3\] of a seal of this one's shape under a nominal pressure p > 0 \[Pa\]; `None` where it is tight.
    #[must_use]
    pub fn conductance_m3(&self, seal: &SealingLaw, pressure_pa: f64) -> Option<f64> {
        let ratio = pressure_pa / seal.tight_pressure_pa();
        let is_open = ratio < 1.0;
        is_open.then(|| self.flow_factor(ratio) * seal.mean_gap_m(pressure_pa).powi(3))
    }

    /// Interpolates ln(phi) by cubics.
    fn flow_factor(&self, pressure_over_tight: f64) -> f64 {
        let last = (COUNT - 1) as f64;
        let place = ((pressure_over_tight / (1.0 - pressure_over_tight)).ln() - LIGHTEST) / STEP;
        let place = place.clamp(0.0, last);
        let first = (place.floor() - 1.0).clamp(0.0, last - 3.0);
        let at = place - first;
        let node = |node: usize| self.ln_factor(first as usize + node);
        let weight = |node: usize| {
            (0..4)
                .filter(|&other| other != node)
                .fold(1.0, |weight, other| weight * (at - other as f64) / (node as f64 - other as f64))
        };
        (0..4).map(|at| weight(at) * node(at)).sum::<f64>().exp()
    }

    fn ln_factor(&self, node: usize) -> f64 {
        let compute = || {
            let odds = (LIGHTEST + STEP * node as f64).exp();
            let pressure_pa = odds / (1.0 + odds) * self.law.tight_pressure_pa();
            let medium_m3 = GapDistribution::new(&self.law, pressure_pa).effective_cube_m3(self.threshold);
            (medium_m3 / self.law.mean_gap_m(pressure_pa).powi(3)).max(f64::MIN_POSITIVE).ln()
        };
        *self.ln_factors[node].get_or_init(compute)
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
            let found = flow.conductance_m3(&law, pressure_pa).unwrap();
            let direct = GapDistribution::new(&law, pressure_pa).effective_cube_m3(law.threshold());
            assert!((found / direct - 1.0).abs() < 0.02, "{share}: {found:e} {direct:e}");
            assert!(found < before, "{share}");
            before = found;
        }
        for share in [1.0, 2.0] {
            assert_eq!(flow.conductance_m3(&law, share * law.tight_pressure_pa()), None);
        }
        let almost = flow.conductance_m3(&law, (1.0 - 1e-12) * law.tight_pressure_pa()).unwrap();
        assert!(almost > 0.0 && almost < before);
    }

    #[test]
    fn seals_of_one_shape_share_flow_factors_and_scale_with_their_heights() {
        let (law, higher) = (seal(1.0), seal(1.1));
        let flow = SealFlow::new(&law);
        let of = |law: &SealingLaw| flow.conductance_m3(law, 0.2 * law.tight_pressure_pa()).unwrap();
        assert!((of(&higher) / of(&law) / 1.331 - 1.0).abs() < 1e-9);
        // Four nodes were computed, and shared.
        assert_eq!(flow.ln_factors.iter().filter(|node| node.get().is_some()).count(), 4);
    }
}
