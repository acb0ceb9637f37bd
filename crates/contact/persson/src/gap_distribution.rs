//! Distribution of the gaps of an elastic contact, by Almqvist, Campana, Prodanov & Persson (2011), J. Mech. Phys. Solids 59:2355,
//! and the flow through them by an effective medium: Bruggeman (1935), Ann. Phys. 416:636; for seals Persson, Prodanov, Krick et al.
//! (2012), Eur. Phys. J. E 35:5.
//!
//! From long to short waves, each wavevector q opens the share -dA of the nominal area with the mean gap u_1(q)
//! ([`crate::sealing`]); shorter waves, of the mean square height h^2(q), spread it:
//!
//! P(u) = Int (-dA) (2 pi h^2)^(-1/2) {exp[-(u - u_1)^2/(2 h^2)] + exp[-(u + u_1)^2/(2 h^2)]}.
//!
//! Its integral is 1 - A. The conductance s of a medium of local conductances u^3, closed at the share A in contact, is that of
//!
//! 1/s = <d/(u^3 + (d - 1) s)>,  d = 1/(1 - A_c),
//!
//! in which contact counts with u = 0: it vanishes at the threshold A_c, 1/2 in Bruggeman's medium of two dimensions.

use std::f64::consts::FRAC_1_SQRT_2;

use numerics::zero_in_bracket;

use crate::sealing::{PercolationThreshold, SealingLaw};

/// Share in contact from which on the opening gap is not resolved: what opens before has one gap.
const FULL: f64 = 0.99;
/// Share of the nominal area that opens with one gap at most.
const MOST_AT_ONCE: f64 = 0.05;
/// Gaps per decade into which the distribution is sorted.
const GAPS_PER_DECADE: f64 = 40.0;
/// Decades of gaps below the largest; smaller ones count with the smallest.
const DECADES: f64 = 8.0;
/// Widths of a Gaussian beyond which nothing is left of it.
const WIDTHS: f64 = 8.0;

/// Gaps between two surfaces in elastic contact, and the shares of the nominal area that have them.
#[derive(Debug, Clone, PartialEq)]
pub struct GapDistribution {
    /// Share of the nominal area in contact.
    area_fraction: f64,
    /// Gaps \[m\] and shares of the nominal area, from narrow to wide.
    gaps: Vec<(f64, f64)>,
}

/// Share of the nominal area that opens at one scale.
struct Opening {
    share: f64,
    gap_m: f64,
    rms_height_m: f64,
}

impl Opening {
    /// Share of the opening whose gap is at most `gap_m` \[m\].
    fn up_to(&self, gap_m: f64) -> f64 {
        let [low, high] =
            [-gap_m, gap_m].map(|end_m| (end_m - self.gap_m) / self.rms_height_m * FRAC_1_SQRT_2);
        if self.rms_height_m > 0.0 {
            0.5 * (libm::erf(high) - libm::erf(low))
        } else {
            f64::from(u8::from(self.gap_m <= gap_m))
        }
    }
}

impl GapDistribution {
    /// Computes the distribution of a seal under a nominal pressure p > 0 \[Pa\].
    #[must_use]
    pub fn new(law: &SealingLaw, pressure_pa: f64) -> Self {
        let openings = law.openings(pressure_pa);
        let widest_m = |opening: &Opening| opening.gap_m + WIDTHS * opening.rms_height_m;
        let largest_m = openings.iter().map(widest_m).fold(0.0, f64::max);
        let area_fraction = law.area_fraction(pressure_pa);
        let count = (DECADES * GAPS_PER_DECADE) as i32;
        let end_m = |at: i32| largest_m * 10f64.powf(f64::from(at - count) / GAPS_PER_DECADE);
        let mut before = vec![0.0; openings.len()];
        let mut gaps = Vec::new();
        for at in 0..=count {
            let mut share = 0.0;
            for (opening, before) in openings.iter().zip(&mut before) {
                let up_to = opening.up_to(end_m(at));
                share += opening.share * (up_to - *before);
                *before = up_to;
            }
            if share > 0.0 {
                gaps.push((end_m(at) * 10f64.powf(-0.5 / GAPS_PER_DECADE), share));
            }
        }
        GapDistribution { area_fraction, gaps }
    }

    /// Share of the nominal area in contact, in (0, 1\].
    #[must_use]
    pub fn area_fraction(&self) -> f64 {
        self.area_fraction
    }

    /// Gaps \[m\] and the shares of the nominal area that have them, from narrow to wide; the shares sum to 1 - A.
    #[must_use]
    pub fn gaps(&self) -> &[(f64, f64)] {
        &self.gaps
    }

