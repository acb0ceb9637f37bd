//! The reliable band of wavelengths of a scan.

use serde::Serialize;

use crate::error::TransformError;
use crate::rows::Lines;
use crate::tip::tip_cutoff_m;
use scans::Scan;

/// Limits of the reliable band that the user gives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BandLimits {
    /// Radius of the tip \[m\], if it is known; 0 if none touched the surface.
    pub tip_radius_m: Option<f64>,
    /// Shortest reliable wavelength \[m\].
    pub shortest_m: Option<f64>,
}

/// The wavelengths that a scan resolves, with their limits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ReliableBand {
    /// Twice the (mean) distance of neighbouring points along the scan lines \[m\].
    pub sampling_m: f64,
    /// Shortest wavelength \[m\] that a given tip radius allows, see [`tip_cutoff_m`]; `None` without a radius, or if
    /// the scan curves nowhere too sharply for it.
    pub tip_m: Option<f64>,
    /// Shortest wavelength that the user gave \[m\].
    pub user_m: Option<f64>,
    /// Largest of these limits \[m\].
    pub shortest_m: f64,
}

impl ReliableBand {
    /// Computes the band of a scan.
    ///
    /// # Errors
    /// [`TransformError::BadLimit`] for a radius or wavelength that is not finite and above 0.
    pub fn new(scan: &Scan, limits: BandLimits) -> Result<Self, TransformError> {
        refuse_bad("tip radius", limits.tip_radius_m.filter(|radius_m| *radius_m != 0.0))?;
        refuse_bad("shortest wavelength", limits.shortest_m)?;
        let sampling_m = 2.0
            * match Lines::from_scan(scan) {
                Lines::Even(rows) => rows.spacing_m,
                Lines::Uneven(line) => line.mean_spacing_m(),
            };
        let tip_m = limits.tip_radius_m.and_then(|radius_m| tip_cutoff_m(scan, radius_m));
        let shortest_m = [tip_m, limits.shortest_m].into_iter().flatten().fold(sampling_m, f64::max);
        Ok(Self { sampling_m, tip_m, user_m: limits.shortest_m, shortest_m })
    }

    /// Returns true if the band holds a wavelength \[m\]. A part in 10^12 allows for rounding of L/n against 2 dx.
    pub fn contains(&self, wavelength_m: f64) -> bool {
        wavelength_m * (1.0 + 1e-12) >= self.shortest_m
    }
}

fn refuse_bad(what: &'static str, value_m: Option<f64>) -> Result<(), TransformError> {
    match value_m {
        Some(value) if !(value.is_finite() && value > 0.0) => Err(TransformError::BadLimit { what, value }),
        _ => Ok(()),
    }
}
