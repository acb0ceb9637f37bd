//! The judgement as tables for scripts.

use study::plan::Needs;
use tables::Table;
use units::SceneKeys;

use crate::judgement::Judgement;
use crate::verdicts::{CurveVerdict, WindowOutcome};

impl Judgement {
    /// A row per curve, load and window: `curve, nominal_pressure_pa, longest_m, shortest_m, pressure_over_gradient,
    /// area_fraction, judged, standard_error, ratio, verdict`. `pressure_over_gradient` is taken with
    /// the rms gradient of the window, on a layer with twice the rms pressure of full contact over E*; areas are fractions of the window. Cells without a solution are empty.
    #[must_use]
    pub fn windows_table(&self, needs: &Needs) -> Table {
        let rows = || self.windows.iter();
        let found = |of: fn(&WindowOutcome) -> Option<f64>| rows().map(of);
        let table = Table::default()
            .with_text("curve", rows().map(|row| needs.curves[row.curve].name.clone()))
            .with_numbers(
                "nominal_pressure_pa",
                rows().map(|row| needs.loads[row.load].nominal_pressure_pa()),
            )
            .with_numbers("longest_m", rows().map(|row| row.longest_m))
            .with_numbers("shortest_m", rows().map(|row| row.shortest_m))
            .with_numbers("pressure_over_gradient", rows().map(|row| row.pressure_over_gradient))
            .with_numbers("area_fraction", found(|row| row.area_fraction))
            .with_numbers("judged", found(|row| Some(row.elements?.area_fraction)))
            .with_numbers("standard_error", found(|row| Some(row.elements?.standard_error)))
            .with_numbers("ratio", found(WindowOutcome::ratio));
        table.with_text("verdict", rows().map(|row| row.verdict.name().to_owned()))
    }

    /// A row per curve and load: `curve, nominal_pressure_pa, area_fraction, judged_low, judged_high, ratio_to_judge, verdict,
    /// reason, reference, worst_window_ratio, worst_window_verdict, worst_window_longest_m, worst_window_shortest_m`. Ratio and
    /// verdict are those of the whole band; `judged_low` and `judged_high` are the elements' area with two standard errors
    /// either way; `reference` names the bodies of these elements, elastic or yielding.
    #[must_use]
    pub fn models_table(&self, needs: &Needs) -> Table {
        let rows = || self.curves.iter();
        let found = |of: fn(&CurveVerdict) -> Option<f64>| rows().map(of);
        let worst_verdict = |row: &CurveVerdict| row.worst_window.map_or("", |worst| worst.verdict.name());
        Table::default()
            .with_text("curve", rows().map(|row| needs.curves[row.curve].name.clone()))
            .with_numbers(
                "nominal_pressure_pa",
                rows().map(|row| needs.loads[row.load].nominal_pressure_pa()),
            )
            .with_numbers("area_fraction", found(|row| row.area_fraction))
            .with_numbers("judged_low", found(|row| Some(row.range?.low)))
            .with_numbers("judged_high", found(|row| Some(row.range?.high)))
            .with_numbers("ratio_to_judge", found(CurveVerdict::ratio))
            .with_text("verdict", rows().map(|row| row.verdict.name().to_owned()))
            .with_text("reason", rows().map(|row| row.reason.words(&SceneKeys)))
            .with_text("reference", rows().map(|row| row.reference.name().to_owned()))
            .with_numbers("worst_window_ratio", found(|row| Some(row.worst_window?.ratio)))
            .with_text("worst_window_verdict", rows().map(|row| worst_verdict(row).to_owned()))
            .with_numbers("worst_window_longest_m", found(|row| Some(row.worst_window?.longest_m)))
            .with_numbers("worst_window_shortest_m", found(|row| Some(row.worst_window?.shortest_m)))
    }
}
