//! The scatter of a spectrum inside its holes, where nothing was measured.

use chacha20::rand_core::Rng;
use rand_distr::{Distribution, StandardNormal};
use spectrum::{Hole, ProfilePsd};

use crate::spectrum_ends::{End, PowerLaw};

/// Standard deviation of the slope d ln C/d ln q inside a hole whose neighbours show none: that of Hurst exponents spread
/// evenly over 0 to 1.
const UNKNOWN_SLOPE: f64 = 0.577_350_269_189_625_8;

/// Smallest standard deviation of ln C that is not rounding.
const MIN_SD: f64 = 1e-6;

/// The holes of a spectrum, each with what its neighbours leave open.
///
/// The plain spectrum crosses a hole as a straight line in ln C over ln q. The power laws of the last decade on either
/// side, prolonged to the middle of the hole, miss that line: the mean square of both misses, with the errors of both
/// laws, is the variance of ln C there. A power law that goes on unchanged leaves nothing open.
#[derive(Debug)]
pub(crate) struct HoleScatter(Vec<OpenHole>);

#[derive(Debug)]
struct OpenHole {
    hole: Hole,
    /// The standard deviation of ln C in the middle.
    ln_c1d_sd: f64,
}

impl HoleScatter {
    pub fn from_spectrum(psd: &ProfilePsd) -> Self {
        HoleScatter(psd.holes().into_iter().map(|hole| OpenHole::new(psd, hole)).collect())
    }

    /// True if any hole leaves something open.
    pub fn scatters(&self) -> bool {
        self.0.iter().any(|open| open.ln_c1d_sd > MIN_SD)
    }

    /// Returns a spectrum with a sample in the middle of every hole, on the straight line.
    pub fn bridged(&self, psd: ProfilePsd) -> Option<ProfilePsd> {
        self.filled(psd, |_| 0.0)
    }

    /// Returns a spectrum with a drawn sample in the middle of every hole.
    pub fn drawn(&self, psd: ProfilePsd, numbers: &mut impl Rng) -> Option<ProfilePsd> {
        self.filled(psd, |open| {
            let deviate: f64 = StandardNormal.sample(numbers);
            deviate * open.ln_c1d_sd
        })
    }

    fn filled(&self, psd: ProfilePsd, mut ln_shift: impl FnMut(&OpenHole) -> f64) -> Option<ProfilePsd> {
        if self.0.is_empty() {
            return Some(psd);
        }
        let samples = psd.wavelengths_m().iter().zip(psd.c1d_m3());
        let mut samples: Vec<(f64, f64, f64)> = samples.map(|(&at, &value)| (at, value, value)).collect();
        for open in &self.0 {
            let shift = ln_shift(open);
            let short = samples.partition_point(|(wavelength_m, ..)| *wavelength_m > open.hole.shortest_m);
            let [.., (long_m, long_m3, _)] = samples[..short] else { continue };
            let Some(&(short_m, short_m3, _)) = samples.get(short) else { continue };
            let straight_m3 = (long_m3 * short_m3).sqrt();
            samples.insert(short, ((long_m * short_m).sqrt(), straight_m3, straight_m3 * shift.exp()));
        }
        let column = |of: fn(&(f64, f64, f64)) -> f64| samples.iter().map(of).collect();
        // A known surface, as that of a table of areas, changes by the same factors.
        let bridged = ProfilePsd::new(column(|at| at.0), column(|at| at.1)).ok()?.with_surface_of(&psd);
        bridged.with_values(column(|at| at.2)).ok()
    }
}

