//! Degrees of freedom of the mean of a spectrum in a bin, and the bias of its logarithm.

use statrs::function::gamma::digamma;

use crate::preparation::Window;

/// Computes the degrees of freedom n of the mean of `bins` >= 1 Fourier bins over `independent_lines` >= 1 lines.
///
/// For Gaussian heights, n times that mean over its expectation is nearly chi-squared distributed with n degrees of
/// freedom. The first bin of each line contributes two. Under a Hann window the powers of neighbouring bins have a
/// correlation of 4/9, and of the next ones 1/36, so each further bin contributes 2/(1 + 2 (4/9 + 1/36)), the limit for
/// many bins. The resulting bias of the logarithm is within 0.008 of simulations with 1 to 12 neighbouring bins of a
/// white surface.
pub(crate) fn degrees_of_freedom(bins: usize, independent_lines: f64, window: Window) -> f64 {
    let shared = match window {
        Window::Hann => HANN,
        Window::None => 1.0,
    };
    2.0 * independent_lines * (1.0 + bins.saturating_sub(1) as f64 / shared)
}

/// Bins per independent bin under a Hann window, 1 + 2 (4/9 + 1/36).
const HANN: f64 = 35.0 / 18.0;

/// Computes the bias of the logarithm of a mean with n > 0 degrees of freedom, psi(n/2) - ln(n/2): -0.577 at n = 2,
/// about -1/n from n = 10 on.
pub(crate) fn bias_of_logarithm(degrees_of_freedom: f64) -> f64 {
    let half = 0.5 * degrees_of_freedom;
    digamma(half) - half.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bin_of_one_line_is_low_by_eulers_constant() {
        assert_eq!(degrees_of_freedom(1, 1.0, Window::Hann), 2.0);
        assert!((bias_of_logarithm(2.0) + 0.577_215_664_901_532_9).abs() < 1e-13);
        // psi(1/2) = -gamma - 2 ln 2; psi(5) = 25/12 - gamma.
        let of_one = -0.577_215_664_901_532_9 - 2.0 * 2f64.ln() - 0.5f64.ln();
        assert!((bias_of_logarithm(1.0) - of_one).abs() < 1e-13);
        let of_ten = 25.0 / 12.0 - 0.577_215_664_901_532_9 - 5f64.ln();
        assert!((bias_of_logarithm(10.0) - of_ten).abs() < 1e-13);
        assert!((bias_of_logarithm(1e6) + 1e-6).abs() < 1e-11);
    }

    #[test]
    fn further_bins_count_as_half_of_them_under_a_hann_window() {
        assert!((degrees_of_freedom(71, 1.0, Window::Hann) - 74.0).abs() < 1e-12);
        assert_eq!(degrees_of_freedom(70, 3.0, Window::None), 420.0);
    }

    #[test]
    fn few_bins_under_a_hann_window_are_as_low_as_random_numbers_say() {
        // Means over a million of white Gaussian lines and more, to 0.001.
        for (bins, bias) in
            [(2, -0.3578), (3, -0.2634), (4, -0.2095), (6, -0.1489), (8, -0.1139), (12, -0.0769)]
        {
            let found = bias_of_logarithm(degrees_of_freedom(bins, 1.0, Window::Hann));
            assert!((found - bias).abs() < 0.009, "{bins}: {found}");
        }
    }
}
