//! The judgement as tables for scripts.

use study::plan::Needs;
use tables::Table;

use crate::judgement::Judgement;
use crate::verdict::ERRORS_GIVEN;
use crate::verdicts::{CurveVerdict, WindowOutcome};

impl Judgement {
    /// A row per curve, load and window: `curve, nominal_pressure_pa, longest_m, shortest_m, pressure_over_gradient,
    /// area_fraction, judged, standard_error, ratio, verdict`. `pressure_over_gradient` is taken with
    /// the rms gradient of the window; areas are fractions of the window. Cells without a solution are empty.
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
    /// reason`. `judged_low` and `judged_high`, two standard errors either way, are empty unless elements were pressed with
    /// the whole band; the ratio is that of the worst window, which the reason names.
    #[must_use]
    pub fn models_table(&self, needs: &Needs) -> Table {
        let rows = || self.curves.iter();
        let found = |of: fn(&CurveVerdict) -> Option<f64>| rows().map(of);
        Table::default()
            .with_text("curve", rows().map(|row| needs.curves[row.curve].name.clone()))
            .with_numbers(
                "nominal_pressure_pa",
                rows().map(|row| needs.loads[row.load].nominal_pressure_pa()),
            )
            .with_numbers("area_fraction", found(|row| row.area_fraction))
            .with_numbers(
                "judged_low",
                found(|row| Some(row.elements?.area_fraction - ERRORS_GIVEN * row.elements?.standard_error)),
            )
            .with_numbers(
                "judged_high",
                found(|row| Some(row.elements?.area_fraction + ERRORS_GIVEN * row.elements?.standard_error)),
            )
            .with_numbers("ratio_to_judge", found(|row| row.ratio))
            .with_text("verdict", rows().map(|row| row.verdict.name().to_owned()))
            .with_text("reason", rows().map(|row| row.reason.to_string()))
    }
}