impl OpenHole {
    fn new(psd: &ProfilePsd, hole: Hole) -> Self {
        let from = psd.wavelengths_m().partition_point(|wavelength_m| *wavelength_m > hole.shortest_m);
        let half = 0.5 * (hole.longest_m / hole.shortest_m).ln();
        let side = |range: std::ops::Range<usize>, end| {
            let (wavelengths_m, c1d_m3) = (&psd.wavelengths_m()[range.clone()], &psd.c1d_m3()[range]);
            PowerLaw::at(end, &ProfilePsd::new(wavelengths_m.to_vec(), c1d_m3.to_vec()).ok()?)
        };
        let across = (psd.c1d_m3()[from] / psd.c1d_m3()[from - 1]).ln() / (2.0 * half);
        let variances: Vec<f64> = [side(0..from, End::Short), side(from..psd.len(), End::Long)]
            .into_iter()
            .flatten()
            .map(|law| (law.slope - across).powi(2) + law.standard_error.powi(2))
            .collect();
        let slope_sd = match variances.len() {
            0 => UNKNOWN_SLOPE,
            sides => (variances.iter().sum::<f64>() / sides as f64).sqrt(),
        };
        OpenHole { hole, ln_c1d_sd: half * slope_sd }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spectrum with these slopes before, inside and behind a hole of one decade.
    fn psd(slopes: [f64; 3]) -> ProfilePsd {
        let [before, inside, behind] = slopes;
        let mut samples = Vec::new();
        for at in 0..=10 {
            let decades = 0.1 * f64::from(at);
            samples.push((-5.0 - decades, -20.0 + before * decades));
            samples.push((-7.0 - decades, -20.0 + before + inside + behind * decades));
        }
        samples.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (wavelengths_m, c1d_m3) =
            samples.into_iter().map(|(x, y)| (10f64.powf(x), 10f64.powf(y))).unzip();
        ProfilePsd::new(wavelengths_m, c1d_m3).unwrap()
    }

    #[test]
    fn a_power_law_across_a_hole_leaves_nothing_open() {
        let open = HoleScatter::from_spectrum(&psd([-2.6; 3]));
        assert_eq!(open.0.len(), 1);
        assert!(open.0[0].ln_c1d_sd < 1e-9, "{open:?}");
    }

    #[test]
    fn the_laws_on_both_sides_bound_the_middle() {
        // The laws miss the line by 1 and 0 in the slope, over half a decade.
        let open = HoleScatter::from_spectrum(&psd([-1.0, -2.0, -2.0]));
        let expected = 0.5 * 10f64.ln() * 0.5f64.sqrt();
        assert!((open.0[0].ln_c1d_sd / expected - 1.0).abs() < 1e-9, "{open:?}");
    }

    #[test]
    fn a_hole_between_single_samples_is_open_for_every_hurst_exponent() {
        let psd = ProfilePsd::new(vec![1e-5, 1e-6], vec![1e-20, 1e-23]).unwrap();
        let open = HoleScatter::from_spectrum(&psd);
        assert!((open.0[0].ln_c1d_sd - 0.5 * 10f64.ln() / 3f64.sqrt()).abs() < 1e-12);
        let bridged = open.bridged(psd).unwrap();
        assert_eq!(bridged.len(), 3);
        assert!((bridged.c1d_m3()[1] / 10f64.powf(-21.5) - 1.0).abs() < 1e-12);
    }

    /// A table of areas was converted anew from C1D, and lost waves at its end.
    #[test]
    fn holes_of_a_known_surface_leave_its_other_waves_as_they_are() {
        use spectrum::random_surfaces::AreaSpectrum;
        use spectrum::{Convention, Psd};
        let wavelengths_m: Vec<f64> =
            [0, 1, 2, 3, 8, 9, 10].iter().map(|&at| 10f64.powf(-5.0 - 0.1 * f64::from(at))).collect();
        let values = wavelengths_m.iter().map(|m| (m / 1e-5).powi(3)).collect();
        let psd = Psd::new(wavelengths_m.clone(), values, Convention::Ciso).unwrap().profile().unwrap();
        let hole = Hole { longest_m: wavelengths_m[3], shortest_m: wavelengths_m[4] };
        let drawn = HoleScatter(vec![OpenHole { hole, ln_c1d_sd: 0.0 }]).bridged(psd.clone()).unwrap();
        assert_eq!(drawn.len(), 8);
        let [given, found] =
            [&psd, &drawn].map(|psd| AreaSpectrum::from_profile(psd).unwrap().mean_square_gradient());
        assert!((found / given - 1.0).abs() < 1e-9, "{found} {given}");
    }
}
