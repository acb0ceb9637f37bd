//! State below one scale of a stack.

/// Response of a scale to the pressure that reaches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Regime {
    /// Partial contact without yielding.
    Elastic,
    /// Partial contact with yielding.
    Plastic,
    /// Complete contact, which changes nothing.
    Flattened,
}

units::named!(Regime, "regime", { Elastic => "elastic", Plastic => "plastic", Flattened => "flattened" });

/// Contact after one more scale of roughness has been taken into account.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Level {
    /// Wavelength of the scale \[m\].
    pub wavelength_m: f64,
    /// Amplitude of the scale \[m\].
    pub amplitude_m: f64,
    /// Mean pressure \[Pa\] on the contact before this scale.
    pub pressure_in_pa: f64,
    /// Mean pressure \[Pa\] on the contact after this scale, the load over the real area.
    pub real_pressure_pa: f64,
    /// Contact area over nominal area, in (0, 1].
    pub area_fraction: f64,
    /// Yield strength \[Pa\] at this scale; `None` in the elastic model, infinite if nothing was deformed above.
    pub yield_strength_pa: Option<f64>,
    /// Aspect ratio over the critical one, r = B/B_c, 0 for an infinite strength; `None` in the elastic model. Above
    /// 100 the law is not to be trusted.
    pub aspect_ratio_over_critical: Option<f64>,
    /// Regime of the scale.
    pub regime: Regime,
}

impl approx::AbsDiffEq for Level {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        0.0
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.agrees(other, |a, b| f64::abs_diff_eq(&a, &b, epsilon))
    }
}

impl approx::RelativeEq for Level {
    fn default_max_relative() -> f64 {
        f64::default_max_relative()
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        self.agrees(other, |a, b| f64::relative_eq(&a, &b, epsilon, max_relative))
    }
}

impl Level {
    fn agrees(&self, other: &Self, close: impl Fn(f64, f64) -> bool) -> bool {
        let optional = |pair| match pair {
            (Some(a), Some(b)) => close(a, b),
            (a, b) => a == b,
        };
        let numbers =
            |l: &Self| [l.wavelength_m, l.amplitude_m, l.pressure_in_pa, l.real_pressure_pa, l.area_fraction];
        self.regime == other.regime
            && optional((self.yield_strength_pa, other.yield_strength_pa))
            && optional((self.aspect_ratio_over_critical, other.aspect_ratio_over_critical))
            && numbers(self).into_iter().zip(numbers(other)).all(|(a, b)| close(a, b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_compare_by_relative_tolerance() {
        let level = Level {
            wavelength_m: 1e-6,
            amplitude_m: 1e-8,
            pressure_in_pa: 2e9,
            real_pressure_pa: 3e9,
            area_fraction: 0.2,
            yield_strength_pa: Some(1.8e9),
            aspect_ratio_over_critical: Some(8.0),
            regime: Regime::Plastic,
        };
        let near = Level { area_fraction: level.area_fraction * (1.0 + 1e-12), ..level };
        approx::assert_relative_eq!(level, near, max_relative = 1e-11);
        approx::assert_relative_ne!(level, near, max_relative = 1e-13);
        approx::assert_relative_ne!(level, Level { regime: Regime::Flattened, ..level }, max_relative = 1.0);
    }
}
