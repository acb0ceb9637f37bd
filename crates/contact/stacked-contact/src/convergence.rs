//! Convergence of the area: the wavelength below which it no longer changes.

/// Ratio of wavelengths, half a decade, that must lie below the convergence wavelength for it to count.
pub const LEAST_WAVELENGTH_RATIO_BELOW: f64 = 3.162_277_660_168_379_5;

/// End of a curve of area over cutoff.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Convergence {
    /// The longest wavelength \[m\] from which every shorter cutoff stays within the tolerance of the final area.
    pub wavelength_m: f64,
    /// True if at least half a decade of spectrum lies below; otherwise the curve may simply have ended.
    pub converged: bool,
}

impl Convergence {
    /// Returns the wavelength \[m\] if the curve has converged.
    #[must_use]
    pub fn if_converged_m(&self) -> Option<f64> {
        self.converged.then_some(self.wavelength_m)
    }
}

/// Finds the point from which a curve of (wavelength \[m\], area) points, from long to short cutoffs, stays within
/// `tolerance` (relative, above 0, e.g. 0.01) of its final area. `None` without points. A choice of this project: the
/// definition in `docs/theory/models.md`, section 4.
#[must_use]
pub fn convergence(curve: &[(f64, f64)], tolerance: f64) -> Option<Convergence> {
    let &(shortest_m, final_area) = curve.last()?;
    let settled = |(_, area): &&(f64, f64)| (area / final_area - 1.0).abs() <= tolerance;
    let &(wavelength_m, _) = curve.iter().rev().take_while(settled).last()?;
    Some(Convergence { wavelength_m, converged: wavelength_m / shortest_m >= LEAST_WAVELENGTH_RATIO_BELOW })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_that_passes_through_its_final_value_early_has_not_converged_there() {
        let curve = [(1e-3, 0.5), (1e-4, 0.1001), (1e-5, 0.2), (1e-6, 0.1005), (1e-7, 0.1)];
        let found = convergence(&curve, 0.01).unwrap();
        assert_eq!(found, Convergence { wavelength_m: 1e-6, converged: true });
        assert_eq!(convergence(&curve, 0.001).unwrap().wavelength_m, 1e-7);
    }

    #[test]
    fn a_curve_that_falls_to_its_end_is_not_converged() {
        let falling = [(1e-3, 0.5), (1e-4, 0.4), (1e-5, 0.3)];
        assert_eq!(convergence(&falling, 0.01), Some(Convergence { wavelength_m: 1e-5, converged: false }));
        let late = [(1e-3, 0.5), (2e-5, 0.3), (1e-5, 0.3)];
        assert_eq!(convergence(&late, 0.01), Some(Convergence { wavelength_m: 2e-5, converged: false }));
        assert_eq!(convergence(&[], 0.01), None);
    }
}
