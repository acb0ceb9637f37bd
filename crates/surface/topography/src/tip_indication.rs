//! What a scan itself tells of a tip that nobody knows.

use scans::Scan;
use serde::Serialize;

use crate::rows::Lines;
use crate::tip::{CURVATURE_FRACTION, peak_curvatures_per_m, trial_steps};

/// Radii in m of a sharp, a common and a blunt tip of an atomic force microscope.
const USUAL_RADII_M: [f64; 3] = [5e-9, 20e-9, 100e-9];
/// The share of points that curve less than the peak that counts as the sharpest: single points that stick out do not.
const USUAL_PEAKS: f64 = 0.999;

/// What the curvature of a scan says of its tip, from up to 256 of its lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TipIndication {
    /// See [`sharpest_peak_radius_m`].
    pub sharpest_peak_radius_m: Option<f64>,
    /// How much of the scan could be trusted with tips of 5, 20 and 100 nm.
    pub trusted: Vec<TrustedDownTo>,
}

/// How much of a scan could be trusted if its tip had this radius.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TrustedDownTo {
    /// Radius in m of the tip.
    pub radius_m: f64,
    /// The wavelength in m below which the tip would show, to 20 %; `None` where all of the scan could be trusted.
    pub shortest_m: Option<f64>,
}

/// The radius in m of the sharpest peak of a scan, from second differences of neighbouring points along its lines; `None`
/// where it has no peak. One point in a thousand is left out as a possible outlier.
///
/// A tip draws no peak sharper than itself: its radius is at most this, if the scan is clean. Noise bends the scan more than
/// the surface does and makes this smaller than the tip may be, so that it is no bound where the scan is noisy at the
/// distance of its points. How blunt the tip is at least does not follow from the peaks: a smooth surface has none.
#[must_use]
pub fn sharpest_peak_radius_m(scan: &Scan) -> Option<f64> {
    let mut curvatures_per_m = peak_curvatures_per_m(&Lines::of(scan));
    if curvatures_per_m.is_empty() {
        return None;
    }
    let last = curvatures_per_m.len() - 1;
    // Of fewer than a thousand points the sharpest one counts.
    let usual = (USUAL_PEAKS * (last + 1) as f64) as usize;
    let (_, &mut curvature_per_m, _) =
        curvatures_per_m.select_nth_unstable_by(usual.min(last), f64::total_cmp);
    Some(1.0 / curvature_per_m).filter(|radius_m| radius_m.is_finite() && *radius_m > 0.0)
}

impl TipIndication {
    pub(crate) fn of(scan: &Scan) -> Self {
        let steps = trial_steps(&Lines::of(scan));
        let trusted = USUAL_RADII_M.map(|radius_m| {
            let fails = |(_, sharpest_per_m): &(f64, f64)| *sharpest_per_m < -CURVATURE_FRACTION / radius_m;
            let first_failing = steps.iter().position(fails);
            let shortest_m = first_failing.map(|at| match at {
                0 => 4.0 * steps[0].0, // the length of the scan
                _ => 2.0 * steps[at - 1].0,
            });
            TrustedDownTo { radius_m, shortest_m }
        });
        Self { sharpest_peak_radius_m: sharpest_peak_radius_m(scan), trusted: trusted.to_vec() }
    }
}
