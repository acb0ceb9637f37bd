//! Stress between its two walls at one variance, as the beginning of an integral equation along the variance.

use std::f64::consts::PI;
use std::sync::LazyLock;

use numerics::GaussLegendre;

use crate::stress_modes::{StressEquations, StressModes};

/// Distance over the spread beyond which the normal density is negligible.
const FAR: f64 = 8.7;
/// Pieces of an interval over which [`RULE`] integrates.
const PIECES: u32 = 2;
/// Nodes of the rule over a piece.
const NODES: usize = 16;

static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(NODES));

/// Slope -dC/dsigma of the mean excess between the walls, at one variance.
#[derive(Debug, Clone)]
pub(crate) struct StressProfile {
    equations: &'static StressEquations,
    modes: StressModes,
    pressure_pa: f64,
    hardness_pa: f64,
    variance_pa2: f64,
}

impl StressProfile {
    /// Creates the profile of modes under a nominal pressure \[Pa\], at a hardness \[Pa\] and a variance \[Pa^2\].
    pub(crate) fn new(
        equations: &'static StressEquations,
        modes: StressModes,
        pressure_pa: f64,
        hardness_pa: f64,
        variance_pa2: f64,
    ) -> Self {
        StressProfile { equations, modes, pressure_pa, hardness_pa, variance_pa2 }
    }

    /// Variance \[Pa^2\] of the profile.
    pub(crate) fn variance_pa2(&self) -> f64 {
        self.variance_pa2
    }

    /// Returns the share in contact at a later variance \[Pa^2\], without flow in between.
    pub(crate) fn contact(&self, variance_pa2: f64) -> f64 {
        2.0 * self.passed(0.0, variance_pa2 - self.variance_pa2)
    }

    /// Returns the plastic share at a later variance \[Pa^2\] and hardness \[Pa\], without flow in between: the slopes beyond the
    /// hardness, of which there are none, and beyond a mirrored one.
    pub(crate) fn plastic(&self, hardness_pa: f64, variance_pa2: f64) -> f64 {
        let added_pa2 = variance_pa2 - self.variance_pa2;
        2.0 * (self.passed(hardness_pa, added_pa2) + self.passed(-hardness_pa, added_pa2))
    }

    /// Integrates the slope times the normal density about a stress, of a variance that has been added.
    fn passed(&self, stress_pa: f64, added_pa2: f64) -> f64 {
        let spread_pa = added_pa2.sqrt();
        // Distances from the stress of what lies between the walls, in the spread.
        let [first, last] = [0.0, self.hardness_pa].map(|wall_pa| (wall_pa - stress_pa) / spread_pa);
        let (first, last) = (first.max(-FAR), last.min(FAR));
        if first >= last {
            return 0.0;
        }
        let scale = self.pressure_pa / self.hardness_pa / (2.0 * PI).sqrt();
        let width = (last - first) / f64::from(PIECES);
        let over = |piece: u32| {
            let middle = first + width * (0.5 + f64::from(piece));
            let distances: [f64; NODES] = std::array::from_fn(|at| middle + 0.5 * width * RULE.nodes()[at]);
            let shares = distances.map(|t| (stress_pa + t * spread_pa) / self.hardness_pa);
            let falls = self.equations.falls(&self.modes, shares).into_iter().zip(RULE.weights());
            let density = |(t, (fall, weight)): (&f64, (f64, &f64))| weight * fall * (-0.5 * t * t).exp();
            0.5 * width * distances.iter().zip(falls).map(density).sum::<f64>()
        };
        scale * (0..PIECES).map(over).sum::<f64>()
    }
}
