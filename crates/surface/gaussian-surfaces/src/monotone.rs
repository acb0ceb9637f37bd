//! Isotonic regression.

/// Finds the non-rising sequence nearest to `values` in the sum of squares by pooling adjacent violators into their
/// mean (Barlow, Bartholomew, Bremner & Brunk 1972, section 1.2).
pub(crate) fn not_rising(values: &[f64]) -> Vec<f64> {
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for &value in values {
        let (mut mean, mut count) = (value, 1);
        while let Some((before, members)) = pools.pop_if(|(before, _)| *before < mean) {
            mean = (before * members as f64 + mean * count as f64) / (members + count) as f64;
            count += members;
        }
        pools.push((mean, count));
    }
    pools.into_iter().flat_map(|(mean, count)| std::iter::repeat_n(mean, count)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn falling_values_are_kept_and_rising_ones_pooled() {
        assert_eq!(not_rising(&[5.0, 4.0, 4.0, -1.0]), [5.0, 4.0, 4.0, -1.0]);
        assert_eq!(not_rising(&[1.0, 3.0, 2.0]), [2.0, 2.0, 2.0]);
        assert_eq!(not_rising(&[5.0, 1.0, 3.0, 0.0]), [5.0, 2.0, 2.0, 0.0]);
        assert_eq!(not_rising(&[]), [0.0; 0]);
    }

    #[test]
    fn no_other_sequence_of_its_kind_is_nearer() {
        let values = [3.0, 5.0, 1.0, 2.0, 2.5, -1.0, 0.0];
        let distance = |of: &[f64]| -> f64 { of.iter().zip(values).map(|(a, b)| (a - b).powi(2)).sum() };
        let nearest = not_rising(&values);
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