    /// Mean over the nominal area of a power of the gap; of the gap itself \[m\] with 1. The broadened distribution has 4 to 80 % more
    /// than the theory's mean gap.
    #[must_use]
    pub fn mean_power(&self, power: i32) -> f64 {
        self.gaps.iter().map(|(gap_m, share)| share * gap_m.powi(power)).sum()
    }

    /// Conductance of the effective medium \[m^3\]: the cube of the parallel slot that lets as much through; 0 from the threshold on.
    #[must_use]
    pub fn effective_cube_m3(&self, threshold: PercolationThreshold) -> f64 {
        let closed_at = threshold.area_fraction();
        let open = 1.0 - self.area_fraction / closed_at;
        let Some((largest_m, _)) = self.gaps.last().filter(|(gap_m, _)| open > 0.0 && *gap_m > 0.0) else {
            return 0.0;
        };
        let dimensions = 1.0 / (1.0 - closed_at);
        let excess = |ln_s: f64| {
            let s = ln_s.exp();
            let passes = |(gap_m, share): &(f64, f64)| {
                share * dimensions * s / ((gap_m / largest_m).powi(3) + (dimensions - 1.0) * s)
            };
            self.gaps.iter().map(passes).sum::<f64>() - open
        };
        // A medium of the largest gap throughout conducts more, one of the smallest less.
        let lowest = -3.0 * (DECADES + 1.0) * std::f64::consts::LN_10;
        if excess(lowest) >= 0.0 {
            return 0.0;
        }
        zero_in_bracket(lowest, 1e-9, excess).exp() * largest_m.powi(3)
    }
}

impl SealingLaw {
    /// Opens the nominal area scale by scale under a nominal pressure p > 0 \[Pa\].
    fn openings(&self, pressure_pa: f64) -> Vec<Opening> {
        let Some([longest, last]) = self.ends_rad_per_m() else { return Vec::new() };
        let area = |q: f64| self.area_up_to(q, pressure_pa);
        let first = if area(last) < FULL { zero_in_bracket(longest, last, |q| area(q) - FULL) } else { last };
        let start = (first, area(first));
        let mut openings = vec![self.opening(1.0 - start.1, first, pressure_pa)];
        self.open(start, (last, area(last)), pressure_pa, &mut openings);
        openings
    }

    /// The gap that opens at a wavevector \[rad/m\], on a share of the nominal area.
    fn opening(&self, share: f64, wavevector_rad_per_m: f64, pressure_pa: f64) -> Opening {
        let contact = self.contact_at(wavevector_rad_per_m, pressure_pa);
        Opening {
            share,
            gap_m: contact.opening_gap_m.unwrap_or(contact.mean_gap_m),
            rms_height_m: self.mean_square_height_beyond_m2(wavevector_rad_per_m).sqrt(),
        }
    }

