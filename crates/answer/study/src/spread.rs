//! Uncertainties of quantities: distributions about a centre, in SI units. A plain run takes the centre.

use std::f64::consts::LN_2;

use numerics::zero_in_bracket;
use statrs::function::beta::beta_reg;
use units::display::three_digits;
use units::{Bound, OutOfBounds, number};

/// The uncertainty of a quantity, as a distribution.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// Its logarithm is normal: never negative.
    LogNormal {
        /// The median.
        median: f64,
        /// Standard deviation of the logarithm.
        sigma_ln: f64,
    },
    /// A Poisson's ratio: twice it follows the beta distribution, which has a single peak.
    Beta {
        /// The median, of the ratio.
        median: f64,
        /// First shape, at least 1.
        alpha: f64,
        /// Second shape, at least 1.
        beta: f64,
    },
    /// Anything between two ends, each as likely.
    Uniform {
        /// The lower end.
        from: f64,
        /// The upper end, above it.
        to: f64,
    },
    /// Measured values in rising order, not all equal, each equally likely.
    Values(Vec<f64>),
}

/// Why there is no such spread.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpreadError {
    /// A number beyond its bound.
    #[error(transparent)]
    OutOfBounds(#[from] OutOfBounds),
    /// An interval that does not rise.
    #[error("the interval begins at {} and ends at {}, which is less; the smaller value stands first", number(*from), number(*to))]
    NotRising {
        /// Its first end, in SI units.
        from: f64,
        /// Its last end.
        to: f64,
    },
    /// A Poisson's ratio so uncertain that small and large values are likelier than those between.
    #[error(
        "the standard uncertainty of Poisson's ratio is {}; about a median of {} it must be from 0 to {}, beyond which no beta \
         distribution on (0, 0.5) has a single peak; give less, or {{ distribution = \"uniform\", ... }}",
        three_digits(*standard_uncertainty),
        number(*median),
        three_digits(*most)
    )]
    NoSinglePeak {
        /// The median.
        median: f64,
        /// The given standard uncertainty.
        standard_uncertainty: f64,
        /// The largest with a single peak.
        most: f64,
    },
    /// No values to draw from.
    #[error("there are no values to draw from; give at least one")]
    NoValues,
}

/// The upper limit of Poisson's ratio: an incompressible body.
pub const LARGEST_POISSON_RATIO: f64 = 0.5;

/// The standard normal quantile of 97.5 %: the central 95 % reach so many standard deviations either way.
const CENTRAL_95: f64 = 1.959_963_984_540_054;

/// The range of centres, in SI units: no draw from a spread leaves the range of magnitudes that laws take.
const CENTRE: Bound = Bound::Within { at_least: 1e-20, at_most: 1e20 };

/// A standard uncertainty over its value. Above the bound, only the order of magnitude would be known.
const RELATIVE: Bound = Bound::Within { at_least: 0.0, at_most: 10.0 };

/// The upper end of an interval over its lower one.
const END_OVER_BEGINNING: Bound = Bound::Within { at_least: 1.0, at_most: 1000.0 };

/// A Poisson's ratio about which others scatter on (0, 0.5).
const RATIO: Bound = Bound::Within { at_least: 1e-6, at_most: 0.499999 };

impl Spread {
    /// Creates a log-normal quantity > 0 with this median and standard deviation; `None` if the deviation is within
    /// rounding.
    ///
    /// # Errors
    /// [`SpreadError::OutOfBounds`] for a median or a relative standard uncertainty beyond its bound.
    pub fn log_normal(median: f64, standard_uncertainty: f64) -> Result<Option<Self>, SpreadError> {
        CENTRE.check("what scatters, in SI units,", median)?;
        let relative =
            RELATIVE.check("the standard uncertainty over its value", standard_uncertainty / median)?;
        // With w = exp(s^2) - 1 the relative variance is w (w + 1), which is solved for w without cancellation.
        let square = relative * relative;
        let w = 2.0 * square / (1.0 + (1.0 + 4.0 * square).sqrt());
        let sigma_ln = w.ln_1p().sqrt();
        Ok((relative > f64::EPSILON).then_some(Spread::LogNormal { median, sigma_ln }))
    }

