//! The spectrum of the sum of two surfaces.

use serde::Serialize;

use crate::profile::ProfilePsd;
use crate::random_surfaces::AreaSpectrum;

/// The spectrum of the sum, or the difference, of two uncorrelated surfaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Superposition {
    /// The spectrum at the wavelengths of both.
    pub psd: ProfilePsd,
    /// Longest and shortest wavelength \[m\] that both cover; `None` if they share none.
    pub shared_m: Option<[f64; 2]>,
}

/// Adds the spectra of two uncorrelated surfaces: C = C_a + C_b where both are measured, elsewhere the one that is.
///
/// The sum is sampled at the wavelengths of either, each spectrum being a power law between its own samples. If one
/// ends inside the band of the other, the sum falls to the other's value between two neighbouring samples. The waves
/// of the two surfaces add.
pub fn superpose(a: &ProfilePsd, b: &ProfilePsd) -> Superposition {
    let mut wavelengths_m = [a.wavelengths_m(), b.wavelengths_m()].concat();
    wavelengths_m.sort_by(|a, b| b.total_cmp(a));
    wavelengths_m.dedup();
    let at = |psd: &ProfilePsd, wavelength_m| psd.value_at(wavelength_m).unwrap_or(0.0);
    let sum = |&wavelength_m: &f64| at(a, wavelength_m) + at(b, wavelength_m);
    let c1d_m3 = wavelengths_m.iter().map(sum).collect();
    let longest_m = a.longest_wavelength_m().min(b.longest_wavelength_m());
    let shortest_m = a.shortest_wavelength_m().max(b.shortest_wavelength_m());
    let psd = ProfilePsd::from_samples(wavelengths_m, c1d_m3);
    let surface = |psd: &ProfilePsd| AreaSpectrum::from_profile(psd).ok();
    Superposition {
        // The waves add, and no step of the sum needs to be converted.
        psd: match surface(a).zip(surface(b)) {
            Some((of_a, of_b)) => psd.with_surface(of_a.waves.plus(&of_b.waves)),
            None => psd,
        },
        shared_m: (longest_m >= shortest_m).then_some([longest_m, shortest_m]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spectra_add_where_both_are_measured() {
        let a = ProfilePsd::from_samples(vec![8.0, 2.0], vec![3.0, 3.0]);
        let b = ProfilePsd::from_samples(vec![4.0, 1.0], vec![5.0, 5.0]);
        let sum = superpose(&a, &b);
        assert_eq!(sum.psd.wavelengths_m(), [8.0, 4.0, 2.0, 1.0]);
        assert_eq!(sum.psd.c1d_m3(), [3.0, 8.0, 8.0, 5.0]);
        assert_eq!(sum.shared_m, Some([4.0, 2.0]));
        assert_eq!(superpose(&b, &a), sum);
    }

    #[test]
    fn spectra_without_a_common_band_are_concatenated() {
        let a = ProfilePsd::from_samples(vec![8.0, 4.0], vec![3.0, 3.0]);
        let b = ProfilePsd::from_samples(vec![2.0, 1.0], vec![5.0, 5.0]);
        let sum = superpose(&a, &b);
        assert_eq!(sum.psd.c1d_m3(), [3.0, 3.0, 5.0, 5.0]);
        assert_eq!(sum.shared_m, None);
    }
}
