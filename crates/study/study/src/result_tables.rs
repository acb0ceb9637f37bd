//! Results as the tables that others script against.

use persson::Cut;
use persson::separation::LightLoads;
use spectrum::AsperityParameters;
use stacked_contact::Level;
use stat_contact::ContactState;

use crate::gap_law::GapState;
use crate::plan::{CurveResult, CutoffState, Load, Results};
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

/// The self-affine fit, lengths in m: one row, its cells empty where nothing could be identified.
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
    part_of_curve(curve, &pressures_pa, loads.len() > 1, details)
}

/// Some blocks of a curve, under these nominal pressures \[Pa\]; `several` tells whether the whole curve has more loads than
/// one.
pub fn part_of_curve(curve: &CurveResult, pressures_pa: &[f64], several: bool, details: bool) -> Table {
    match curve {
        CurveResult::Stacked(blocks) => stacked(blocks, pressures_pa, several, details),
        CurveResult::Statistical(blocks) => statistical(blocks, details),
        CurveResult::Persson(blocks) => persson(blocks, pressures_pa, several),
    }
}

/// A statistical curve: the asperities each cutoff leaves, and their contact. The first row has no asperities yet.
fn statistical(blocks: &[Vec<CutoffState>], details: bool) -> Table {
    let rows = || blocks.iter().flatten();
    let parameter =
        |of: fn(&AsperityParameters) -> f64| rows().map(move |row| row.contact.map(|(p, _)| of(&p)));
    let state =
        |of: fn(&ContactState) -> Option<f64>| rows().map(move |row| row.contact.and_then(|(_, s)| of(&s)));
    let table = Table::default()
        .with_numbers("wavelength_m", rows().map(|row| row.wavelength_m))
        .with_numbers("radius_m", parameter(|p| p.radius_m))
        .with_numbers("density_per_m2", parameter(|p| p.density_per_m2))
        .with_numbers("sigma_s_m", parameter(|p| p.sigma_s_m))
        .with_numbers("separation_m", state(|s| s.separation_m))
        .with_numbers("pressure_pa", state(|s| Some(s.pressure_pa)))
        .with_numbers("area_fraction", state(|s| Some(s.area_fraction)));
    if !details {
        return table;
    }
    STATE_DETAILS.iter().fold(table, |table, (name, of)| table.with_numbers(name, state(*of)))
}

/// One column of a state.
type StateColumn = (&'static str, fn(&ContactState) -> Option<f64>);

/// How a statistical state was found, and its logarithms.
pub const STATE_DETAILS: [StateColumn; 5] = [
    ("error_estimate", |state| Some(state.error_estimate)),
    ("evaluations", |state| Some(state.evaluations as f64)),
    ("out_of_range_load_share", |state| Some(state.out_of_range_load_share)),
    ("ln_pressure_pa", |state| Some(state.ln_pressure_pa)),
    ("ln_area_fraction", |state| Some(state.ln_area_fraction)),
];

/// A curve of Persson's theory.
fn persson(curve: &[Vec<Cut>], pressures_pa: &[f64], several: bool) -> Table {
    let column = |of: fn(&Cut) -> f64| curve.iter().flatten().map(of);
    let optional = |of: fn(&Cut) -> Option<f64>| curve.iter().flatten().map(of);
    with_loads(curve, pressures_pa, several)
        .with_numbers("wavelength_m", column(|cut| cut.wavelength_m))
        .with_numbers("area_fraction", column(|cut| cut.areas.contact()))
        .with_numbers("elastic_area_fraction", column(|cut| cut.areas.elastic))
        .with_numbers("plastic_area_fraction", column(|cut| cut.areas.plastic))
        .with_numbers("real_pressure_pa", column(|cut| cut.real_pressure_pa))
        .with_numbers("rms_gradient", column(|cut| cut.rms_gradient))
        .with_numbers("mean_gap_m", optional(|cut| cut.mean_gap_m))
        .with_numbers("stiffness_pa_per_m", optional(|cut| cut.stiffness_pa_per_m))
}

/// A surface under loads: a row a load. The law of light loads is the same in every row, where the model has one.
pub fn gaps(states: &[GapState], light: Option<&LightLoads>) -> Table {
    let column = |of: fn(&GapState) -> Option<f64>| states.iter().map(of);
    let of_light = |of: fn(&LightLoads) -> f64| states.iter().map(move |_| light.map(of));
    Table::default()
        .with_numbers("nominal_pressure_pa", column(|state| Some(state.nominal_pressure_pa)))
        .with_numbers("area_fraction", column(|state| Some(state.area_fraction)))
        .with_numbers("mean_gap_m", column(|state| state.mean_gap_m))
        .with_numbers("stiffness_pa_per_m", column(|state| state.stiffness_pa_per_m))
        .with_numbers("u0_m", of_light(|light| light.decay_length_m))
        .with_numbers("p00_pa", of_light(|light| light.reference_pressure_pa))
}

/// A table that tells which load a row belongs to, where there are several.
fn with_loads<T>(curve: &[Vec<T>], pressures_pa: &[f64], several: bool) -> Table {
    let of_block = |(rows, &pressure_pa): (&Vec<T>, &f64)| std::iter::repeat_n(pressure_pa, rows.len());
    let table = Table::default();
    if !several {
        return table;
    }
    table.with_numbers("nominal_pressure_pa", curve.iter().zip(pressures_pa).flat_map(of_block))
}

/// A stacked curve.
fn stacked(curve: &[Vec<Level>], pressures_pa: &[f64], several: bool, details: bool) -> Table {
    let column = |of: fn(&Level) -> f64| curve.iter().flatten().map(of);
    let mut table = with_loads(curve, pressures_pa, several)
        .with_numbers("wavelength_m", column(|level| level.wavelength_m))
        .with_numbers("amplitude_m", column(|level| level.amplitude_m))
        .with_numbers("area_fraction", column(|level| level.area_fraction))
        .with_numbers("real_pressure_pa", column(|level| level.real_pressure_pa))
        .with_words("regime", curve.iter().flatten().map(|level| level.regime.name()));
    if details {
        // An infinite strength, of a scale above which nothing was deformed, is an empty cell like an unneeded one.
        let strength = |level: &Level| level.yield_strength_pa.filter(|strength_pa| strength_pa.is_finite());
        table = table
            .with_numbers("pressure_in_pa", column(|level| level.pressure_in_pa))
            .with_numbers("yield_strength_pa", curve.iter().flatten().map(strength));
    }
    table
}