    /// Creates a log-normal quantity > 0 whose central 95 % are this interval. Returns its geometric mean and its
    /// spread.
    ///
    /// # Errors
    /// [`SpreadError`] for an interval that does not rise, or is too wide.
    pub fn log_normal_within(from: f64, to: f64) -> Result<(f64, Option<Self>), SpreadError> {
        let (from, to) = rising(from, to)?;
        CENTRE.check("what scatters, in SI units,", from)?;
        CENTRE.check("what scatters, in SI units,", to)?;
        let ratio = END_OVER_BEGINNING.check("the end of the interval over its beginning", to / from)?;
        let median = if ratio == 1.0 { from } else { (from * to).sqrt() };
        let sigma_ln = ratio.ln() / (2.0 * CENTRAL_95);
        Ok((median, (sigma_ln > f64::EPSILON).then_some(Spread::LogNormal { median, sigma_ln })))
    }

    /// Creates a Poisson's ratio with this median and standard deviation on (0, 0.5); `None` if the deviation is within
    /// rounding.
    ///
    /// # Errors
    /// [`SpreadError`] for a median outside (0, 0.5), and for a standard uncertainty beyond what a single peak allows.
    pub fn poisson_ratio(median: f64, standard_uncertainty: f64) -> Result<Option<Self>, SpreadError> {
        RATIO.check("a Poisson's ratio that scatters", median)?;
        Bound::AtLeast(0.0).check("the standard uncertainty of Poisson's ratio", standard_uncertainty)?;
        if standard_uncertainty <= f64::EPSILON * median {
            return Ok(None);
        }
        let shapes = shapes_of(median / LARGEST_POISSON_RATIO, standard_uncertainty / LARGEST_POISSON_RATIO);
        let (alpha, beta) = shapes.map_err(|most| SpreadError::NoSinglePeak {
            median,
            standard_uncertainty,
            most: LARGEST_POISSON_RATIO * most,
        })?;
        Ok(Some(Spread::Beta { median, alpha, beta }))
    }

    /// Returns the middle and the spread of a Poisson's ratio given by an interval of 1.96 standard deviations either
    /// way. The interval holds the central 95 %, up to 97 % if it is wide.
    ///
    /// # Errors
    /// Returns the errors of [`poisson_ratio`](Self::poisson_ratio), and an error for an interval that does not rise.
    pub fn poisson_ratio_within(from: f64, to: f64) -> Result<(f64, Option<Self>), SpreadError> {
        let (from, to) = rising(from, to)?;
        let middle = 0.5 * (from + to);
        Ok((middle, Self::poisson_ratio(middle, (to - from) / (2.0 * CENTRAL_95))?))
    }

    /// Anything from one value to another: the middle, and how it scatters.
    ///
    /// # Errors
    /// [`SpreadError::NotRising`] for the larger value first.
    pub fn uniform(from: f64, to: f64) -> Result<(f64, Option<Self>), SpreadError> {
        let (from, to) = rising(from, to)?;
        Ok((0.5 * (from + to), (from < to).then_some(Spread::Uniform { from, to })))
    }

    /// Returns the median of measured values, and their spread.
    ///
    /// # Errors
    /// [`SpreadError::NoValues`] without values.
    pub fn values(mut values: Vec<f64>) -> Result<(f64, Option<Self>), SpreadError> {
        values.sort_by(f64::total_cmp);
        let (Some(first), Some(last)) = (values.first(), values.last()) else {
            return Err(SpreadError::NoValues);
        };
        if first == last {
            return Ok((*first, None));
        }
        Ok((median_of_sorted(&values), Some(Spread::Values(values))))
    }

    /// Returns the value that a plain run takes: the median.
    #[must_use]
    pub fn centre(&self) -> f64 {
        match self {
            Spread::LogNormal { median, .. } | Spread::Beta { median, .. } => *median,
            Spread::Uniform { from, to } => 0.5 * (from + to),
            Spread::Values(values) => median_of_sorted(values),
        }
    }

