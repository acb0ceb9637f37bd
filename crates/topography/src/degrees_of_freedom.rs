//! How many independent squares of Gaussian numbers stand behind the mean of a spectrum in a bin, and by how much its logarithm
//! is too low for that.

use statrs::function::gamma::digamma;

use crate::window::Window;

/// Degrees of freedom n of the mean of so many Fourier bins (at least 1) over so many independent lines (at least 1): of
/// Gaussian heights n times that mean over its expectation is about chi-squared distributed with n degrees of freedom.
///
/// Each bin of each line brings two. Under a Hann window neighbouring bins share power, with a correlation of 4/9, and 1/36 the
/// ones after that, so that n = 2 K M/(1 + 2 (4/9 + 1/36)) of many bins, and no less than the 2 M of one (physics2.md, D1).
pub(crate) fn degrees_of_freedom(bins: usize, independent_lines: f64, window: Window) -> f64 {
    let shared = match window {
        Window::Hann => HANN,
        Window::None => 1.0,
    };
    2.0 * independent_lines * (bins as f64 / shared).max(1.0)
}

/// 1 + 2 (4/9 + 1/36).
const HANN: f64 = 35.0 / 18.0;

/// The mean of the logarithm of a mean of n > 0 degrees of freedom, less the logarithm of its expectation: psi(n/2) - ln(n/2),
/// -0.577 at n = 2 and about -1/n from 10 on.
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
    fn many_bins_count_as_half_of_them_under_a_hann_window() {
        assert!((degrees_of_freedom(70, 1.0, Window::Hann) - 72.0).abs() < 1e-12);
        assert_eq!(degrees_of_freedom(70, 3.0, Window::None), 420.0);
    }
}
