//! The elastic-plastic sinusoid: Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Jackson, Krithivasan & Wilson (2008).

use crate::elastic_sinusoid::{
    FULL_CONTACT_SLOPE, HEAVY_EXPONENT, LIGHT_EXPONENT, heavy_limit, log_of_fraction,
};
use crate::mean_gap::GapExponent;
use crate::root::newton_in_bracket;
use crate::{Break, ElasticSinusoid, MaterialPair};

/// Aspect ratio over the critical one above which results are flagged; no fitted range is published.
pub const FLAGGED_ASPECT_RATIO_OVER_CRITICAL: f64 = 100.0;

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
    /// p*_ep \[Pa\], p* where the aspect ratio is at most the critical one.
    complete_contact_pressure_pa: f64,
    critical_pressure_pa: f64,
    /// E* B/Sy, from which the exponent d of the plastic area follows.
    slope_over_yield_slope: f64,
    /// C Sy \[Pa\].
    yield_pressure_pa: f64,
    /// C Sy/(8 E* B), from which the critical area fraction follows.
    critical_area_root: f64,
}

impl ElasticPlasticSinusoid {
    /// A sinusoid of aspect ratio B = Delta/lambda > 0 and yield strength Sy > 0 \[Pa\]; an infinite strength is elastic.
    pub fn new(pair: &MaterialPair, aspect_ratio: f64, yield_strength_pa: f64) -> Self {
        debug_assert!(aspect_ratio > 0.0 && yield_strength_pa > 0.0);
        let elastic = ElasticSinusoid::new(pair, aspect_ratio);
        let slope_pa = pair.composite_modulus_pa() * aspect_ratio;
        let yield_pressure_pa = pair.spherical_yield_coefficient() * yield_strength_pa;
        let critical_aspect_ratio =
            pair.sinusoidal_yield_coefficient() * (yield_strength_pa / pair.composite_modulus_pa());
        let aspect_ratio_over_critical = aspect_ratio / critical_aspect_ratio;
        let softening = if aspect_ratio_over_critical > 1.0 {
            (11.0 / (4.0 * aspect_ratio_over_critical + 7.0)).powf(0.6)
        } else {
            1.0
        };
        ElasticPlasticSinusoid {
            elastic,
            critical_aspect_ratio,
            aspect_ratio_over_critical,
            complete_contact_pressure_pa: elastic.complete_contact_pressure_pa() * softening,
            // (C Sy/2)^3/(6 pi (E* B)^2), arranged so that no power over- or underflows.
            critical_pressure_pa: yield_pressure_pa * (yield_pressure_pa / slope_pa).powi(2)
                / (48.0 * std::f64::consts::PI),
            slope_over_yield_slope: slope_pa / yield_strength_pa,
            yield_pressure_pa,
            critical_area_root: yield_pressure_pa / (8.0 * slope_pa),
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
        self.complete_contact_pressure_pa
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
        let x = pressure_pa / self.complete_contact_pressure_pa;
        if x >= 1.0 {
            return 1.0;
        }
        let log_x = x.ln();
        let light = -self.plastic_area_fraction(pressure_pa) * (LIGHT_EXPONENT * log_x).exp_m1();
        let heavy = heavy_limit(x) * (HEAVY_EXPONENT * log_x).exp();
        (light + heavy).min(1.0)
    }

    /// Mean gap over amplitude g/Delta = (1 - x^(A1 x + A2))^(5/2) in \[0, 1), x = p/p*_ep, at the mean pressure p > 0
    /// \[Pa\] (Rostami & Jackson 2013; Jackson & Jacobs, Eqs. 9-12); the elastic one for r <= 1 and up to p_c. It jumps
    /// at the critical pressure, upwards, by the share of the deformation that
    /// [`deformation_breaks`](Self::deformation_breaks) tells.
    pub fn mean_gap_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.mean_gap_over_amplitude(pressure_pa);
        }
        log_of_fraction(pressure_pa, self.complete_contact_pressure_pa)
            .map_or(0.0, |log_x| self.gap_exponent().gap_over_amplitude(log_x))
    }

    /// Deformation over amplitude h_p/Delta = 1 - g/Delta in (0, 1] at the mean pressure p > 0 \[Pa\].
    pub fn deformation_over_amplitude(&self, pressure_pa: f64) -> f64 {
        if !self.yields_at(pressure_pa) {
            return self.elastic.deformation_over_amplitude(pressure_pa);
        }
        log_of_fraction(pressure_pa, self.complete_contact_pressure_pa)
            .map_or(1.0, |log_x| self.gap_exponent().deformation_over_amplitude(log_x))
    }

    /// Mean pressure \[Pa\] when the flat has descended by w > 0, given as w/Delta: the smaller of the elastic and the
    /// elastic-plastic one, since plastic flow can only soften; p*_ep from w = Delta on.
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        let elastic_pa = self.elastic.pressure_at_interference_pa(interference_over_amplitude);
        if self.aspect_ratio_over_critical <= 1.0 {
            elastic_pa
        } else if interference_over_amplitude >= 1.0 {
            self.complete_contact_pressure_pa
        } else {
            let log_x = self.gap_exponent().log_x_at(interference_over_amplitude);
            elastic_pa.min(self.complete_contact_pressure_pa * log_x.exp())
        }
    }

    /// Interference over amplitude at which the elastic-plastic mean gap is reached at the mean pressure p*_ep x, and its
    /// derivative by ln x, for r > 1 and ln x < 0. Explicit, where the pressure at an interference has to be solved for.
    pub fn flow_interference_over_amplitude(&self, log_x: f64) -> (f64, f64) {
        self.gap_exponent().deformation_and_slope(log_x)
    }

    /// ln x, p = p*_ep x, at which the elastic-plastic mean gap corresponds to an interference over amplitude in (0, 1),
    /// for r > 1.
    pub fn flow_log_pressure_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        self.gap_exponent().log_x_at(interference_over_amplitude)
    }

    /// Positive where plastic flow sets the pressure at an interference over amplitude in (0, 1): the logarithm of t,
    /// in the law x^(A1 x + A2) = t, that the elastic pressure would need, over the one that it has.
    pub fn flow_margin_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        if self.aspect_ratio_over_critical <= 1.0 {
            return -1.0;
        }
        let elastic_pa = self.elastic.pressure_at_interference_pa(interference_over_amplitude);
        let log_x = (elastic_pa / self.complete_contact_pressure_pa).ln();
        if log_x >= 0.0 {
            return 1.0;
        }
        let log_t = 0.5 * (elastic_pa / self.elastic.complete_contact_pressure_pa()).ln();
        self.gap_exponent().log_power(log_x) - log_t
    }

    /// Mean pressure \[Pa\] from which plastic flow sets the pressure at an interference, where r > 1.
    ///
    /// There is one: A2 > 1/2 makes the elastic pressure the smaller one at first, p*_ep < p* the larger one at complete
    /// contact, and the difference of the exponents has a single zero between.
    pub fn flow_onset_pressure_pa(&self) -> Option<f64> {
        if self.aspect_ratio_over_critical <= 1.0 {
            return None;
        }
        let exponent = self.gap_exponent();
        let softening = self.complete_contact_pressure_pa / self.elastic.complete_contact_pressure_pa();
        let log_x = exponent.log_x_where_half_power_is(softening.ln());
        Some(self.complete_contact_pressure_pa * log_x.exp())
    }

    /// Mean pressure \[Pa\] from which the area fraction is 1: x_full p*_ep, below p*_ep for r > 1.5 or so because the
    /// fitted area, held at 1, overshoots.
    pub fn flattening_pressure_pa(&self) -> f64 {
        if self.aspect_ratio_over_critical <= 1.0 {
            return self.complete_contact_pressure_pa;
        }
        let complete_pa = self.complete_contact_pressure_pa;
        // The area fraction minus one has a zero at x = 1; over 1 - x it has none there, and another one, at smaller x,
        // just where it is positive at x = 1.
        let excess = |short_of_one: f64| {
            let x = 1.0 - short_of_one;
            let plastic = self.plastic_area_fraction(x * complete_pa);
            plastic * opening(LIGHT_EXPONENT, short_of_one)
                - opening(HEAVY_EXPONENT, short_of_one)
                - FULL_CONTACT_SLOPE * x.powf(HEAVY_EXPONENT)
        };
        if excess(0.0) <= 0.0 {
            return complete_pa;
        }
        let short_of_one = newton_in_bracket(0.0, 1.0, 0.5, |u| {
            let step = 1e-6;
            let value = -excess(u);
            let ahead = -excess((u + step).min(1.0));
            (value, (ahead - value) / step)
        });
        (1.0 - short_of_one) * complete_pa
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
        let complete = Break::kink(self.complete_contact_pressure_pa, "the gap closes");
        first_yield.into_iter().chain(std::iter::once(complete))
    }

    /// Whether r lies below the value from which results are flagged, [`FLAGGED_ASPECT_RATIO_OVER_CRITICAL`].
    pub fn in_fitted_range(&self) -> bool {
        self.aspect_ratio_over_critical <= FLAGGED_ASPECT_RATIO_OVER_CRITICAL
    }

    fn gap_exponent(&self) -> GapExponent {
        GapExponent::elastic_plastic(self.aspect_ratio_over_critical)
    }

    /// phi_p = 2 (phi_c/2)^(1/(1+d)) [3 p/(4 C Sy)]^(d/(1+d)), with phi_c/2 = (C Sy/(8 E* B))^2/pi and
    /// d = 3.8 (E* B/Sy)^0.11.
    fn plastic_area_fraction(&self, pressure_pa: f64) -> f64 {
        let d = 3.8 * self.slope_over_yield_slope.powf(0.11);
        let log_half_critical_area = 2.0 * self.critical_area_root.ln() - std::f64::consts::PI.ln();
        let log_pressure = (0.75 * pressure_pa / self.yield_pressure_pa).ln();
        2.0 * ((log_half_critical_area + d * log_pressure) / (1.0 + d)).exp()
    }
}

/// (1 - (1 - u)^a)/u, a at u = 0.
fn opening(a: f64, u: f64) -> f64 {
    if u == 0.0 { a } else { -(a * (-u).ln_1p()).exp_m1() / u }
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
                let (flow, _) = law.flow_interference_over_amplitude(log_x);
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
            let ((low, _), (high, _)) = (
                law.flow_interference_over_amplitude(log_x - 1e-6),
                law.flow_interference_over_amplitude(log_x + 1e-6),
            );
            let (value, slope) = law.flow_interference_over_amplitude(log_x);
            assert!(((high - low) / 2e-6 / slope - 1.0).abs() < 1e-8);
            assert!(
                (law.flow_log_pressure_at_interference(value) - log_x).abs() < 1e-12 * log_x.abs().max(1.0)
            );
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
