//! The contact area against load from boundary elements, as counted and as corrected.

use elements::{Mean, PressedLoad};
use study::figure::{Axis, FigureData, Series, Shows};

const PRESSURE: Axis = Axis { column: "nominal_pressure_pa", label: "nominal pressure (Pa)" };
const AREA: &str = "contact area / nominal area";

/// The areas of [`elements::means_table`] against load; those at zero have no place on logarithmic axes.
#[must_use]
pub fn area_against_load(loads: &[PressedLoad]) -> FigureData {
    let mut means: Vec<(f64, Mean)> =
        loads.iter().map(|load| (load.nominal_pressure_pa, load.mean())).collect();
    means.sort_by(|a, b| a.0.total_cmp(&b.0));
    let line = |index: usize, name: &str, of: fn(&Mean) -> Option<f64>| {
        let points = means.iter().filter_map(|(pressure_pa, mean)| Some((*pressure_pa, of(mean)?)));
        Series::under(name, index, points.collect())
    };
    let lines = [
        line(0, "points in contact", |mean| Some(mean.area_fraction)),
        line(1, "corrected", |mean| Some(mean.area_fraction_corrected)),
        line(2, "extrapolated", |mean| mean.area_fraction_extrapolated),
        line(3, "plastic", |mean| Some(mean.plastic_area_fraction_corrected)),
    ];
    let is_seen = |series: &Series| series.points.iter().any(|(_, area)| *area > 0.0);
    let series = lines.into_iter().filter(is_seen).collect();
    FigureData::new("area-against-load", Shows::AreaAgainstLoad, PRESSURE, AREA, series)
}
