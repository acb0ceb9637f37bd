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
            let gap_m = self.value(Slot { quantity: gap, load: Some(load), curve: None })?;
            let flat_gas = gap_m.and_then(|gap_m| self.gas_over(gap_m)).unwrap_or(0.0);
            let over = |gap_m: Option<f64>| gap_m.and_then(|gap_m| self.gas_over(gap_m)).unwrap_or(0.0);
            let gas = deviation.mean_inside(|local_pa| over(self.gap_under(gap, local_pa)))
                + deviation.mean_outside(|beyond_m| over(gap_m.map(|gap_m| gap_m + beyond_m)));
            Ok(Some(gas + in_series((flat - flat_gas).max(0.0), heat())))
        };
        Ok(match quantity {
            Quantity::MeanGap | Quantity::FlowedGap => Some(flat + adds.gap_m),
            Quantity::Stiffness => Some((flat.recip() + adds.compliance_m_per_pa).recip()),
            Quantity::ThermalConductance
            | Quantity::YovanovichConductance
            | Quantity::CooperMikicYovanovichConductance => Some(in_series(flat, heat())),
            Quantity::ElectricalConductance | Quantity::FlowedElectricalConductance => {
                Some(in_series(flat, current()))
            }
            Quantity::GasConductance | Quantity::ThermalConductanceWithGas => with_gas(Quantity::MeanGap)?,
            Quantity::FlowedConductanceWithGas => with_gas(Quantity::FlowedGap)?,
            _ => None,
        })
    }
}
