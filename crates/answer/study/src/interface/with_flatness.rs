//! Quantities of parts that are not flat, by both limits.

use ::interface::flatness::Deviation;

use super::flat::FlatnessAdds;
use super::quantity::{Quantity, Slot};
use super::states::{InterfaceError, InterfaceStates};

/// A quantity by both limits of flatness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatnessRange {
    /// The value with the deviation as a long wave of the surface.
    pub by_wave: f64,
    /// The value with the deviation as a cap.
    pub by_cap: f64,
}

impl InterfaceStates<'_> {
    /// Changes a quantity of flat faces under a load to those of both limits of the flatness; `None` if flatness does not change it, or
    /// none is given.
    ///
    /// # Errors
    /// [`InterfaceError`] for what leaves the range of magnitudes.
    pub fn with_flatness(
        &self,
        quantity: Quantity,
        load: usize,
        flat: f64,
    ) -> Result<Option<FlatnessRange>, InterfaceError> {
        let Some((flatness, [wave, cap])) = self.request.flatness.zip(self.flatness_limits(load)) else {
            return Ok(None);
        };
        let (pressure_pa, modulus_pa) = (self.pressure_pa(load), self.modulus_pa());
        let by_wave = self.with(&wave, &flatness.ridge(pressure_pa, modulus_pa), quantity, load, flat)?;
        let by_cap = self.with(&cap, &flatness.cap(pressure_pa, modulus_pa), quantity, load, flat)?;
        Ok(by_wave.zip(by_cap).map(|(by_wave, by_cap)| FlatnessRange { by_wave, by_cap }))
    }

    fn with(
        &self,
        adds: &FlatnessAdds,
        deviation: &impl Deviation,
        quantity: Quantity,
        load: usize,
        flat: f64,
    ) -> Result<Option<f64>, InterfaceError> {
        let added = adds.stiffness(self.modulus_pa());
        let in_series = |flat: f64, added: Option<f64>| {
            added.map_or(flat, |added| (flat.recip() + added.recip()).recip())
        };
        let heat = || {
            let conductivities = self.request.conductivities.as_ref();
            added.zip(conductivities).map(|(added, of)| added.thermal_conductance_w_per_m2_k(of))
        };
        let current = || {
            let resistivities = self.request.resistivities.as_ref();
            added.zip(resistivities).map(|(added, of)| added.electrical_conductance_s_per_m2(of))
        };
        let with_gas = |gap: Quantity| -> Result<Option<f64>, InterfaceError> {
            let gap_m = self.gap_under(gap, self.pressure_pa(load));
            let flat_gas = gap_m.and_then(|gap_m| self.gas_over(gap_m)).unwrap_or(0.0);
            let over = |gap_m: Option<f64>| gap_m.and_then(|gap_m| self.gas_over(gap_m)).unwrap_or(0.0);
            let gas = deviation.mean_inside(|local_pa| over(self.gap_under(gap, local_pa)))
                + deviation.mean_outside(|beyond_m| over(gap_m.map(|gap_m| gap_m + beyond_m)));
            Ok(Some(gas + in_series((flat - flat_gas).max(0.0), heat())))
        };
        Ok(match quantity {
            Quantity::MeanGap | Quantity::YovanovichGap => Some(flat + adds.gap_m),
            Quantity::Stiffness => Some((flat.recip() + adds.compliance_m_per_pa).recip()),
            Quantity::ThermalConductance
            | Quantity::YovanovichConductance
            | Quantity::CooperMikicYovanovichConductance => Some(in_series(flat, heat())),
            Quantity::ElectricalConductance | Quantity::YovanovichElectricalConductance => {
                Some(in_series(flat, current()))
            }
            Quantity::ThermalResistance => {
                self.resistance(Quantity::ThermalConductance, load, flat, heat())?
            }
            Quantity::ElectricalResistance => {
                self.resistance(Quantity::ElectricalConductance, load, flat, current())?
            }
            Quantity::GasConductance | Quantity::ThermalConductanceWithGas => with_gas(Quantity::MeanGap)?,
            Quantity::YovanovichConductanceWithGas => with_gas(Quantity::YovanovichGap)?,
            _ => None,
        })
    }

    /// A resistance of the nominal area, in proportion to the inverse of a conductance, with an addition in series.
    fn resistance(
        &self,
        conductance: Quantity,
        load: usize,
        flat: f64,
        added: Option<f64>,
    ) -> Result<Option<f64>, InterfaceError> {
        let of_flat = self.value(Slot { quantity: conductance, load: Some(load), curve: None })?;
        Ok(of_flat.map(|of_flat| flat * (1.0 + added.map_or(0.0, |added| of_flat / added))))
    }

    /// Returns the volume per time \[m^3/s\] that at most passes a seal around the contact of faces that are not flat, by either limit, where
    /// both gaps add; `None` without a flatness or without a joint, and where contact spreads over all of it.
    #[must_use]
    pub fn leak_around_m3_per_s(&self, load: usize) -> Option<f64> {
        let (flatness, joint) = self.request.flatness.zip(self.request.seal?.joint)?;
        let (pressure_pa, modulus_pa) = (self.pressure_pa(load), self.modulus_pa());
        let gap_m = self.gap_under(Quantity::MeanGap, pressure_pa)?;
        let cube = |beyond_m: f64| (beyond_m + gap_m).powi(3);
        let by_ridge = flatness.ridge(pressure_pa, modulus_pa).mean_outside(cube);
        let mean_cube_m3 = by_ridge.max(flatness.cap(pressure_pa, modulus_pa).mean_outside(cube));
        (mean_cube_m3 > 0.0).then(|| joint.rate_m3_per_s(mean_cube_m3))
    }
}
