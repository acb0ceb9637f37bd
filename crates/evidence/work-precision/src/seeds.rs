//! Computations repeated with several seeds: their results, cost and scatter.

use crate::processes::own_processor_s;

/// Returns the results with the seeds from 1 on, and the mean processor time \[s\] of one.
///
/// # Errors
/// The error of the first computation that fails, or a message if the system does not report times.
pub fn with_seeds<T>(
    seeds: u64,
    compute: impl FnMut(u64) -> Result<T, String>,
) -> Result<(Vec<T>, f64), String> {
    let start_s = own_processor_s()?;
    let found = (1..=seeds).map(compute).collect::<Result<Vec<T>, String>>()?;
    Ok((found, (own_processor_s()? - start_s) / seeds as f64))
}

/// Mean of some numbers.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Root mean square of some numbers.
pub fn root_mean_square(values: &[f64]) -> f64 {
    mean(&values.iter().map(|value| value * value).collect::<Vec<f64>>()).sqrt()
}

/// Standard deviation of a sample of two or more.
pub fn standard_deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / (values.len() - 1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_of_two_scatters_by_half_its_distance_times_root_two() {
        let (found, seconds) = with_seeds(2, |seed| Ok(seed as f64)).unwrap();
        assert_eq!((mean(&found), seconds >= 0.0), (1.5, true));
        assert!((standard_deviation(&found) - 0.5f64.sqrt()).abs() < 1e-15);
        assert!((root_mean_square(&found) - 2.5f64.sqrt()).abs() < 1e-15);
        assert_eq!(with_seeds::<f64>(2, |seed| Err(format!("seed {seed}"))).unwrap_err(), "seed 1");
    }
}