    /// Its standard deviation.
    #[must_use]
    pub fn standard_uncertainty(&self) -> f64 {
        match self {
            Spread::LogNormal { median, sigma_ln } => {
                let square = sigma_ln * sigma_ln;
                median * (square.exp() * square.exp_m1()).sqrt()
            }
            Spread::Beta { alpha, beta, .. } => LARGEST_POISSON_RATIO * standard_deviation(*alpha, *beta),
            Spread::Uniform { from, to } => (to - from) / 12f64.sqrt(),
            Spread::Values(values) => {
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
                (squares / values.len() as f64).sqrt()
            }
        }
    }

    /// Returns the distribution of the quantity over its centre. A Poisson's ratio is returned unchanged, because no
    /// caller needs its distribution.
    #[must_use]
    pub fn over_its_centre(self) -> Self {
        let centre = self.centre();
        match self {
            Spread::LogNormal { sigma_ln, .. } => Spread::LogNormal { median: 1.0, sigma_ln },
            Spread::Uniform { from, to } => Spread::Uniform { from: from / centre, to: to / centre },
            Spread::Values(values) => {
                Spread::Values(values.into_iter().map(|value| value / centre).collect())
            }
            Spread::Beta { .. } => self,
        }
    }

    /// The name of the distribution.
    #[must_use]
    pub fn distribution(&self) -> &'static str {
        match self {
            Spread::LogNormal { .. } => "log-normal",
            Spread::Beta { .. } => "beta",
            Spread::Uniform { .. } => "uniform",
            Spread::Values(_) => "values",
        }
    }
}

fn rising(from: f64, to: f64) -> Result<(f64, f64), SpreadError> {
    if from <= to { Ok((from, to)) } else { Err(SpreadError::NotRising { from, to }) }
}

/// Returns the middle value, or the mean of the middle two; 0 without values.
fn median_of_sorted(values: &[f64]) -> f64 {
    let upper = values.len() / 2;
    let lower = values.len().saturating_sub(1) / 2;
    let at = |index: usize| values.get(index).copied().unwrap_or_default();
    0.5 * (at(lower) + at(upper))
}

/// Finds the shapes of the beta distribution on (0, 1) with this median and standard deviation and a single peak. If
/// there is none, returns the largest standard deviation that has one as the error.
///
/// At a given median a larger sum of the shapes makes the distribution narrower. The widest distribution with a single
/// peak has one shape of 1, and its median has a closed form.
fn shapes_of(median: f64, deviation: f64) -> Result<(f64, f64), f64> {
    if median > 0.5 {
        return shapes_of(1.0 - median, deviation).map(|(alpha, beta)| (beta, alpha));
    }
    let widest = (1.0, LN_2 / -(-median).ln_1p());
    let most = standard_deviation(widest.0, widest.1);
    if deviation > most {
        return Err(most);
    }
    let too_wide = |ln_sum: f64| {
        let (alpha, beta) = shapes_of_median(median, ln_sum.exp());
        standard_deviation(alpha, beta) / deviation - 1.0
    };
    let (least, largest) = ((widest.0 + widest.1).ln(), LARGEST_SUM.ln());
    if too_wide(least) <= 0.0 {
        return Ok(widest);
    }
    Ok(shapes_of_median(median, zero_in_bracket(least, largest, too_wide).exp()))
}

/// The largest sum of the shapes; beyond it the standard deviation is below rounding at every median.
const LARGEST_SUM: f64 = 1e40;

fn standard_deviation(alpha: f64, beta: f64) -> f64 {
    let sum = alpha + beta;
    (alpha / sum * (beta / sum) / (sum + 1.0)).sqrt()
}

