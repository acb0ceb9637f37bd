//! What models get of scans after binning and averaging.

use std::f64::consts::PI;

use spectrum::{Moments, Normalisation, ProfilePsd, cumulative_moments_to};
use units::{Remark, RemarkCode};

use crate::scan_spectrum::ScanSpectrum;

/// Largest relative difference of rms heights and slopes that passes.
const LARGE: f64 = 0.1;

/// Root mean square height and slope of the composite over those of the scans, each in the band of the scan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelsGet {
    /// Ratio of rms heights.
    pub height: f64,
    /// Ratio of rms slopes; those of evenly spaced points are the differences of neighbours.
    pub slope: f64,
    /// Shortest wavelength of the scans \[m\] if waves of two to four points decide their slopes.
    pub decided_at_m: Option<f64>,
}

impl ModelsGet {
    /// Compares the composite, a power law between its samples as models take it, with the Fourier samples of the scans. Of
    /// several scans it compares the mean squares. `None` if no scan has a band.
    #[must_use]
    pub fn new(composite: &ProfilePsd, scans: &[ScanSpectrum]) -> Option<Self> {
        let of_scan = |scan: &ScanSpectrum| {
            let ends_m = [scan.reliable.longest_wavelength_m(), scan.reliable.shortest_wavelength_m()];
            let models = between(composite, ends_m);
            let measured = mean_squares(scan);
            let ratios = [measured[0] / models[0], measured[1] / models[1]];
            ratios.iter().all(|ratio| ratio.is_finite() && *ratio > 0.0).then_some(ratios)
        };
        let ratios: Vec<[f64; 2]> = scans.iter().filter_map(of_scan).collect();
        let mean = |of: usize| ratios.iter().map(|ratio| ratio[of]).sum::<f64>() / ratios.len() as f64;
        let shortest_m = scans.iter().map(|scan| scan.reliable.shortest_wavelength_m());
        let slope = mean(1).sqrt().recip();
        (!ratios.is_empty()).then(|| Self {
            height: mean(0).sqrt().recip(),
            slope,
            decided_at_m: shortest_m.reduce(f64::min).filter(|_| slope > 1.0 + LARGE),
        })
    }

    /// The remark on the comparison, passed or not.
    pub(crate) fn remark(self) -> Remark {
        let is_close = [self.height, self.slope].iter().all(|ratio| (ratio - 1.0).abs() <= LARGE);
        let remark = Remark::new(RemarkCode::ModelsGet).with("height", self.height).with("slope", self.slope);
        let at = self.decided_at_m.into_iter();
        at.fold(remark.passed_if(is_close), |remark, at_m| remark.with("shortest_m", at_m))
    }
}

/// Mean square height \[m^2\] and slope of a spectrum between two wavelengths.
fn between(profile: &ProfilePsd, ends_m: [f64; 2]) -> [f64; 2] {
    let [before, all] = ends_m.map(|end_m| {
        let moments: Option<Moments> = cumulative_moments_to(profile, Normalisation::Parseval, end_m).pop();
        moments.map_or([0.0; 2], |moments| [moments.m0_m2, moments.m2])
    });
    [all[0] - before[0], all[1] - before[1]]
}

/// Mean square height \[m^2\] and slope of the Fourier samples of a scan in its band.
fn mean_squares(scan: &ScanSpectrum) -> [f64; 2] {
    let slope = |q: f64| match scan.spectrum.spacing_m {
        Some(spacing_m) => 2.0 * (0.5 * q * spacing_m).sin() / spacing_m,
        None => q,
    };
    let masses = scan.masses();
    let sum = |of: &dyn Fn(f64) -> f64| masses.iter().map(|(q, mass)| of(*q) * mass).sum::<f64>() / PI;
    [sum(&|_| 1.0), sum(&|q| slope(q).powi(2))]
}
