//! Populations of the elastic-plastic spheres of Jackson & Green.

use std::f64::consts::PI;

use asperity::{
    FITTED_CONTACT_RADIUS_OVER_RADIUS, FITTED_STRENGTH_OVER_MODULUS, Hardness, Hertz, JacksonGreen,
    MaterialPair, NixGao, YIELD_INTERFERENCE_RATIO,
};
use numerics::{minimum_in_bracket, zero_in_bracket};

use super::answers::{Asperities, Course, Hertzian, Response};
use super::one_by_one::hertzian;
use super::pieces::{Chart, Piece, pieces_between};
use crate::Population;

/// Elastic-plastic spheres, with a constant strength or the strength at the depth of the interference.
#[derive(Debug, Clone)]
pub(crate) struct ElasticPlasticSpheres {
    pair: MaterialPair,
    radius_m: f64,
    density_per_m2: f64,
    strength: NixGao,
    hardness: Hardness,
    /// Law of the strength S0, which holds at every depth if the strength is constant.
    macroscopic: JacksonGreen,
    /// Law below the onset: that of an infinite strength.
    elastic: JacksonGreen,
    onset_m: f64,
    held: Option<Held>,
}

/// Force and area that no longer grow with the interference.
#[derive(Debug, Clone, Copy)]
struct Held {
    from_m: f64,
    response: Response,
}

impl ElasticPlasticSpheres {
    pub fn new(pair: &MaterialPair, population: &Population, strength: NixGao, hardness: Hardness) -> Self {
        let radius_m = population.radius_m();
        let of_strength = |strength_pa| JacksonGreen::new(pair, radius_m, strength_pa, hardness);
        let macroscopic = of_strength(strength.macroscopic_strength_pa());
        // Elastic while w < 1.9 w_c(w), and w_c(w) = w_c0 (1 + h*/w): the onset is the positive root of w^2 - 1.9
        // w_c0 w - 1.9 w_c0 h*; a cap on the strength limits w_c to that of the cap.
        let half_m = 0.5 * YIELD_INTERFERENCE_RATIO * macroscopic.critical_interference_m();
        let length_m = strength.strain_gradient_length_m().unwrap_or(0.0);
        let grown_onset_m = half_m + (half_m * (half_m + 2.0 * length_m)).sqrt();
        let capped_onset_m =
            strength.cap_pa().map_or(f64::INFINITY, |cap_pa| of_strength(cap_pa).plastic_onset_m());
        ElasticPlasticSpheres {
            pair: *pair,
            radius_m,
            density_per_m2: population.density_per_m2(),
            strength,
            hardness,
            macroscopic,
            elastic: of_strength(f64::INFINITY),
            onset_m: grown_onset_m.min(capped_onset_m),
            held: None,
        }
    }

    /// Returns these spheres with force and area held from a contact radius on, given over the sphere radius in
    /// (0, 1\], or from a smaller interference if the force there is never reached again.
    pub fn held_from(self, radius_share: f64) -> Self {
        let at_share_m = self.interference_of_area_share_m(radius_share * radius_share, f64::INFINITY);
        let held =
            |sphere: JacksonGreen, from_m: f64| Held { from_m, response: self.response(sphere, from_m) };
        let at = |from_m: f64| held(self.sphere_at(from_m), from_m);
        // The force steps at the onset, and may dip behind it.
        let earlier = [Some(held(self.elastic, self.onset_m)), self.top_before_dip_m().map(at)];
        let earlier = earlier.into_iter().flatten().filter(|held| held.from_m < at_share_m);
        let highest = earlier.fold(at(at_share_m), |one, other| {
            if other.response.pressure_pa >= one.response.pressure_pa { other } else { one }
        });
        ElasticPlasticSpheres { held: Some(highest), ..self }
    }

    /// Interference \[m\] of the largest force before a dip.
    fn top_before_dip_m(&self) -> Option<f64> {
        // 0.618^40 of the bracket, some 1e-8, is where a maximum loses its digits.
        const GOLDEN_STEPS: usize = 40;
        let [from_m, below_m, _] = self.fall_m()?;
        let lost = |log_m: f64| -self.at_depth(log_m.exp()).force_n(log_m.exp());
        Some(minimum_in_bracket(from_m.ln(), below_m.ln(), GOLDEN_STEPS, lost).exp())
    }

