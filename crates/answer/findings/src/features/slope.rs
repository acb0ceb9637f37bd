//! The slope of a curve in its logarithms.

use numerics::line_through;

use super::Point;

/// The points of a curve between two wavelengths \[m\], both included.
pub fn between(curve: &[Point], longest_m: f64, shortest_m: f64) -> &[Point] {
    let begin = curve.partition_point(|(wavelength_m, _)| *wavelength_m > longest_m);
    let end = curve.partition_point(|(wavelength_m, _)| *wavelength_m >= shortest_m);
    &curve[begin.min(end)..end]
}

/// d ln y/d ln x of points with positive coordinates, by least squares; `None` of fewer than two abscissas.
pub fn log_slope(points: &[Point]) -> Option<f64> {
    Some(line_through(points.iter().map(|(x, y)| (x.ln(), y.ln())))?.slope)
}

/// d ln y/d ln x between neighbouring points, each at the geometric mean of their wavelengths.
pub fn log_slopes(curve: &[Point]) -> Vec<Point> {
    let slope = |pair: &[Point]| {
        let [(long, above), (short, below)] = [pair[0], pair[1]];
        ((long * short).sqrt(), (below / above).ln() / (short / long).ln())
    };
    curve.windows(2).map(slope).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_has_one_slope_everywhere() {
        let curve: Vec<Point> = (0..9).map(|i| 10f64.powi(-i)).map(|x| (x, 3.0 * x.powf(0.7))).collect();
        assert!((log_slope(&curve).unwrap() - 0.7).abs() < 1e-14);
        assert!(log_slopes(&curve).iter().all(|(_, slope)| (slope - 0.7).abs() < 1e-12));
        assert!((log_slopes(&curve)[0].0 - 10f64.powf(-0.5)).abs() < 1e-15);
        assert_eq!(log_slope(&curve[..1]), None);
        assert_eq!(log_slope(&[(1.0, 2.0), (1.0, 3.0)]), None);
    }

    #[test]
    fn a_stretch_includes_both_its_ends() {
        let curve = [(1e-3, 1.0), (1e-4, 2.0), (1e-5, 3.0), (1e-6, 4.0)];
        assert_eq!(between(&curve, 1e-4, 1e-5), &curve[1..3]);
        assert_eq!(between(&curve, 1.0, 2e-4), &curve[..1]);
        assert_eq!(between(&curve, 9e-6, 2e-6), &[]);
        assert_eq!(between(&curve, 1e-6, 1e-3), &[]);
    }
}
