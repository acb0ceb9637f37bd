//! Results as tables.

use tables::Table;

use crate::mean::{Mean, PressedLoad};
use crate::state::PressedState;

/// Table with a row per load, the mean of all surfaces: `nominal_pressure_pa, area_fraction, area_fraction_corrected,
/// area_fraction_extrapolated, standard_error, plastic_area_fraction, mean_gap_m, mean_plastic_depth_m,
/// largest_pressure_pa, stiffness_pa_per_m, iterations, residual, plastic_area_fraction_corrected, open_along_x,
/// open_along_y`.
#[must_use]
pub fn means_table(loads: &[PressedLoad]) -> Table {
    let means: Vec<Mean> = loads.iter().map(PressedLoad::mean).collect();
    let table = Table::default();
    with_means(
        table.with_numbers("nominal_pressure_pa", loads.iter().map(|load| load.nominal_pressure_pa)),
        &means,
    )
}

/// Table with a row per surface and load, in blocks of loads: the columns of [`means_table`] with `realisation`, from
/// 1 on, as the second; a single surface has no standard error, and its `open` columns are 1 or 0.
#[must_use]
pub fn states_table(loads: &[PressedLoad]) -> Table {
    let alone = |load: &PressedLoad, state: &PressedState| Mean {
        area_fraction_extrapolated: load.extrapolated_area_fraction(state),
        ..PressedLoad { states: vec![*state], ..*load }.mean()
    };
    let means: Vec<Mean> =
        loads.iter().flat_map(|load| load.states.iter().map(move |state| alone(load, state))).collect();
    let pressures_pa =
        loads.iter().flat_map(|load| load.states.iter().map(|state| state.numbers.nominal_pressure_pa));
    let realisations = loads.iter().flat_map(|load| (1..=load.states.len()).map(|number| number as f64));
    let table = Table::default().with_numbers("nominal_pressure_pa", pressures_pa);
    with_means(table.with_numbers("realisation", realisations), &means)
}

/// Adds the columns that both tables have.
fn with_means(table: Table, means: &[Mean]) -> Table {
    let column = |of: fn(&Mean) -> Option<f64>| means.iter().map(of).collect::<Vec<_>>();
    table
        .with_numbers("area_fraction", column(|mean| Some(mean.area_fraction)))
        .with_numbers("area_fraction_corrected", column(|mean| Some(mean.area_fraction_corrected)))
        .with_numbers("area_fraction_extrapolated", column(|mean| mean.area_fraction_extrapolated))
        .with_numbers("standard_error", column(|mean| mean.standard_error))
        .with_numbers("plastic_area_fraction", column(|mean| Some(mean.plastic_area_fraction)))
        .with_numbers("mean_gap_m", column(|mean| Some(mean.mean_gap_m)))
        .with_numbers("mean_plastic_depth_m", column(|mean| Some(mean.mean_plastic_depth_m)))
        .with_numbers("largest_pressure_pa", column(|mean| Some(mean.largest_pressure_pa)))
        .with_numbers("stiffness_pa_per_m", column(|mean| mean.stiffness_pa_per_m))
        .with_numbers("iterations", column(|mean| Some(mean.iterations as f64)))
        .with_numbers("residual", column(|mean| Some(mean.residual)))
        .with_numbers(
            "plastic_area_fraction_corrected",
            column(|mean| Some(mean.plastic_area_fraction_corrected)),
        )
        .with_numbers("open_along_x", column(|mean| Some(mean.open_along_x)))
        .with_numbers("open_along_y", column(|mean| Some(mean.open_along_y)))
}