    /// Interferences \[m\] just before the force begins to fall smoothly, just after, and where it rises again, if it
    /// falls.
    fn fall_m(&self) -> Option<[f64; 3]> {
        // Number of interferences at which the force is sampled, evenly in the logarithm: dips are a tenth of them or
        // wider.
        const SAMPLES: usize = 48;
        // Below this share of the cross-section the hardness is still that of the flat.
        const SMALLEST_SHARE: f64 = 1e-2;
        if self.is_known_to_rise() {
            return None;
        }
        let [low_m, high_m] =
            [SMALLEST_SHARE, 1.0].map(|share| self.interference_of_area_share_m(share, f64::INFINITY));
        // Just beside the onset, on its plastic side.
        let low_m = low_m.max(self.onset_m) * (1.0 + 1e-12);
        if low_m >= high_m || !high_m.is_finite() {
            return None;
        }
        let step = (high_m / low_m).ln() / (SAMPLES - 1) as f64;
        let at_m = |i: usize| low_m * (step * i as f64).exp();
        let forces_n: Vec<f64> = (0..SAMPLES).map(at_m).map(|w_m| self.at_depth(w_m).force_n(w_m)).collect();
        let falls = |pair: &[f64]| pair[1] < pair[0];
        let first = forces_n.windows(2).position(falls)?;
        let last = forces_n.windows(2).rposition(falls)?;
        Some([at_m(first.saturating_sub(1)), at_m(first + 1), at_m(last + 2)])
    }

    /// Law of the strength at a depth \[m\].
    #[inline(always)]
    fn at_depth(&self, depth_m: f64) -> JacksonGreen {
        if self.strength.strain_gradient_length_m().is_none() {
            return self.macroscopic;
        }
        self.grown_at_depth(depth_m)
    }

    /// Law at a depth \[m\], for a strength that depends on the depth.
    #[inline(always)]
    fn grown_at_depth(&self, depth_m: f64) -> JacksonGreen {
        JacksonGreen::new(&self.pair, self.radius_m, self.strength.at_depth_pa(depth_m), self.hardness)
    }

    /// Interference \[m\] at which A/(pi R^2) reaches `share` <= 1; infinite if it is beyond `high_m`.
    ///
    /// It is unique: ln(R/w) falls to zero at w = R, and b ln(w'/1.9), which rises from zero at the onset, nowhere
    /// falls fast enough to meet it again.
    fn interference_of_area_share_m(&self, share: f64, high_m: f64) -> f64 {
        if self.strength.strain_gradient_length_m().is_none() {
            return self.macroscopic.interference_of_area_share_m(share);
        }
        let (low_m, high_m) = (self.onset_m, high_m.min(share * self.radius_m));
        if low_m >= share * self.radius_m {
            return share * self.radius_m;
        }
        let excess = |log_m: f64| {
            let depth_m = log_m.exp();
            self.at_depth(depth_m).log_area_over_cross_section(depth_m) - share.ln()
        };
        if low_m >= high_m || excess(high_m.ln()) < 0.0 {
            return f64::INFINITY;
        }
        zero_in_bracket(low_m.ln(), high_m.ln(), excess).exp()
    }

    /// Returns true if the force is known never to fall smoothly, without a search.
    ///
    /// On the way to a = R the hardness falls, faster the faster the area grows (the cosine to a third), and the
    /// strength may; beyond, the force rises again. ln H_G falls by ln(a/R) no faster than 1.21 (cosine) or 0.46
    /// (2005), a^2 grows like w^(1+b) or, with a gradient, w^(1+2b), and the rest of the force at least like w or
    /// w^(1/2).
    fn is_known_to_rise(&self) -> bool {
        // Sy/E* up to which b is at most 0.56.
        const RISES_BELOW: f64 = 0.06;
        let is_constant = self.strength.strain_gradient_length_m().is_none();
        let strongest_pa = self.strength.at_depth_pa(self.onset_m);
        (is_constant || self.hardness == Hardness::JacksonGreen2005)
            && strongest_pa < RISES_BELOW * self.modulus_pa()
    }

    /// Law at an interference \[m\]. Below the onset any strength will do; computing that of the depth would double the
    /// cost of a node there.
    #[inline(always)]
    fn sphere_at(&self, interference_m: f64) -> JacksonGreen {
        if interference_m < self.onset_m { self.elastic } else { self.at_depth(interference_m) }
    }

    #[inline(always)]
    fn response(&self, sphere: JacksonGreen, interference_m: f64) -> Response {
        let (force_n, area_m2) = sphere.force_and_area(interference_m);
        Response { pressure_pa: self.density_per_m2 * force_n, area_fraction: self.density_per_m2 * area_m2 }
    }

    fn modulus_pa(&self) -> f64 {
        self.pair.composite_modulus_pa()
    }
}

impl Asperities for ElasticPlasticSpheres {
    fn at_interference(&self, interference_m: f64) -> Response {
        if let Some(held) = self.held.filter(|held| interference_m >= held.from_m) {
            return held.response;
        }
        self.response(self.sphere_at(interference_m), interference_m)
    }

