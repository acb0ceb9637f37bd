//! The scatter of contact areas between surfaces of one spectrum, pooled over windows.
//!
//! Two surfaces say little about their own scatter: Student's factor for them is 6.5. Windows of a spectrum scatter alike, so
//! that a dozen of them say enough together.

use study::student::widening;

/// Above this area fraction surfaces touch too nearly everywhere to show a scatter.
const NEARLY_ALL: f64 = 0.999;

/// The areas of the surfaces of a window, under one pressure.
pub(crate) struct AreasOnWindow<'a> {
    pub window: usize,
    pub areas: &'a [f64],
}

/// Scatter that all windows share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PooledScatter {
    /// The relative variance of an area fraction A over 1 - A: surfaces that touch nearly everywhere scatter little.
    variance_over_gap: f64,
    /// Degrees of freedom.
    freedom: usize,
}

impl PooledScatter {
    /// Pools the scatter of presses, window by window in order: the pressures on a window share its surfaces, and count as one.
    /// `None` if no window scatters.
    pub fn new<'a>(presses: impl Iterator<Item = AreasOnWindow<'a>>) -> Option<Self> {
        let mut windows: Vec<WindowScatter> = Vec::new();
        for AreasOnWindow { window, areas } in presses {
            let (mean, variance) = mean_and_variance(areas);
            // Where everything in contact flows, the load alone decides, and surfaces do not differ.
            if mean > NEARLY_ALL || variance == 0.0 {
                continue;
            }
            let over_gap = variance / (mean * mean * (1.0 - mean));
            match windows.iter_mut().find(|other| other.window == window) {
                Some(known) => {
                    known.sum += over_gap;
                    known.presses += 1;
                }
                None => {
                    let freedom = areas.len() - 1;
                    windows.push(WindowScatter { window, sum: over_gap, presses: 1, freedom });
                }
            }
        }
        let freedom: usize = windows.iter().map(|window| window.freedom).sum();
        let weighted = |window: &WindowScatter| {
            window.freedom as f64 * window.sum / window.presses as f64 / freedom as f64
        };
        (freedom > 0)
            .then(|| PooledScatter { variance_over_gap: windows.iter().map(weighted).sum(), freedom })
    }

    /// The standard error of the mean of areas: from the pooled scatter, or from their own if that is larger. Twice the error
    /// covers 95 %.
    pub fn error_of_mean(&self, areas: &[f64]) -> f64 {
        let (mean, variance) = mean_and_variance(areas);
        let pooled = self.variance_over_gap * (1.0 - mean).max(0.0) * mean * mean;
        let widened = widening(self.freedom + 1).powi(2) * pooled;
        (widened.max(variance) / areas.len() as f64).sqrt()
    }
}

/// The scatter on a window: the sum over its presses of the variance over the gap.
struct WindowScatter {
    window: usize,
    sum: f64,
    presses: usize,
    freedom: usize,
}

/// The mean of at least one value, and their variance; 0 for one value.
pub(crate) fn mean_and_variance(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    (mean, squares / (count - 1.0).max(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pairs of surfaces on windows, whose areas deviate by a share of the mean to either side.
    fn pairs(deviations: &[f64]) -> Option<PooledScatter> {
        let areas: Vec<[f64; 2]> = deviations.iter().map(|by| [0.2 * (1.0 - by), 0.2 * (1.0 + by)]).collect();
        let presses =
            areas.iter().enumerate().map(|(window, areas)| AreasOnWindow { window, areas: &areas[..] });
        PooledScatter::new(presses)
    }

    #[test]
    fn pairs_share_the_mean_square_of_their_scatter() {
        let pooled = pairs(&[0.01, 0.03, 0.02, 0.02]).unwrap();
        assert_eq!(pooled.freedom, 4);
        // A deviation d to either side is a variance of 2 d^2.
        let variance = 2.0 * (1.0 + 9.0 + 4.0 + 4.0) / 4.0 * 1e-4;
        assert!((pooled.variance_over_gap * 0.8 / variance - 1.0).abs() < 1e-12);
        let error = pooled.error_of_mean(&[0.2, 0.2]);
        assert!((error / (0.2 * widening(5) * (0.5 * variance).sqrt()) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_window_that_scatters_more_keeps_its_own_error() {
        let pooled = pairs(&[0.01; 12]).unwrap();
        let own = pooled.error_of_mean(&[0.15, 0.25]);
        assert!((own - 0.05).abs() < 1e-12);
    }

    #[test]
    fn surfaces_that_touch_everywhere_or_flow_have_no_scatter_to_share() {
        assert_eq!(pairs(&[0.0, 0.0]), None);
        let full = [AreasOnWindow { window: 0, areas: &[1.0, 0.9995] }];
        assert_eq!(PooledScatter::new(full.into_iter()), None);
    }

    #[test]
    fn loads_on_a_window_count_as_one_and_larger_areas_scatter_less() {
        // A deviation d to either side is a relative variance of 2 d^2.
        let areas = |mean: f64, by: f64| [mean * (1.0 - by), mean * (1.0 + by)];
        let (light, heavy, other) = (areas(0.2, 0.03), areas(0.6, 0.01), [0.4 * 0.98, 0.4, 0.4 * 1.02]);
        let presses = [(0, &light[..]), (1, &other[..]), (0, &heavy[..])]
            .map(|(window, areas)| AreasOnWindow { window, areas });
        let pooled = PooledScatter::new(presses.into_iter()).unwrap();
        assert_eq!(pooled.freedom, 3);
        let of_window = 0.5 * (2.0 * 9e-4 / 0.8 + 2.0 * 1e-4 / 0.4);
        let variance_over_gap = (of_window + 2.0 * (4e-4 / 0.6)) / 3.0;
        assert!((pooled.variance_over_gap / variance_over_gap - 1.0).abs() < 1e-9, "{pooled:?}");
        let error = widening(4) * 0.6 * (0.4 * variance_over_gap / 3.0).sqrt();
        assert!((pooled.error_of_mean(&[0.6; 3]) / error - 1.0).abs() < 1e-9);
    }
}
