//! The mean gap against load, and the loops of a tangential load, as figures.

use interface::conductance::MOST_PLASTIC_SHARE;
use scene::Scene;
use study::figure::{Axis, FigureData, Mark, Series, ShearLoop, Shows, shear_loops};
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};
use study::plan::Load;
use uncertainty::Uncertainty;
use units::display::typeset;
use units::log_spaced;

const POINTS: u32 = 61;

/// The factor by which the figure extends below the lightest and above the heaviest load.
const BESIDE: f64 = 10.0;

/// The most loops of a figure.
const MOST_LOOPS: usize = 4;
/// Steps of each part of a loop.
const LOOP_STEPS: usize = 40;

const PRESSURE: Axis = Axis { column: "nominal_pressure_pa", label: "nominal pressure (Pa)" };

/// The mean gap of the whole theory and of the law of light loads, with the loads of the scene; `None` if there is no
/// gap.
pub(crate) fn gap_against_load(
    states: &InterfaceStates<'_>,
    scene: &Scene,
    uncertainty: Option<&Uncertainty>,
) -> Option<FigureData> {
    let light = states.light_loads()?;
    let pressures = scene.needs.loads.iter().map(|load| load.nominal_pressure_pa());
    let least_pa = pressures.clone().fold(f64::INFINITY, f64::min) / BESIDE;
    let most_pa = pressures.fold(0.0, f64::max) * BESIDE;
    let along: Vec<f64> = log_spaced(least_pa, most_pa, POINTS).collect();
    // Nearly closed gaps would take up most of a logarithmic axis.
    let least_m = 1e-3 * states.rms_height_m();
    let line = |column: &str, curve_index: usize, gap_m: &dyn Fn(f64) -> Option<f64>| {
        let points: Vec<(f64, f64)> = along
            .iter()
            .filter_map(|&pressure_pa| Some((pressure_pa, gap_m(pressure_pa)?)))
            .filter(|(_, gap_m)| *gap_m > least_m)
            .collect();
        Series { curve: column.to_owned(), curve_index, ..Series::alone(column, points) }
    };
    let whole = line("mean gap", 1, &|pressure_pa| states.mean_gap_under_m(pressure_pa));
    let law = line("law of light loads", 0, &|pressure_pa| {
        // Peaks that flow follow another law.
        let is_elastic = states.plastic_share(0).is_none_or(|share| share <= MOST_PLASTIC_SHARE);
        is_elastic.then(|| light.decay_length_m * (light.reference_pressure_pa / pressure_pa).ln())
    });
    let mark = |load: usize| {
        let slot = Slot { quantity: Quantity::MeanGap, load: Some(load), curve: None };
        let y = states.value(slot).ok().flatten().filter(|gap_m| *gap_m > least_m)?;
        let interval = uncertainty.and_then(|found| found.quantity(slot));
        let [low, high] = interval.map_or([y, y], |interval| [interval.low, interval.high]);
        let x = scene.needs.loads[load].nominal_pressure_pa();
        let label = "loads of the scene".to_owned();
        let (column, low, high) = (label.clone(), low.min(y), high.max(y));
        Some(Mark { label, column, is_ring: false, condition_index: None, x, y, low, high })
    };
    let series = [whole, law].into_iter().filter(|line| !line.points.is_empty()).collect();
    Some(FigureData {
        title: "Mean gap against load".to_owned(),
        marks: (0..scene.needs.loads.len()).filter_map(mark).collect(),
        ..FigureData::new("gap", Shows::Response, PRESSURE, "mean gap (m)", series)
    })
}

/// The loops of the tangential load under the first loads that it does not slide under; `None` if there is none.
pub(crate) fn loops_of_loads(states: &InterfaceStates<'_>, scene: &Scene) -> Option<FigureData> {
    let of_load =
        |(load, pressed): (usize, &Load)| states.shear_loop(load, &typeset(&pressed.label), LOOP_STEPS);
    let loops: Vec<ShearLoop> =
        scene.needs.loads.iter().enumerate().filter_map(of_load).take(MOST_LOOPS).collect();
    shear_loops(&loops)
}
