//! Which scales still matter: the wavelength below which the area no longer changes.

use crate::Level;

/// Half a decade of spectrum has to lie below the convergence wavelength before it means convergence.
pub const LEAST_WAVELENGTH_RATIO_BELOW: f64 = 3.162_277_660_168_379_5;

/// The end of a curve of area against cutoff.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Convergence {
    /// The longest wavelength \[m\] from which every shorter cutoff stays within the tolerance of the final area.
    pub wavelength_m: f64,
    /// Whether at least half a decade of spectrum lies below it; else the curve may simply have ended.
    pub converged: bool,
}

/// Where a curve has come within `tolerance` (relative, e.g. 0.01) of its final area, for good. `None` of no levels.
pub fn convergence(curve: &[Level], tolerance: f64) -> Option<Convergence> {
    let last = curve.last()?;
    let settled = |level: &&Level| (level.area_fraction / last.area_fraction - 1.0).abs() <= tolerance;
    let first = curve.iter().rev().take_while(settled).last()?;
    Some(Convergence {
        wavelength_m: first.wavelength_m,
        converged: first.wavelength_m / last.wavelength_m >= LEAST_WAVELENGTH_RATIO_BELOW,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Regime;

    fn curve(points: &[(f64, f64)]) -> Vec<Level> {
        points
            .iter()
            .map(|&(wavelength_m, area_fraction)| Level {
                wavelength_m,
                amplitude_m: 1e-9,
                pressure_in_pa: 1e6,
                real_pressure_pa: 1e6 / area_fraction,
                area_fraction,
                yield_strength_pa: None,
                aspect_ratio_over_critical: None,
                regime: Regime::Elastic,
            })
            .collect()
    }

    #[test]
    fn a_curve_that_passes_through_its_final_value_early_has_not_converged_there() {
        let curve = curve(&[(1e-3, 0.5), (1e-4, 0.1001), (1e-5, 0.2), (1e-6, 0.1005), (1e-7, 0.1)]);
        let found = convergence(&curve, 0.01).unwrap();
        assert_eq!(found, Convergence { wavelength_m: 1e-6, converged: true });
        assert_eq!(convergence(&curve, 0.001).unwrap().wavelength_m, 1e-7);
    }

    #[test]
    fn a_curve_that_falls_to_its_end_is_not_converged() {
        let falling = curve(&[(1e-3, 0.5), (1e-4, 0.4), (1e-5, 0.3)]);
        assert_eq!(convergence(&falling, 0.01), Some(Convergence { wavelength_m: 1e-5, converged: false }));
        let late = curve(&[(1e-3, 0.5), (2e-5, 0.3), (1e-5, 0.3)]);
        assert_eq!(convergence(&late, 0.01), Some(Convergence { wavelength_m: 2e-5, converged: false }));
        assert_eq!(convergence(&[], 0.01), None);
    }
}
