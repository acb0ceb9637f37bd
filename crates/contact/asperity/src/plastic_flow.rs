//! Plastic branch of the elastic-plastic sinusoid: explicit in the pressure, for many pressures of one sinusoid.

use crate::ElasticPlasticSinusoid;
use crate::elementary;
use crate::mean_gap::GapExponent;
use crate::yielding_area::YieldingArea;

/// Plastic branch of a sinusoid, with the pressure-independent constants precomputed
/// ([`ElasticPlasticSinusoid::plastic_flow`]).
///
/// A sinusoid with r <= 1 has no plastic branch: only the functions documented as equal to those of
/// [`ElasticPlasticSinusoid`] are meaningful for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticFlow {
    law: ElasticPlasticSinusoid,
    gap: GapExponent,
    area: YieldingArea,
}

/// State of a sinusoid on its plastic branch.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FlowPoint {
    /// Interference over amplitude w/Delta at which the elastic-plastic mean gap is reached.
    pub interference_over_amplitude: f64,
    /// Derivative of w/Delta by ln p.
    pub slope_by_log_pressure: f64,
    /// Mean pressure \[Pa\].
    pub pressure_pa: f64,
    /// Fraction of the nominal area in contact.
    pub area_fraction: f64,
}

impl ElasticPlasticSinusoid {
    /// Returns the plastic branch with its constants precomputed for many pressures, for r > 1.
    #[must_use]
    pub fn plastic_flow(&self) -> PlasticFlow {
        PlasticFlow { law: *self, gap: self.gap_exponent(), area: self.yielding_area() }
    }
}

impl PlasticFlow {
    /// Equals [`ElasticPlasticSinusoid::complete_contact_pressure_pa`].
    #[must_use]
    pub fn complete_contact_pressure_pa(&self) -> f64 {
        self.area.complete_contact_pressure_pa()
    }

    /// Equals [`ElasticPlasticSinusoid::area_fraction`].
    #[must_use]
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        if self.law.yields_at(pressure_pa) {
            self.area.fraction_at(pressure_pa)
        } else {
            self.law.elastic().area_fraction(pressure_pa)
        }
    }

    /// Equals [`ElasticPlasticSinusoid::pressure_at_interference_pa`].
    #[must_use]
    pub fn pressure_at_interference_pa(&self, interference_over_amplitude: f64) -> f64 {
        self.law.pressure_at_interference_by_pa(self.gap, interference_over_amplitude)
    }

    /// Computes [`pressure_at_interference_pa`](Self::pressure_at_interference_pa) at each of some interferences over
    /// amplitude, to the same digits at a fraction of the cost.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn pressures_at_interferences(&self, interferences_over_amplitude: &[f64], pressures_pa: &mut [f64]) {
        self.law.pressures_at_interferences_by(self.gap, interferences_over_amplitude, pressures_pa);
    }

    /// State at p = p*_ep x, given ln x < 0. Explicit, whereas the pressure at an interference has to be solved for.
    #[must_use]
    pub fn at_log_pressure(&self, log_x: f64) -> FlowPoint {
        let flowing = self.yielding_at(log_x.exp(), log_x);
        if self.law.yields_at(flowing.pressure_pa) {
            return flowing;
        }
        FlowPoint { area_fraction: self.law.elastic().area_fraction(flowing.pressure_pa), ..flowing }
    }

    /// State at ln x < 0 and x, without a branch, where the sinusoid yields.
    #[inline(always)]
    #[must_use]
    pub fn yielding_at(&self, x: f64, log_x: f64) -> FlowPoint {
        let (interference_over_amplitude, slope_by_log_pressure) = self.gap.deformation_and_slope(log_x, x);
        FlowPoint {
            interference_over_amplitude,
            slope_by_log_pressure,
            pressure_pa: self.area.complete_contact_pressure_pa() * x,
            area_fraction: self.area.fraction(x, log_x),
        }
    }

    /// Area fraction at p = p*_ep x, x < 1, without a branch, where the sinusoid yields.
    #[inline(always)]
    #[must_use]
    pub fn yielding_area_fraction(&self, x: f64) -> f64 {
        self.area.fraction(x, elementary::ln(x))
    }

    /// ln x, p = p*_ep x, at which the elastic-plastic mean gap corresponds to an interference over amplitude in (0,
    /// 1).
    #[must_use]
    pub fn log_pressure_at_interference(&self, interference_over_amplitude: f64) -> f64 {
        self.gap.log_x_at(interference_over_amplitude)
    }
}

#[cfg(test)]
mod tests {
    use crate::samples::at_ratio;

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
}
