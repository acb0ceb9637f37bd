//! Results as the tables that others script against.

use persson::separation::LightLoads;

use crate::gap_law::GapState;
pub use crate::models::STATE_DETAILS;
use crate::plan::{CurveResult, Load, Results};
use tables::Table;

/// Moments and McCool's parameters (Jackson & Jacobs, Eqs. 1, 3, 4), in SI units: a row per wavelength; the first has
/// no interval yet and empty cells.
pub fn moments(results: &Results) -> Table {
    let none_yet = std::iter::once(None);
    let rows = || none_yet.clone().chain(results.moments.iter().map(Some));
    let wavelengths = std::iter::once(results.psd.longest_wavelength_m())
        .chain(results.moments.iter().map(|(moments, _)| moments.wavelength_m));
    let moment =
        |of: fn(&spectrum::Moments) -> f64| rows().map(move |row| row.map(|(moments, _)| of(moments)));
    let parameter = |of: fn(&spectrum::AsperityParameters) -> f64| {
        rows().map(move |row| row.and_then(|(_, parameters)| parameters.as_ref()).map(of))
    };
    Table::default()
        .with_numbers("wavelength_m", wavelengths)
        .with_numbers("m0_m2", moment(|m| m.m0_m2))
        .with_numbers("m2", moment(|m| m.m2))
        .with_numbers("m4_per_m2", moment(|m| m.m4_per_m2))
        .with_numbers("radius_m", parameter(|p| p.radius_m))
        .with_numbers("density_per_m2", parameter(|p| p.density_per_m2))
        .with_numbers("sigma_s_m", parameter(|p| p.sigma_s_m))
        .with_numbers("offset_m", parameter(|p| p.offset_m))
        .with_numbers("nayak_alpha", parameter(|p| p.nayak_alpha))
}

/// Amplitude \[m\] and aspect ratio (Jackson & Jacobs, Eq. 5): a row per wavelength.
pub fn amplitude(results: &Results) -> Table {
    let scales = &results.scales;
    Table::default()
        .with_numbers("wavelength_m", scales.iter().map(|scale| scale.wavelength_m))
        .with_numbers("amplitude_m", scales.iter().map(|scale| scale.amplitude_m))
        .with_numbers("aspect_ratio", scales.iter().map(stacked_contact::Scale::aspect_ratio))
}

/// Makes the table of the self-affine fit, lengths in m: one row, with empty cells for parameters that could not be
/// identified.
pub fn fit(results: &Results) -> Table {
    let fit = results.fit.as_ref();
    let rolloff = fit.and_then(|fit| fit.rolloff);
    Table::default()
        .with_numbers("hurst_exponent", [fit.map(|fit| fit.hurst_exponent)])
        .with_numbers("hurst_exponent_se", [fit.and_then(|fit| fit.hurst_exponent_se)])
        .with_numbers("rolloff_wavelength_m", [rolloff.map(|rolloff| rolloff.wavelength_m)])
        .with_numbers("rolloff_wavelength_se_m", [rolloff.and_then(|rolloff| rolloff.wavelength_se_m)])
        .with_numbers("plateau_m3", [rolloff.map(|rolloff| rolloff.plateau_m3)])
        .with_numbers("plateau_se_m3", [rolloff.and_then(|rolloff| rolloff.plateau_se_m3)])
        .with_numbers("rms_log10_residual", [fit.map(|fit| fit.rms_log10_residual)])
        .with_numbers("points", [fit.map(|fit| fit.points as f64)])
}

/// A curve against cutoff, block after block, a block per load (and per separation); `details` appends how each row was
/// found.
pub fn curve(curve: &CurveResult, loads: &[Load], details: bool) -> Table {
    let pressures_pa: Vec<f64> = loads.iter().map(Load::nominal_pressure_pa).collect();
    curve.table(&pressures_pa, loads.len() > 1, details)
}

/// Makes the table of a surface under loads, with a row per load. The law of light loads is in every row, if the model
/// has one.
pub fn gaps(states: &[GapState], light: Option<&LightLoads>) -> Table {
    let column = |of: fn(&GapState) -> Option<f64>| states.iter().map(of);
    let of_light = |of: fn(&LightLoads) -> f64| states.iter().map(move |_| light.map(of));
    Table::default()
        .with_numbers("nominal_pressure_pa", column(|state| Some(state.nominal_pressure_pa)))
        .with_numbers("area_fraction", column(|state| Some(state.area_fraction)))
        .with_numbers("mean_gap_m", column(|state| state.mean_gap_m))
        .with_numbers("mean_plane_distance_m", column(|state| state.mean_plane_distance_m))
        .with_numbers("stiffness_pa_per_m", column(|state| state.stiffness_pa_per_m))
        .with_numbers("u0_m", of_light(|light| light.decay_length_m))
        .with_numbers("p00_pa", of_light(|light| light.reference_pressure_pa))
}
