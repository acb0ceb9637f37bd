//! The elastic-plastic sphere of Jackson & Green: 2005, J. Tribol. 127:343; 2006, Tribol. Int. 39:906.

use multiversion::multiversion;
use std::f64::consts::PI;

use crate::lanes::{FEW, LANES, any, each, in_blocks, in_few};
use crate::{Break, Hertz, MaterialPair, elementary};

/// Ratio w/w_c up to which the law is Hertz's; its force jumps there (see [`JacksonGreen::breaks`]).
pub const YIELD_INTERFERENCE_RATIO: f64 = 1.9;
/// Largest contact radius over sphere radius in the finite-element results that the law was fitted to (approximate).
pub const FITTED_CONTACT_RADIUS_OVER_RADIUS: f64 = 0.41;
/// Largest Sy/E* in the finite-element results that the law was fitted to (approximate).
pub const FITTED_STRENGTH_OVER_MODULUS: f64 = 0.01;

/// Decrease of the mean pressure at full plasticity with the size of the contact, H_G/Sy over a/R.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Hardness {
    /// Jackson & Green (2005): 2.84 [1 - exp(-0.82 (a/R)^-0.7)].
    #[default]
    #[serde(rename = "2005")]
    JacksonGreen2005,
    /// Cosine form 2.84 - 0.92 [1 - cos(pi a/R)]: up to 2 % above `JacksonGreen2005` for small contacts, below it
    /// from a/R = 0.36 on (1.00 against 1.59 at a/R = 1).
    #[serde(rename = "cosine")]
    Cosine,
}

units::named!(Hardness, "hardness formula", { JacksonGreen2005 => "2005", Cosine => "cosine" });

impl Hardness {
    /// Ratio H_G/Sy at ln(A/(pi R^2)) <= 0, which is twice the logarithm of a/R.
    fn over_strength(self, log_area_share: f64) -> f64 {
        match self {
            Hardness::JacksonGreen2005 => Self::jackson_green_2005(log_area_share),
            Hardness::Cosine => Self::cosine(log_area_share),
        }
    }

    #[inline(always)]
    fn jackson_green_2005(log_area_share: f64) -> f64 {
        2.84 * (1.0 - elementary::exp(-0.82 * elementary::exp(-0.35 * log_area_share)))
    }

    fn cosine(log_area_share: f64) -> f64 {
        2.84 - 0.92 * (1.0 - (PI * (0.5 * log_area_share).exp()).cos())
    }
}

/// Sphere that yields, pressed by a flat to an interference: Jackson & Green (2005, 2006), as in `docs/theory/models.md`,
/// section 2.2.
///
/// Hertz's law below 1.9 w_c; above, a fit to finite elements for contact radii up to 0.41 R and Sy/E* up to about
/// 0.01 ([`in_fitted_range`](Self::in_fitted_range)). Evaluated for every w >= 0, with a/R limited to 1. With w' =
/// w/w_c and C = 1.295 exp(0.736 nu).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JacksonGreen {
    hertz: Hertz,
    hardness: Hardness,
    radius_m: f64,
    /// C Sy \[Pa\]: the largest pressure at first yield.
    yield_pressure_pa: f64,
    yield_strength_pa: f64,
    /// Sy/E*.
    strength_over_modulus: f64,
    /// w_c \[m\].
    critical_interference_m: f64,
    /// ln(1.9 w_c/R).
    log_onset_over_radius: f64,
    /// b = 0.14 exp(23 Sy/E*).
    area_exponent: f64,
}

