//! Refit of the two constants of the form `algebraic-nayak` of Persson's theory.
//!
//! V_e = [g + (1 - g) A] V with g = a + b ln(alpha): a and b minimise the sum of squares of relative errors in the
//! area, each over its own standard error.

use persson::corrections::algebraic_variance_pa2;
use persson::elastic;

use crate::elements::ElementsRow;

/// Largest relative error of a row that counts among the errors of the form.
const WELL_KNOWN: f64 = 0.015;

/// Constants of the form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NayakForm {
    /// Constant a of g = a + b ln(alpha).
    pub a: f64,
    /// Constant b of g = a + b ln(alpha).
    pub b: f64,
}

/// Errors of a form.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Misfit {
    /// Root mean square of relative errors, over the areas known to 1.5 %.
    pub rms: f64,
    /// Largest of these errors, with its sign.
    pub worst: f64,
    /// Number of these areas.
    pub well_known: usize,
    /// Root mean square of all relative errors, each over its standard error.
    pub rms_in_standard_errors: f64,
    /// Largest of these.
    pub worst_in_standard_errors: f64,
}

impl NayakForm {
    /// Constants of the program.
    pub const OF_THE_PROGRAM: Self = Self { a: 0.4244, b: 0.0357 };

    /// Area under p/(E* h') of a spectrum of alpha.
    #[must_use]
    pub fn area_fraction(&self, pressure_over_gradient: f64, alpha: f64) -> f64 {
        let g = (self.a + self.b * alpha.ln()).clamp(f64::MIN_POSITIVE, 1.0);
        // In units of E* h' the variance is 1/4.
        elastic::area_fraction(
            pressure_over_gradient,
            algebraic_variance_pa2(g, pressure_over_gradient, 0.25).sqrt(),
        )
    }

    /// Fits the constants, from those of the program on.
    #[must_use]
    pub fn fitted(elements: &[ElementsRow]) -> Self {
        let rows = elastic_rows(elements);
        let mut form = Self::OF_THE_PROGRAM;
        for _ in 0..20 {
            form = form.improved(&rows);
        }
        form
    }

    /// Gauss-Newton step.
    fn improved(self, rows: &[&ElementsRow]) -> Self {
        const STEP: f64 = 1e-5;
        let mut normal = [0.0; 3];
        let mut right = [0.0; 2];
        for row in rows {
            let error = row.relative_error();
            let residual = |form: &Self| form.relative_error_of(row) / error;
            let here = residual(&self);
            let by_a = (residual(&Self { a: self.a + STEP, ..self }) - here) / STEP;
            let by_b = (residual(&Self { b: self.b + STEP, ..self }) - here) / STEP;
            normal = [normal[0] + by_a * by_a, normal[1] + by_a * by_b, normal[2] + by_b * by_b];
            right = [right[0] - by_a * here, right[1] - by_b * here];
        }
        let determinant = normal[0] * normal[2] - normal[1] * normal[1];
        Self {
            a: self.a + (normal[2] * right[0] - normal[1] * right[1]) / determinant,
            b: self.b + (normal[0] * right[1] - normal[1] * right[0]) / determinant,
        }
    }

    /// Errors of the form.
    #[must_use]
    pub fn misfit(&self, elements: &[ElementsRow]) -> Misfit {
        let rows = elastic_rows(elements);
        let well: Vec<f64> = rows
            .iter()
            .filter(|row| row.relative_error() < WELL_KNOWN)
            .map(|row| self.relative_error_of(row))
            .collect();
        let in_errors: Vec<f64> =
            rows.iter().map(|row| self.relative_error_of(row) / row.relative_error()).collect();
        Misfit {
            rms: rms(&well),
            worst: worst(&well),
            well_known: well.len(),
            rms_in_standard_errors: rms(&in_errors),
            worst_in_standard_errors: worst(&in_errors),
        }
    }

    fn relative_error_of(&self, row: &ElementsRow) -> f64 {
        self.area_fraction(row.pressure_over_gradient, row.alpha) / row.area_fraction - 1.0
    }
}

fn elastic_rows(elements: &[ElementsRow]) -> Vec<&ElementsRow> {
    elements.iter().filter(|row| row.spread_over_hardness.is_none()).collect()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

fn worst(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, |worst, value| if value.abs() > worst.abs() { value } else { worst })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements;

    #[test]
    fn the_constants_of_areas_that_follow_the_form_are_found_again() {
        let form = NayakForm { a: 0.5, b: 0.02 };
        let mut text = "hurst_exponent,first_wave,rolloff_wave,last_wave,alpha,pressure_over_gradient,spread_over_hardness,\
                        area_fraction,area_fraction_corrected,plastic_area_fraction,standard_error,\
                        plastic_standard_error,realisations,grid\n"
            .to_owned();
        for alpha in [2.0, 8.0, 60.0] {
            for load in [0.003, 0.04, 0.4] {
                let area = form.area_fraction(load, alpha);
                text += &format!("0.8,1,1,100,{alpha},{load},,{area},{area},0,0,0,4,256\n");
            }
        }
        let rows: Vec<ElementsRow> = elements::read(text.as_bytes()).unwrap();
        let found = NayakForm::fitted(&rows);
        assert!((found.a - form.a).abs() < 1e-6 && (found.b - form.b).abs() < 1e-6, "{found:?}");
        let misfit = NayakForm::OF_THE_PROGRAM.misfit(&rows);
        assert!(misfit.well_known == 9 && misfit.worst > 0.01 && misfit.rms < misfit.worst, "{misfit:?}");
    }
}
