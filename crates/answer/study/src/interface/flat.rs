//! Gap and compliance that parts which are not flat add to those of their roughness.

use ::interface::conductance::RelativeStiffness;
use ::interface::flatness::Flatness;
use persson::elastic;
use persson::separation::{Separation, SeparationLaw};

use super::quantity::{Quantity, Slot};
use super::states::{InterfaceError, InterfaceStates};

/// Additions of one limit of flatness under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatnessAdds {
    /// Mean gap \[m\].
    pub gap_m: f64,
    /// Compliance per nominal area \[m/Pa\].
    pub compliance_m_per_pa: f64,
    /// Share of the nominal contact over which contact spreads.
    pub share: f64,
}

/// A quantity by both limits of flatness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatnessRange {
    /// The value with the deviation as a long wave of the surface.
    pub by_wave: f64,
    /// The value with the deviation as a cap.
    pub by_cap: f64,
}

impl FlatnessAdds {
    /// The stiffness of the addition over the contact modulus \[Pa\]; `None` if it adds no compliance, or less than the range of
    /// magnitudes has.
    fn stiffness(&self, modulus_pa: f64) -> Option<RelativeStiffness> {
        RelativeStiffness::new(self.compliance_m_per_pa.recip(), modulus_pa).ok()
    }

    /// Compares a limit with flat faces.
    fn new(limit: Separation, flat: Separation, share: f64) -> Self {
        FlatnessAdds {
            gap_m: (limit.mean_gap_m - flat.mean_gap_m).max(0.0),
            compliance_m_per_pa: (limit.stiffness_pa_per_m.recip() - flat.stiffness_pa_per_m.recip())
                .max(0.0),
            share,
        }
    }

    /// Compares a wave, by the law of the roughness with it, with flat faces; `deviation_pa` is the root of the variance of the
    /// pressure that flattens the wave.
    pub(super) fn of_wave(
        with_wave: &SeparationLaw,
        flat: Separation,
        pressure_pa: f64,
        deviation_pa: f64,
    ) -> Self {
        Self::new(with_wave.whole(pressure_pa), flat, elastic::area_fraction(pressure_pa, deviation_pa))
    }

    /// Compares a cap with flat faces. Around the contact the roughness keeps the gap of the nominal pressure.
    pub(super) fn of_cap(
        flatness: &Flatness,
        law: &SeparationLaw,
        flat: Separation,
        pressure_pa: f64,
        modulus_pa: f64,
    ) -> Self {
        let cap = flatness.cap(pressure_pa, modulus_pa);
        let inside_m = cap.mean_inside(|local_pa| law.whole(local_pa).mean_gap_m);
        let outside_m = cap.mean_outside(|gap_m| gap_m + flat.mean_gap_m);
        let of_roughness = cap.mean_inside(|local_pa| law.whole(local_pa).stiffness_pa_per_m);
        let compliance_m_per_pa = cap.compliance_m_per_pa() + of_roughness.recip();
        let limit =
            Separation { mean_gap_m: inside_m + outside_m, stiffness_pa_per_m: compliance_m_per_pa.recip() };
        Self::new(limit, flat, cap.share())
    }
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
        let Some([wave, cap]) = self.flatness_limits(load) else { return Ok(None) };
        let by_wave = self.with(&wave, quantity, load, flat)?;
        let by_cap = self.with(&cap, quantity, load, flat)?;
        Ok(by_wave.zip(by_cap).map(|(by_wave, by_cap)| FlatnessRange { by_wave, by_cap }))
    }

    fn with(
        &self,
        adds: &FlatnessAdds,
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
            let gas = gap_m.and_then(|gap_m| self.gas_over_wave(gap_m + adds.gap_m));
            Ok(gas.map(|gas| gas + in_series((flat - flat_gas).max(0.0), heat())))
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
