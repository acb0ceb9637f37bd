//! Limit of light loads as two numbers.

use crate::finite_elements::UnitSystem;

/// Law p = p00 exp(-u/u0), the limit of Persson's theory at light loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExponentialLaw {
    /// Decay length u0 > 0 \[m\].
    pub decay_length_m: f64,
    /// Reference pressure p00 > 0 \[Pa\].
    pub reference_pressure_pa: f64,
    /// Pressure \[Pa\] up to which it agrees with the whole law within the relative error [`share`](Self::share).
    pub holds_up_to_pa: f64,
    /// Relative error of the pressure up to [`holds_up_to_pa`](Self::holds_up_to_pa).
    pub share: f64,
}

impl ExponentialLaw {
    /// Pressure \[Pa\] at a gap \[m\].
    #[must_use]
    pub fn pressure_pa(&self, mean_gap_m: f64) -> f64 {
        self.reference_pressure_pa * (-mean_gap_m / self.decay_length_m).exp()
    }

    /// Parameters c0 and p0 of CalculiX in the given units: p = p0 exp(-ln(100) x/c0) at the clearance x, so that c0
    /// = ln(100) u0.
    #[must_use]
    pub fn calculix(&self, units: UnitSystem) -> [f64; 2] {
        [units.length(100f64.ln() * self.decay_length_m), units.pressure(self.reference_pressure_pa)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calculix_has_a_hundredth_of_the_pressure_at_its_clearance() {
        let law = ExponentialLaw {
            decay_length_m: 2e-6,
            reference_pressure_pa: 3e8,
            holds_up_to_pa: 1e6,
            share: 0.01,
        };
        let [clearance_mm, pressure_mpa] = law.calculix(UnitSystem::Millimetres);
        assert!((pressure_mpa / 300.0 - 1.0).abs() < 1e-15);
        assert!((clearance_mm / (4.605_170_185_988_092 * 2e-3) - 1.0).abs() < 1e-15);
        assert!((law.pressure_pa(1e-3 * clearance_mm) / 3e6 - 1.0).abs() < 1e-14);
    }
}
