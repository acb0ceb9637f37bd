//! Area of a window by boundary elements, interpolated to any load.

use persson::elastic;

use crate::elements::ElementsRow;
use crate::spectra::WaveBand;

/// Area over p/(E* h') of a band. Between the loads that were pressed, the ratio to Persson's area, which changes
/// slowly, is interpolated in the logarithm of the load.
#[derive(Clone, Debug, PartialEq)]
pub struct WindowLaw {
    /// ln p/(E* h'), rising, and the ratio to Persson's area.
    knots: Vec<(f64, f64)>,
    /// Relative errors of the knots.
    errors: Vec<f64>,
}

impl WindowLaw {
    /// Creates the law of a band; `None` if it has not been pressed.
    #[must_use]
    pub fn from_elements(elements: &[ElementsRow], band: &WaveBand) -> Option<Self> {
        let mut rows: Vec<&ElementsRow> =
            elements.iter().filter(|row| row.band() == *band && row.spread_over_hardness.is_none()).collect();
        rows.sort_by(|a, b| a.pressure_over_gradient.total_cmp(&b.pressure_over_gradient));
        let knot = |row: &&ElementsRow| {
            (row.pressure_over_gradient.ln(), row.area_fraction / persson(row.pressure_over_gradient))
        };
        let errors = rows.iter().map(|row| row.relative_error()).collect();
        let knots: Vec<(f64, f64)> = rows.iter().map(knot).collect();
        (!knots.is_empty()).then_some(WindowLaw { knots, errors })
    }

    /// Area fraction under p/(E* h') >= 0; proportional to the load below the lightest that was pressed.
    #[must_use]
    pub fn area_fraction(&self, pressure_over_gradient: f64) -> f64 {
        (self.between(pressure_over_gradient, |at| self.knots[at].1) * persson(pressure_over_gradient))
            .min(1.0)
    }

    /// Relative error of the area fraction.
    #[must_use]
    pub fn relative_error(&self, pressure_over_gradient: f64) -> f64 {
        self.between(pressure_over_gradient, |at| self.errors[at])
    }

    fn between(&self, pressure_over_gradient: f64, value: impl Fn(usize) -> f64) -> f64 {
        let x = pressure_over_gradient.ln();
        let above = self.knots.partition_point(|(knot, _)| *knot < x);
        if above == 0 || above == self.knots.len() {
            return value(above.saturating_sub(1));
        }
        let (low, high) = (self.knots[above - 1].0, self.knots[above].0);
        let share = (x - low) / (high - low);
        value(above - 1) * (1.0 - share) + value(above) * share
    }
}

/// Persson's elastic area under p/(E* h').
#[must_use]
pub fn persson(pressure_over_gradient: f64) -> f64 {
    // In units of E* h' the spread s is 1/2.
    elastic::area_fraction(pressure_over_gradient, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements;

    fn row(pressure_over_gradient: f64, area_fraction: f64) -> ElementsRow {
        let text = format!(
            "hurst_exponent,first_wave,rolloff_wave,last_wave,alpha,pressure_over_gradient,spread_over_hardness,area_fraction,\
             area_fraction_corrected,plastic_area_fraction,standard_error,plastic_standard_error,realisations,grid\n\
             0.8,4,4,40,6,{pressure_over_gradient},,{area_fraction},{area_fraction},0,0,0,4,256\n"
        );
        elements::read::<ElementsRow>(text.as_bytes()).unwrap()[0]
    }

    #[test]
    fn a_law_meets_its_knots_and_is_proportional_at_lighter_loads() {
        let rows = [row(0.1, 0.2), row(0.01, 0.022), row(1.0, 0.96)];
        let law = WindowLaw::from_elements(&rows, &rows[0].band()).unwrap();
        for row in &rows {
            assert!((law.area_fraction(row.pressure_over_gradient) / row.area_fraction - 1.0).abs() < 1e-12);
        }
        // A law that is k times Persson's everywhere stays k times it between the loads.
        let scaled = [0.01, 1.0].map(|load| row(load, 1.02 * persson(load)));
        let law = WindowLaw::from_elements(&scaled, &scaled[0].band()).unwrap();
        assert!((law.area_fraction(0.1) / persson(0.1) - 1.02).abs() < 1e-12);
        assert!((law.area_fraction(1e-6) / law.area_fraction(1e-5) - 0.1).abs() < 1e-8);
        assert_eq!(law.area_fraction(30.0), 1.0);
    }
}
