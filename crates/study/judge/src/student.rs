//! How much wider Student's distribution is than the normal one.

/// Student's t at 97.5 % for 1, 2, ... degrees of freedom (Student 1908, Biometrika 6:1).
const T_975: [f64; 15] = [
    12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
];
/// The same of the normal distribution.
const NORMAL_975: f64 = 1.960;

/// The factor by which the error of a mean of so many values (at least 2) is widened so that twice of it covers 95 %.
pub(crate) fn widening(values: usize) -> f64 {
    let freedom = values.saturating_sub(1).max(1);
    match T_975.get(freedom - 1) {
        Some(t) => t / NORMAL_975,
        // Cornish & Fisher's expansion to second order, exact to a thousandth from here on.
        None => {
            let (square, inverse) = (NORMAL_975 * NORMAL_975, (freedom as f64).recip());
            let first = (square + 1.0) / 4.0;
            let second = ((5.0 * square + 16.0) * square + 3.0) / 96.0;
            1.0 + inverse * (first + inverse * second)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::widening;

    #[test]
    fn it_falls_to_one_without_a_step() {
        let factors: Vec<f64> = (2..40).map(widening).collect();
        assert!(factors.windows(2).all(|pair| pair[1] < pair[0] && pair[1] > 1.0));
        assert!((widening(16) - widening(17)).abs() < 0.01);
    }
}
