//! The answer as tables for scripts.

use super::{LoadAnswer, SceneAnswer};
use study::plan::Needs;
use tables::Table;

impl SceneAnswer {
    /// A row per curve and load: `curve, nominal_pressure_pa, area_fraction, real_pressure_pa, settled_1_percent_m,
    /// settled_01_percent_m, settled` (yes or no, empty for a curve at the shortest cutoff only),
    /// `setting_wavelength_m, setting_pressure_pa, out_of_range_load_share`. A wavelength is empty if the spectrum ends
    /// too soon below it.
    pub fn scales_table(&self, needs: &Needs) -> Table {
        let rows = || {
            needs.curves.iter().zip(&self.curves).flat_map(|(curve, answers)| {
                needs
                    .loads
                    .iter()
                    .zip(answers)
                    .filter_map(move |(load, answer)| Some((curve, load, answer.as_ref()?)))
            })
        };
        let found = |of: fn(&LoadAnswer) -> Option<f64>| rows().map(move |(_, _, answer)| of(answer));
        Table::default()
            .with_text("curve", rows().map(|(curve, _, _)| curve.name.clone()))
            .with_numbers("nominal_pressure_pa", rows().map(|(_, load, _)| load.nominal_pressure_pa()))
            .with_numbers("area_fraction", found(|answer| Some(answer.area_fraction)))
            .with_numbers("real_pressure_pa", found(|answer| Some(answer.real_pressure_pa)))
            .with_numbers("settled_1_percent_m", found(|answer| answer.within_1_percent.if_converged_m()))
            .with_numbers("settled_01_percent_m", found(|answer| answer.within_01_percent.if_converged_m()))
            .with_text("settled", rows().map(|(_, _, answer)| settled(answer).to_owned()))
            .with_numbers("setting_wavelength_m", found(|answer| Some(answer.setting?.wavelength_m)))
            .with_numbers(
                "setting_pressure_pa",
                found(|answer| Some(answer.setting?.full_contact_pressure_pa)),
            )
            .with_numbers("out_of_range_load_share", found(|answer| answer.out_of_range_load_share))
    }

    /// A row per curve, load and decade of wavelengths: `curve, nominal_pressure_pa, longest_wavelength_m,
    /// shortest_wavelength_m, share` of ln(A_n/A) that the decade decides, `measured` (yes or no: whether the spectrum was
    /// measured in at least half of it).
    pub fn decades_table(&self, needs: &Needs) -> Table {
        let rows = || {
            needs.curves.iter().zip(&self.curves).flat_map(|(curve, answers)| {
                needs.loads.iter().zip(answers).flat_map(move |(load, answer)| {
                    let decades = answer.iter().flat_map(|answer| &answer.decades);
                    decades.map(move |decade| (curve, load, decade))
                })
            })
        };
        Table::default()
            .with_text("curve", rows().map(|(curve, _, _)| curve.name.clone()))
            .with_numbers("nominal_pressure_pa", rows().map(|(_, load, _)| load.nominal_pressure_pa()))
            .with_numbers("longest_wavelength_m", rows().map(|(_, _, decade)| decade.longest_m))
            .with_numbers("shortest_wavelength_m", rows().map(|(_, _, decade)| decade.shortest_m))
            .with_numbers("share", rows().map(|(_, _, decade)| decade.share))
            .with_text(
                "measured",
                rows().map(|(_, _, decade)| if decade.measured { "yes" } else { "no" }.to_owned()),
            )
    }
}

fn settled(answer: &LoadAnswer) -> &'static str {
    match (answer.followed, answer.settled) {
        (false, _) => "",
        (true, true) => "yes",
        (true, false) => "no",
    }
}
