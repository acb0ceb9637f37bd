//! Gap and compliance that parts which are not flat add to those of their roughness.
//!
//! As a wave, the deviation is one of the roughness in Persson's theory; as a cap, it is a smooth body on which the roughness has the local
//! pressure. Peaks that flow get the same additions, since the deviation stays elastic.

use ::interface::conductance::RelativeStiffness;
use ::interface::flatness::{Deviation, Ridge};
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

    /// Compares a wave, by the law of the roughness with it, with flat faces. A smooth ridge has its share.
    pub(super) fn of_wave(
        with_wave: &SeparationLaw,
        flat: Separation,
        ridge: &Ridge,
        pressure_pa: f64,
    ) -> Self {
        Self::new(with_wave.whole(pressure_pa), flat, ridge.share())
    }

    /// Compares a smooth deviation under the roughness with flat faces. Around the contact the roughness keeps the gap of the nominal
    /// pressure.
    pub(super) fn of(deviation: &impl Deviation, law: &SeparationLaw, flat: Separation) -> Self {
        let inside_m = deviation.mean_inside(|local_pa| law.whole(local_pa).mean_gap_m);
        let outside_m = deviation.mean_outside(|gap_m| gap_m + flat.mean_gap_m);
        let of_roughness = deviation.mean_inside(|local_pa| law.whole(local_pa).stiffness_pa_per_m);
        let compliance_m_per_pa = deviation.compliance_m_per_pa() + of_roughness.recip();
        let limit =
            Separation { mean_gap_m: inside_m + outside_m, stiffness_pa_per_m: compliance_m_per_pa.recip() };
        Self::new(limit, flat, deviation.share())
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
