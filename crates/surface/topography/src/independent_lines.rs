//! How many independent lines the lines of a map stand for: neighbours are alike at wavelengths beyond their distance.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// Bins in which it is measured. Beyond them a map of as many lines as points has far more than a hundred independent ones, whose
/// number hardly matters.
pub(crate) const FIRST_BINS: usize = 64;

/// The number for each of the first bins, from their values row by row, `bins` to a row; none where there are no rows.
///
/// Across the lines a bin is a sum of waves of independent random amplitudes, whose powers s add up to the mean over the lines.
/// Of M waves of equal expectation (Sum s)^2/Sum s^2 is about (M + 1)/2, as the square of an exponential number is twice that
/// of its mean: hence 2 (Sum s)^2/Sum s^2 - 1.
pub(crate) fn independent_lines(values: &[Complex<f64>], bins: usize) -> Vec<f64> {
    if values.is_empty() {
        return Vec::new();
    }
    let rows = values.len() / bins;
    let transform = FftPlanner::new().plan_fft_forward(rows);
    let mut across = vec![Complex::default(); rows];
    let of_bin = |bin: usize| {
        across.iter_mut().zip(values[bin..].iter().step_by(bins)).for_each(|(to, from)| *to = *from);
        transform.process(&mut across);
        let powers = || across.iter().map(Complex::norm_sqr);
        let (sum, squares) = (powers().sum::<f64>(), powers().map(|power| power * power).sum::<f64>());
        if squares > 0.0 { 2.0 * (sum * (sum / squares)) - 1.0 } else { 1.0 }
    };
    (0..bins).map(of_bin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of one wave across, or of several of equal power.
    fn rows(waves: &[usize], rows: usize) -> Vec<Complex<f64>> {
        let phase = |row: usize, wave: usize| {
            Complex::cis(std::f64::consts::TAU * ((row * wave) % rows) as f64 / rows as f64 + wave as f64)
        };
        (0..rows).map(|row| waves.iter().map(|&wave| phase(row, wave)).sum()).collect()
    }

    #[test]
    fn equal_waves_are_counted() {
        // Of powers that do not scatter the formula yields twice their number less one.
        assert!((independent_lines(&rows(&[3], 64), 1)[0] - 1.0).abs() < 1e-12);
        assert!((independent_lines(&rows(&[1, 5, 9, 20], 64), 1)[0] - 7.0).abs() < 1e-12);
        assert!(independent_lines(&[], 8).is_empty());
    }
}
