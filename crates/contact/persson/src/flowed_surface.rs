//! Gap and stiffness where all of the contact has flowed at a hardness H.
//!
//! Bodies that flow press with H wherever the rough surface, as it is bent by these pressures, stands above the plane of the other body,
//! and with 0 elsewhere. Bending is elastic: the pressure of a wave q lowers it by 2 p_q/(E* q). Of a Gaussian surface the
//! part of the pressure that follows the heights is H phi(t) h_q/s (Bussgang's theorem), with the rms height s of the bent surface
//! and the level t of the plane in units of s. So **a wave keeps the share 1/(1 + kappa/q) of its height**, kappa = 2 H phi(t)/(E* s):
//! long waves bend, short ones flow. s and kappa follow from each other, and t from the load, Q(t) = p/H. From the bent surface:
//!
//! * the distance of the mean planes is t s, and the mean of the open gap s {phi(t) + t \[1 - Q(t)\]};
//! * the contact is the part of the bent surface above t s. On unloading it is a rigid punch of many spots. Each pressure on these spots
//!   that carries the load stores more energy than the true one (Thomson's principle), so that 1/K is at most
//!   (2/E*) Int_0^inf \[C(r)/p^2 - 1\] dr with the correlation C of such a pressure. Here it is (z - t)^(-1/2), which is the true one of
//!   a paraboloid, times exp(-lambda z_l): z_l are the long waves, of which each has the share chi/(q + chi), and spots share
//!   the load evenly over these. The best chi is taken.

use std::f64::consts::LN_10;
use std::sync::OnceLock;

use numerics::gaussian::{density, level_of_share, share_above};
use numerics::{minimum_in_bracket, zero_in_bracket};

use crate::excursion::{mean_depth_below, punch_load, punch_pairs};
use crate::separation::{SeparationLaw, Wave};

/// Waves, and distances, per decade.
const PER_DECADE: f64 = 24.0;

/// Waves of a surface in narrow bands.
#[derive(Debug, Clone)]
pub(crate) struct Waves {
    bands: Vec<Wave>,
    /// Their correlations, once they are read.
    correlations: OnceLock<Correlations>,
}

/// Correlations of waves over distances.
#[derive(Debug, Clone)]
struct Correlations {
    /// Distances \[m\] in equal steps of their logarithms, from well below the shortest to well above the longest wave.
    distances_m: Vec<f64>,
    /// Share of the correlation of every wave that is lost, distance by distance.
    lost: Vec<f64>,
}

/// Bent surface of bodies that flow under a load.
#[derive(Debug, Clone)]
pub(crate) struct FlowedSurface<'w> {
    waves: &'w Waves,
    /// Level of the other body over the mean plane, in rms heights of the bent surface.
    level: f64,
    /// Rms height of the bent surface \[m\]; 0 where the hardness is enough to flatten it.
    rms_height_m: f64,
    /// Shares of the waves in the mean square height of the bent surface.
    shares: Vec<f64>,
}

impl Waves {
    /// Returns the waves of a law; `None` if it has none.
    pub(crate) fn from_law(law: &SeparationLaw) -> Option<Self> {
        let bands = law.waves(PER_DECADE);
        (!bands.is_empty()).then_some(Waves { bands, correlations: OnceLock::new() })
    }

    /// Shortest and longest wavevector \[rad/m\].
    fn ends_rad_per_m(&self) -> [f64; 2] {
        [self.bands.first(), self.bands.last()].map(|end| end.map_or(1.0, |wave| wave.wavevector_rad_per_m))
    }

    fn correlations(&self) -> &Correlations {
        self.correlations.get_or_init(|| {
            let [first, last] = self.ends_rad_per_m();
            let (nearest_m, farthest_m) = (0.02 / last, 12.0 / first);
            let count = (PER_DECADE * (farthest_m / nearest_m).log10()).ceil();
            let step = (farthest_m / nearest_m).ln() / count;
            let distances_m: Vec<f64> =
                (0..=count as u32).map(|at| nearest_m * (step * f64::from(at)).exp()).collect();
            let lost = distances_m.iter().flat_map(|distance_m| {
                let of_wave = move |wave: &Wave| lost_correlation(wave.wavevector_rad_per_m * distance_m);
                self.bands.iter().map(of_wave)
            });
            Correlations { lost: lost.collect(), distances_m }
        })
    }

