//! The averaged pressure under a ball beside that of Hertz.

use elements::IndenterState;
use study::figure::{Axis, BandKind, FigureBand, FigureData, Series, Shows};
use units::display::{counted, three_digits};

const RADIUS: Axis = Axis { column: "distance_m", label: "distance from the axis (m)" };
const PRESSURE: &str = "mean pressure (Pa)";
/// Points of Hertz's line.
const HERTZ_POINTS: usize = 100;

/// Draws the mean pressure over rings around the axis, averaged over all places, and Hertz's pressure of the smooth ball; `None`
/// without a place. A band has the standard deviation between places.
pub(crate) fn averaged_pressure(states: &[IndenterState]) -> Option<FigureData> {
    let first = states.first()?;
    let reach_m = states.iter().map(|state| state.outermost_contact_m).fold(first.hertz_radius_m, f64::max);
    let rings: Vec<(f64, Vec<f64>)> = (0..first.ring_pressures_pa.len())
        .map(|ring| {
            let of_places = states.iter().filter_map(|state| state.ring_pressures_pa[ring]);
            (first.ring_radius_m(ring), of_places.collect::<Vec<f64>>())
        })
        .filter(|(radius_m, pressures_pa)| !pressures_pa.is_empty() && *radius_m < 1.2 * reach_m)
        .collect();
    let means = rings.iter().map(|(radius_m, pressures_pa)| (*radius_m, mean(pressures_pa))).collect();
    let scatter = rings.iter().map(|(radius_m, pressures_pa)| {
        let (mean_pa, deviation_pa) = (mean(pressures_pa), deviation(pressures_pa));
        (*radius_m, [(mean_pa - deviation_pa).max(0.0), mean_pa + deviation_pa])
    });
    let band = FigureBand {
        label: "standard deviation between places".to_owned(),
        kind: BandKind::Interval,
        load: Some(1),
        curve_index: 0,
        points: scatter.collect(),
    };
    let series = vec![Series::under("Hertz", 0, hertz(first)), Series::under("rough flat", 1, means)];
    let figure = FigureData::new("ball-pressure", Shows::Response, RADIUS, PRESSURE, series);
    Some(FigureData {
        title: format!(
            "Averaged pressure at {}, roughness number {}",
            counted(states.len(), "place"),
            three_digits(first.roughness_number)
        ),
        bands: if states.len() > 1 { vec![band] } else { Vec::new() },
        ..figure.with_linear_axes()
    })
}

/// Hertz's pressure p0 sqrt(1 - (r/a)^2), closer towards the edge, where it ends with a steep slope.
fn hertz(state: &IndenterState) -> Vec<(f64, f64)> {
    let point = |step: usize| {
        let (sine, cosine) = (0.5 * std::f64::consts::PI * step as f64 / HERTZ_POINTS as f64).sin_cos();
        (state.hertz_radius_m * sine, state.hertz_pressure_pa * cosine)
    };
    (0..=HERTZ_POINTS).map(point).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The standard deviation; 0 of one value.
fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / (values.len().max(2) - 1) as f64).sqrt()
}
