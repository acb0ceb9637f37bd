//! The self-affine spectrum with a roll-off, fitted to samples.

use std::ops::RangeBounds;

use serde::Serialize;
use thiserror::Error;
use units::display::counted;

use crate::cholesky::Cholesky;
use crate::interval::ln_ratio;
use crate::profile::ProfilePsd;

/// Number of trial roll-offs at the start, evenly spaced in the logarithm of the band.
const STARTS: usize = 24;
/// Width in ln q_r, relative to the band, at which the search ends; the minimum is flat to half the digits.
const SEARCH_WIDTH: f64 = 1e-8;
/// Deviations in ln C1D below this count as rounding.
const ROUNDING: f64 = 1e-12;
/// Advantage in the Bayesian information criterion that counts as strong evidence: Kass & Raftery (1995), J.
/// Am. Stat. Assoc. 90:773.
const STRONG_EVIDENCE: f64 = 6.0;
/// Longest step in ln C_0, H and ln q_r that the final Gauss-Newton steps accept.
const LARGEST_POLISH: f64 = 1e-5;
/// Smallest pivot of the correlation matrix with which its inverse still has digits.
const SMALLEST_PIVOT: f64 = 1e-7;

/// A self-affine spectrum fitted with equal weights to ln C1D: with a roll-off
/// ln C1D = ln C_0 - (H + 1/2) ln(1 + (q/q_r)^2), without one ln C1D = const - (2 H + 1) ln q.
///
/// Standard errors follow from s^2 (J^T J)^-1 to first order; they are absent if there are as many parameters as
/// samples.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SelfAffineFit {
    /// Hurst exponent H; 0 to 1 for a self-affine surface, but reported as fitted.
    pub hurst_exponent: f64,
    /// Standard error of the Hurst exponent.
    pub hurst_exponent_se: Option<f64>,
    /// The roll-off, if the samples show one.
    pub rolloff: Option<RollOff>,
    /// Root mean square deviation of log10 C1D from the fit.
    pub rms_log10_residual: f64,
    /// Number of samples fitted.
    pub points: usize,
}

/// The roll-off of a self-affine spectrum, where it levels off towards long wavelengths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RollOff {
    /// Roll-off wavelength lambda_r = 2 pi/q_r in m, inside the fitted band.
    pub wavelength_m: f64,
    /// Standard error of the wavelength in m.
    pub wavelength_se_m: Option<f64>,
    /// The plateau C_0 of C1D in m^3.
    pub plateau_m3: f64,
    /// Standard error of the plateau in m^3.
    pub plateau_se_m3: Option<f64>,
}

/// Errors of fitting a self-affine spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FitError {
    /// Fewer than two samples in the band.
    #[error(
        "fitting a self-affine spectrum: {}; widen the band to hold at least 2", counted(*.points, "sample")
    )]
    TooFewSamples {
        /// Number of samples in the band.
        points: usize,
    },
}

/// Fits a self-affine spectrum to the samples whose wavelength in m lies in `band`; `..` takes them all.
///
/// A roll-off is reported only if it is identifiable: three samples or more, q_r inside the sampled band, a regular
/// normal matrix, and a Bayesian information criterion more than 6 below that of the pure power law: n ln(RSS_2/RSS_3)
/// above ln n + 6 (strong evidence after Kass & Raftery, 1995). Sums of squares below those of deviations of 1e-12 count
/// as rounding, so exact power laws have no roll-off. Otherwise the pure power law is returned.
///
/// # Errors
/// [`FitError::TooFewSamples`] with fewer than two samples in the band.
pub fn fit_self_affine(psd: &ProfilePsd, band: impl RangeBounds<f64>) -> Result<SelfAffineFit, FitError> {
    let samples = LogSamples::in_band(psd, band);
    if samples.len() < 2 {
        return Err(FitError::TooFewSamples { points: samples.len() });
    }
    let power_law = Line::through(&samples.ln_q, &samples.ln_c);
    Ok(with_rolloff(&samples, &power_law).unwrap_or_else(|| without_rolloff(&samples, &power_law)))
}

fn without_rolloff(samples: &LogSamples, power_law: &Line) -> SelfAffineFit {
    SelfAffineFit {
        hurst_exponent: -(power_law.slope + 1.0) / 2.0,
        hurst_exponent_se: samples
            .variance(power_law.sum_of_squares, 2)
            .map(|s2| power_law.slope_error(s2) / 2.0),
        rolloff: None,
        rms_log10_residual: samples.rms_log10(power_law.sum_of_squares),
        points: samples.len(),
    }
}

