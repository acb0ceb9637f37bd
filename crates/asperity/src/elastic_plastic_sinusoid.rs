//! The elastic-plastic sinusoid: Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Jackson, Krithivasan & Wilson (2008).

use numerics::newton_in_bracket;

use crate::elastic_sinusoid::log_of_fraction;
use crate::mean_gap::{GapExponent, power_at};
use crate::plastic_area::PlasticArea;
use crate::{Break, ElasticSinusoid, MaterialPair, elementary};

/// Aspect ratio over the critical one above which results are flagged; no fitted range is published.
pub const FLAGGED_ASPECT_RATIO_OVER_CRITICAL: f64 = 100.0;

/// Where r is held, so that nothing made of it overflows: some 300 decades beyond trust.
const LARGEST_RATIO: f64 = 1e300;

/// A sinusoidal surface, of one aspect ratio and strength, in contact with a flat: Krithivasan & Jackson (2007), as in
/// `docs/models.md`, section 2.4, with the mean gap of 2.5 and the interference of 2.6.
///
/// It is elastic where its aspect ratio is at most the critical one, and below the critical pressure p_c; elsewhere
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
    /// A sinusoid of aspect ratio B = Delta/lambda > 0 and yield strength Sy > 0 \[Pa\]; an infinite strength is elastic.
    #[inline]
    pub fn new(pair: &MaterialPair, aspect_ratio: f64, yield_strength_pa: f64) -> Self {
        debug_assert!(aspect_ratio > 0.0 && yield_strength_pa > 0.0);
        let elastic = ElasticSinusoid::new(pair, aspect_ratio);
        let slope_pa = pair.composite_modulus_pa() * aspect_ratio;
        let yield_pressure_pa = pair.spherical_yield_coefficient() * yield_strength_pa;
        let critical_aspect_ratio =
            pair.sinusoidal_yield_coefficient() * (yield_strength_pa / pair.composite_modulus_pa());
        let aspect_ratio_over_critical = (aspect_ratio / critical_aspect_ratio).min(LARGEST_RATIO);
        ElasticPlasticSinusoid {
            elastic,
            critical_aspect_ratio,
            aspect_ratio_over_critical,
            // (C Sy/2)^3/(6 pi (E* B)^2), arranged so that no power over- or underflows.
            critical_pressure_pa: yield_pressure_pa * (yield_pressure_pa / slope_pa).powi(2)
                / (48.0 * std::f64::consts::PI),
            slope_over_yield_slope: pair.sinusoidal_yield_coefficient() * aspect_ratio_over_critical,
            log_yield_coefficient: pair.log_spherical_yield_coefficient(),
        }
    }

    /// The same sinusoid without its strength.
    pub fn elastic(&self) -> ElasticSinusoid {
        self.elastic
    }

    /// Critical aspect ratio B_c = sqrt(2) Sy/(3 pi E*) exp(2 (nu + 1)/3): the von Mises stress under a harmonic
    /// pressure reaches the strength just at complete contact.
    pub fn critical_aspect_ratio(&self) -> f64 {
        self.critical_aspect_ratio
    }

    /// r = B/B_c >= 0; at most 1 is elastic, and above
    /// [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`] results are not to be trusted.
    pub fn aspect_ratio_over_critical(&self) -> f64 {
        self.aspect_ratio_over_critical
    }

    /// Mean pressure of complete contact \[Pa\]: p*_ep = p* (11/(4 r + 7))^(3/5) for r > 1, else p*. The area is complete
    /// at [`flattening_pressure_pa`](Self::flattening_pressure_pa) already.
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.softened_pressure_pa(self.log_softening())
    }

    /// Mean pressure p_c = (C Sy/2)^3/(6 pi (E* B)^2) \[Pa\] of first yield, C = 1.295 exp(0.736 nu). It counts only
    /// where r > 1.
    pub fn critical_pressure_pa(&self) -> f64 {
        self.critical_pressure_pa
    }

    /// Whether the sinusoid yields anywhere at the mean pressure p \[Pa\].
    pub fn yields_at(&self, pressure_pa: f64) -> bool {
        self.aspect_ratio_over_critical > 1.0 && pressure_pa > self.critical_pressure_pa
    }

    /// Fraction of the nominal area in contact, in (0, 1\], at the mean pressure p > 0 \[Pa\]: the elastic one for r <=
    /// 1 and up to p_c, else min(1, phi_p (1 - x^1.51) + phi_2 x^1.04), x = p/p*_ep < 1, and 1 from there on. The
    /// published fit is held at 1, and steps up by up to 4 % at the critical pressure.
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.area_fraction(pressure_pa);
        }
        self.yielding_area().fraction_at(pressure_pa)
    }

    /// The area of the yielding sinusoid, r > 1 and p > p_c, with its constants worked out: for many pressures.
    pub fn yielding_area(&self) -> YieldingArea {
        let log_softening = self.log_softening();
        YieldingArea {
            complete_contact_pressure_pa: self.softened_pressure_pa(log_softening),
            plastic: self.plastic_area(log_softening),
        }
    }

    /// Mean gap over amplitude g/Delta = (1 - x^(A1 x + A2))^(5/2) in \[0, 1), x = p/p*_ep, at the mean pressure p > 0
    /// \[Pa\] (Rostami & Jackson 2013; Jackson & Jacobs, Eqs. 9-12); the elastic one for r <= 1 and up to p_c. It jumps
    /// at the critical pressure, upwards, by the share of the deformation that
    /// [`deformation_breaks`](Self::deformation_breaks) tells.
    pub fn mean_gap_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.mean_gap_over_amplitude(pressure_pa);
        }
        log_of_fraction(pressure_pa, self.complete_contact_pressure_pa())
            .map_or(0.0, |log_x| self.gap_exponent().gap_over_amplitude(log_x))
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta in \[0, 1\] at the mean pressure p > 0 \[Pa\]; 0 where it
    /// underflows, which takes r beyond 1e4.
    pub fn deformation_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.deformation_over_amplitude(pressure_pa);
        }
        let x = pressure_pa / self.complete_contact_pressure_pa();
        if x < 1.0 { self.gap_exponent().deformation_over_amplitude(x.ln(), x) } else { 1.0 }
    }

    /// [`area_fraction`](Self::area_fraction) and [`deformation_over_amplitude`](Self::deformation_over_amplitude) at the
    /// mean pressure p > 0 \[Pa\], of which the second costs little beside the first.
    pub fn area_and_deformation(&self, pressure_pa: f64) -> (f64, f64) {
        if !self.yields_at(pressure_pa) {
            let elastic = self.elastic;
            return (elastic.area_fraction(pressure_pa), elastic.deformation_over_amplitude(pressure_pa));
        }
        let log_softening = self.log_softening();
        let x = pressure_pa / self.softened_pressure_pa(log_softening);
        if x >= 1.0 {
            return (1.0, 1.0);
        }
        let log_x = x.ln();
        let area_fraction = self.plastic_area(log_softening).fraction_alone(x, log_x);
        (area_fraction, self.gap_exponent().deformation_over_amplitude(log_x, x))
    }

    /// Mean pressure \[Pa\] when the flat has descended by w > 0, given as w/Delta: the smaller of the elastic and the
    /// elastic-plastic one, since plastic flow can only soften; p*_ep from w = Delta on.
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa();
        }
        self.pressed_to_power(power_at(interference_over_amplitude), self.gap_exponent()).pressure_pa
    }

    /// Mean pressure \[Pa\] and area fraction when the flat has descended by w > 0, given as w/Delta: those of
    /// [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) and [`area_fraction`](Self::area_fraction), at
    /// two thirds of their cost.
    pub fn pressure_and_area_at_interference(&self, interference_over_amplitude: f64) -> (f64, f64) {
        if interference_over_amplitude >= 1.0 {
            return (self.complete_contact_pressure_pa(), 1.0);
        }
        self.pressure_and_area_at_power(power_at(interference_over_amplitude))
    }

    /// The same at t = 1 - (1 - w/Delta)^(2/5) in (0, 1), for those who have it already.
    pub fn pressure_and_area_at_power(&self, t: f64) -> (f64, f64) {
        let Pressed { pressure_pa, flow } = self.pressed_to_power(t, self.gap_exponent());
        let area_fraction = match flow {
            Some(Flow { log_softening, x, log_x }) if self.yields_at(pressure_pa) => {
                if log_x < 0.0 {
                    self.plastic_area(log_softening).fraction(x, log_x)
                } else {
                    1.0
                }
            }
            _ => self.elastic.area_fraction(pressure_pa),
        };
        (pressure_pa, area_fraction)
    }

    /// The smaller of the elastic and the elastic-plastic pressure at t in (0, 1).
    #[inline]
    fn pressed_to_power(&self, t: f64, gap: GapExponent) -> Pressed {
        let elastic_pa = self.elastic.complete_contact_pressure_pa() * t * t;
        if self.aspect_ratio_over_critical <= 1.0 {
            return Pressed { pressure_pa: elastic_pa, flow: None };
        }
        let (log_t, log_softening) = (elementary::ln(t), self.log_softening());
        let log_x = 2.0 * log_t - log_softening;
        // Where the elastic pressure is the smaller one, nothing has to be solved for.
        if log_x < 0.0 {
            let x = elementary::exp(log_x);
            if gap.log_power(log_x, x) <= log_t {
                return Pressed { pressure_pa: elastic_pa, flow: Some(Flow { log_softening, x, log_x }) };
            }
        }
        let log_x = gap.log_x_at_power(log_t);
        let plastic_pa = self.softened_pressure_pa(log_softening + log_x);
        Pressed {
            pressure_pa: elastic_pa.min(plastic_pa),
            flow: Some(Flow { log_softening, x: elementary::exp(log_x), log_x }),
        }
    }

    /// The plastic branch with its constants worked out, for r > 1: for many pressures of one sinusoid.
    pub fn plastic_flow(&self) -> PlasticFlow {
        PlasticFlow { law: *self, gap: self.gap_exponent(), area: self.yielding_area() }
    }

    /// Positive where plastic flow sets the pressure at an interference over amplitude in (0, 1): the logarithm of t,
    /// in the law x^(A1 x + A2) = t, that the elastic pressure would need, over the one that it has.
    #[inline]
    pub fn flow_margin_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        self.flow_margin_at_power(power_at(interference_over_amplitude))
    }

    /// The same at t = 1 - (1 - w/Delta)^(2/5) in (0, 1), without a branch.
    #[inline(always)]
    pub fn flow_margin_at_power(&self, t: f64) -> f64 {
        let log_t = elementary::ln(t);
        let log_x = 2.0 * log_t - self.log_softening();
        let margin = self.gap_exponent().log_power(log_x, elementary::exp(log_x)) - log_t;
        if self.aspect_ratio_over_critical <= 1.0 {
            -1.0
        } else if log_x >= 0.0 {
            1.0
        } else {
            margin
        }
    }

    /// Mean pressure \[Pa\] from which plastic flow sets the pressure at an interference, where r > 1.
    ///
    /// There is one: A2 > 1/2 makes the elastic pressure the smaller one at first, p*_ep < p* the larger one at complete
    /// contact, and the difference of the exponents has a single zero between.
    pub fn flow_onset_pressure_pa(&self) -> Option<f64> {
        if self.aspect_ratio_over_critical <= 1.0 {
            return None;
        }
        let log_softening = self.log_softening();
        let log_x = self.gap_exponent().log_x_where_half_power_is(log_softening);
        Some(self.softened_pressure_pa(log_softening + log_x))
    }

    /// Mean pressure \[Pa\] from which the area fraction is 1: x_full p*_ep, below p*_ep for r > 1.5 or so because the
    /// fitted area, held at 1, overshoots.
    pub fn flattening_pressure_pa(&self) -> f64 {
        if self.aspect_ratio_over_critical <= 1.0 {
            return self.complete_contact_pressure_pa();
        }
        let YieldingArea { complete_contact_pressure_pa: complete_pa, plastic: area } = self.yielding_area();
        if area.overshoot(0.0).0 <= 0.0 {
            return complete_pa;
        }
        let short_of_one = newton_in_bracket(0.0, 1.0, 0.5, |u| {
            let (overshoot, slope) = area.overshoot(u);
            (-overshoot, -slope)
        });
        // Far below complete contact the difference to one has no digits for the share itself.
        if short_of_one < 0.5 { (1.0 - short_of_one) * complete_pa } else { area.full_from() * complete_pa }
    }

    /// Positive above [`flattening_pressure_pa`](Self::flattening_pressure_pa), negative below it, and smooth, at mean
    /// pressures up to that of complete contact, for r > 1: a root of it is cheaper than the pressure itself.
    pub fn flattening_margin(&self, pressure_pa: f64) -> f64 {
        let YieldingArea { complete_contact_pressure_pa: complete_pa, plastic: area } = self.yielding_area();
        area.overshoot(((complete_pa - pressure_pa) / complete_pa).max(0.0)).0
    }

    /// The mean pressures \[Pa\] at which the area is not smooth, in rising order.
    pub fn breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let yields = self.aspect_ratio_over_critical > 1.0;
        let elastic = (!yields).then(|| self.elastic.breaks());
        let plastic = yields.then(|| {
            let critical = self.critical_pressure_pa;
            let below = self.elastic.area_fraction(critical);
            let above = self.area_fraction(critical * (1.0 + 2.0 * f64::EPSILON));
            [
                Break::jump(critical, "first yield at the critical pressure p_c", below, above),
                Break::kink(self.flattening_pressure_pa(), "complete contact"),
            ]
        });
        elastic.into_iter().flatten().chain(plastic.into_iter().flatten())
    }

    /// The mean pressures \[Pa\] at which the deformation, and so the mean gap, is not smooth, in rising order.
    pub fn deformation_breaks(&self) -> impl Iterator<Item = Break> + use<> {
        let yields = self.aspect_ratio_over_critical > 1.0;
        let first_yield = yields.then(|| {
            let critical = self.critical_pressure_pa;
            let below = self.elastic.deformation_over_amplitude(critical);
            let above = self.deformation_over_amplitude(critical * (1.0 + 2.0 * f64::EPSILON));
            Break::jump(critical, "first yield at the critical pressure p_c", below, above)
        });
        let complete = Break::kink(self.complete_contact_pressure_pa(), "the gap closes");
        first_yield.into_iter().chain(std::iter::once(complete))
    }

    /// Whether r lies below the value from which results are flagged, [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`].
    pub fn in_fitted_range(&self) -> bool {
        self.aspect_ratio_over_critical <= FLAGGED_ASPECT_RATIO_OVER_CRITICAL
    }

    #[inline(always)]
    fn gap_exponent(&self) -> GapExponent {
        GapExponent::elastic_plastic(self.aspect_ratio_over_critical)
    }

    /// ln(p*_ep/p*).
    #[inline(always)]
    fn log_softening(&self) -> f64 {
        if self.aspect_ratio_over_critical <= 1.0 {
            return 0.0;
        }
        0.6 * elementary::ln(11.0 / (4.0 * self.aspect_ratio_over_critical + 7.0))
    }

    /// p* by a factor \[Pa\] given as its logarithm.
    #[inline(always)]
    fn softened_pressure_pa(&self, log_factor: f64) -> f64 {
        self.elastic.complete_contact_pressure_pa() * elementary::exp(log_factor)
    }

    /// phi_p = 2 (phi_c/2)^(1/(1+d)) [3 p/(4 C Sy)]^(d/(1+d)), with phi_c/2 = (C Sy/(8 E* B))^2/pi and
    /// d = 3.8 (E* B/Sy)^0.11, as a power of x = p/p*_ep. With s = E* B/Sy, 3 p*_ep/(4 C Sy) is
    /// (3 sqrt(2) pi/4) s/C times the softening.
    #[inline(always)]
    fn plastic_area(&self, log_softening: f64) -> PlasticArea {
        const LN_8: f64 = 2.079_441_541_679_835_9;
        const LN_PI: f64 = 1.144_729_885_849_400_2;
        const LN_3_SQRT_2_PI_OVER_4: f64 = 1.203_621_403_677_591_9;
        let log_slope = elementary::ln(self.slope_over_yield_slope);
        let d = 3.8 * elementary::exp(0.11 * log_slope);
        let log_half_critical_area = 2.0 * (self.log_yield_coefficient - LN_8 - log_slope) - LN_PI;
        let log_complete = LN_3_SQRT_2_PI_OVER_4 - self.log_yield_coefficient + log_slope + log_softening;
        PlasticArea {
            log_factor: std::f64::consts::LN_2 + (log_half_critical_area + d * log_complete) / (1.0 + d),
            exponent: d / (1.0 + d),
        }
    }
}