impl JacksonGreen {
    /// Creates a sphere of radius R > 0 \[m\] and yield strength Sy > 0 \[Pa\]. With an infinite strength it is
    /// Hertzian.
    #[inline]
    #[must_use]
    pub fn new(pair: &MaterialPair, radius_m: f64, yield_strength_pa: f64, hardness: Hardness) -> Self {
        debug_assert!(radius_m > 0.0 && yield_strength_pa > 0.0);
        let yield_pressure_pa = pair.spherical_yield_coefficient * yield_strength_pa;
        let strength_over_modulus = yield_strength_pa / pair.composite_modulus_pa();
        let critical_slope = PI * yield_pressure_pa / (2.0 * pair.composite_modulus_pa());
        JacksonGreen {
            hertz: Hertz::new(pair, radius_m),
            hardness,
            radius_m,
            yield_pressure_pa,
            yield_strength_pa,
            strength_over_modulus,
            critical_interference_m: critical_slope * critical_slope * radius_m,
            log_onset_over_radius: elementary::ln(YIELD_INTERFERENCE_RATIO * critical_slope * critical_slope),
            area_exponent: 0.14 * elementary::exp(23.0 * strength_over_modulus),
        }
    }

    /// Interference at first yield, w_c = (pi C Sy/(2 E*))^2 R \[m\]; infinite for an infinite strength.
    #[must_use]
    pub fn critical_interference_m(&self) -> f64 {
        self.critical_interference_m
    }

    /// Interference from which the law departs from Hertz's, 1.9 w_c \[m\].
    #[must_use]
    pub fn plastic_onset_m(&self) -> f64 {
        YIELD_INTERFERENCE_RATIO * self.critical_interference_m
    }

    /// Force F \[N\] at the interference w >= 0 \[m\]: Hertz's below 1.9 w_c, above it P_c {exp(-w'^(5/12)/4)
    /// w'^(3/2) + 4 H_G/(C Sy) \[1 - exp(-w'^(5/9)/25)\] w'}, P_c = (2/3) C Sy pi R w_c.
    ///
    /// It jumps at 1.9 w_c, downwards for nu > 0.32 or so when Sy is small against E* (by the step in
    /// [`breaks`](Self::breaks)), and is not capped with the area.
    #[must_use]
    pub fn force_n(&self, interference_m: f64) -> f64 {
        if self.is_elastic(interference_m) {
            self.hertz.force_n(interference_m)
        } else {
            self.plastic_force_n(interference_m)
        }
    }

    /// Forces \[N\] and contact areas \[m^2\] at interferences w >= 1.9 w_c \[m\], each under its own law `at_depth`;
    /// all laws have the same hardness form.
    #[inline]
    pub fn plastic_forces_and_areas(
        hardness: Hardness,
        at_depth: impl Fn(f64) -> JacksonGreen,
        interferences_m: &[f64],
        forces_n: &mut [f64],
        areas_m2: &mut [f64],
    ) {
        // One loop per hardness form, so that the cosine of one does not keep the compiler from vectorising the
        // other.
        let nodes = (interferences_m, forces_n, areas_m2);
        match hardness {
            Hardness::JacksonGreen2005 => plastic_at_each(at_depth, Hardness::jackson_green_2005, nodes),
            Hardness::Cosine => plastic_at_each(at_depth, Hardness::cosine, nodes),
        }
    }

    /// Computes [`force_and_area`](Self::force_and_area) at each of many interferences w >= 0 \[m\], to the same digits
    /// at a fraction of the cost (with the cosine form of the hardness at about the same).
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn forces_and_areas(&self, interferences_m: &[f64], forces_n: &mut [f64], areas_m2: &mut [f64]) {
        let nodes = (interferences_m, forces_n, areas_m2);
        match self.hardness {
            Hardness::JacksonGreen2005 => at_each(self, Hardness::jackson_green_2005, nodes),
            Hardness::Cosine => at_each(self, Hardness::cosine, nodes),
        }
    }

