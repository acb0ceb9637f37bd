//! Means over a few surfaces, and their standard errors.

/// Half the width of the interval that holds 95 % of Student's distribution, over that of the normal one, by degrees
/// of freedom from 1 on.
const STUDENT_OVER_NORMAL: [f64; 15] = [
    6.4829, 2.1953, 1.6237, 1.4166, 1.3116, 1.2485, 1.2065, 1.1766, 1.1542, 1.1368, 1.1230, 1.1117, 1.1023,
    1.0943, 1.0875,
];

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
        let count = values.clone().count() as f64;
        let value = values.clone().sum::<f64>() / count;
        let squares: f64 = values.map(|one| (one - value) * (one - value)).sum();
        let freedom = count as usize - 1;
        let standard_error = match freedom {
            0 => f64::INFINITY,
            _ => wider(freedom) * (squares / freedom as f64 / count).sqrt(),
        };
        Mean { value, standard_error }
    }
}

fn wider(freedom: usize) -> f64 {
    STUDENT_OVER_NORMAL.get(freedom - 1).copied().unwrap_or(1.0 + 1.3 / freedom as f64)
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
        assert!((wider(16) / (2.1199 / 1.95996) - 1.0).abs() < 2e-3);
    }
}