/// A mean pressure \[Pa\], and where r > 1 what was worked out on the way to it.
struct Pressed {
    pressure_pa: f64,
    flow: Option<Flow>,
}

/// ln(p*_ep/p*), and x = p/p*_ep with its logarithm.
struct Flow {
    log_softening: f64,
    x: f64,
    log_x: f64,
}

/// A sinusoid on its plastic branch, r > 1, with what does not depend on the pressure worked out
/// ([`ElasticPlasticSinusoid::plastic_flow`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticFlow {
    law: ElasticPlasticSinusoid,
    gap: GapExponent,
    area: YieldingArea,
}

/// What a sinusoid answers where plastic flow sets its pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowPoint {
    /// w/Delta at which the elastic-plastic mean gap is reached.
    pub interference_over_amplitude: f64,
    /// Its derivative by ln p.
    pub slope_by_log_pressure: f64,
    /// Mean pressure \[Pa\].
    pub pressure_pa: f64,
    /// Fraction of the nominal area in contact.
    pub area_fraction: f64,
}

impl PlasticFlow {
    /// [`ElasticPlasticSinusoid::complete_contact_pressure_pa`].
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.area.complete_contact_pressure_pa
    }

    /// The point at ln x < 0 and x, p = p*_ep x, without a branch, where the sinusoid yields.
    #[inline(always)]
    pub fn yielding_at(&self, x: f64, log_x: f64) -> FlowPoint {
        let (interference_over_amplitude, slope_by_log_pressure) = self.gap.deformation_and_slope(log_x, x);
        FlowPoint {
            interference_over_amplitude,
            slope_by_log_pressure,
            pressure_pa: self.area.complete_contact_pressure_pa * x,
            area_fraction: self.area.plastic.fraction(x, log_x),
        }
    }

    /// The fraction of the area at p = p*_ep x, x < 1, without a branch, where the sinusoid yields.
    #[inline(always)]
    pub fn yielding_area_fraction(&self, x: f64) -> f64 {
        self.area.plastic.fraction(x, elementary::ln(x))
    }

    /// The point at ln x < 0, p = p*_ep x. Explicit, where the pressure at an interference has to be solved for.
    pub fn at_log_pressure(&self, log_x: f64) -> FlowPoint {
        let x = log_x.exp();
        let (interference_over_amplitude, slope_by_log_pressure) = self.gap.deformation_and_slope(log_x, x);
        let pressure_pa = self.area.complete_contact_pressure_pa * x;
        let area_fraction = if self.law.yields_at(pressure_pa) {
            self.area.plastic.fraction(x, log_x)
        } else {
            self.law.elastic.area_fraction(pressure_pa)
        };
        FlowPoint { interference_over_amplitude, slope_by_log_pressure, pressure_pa, area_fraction }
    }

    /// [`ElasticPlasticSinusoid::pressure_at_interference_pa`].
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa();
        }
        self.law.pressed_to_power(power_at(interference_over_amplitude), self.gap).pressure_pa
    }

    /// ln x, p = p*_ep x, at which the elastic-plastic mean gap corresponds to an interference over amplitude in (0, 1).
    pub fn log_pressure_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        self.gap.log_x_at(interference_over_amplitude)
    }

    /// [`ElasticPlasticSinusoid::area_fraction`].
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        if self.law.yields_at(pressure_pa) {
            self.area.fraction_at(pressure_pa)
        } else {
            self.law.elastic.area_fraction(pressure_pa)
        }
    }
}

