//! Preparation of heights before they are transformed: detrending and window.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};
use units::named;

use crate::detrend::Detrend;

/// Detrending and window applied to heights before they are transformed.
///
/// The default suits data that are not periodic: subtract a plane (for a line scan a straight line) and apply the Hann
/// window. Periodic data, such as computed surfaces, need [`Detrend::Mean`] and [`Window::None`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Preparation {
    /// The subtracted trend.
    pub detrend: Detrend,
    /// The window applied to the remainder.
    pub window: Window,
}

impl Preparation {
    /// Preparation of periodic data: subtract the mean, no window.
    pub const PERIODIC: Self = Self { detrend: Detrend::Mean, window: Window::None };

    /// Number of first bins, from q = 2 pi/L on, that do not show the spectrum of the surface.
    ///
    /// One if a slope was subtracted, which removes most of the first bin, or a window applied, which mixes it with the
    /// removed mean; 0 for [`Preparation::PERIODIC`].
    pub const fn flagged_bins(self) -> usize {
        match (self.detrend, self.window) {
            (Detrend::Mean, Window::None) => 0,
            _ => 1,
        }
    }
}

/// Window applied to the heights before they are transformed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Window {
    /// The Hann window (1 - cos(2 pi x/L))/2 divided by its rms, sqrt(3/8), which keeps the power of a stationary
    /// surface: Jacobs, Junge & Pastewka (2017), Surf. Topogr.: Metrol. Prop. 5:013001. Each of N points stands for a
    /// step L/N and lies in its middle, x = (i + 1/2) L/N, so that a scan read backwards has the same spectrum.
    ///
    /// For a map, the product of windows along x and y: unlike a window of circular symmetry it uses the whole of an
    /// elongated map, and its rms is the product of the two.
    #[default]
    Hann,
    /// No window, for periodic data.
    None,
}

named!(Window, "window", { Hann => "hann", None => "none" });

impl Window {
    /// Computes the factors at `points` >= 2 evenly spaced points of a period; their mean square is 1.
    pub(crate) fn factors(self, points: usize) -> Vec<f64> {
        match self {
            Self::Hann => hann(points),
            Self::None => vec![1.0; points],
        }
    }
}

fn hann(points: usize) -> Vec<f64> {
    // The mean of sin^4 is 3/8 if the points resolve cos(4 pi i/N), from 3 on; both of two points have sin^2 = 1/2.
    let rms = if points == 2 { 0.5 } else { 0.375f64.sqrt() };
    let factor = |point: usize| {
        // Measured from the nearer end, so that mirrored points have the same digits.
        let half_steps = (2 * point + 1).min(2 * (points - point) - 1);
        (PI * half_steps as f64 / (2 * points) as f64).sin().powi(2) / rms
    };
    (0..points).map(factor).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn every_window_keeps_the_power_and_has_no_direction() {
        for points in (2..40).chain([97, 1000, 1024]) {
            for &window in Window::ALL {
                let sum: f64 = window.factors(points).iter().map(|factor| factor * factor).sum();
                assert_relative_eq!(sum / points as f64, 1.0, max_relative = 1e-14);
                let mut backwards = window.factors(points);
                backwards.reverse();
                assert_eq!(backwards, window.factors(points));
            }
        }
        assert_eq!("hann".parse(), Ok(Window::Hann));
        assert_eq!(
            "hamming".parse::<Window>().unwrap_err().to_string(),
            "reading the window: 'hamming' is not one of hann, none"
        );
    }
}
