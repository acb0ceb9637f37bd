//! Slopes and curvatures from heights, for comparison with those from the spectrum.

use crate::detrend::{Detrend, Trend};
use crate::height_rows::{Columns, HeightRows};
use crate::line::RmsDerivatives;
use crate::piecewise::fitted_slope;
use crate::rows::{Lines, Rows};
use crate::sums::{dot, sum_of};
use scans::{NonuniformLineScan, Scan};

/// Boundary condition of the heights at the ends of a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScanBoundary {
    /// The last point of a line is a neighbour of the first.
    Periodic,
    /// The lines end.
    Open,
}

/// Computes rms slope and curvature from differences of neighbouring heights after detrending; for a map along its
/// rows.
///
/// Evenly spaced points a apart: (h_(i+1) - h_i)/a and (h_(i+1) - 2 h_i + h_(i-1))/a^2. Unevenly spaced points: the
/// slopes of the straight lines between them weighted by their lengths, and the change of slope at each inner point
/// over half the length of its two neighbours, weighted by that length; `boundary` then counts as open.
///
/// On periodic data without a window this equals
/// [`LineSpectrum::rms_derivatives`](crate::LineSpectrum::rms_derivatives) for differences, to rounding. The Hann
/// window favours the middle of the scan, so agreement then depends on how uniform the roughness is; its own slope adds
/// (2 pi/L)^2/3 times the variance to the mean square slope. Without a window, the step between the ends of a scan that
/// is not periodic swamps the spectral values.
pub fn real_space_derivatives(scan: &Scan, detrend: Detrend, boundary: ScanBoundary) -> RmsDerivatives {
    match Lines::from_scan(scan) {
        Lines::Even(rows) => even_derivatives(&rows.slices(), &rows.trend(detrend), rows.spacing_m, boundary),
        Lines::Uneven(line) => uneven_derivatives(line, detrend),
    }
}

/// Computes rms slope and curvature across the rows of a map, as if it had been scanned along y; `None` for a line.
///
/// Drift and steps between rows show here but not along the rows, so the two may differ on an isotropic surface.
/// [`Detrend::Line`] subtracts a straight line from each column.
#[must_use]
pub fn real_space_derivatives_across(
    scan: &Scan,
    detrend: Detrend,
    boundary: ScanBoundary,
) -> Option<RmsDerivatives> {
    match scan {
        Scan::Map(map) => {
            let columns = Columns(map);
            let trend = Trend::from_rows(&columns, detrend);
            Some(even_derivatives(&columns, &trend, map.spacing_y_m(), boundary))
        }
        Scan::Lines(lines) => {
            let rows = Rows::from_lines(lines.across()?);
            Some(even_derivatives(&rows.slices(), &rows.trend(detrend), rows.spacing_m, boundary))
        }
        Scan::UniformLine(_) | Scan::NonuniformLine(_) => None,
    }
}

fn even_derivatives(
    lines: &impl HeightRows,
    trend: &Trend,
    spacing_m: f64,
    boundary: ScanBoundary,
) -> RmsDerivatives {
    let points = lines.points();
    let closing = usize::from(boundary == ScanBoundary::Periodic);
    let (ones, mut rest_m) = (vec![1.0; points], vec![0.0; points]);
    let (mut slopes, mut bends) = (Vec::with_capacity(points), Vec::with_capacity(points));
    let (mut slope_squares, mut curvature_squares) = (0.0, 0.0);
    lines.for_each_row(|row, heights_m| {
        trend.subtract(row, heights_m, &ones, &mut rest_m);
        slopes.clear();
        slopes.extend(rest_m.iter().zip(&rest_m[1..]).map(|(here_m, next_m)| (next_m - here_m) / spacing_m));
        slopes.extend((closing == 1).then(|| (rest_m[0] - rest_m[points - 1]) / spacing_m));
        slope_squares += sum_of(&slopes, |slope| slope * slope);
        let last = slopes[slopes.len() - 1];
        bends.clear();
        bends.extend(slopes.iter().zip(&slopes[1..]).map(|(here, next)| next - here));
        bends.extend((closing == 1).then(|| slopes[0] - last));
        curvature_squares += sum_of(&bends, |bend| (bend / spacing_m).powi(2));
    });
    let rows = lines.count();
    let (slopes, bends) = (rows * (points - 1 + closing), rows * (points - 2 + 2 * closing));
    RmsDerivatives {
        slope: (slope_squares / slopes as f64).sqrt(),
        curvature_per_m: (bends > 0).then(|| (curvature_squares / bends as f64).sqrt()),
    }
}

fn uneven_derivatives(line: &NonuniformLineScan, detrend: Detrend) -> RmsDerivatives {
    let lengths_m: Vec<f64> = line.positions_m().windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rises_m = line.heights_m().windows(2).map(|pair| pair[1] - pair[0]);
    let slopes: Vec<f64> = rises_m.zip(&lengths_m).map(|(rise_m, length_m)| rise_m / length_m).collect();
    let trend = if detrend == Detrend::Mean { 0.0 } else { fitted_slope(line) };
    let weighted =
        |squares: &[f64], weights_m: &[f64]| dot(squares, weights_m) / sum_of(weights_m, |weight_m| weight_m);
    let slope_squares: Vec<f64> = slopes.iter().map(|slope| (slope - trend).powi(2)).collect();
    let spans_m: Vec<f64> = lengths_m.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    let bends = slopes.windows(2).map(|pair| pair[1] - pair[0]);
    let bend_squares: Vec<f64> = bends.zip(&spans_m).map(|(bend, span_m)| (bend / span_m).powi(2)).collect();
    RmsDerivatives {
        slope: weighted(&slope_squares, &lengths_m).sqrt(),
        curvature_per_m: (!spans_m.is_empty()).then(|| weighted(&bend_squares, &spans_m).sqrt()),
    }
}
