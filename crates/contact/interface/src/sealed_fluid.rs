//! The fluid that leaks through a seal: a liquid, or a gas that expands and slips; and the units of its leak rate.

use serde::{Deserialize, Serialize};
use units::{Bound, OutOfBounds, named};

use crate::gas::{GAS_CONSTANT_J_PER_MOL_K, NamedGas};

/// Factor of the Knudsen number in the flow of a gas that slips at both walls of a slot: 1 + 6 Kn for walls that scatter diffusely.
const SLIP: f64 = 6.0;
/// Share of the flow of a gas from which on its slip is named.
const NOTABLE_SLIP: f64 = 0.1;
/// Viscosity \[Pa s\] between those of gases, at most 3e-5 in common ones at room temperature, and of liquids, at least 2e-4.
const MOST_VISCOUS_GAS_PA_S: f64 = 8e-5;

/// Gas that leaks, by name, and its state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LeakingGas {
    /// The gas.
    pub gas: NamedGas,
    viscosity_pa_s: f64,
    temperature_k: f64,
    outlet_pressure_pa: f64,
}

/// Fluid that leaks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SealedFluid {
    /// A fluid that does not expand.
    Incompressible {
        /// Dynamic viscosity \[Pa s\].
        viscosity_pa_s: f64,
    },
    /// A gas, whose leak rate is its volume at the outlet.
    Gas(LeakingGas),
}

/// Unit of a leak rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum LeakUnit {
    /// Volume in cubic metres per second.
    #[serde(rename = "m^3/s")]
    CubicMetrePerSecond,
    /// Volume in millilitres per minute.
    #[serde(rename = "ml/min")]
    MillilitrePerMinute,
    /// Volume in cubic millimetres per second.
    #[serde(rename = "mm^3/s")]
    CubicMillimetrePerSecond,
    /// Pressure times volume of a gas, in millibars times litres per second.
    #[serde(rename = "mbar l/s")]
    MillibarLitrePerSecond,
    /// Pressure times volume of a gas, in pascals times cubic metres per second.
    #[serde(rename = "Pa m^3/s")]
    PascalCubicMetrePerSecond,
    /// Mass of a gas, in grams per year of 365.25 days.
    #[serde(rename = "g/year")]
    GramPerYear,
}

named!(LeakUnit, "unit of a leak rate", {
    CubicMetrePerSecond => "m^3/s",
    MillilitrePerMinute => "ml/min",
    CubicMillimetrePerSecond => "mm^3/s",
    MillibarLitrePerSecond => "mbar l/s",
    PascalCubicMetrePerSecond => "Pa m^3/s",
    GramPerYear => "g/year",
});

impl LeakingGas {
    /// Creates a gas at a temperature \[K\] that flows out against a pressure \[Pa\].
    ///
    /// # Errors
    /// [`OutOfBounds`] for a temperature outside of [`NamedGas::TEMPERATURES_K`], and unless the pressure is positive and within
    /// thirty decades of 1.
    pub fn new(gas: NamedGas, temperature_k: f64, outlet_pressure_pa: f64) -> Result<Self, OutOfBounds> {
        Ok(LeakingGas {
            gas,
            viscosity_pa_s: gas.viscosity_pa_s(temperature_k)?,
            temperature_k,
            outlet_pressure_pa: Bound::Magnitude.check("pressure at the outlet in Pa", outlet_pressure_pa)?,
        })
    }

    /// Volume at the outlet over that of an incompressible fluid, (p1 + p2)/(2 p2), with p1 - p2 the pressure drop \[Pa\].
    #[must_use]
    pub fn expansion(&self, pressure_drop_pa: f64) -> f64 {
        1.0 + 0.5 * pressure_drop_pa / self.outlet_pressure_pa
    }

    /// Flow through a slot \[m\] over that of a gas that does not slip, 1 + 6 Kn, with the mean free path at the mean of both
    /// pressures over the height of the slot. Above Kn = 1 it is an estimate.
    #[must_use]
    pub fn slip(&self, pressure_drop_pa: f64, slot_m: f64) -> f64 {
        let mean_pa = self.outlet_pressure_pa + 0.5 * pressure_drop_pa;
        1.0 + SLIP * self.gas.mean_free_path_m(self.temperature_k, mean_pa) / slot_m
    }

    /// Mass per volume at the outlet, of an ideal gas \[kg/m^3\].
    fn density_kg_per_m3(&self) -> f64 {
        self.outlet_pressure_pa * self.gas.molar_mass_kg_per_mol()
            / (GAS_CONSTANT_J_PER_MOL_K * self.temperature_k)
    }
}

impl SealedFluid {
    /// Dynamic viscosity \[Pa s\].
    #[must_use]
    pub fn viscosity_pa_s(&self) -> f64 {
        match self {
            SealedFluid::Incompressible { viscosity_pa_s } => *viscosity_pa_s,
            SealedFluid::Gas(gas) => gas.viscosity_pa_s,
        }
    }

