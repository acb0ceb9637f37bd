//! The area of one decade as boundary elements have it, at any load.

use persson::elastic;

use crate::elements::ElementsRow;
use crate::programme::one_decade;

/// Area against p/(E* h') of the decade of a Hurst exponent: between the loads that were pressed, the ratio to Persson's
/// area, which changes slowly, is interpolated in the logarithm of the load.
#[derive(Clone, Debug, PartialEq)]
pub struct WindowLaw {
    /// ln p/(E* h'), rising, and the ratio to Persson's area.
    knots: Vec<(f64, f64)>,
    /// The relative errors of the knots.
    errors: Vec<f64>,
}

impl WindowLaw {
    /// The law of a Hurst exponent; `None` where its decade has not been pressed.
    #[must_use]
    pub fn of(elements: &[ElementsRow], hurst_exponent: f64) -> Option<Self> {
        let band = one_decade(hurst_exponent);
        let mut rows: Vec<&ElementsRow> =
            elements.iter().filter(|row| row.band() == band && row.spread_over_hardness.is_none()).collect();
        rows.sort_by(|a, b| a.pressure_over_gradient.total_cmp(&b.pressure_over_gradient));
        let knot = |row: &&ElementsRow| {
            (row.pressure_over_gradient.ln(), row.area_fraction / persson(row.pressure_over_gradient))
        };
        let errors = rows.iter().map(|row| row.relative_error()).collect();
        let knots: Vec<(f64, f64)> = rows.iter().map(knot).collect();
        (!knots.is_empty()).then_some(WindowLaw { knots, errors })
    }

    /// Area over nominal area under p/(E* h') >= 0; proportional to the load below the lightest that was pressed.
    #[must_use]
    pub fn area_fraction(&self, pressure_over_gradient: f64) -> f64 {
        (self.between(pressure_over_gradient, |at| self.knots[at].1) * persson(pressure_over_gradient))
            .min(1.0)
    }

    /// The relative error of that.
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
