//! The least squares of the self-affine fit, by Levenberg's and Marquardt's method.

use std::ops::RangeBounds;

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DVector, Dyn, Matrix3, OMatrix, U3, Vector3};

use crate::interval::ln_ratio;
use crate::profile::ProfilePsd;
use crate::self_affine::{FitError, RollOff, SelfAffineFit};

/// Number of trial roll-offs at the start, evenly spaced in the logarithm of the band.
const STARTS: usize = 24;
/// Deviations in ln C1D below this count as rounding.
const ROUNDING: f64 = 1e-12;
/// Advantage in the Bayesian information criterion that counts as strong evidence: Kass & Raftery (1995), J.
/// Am. Stat. Assoc. 90:773.
const STRONG_EVIDENCE: f64 = 6.0;
/// Longest step in ln C_0, H and ln q_r that the final Gauss-Newton steps accept.
const LARGEST_POLISH: f64 = 1e-5;
/// Smallest pivot of the correlation matrix with which its inverse still has digits.
const SMALLEST_PIVOT: f64 = 1e-7;

/// Fits the samples in a band.
///
/// # Errors
/// [`FitError::TooFewSamples`].
pub(crate) fn fit(psd: &ProfilePsd, band: impl RangeBounds<f64>) -> Result<SelfAffineFit, FitError> {
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
    let best = RollOffModel::fitted(samples)?;
    let sum_of_squares = best.sum_of_squares();
    if !(0.0..=samples.extent()).contains(&best.parameters[2])
        || !samples.prefers(sum_of_squares, power_law.sum_of_squares)
    {
        return None;
    }
    let inverse = best.inverse_normal()?;
    let error = |parameter: usize| {
        samples.variance(sum_of_squares, 3).map(|s2| (s2 * inverse[(parameter, parameter)]).sqrt())
    };
    let [ln_plateau, exponent, ln_q_r] = best.parameters.into();
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
struct RollOffModel<'s> {
    samples: &'s LogSamples,
    parameters: Vector3<f64>,
}

impl<'s> RollOffModel<'s> {
    /// Finds the least-squares fit; `None` if the sum of squares still falls beyond an end of the band. The search starts at
    /// the best of the trial roll-offs, for which the other two parameters follow from a straight line.
    fn fitted(samples: &'s LogSamples) -> Option<Self> {
        let at = |start: usize| Self::at(samples, (start as f64 - 1.5) / STARTS as f64 * samples.extent());
        // Two points on either side lie outside the band, so that a minimum just inside an end has neighbours.
        let sums: Vec<f64> = (0..STARTS + 4).map(|start| at(start).sum_of_squares()).collect();
        let least = (0..sums.len()).min_by(|&a, &b| sums[a].total_cmp(&sums[b]))?;
        if least == 0 || least + 1 == sums.len() {
            return None;
        }
        let (fitted, _) = LevenbergMarquardt::new().minimize(at(least));
        Some(fitted.polished())
    }

    /// Refines the fit by Gauss-Newton steps while each is at most half as long as the last. They settle the lower half of the
    /// digits, for which the sum of squares is too flat.
    fn polished(mut self) -> Self {
        let mut longest = LARGEST_POLISH;
        let step = |fit: &Self| Some(fit.inverse_normal()? * fit.jacobian()?.tr_mul(&fit.residuals()?));
        while let Some(step) = step(&self).filter(|step| step.norm() < longest) {
            self.parameters -= step;
            longest = 0.5 * step.norm();
        }
        self
    }

    /// Fits the other parameters for a given roll-off.
    fn at(samples: &'s LogSamples, ln_q_r: f64) -> Self {
        let fall: Vec<f64> = samples.ln_q.iter().map(|ln_q| fall(ln_q - ln_q_r)).collect();
        let line = Line::through(&fall, &samples.ln_c);
        Self { samples, parameters: Vector3::new(line.intercept, -line.slope, ln_q_r) }
    }

    fn residual(&self, sample: usize) -> f64 {
        let [ln_plateau, exponent, ln_q_r] = self.parameters.into();
        ln_plateau - exponent * fall(self.samples.ln_q[sample] - ln_q_r) - self.samples.ln_c[sample]
    }

    fn derivatives(&self, sample: usize) -> [f64; 3] {
        let from_rolloff = self.samples.ln_q[sample] - self.parameters[2];
        [1.0, -fall(from_rolloff), self.parameters[1] * fall_slope(from_rolloff)]
    }

    /// Sum of the squared residuals; infinite if it overflows or is NaN.
    fn sum_of_squares(&self) -> f64 {
        let sum: f64 = (0..self.samples.len()).map(|sample| self.residual(sample).powi(2)).sum();
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    /// Computes (J^T J)^-1; `None` if the matrix is singular to working precision.
    fn inverse_normal(&self) -> Option<Matrix3<f64>> {
        let jacobian = self.jacobian()?;
        let normal = jacobian.tr_mul(&jacobian);
        let norms = normal.diagonal().map(f64::sqrt);
        let scales = norms * norms.transpose();
        let factor = normal.component_div(&scales).cholesky()?;
        let has_digits = factor.l_dirty().diagonal().iter().all(|pivot| *pivot >= SMALLEST_PIVOT);
        has_digits.then(|| factor.inverse().component_div(&scales))
    }
}

impl LeastSquaresProblem<f64, Dyn, U3> for RollOffModel<'_> {
    type ParameterStorage = Owned<f64, U3>;
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U3>;

    fn set_params(&mut self, parameters: &Vector3<f64>) {
        self.parameters = *parameters;
    }

    fn params(&self) -> Vector3<f64> {
        self.parameters
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_fn(self.samples.len(), |sample, _| self.residual(sample)))
    }

    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U3>> {
        let mut jacobian = OMatrix::<f64, Dyn, U3>::zeros(self.samples.len());
        for (sample, mut row) in jacobian.row_iter_mut().enumerate() {
            row.copy_from_slice(&self.derivatives(sample));
        }
        Some(jacobian)
    }
}

/// Computes ln(1 + (q/q_r)^2) from ln(q/q_r) without overflow.
fn fall(ln_q_over_q_r: f64) -> f64 {
    2.0 * ln_q_over_q_r.max(0.0) + (-2.0 * ln_q_over_q_r.abs()).exp().ln_1p()
}

/// Derivative of [`fall`].
fn fall_slope(ln_q_over_q_r: f64) -> f64 {
    2.0 / (1.0 + (-2.0 * ln_q_over_q_r).exp())
}