    /// Computes [`force_n`](Self::force_n) at each of few interferences w >= 0 \[m\], to the same digits at a fraction of
    /// the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn forces_n(&self, interferences_m: &[f64], forces_n: &mut [f64]) {
        match self.hardness {
            Hardness::JacksonGreen2005 => {
                forces_at_each(self, Hardness::jackson_green_2005, interferences_m, forces_n);
            }
            Hardness::Cosine => forces_at_each(self, Hardness::cosine, interferences_m, forces_n),
        }
    }

    /// Forces and areas at N interferences, without a branch; `over_strength` is H_G/Sy at ln(A/(pi R^2)).
    #[inline(always)]
    fn plastic<const N: usize>(
        &self,
        interferences_m: [f64; N],
        over_strength: impl Fn(f64) -> f64,
    ) -> [[f64; N]; 2] {
        let log_ratios: [f64; N] = each(|i| self.log_over_onset(interferences_m[i]));
        let growths: [f64; N] = each(|i| elementary::exp(self.log_growth(log_ratios[i])));
        let most_m2 = PI * self.radius_m * self.radius_m;
        let areas_m2 = each(|i| {
            let grown_m2 = self.hertz.area_m2(interferences_m[i]) * growths[i];
            if grown_m2 < most_m2 { grown_m2 } else { most_m2 }
        });
        [self.plastic_forces_n(interferences_m, log_ratios, over_strength), areas_m2]
    }

    /// Force \[N\] and contact area \[m^2\] at the interference w >= 0 \[m\]: [`force_n`](Self::force_n) and
    /// [`area_m2`](Self::area_m2), which share a logarithm and an exponential.
    #[must_use]
    pub fn force_and_area(&self, interference_m: f64) -> (f64, f64) {
        self.on_its_branch(interference_m, || {
            let [[force_n], [area_m2]] =
                self.plastic([interference_m], |log_share| self.hardness.over_strength(log_share));
            (force_n, area_m2)
        })
    }

    /// Force and area at one interference, given those of the plastic branch, which count from the onset on.
    #[inline(always)]
    fn on_its_branch(&self, interference_m: f64, plastic: impl FnOnce() -> (f64, f64)) -> (f64, f64) {
        if self.is_elastic(interference_m) {
            let most_m2 = PI * self.radius_m * self.radius_m;
            return (self.hertz.force_n(interference_m), self.hertz.area_m2(interference_m).min(most_m2));
        }
        plastic()
    }

    /// Contact area A = A_c w' (w'/1.9)^b \[m^2\], A_c = pi R w_c, b = 0.14 exp(23 Sy/E*), at the interference w >= 0
    /// \[m\]; Hertz's below 1.9 w_c, and limited to the cross-section pi R^2 (Jackson & Jacobs), also on Hertz's
    /// branch. Continuous.
    #[must_use]
    pub fn area_m2(&self, interference_m: f64) -> f64 {
        let area_m2 = self.hertz.area_m2(interference_m) * self.area_over_hertz(interference_m);
        area_m2.min(PI * self.radius_m * self.radius_m)
    }

    /// True if the contact at this interference lies within the results that the law was fitted to: a/R <= 0.41 and
    /// Sy/E* <= 0.01. Always true on Hertz's branch, which is not a fit.
    #[must_use]
    pub fn in_fitted_range(&self, interference_m: f64) -> bool {
        self.is_elastic(interference_m)
            || (self.strength_over_modulus <= FITTED_STRENGTH_OVER_MODULUS
                && self.contact_radius_over_radius(interference_m) <= FITTED_CONTACT_RADIUS_OVER_RADIUS)
    }

    /// Interferences \[m\] at which the force or the area is not smooth, in rising order: the departure from Hertz's
    /// law, where the force jumps, and the cap of the area at pi R^2.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let onset = self.plastic_onset_m();
        let departure = onset.is_finite().then(|| {
            let (below, above) = (self.hertz.force_n(onset), self.plastic_force_n(onset));
            Break::jump(onset, "departure from Hertz at 1.9 w_c", below, above)
        });
        let cap = Some(Break::kink(self.cap_interference_m(), "area reaches pi R^2"));
        let in_order = if self.cap_interference_m() < onset { [cap, departure] } else { [departure, cap] };
        in_order.into_iter().flatten()
    }

    /// Interference \[m\] at which the area reaches pi R^2.
    #[must_use]
    pub fn cap_interference_m(&self) -> f64 {
        self.interference_of_area_share_m(1.0)
    }

    /// Interference \[m\] at which the area reaches a share of pi R^2 in (0, 1]: w = share R while Hertzian, else
    /// (w/R)(w'/1.9)^b = share, solved in logarithms.
    #[must_use]
    pub fn interference_of_area_share_m(&self, share: f64) -> f64 {
        let onset = self.plastic_onset_m();
        if onset >= share * self.radius_m {
            return share * self.radius_m;
        }
        // ln(onset/(share R)) is the room left at the onset; it is used up at the rate 1 + b in ln w.
        let log_room = (share * self.radius_m / onset).ln();
        onset * (log_room / (1.0 + self.area_exponent)).exp()
    }

    /// Computes ln(A/(pi R^2)) at the interference w > 0 \[m\] without the cap: positive if the cap holds.
    #[must_use]
    pub fn log_area_over_cross_section(&self, interference_m: f64) -> f64 {
        let log_growth =
            if self.is_elastic(interference_m) { 0.0 } else { self.log_area_over_hertz(interference_m) };
        (interference_m / self.radius_m).ln() + log_growth
    }

    #[inline(always)]
    fn is_elastic(&self, interference_m: f64) -> bool {
        interference_m < self.plastic_onset_m()
    }

    /// Factor (w'/1.9)^b, 1 below the onset; through the logarithm, because b reaches thousands when Sy nears E*.
    fn area_over_hertz(&self, interference_m: f64) -> f64 {
        if self.is_elastic(interference_m) { 1.0 } else { self.log_area_over_hertz(interference_m).exp() }
    }

    fn log_area_over_hertz(&self, interference_m: f64) -> f64 {
        self.log_growth(self.log_over_onset(interference_m))
    }

    /// Computes ln(w'/1.9), keeping its digits near the onset.
    #[inline(always)]
    fn log_over_onset(&self, interference_m: f64) -> f64 {
        let onset_m = self.plastic_onset_m();
        elementary::ln_1p((interference_m - onset_m) / onset_m)
    }

    /// Computes b ln(w'/1.9).
    #[inline(always)]
    fn log_growth(&self, log_ratio: f64) -> f64 {
        self.area_exponent * log_ratio
    }

    /// Contact radius over sphere radius, a/R = min(1, sqrt(A/(pi R^2))).
    fn contact_radius_over_radius(&self, interference_m: f64) -> f64 {
        ((interference_m / self.radius_m).sqrt() * (0.5 * self.log_area_over_hertz(interference_m)).exp())
            .min(1.0)
    }

    /// Force \[N\] from the onset on.
    #[inline(always)]
    fn plastic_force_n(&self, interference_m: f64) -> f64 {
        let log_ratio = self.log_over_onset(interference_m);
        let [force_n] = self.plastic_forces_n([interference_m], [log_ratio], |log_share| {
            self.hardness.over_strength(log_share)
        });
        force_n
    }

    /// Forces \[N\] at N interferences from the onset on, in logarithms: `log_ratios` are ln(w'/1.9), and
    /// `over_strength` gives H_G/Sy at ln(A/(pi R^2)), which is ln(1.9 w_c/R) + (1 + b) ln(w'/1.9), limited to 0.
    #[inline(always)]
    fn plastic_forces_n<const N: usize>(
        &self,
        interferences_m: [f64; N],
        log_ratios: [f64; N],
        over_strength: impl Fn(f64) -> f64,
    ) -> [f64; N] {
        const LOG_OF_ONSET: f64 = 0.641_853_886_172_394_8;
        let critical_force_n =
            2.0 / 3.0 * self.yield_pressure_pa * PI * self.radius_m * self.critical_interference_m;
        let hardnesses: [f64; N] = each(|i| {
            let log_ratio = log_ratios[i];
            let log_area_share = self.log_onset_over_radius + log_ratio + self.log_growth(log_ratio);
            over_strength(if log_area_share < 0.0 { log_area_share } else { 0.0 })
        });
        // 5/12 and 5/9 are three and four times 5/36: both powers from one exponential.
        let powers: [f64; N] = each(|i| elementary::exp(5.0 / 36.0 * (LOG_OF_ONSET + log_ratios[i])));
        let w: [f64; N] = each(|i| interferences_m[i] / self.critical_interference_m);
        let elastic_shares: [f64; N] =
            each(|i| elementary::exp(-0.25 * (powers[i] * powers[i]) * powers[i]) * w[i] * w[i].sqrt());
        let plastic_shares: [f64; N] = each(|i| {
            let square = powers[i] * powers[i];
            -elementary::exp_m1(-square * square / 25.0) * w[i]
        });
        each(|i| {
            let hardness_over_pressure =
                4.0 * hardnesses[i] * self.yield_strength_pa / self.yield_pressure_pa;
            critical_force_n * (elastic_shares[i] + hardness_over_pressure * plastic_shares[i])
        })
    }
}

