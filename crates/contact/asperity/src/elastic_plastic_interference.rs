//! The elastic-plastic sinusoid pressed to an interference w: `docs/theory/models.md`, section 2.6.
//!
//! The mean gap is g/Delta = (1 - t)^(5/2) on both branches: on the elastic one with t = (p/p*)^(1/2), on the plastic
//! one with t = x^(A1 x + A2), x = p/p*_ep. An interference gives t, and each branch a pressure; the smaller one
//! holds, because plastic flow can only soften. The elastic one, p* t^2, is explicit. The plastic one is solved for
//! in ln x, and only if the elastic one may be the larger.

use multiversion::multiversion;

use crate::ElasticPlasticSinusoid;
use crate::elementary;
use crate::lanes::{FEW, LANES, any, each, in_blocks, in_few};
use crate::mean_gap::{GapExponent, power_at, powers_at};

/// State of a sinusoid at an interference.
struct StateAtInterference {
    /// Smaller of the elastic and the plastic pressure \[Pa\].
    pressure_pa: f64,
    /// Ratio of `pressure_pa` to p*_ep; `log_x` is its logarithm.
    x: f64,
    log_x: f64,
}

/// States of N sinusoids at interferences below complete contact.
struct StatesAtInterferences<const N: usize> {
    pressures_pa: [f64; N],
    x: [f64; N],
    log_x: [f64; N],
}

