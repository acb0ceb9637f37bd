//! Student's distribution: how far the mean of few values may lie from what it estimates.

use rand_chacha::rand_core::Rng;
use rand_distr::{Distribution, StandardNormal};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// The half width of an interval of this probability in standard errors of the mean of n >= 2 values: the quantile of
/// Student's t of n - 1 degrees of freedom.
pub(crate) fn half_width(level: f64, values: usize) -> f64 {
    let freedom = values.saturating_sub(1).max(1) as f64;
    let quantile = |t: StudentsT| t.inverse_cdf(0.5 + 0.5 * level);
    StudentsT::new(0.0, 1.0, freedom).map_or(f64::INFINITY, quantile)
}

/// The same in standard deviations of a normal distribution.
pub(crate) fn normal_half_width(level: f64) -> f64 {
    Normal::standard().inverse_cdf(0.5 + 0.5 * level)
}

/// What normal deviates are multiplied by to become those of Student's t. The factors for all numbers of values are drawn
/// together, so that bins which more or fewer scans reach go together in a draw.
#[derive(Debug)]
pub(crate) struct StudentFactors {
    /// The sums of 1, 2, ... squares of normal deviates.
    sums: Vec<f64>,
}

impl StudentFactors {
    /// Those for up to so many values.
    pub fn draw(values: usize, numbers: &mut impl Rng) -> Self {
        let mut sum = 0.0;
        let mut next = || {
            let deviate: f64 = StandardNormal.sample(numbers);
            sum += deviate * deviate;
            sum
        };
        StudentFactors { sums: (1..values).map(|_| next()).collect() }
    }

    /// The factor for so many values, at least 2: sqrt((n - 1)/chi-squared of n - 1 degrees of freedom).
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

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (values, t) in [(2, 12.706_205), (3, 4.302_653), (6, 2.570_582), (31, 2.042_272)] {
            assert!((half_width(0.95, values) / t - 1.0).abs() < 1e-6, "{values}");
        }
        assert!((normal_half_width(0.95) - 1.959_964).abs() < 1e-6);
    }

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
