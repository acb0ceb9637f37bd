//! Unit systems of finite element models.

use units::named;

/// Units of length and force, and the resulting pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum UnitSystem {
    /// Metres and newtons: pascals.
    #[default]
    Si,
    /// Millimetres and newtons: megapascals.
    Millimetres,
    /// Micrometres and micronewtons: megapascals.
    Micrometres,
    /// Inches and pounds-force: pounds-force per square inch.
    Inches,
}

named!(UnitSystem, "system of units", {
    Si => "SI",
    Millimetres => "N-mm",
    Micrometres => "uN-um",
    Inches => "lbf-in",
});

impl UnitSystem {
    /// Units of length in metres and of pressure in pascals, and the symbols of those of length, force and pressure.
    const fn units(self) -> (f64, f64, [&'static str; 3]) {
        match self {
            UnitSystem::Si => (1.0, 1.0, ["m", "N", "Pa"]),
            UnitSystem::Millimetres => (1e-3, 1e6, ["mm", "N", "MPa"]),
            UnitSystem::Micrometres => (1e-6, 1e6, ["um", "uN", "MPa"]),
            // 0.45359237 kg under 9.80665 m/s^2 on the square of 0.0254 m.
            UnitSystem::Inches => (0.0254, 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254), ["in", "lbf", "psi"]),
        }
    }

    /// Unit of length in metres.
    #[must_use]
    pub const fn length_m(self) -> f64 {
        self.units().0
    }

    /// Unit of pressure in pascals.
    #[must_use]
    pub const fn pressure_pa(self) -> f64 {
        self.units().1
    }

    /// Symbol of the unit of length.
    #[must_use]
    pub const fn length_symbol(self) -> &'static str {
        self.units().2[0]
    }

    /// Symbol of the unit of force.
    #[must_use]
    pub const fn force_symbol(self) -> &'static str {
        self.units().2[1]
    }

    /// Symbol of the unit of pressure.
    #[must_use]
    pub const fn pressure_symbol(self) -> &'static str {
        self.units().2[2]
    }

    /// Converts a length \[m\] to these units.
    #[must_use]
    pub fn length(self, length_m: f64) -> f64 {
        length_m / self.length_m()
    }

    /// Converts a pressure \[Pa\] to these units.
    #[must_use]
    pub fn pressure(self, pressure_pa: f64) -> f64 {
        pressure_pa / self.pressure_pa()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_of_pressure_is_one_of_force_on_a_square_of_one_of_length() {
        let newtons = |units: UnitSystem| match units.force_symbol() {
            "uN" => 1e-6,
            "lbf" => 4.448_221_615_260_5,
            _ => 1.0,
        };
        for &units in UnitSystem::ALL {
            let pressure_pa = newtons(units) / units.length_m().powi(2);
            assert!((units.pressure_pa() / pressure_pa - 1.0).abs() < 1e-15, "{units}");
            assert_eq!(units.to_string().parse(), Ok(units));
        }
    }
}
