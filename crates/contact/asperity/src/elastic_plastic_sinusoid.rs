//! The elastic-plastic sinusoid at a mean pressure: Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Jackson,
//! Krithivasan & Wilson (2008).

use std::f64::consts::PI;

use crate::elastic_sinusoid::log_of_fraction;
use crate::mean_gap::GapExponent;
use crate::yielding_area::{YieldParameters, YieldingArea};
use crate::{Break, ElasticSinusoid, MaterialPair, elementary};

/// Aspect ratio over the critical one above which results are flagged; no fitted range is published.
pub const FLAGGED_ASPECT_RATIO_OVER_CRITICAL: f64 = 100.0;

/// Upper limit of r, so that no derived number overflows: some 300 decades beyond the fits.
const LARGEST_RATIO: f64 = 1e300;

/// Sinusoidal surface, of one aspect ratio and strength, in contact with a flat: Krithivasan & Jackson (2007), as in
/// `docs/theory/models.md`, section 2.4, with the mean gap of 2.5 and the interference of 2.6.
///
/// It is elastic if its aspect ratio is at most the critical one, and below the critical pressure p_c; elsewhere
/// plastic flow lowers the pressure of complete contact and raises the area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticPlasticSinusoid {
    elastic: ElasticSinusoid,
    critical_aspect_ratio: f64,
    aspect_ratio_over_critical: f64,
    critical_pressure_pa: f64,
    /// E* B/Sy, from which the exponent d of the plastic area follows.
    slope_over_yield_slope: f64,
    /// ln C.
    log_yield_coefficient: f64,
}

impl ElasticPlasticSinusoid {
    /// Creates a sinusoid of aspect ratio B = Delta/lambda > 0 and yield strength Sy > 0 \[Pa\]; with an infinite
    /// strength it is elastic.
    #[inline]
    #[must_use]
    pub fn new(pair: &MaterialPair, aspect_ratio: f64, yield_strength_pa: f64) -> Self {
        debug_assert!(aspect_ratio > 0.0 && yield_strength_pa > 0.0);
        let slope_pa = pair.composite_modulus_pa() * aspect_ratio;
        let yield_pressure_pa = pair.spherical_yield_coefficient * yield_strength_pa;
        let critical_aspect_ratio =
            pair.sinusoidal_yield_coefficient * (yield_strength_pa / pair.composite_modulus_pa());
        let aspect_ratio_over_critical = (aspect_ratio / critical_aspect_ratio).min(LARGEST_RATIO);
        ElasticPlasticSinusoid {
            elastic: ElasticSinusoid::new(pair, aspect_ratio),
            critical_aspect_ratio,
            aspect_ratio_over_critical,
            // (C Sy/2)^3/(6 pi (E* B)^2), arranged so that no power over- or underflows.
            critical_pressure_pa: yield_pressure_pa * (yield_pressure_pa / slope_pa).powi(2) / (48.0 * PI),
            slope_over_yield_slope: pair.sinusoidal_yield_coefficient * aspect_ratio_over_critical,
            log_yield_coefficient: pair.log_spherical_yield_coefficient,
        }
    }

    /// Returns the elastic sinusoid of the same shape and material.
    #[must_use]
    pub fn elastic(&self) -> ElasticSinusoid {
        self.elastic
    }

    /// Returns the elastic sinusoid that is in complete contact at p*_ep: its area is the elastic one at p/p*_ep.
    #[must_use]
    pub fn softened(&self) -> ElasticSinusoid {
        ElasticSinusoid::complete_at(self.complete_contact_pressure_pa())
    }

    /// Critical aspect ratio B_c = sqrt(2) Sy/(3 pi E*) exp(2 (nu + 1)/3): the von Mises stress under a harmonic
    /// pressure reaches the strength just at complete contact.
    #[must_use]
    pub fn critical_aspect_ratio(&self) -> f64 {
        self.critical_aspect_ratio
    }

    /// Ratio r = B/B_c >= 0; at most 1 is elastic, and results above [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`] are not
    /// to be trusted.
    #[must_use]
    pub fn aspect_ratio_over_critical(&self) -> f64 {
        self.aspect_ratio_over_critical
    }