fn with_rolloff(samples: &LogSamples, power_law: &Line) -> Option<SelfAffineFit> {
    if samples.len() < 3 {
        return None;
    }
    let best = RollOffFit::nearest(samples)?.polished();
    let sum_of_squares = best.sum_of_squares();
    if !best.is_inside_band() || !samples.prefers(sum_of_squares, power_law.sum_of_squares) {
        return None;
    }
    let inverse = best.inverse_normal()?;
    let error = |parameter: usize| {
        samples.variance(sum_of_squares, 3).map(|s2| (s2 * inverse[parameter][parameter]).sqrt())
    };
    let [ln_plateau, exponent, ln_q_r] = best.parameters;
    let plateau_m3 = samples.reference_m3 * ln_plateau.exp();
    let wavelength_m = samples.longest_m * (-ln_q_r).exp();
    Some(SelfAffineFit {
        hurst_exponent: exponent - 0.5,
        hurst_exponent_se: error(1),
        rolloff: Some(RollOff {
            wavelength_m,
            wavelength_se_m: error(2).map(|se| se * wavelength_m),
            plateau_m3,
            plateau_se_m3: error(0).map(|se| se * plateau_m3),
        }),
        rms_log10_residual: samples.rms_log10(sum_of_squares),
        points: samples.len(),
    })
}

/// The samples in the band, as logarithms relative to the one of longest wavelength.
struct LogSamples {
    longest_m: f64,
    reference_m3: f64,
    ln_q: Vec<f64>,
    ln_c: Vec<f64>,
}

impl LogSamples {
    fn in_band(psd: &ProfilePsd, band: impl RangeBounds<f64>) -> Self {
        let inside = || {
            psd.wavelengths_m().iter().zip(psd.c1d_m3()).filter(|(wavelength, _)| band.contains(wavelength))
        };
        let (longest_m, reference_m3) =
            inside().next().map_or((1.0, 1.0), |(&wavelength, &value)| (wavelength, value));
        Self {
            longest_m,
            reference_m3,
            ln_q: inside().map(|(&wavelength_m, _)| ln_ratio(longest_m, wavelength_m)).collect(),
            ln_c: inside().map(|(_, &c1d_m3)| ln_ratio(c1d_m3, reference_m3)).collect(),
        }
    }

    fn len(&self) -> usize {
        self.ln_q.len()
    }

    /// Extent of the band in ln q.
    fn extent(&self) -> f64 {
        self.ln_q[self.len() - 1]
    }

    /// Variance s^2 of ln C1D about a fit; `None` without degrees of freedom.
    fn variance(&self, sum_of_squares: f64, parameters: usize) -> Option<f64> {
        let freedom = self.len().checked_sub(parameters).filter(|&freedom| freedom > 0)?;
        Some(sum_of_squares / freedom as f64)
    }

    fn rms_log10(&self, sum_of_squares: f64) -> f64 {
        (sum_of_squares / self.len() as f64).sqrt() / 10f64.ln()
    }

    /// Returns true if the Bayesian information criterion strongly favours one more parameter.
    fn prefers(&self, larger_model: f64, smaller_model: f64) -> bool {
        let points = self.len() as f64;
        let rounding = points * ROUNDING * ROUNDING;
        points * (smaller_model.max(rounding) / larger_model.max(rounding)).ln()
            > points.ln() + STRONG_EVIDENCE
    }
}

/// The least-squares straight line through points.
struct Line {
    intercept: f64,
    slope: f64,
    spread: f64,
    sum_of_squares: f64,
}

impl Line {
    fn through(x: &[f64], y: &[f64]) -> Self {
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let (x_mean, y_mean) = (mean(x), mean(y));
        let spread: f64 = x.iter().map(|x| (x - x_mean).powi(2)).sum();
        let slope = x.iter().zip(y).map(|(x, y)| (x - x_mean) * (y - y_mean)).sum::<f64>() / spread;
        let residual = |(x, y): (&f64, &f64)| (y - y_mean) - slope * (x - x_mean);
        let sum_of_squares = x.iter().zip(y).map(residual).map(|residual| residual * residual).sum();
        Self { intercept: y_mean - slope * x_mean, slope, spread, sum_of_squares }
    }

    fn slope_error(&self, variance: f64) -> f64 {
        (variance / self.spread).sqrt()
    }
}

/// The model with a roll-off: ln C_0, H + 1/2, ln q_r, all relative to the first sample.
struct RollOffFit<'s> {
    samples: &'s LogSamples,
    parameters: [f64; 3],
}

impl<'s> RollOffFit<'s> {
    /// Finds the least-squares fit to half its digits; `None` if the sum of squares still falls beyond an end of the
    /// band.
    ///
    /// For a given roll-off the other two parameters follow from a straight line, so the search has a single variable
    /// (variable projection: Golub & Pereyra (1973), SIAM J. Numer. Anal. 10:413).
    fn nearest(samples: &'s LogSamples) -> Option<Self> {
        let at = |start: usize| (start as f64 - 1.5) / STARTS as f64 * samples.extent();
        // Two points on either side lie outside the band, so that a minimum just inside an end has neighbours.
        let sums: Vec<f64> =
            (0..STARTS + 4).map(|start| Self::at(samples, at(start)).sum_of_squares()).collect();
        let least = (0..sums.len()).min_by(|&a, &b| sums[a].total_cmp(&sums[b]))?;
        let (before, after) = (least.checked_sub(1)?, least + 1);
        if after == sums.len() {
            return None;
        }
        let width = SEARCH_WIDTH * samples.extent();
        let ln_q_r = least_between(at(before), at(after), width, |x| Self::at(samples, x).sum_of_squares());
        Some(Self::at(samples, ln_q_r))
    }