impl ElasticPlasticSinusoid {
    /// Mean pressure \[Pa\] when the flat has descended by w > 0, given as w/Delta: the smaller of the elastic and
    /// the elastic-plastic one, because plastic flow can only soften; p*_ep from w = Delta on.
    #[must_use]
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        self.pressure_at_interference_by_pa(self.gap_exponent(), interference_over_amplitude)
    }

    /// [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) with the exponent of the gap precomputed.
    #[inline]
    pub(crate) fn pressure_at_interference_by_pa(
        &self,
        gap: GapExponent,
        interference_over_amplitude: f64,
    ) -> f64 {
        if interference_over_amplitude >= 1.0 {
            return self.complete_contact_pressure_pa();
        }
        let t = power_at(interference_over_amplitude);
        if self.can_yield() {
            self.state_at_power(t, gap, self.log_softening()).pressure_pa
        } else {
            self.elastic_pressure_pa(t)
        }
    }

    /// Returns [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) and
    /// [`area_fraction`](Self::area_fraction) when the flat has descended by w > 0, given as w/Delta, at two thirds
    /// of the cost of the two calls.
    #[must_use]
    pub fn pressure_and_area_at_interference(&self, interference_over_amplitude: f64) -> (f64, f64) {
        if interference_over_amplitude >= 1.0 {
            return (self.complete_contact_pressure_pa(), 1.0);
        }
        self.pressure_and_area_at_power(power_at(interference_over_amplitude))
    }

    /// Returns mean pressure \[Pa\] and area fraction at t = 1 - (1 - w/Delta)^(2/5) in (0, 1), for callers that
    /// already have t.
    #[must_use]
    pub fn pressure_and_area_at_power(&self, t: f64) -> (f64, f64) {
        if !self.can_yield() {
            let pressure_pa = self.elastic_pressure_pa(t);
            return (pressure_pa, self.elastic().area_fraction(pressure_pa));
        }
        let log_softening = self.log_softening();
        let state = self.state_at_power(t, self.gap_exponent(), log_softening);
        let area_fraction = self.area_of_state(
            &state,
            || self.elastic().area_fraction(state.pressure_pa),
            || self.yielding_area_at(log_softening).fraction(state.x, state.log_x),
        );
        (state.pressure_pa, area_fraction)
    }

    /// Computes [`pressure_and_area_at_interference`](Self::pressure_and_area_at_interference) at each of many
    /// interferences over amplitude, to the same digits at a fraction of the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn pressures_and_areas_at_interferences(
        &self,
        interferences_over_amplitude: &[f64],
        pressures_pa: &mut [f64],
        area_fractions: &mut [f64],
    ) {
        if self.can_yield() {
            elastic_plastic_at_each(self, interferences_over_amplitude, pressures_pa, area_fractions);
        } else {
            self.elastic().pressures_and_areas_at_interferences(
                interferences_over_amplitude,
                pressures_pa,
                area_fractions,
            );
        }
    }

    /// [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) at each of some interferences over amplitude,
    /// with the exponent of the gap precomputed.
    pub(crate) fn pressures_at_interferences_by(
        &self,
        gap: GapExponent,
        interferences_over_amplitude: &[f64],
        pressures_pa: &mut [f64],
    ) {
        if self.can_yield() {
            elastic_plastic_pressures(self, gap, interferences_over_amplitude, pressures_pa);
        } else {
            self.elastic().pressures_at_interferences(interferences_over_amplitude, pressures_pa);
        }
    }

    /// Returns a number that is positive where plastic flow sets the pressure at an interference over amplitude in
    /// (0, 1): in the law x^(A1 x + A2) = t, the ln t that the elastic pressure would need over the ln t that it has.
    #[inline]
    #[must_use]
    pub fn flow_margin_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        self.flow_margin_at_power(power_at(interference_over_amplitude))
    }

    /// [`flow_margin_at_interference`](Self::flow_margin_at_interference) at t = 1 - (1 - w/Delta)^(2/5) in (0, 1),
    /// without a branch.
    #[inline(always)]
    #[must_use]
    pub fn flow_margin_at_power(&self, t: f64) -> f64 {
        let log_t = elementary::ln(t);
        let log_x = 2.0 * log_t - self.log_softening();
        let margin = flow_margin(self.gap_exponent(), log_t, log_x, elementary::exp(log_x));
        if self.can_yield() { margin } else { -1.0 }
    }

    /// Mean pressure \[Pa\] from which plastic flow sets the pressure at an interference; `None` unless r > 1.
    ///
    /// It exists: A2 > 1/2 makes the elastic pressure the smaller one at first, p*_ep < p* the larger one at complete
    /// contact, and the difference of the exponents has a single zero between.
    #[must_use]
    pub fn flow_onset_pressure_pa(&self) -> Option<f64> {
        self.can_yield().then(|| {
            let log_softening = self.log_softening();
            let log_x = self.gap_exponent().log_x_where_half_power_is(log_softening);
            self.softened_pressure_pa(log_softening + log_x)
        })
    }

    /// Elastic pressure p* t^2 \[Pa\] at t in (0, 1).
    #[inline(always)]
    fn elastic_pressure_pa(&self, t: f64) -> f64 {
        self.elastic().complete_contact_pressure_pa() * t * t
    }

    /// Smaller of the elastic and the plastic pressure at t in (0, 1), for r > 1, from the exponent of the gap and
    /// ln(p*_ep/p*).
    #[inline(always)]
    fn state_at_power(&self, t: f64, gap: GapExponent, log_softening: f64) -> StateAtInterference {
        let elastic_pa = self.elastic_pressure_pa(t);
        let log_t = elementary::ln(t);
        let log_x = 2.0 * log_t - log_softening;
        let x = elementary::exp(log_x);
        // At the elastic pressure plastic flow would deform as much or less: the elastic pressure is the smaller one.
        if flow_margin(gap, log_t, log_x, x) <= 0.0 {
            return StateAtInterference { pressure_pa: elastic_pa, x, log_x };
        }
        let log_x = gap.log_x_at_power(log_t);
        let plastic_pa = self.softened_pressure_pa(log_softening + log_x);
        StateAtInterference { pressure_pa: elastic_pa.min(plastic_pa), x: elementary::exp(log_x), log_x }
    }

    /// States with the digits of [`state_at_power`](Self::state_at_power) at N interferences over amplitude, for r > 1.
    #[inline(always)]
    fn states_at<const N: usize>(
        &self,
        ratios: [f64; N],
        gap: GapExponent,
        log_softening: f64,
    ) -> StatesAtInterferences<N> {
        let t = if any::<N>(|i| ratios[i] < 1.0) { powers_at(ratios) } else { [1.0; N] };
        let log_t: [f64; N] = each(|i| elementary::ln(t[i]));
        let mut log_x: [f64; N] = each(|i| 2.0 * log_t[i] - log_softening);
        let mut x: [f64; N] = each(|i| elementary::exp(log_x[i]));
        let margins: [f64; N] = each(|i| flow_margin(gap, log_t[i], log_x[i], x[i]));
        let mut pressures_pa: [f64; N] = each(|i| self.elastic_pressure_pa(t[i]));
        let flows = |i: usize| (margins[i] > 0.0) & (ratios[i] < 1.0);
        if any::<N>(flows) {
            let flowing_log_x = gap.log_xs_at_powers(log_t, flows);
            let plastic_pa: [f64; N] = each(|i| self.softened_pressure_pa(log_softening + flowing_log_x[i]));
            let flowing_x: [f64; N] = each(|i| elementary::exp(flowing_log_x[i]));
            pressures_pa =
                each(|i| if flows(i) { pressures_pa[i].min(plastic_pa[i]) } else { pressures_pa[i] });
            log_x = each(|i| if flows(i) { flowing_log_x[i] } else { log_x[i] });
            x = each(|i| if flows(i) { flowing_x[i] } else { x[i] });
        }
        StatesAtInterferences { pressures_pa, x, log_x }
    }

    /// Area fraction of a state, given those of a sinusoid that has not yielded and of one that has.
    #[inline(always)]
    fn area_of_state(
        &self,
        state: &StateAtInterference,
        elastic: impl FnOnce() -> f64,
        yielding: impl FnOnce() -> f64,
    ) -> f64 {
        if !self.yields_at(state.pressure_pa) {
            elastic()
        } else if state.log_x < 0.0 {
            yielding()
        } else {
            1.0
        }
    }
}