/// Forces and areas at interferences on both branches of a law.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn at_each<H: Fn(f64) -> f64>(
    law: &JacksonGreen,
    over_strength: H,
    (interferences_m, forces_n, areas_m2): (&[f64], &mut [f64], &mut [f64]),
) {
    in_blocks(interferences_m, [forces_n, areas_m2], |interferences_m| {
        let is_plastic = any::<LANES>(|i| !law.is_elastic(interferences_m[i]));
        let [mut forces_n, mut areas_m2] =
            if is_plastic { law.plastic(interferences_m, &over_strength) } else { [[0.0; LANES]; 2] };
        for i in 0..LANES {
            (forces_n[i], areas_m2[i]) = law.on_its_branch(interferences_m[i], || (forces_n[i], areas_m2[i]));
        }
        [forces_n, areas_m2]
    });
}

/// Forces at few interferences on both branches of a law.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn forces_at_each<H: Fn(f64) -> f64>(
    law: &JacksonGreen,
    over_strength: H,
    interferences_m: &[f64],
    forces_n: &mut [f64],
) {
    in_few(interferences_m, forces_n, |interferences_m| {
        let is_plastic = any::<FEW>(|i| !law.is_elastic(interferences_m[i]));
        let log_ratios = each(|i| law.log_over_onset(interferences_m[i]));
        let plastic_n = if is_plastic {
            law.plastic_forces_n(interferences_m, log_ratios, &over_strength)
        } else {
            [0.0; FEW]
        };
        each(|i| {
            let w = interferences_m[i];
            if law.is_elastic(w) { law.hertz.force_n(w) } else { plastic_n[i] }
        })
    });
}