    /// Fits the other parameters for a given roll-off.
    fn at(samples: &'s LogSamples, ln_q_r: f64) -> Self {
        let fall: Vec<f64> = samples.ln_q.iter().map(|ln_q| fall(ln_q - ln_q_r)).collect();
        let line = Line::through(&fall, &samples.ln_c);
        Self { samples, parameters: [line.intercept, -line.slope, ln_q_r] }
    }

    /// Yields the residual of each sample and its derivatives with respect to the parameters.
    fn rows(&self) -> impl Iterator<Item = (f64, [f64; 3])> {
        let [ln_plateau, exponent, ln_q_r] = self.parameters;
        self.samples.ln_q.iter().zip(&self.samples.ln_c).map(move |(ln_q, ln_c)| {
            let from_rolloff = ln_q - ln_q_r;
            let fall = fall(from_rolloff);
            (ln_plateau - exponent * fall - ln_c, [1.0, -fall, exponent * fall_slope(from_rolloff)])
        })
    }

    /// Sum of the squared residuals; infinite if it overflows or is NaN.
    fn sum_of_squares(&self) -> f64 {
        let sum: f64 = self.rows().map(|(residual, _)| residual * residual).sum();
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    fn is_inside_band(&self) -> bool {
        (0.0..=self.samples.extent()).contains(&self.parameters[2])
    }

    /// Refines the fit by Gauss-Newton steps while each is at most half as long as the last. They settle the lower half
    /// of the digits, for which the sum of squares is too flat.
    fn polished(mut self) -> Self {
        let mut longest = LARGEST_POLISH;
        let norm = |step: &[f64; 3]| step.iter().map(|part| part * part).sum::<f64>().sqrt();
        while let Some(step) = self.gauss_newton_step().filter(|step| norm(step) < longest) {
            self.parameters = std::array::from_fn(|i| self.parameters[i] - step[i]);
            longest = 0.5 * norm(&step);
        }
        self
    }

    fn gauss_newton_step(&self) -> Option<[f64; 3]> {
        let inverse = self.inverse_normal()?;
        let mut gradient = [0.0; 3];
        for (residual, derivatives) in self.rows() {
            (0..3).for_each(|i| gradient[i] += derivatives[i] * residual);
        }
        Some(inverse.map(|row| row.iter().zip(gradient).map(|(a, b)| a * b).sum()))
    }

    /// Computes (J^T J)^-1; `None` if the matrix is singular to working precision.
    fn inverse_normal(&self) -> Option<[[f64; 3]; 3]> {
        let mut normal = [[0.0; 3]; 3];
        for (_, derivatives) in self.rows() {
            (0..3).for_each(|i| (0..3).for_each(|j| normal[i][j] += derivatives[i] * derivatives[j]));
        }
        let norms: [f64; 3] = std::array::from_fn(|i| normal[i][i].sqrt());
        let scaled = |matrix: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
            std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] / (norms[i] * norms[j])))
        };
        let factor =
            Cholesky::new(scaled(normal)).filter(|factor| factor.smallest_pivot() >= SMALLEST_PIVOT)?;
        Some(scaled(factor.inverse()))
    }
}

/// Finds the minimum of a function between two arguments by golden-section search down to an interval of `width`.
fn least_between(mut from: f64, mut to: f64, width: f64, function: impl Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut left, mut right) = (to - golden * (to - from), from + golden * (to - from));
    let (mut of_left, mut of_right) = (function(left), function(right));
    while to - from > width {
        if of_left <= of_right {
            (to, right, of_right) = (right, left, of_left);
            left = to - golden * (to - from);
            of_left = function(left);
        } else {
            (from, left, of_left) = (left, right, of_right);
            right = from + golden * (to - from);
            of_right = function(right);
        }
    }
    0.5 * (from + to)
}

/// Computes ln(1 + (q/q_r)^2) from ln(q/q_r) without overflow.
fn fall(ln_q_over_q_r: f64) -> f64 {
    2.0 * ln_q_over_q_r.max(0.0) + (-2.0 * ln_q_over_q_r.abs()).exp().ln_1p()
}

/// Derivative of [`fall`].
fn fall_slope(ln_q_over_q_r: f64) -> f64 {
    2.0 / (1.0 + (-2.0 * ln_q_over_q_r).exp())
}
