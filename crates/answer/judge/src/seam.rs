//! Steps by closed forms: from the waves of a window, which elements press, to all waves, and from a load to a lighter one.

/// The least relative standard error of a seam. Measured on spectra of every kind (docs/develop/trials.md).
const LEAST_ERROR: f64 = 0.02;
/// The least relative standard error of a seam for elements that flow at a hardness, an assumption: the closed form with a
/// hardness is up to a tenth low on bands that were solved at once.
const LEAST_ERROR_IF_YIELDING: f64 = 0.05;

/// The relative standard error of a seam per exponent of the stiffness of a layer, up to 1: measured on whole bands on layers
/// (docs/develop/trials.md).
const ERROR_PER_EXPONENT: f64 = 0.15;

/// The relative standard error of a closed form that carries an area to lighter loads, per decade of load: elements on one band
/// over 1.3 decades scatter by 4 %, of which the closed form knows a part.
const ERROR_PER_DECADE: f64 = 0.03;

/// The lightest load p/(E* h') of the elements that the closed form was fitted to (docs/guide/which-model.md).
const LIGHTEST_TRIED: f64 = 0.003;

/// The relative standard error of a seam under a load p/(E* h') of the longer waves: below the lightest load that was tried their
/// closed form carries the area down.
pub(crate) fn error_of_light_load(pressure_over_gradient: f64) -> f64 {
    ERROR_PER_DECADE * (LIGHTEST_TRIED / pressure_over_gradient).log10().max(0.0)
}

/// The relative standard error of a seam between waves whose stiffness on a layer goes as q^n with the wavenumber q; 0 on
/// half-spaces.
pub(crate) fn error_on_layer(exponent: f64) -> f64 {
    ERROR_PER_EXPONENT * exponent.abs().min(1.0)
}

/// The step from the area of elements on a window to the area of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Seam {
    /// The factor from the area on the window to that of the surface.
    pub factor: f64,
    /// The relative standard error of the factor.
    pub relative_error: f64,
}

impl Seam {
    /// No seam: the window is the whole surface.
    pub const NONE: Seam = Seam { factor: 1.0, relative_error: 0.0 };

    /// The step of an area to a load that is lighter by a factor.
    pub fn down(factor: f64, lighter_by: f64) -> Self {
        Seam { factor, relative_error: ERROR_PER_DECADE * lighter_by.log10() }
    }

    /// Joins two factors. One is the share of the surface that the longer waves leave in contact. It is right if the shorter
    /// waves are weak, and up to a tenth off if both overlap. The other is the closed form on the surface over that on the
    /// window. It is right where the closed form is, and wrong on spectra with humps. The middle is nearer to the truth than
    /// either, and half of what they differ is its error.
    pub fn new(by_share: f64, by_closed_form: f64, yields: bool) -> Self {
        let least = if yields { LEAST_ERROR_IF_YIELDING } else { LEAST_ERROR };
        let half_apart = 0.5 * (by_share / by_closed_form).ln().abs();
        Seam { factor: (by_share * by_closed_form).sqrt(), relative_error: half_apart.max(least) }
    }

    /// Adds an independent relative standard error.
    pub fn with_error(self, relative_error: f64) -> Self {
        Seam { relative_error: self.relative_error.hypot(relative_error), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_both_factors_is_taken_and_half_their_distance_is_its_error() {
        let seam = Seam::new(0.4, 0.1, false);
        assert!((seam.factor - 0.2).abs() < 1e-15 && (seam.relative_error - 2f64.ln()).abs() < 1e-15);
        let seam = Seam::new(0.3, 0.3, false);
        assert_eq!(seam.relative_error, LEAST_ERROR);
        assert_eq!(seam.with_error(error_on_layer(0.0)), seam);
        assert_eq!(error_on_layer(-3.0), ERROR_PER_EXPONENT);
        assert_eq!(error_of_light_load(0.02), 0.0);
        assert!((error_of_light_load(3e-5) - 2.0 * ERROR_PER_DECADE).abs() < 1e-12);
    }
}
