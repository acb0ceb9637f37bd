//! The name of a decade of wavelengths.

use findings::features::DecadeShare;
use spectrum::ProfilePsd;
use units::display::length;

/// `10 µm to 1 µm`: a decade that the spectrum covers in part is told as far as the spectrum goes, and one that was not
/// measured as such.
pub(crate) fn name(decade: &DecadeShare, psd: &ProfilePsd) -> String {
    let begins_m = decade.longest_m.min(psd.longest_wavelength_m());
    let ends_m = decade.shortest_m.max(psd.shortest_wavelength_m());
    let measured = if decade.measured { "" } else { ", not measured" };
    format!("{} to {}{measured}", unbroken(begins_m), unbroken(ends_m))
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
        let told = |longest_m, measured| {
            name(&DecadeShare { longest_m, shortest_m: longest_m / 10.0, share: 0.5, measured }, &psd)
        };
        assert_eq!(told(1e-4, true), "40\u{a0}µm to 10\u{a0}µm");
        assert_eq!(told(1e-5, false), "10\u{a0}µm to 1.26\u{a0}µm, not measured");
    }
}