/// Returns a number that is positive where plastic flow sets the pressure, at ln t and at ln x of the elastic pressure.
#[inline(always)]
fn flow_margin(gap: GapExponent, log_t: f64, log_x: f64, x: f64) -> f64 {
    let margin = gap.log_power(log_x, x) - log_t;
    if log_x >= 0.0 { 1.0 } else { margin }
}

/// Pressures \[Pa\] and area fractions of a sinusoid with r > 1 at interferences over amplitude. A block of numbers
/// skips a branch of the law that none of them takes.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn elastic_plastic_at_each(
    law: &ElasticPlasticSinusoid,
    interferences_over_amplitude: &[f64],
    pressures_pa: &mut [f64],
    area_fractions: &mut [f64],
) {
    let (gap, log_softening) = (law.gap_exponent(), law.log_softening());
    let (area, elastic) = (law.yielding_area_at(log_softening), law.elastic());
    let complete_pa = law.complete_contact_pressure_pa();
    in_blocks(interferences_over_amplitude, [pressures_pa, area_fractions], |ratios| {
        let StatesAtInterferences { pressures_pa, x, log_x } =
            law.states_at::<LANES>(ratios, gap, log_softening);
        let yields = |i: usize| law.yields_at(pressures_pa[i]);
        let elastic =
            if any::<LANES>(|i| !yields(i)) { elastic.area_fractions(pressures_pa) } else { [0.0; LANES] };
        let yielding =
            if any::<LANES>(yields) { each(|i| area.fraction(x[i], log_x[i])) } else { [0.0; LANES] };
        let area_fractions = each(|i| {
            let state = StateAtInterference { pressure_pa: pressures_pa[i], x: x[i], log_x: log_x[i] };
            let fraction = law.area_of_state(&state, || elastic[i], || yielding[i]);
            if ratios[i] >= 1.0 { 1.0 } else { fraction }
        });
        [each(|i| if ratios[i] >= 1.0 { complete_pa } else { pressures_pa[i] }), area_fractions]
    });
}

/// Pressures \[Pa\] of a sinusoid at interferences over amplitude, for few of them.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2"))]
fn elastic_plastic_pressures(
    law: &ElasticPlasticSinusoid,
    gap: GapExponent,
    interferences_over_amplitude: &[f64],
    pressures_pa: &mut [f64],
) {
    let (log_softening, complete_pa) = (law.log_softening(), law.complete_contact_pressure_pa());
    in_few(interferences_over_amplitude, pressures_pa, |ratios| {
        let pressures_pa = law.states_at::<FEW>(ratios, gap, log_softening).pressures_pa;
        each(|i| if ratios[i] >= 1.0 { complete_pa } else { pressures_pa[i] })
    });
}

#[cfg(test)]
mod tests {
    use crate::samples::{assert_batch_has_the_digits_of_each, at_ratio};

    #[test]
    fn many_interferences_have_the_digits_of_each() {
        for r in [0.5, 1.0, 1.0 + f64::EPSILON, 1.001, 1.5, 37.0, 310.0, 1e4, 1e8] {
            let law = at_ratio(r);
            let onset_pa = law.flow_onset_pressure_pa().unwrap_or(law.complete_contact_pressure_pa());
            let onset = law.elastic().deformation_over_amplitude(onset_pa);
            let breaks = law.breaks().map(|b| law.deformation_over_amplitude(b.at));
            let breaks: Vec<f64> = breaks.chain([onset, 1.0]).filter(|&at| at > 0.0).collect();
            assert_batch_has_the_digits_of_each(
                &breaks,
                &[f64::INFINITY],
                |ratio| law.pressure_and_area_at_interference(ratio),
                |ratios, pressures, areas| {
                    law.pressures_and_areas_at_interferences(ratios, pressures, areas);
                },
            );
            let flow = law.plastic_flow();
            assert_batch_has_the_digits_of_each(
                &breaks,
                &[f64::INFINITY],
                |ratio| (flow.pressure_at_interference_pa(ratio), 0.0),
                |ratios, pressures, others| {
                    flow.pressures_at_interferences(ratios, pressures);
                    others.fill(0.0);
                },
            );
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