    /// Volume that leaks over that of an incompressible fluid that sticks to the walls, under a pressure drop \[Pa\] through a slot \[m\].
    pub(crate) fn volume_factor(&self, pressure_drop_pa: f64, slot_m: f64) -> f64 {
        match self {
            SealedFluid::Incompressible { .. } => 1.0,
            SealedFluid::Gas(gas) => gas.expansion(pressure_drop_pa) * gas.slip(pressure_drop_pa, slot_m),
        }
    }

    /// Returns the slip of a gas, if it is notable, under a pressure drop \[Pa\] through a slot \[m\].
    #[must_use]
    pub fn notable_slip(&self, pressure_drop_pa: f64, slot_m: f64) -> Option<f64> {
        match self {
            SealedFluid::Incompressible { .. } => None,
            SealedFluid::Gas(gas) => {
                Some(gas.slip(pressure_drop_pa, slot_m)).filter(|slip| *slip > 1.0 + NOTABLE_SLIP)
            }
        }
    }

    /// Returns true if a viscosity is that of a gas, which is not named and so does not expand.
    #[must_use]
    pub fn is_unnamed_gas(&self) -> bool {
        matches!(self, SealedFluid::Incompressible { viscosity_pa_s } if *viscosity_pa_s < MOST_VISCOUS_GAS_PA_S)
    }
}

impl LeakUnit {
    /// Converts a volume per time \[m^3/s\] of a fluid; `None` for a unit that takes a gas, of another fluid.
    #[must_use]
    pub fn of(self, rate_m3_per_s: f64, fluid: &SealedFluid) -> Option<f64> {
        const YEAR_S: f64 = 365.25 * 86_400.0;
        let of_gas = |per_m3: fn(&LeakingGas) -> f64| match fluid {
            SealedFluid::Incompressible { .. } => None,
            SealedFluid::Gas(gas) => Some(per_m3(gas)),
        };
        let per_m3 = match self {
            LeakUnit::CubicMetrePerSecond => 1.0,
            LeakUnit::MillilitrePerMinute => 6e7,
            LeakUnit::CubicMillimetrePerSecond => 1e9,
            // 1 Pa m^3 is 10 mbar l.
            LeakUnit::MillibarLitrePerSecond => of_gas(|gas| 10.0 * gas.outlet_pressure_pa)?,
            LeakUnit::PascalCubicMetrePerSecond => of_gas(|gas| gas.outlet_pressure_pa)?,
            LeakUnit::GramPerYear => of_gas(|gas| 1e3 * YEAR_S * gas.density_kg_per_m3())?,
        };
        Some(per_m3 * rate_m3_per_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_gases_take_pressure_density_and_no_liquid() {
        let helium = LeakingGas::new(NamedGas::Helium, 300.0, 2e5).unwrap();
        let fluid = SealedFluid::Gas(helium);
        let of = |unit: LeakUnit| unit.of(1e-9, &fluid).unwrap();
        let known =
            |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
        known(of(LeakUnit::CubicMetrePerSecond), 1e-9);
        known(of(LeakUnit::MillilitrePerMinute), 0.06);
        known(of(LeakUnit::CubicMillimetrePerSecond), 1.0);
        known(of(LeakUnit::PascalCubicMetrePerSecond), 2e-4);
        // 1 mbar l = 100 Pa 1e-3 m^3.
        known(of(LeakUnit::MillibarLitrePerSecond), 2e-3);
        // 2e5 Pa 4.003 g/mol / (R 300 K) = 320.96 g/m^3.
        known(of(LeakUnit::GramPerYear), 1e-9 * 2e5 * 4.003 / (8.314_462_618 * 300.0) * 365.25 * 86_400.0);
        let water = SealedFluid::Incompressible { viscosity_pa_s: 1e-3 };
        let of_liquids: Vec<bool> = LeakUnit::ALL.iter().map(|unit| unit.of(1.0, &water).is_some()).collect();
        assert_eq!(of_liquids, [true, true, true, false, false, false]);
    }

    #[test]
    fn slip_is_notable_in_narrow_slots_of_a_gas() {
        let air = SealedFluid::Gas(LeakingGas::new(NamedGas::Air, 288.15, 101_325.0).unwrap());
        // 6 64 nm/h at 1 atm.
        assert!((air.notable_slip(1e-9, 384e-9).unwrap() - 2.0).abs() < 1e-9);
        assert_eq!(air.notable_slip(1e-9, 3.9e-6), None);
        assert!(air.notable_slip(1e-9, 3.8e-6).is_some());
        assert_eq!(SealedFluid::Incompressible { viscosity_pa_s: 1e-5 }.notable_slip(1e5, 1e-9), None);
    }

    #[test]
    fn an_unnamed_gas_is_known_by_its_viscosity() {
        let is_gas = |viscosity| SealedFluid::Incompressible { viscosity_pa_s: viscosity }.is_unnamed_gas();
        assert!(is_gas(1.8e-5) && !is_gas(2e-4));
        assert!(!SealedFluid::Gas(LeakingGas::new(NamedGas::Air, 300.0, 1e5).unwrap()).is_unnamed_gas());
        assert!(LeakingGas::new(NamedGas::Air, 100.0, 1e5).is_err());
        assert!(LeakingGas::new(NamedGas::Air, 300.0, 0.0).is_err());
    }
}
