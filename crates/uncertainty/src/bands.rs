//! Intervals along the cutoff, from a part of the draws.

use crate::areas::Points;
use crate::found::{AreaBand, BandPoint};
use crate::quantiles::interval;

/// Draws that a band is made of, at most: it is drawn, not read off.
pub(crate) const MOST_DRAWS: usize = 64;

/// The band of a curve under a load from what each draw has along the cutoff, at the cutoffs that all of them have.
pub(crate) fn band(curve: usize, load: usize, draws: &[&Points], level: f64) -> Option<AreaBand> {
    let (first, others) = draws.split_first()?;
    let point = |&(wavelength_m, area): &(f64, f64)| {
        let at = |points: &&&Points| {
            let found = points.iter().find(|(other_m, _)| *other_m == wavelength_m)?;
            Some(found.1.ln())
        };
        let of_others: Option<Vec<f64>> = others.iter().map(|points| at(&points)).collect();
        let mut ln_areas = of_others?;
        ln_areas.push(area.ln());
        let found = interval(&ln_areas, level)?;
        let is_told = found.low.value.is_finite() && found.high.value.is_finite();
        is_told.then(|| BandPoint { wavelength_m, low: found.low.value.exp(), high: found.high.value.exp() })
    };
    let points: Vec<BandPoint> = first.iter().filter_map(point).collect();
    (!points.is_empty()).then_some(AreaBand { curve, load, points })
}
