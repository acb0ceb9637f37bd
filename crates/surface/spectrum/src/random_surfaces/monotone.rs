//! Isotonic regression.

/// A run of values, of the same level in the non-rising sequence nearest to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pool {
    pub start: usize,
    pub end: usize,
    pub level: f64,
}

/// Finds the non-rising sequence nearest to `values` in the weighted sum of squares by pooling adjacent violators into
/// their weighted mean (Barlow, Bartholomew, Bremner & Brunk 1972, section 1.2). It keeps the weighted sum. Weights are
/// positive.
pub(crate) fn not_rising(values: &[f64], weights: &[f64]) -> Vec<Pool> {
    let mut pools: Vec<(f64, f64, usize)> = Vec::new();
    for (&value, &weight) in values.iter().zip(weights) {
        let (mut mean, mut weight, mut count) = (value, weight, 1);
        while let Some((before, heavy, members)) = pools.pop_if(|(before, ..)| *before < mean) {
            mean = (before * heavy + mean * weight) / (heavy + weight);
            weight += heavy;
            count += members;
        }
        pools.push((mean, weight, count));
    }
    let mut end = 0;
    let pool = |(level, _, members)| {
        end += members;
        Pool { start: end - members, end, level }
    };
    pools.into_iter().map(pool).collect()
}

#[cfg(test)]
mod tests {
    fn not_rising(values: &[f64], weights: &[f64]) -> Vec<f64> {
        let pools = super::not_rising(values, weights);
        pools.iter().flat_map(|pool| std::iter::repeat_n(pool.level, pool.end - pool.start)).collect()
    }

    #[test]
    fn falling_values_are_kept_and_rising_ones_pooled() {
        assert_eq!(not_rising(&[5.0, 4.0, 4.0, -1.0], &[1.0; 4]), [5.0, 4.0, 4.0, -1.0]);
        assert_eq!(not_rising(&[1.0, 3.0, 2.0], &[1.0; 3]), [2.0, 2.0, 2.0]);
        assert_eq!(not_rising(&[5.0, 1.0, 3.0, 0.0], &[1.0, 3.0, 1.0, 1.0]), [5.0, 1.5, 1.5, 0.0]);
        assert_eq!(not_rising(&[], &[]), [0.0; 0]);
    }

    #[test]
    fn no_other_sequence_of_its_kind_is_nearer() {
        let values = [3.0, 5.0, 1.0, 2.0, 2.5, -1.0, 0.0];
        let weights = [1.0, 0.5, 2.0, 1.0, 3.0, 1.0, 0.1];
        let distance = |of: &[f64]| -> f64 {
            of.iter().zip(values).zip(weights).map(|((a, b), weight)| weight * (a - b).powi(2)).sum()
        };
        let nearest = not_rising(&values, &weights);
        assert!(nearest.is_sorted_by(|a, b| a >= b));
        for moved in 0..values.len() {
            for step in [-1e-3, 1e-3] {
                let mut other = nearest.clone();
                other[moved] += step;
                if other.is_sorted_by(|a, b| a >= b) {
                    assert!(distance(&other) > distance(&nearest));
                }
            }
        }
    }
}