/// The shapes of this sum whose median, at most 0.5, is the one given.
///
/// For large shapes the median is (alpha - 1/3)/(alpha + beta - 2/3) (Kerman 2011, arXiv:1111.0433), from 1000 on
/// within 1e-6 of the standard deviation. There the incomplete beta function loses its digits; below 1000 it has at
/// least eight.
fn shapes_of_median(median: f64, sum: f64) -> (f64, f64) {
    const LARGE: f64 = 1000.0;
    let alpha = median * (sum - 2.0 / 3.0) + 1.0 / 3.0;
    if alpha >= LARGE {
        return (alpha, sum - alpha);
    }
    let above_half = |alpha: f64| beta_reg(alpha, sum - alpha, median) - 0.5;
    let alpha = zero_in_bracket(0.5, (0.5 * sum).min(2.0 * LARGE), above_half);
    (alpha, sum - alpha)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn log_normal(median: f64, standard_uncertainty: f64) -> Spread {
        Spread::log_normal(median, standard_uncertainty).unwrap().unwrap()
    }

    #[test]
    fn a_log_normal_has_its_median_and_its_standard_deviation() {
        for relative in [1e-9, 1e-3, 0.02, 0.3, 2.0, 10.0] {
            let spread = log_normal(210e9, relative * 210e9);
            assert_eq!(spread.centre(), 210e9);
            assert!((spread.standard_uncertainty() / (relative * 210e9) - 1.0).abs() < 1e-13, "{relative}");
        }
        let Spread::LogNormal { sigma_ln, .. } = log_normal(1.0, 0.1) else { panic!() };
        // v (v - 1) = 0.01 has v = (1 + sqrt(1.04))/2.
        assert!((sigma_ln - ((1.0 + 1.04f64.sqrt()) / 2.0).ln().sqrt()).abs() < 1e-15);
        assert_eq!(Spread::log_normal(210e9, 0.0), Ok(None));
        assert_eq!(Spread::log_normal(210e9, 1e-300), Ok(None));
    }

    #[test]
    fn an_interval_holds_the_central_95_per_cent_about_its_geometric_mean() {
        let (centre, spread) = Spread::log_normal_within(0.8e9, 1.2e9).unwrap();
        assert_eq!(centre, (0.8e9 * 1.2e9f64).sqrt());
        let Some(Spread::LogNormal { median, sigma_ln }) = spread else { panic!() };
        assert_eq!(median, centre);
        assert!((median * (1.959964 * sigma_ln).exp() / 1.2e9 - 1.0).abs() < 1e-8);
        assert_eq!(Spread::log_normal_within(1e9, 1e9), Ok((1e9, None)));
    }

    #[test]
    fn a_poisson_ratio_has_its_median_its_standard_deviation_and_a_single_peak() {
        for (median, uncertainty) in [
            (0.3, 0.02),
            (0.3, 1e-6),
            (0.25, 0.14),
            (0.25, 0.25 / 3f64.sqrt() * (1.0 - 1e-15)),
            (0.05, 0.04),
            (0.49, 0.009),
            (0.4999, 0.00005),
            (1e-6, 1e-6),
            (0.3, 1e-12),
        ] {
            let spread = Spread::poisson_ratio(median, uncertainty).unwrap().unwrap();
            let Spread::Beta { alpha, beta, .. } = spread else { panic!() };
            assert!(alpha >= 1.0 - 1e-12 && beta >= 1.0 - 1e-12, "{median} {uncertainty}: {alpha} {beta}");
            assert_eq!(spread.centre(), median);
            assert!(
                (spread.standard_uncertainty() / uncertainty - 1.0).abs() < 1e-9,
                "{median} {uncertainty}"
            );
            if alpha + beta < 1e5 {
                let below = beta_reg(alpha, beta, 2.0 * median);
                assert!((below - 0.5).abs() < 1e-6, "{median} {uncertainty}: {below}");
            }
        }
        assert_eq!(Spread::poisson_ratio(0.3, 0.0), Ok(None));
    }

    #[test]
    fn the_incomplete_beta_function_has_the_digits_that_shapes_need() {
        // Medians with 30 digits from mpmath, rounded.
        for (alpha, beta, x, expected) in [
            (2.0, 3.0, 0.385_727_568_132_389_5, 0.5),
            (6.0, 4.0, 0.606_915_167_189_370_4, 0.5),
            (30.0, 20.0, 0.601_343_653_736_781_7, 0.5),
            (300.0, 200.0, 0.600_133_437_285_883_9, 0.5),
        ] {
            assert!((beta_reg(alpha, beta, x) - expected).abs() < 1e-12, "{alpha} {beta}");
        }
    }

    #[test]
    fn an_interval_of_poisson_ratios_holds_95_to_97_per_cent() {
        for (from, to) in [(0.25, 0.35), (0.05, 0.45), (0.4, 0.48)] {
            let (centre, spread) = Spread::poisson_ratio_within(from, to).unwrap();
            assert_eq!(centre, 0.5 * (from + to));
            let Some(Spread::Beta { alpha, beta, .. }) = spread else { panic!() };
            let held = beta_reg(alpha, beta, 2.0 * to) - beta_reg(alpha, beta, 2.0 * from);
            assert!((0.945..0.975).contains(&held), "{from} to {to}: {held}");
        }
    }

    #[test]
    fn what_is_beyond_its_bound_is_refused_with_value_and_bound() {
        let told = |spread: Result<Option<Spread>, SpreadError>| spread.unwrap_err().to_string();
        assert_eq!(
            told(Spread::log_normal(1e9, -1e8)),
            "the standard uncertainty over its value is -0.1; it must be from 0 to 10"
        );
        assert!(told(Spread::log_normal(1e9, f64::INFINITY)).ends_with("it must be from 0 to 10"));
        assert!(told(Spread::log_normal(1e21, 1e20)).ends_with("it must be from 1e-20 to 1e20"));
        let told = |spread: Result<(f64, Option<Spread>), SpreadError>| spread.unwrap_err().to_string();
        assert_eq!(
            told(Spread::log_normal_within(1.2e9, 0.8e9)),
            "the interval begins at 1200000000 and ends at 800000000, which is less; the smaller value stands first"
        );
        assert_eq!(
            told(Spread::log_normal_within(1.0, 1001.0)),
            "the end of the interval over its beginning is 1001; it must be from 1 to 1000"
        );
        assert_eq!(
            told(
                Spread::poisson_ratio_within(0.0, 0.5)
                    .and(Spread::poisson_ratio(0.25, 0.2).map(|s| (0.0, s)))
            ),
            "the standard uncertainty of Poisson's ratio is 0.2; about a median of 0.25 it must be from 0 to 0.144, beyond \
             which no beta distribution on (0, 0.5) has a single peak; give less, or { distribution = \"uniform\", ... }"
        );
        assert!(told(Spread::values(Vec::new())).contains("at least one"));
        for median in [0.0, 0.5, -0.2, f64::NAN] {
            assert!(matches!(Spread::poisson_ratio(median, 0.01), Err(SpreadError::OutOfBounds(_))));
        }
    }

    #[test]
    fn a_plain_run_takes_the_median_of_what_was_given() {
        assert_eq!(Spread::uniform(0.8e9, 1.2e9).unwrap().0, 1e9);
        assert_eq!(Spread::uniform(1e9, 1e9).unwrap(), (1e9, None));
        assert_eq!(Spread::values(vec![3.0, 1.0, 2.0]).unwrap().0, 2.0);
        let (centre, spread) = Spread::values(vec![4.0, 1.0, 2.0, 3.0]).unwrap();
        assert_eq!((centre, spread.as_ref().map(Spread::centre)), (2.5, Some(2.5)));
        assert_eq!(Spread::values(vec![2.0, 2.0]).unwrap(), (2.0, None));
        let relative = spread.unwrap().over_its_centre();
        assert_eq!(relative, Spread::Values(vec![0.4, 0.8, 1.2, 1.6]));
        assert!((relative.standard_uncertainty() - 1.25f64.sqrt() / 2.5).abs() < 1e-15);
    }
}
