//! Intervals along the cutoff, from a part of the draws.

use crate::areas::Points;
use crate::quantiles::area_interval_about;
use crate::results::{AreaBand, BandPoint};

/// The most draws for a band, which is only drawn, not read off.
pub(crate) const MAX_DRAWS: usize = 64;

/// The band of a curve under a load, from the draws at the cutoffs that all of them have. It is centred on the best
/// estimates, as the interval of the table is.
pub(crate) fn band(
    curve: usize,
    load: usize,
    draws: &[&Points],
    best: &Points,
    level: f64,
) -> Option<AreaBand> {
    let point = |&(wavelength_m, best): &(f64, f64)| {
        let at = |points: &&Points| {
            let found = points.iter().find(|(other_m, _)| *other_m == wavelength_m)?;
            Some(found.1.ln())
        };
        let ln_areas: Vec<f64> = draws.iter().map(at).collect::<Option<_>>()?;
        let found = area_interval_about(best.ln(), &ln_areas, level)?;
        let is_told = found.low.value.is_finite() && found.high.value.is_finite();
        let [low, median, high] = [found.low, found.median, found.high].map(|quantile| quantile.value.exp());
        is_told.then_some(BandPoint { wavelength_m, area_fraction: best, median, low, high })
    };
    let points: Vec<BandPoint> = best.iter().filter_map(point).collect();
    (!points.is_empty()).then_some(AreaBand { curve, load, points })
}
