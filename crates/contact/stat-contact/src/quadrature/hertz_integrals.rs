//! Area and pressure of a Gaussian population of Hertz's spheres, in closed form.

use super::precision::error_estimate;
use super::sums::Sums;
use crate::asperities::answers::Asperities;
use crate::gaussian::density::DENSITY_SCALE;
use crate::gaussian::hertz_load::load_and_mean_height;
use crate::gaussian::moments::first_moment;
use crate::gaussian::window::Window;

/// Integrals at every separation at which no asperity within reach leaves Hertz's law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HertzIntegrals {
    pressure_pa: f64,
    area_fraction: f64,
    /// Interference, in units of sigma_s, up to which the law is Hertz's.
    until: f64,
}

impl HertzIntegrals {
    /// Returns `None` if asperities at the highest interference of the window no longer follow Hertz.
    pub fn within(window: &Window, asperities: &dyn Asperities, sigma_s_m: f64) -> Option<Self> {
        let hertz = asperities.hertzian()?;
        let until = hertz.until_m / sigma_s_m;
        (window.high <= until).then(|| HertzIntegrals {
            pressure_pa: DENSITY_SCALE * hertz.pressure_per_three_halves * sigma_s_m * sigma_s_m.sqrt(),
            area_fraction: hertz.area_per_m * sigma_s_m,
            until,
        })
    }

    /// The integrals at the separation u, over the reference density.
    pub fn sums_at(&self, u: f64) -> Sums {
        let (load, mean) = load_and_mean_height(u);
        // Integration by parts reduces the higher means to the first.
        let square = 2.5 + u * mean;
        let cube = 3.5 * mean + 1.5 * u + u * u * mean;
        Sums::new(self.pressure_pa * load, self.area_fraction * first_moment(u), [mean, square, cube])
    }

    /// Estimate of the relative error of the integrals.
    pub fn relative_error(&self, u: f64) -> f64 {
        let other_law =
            if self.until == f64::INFINITY { 0.0 } else { Window::up_to(self.until).left_out(u, false) };
        error_estimate(other_law, u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_means_are_the_derivatives_of_the_logarithm() {
        let integrals =
            HertzIntegrals { pressure_pa: DENSITY_SCALE, area_fraction: 1.0, until: f64::INFINITY };
        for u in [-20.0f64, -4.0, -0.5, 0.7, 5.0, 30.0] {
            let slopes = |u: f64| integrals.sums_at(u).log_pressure_slopes();
            let step = 1e-4 * (1.0 + u.abs());
            for order in [0, 1] {
                let difference = (slopes(u + step)[order] - slopes(u - step)[order]) / (2.0 * step);
                let error = (difference / slopes(u)[order + 1] - 1.0).abs();
                assert!(error < 1e-5, "u = {u}, order {order}: {difference} and {:?}", slopes(u));
            }
        }
    }
}