    /// Mean pressure of complete contact \[Pa\]: p*_ep = p* (11/(4 r + 7))^(3/5) for r > 1, else p*. The area
    /// fraction reaches 1 earlier, at [`flattening_pressure_pa`](Self::flattening_pressure_pa).
    #[must_use]
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.softened_pressure_pa(self.log_softening())
    }

    /// Mean pressure p_c = (C Sy/2)^3/(6 pi (E* B)^2) \[Pa\] of first yield, C = 1.295 exp(0.736 nu). It matters only
    /// for r > 1.
    #[must_use]
    pub fn critical_pressure_pa(&self) -> f64 {
        self.critical_pressure_pa
    }

    /// True if the sinusoid yields anywhere at the mean pressure p \[Pa\].
    #[must_use]
    pub fn yields_at(&self, pressure_pa: f64) -> bool {
        self.can_yield() && pressure_pa > self.critical_pressure_pa
    }

    /// True if r lies below the value from which results are flagged, [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`].
    #[must_use]
    pub fn in_fitted_range(&self) -> bool {
        self.aspect_ratio_over_critical <= FLAGGED_ASPECT_RATIO_OVER_CRITICAL
    }

    /// Fraction of the nominal area in contact, in (0, 1\], at the mean pressure p > 0 \[Pa\]: the elastic one for r
    /// <= 1 and up to p_c, else min(1, phi_p (1 - x^1.51) + phi_2 x^1.04), x = p/p*_ep < 1, and 1 from x = 1 on. The
    /// published fit is limited to 1, and steps up by up to 4 % at the critical pressure.
    #[must_use]
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        if self.yields_at(pressure_pa) {
            self.yielding_area().fraction_at(pressure_pa)
        } else {
            self.elastic.area_fraction(pressure_pa)
        }
    }

    /// Returns the area of the yielding sinusoid, r > 1 and p > p_c, with its constants precomputed for many
    /// pressures.
    #[must_use]
    pub fn yielding_area(&self) -> YieldingArea {
        self.yielding_area_at(self.log_softening())
    }

    /// [`yielding_area`](Self::yielding_area) with ln(p*_ep/p*) given. Always inlined, so that constants that the
    /// caller does not use are not computed.
    #[inline(always)]
    pub(crate) fn yielding_area_at(&self, log_softening: f64) -> YieldingArea {
        YieldingArea::new(YieldParameters {
            complete_contact_pressure_pa: self.softened_pressure_pa(log_softening),
            log_softening,
            slope_over_yield_slope: self.slope_over_yield_slope,
            log_yield_coefficient: self.log_yield_coefficient,
        })
    }

    /// Mean pressure \[Pa\] from which the area fraction is 1. For r > 1.5 or so it is below p*_ep, because the
    /// fitted area overshoots before it is limited to 1.
    #[must_use]
    pub fn flattening_pressure_pa(&self) -> f64 {
        if self.can_yield() {
            self.yielding_area().flattening_pressure_pa()
        } else {
            self.complete_contact_pressure_pa()
        }
    }

    /// Returns a smooth number that is positive above [`flattening_pressure_pa`](Self::flattening_pressure_pa) and
    /// negative below it, at mean pressures up to that of complete contact, for r > 1. A root of it is cheaper than
    /// the pressure itself.
    #[must_use]
    pub fn flattening_margin(&self, pressure_pa: f64) -> f64 {
        self.yielding_area().flattening_margin(pressure_pa)
    }

    /// Mean gap over amplitude g/Delta = (1 - x^(A1 x + A2))^(5/2) in \[0, 1), x = p/p*_ep, at the mean pressure p >
    /// 0 \[Pa\] (Rostami & Jackson 2013; Jackson & Jacobs, Eqs. 9-12); the elastic one for r <= 1 and up to p_c. It
    /// jumps upwards at the critical pressure, by the step of the deformation in
    /// [`deformation_breaks`](Self::deformation_breaks).
    #[must_use]
    pub fn mean_gap_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.mean_gap_over_amplitude(pressure_pa);
        }
        log_of_fraction(pressure_pa, self.complete_contact_pressure_pa())
            .map_or(0.0, |log_x| self.gap_exponent().gap_over_amplitude(log_x))
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta in \[0, 1\] at the mean pressure p > 0 \[Pa\]; 0 if it
    /// underflows, which takes r > 1e4.
    #[must_use]
    pub fn deformation_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.deformation_over_amplitude(pressure_pa);
        }
        let x = pressure_pa / self.complete_contact_pressure_pa();
        if x < 1.0 { self.gap_exponent().deformation_over_amplitude(x.ln(), x) } else { 1.0 }
    }

    /// Returns [`area_fraction`](Self::area_fraction) and
    /// [`deformation_over_amplitude`](Self::deformation_over_amplitude) at the mean pressure p > 0 \[Pa\]; the second
    /// costs little beside the first.
    #[must_use]
    pub fn area_and_deformation(&self, pressure_pa: f64) -> (f64, f64) {
        if !self.yields_at(pressure_pa) {
            let elastic = self.elastic;
            return (elastic.area_fraction(pressure_pa), elastic.deformation_over_amplitude(pressure_pa));
        }
        let area = self.yielding_area_at(self.log_softening());
        let x = pressure_pa / area.complete_contact_pressure_pa();
        if x >= 1.0 {
            return (1.0, 1.0);
        }
        let log_x = x.ln();
        (area.fraction_alone(x, log_x), self.gap_exponent().deformation_over_amplitude(log_x, x))
    }

    /// Mean pressures \[Pa\] at which the area is not smooth, in rising order.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let breaks = if self.can_yield() {
            [
                self.jump_at_first_yield(ElasticSinusoid::area_fraction, Self::area_fraction),
                Break::kink(self.flattening_pressure_pa(), "complete contact"),
            ]
        } else {
            self.elastic.area_breaks()
        };
        breaks.into_iter()
    }

    /// Mean pressures \[Pa\] at which the deformation, and so the mean gap, is not smooth, in rising order.
    pub fn deformation_breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let first_yield = self.can_yield().then(|| {
            self.jump_at_first_yield(
                ElasticSinusoid::deformation_over_amplitude,
                Self::deformation_over_amplitude,
            )
        });
        let complete = Break::kink(self.complete_contact_pressure_pa(), "the gap closes");
        first_yield.into_iter().chain([complete])
    }

    /// Jump of a result at p_c, from its elastic value there to its value just above.
    fn jump_at_first_yield(
        &self,
        elastic: fn(&ElasticSinusoid, f64) -> f64,
        yielding: fn(&Self, f64) -> f64,
    ) -> Break {
        let critical_pa = self.critical_pressure_pa;
        let just_above_pa = critical_pa * (1.0 + 2.0 * f64::EPSILON);
        let (below, above) = (elastic(&self.elastic, critical_pa), yielding(self, just_above_pa));
        Break::jump(critical_pa, "first yield at the critical pressure p_c", below, above)
    }

    /// True if r > 1; otherwise the sinusoid is elastic at any pressure.
    #[inline(always)]
    pub(crate) fn can_yield(&self) -> bool {
        self.aspect_ratio_over_critical > 1.0
    }

    /// Exponent of the mean gap under plastic flow, for r > 1.
    #[inline(always)]
    pub(crate) fn gap_exponent(&self) -> GapExponent {
        GapExponent::elastic_plastic(self.aspect_ratio_over_critical)
    }

    /// ln(p*_ep/p*), 0 for r <= 1.
    #[inline(always)]
    pub(crate) fn log_softening(&self) -> f64 {
        if self.can_yield() {
            0.6 * elementary::ln(11.0 / (4.0 * self.aspect_ratio_over_critical + 7.0))
        } else {
            0.0
        }
    }

    /// Pressure \[Pa\] that is p* times a factor, given as the logarithm of the factor.
    #[inline(always)]
    pub(crate) fn softened_pressure_pa(&self, log_factor: f64) -> f64 {
        self.elastic.complete_contact_pressure_pa() * elementary::exp(log_factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticBody;
    use crate::samples::{at_ratio, pair};

    #[test]
    fn at_most_the_critical_aspect_ratio_is_elastic_at_any_pressure() {
        let law = ElasticPlasticSinusoid::new(&pair(), 1e-4, 1e9);
        let critical = ElasticPlasticSinusoid::new(&pair(), law.critical_aspect_ratio(), 1e9);
        assert_eq!(critical.aspect_ratio_over_critical(), 1.0);
        for x in [1e-6, 0.1, 0.85, 1.2] {
            let pressure = x * critical.complete_contact_pressure_pa();
            assert_eq!(critical.area_fraction(pressure), critical.elastic().area_fraction(pressure));
        }
    }

    #[test]
    fn an_infinite_strength_is_elastic() {
        let law = ElasticPlasticSinusoid::new(&pair(), 0.05, f64::INFINITY);
        assert_eq!(law.aspect_ratio_over_critical(), 0.0);
        assert_eq!(law.area_fraction(1e9), law.elastic().area_fraction(1e9));
        assert_eq!(law.deformation_over_amplitude(1e9), law.elastic().deformation_over_amplitude(1e9));
    }

    #[test]
    fn results_stay_in_range_where_the_aspect_ratio_is_beyond_all_bounds() {
        let ends = [f64::from_bits(1), 1e-300, 1e-12, 1.0, 1e300];
        for (modulus_pa, strength_pa, aspect_ratio) in
            [(1e30, 1e-290, 1e3), (1e30, 2e-66, 8e76), (1e16, 9e-144, 6e63), (1e9, 1e9, 1e-300)]
        {
            let pair = MaterialPair::against_rigid(ElasticBody::new(modulus_pa, 0.0).unwrap());
            let law = ElasticPlasticSinusoid::new(&pair, aspect_ratio, strength_pa);
            assert!(law.aspect_ratio_over_critical() <= LARGEST_RATIO);
            for end in ends {
                let area_fraction = law.area_fraction(end);
                assert!(area_fraction > 0.0 && area_fraction <= 1.0, "{law:?}, p = {end}: {area_fraction}");
                assert!((0.0..=1.0).contains(&law.deformation_over_amplitude(end)), "{law:?}, p = {end}");
                let (pressure_pa, area_fraction) = law.pressure_and_area_at_interference(end);
                assert!(pressure_pa.is_finite(), "{law:?}, w/Delta = {end}: {pressure_pa}");
                assert!(area_fraction > 0.0 && area_fraction <= 1.0, "{law:?}, w/Delta = {end}");
            }
        }
    }

    #[test]
    fn area_and_deformation_together_are_those_of_each_alone() {
        for r in [0.5, 1.2, 37.0, 1e4] {
            let law = at_ratio(r);
            for x in [1e-12, 1e-3, 0.4, 0.999, 1.0, 3.0] {
                let pressure = x * law.complete_contact_pressure_pa();
                let alone = (law.area_fraction(pressure), law.deformation_over_amplitude(pressure));
                assert_eq!(law.area_and_deformation(pressure), alone, "r = {r}, x = {x}");
            }
        }
    }

    #[test]
    fn the_area_fraction_is_never_below_the_share_of_complete_contact() {
        for r in [0.5, 1.0001, 2.0, 37.0, 1e4] {
            let law = at_ratio(r);
            for i in 1..400 {
                let x = f64::from(i) / 399.0;
                assert!(law.area_fraction(x * law.complete_contact_pressure_pa()) >= x, "r = {r}, x = {x}");
            }
        }
    }

    #[test]
    fn the_area_steps_at_first_yield_by_up_to_the_published_four_percent() {
        let steps = (0..400)
            .map(|i| at_ratio(1.001 * 10f64.powf(f64::from(i) / 100.0)).breaks().next().unwrap().step);
        let largest = steps.map(f64::abs).fold(0.0, f64::max);
        assert!((0.035..0.041).contains(&largest), "{largest}");
    }

    #[test]
    fn the_area_steps_up_by_up_to_seven_percent_where_the_aspect_ratio_passes_the_critical_one() {
        let step = |x: f64| {
            let (elastic, plastic) = (at_ratio(1.0 - 1e-9), at_ratio(1.0 + 1e-9));
            let pressure = x * elastic.complete_contact_pressure_pa();
            plastic.area_fraction(pressure) / elastic.area_fraction(pressure) - 1.0
        };
        assert!((0.060..0.070).contains(&step(0.5)), "{}", step(0.5));
        assert!((0.030..0.070).contains(&step(0.3)), "{}", step(0.3));
    }

    #[test]
    fn the_deformation_drops_at_first_yield_as_published() {
        for (r, drop) in [(1.5, 0.07), (37.0, 0.69)] {
            let law = at_ratio(r);
            let critical = law.critical_pressure_pa;
            let above = law.deformation_over_amplitude(critical * (1.0 + 1e-12));
            let measured = 1.0 - above / law.deformation_over_amplitude(critical);
            assert!((measured - drop).abs() < 0.01, "r = {r}: {measured}");
            let announced = law.deformation_breaks().next().unwrap();
            assert!(
                (announced.step + measured).abs() < 1e-9 && announced.at == critical,
                "r = {r}: {announced:?}"
            );
        }
    }

    #[test]
    fn the_announced_pressures_are_in_rising_order() {
        for r in [0.3, 1.0001, 1.6, 37.0, 1e4] {
            let at: Vec<f64> = at_ratio(r).breaks().map(|b| b.at).collect();
            assert!(at.is_sorted() && at.len() == 2, "r = {r}: {at:?}");
        }
    }
}