    fn at_interferences(
        &self,
        interferences_m: &[f64],
        pressures_pa: &mut [f64],
        area_fractions: &mut [f64],
    ) {
        let (forces_n, areas_m2) = (&mut *pressures_pa, &mut *area_fractions);
        let hardness = self.hardness;
        if interferences_m.first().is_some_and(|&w| w < self.onset_m) {
            Hertz::new(&self.pair, self.radius_m).forces_and_areas(interferences_m, forces_n, areas_m2);
            let most_m2 = PI * self.radius_m * self.radius_m;
            areas_m2.iter_mut().for_each(|area_m2| *area_m2 = area_m2.min(most_m2));
        } else if self.strength.strain_gradient_length_m().is_none() {
            let sphere = self.macroscopic;
            JacksonGreen::plastic_forces_and_areas(hardness, |_| sphere, interferences_m, forces_n, areas_m2);
        } else {
            let of_strength = |depth_m: f64| self.grown_at_depth(depth_m);
            JacksonGreen::plastic_forces_and_areas(
                hardness,
                of_strength,
                interferences_m,
                forces_n,
                areas_m2,
            );
        }
        pressures_pa.iter_mut().for_each(|force_n| *force_n *= self.density_per_m2);
        area_fractions.iter_mut().for_each(|area_m2| *area_m2 *= self.density_per_m2);
    }

    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        if self.strength.strain_gradient_length_m().is_none() {
            self.macroscopic.forces_n(interferences_m, pressures_pa);
        } else {
            let forces = pressures_pa.iter_mut().zip(interferences_m);
            forces.for_each(|(force_n, &w)| *force_n = self.sphere_at(w).force_n(w));
        }
        for (&w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            let held = self.held.filter(|held| w >= held.from_m);
            *pressure_pa = held.map_or(self.density_per_m2 * *pressure_pa, |held| held.response.pressure_pa);
        }
    }

    fn hertzian(&self) -> Option<Hertzian> {
        let sphere = Hertz::new(&self.pair, self.radius_m);
        let held_m = self.held.map_or(self.radius_m, |held| held.from_m);
        Some(hertzian(&sphere, self.density_per_m2, self.onset_m.min(held_m)))
    }

    fn flattened_from_m(&self) -> Option<f64> {
        self.held.map(|held| held.from_m)
    }

    fn saturation(&self) -> Option<(f64, Response)> {
        self.held.map(|held| (held.from_m, held.response))
    }

    fn pieces(&self, _low_m: f64, high_m: f64) -> Vec<Piece<'_>> {
        let mut breaks_m = vec![0.0];
        if self.held.is_some() {
            breaks_m.push(self.onset_m);
        } else if self.onset_m.min(self.radius_m) < high_m {
            breaks_m.extend([self.onset_m, self.interference_of_area_share_m(1.0, high_m)]);
        }
        breaks_m.extend(self.strength.cap_depth_m().filter(|&depth_m| depth_m > self.onset_m));
        let end_m = self.held.map_or(f64::INFINITY, |held| held.from_m);
        breaks_m.retain(|break_m| *break_m < end_m);
        breaks_m.push(end_m);
        breaks_m.sort_by(f64::total_cmp);
        pieces_between(&breaks_m, |_| Chart::Interference)
    }

    fn out_of_fitted_range(&self, high_m: f64) -> Vec<(f64, f64)> {
        if self.onset_m >= high_m {
            return Vec::new();
        }
        let weak_enough_m = self
            .strength
            .depth_of_strength_m(FITTED_STRENGTH_OVER_MODULUS * self.modulus_pa())
            .unwrap_or(f64::INFINITY)
            .max(self.onset_m);
        let shallow_until_m = self
            .interference_of_area_share_m(FITTED_CONTACT_RADIUS_OVER_RADIUS.powi(2), high_m)
            .max(weak_enough_m);
        vec![(self.onset_m, weak_enough_m), (shallow_until_m.max(self.onset_m), f64::INFINITY)]
    }

    fn course(&self, sigma_s_m: f64) -> Course {
        if self.held.is_some_and(|held| held.from_m <= self.onset_m) {
            return Course::Rises;
        }
        // The published force steps at the departure from Hertz, down where nu is large or Sy nears E*. The density
        // spreads the step dF over sigma_s, and it turns p(d) only where 0.4 dF exceeds the rise 1.5 F sigma_s/w.
        let law = self.at_depth(self.onset_m);
        let step = law.breaks().map(|b| b.step).find(|&step| step != 0.0).unwrap_or(0.0);
        if -step * self.onset_m > 2.0 * sigma_s_m {
            Course::StepsDown { at_m: self.onset_m }
        } else {
            Course::Rises
        }
    }

    fn dip_m(&self) -> Option<[f64; 2]> {
        let end_m = self.held.map_or(f64::INFINITY, |held| held.from_m);
        let [from_m, _, to_m] = self.fall_m()?;
        (from_m < end_m).then(|| [from_m, to_m.min(end_m)])
    }
}