/// The area of a sinusoid that yields, with what does not depend on the pressure worked out
/// ([`ElasticPlasticSinusoid::yielding_area`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldingArea {
    complete_contact_pressure_pa: f64,
    plastic: PlasticArea,
}

impl YieldingArea {
    /// [`ElasticPlasticSinusoid::area_fraction`] where the sinusoid yields at the mean pressure p \[Pa\].
    pub fn fraction_at(&self, pressure_pa: f64) -> f64 {
        let x = pressure_pa / self.complete_contact_pressure_pa;
        if x < 1.0 { self.plastic.fraction_alone(x, x.ln()) } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticBody;

    fn pair() -> MaterialPair {
        MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap())
    }

    /// A UNCD sinusoid of r times the critical aspect ratio.
    fn at_ratio(r: f64) -> ElasticPlasticSinusoid {
        let critical = ElasticPlasticSinusoid::new(&pair(), 1.0, 1.8e9).critical_aspect_ratio();
        ElasticPlasticSinusoid::new(&pair(), r * critical, 1.8e9)
    }

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
    fn the_area_is_complete_just_above_the_flattening_pressure_however_low_that_is() {
        for strength_pa in [1e-20, 1e-12, 1e-3, 1e3, 1e8] {
            let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.2).unwrap());
            let law = ElasticPlasticSinusoid::new(&pair, 0.1, strength_pa);
            let flattening_pa = law.flattening_pressure_pa();
            assert_eq!(law.area_fraction(flattening_pa * (1.0 + 1e-12)), 1.0, "Sy = {strength_pa}");
            let below = law.area_fraction(flattening_pa * (1.0 - 1e-6));
            assert!(below < 1.0 && below > 1.0 - 1e-5, "Sy = {strength_pa}: {below}");
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