    /// Opens what shrinks between two wavevectors \[rad/m\] with their areas, in halves while it is too much for one gap.
    fn open(&self, start: (f64, f64), end: (f64, f64), pressure_pa: f64, openings: &mut Vec<Opening>) {
        let (share, middle) = (start.1 - end.1, (start.0 * end.0).sqrt());
        if share > MOST_AT_ONCE && end.0 / start.0 > 1.0 + 1e-9 {
            let between = (middle, self.area_up_to(middle, pressure_pa));
            self.open(start, between, pressure_pa, openings);
            self.open(between, end, pressure_pa, openings);
        } else if share > 0.0 {
            openings.push(self.opening(share, middle, pressure_pa));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::EnergyFactor;
    use crate::roughness::{Roughness, RoughnessSample};

    const MODULUS_PA: f64 = 1e11;

    /// Seal of a self-affine surface of three decades with a Hurst exponent of 0.8, whose waves are those of the surface.
    fn seal(threshold: PercolationThreshold) -> (SealingLaw, f64) {
        let wavevector = |at: i32| 1e4 * 10f64.powf(f64::from(at) / 20.0);
        let sample = |at: i32| RoughnessSample {
            wavelength_m: std::f64::consts::TAU / wavevector(at),
            c1d_m3: 1e-9 * wavevector(at).powf(-2.6),
            moments: [0.0; 3],
            amplitude_m: 0.0,
        };
        let samples: Vec<RoughnessSample> = (0..=60).map(sample).collect();
        let gradients: Vec<f64> =
            (0..=60).map(|at| 1e-6 * (wavevector(at).powf(0.4) - wavevector(0).powf(0.4))).collect();
        let roughness = Roughness::new(&samples, Some(&gradients));
        let law = SealingLaw::new(&roughness, MODULUS_PA, EnergyFactor::ALMQVIST, None, threshold);
        (law, MODULUS_PA * gradients[60].sqrt())
    }

    #[test]
    fn the_shares_of_all_gaps_and_of_contact_are_everything() {
        let (law, spread_pa) = seal(PercolationThreshold::SIMULATED);
        let mut before: Option<GapDistribution> = None;
        for share in [1e-4, 0.01, 0.05, 0.1, 0.2, 0.4] {
            let found = GapDistribution::new(&law, share * spread_pa);
            assert!((found.mean_power(0) + found.area_fraction() - 1.0).abs() < 1e-9, "{share}");
            assert!(found.gaps().len() > 100 && found.gaps().windows(2).all(|pair| pair[0].0 < pair[1].0));
            let threshold = PercolationThreshold::SIMULATED;
            if let Some(lighter) = before {
                assert!(found.mean_power(1) < lighter.mean_power(1));
                let [less, more] = [&found, &lighter].map(|gaps| gaps.effective_cube_m3(threshold));
                assert!(less < more || more == 0.0, "{share}: {less:e} {more:e}");
            }
            before = Some(found);
        }
        assert_eq!(
            GapDistribution::new(&law, 0.4 * spread_pa).effective_cube_m3(PercolationThreshold::SIMULATED),
            0.0
        );
    }

    /// The balance of each wave keeps the mean of what opens; the spread about it is folded at contact, and only adds.
    #[test]
    fn opening_gaps_have_the_mean_gap_of_the_theory() {
        let (law, spread_pa) = seal(PercolationThreshold::SIMULATED);
        for (share, broadened) in [(0.01, 1.04), (0.05, 1.15), (0.15, 1.33)] {
            let openings = law.openings(share * spread_pa);
            let mean_m: f64 = openings.iter().map(|opening| opening.share * opening.gap_m).sum();
            // The theory's mean gap, without the tail of its heights.
            let first = law.contact_at(1e4, share * spread_pa);
            let found = mean_m / first.mean_gap_m;
            // The deepest gaps, which open while 0.99 or more touches, have one gap.
            assert!((0.85..1.01).contains(&found), "{share}: {found}");
            let spread = GapDistribution::new(&law, share * spread_pa).mean_power(1) / first.mean_gap_m;
            assert!((spread / broadened - 1.0).abs() < 0.02, "{share}: {spread}");
        }
    }

    #[test]
    fn two_conductances_make_the_medium_of_its_closed_form() {
        // s/g^3 = 1 - f/A_c of a share f in contact and one gap elsewhere.
        for closed_at in [0.3, 0.42, 0.5] {
            let threshold = PercolationThreshold::new(closed_at).unwrap();
            for area_fraction in [0.0, 0.1, 0.29] {
                let one = GapDistribution { area_fraction, gaps: vec![(2e-6, 1.0 - area_fraction)] };
                let expected = (1.0 - area_fraction / closed_at) * 8e-18;
                assert!(
                    (one.effective_cube_m3(threshold) / expected - 1.0).abs() < 1e-8,
                    "{closed_at} {area_fraction}"
                );
            }
            let shut = GapDistribution { area_fraction: closed_at, gaps: vec![(2e-6, 1.0 - closed_at)] };
            assert_eq!(shut.effective_cube_m3(threshold), 0.0);
        }
        // Gaps that have vanished let nothing through.
        let vanished = GapDistribution { area_fraction: 0.1, gaps: vec![(0.0, 0.9)] };
        assert_eq!(vanished.effective_cube_m3(PercolationThreshold::SIMULATED), 0.0);
        // Half of one conductance and half of another, in Bruggeman's medium: their geometric mean.
        let halves = GapDistribution { area_fraction: 0.0, gaps: vec![(1e-6, 0.5), (3e-6, 0.5)] };
        let bruggeman = PercolationThreshold::new(0.5).unwrap();
        assert!((halves.effective_cube_m3(bruggeman) / 27f64.sqrt() / 1e-18 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn an_opening_without_shorter_waves_is_one_gap() {
        let opening = Opening { share: 1.0, gap_m: 1e-6, rms_height_m: 0.0 };
        assert_eq!((opening.up_to(0.99e-6), opening.up_to(1e-6)), (0.0, 1.0));
        let spread = Opening { rms_height_m: 1e-6, ..opening };
        // Folded normal: P(|x| <= 2) of mean and standard deviation 1.
        assert!((spread.up_to(2e-6) - 0.839_994_848).abs() < 1e-8, "{}", spread.up_to(2e-6));
    }

    #[test]
    fn without_roughness_everything_touches() {
        let law = SealingLaw::new(
            &Roughness::new(&[], None),
            MODULUS_PA,
            EnergyFactor::ALMQVIST,
            None,
            PercolationThreshold::SIMULATED,
        );
        let found = GapDistribution::new(&law, 1e6);
        assert_eq!((found.area_fraction(), found.gaps().len()), (1.0, 0));
        assert_eq!(found.effective_cube_m3(PercolationThreshold::SIMULATED), 0.0);
    }
}
