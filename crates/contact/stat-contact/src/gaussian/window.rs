//! Interferences that contribute to the integrals.

use super::density::{DENSITY_SCALE, density};

/// Interval in which the integrand is not negligible.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Window {
    /// The lowest interference.
    pub low: f64,
    /// The highest interference.
    pub high: f64,
    /// -ln of the density at its ends over the largest in contact.
    drop: f64,
}

impl Window {
    /// Interferences at which the density is above a share exp(-drop) of its largest value in contact, for every
    /// separation from `nearest` to `farthest`.
    pub fn new(nearest: f64, farthest: f64, drop: f64) -> Window {
        let reach = |u: f64| 2.0 * drop / (u + (u * u + 2.0 * drop).sqrt());
        let half_width = (2.0 * drop).sqrt();
        Window {
            low: (-farthest - half_width).max(0.0),
            high: if nearest >= 0.0 { reach(nearest) } else { half_width - nearest },
            drop,
        }
    }

    /// All interferences up to one.
    pub fn up_to(high: f64) -> Window {
        Window { low: 0.0, high, drop: f64::INFINITY }
    }

    /// Share of the integrals at the separation u that lies outside, for a response like s^2 or, if it `saturates`,
    /// one that is constant above the window.
    pub fn left_out(&self, u: f64, saturates: bool) -> f64 {
        let s = self.high;
        let below = if self.low == 0.0 { 0.0 } else { (-self.drop).exp() };
        if saturates {
            return below;
        }
        // Int_s^inf t^2 exp(-t (u + t/2)) dt, and its whole from 0 on within a fifth.
        let y = s * (u + s);
        let beyond = density(u, s) / DENSITY_SCALE * s * s / (u + s) * (1.0 + 2.0 / y + 2.0 / (y * y));
        let whole = if u > 0.0 { 2.0 / (u + 1.17).powi(3) } else { 1.25 * (1.0 + u * u) };
        below + beyond / whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gaussian::density::log_reference_density;

    #[test]
    fn the_window_ends_where_the_density_has_dropped() {
        for u in [-9.0, 0.0, 2.0, 60.0] {
            let window = Window::new(u, u, 30.0);
            let drop = 0.5 * (u + window.high).powi(2) + log_reference_density(u);
            assert!((drop - 30.0).abs() < 1e-10, "u = {u}: {drop}");
        }
        assert_eq!(Window::new(-1.0, 1.0, 30.0).low, 0.0);
        assert!(Window::new(-20.0, -19.0, 30.0).low > 11.0);
    }
}
