//! Means over a few surfaces, and their standard errors.

use study::student::widening;

/// Mean over some surfaces and its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// Mean value.
    pub value: f64,
    /// Standard error t s/sqrt(n), with t the factor by which Student's distribution is wider than the normal one at
    /// 95 %, so that twice this covers 95 %; infinite for a single value.
    pub standard_error: f64,
}

impl Mean {
    /// Computes the mean of values.
    #[must_use]
    pub fn new(values: impl Iterator<Item = f64> + Clone) -> Self {
        let count = values.clone().count();
        let value = values.clone().sum::<f64>() / count as f64;
        let squares: f64 = values.map(|one| (one - value) * (one - value)).sum();
        let standard_error = match count {
            1 => f64::INFINITY,
            _ => widening(count) * (squares / (count - 1) as f64 / count as f64).sqrt(),
        };
        Mean { value, standard_error }
    }
}

/// Computes the mean of values and its relative standard error s/(sqrt(n) mean), of few values not widened.
#[must_use]
pub fn mean_and_relative_error(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let values: Vec<f64> = values.collect();
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (mean, (squares / (count * (count - 1.0))).sqrt() / mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_values_are_trusted_less() {
        let mean = Mean::new([1.0, 2.0, 3.0].into_iter());
        assert_eq!(mean.value, 2.0);
        // Student's t of 2 degrees of freedom is 4.3027, that of the normal distribution 1.95996.
        assert!((mean.standard_error - 4.3027 / 1.95996 / 3f64.sqrt()).abs() < 1e-4);
        assert_eq!(Mean::new([1.0].into_iter()).standard_error, f64::INFINITY);
        let (mean, error) = mean_and_relative_error([1.0, 2.0, 3.0].into_iter());
        assert!(mean == 2.0 && (error - 0.5 / 3f64.sqrt()).abs() < 1e-15);
    }
}