/// Forces and areas at interferences, without a branch.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn plastic_at_each<L: Fn(f64) -> JacksonGreen, H: Fn(f64) -> f64>(
    at_depth: L,
    over_strength: H,
    (interferences_m, forces_n, areas_m2): (&[f64], &mut [f64], &mut [f64]),
) {
    for ((&w, force_n), area_m2) in interferences_m.iter().zip(forces_n).zip(areas_m2) {
        [[*force_n], [*area_m2]] = at_depth(w).plastic([w], &over_strength);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticBody;
    use crate::samples::assert_batch_has_the_digits_of_each;

    fn sphere(poisson_ratio: f64, strength_over_modulus: f64) -> JacksonGreen {
        let body = ElasticBody::new(1e11, poisson_ratio).unwrap();
        let pair = MaterialPair::against_rigid(body);
        JacksonGreen::new(
            &pair,
            1e-6,
            strength_over_modulus * pair.composite_modulus_pa(),
            Hardness::default(),
        )
    }

    fn force_step(poisson_ratio: f64, strength_over_modulus: f64) -> f64 {
        let law = sphere(poisson_ratio, strength_over_modulus);
        law.breaks().find(|b| b.what.contains("Hertz")).unwrap().step
    }

    #[test]
    fn the_force_jumps_by_the_published_law_s_own_size() {
        for (nu, percent, within) in
            [(0.0, 7.5, 0.05), (0.2, 2.64, 0.005), (0.3, 0.47, 0.005), (0.4, -1.5, 0.05), (0.5, -3.4, 0.05)]
        {
            let step = 100.0 * force_step(nu, 1e-6);
            assert!((step - percent).abs() < within, "nu = {nu}: {step} %");
        }
        assert!((100.0 * force_step(0.2, 0.08) + 1.1).abs() < 0.05);
        assert!((100.0 * force_step(0.2, 0.5) + 10.8).abs() < 0.05);
        assert!((100.0 * force_step(0.2, 3.0) + 10.8).abs() < 0.05);
    }

    #[test]
    fn many_interferences_have_the_digits_of_each() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.3).unwrap());
        for &hardness in Hardness::ALL {
            for strength_pa in [1e4, 1e8, 1e9, 1e10, 5e12, f64::INFINITY] {
                let law = JacksonGreen::new(&pair, 1e-6, strength_pa, hardness);
                let breaks: Vec<f64> = law.breaks().map(|b| b.at).collect();
                assert_batch_has_the_digits_of_each(
                    &breaks,
                    &[-0.0, -1e-300, -1e-9, -0.5, f64::INFINITY, f64::NAN],
                    |w| law.force_and_area(w),
                    |w, forces, areas| law.forces_and_areas(w, forces, areas),
                );
                assert_batch_has_the_digits_of_each(
                    &breaks,
                    &[-0.0, -1e-300, -1e-9, -0.5, f64::INFINITY, f64::NAN],
                    |w| (law.force_n(w), 0.0),
                    |w, forces, others| {
                        law.forces_n(w, forces);
                        others.fill(0.0);
                    },
                );
            }
        }
    }

    #[test]
    fn the_announced_step_is_the_one_the_force_makes() {
        let law = sphere(0.5, 0.002);
        let onset = law.plastic_onset_m();
        let made = law.force_n(onset) / law.force_n(onset * (1.0 - 1e-12)) - 1.0;
        assert!((made - force_step(0.5, 0.002)).abs() < 1e-10);
    }

    #[test]
    fn the_area_is_continuous_where_the_force_jumps() {
        let law = sphere(0.2, 0.01);
        let onset = law.plastic_onset_m();
        assert!(
            (law.area_m2(onset * (1.0 + 1e-12)) / law.area_m2(onset * (1.0 - 1e-12)) - 1.0).abs() < 1e-11
        );
    }

    #[test]
    fn the_cap_is_where_the_area_reaches_the_cross_section() {
        for strength_over_modulus in [1e-4, 0.01, 0.1, 0.2, 1.0, 40.0] {
            let law = sphere(0.2, strength_over_modulus);
            let w = law.cap_interference_m();
            let full = PI * 1e-12;
            assert!((law.area_m2(w * (1.0 - 1e-9)) / full - 1.0).abs() < 1e-4, "{strength_over_modulus}");
            assert!(law.area_m2(w * (1.0 - 1e-9)) < full);
            assert!((law.area_m2(w * (1.0 + 1e-9)) / full - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn the_logarithm_of_the_area_is_that_of_the_area_below_the_cap() {
        let law = sphere(0.3, 0.05);
        for w in [1e-9, 1e-8, 0.9 * law.cap_interference_m()] {
            let share = law.area_m2(w) / (PI * 1e-12);
            assert!((law.log_area_over_cross_section(w) - share.ln()).abs() < 1e-14);
        }
        assert!(law.log_area_over_cross_section(2e-6) > 0.0);
    }

    #[test]
    fn an_infinite_strength_is_hertz_and_a_huge_one_stays_finite_in_force() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(1e9, 0.3).unwrap());
        let hard = JacksonGreen::new(&pair, 1e-6, f64::INFINITY, Hardness::default());
        assert_eq!(hard.force_n(1e-7), Hertz::new(&pair, 1e-6).force_n(1e-7));
        let law = sphere(0.3, 50.0);
        assert!(law.force_n(law.plastic_onset_m() * 2.0).is_finite());
    }

    #[test]
    fn contacts_outside_the_fitted_range_are_flagged() {
        let metal = sphere(0.3, 0.003);
        assert!(metal.in_fitted_range(metal.plastic_onset_m() * 10.0));
        assert!(!metal.in_fitted_range(0.5e-6));
        let glass = sphere(0.3, 0.05);
        assert!(glass.in_fitted_range(glass.plastic_onset_m() * 0.5));
        assert!(!glass.in_fitted_range(glass.plastic_onset_m() * 1.5));
    }
}
