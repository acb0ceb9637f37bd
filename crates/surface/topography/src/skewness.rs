//! Skewness of the heights of a trace.

use scans::{NonuniformLineScan, Scan};

use crate::detrend::Detrend;
use crate::piecewise::fitted_slope;
use crate::rows::{Lines, Rows};

/// Skewness from which on heights are clearly not Gaussian.
const LARGE_SKEWNESS: f64 = 1.0;
/// Standard errors that a skewness must exceed.
const ERRORS: f64 = 3.0;

/// Computes the skewness Rsk of the heights of a trace over their mean line (ISO 21920-2); `None` for maps, and where it is below 1 or
/// three standard errors.
///
/// The standard error is that of N independent Gaussian heights, sqrt(6/N), where N counts the crossings of the mean line: heights on one
/// side of it belong together.
#[must_use]
pub fn clear_skewness(scan: &Scan, detrend: Detrend) -> Option<f64> {
    let (heights_m, weights_m) = match (scan, Lines::from_scan(scan)) {
        (Scan::UniformLine(_), Lines::Even(rows)) => (flat_m(&rows, detrend), vec![1.0; rows.points]),
        (_, Lines::Uneven(line)) => flat_and_weights_m(line, detrend),
        _ => return None,
    };
    let length_m: f64 = weights_m.iter().sum();
    let mean = |of: &dyn Fn(f64) -> f64| {
        heights_m.iter().zip(&weights_m).map(|(height_m, weight_m)| of(*height_m) * weight_m).sum::<f64>()
            / length_m
    };
    let middle_m = mean(&|height_m| height_m);
    let rms_m = mean(&|height_m| (height_m - middle_m).powi(2)).sqrt();
    let skewness = mean(&|height_m| ((height_m - middle_m) / rms_m).powi(3));
    let crossings = heights_m.windows(2).filter(|pair| (pair[0] > middle_m) != (pair[1] > middle_m)).count();
    let error = (6.0 / crossings as f64).sqrt();
    (skewness.abs() > LARGE_SKEWNESS.max(ERRORS * error)).then_some(skewness)
}

fn flat_m(line: &Rows<'_>, detrend: Detrend) -> Vec<f64> {
    let mut rest_m = vec![0.0; line.points];
    line.trend(detrend).subtract(0, line.heights_m, &vec![1.0; line.points], &mut rest_m);
    rest_m
}

/// Returns heights without their trend, and the length of the trace that each stands for.
fn flat_and_weights_m(line: &NonuniformLineScan, detrend: Detrend) -> (Vec<f64>, Vec<f64>) {
    let trend = if detrend == Detrend::Mean { 0.0 } else { fitted_slope(line) };
    let positions_m = line.positions_m();
    let heights_m = line.heights_m();
    let flat_m = positions_m.iter().zip(heights_m).map(|(x_m, height_m)| height_m - trend * x_m).collect();
    let last = positions_m.len() - 1;
    let weight_m = |i: usize| 0.5 * (positions_m[(i + 1).min(last)] - positions_m[i.saturating_sub(1)]);
    (flat_m, (0..=last).map(weight_m).collect())
}
