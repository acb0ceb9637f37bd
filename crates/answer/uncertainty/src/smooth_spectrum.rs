//! A smooth spectrum through the bins of a composite, which goes on beyond them.

use std::f64::consts::LN_10;

use topography::CompositeBin;

/// Distance over which bins are joined by a straight line in ln C over ln q \[decades\].
const HALF_WIDTH_DECADES: f64 = 0.6;

/// Slopes of ln C over ln q with which a spectrum goes on: it neither falls towards longer waves nor has more of them than a
/// surface of a Hurst exponent of 1.
const SLOPES: [f64; 2] = [-3.0, 0.0];

/// Ratio of wavelengths over which a spectrum goes on beyond its longest, after which it is level. The excess of a scan then
/// lies midway between those of a surface that levels off at once and of one that never does.
const LEVEL_BEYOND: f64 = 2.0;

/// A smooth spectrum, as points of ln q and ln C in ascending order.
pub(crate) struct SmoothSpectrum {
    points: Vec<[f64; 2]>,
    /// Slope beyond the longest wavelength.
    slope: f64,
}

impl SmoothSpectrum {
    /// Fits straight lines to neighbouring bins of a composite, weighted by their degrees of freedom and their distance.
    pub fn through(bins: &[CompositeBin]) -> Self {
        let samples: Vec<[f64; 3]> = bins
            .iter()
            .map(|bin| {
                let freedom = bin.degrees_of_freedom.unwrap_or(2.0 * bin.measurements as f64);
                [-bin.wavelength_m.ln(), bin.c1d_m3.ln(), freedom]
            })
            .collect();
        let fits: Vec<[f64; 2]> = samples.iter().map(|[ln_q, ..]| fit_about(*ln_q, &samples)).collect();
        let slope = fits.first().map_or(0.0, |[_, slope]| slope.clamp(SLOPES[0], SLOPES[1]));
        let points = samples.iter().zip(&fits).map(|([ln_q, ..], [ln_c, _])| [*ln_q, *ln_c]).collect();
        SmoothSpectrum { points, slope }
    }

    /// Computes C1D in m^3 at a wavelength in m. Beyond the shortest it keeps the last value.
    pub fn c1d_m3(&self, wavelength_m: f64) -> f64 {
        let ln_q = -wavelength_m.ln();
        let next = self.points.partition_point(|[other, _]| *other < ln_q);
        let ln_c = match (next.checked_sub(1).and_then(|at| self.points.get(at)), self.points.get(next)) {
            (Some([q0, c0]), Some([q1, c1])) => c0 + (c1 - c0) * (ln_q - q0) / (q1 - q0),
            (None, Some([q1, c1])) => c1 + self.slope * (ln_q - q1).max(-LEVEL_BEYOND.ln()),
            (last, None) => last.map_or(0.0, |[_, c0]| *c0),
        };
        ln_c.exp()
    }
}

/// Value and slope at a place of the straight line through the samples about it.
fn fit_about(ln_q: f64, samples: &[[f64; 3]]) -> [f64; 2] {
    let (mut sums, mut products) = ([0.0; 3], [0.0; 2]);
    for [other, ln_c, freedom] in samples {
        let off = other - ln_q;
        let distance = (off / (HALF_WIDTH_DECADES * LN_10)).abs().min(1.0);
        let weight = freedom * (1.0 - distance.powi(3)).powi(3);
        for (power, sum) in sums.iter_mut().enumerate() {
            *sum += weight * off.powi(power as i32);
        }
        products[0] += weight * ln_c;
        products[1] += weight * off * ln_c;
    }
    let spread = sums[0] * sums[2] - sums[1] * sums[1];
    // Without a neighbour there is no slope.
    if spread <= 1e-9 * sums[0] * sums[0] {
        return [products[0] / sums[0], 0.0];
    }
    [
        (sums[2] * products[0] - sums[1] * products[1]) / spread,
        (sums[0] * products[1] - sums[1] * products[0]) / spread,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bins of C1D of a wavelength in m, from 100 um down.
    fn bins(c1d_m3: impl Fn(f64) -> f64) -> Vec<CompositeBin> {
        let bin = |at: i32| {
            let wavelength_m = 1e-4 * 10f64.powf(-0.1 * f64::from(at));
            CompositeBin {
                centre_m: wavelength_m,
                wavelength_m,
                c1d_m3: c1d_m3(wavelength_m),
                kept: 1.0,
                measurements: 3,
                standard_error_m3: None,
                degrees_of_freedom: Some(6.0 + f64::from(at)),
            }
        };
        (0..20).map(bin).collect()
    }

    #[test]
    fn a_power_law_goes_on_for_an_octave_and_then_is_level() {
        let law = |wavelength_m: f64| 1e-20 * (wavelength_m / 1e-4).powf(2.2);
        let smooth = SmoothSpectrum::through(&bins(law));
        for wavelength_m in [1.9e-4, 1e-4, 3.3e-5, 2e-6] {
            assert!((smooth.c1d_m3(wavelength_m) / law(wavelength_m) - 1.0).abs() < 1e-9, "{wavelength_m}");
        }
        assert!((smooth.c1d_m3(1e-2) / law(2e-4) - 1.0).abs() < 1e-9);
        // A spectrum that falls towards long waves is level beyond them.
        let falling = SmoothSpectrum::through(&bins(|wavelength_m| 1e-24 / wavelength_m));
        assert!((falling.c1d_m3(1e-3) / 1e-20 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_single_bin_is_level() {
        let smooth = SmoothSpectrum::through(&bins(|_| 1e-20)[..1]);
        assert!(
            (smooth.c1d_m3(1e-3) / 1e-20 - 1.0).abs() < 1e-9
                && (smooth.c1d_m3(1e-6) / 1e-20 - 1.0).abs() < 1e-9
        );
    }
}