    /// Bends the surface under a nominal pressure that is a share in (0, 1) of the hardness, at a ratio H/E* > 0.
    pub(crate) fn flowed(&self, load_over_hardness: f64, hardness_over_modulus: f64) -> FlowedSurface<'_> {
        let level = level_of_share(load_over_hardness);
        let slope = 2.0 * hardness_over_modulus * density(level);
        // kappa s is this slope; its square, Sum h_q^2 [q kappa/(q + kappa)]^2, rises with kappa up to the mean square gradient.
        let bent = |kappa_per_m: f64| {
            let of_wave = move |wave: &Wave| {
                let q = wave.wavevector_rad_per_m;
                wave.mean_square_height_m2 * (q / (1.0 + q / kappa_per_m)).powi(2)
            };
            self.bands.iter().map(of_wave)
        };
        let root_of = |kappa_per_m: f64| bent(kappa_per_m).sum::<f64>().sqrt();
        let gradient = root_of(f64::INFINITY);
        let kappa_per_m = if slope < gradient {
            let rms_height_m = self.bands.iter().map(|wave| wave.mean_square_height_m2).sum::<f64>().sqrt();
            let [_, shortest] = self.ends_rad_per_m();
            let [least, most] = [0.5 * slope / rms_height_m, 2.0 * shortest / (1.0 - slope / gradient)];
            zero_in_bracket(least.ln(), most.ln(), |ln_kappa| root_of(ln_kappa.exp()) - slope).exp()
        } else {
            f64::INFINITY
        };
        let square = root_of(kappa_per_m).powi(2);
        FlowedSurface {
            waves: self,
            level,
            rms_height_m: slope / kappa_per_m,
            shares: bent(kappa_per_m).map(|of_wave| of_wave / square).collect(),
        }
    }
}

/// Returns 1 - J_0(x) averaged over a narrow band about a wave, x = q r.
fn lost_correlation(x: f64) -> f64 {
    if x < 1e-4 {
        return 0.25 * x * x;
    }
    let across = 0.5 * x * LN_10 / PER_DECADE;
    1.0 - libm::j0(x) * (across.sin() / across)
}

