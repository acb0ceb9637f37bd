//! Dips: local minima of a curve.

use super::Point;

/// A local minimum between two rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dip {
    /// Its wavelength \[m\].
    pub wavelength_m: f64,
    /// The value there.
    pub value: f64,
    /// The lower of the two neighbouring peaks over the value: at least the depth requested.
    pub depth: f64,
}

/// The dips of a curve, from long to short wavelengths, whose neighbouring peaks are both at least `least_depth` > 1 times
/// as high. A peak may be the end of the curve.
pub fn dips(curve: &[Point], least_depth: f64) -> Vec<Dip> {
    let mut dips = Vec::new();
    let Some(&first) = curve.first() else { return dips };
    // One pass with hysteresis: a turn counts once the curve has gone back by the depth asked for.
    let (mut peak, mut lowest) = (first, first);
    // The dip last entered, with the peak before it; it ends where the curve turns down again.
    let mut open: Option<(Point, f64)> = None;
    for &point in curve {
        match open {
            None => {
                if point.1 > peak.1 && lowest.1 * least_depth > peak.1 {
                    (peak, lowest) = (point, point);
                } else if point.1 < lowest.1 {
                    lowest = point;
                } else if peak.1 >= least_depth * lowest.1 && point.1 >= least_depth * lowest.1 {
                    open = Some((lowest, peak.1));
                    (peak, lowest) = (point, point);
                }
            }
            Some((bottom, before)) => {
                if point.1 > peak.1 {
                    (peak, lowest) = (point, point);
                } else if point.1 < lowest.1 {
                    lowest = point;
                    if peak.1 >= least_depth * lowest.1 {
                        dips.push(dip(bottom, before, peak.1));
                        open = None;
                    }
                }
            }
        }
    }
    dips.extend(open.map(|(bottom, before)| dip(bottom, before, peak.1)));
    dips
}

fn dip((wavelength_m, value): Point, peak_before: f64, peak_after: f64) -> Dip {
    Dip { wavelength_m, value, depth: peak_before.min(peak_after) / value }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(values: &[f64]) -> Vec<Point> {
        values.iter().enumerate().map(|(i, &value)| (10f64.powi(-(i as i32)), value)).collect()
    }

    #[test]
    fn dips_deep_enough_are_found_with_their_depth() {
        let found = dips(&curve(&[8.0, 2.0, 3.0, 2.9, 1.0, 6.0, 5.0, 7.0]), 1.4);
        let places: Vec<(f64, f64, f64)> = found.iter().map(|d| (d.wavelength_m, d.value, d.depth)).collect();
        // 5.0 lies only 1.2 below its peaks.
        assert_eq!(places, [(0.1, 2.0, 1.5), (1e-4, 1.0, 3.0)]);
    }

    #[test]
    fn the_lower_shoulder_decides() {
        assert_eq!(dips(&curve(&[2.0, 1.0, 10.0]), 1.5)[0].depth, 2.0);
        assert_eq!(dips(&curve(&[10.0, 1.0, 2.0]), 1.5)[0].depth, 2.0);
        assert_eq!(dips(&curve(&[10.0, 1.0, 1.4]), 1.5), []);
        assert_eq!(dips(&curve(&[1.2, 1.0, 9.0]), 1.5), []);
    }

    #[test]
    fn curves_that_go_one_way_have_none() {
        assert_eq!(dips(&curve(&[5.0, 4.0, 3.0, 1.0]), 1.1), []);
        assert_eq!(dips(&curve(&[1.0, 4.0, 9.0]), 1.1), []);
        assert_eq!(dips(&curve(&[2.0; 4]), 1.1), []);
        assert_eq!(dips(&[], 1.1), []);
    }

    #[test]
    fn a_small_ripple_does_not_split_a_dip() {
        let found = dips(&curve(&[10.0, 3.0, 3.1, 2.0, 2.1, 5.0, 4.9, 6.0]), 1.5);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].value, found[0].depth), (2.0, 3.0));
    }
}
