//! The name of a decade of wavelengths.

use spectrum::ProfilePsd;
use units::display::length;

/// `10 µm to 1 µm`: a decade that the spectrum covers in part is told as far as the spectrum goes.
pub(crate) fn name(longest_m: f64, shortest_m: f64, psd: &ProfilePsd) -> String {
    let begins_m = longest_m.min(psd.longest_wavelength_m());
    let ends_m = shortest_m.max(psd.shortest_wavelength_m());
    format!("{} to {}", unbroken(begins_m), unbroken(ends_m))
}

/// A length that stays on its line.
fn unbroken(length_m: f64) -> String {
    length(length_m).replace(' ', "\u{a0}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decade_is_told_as_far_as_the_spectrum_goes() {
        let psd = ProfilePsd::new(vec![4e-5, 1.26e-6], vec![1e-20, 1e-24]).unwrap();
        assert_eq!(name(1e-4, 1e-5, &psd), "40\u{a0}µm to 10\u{a0}µm");
        assert_eq!(name(1e-5, 1e-6, &psd), "10\u{a0}µm to 1.26\u{a0}µm");
    }
}
