//! Scans that are hardly what they seem: too steep or too long for a rough surface, as wrong units make them.

use scans::{MeasuredScan, Statistics};
use units::{Remark, RemarkCode};

use crate::spike::Spike;

/// The root mean square slope of no surface that an instrument follows.
const STEEP: f64 = 10.0;
/// Length \[m\] of a scan that few instruments make.
const LONG_M: f64 = 1.0;

/// Returns the remark on a slope or a length that a unit or a size may have made.
pub(crate) fn implausible(rms_slope: f64, length_m: f64) -> Option<Remark> {
    if rms_slope > STEEP {
        return Some(Remark::new(RemarkCode::ScanSteep).with("slope", rms_slope));
    }
    (length_m > LONG_M).then(|| Remark::new(RemarkCode::ScanLong).with("length_m", length_m))
}

/// Returns the remark on what makes a scan doubtful before any spectrum is made of it: its slope, its length, or a point
/// far off all others.
#[must_use]
pub fn doubt_of_scan(scan: &MeasuredScan, found: &Statistics) -> Option<Remark> {
    let slopes = [found.rms_slope_x, found.rms_slope_y].into_iter().flatten();
    implausible(slopes.fold(0.0, f64::max), scan.size_m().0)
        .or_else(|| Spike::in_measured(scan).map(Spike::remark))
}

#[cfg(test)]
mod tests {
    use super::*;
    use scans::{Scan, UniformLineScan};

    #[test]
    fn units_that_are_off_are_told_by_slope_and_length() {
        let code = |spacing_m: f64, heights_m: Vec<f64>| {
            let scan = Scan::UniformLine(UniformLineScan::new(spacing_m, heights_m).unwrap()).into();
            doubt_of_scan(&scan, &Statistics::from_scan(&scan).unwrap()).map(|remark| remark.code)
        };
        let rough = |scale: f64| (0..100).map(|at| scale * f64::from(at * 37 % 11)).collect::<Vec<f64>>();
        assert_eq!(code(1e-6, rough(1e-7)), None);
        assert_eq!(code(1e-9, rough(1e-7)), Some(RemarkCode::ScanSteep));
        assert_eq!(code(0.1, rough(1e-7)), Some(RemarkCode::ScanLong));
        let mut spiked = rough(1e-10);
        spiked[50] = 1e-6;
        assert_eq!(code(1e-6, spiked), Some(RemarkCode::Spike));
    }
}
