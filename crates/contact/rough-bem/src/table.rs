//! Results as tables.

use tables::Table;

use crate::mean::{Mean, PressedLoad, share};
use crate::state::PressedState;

/// Table with a row per load, the mean of all surfaces: `nominal_pressure_pa, area_fraction, area_fraction_corrected,
/// area_fraction_extrapolated, standard_error, plastic_area_fraction, mean_gap_m, mean_plastic_depth_m,
/// largest_pressure_pa, stiffness_pa_per_m, iterations, residual, plastic_area_fraction_corrected, open_along_x,
/// open_along_y`.
#[must_use]
pub fn means_table(loads: &[PressedLoad]) -> Table {
    let means: Vec<Mean> = loads.iter().map(PressedLoad::mean).collect();
    let column = |of: fn(&Mean) -> Option<f64>| means.iter().map(of).collect::<Vec<_>>();
    Table::default()
        .with_numbers("nominal_pressure_pa", loads.iter().map(|load| load.nominal_pressure_pa))
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

/// Table with a row per surface and load, in blocks of loads: the columns of [`means_table`] with `realisation`, from
/// 1 on, as the second; a single surface has no standard error, and its `open` columns are 1 or 0.
#[must_use]
pub fn states_table(loads: &[PressedLoad]) -> Table {
    let rows: Vec<(&PressedLoad, usize, &PressedState)> = loads
        .iter()
        .flat_map(|load| load.states.iter().enumerate().map(move |(at, state)| (load, at + 1, state)))
        .collect();
    let column = |of: fn(&PressedState) -> Option<f64>| rows.iter().map(|row| of(row.2)).collect::<Vec<_>>();
    let extrapolated = rows.iter().map(|(load, _, state)| load.extrapolated_area_fraction(state));
    Table::default()
        .with_numbers("nominal_pressure_pa", rows.iter().map(|row| row.0.nominal_pressure_pa))
        .with_numbers("realisation", rows.iter().map(|row| row.1 as f64))
        .with_numbers("area_fraction", column(|state| Some(state.area_fraction)))
        .with_numbers("area_fraction_corrected", column(|state| Some(state.area_fraction_corrected)))
        .with_numbers("area_fraction_extrapolated", extrapolated)
        .with_numbers("standard_error", column(|_| None))
        .with_numbers("plastic_area_fraction", column(|state| Some(state.plastic_area_fraction)))
        .with_numbers("mean_gap_m", column(|state| Some(state.mean_gap_m)))
        .with_numbers("mean_plastic_depth_m", column(|state| Some(state.mean_plastic_depth_m)))
        .with_numbers("largest_pressure_pa", column(|state| Some(state.largest_pressure_pa)))
        .with_numbers("stiffness_pa_per_m", column(|state| state.stiffness_pa_per_m))
        .with_numbers("iterations", column(|state| Some(state.iterations as f64)))
        .with_numbers("residual", column(|state| Some(state.residual)))
        .with_numbers(
            "plastic_area_fraction_corrected",
            column(|state| Some(state.plastic_area_fraction_corrected)),
        )
        .with_numbers("open_along_x", column(|state| Some(share(state.open.along_x))))
        .with_numbers("open_along_y", column(|state| Some(share(state.open.along_y))))
}
