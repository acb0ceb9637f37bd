//! Polynomials whose coefficients come in fours, lowest power first, evaluated as four independent sums over every
//! fourth power.

/// Evaluates a polynomial at t.
#[inline(always)]
pub(crate) fn value(coefficients: &[f64], t: f64) -> f64 {
    let (square, fourth) = (t * t, t * t * (t * t));
    let mut sums = [0.0; 4];
    for four in coefficients.as_chunks::<4>().0.iter().rev() {
        for (sum, coefficient) in sums.iter_mut().zip(four) {
            *sum = *sum * fourth + coefficient;
        }
    }
    (sums[0] + t * sums[1]) + square * (sums[2] + t * sums[3])
}

/// Evaluates a polynomial and its derivative at t.
#[inline(always)]
pub(crate) fn value_and_slope(coefficients: &[f64], t: f64) -> (f64, f64) {
    let (square, fourth) = (t * t, t * t * (t * t));
    let (mut sums, mut slopes) = ([0.0; 4], [0.0; 4]);
    for four in coefficients.as_chunks::<4>().0.iter().rev() {
        for ((sum, slope), coefficient) in sums.iter_mut().zip(&mut slopes).zip(four) {
            *slope = *slope * fourth + *sum;
            *sum = *sum * fourth + coefficient;
        }
    }
    let value = (sums[0] + t * sums[1]) + square * (sums[2] + t * sums[3]);
    let by_fourth = (slopes[0] + t * slopes[1]) + square * (slopes[2] + t * slopes[3]);
    let of_the_powers = sums[1] + t * (2.0 * sums[2] + 3.0 * t * sums[3]);
    (value, of_the_powers + 4.0 * square * t * by_fourth)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn value_and_slope_are_those_of_the_polynomial() {
        // (1 + t)^7, whose derivative is 7 (1 + t)^6.
        let coefficients = [1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0];
        for t in [-0.5, 0.0, 0.25, 1.0f64] {
            let (exact, slope) = ((1.0 + t).powi(7), 7.0 * (1.0 + t).powi(6));
            let found = value_and_slope(&coefficients, t);
            assert!((found.0 / exact - 1.0).abs() < 1e-14 && (found.1 / slope - 1.0).abs() < 1e-14, "{t}");
            assert_eq!(value(&coefficients, t), found.0);
        }
    }
}