    /// What lets a stack tell a flattened scale from a steeper one that was flattened before.
    #[test]
    fn a_steeper_sinusoid_takes_more_pressure_to_flatten_up_to_four_thousand_critical_aspect_ratios() {
        for poisson_ratio in [-0.99, 0.0, 0.2, 0.5] {
            let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, poisson_ratio).unwrap());
            let critical = ElasticPlasticSinusoid::new(&pair, 1.0, 1e9).critical_aspect_ratio();
            let flattening_pa: Vec<f64> = (-100..=1200)
                .map(|i| critical * 4000f64.powf(f64::from(i) / 1200.0))
                .map(|b| ElasticPlasticSinusoid::new(&pair, b, 1e9).flattening_pressure_pa())
                .collect();
            assert!(flattening_pa.is_sorted_by(|flatter, steeper| flatter < steeper), "nu = {poisson_ratio}");
        }
    }

    #[test]
    fn the_fit_flattens_before_complete_contact_as_published() {
        let at = |r: f64| at_ratio(r).flattening_pressure_pa() / at_ratio(r).complete_contact_pressure_pa();
        assert!((at(37.0) - 0.50).abs() < 0.005, "{}", at(37.0));
        assert_eq!(at(1.2), 1.0);
        assert!(at(2.0) < 1.0);
    }

    #[test]
    fn the_area_is_complete_from_the_flattening_pressure_on_and_not_before() {
        for r in [1.05, 1.49, 1.6, 3.0, 37.0, 1e3, 1e5] {
            let law = at_ratio(r);
            let flat = law.flattening_pressure_pa();
            for i in 1..2000 {
                let pressure = law.complete_contact_pressure_pa() * f64::from(i) / 1500.0;
                let complete = law.area_fraction(pressure) == 1.0;
                let clear = (pressure / flat - 1.0).abs() > 1e-9;
                assert!(!clear || complete == (pressure > flat), "r = {r}, p/p_flat = {}", pressure / flat);
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

    #[test]
    fn plastic_flow_sets_the_pressure_from_its_onset_on() {
        for r in [1.001, 1.5, 37.0, 310.0, 1e4] {
            let law = at_ratio(r);
            let onset = law.flow_onset_pressure_pa().unwrap();
            for factor in [0.3, 0.999, 1.001, 1.5] {
                let pressure = onset * factor;
                let elastic = law.elastic().deformation_over_amplitude(pressure);
                let log_x = (pressure / law.complete_contact_pressure_pa()).ln();
                if log_x >= 0.0 {
                    continue;
                }
                let flow = law.plastic_flow().at_log_pressure(log_x).interference_over_amplitude;
                assert!((flow > elastic) == (factor > 1.0), "r = {r}, {factor} of the onset");
                let interference = flow.max(elastic);
                assert!((law.flow_margin_at_interference(interference) > 0.0) == (factor > 1.0), "r = {r}");
                let back = law.pressure_at_interference_pa(interference);
                assert!((back / pressure - 1.0).abs() < 1e-9, "r = {r}, {factor}: {back} {pressure}");
            }
        }
        assert_eq!(at_ratio(0.9).flow_onset_pressure_pa(), None);
        assert!(at_ratio(0.9).flow_margin_at_interference(0.5) < 0.0);
    }

    #[test]
    fn the_slope_of_the_interference_is_its_derivative() {
        let law = at_ratio(37.0);
        for log_x in [-20.0, -3.0, -0.1] {
            let at = |log_x| law.plastic_flow().at_log_pressure(log_x);
            let (low, point, high) = (at(log_x - 1e-6), at(log_x), at(log_x + 1e-6));
            let rise = high.interference_over_amplitude - low.interference_over_amplitude;
            assert!((rise / 2e-6 / point.slope_by_log_pressure - 1.0).abs() < 1e-8);
            let back = law.plastic_flow().log_pressure_at_interference(point.interference_over_amplitude);
            assert!((back - log_x).abs() < 1e-12 * log_x.abs().max(1.0));
            assert!((point.area_fraction / law.area_fraction(point.pressure_pa) - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn plastic_flow_only_softens_the_sinusoid_pressed_to_an_interference() {
        for r in [0.9, 1.1, 2.0, 37.0, 300.0] {
            let law = at_ratio(r);
            let mut last = 0.0;
            for exponent in -48..=4 {
                let interference = 10f64.powf(f64::from(exponent) / 4.0);
                let pressure = law.pressure_at_interference_pa(interference);
                assert!(pressure <= law.elastic().pressure_at_interference_pa(interference));
                assert!(pressure >= last, "r = {r}, w/Delta = {interference}");
                last = pressure;
            }
        }
    }
}
