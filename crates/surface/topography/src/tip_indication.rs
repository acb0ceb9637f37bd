//! Indication of an unknown tip radius by the scan itself.

use scans::Scan;
use units::display::length;
use units::{Remark, RemarkCode};

use crate::rows::Lines;
use crate::tip::{CURVATURE_FRACTION, peak_curvatures_per_m, trial_steps};

/// Radii \[m\] of a sharp, a common and a blunt tip of an atomic force microscope.
const RADII_OF_MICROSCOPES_M: [f64; 3] = [5e-9, 20e-9, 100e-9];
/// Radii \[m\] of the tips of a stylus (ISO 3274).
const RADII_OF_STYLI_M: [f64; 3] = [2e-6, 5e-6, 10e-6];
/// Shortest wavelength \[m\] from which on a scan is rather that of a stylus, whose points lie further apart.
const SHORTEST_OF_STYLI_M: f64 = 1e-7;
/// Quantile of the curvature that counts as the sharpest peak; excludes outliers.
const USUAL_PEAKS: f64 = 0.999;

/// Indication of the tip radius by the curvature of a scan, from up to 256 of its lines.
#[derive(Clone, Debug, PartialEq)]
pub struct TipIndication {
    /// Radius of the sharpest peak \[m\], see [`sharpest_peak_radius_m`].
    pub sharpest_peak_radius_m: Option<f64>,
    /// Reliable wavelengths for [`usual_tip_radii_m`].
    pub trusted: Vec<TrustedDownTo>,
}

/// Reliable wavelengths of a scan for an assumed tip radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrustedDownTo {
    /// Tip radius \[m\].
    pub radius_m: f64,
    /// Wavelength \[m\] below which the tip would show, within 20 %; `None` if the whole scan is reliable.
    pub shortest_m: Option<f64>,
}

/// Radii \[m\] of the tips of instruments that resolve scans down to this wavelength \[m\], from sharp to blunt.
#[must_use]
pub fn usual_tip_radii_m(shortest_m: f64) -> [f64; 3] {
    if shortest_m < SHORTEST_OF_STYLI_M { RADII_OF_MICROSCOPES_M } else { RADII_OF_STYLI_M }
}

/// Computes the radius \[m\] of the sharpest peak of a scan, from second differences of neighbouring points along its
/// lines; `None` without peaks. The sharpest one in a thousand points is left out as a possible outlier.
///
/// A tip traces no peak sharper than itself, so its radius is at most this if the scan is clean. Noise at the distance
/// of the points makes the value too small to be a bound. A lower bound of the radius does not follow from the peaks: a
/// smooth surface has none.
#[must_use]
pub fn sharpest_peak_radius_m(scan: &Scan) -> Option<f64> {
    let mut curvatures_per_m = peak_curvatures_per_m(&Lines::from_scan(scan));
    if curvatures_per_m.is_empty() {
        return None;
    }
    let last = curvatures_per_m.len() - 1;
    // With fewer than a thousand points the sharpest one counts.
    let usual = (USUAL_PEAKS * (last + 1) as f64) as usize;
    let (_, &mut curvature_per_m, _) =
        curvatures_per_m.select_nth_unstable_by(usual.min(last), f64::total_cmp);
    Some(1.0 / curvature_per_m).filter(|radius_m| radius_m.is_finite() && *radius_m > 0.0)
}

impl TipIndication {
    pub(crate) fn remark(&self) -> Remark {
        let trusted = self.trusted.iter().map(|trusted| {
            let of_scan = trusted
                .shortest_m
                .map_or("all of it".to_owned(), |shortest_m| format!("down to about {}", length(shortest_m)));
            format!("{of_scan} with a tip of {}", length(trusted.radius_m))
        });
        let remark =
            Remark::new(RemarkCode::TipIndicated).with("trusted", trusted.collect::<Vec<_>>().join(", "));
        match self.sharpest_peak_radius_m {
            Some(radius_m) => remark.with("sharpest_peak_radius_m", radius_m),
            None => remark,
        }
    }

    /// Returns the wavelength \[m\] below which a usual tip would show: the common one, or else the blunt one; `None` if neither would.
    pub(crate) fn may_show_below_m(&self) -> Option<f64> {
        self.trusted.iter().skip(1).find_map(|trusted| trusted.shortest_m)
    }

    /// Finds the indication of a scan that is used down to a wavelength \[m\].
    #[must_use]
    pub fn from_scan(scan: &Scan, shortest_m: f64) -> Self {
        let steps = trial_steps(&Lines::from_scan(scan));
        let trusted = usual_tip_radii_m(shortest_m).map(|radius_m| {
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

#[cfg(test)]
mod tests {
    use units::SceneKeys;

    use super::*;

    #[test]
    fn an_unknown_tip_is_described() {
        let trusted = |radius_m, shortest_m| TrustedDownTo { radius_m, shortest_m };
        let indicated = TipIndication {
            sharpest_peak_radius_m: Some(12e-9),
            trusted: vec![trusted(5e-9, None), trusted(20e-9, Some(4e-9))],
        };
        assert_eq!(
            indicated.remark().about(["a"]).words(&SceneKeys),
            "a: the sharpest peaks have a radius of 12 nm, which the tip does not exceed unless they are noise; to be trusted: all \
             of it with a tip of 5 nm, down to about 4 nm with a tip of 20 nm"
        );
    }
}
