//! Draws from Student's t distribution for several numbers of values at once.

use chacha20::rand_core::Rng;
use rand_distr::{Distribution, StandardNormal};

/// Factors that turn normal deviates into deviates of Student's t. The factors for all numbers of values are drawn together,
/// so that bins reached by different numbers of scans stay correlated within a draw.
#[derive(Debug)]
pub(crate) struct StudentFactors {
    /// The sums of 1, 2, ... squares of normal deviates.
    sums: Vec<f64>,
}

impl StudentFactors {
    /// Draws the factors for up to `values` values.
    pub fn draw(values: usize, numbers: &mut impl Rng) -> Self {
        let mut sum = 0.0;
        let mut next = || {
            let deviate: f64 = StandardNormal.sample(numbers);
            sum += deviate * deviate;
            sum
        };
        StudentFactors { sums: (1..values).map(|_| next()).collect() }
    }

    /// The factor for `values` >= 2 values: sqrt((n - 1)/chi-squared of n - 1 degrees of freedom).
    pub fn of(&self, values: usize) -> f64 {
        let freedom = values - 1;
        (freedom as f64 / self.sums[freedom - 1]).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::group::Group;
    use crate::random::Streams;
    use study::student::half_width;

    #[test]
    fn deviates_with_their_factor_follow_students_distribution() {
        for values in [2, 3, 6] {
            let within = (0..20_000).filter(|&draw| {
                let mut numbers = Streams::new(7).of(Group::Scans, draw);
                let factors = StudentFactors::draw(values, &mut numbers);
                let deviate: f64 = StandardNormal.sample(&mut numbers);
                (deviate * factors.of(values)).abs() < half_width(0.95, values)
            });
            let share = within.count() as f64 / 20_000.0;
            // Three standard errors of a share of 0.95 among 20,000.
            assert!((share - 0.95).abs() < 0.0047, "{values}: {share}");
        }
    }
}