impl FlowedSurface<'_> {
    /// Mean of the open gap over the nominal area \[m\].
    pub(crate) fn mean_gap_m(&self) -> f64 {
        self.rms_height_m * mean_depth_below(self.level)
    }

    /// Distance of the mean planes of both bodies \[m\], negative where they pass each other.
    pub(crate) fn mean_plane_distance_m(&self) -> f64 {
        self.rms_height_m * self.level
    }

    /// Stiffness of unloading over the contact modulus, K/E* \[1/m\], that the spots would have as (p/H) times the rms wavevector of the
    /// bent surface, but for the [`spot_factor`](Self::spot_factor).
    pub(crate) fn stiffness_scale_per_m(&self) -> f64 {
        let waves = self.waves.bands.iter().zip(&self.shares);
        let square: f64 = waves.map(|(wave, share)| share * wave.wavevector_rad_per_m.powi(2)).sum();
        share_above(self.level) * square.sqrt()
    }

    /// Stiffness of unloading over E* times its [scale](Self::stiffness_scale_per_m), about 0.6.
    pub(crate) fn spot_factor(&self) -> f64 {
        /// Sections of the search for chi, at whose best value the stiffness hardly changes.
        const SECTIONS: usize = 10;
        let [longest, shortest] = self.waves.ends_rad_per_m();
        let compliance_m = |ln_chi: f64| self.compliance_m(ln_chi.exp());
        let best = minimum_in_bracket((0.03 * longest).ln(), shortest.ln(), SECTIONS, compliance_m);
        1.0 / (compliance_m(best) * self.stiffness_scale_per_m())
    }

    /// Compliance E*/K \[m\] with a pressure that is even over waves longer than 1/chi.
    fn compliance_m(&self, chi_per_m: f64) -> f64 {
        let evened: Vec<[f64; 3]> = self
            .waves
            .bands
            .iter()
            .zip(&self.shares)
            .map(|(wave, share)| {
                let long = chi_per_m / (wave.wavevector_rad_per_m + chi_per_m);
                [*share, share * long, share * long * long]
            })
            .collect();
        let [_, with_long, long] =
            evened.iter().fold([0.0; 3], |sum, wave| [0, 1, 2].map(|at| sum[at] + wave[at]));
        let [_, weight] = punch_load(self.level);
        let alone = punch_pairs(self.level + weight * with_long, 1.0);
        let excess = |lost: &[f64]| {
            let lost = evened
                .iter()
                .zip(lost)
                .fold([0.0; 3], |sum, (wave, lost)| [0, 1, 2].map(|at| sum[at] + wave[at] * lost));
            let level = self.level + weight * (2.0 * with_long - lost[1]);
            (weight * weight * (long - lost[2])).exp() * punch_pairs(level, lost[0]) / alone - 1.0
        };
        let Correlations { distances_m, lost } = self.waves.correlations();
        let count = self.waves.bands.len();
        let excesses: Vec<f64> = lost.chunks(count).map(excess).collect();
        let below = distances_m[0] * excesses[0];
        let pairs = distances_m.windows(2).zip(excesses.windows(2));
        let beyond =
            pairs.map(|(r, excess)| 0.5 * (r[1] / r[0]).ln() * (r[0] * excess[0] + r[1] * excess[1]));
        2.0 * (below + beyond.sum::<f64>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EnergyFactor;
    use crate::separation::SeparationKnot;

    /// Waves from 1e4 rad/m to a multiple of that, of even height over ln q.
    fn waves(width: f64) -> Waves {
        let knot = |at: i32| {
            let q = 1e4 * width.powf(f64::from(at) / 40.0);
            let variance_pa2 = 1e16 * ((q / 1e4).powi(2) - 1.0);
            SeparationKnot { wavevector_rad_per_m: q, variance_pa2, variance_exponent: 2.0 }
        };
        let knots: Vec<SeparationKnot> = (0..=40).map(knot).collect();
        Waves::from_law(&SeparationLaw::new(&knots, 1e11, EnergyFactor::ALMQVIST)).unwrap()
    }

    /// At a high level t, spots are paraboloids whose heights over it are exponential, of the mean s/t, and whose curvature is t h'^2/(2 s):
    /// sum 2 a over the area is t A q/(2 sqrt(pi)) with q = h'/s.
    #[test]
    fn few_spots_far_apart_are_punches_of_their_own_radii() {
        let waves = waves(1.5);
        for share in [1e-6, 1e-9, 1e-12] {
            let factor = waves.flowed(share, 1e-9).spot_factor();
            let expected = level_of_share(share) / (2.0 * std::f64::consts::PI.sqrt());
            // Their heights have that distribution but for terms in 1/t^2.
            let within = 2.0 / level_of_share(share).powi(2);
            assert!((factor / expected - 1.0).abs() < within, "{share}: {factor} {expected}");
        }
    }

    #[test]
    fn long_waves_bend_and_short_ones_stay() {
        let waves = waves(100.0);
        let [soft, hard] = [1e-9, 0.1].map(|ratio| waves.flowed(0.05, ratio));
        assert!(hard.rms_height_m < 0.9 * soft.rms_height_m);
        let kept = |surface: &FlowedSurface<'_>, at: usize| {
            surface.shares[at] * surface.rms_height_m.powi(2) / waves.bands[at].mean_square_height_m2
        };
        let last = waves.bands.len() - 1;
        assert!(kept(&hard, 0) < 0.1 && kept(&hard, last) > 0.85, "{} {}", kept(&hard, 0), kept(&hard, last));
        assert!((kept(&soft, 0) - 1.0).abs() < 1e-5);
        // kappa s = 2 (H/E*) phi(t), with the share 1/(1 + kappa/q)^2 of each wave.
        let q = waves.bands[0].wavevector_rad_per_m;
        let kappa_per_m = q * (kept(&hard, 0).sqrt().recip() - 1.0);
        let slope = 0.2 * density(level_of_share(0.05));
        assert!((kappa_per_m * hard.rms_height_m / slope - 1.0).abs() < 1e-9);
        // A hardness that flattens all waves leaves none.
        let flattened = waves.flowed(0.5, 100.0);
        assert_eq!((flattened.mean_gap_m(), flattened.mean_plane_distance_m()), (0.0, 0.0));
        assert!(flattened.spot_factor() > 0.0);
    }
}
