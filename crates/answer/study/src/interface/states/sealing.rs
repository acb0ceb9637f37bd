//! The seal under a load: channels, leaks, and the pressure that closes it.

use ::interface::leak::LeakRate;
use persson::SealConductance;
use persson::sealing::MagnifiedContact;

use super::InterfaceStates;

impl InterfaceStates<'_> {
    /// The nominal pressure \[Pa\] from which a seal is closed because its bodies flow: they touch the share p/H at least.
    /// `None` without a seal or a hardness.
    #[must_use]
    pub fn closed_by_yielding_from_pa(&self) -> Option<f64> {
        Some(self.request.seal?.threshold.area_fraction() * self.inputs.hardness_pa?)
    }

    /// The nominal pressure \[Pa\] that closes a seal, elastically or as its bodies flow; `None` without a seal.
    pub(super) fn tight_pressure_pa(&self) -> Option<f64> {
        let elastic_pa = self.elastic.sealing.as_ref()?.tight_pressure_pa();
        Some(self.closed_by_yielding_from_pa().map_or(elastic_pa, |from_pa| from_pa.min(elastic_pa)))
    }

    pub(super) fn leak(&self, load: usize) -> Option<LeakRate> {
        let joint = self.request.seal?.joint?;
        let (conductance, area_fraction) = (self.seal_conductance(load)?, self.sealing_area_fraction(load)?);
        let SealConductance { medium_m3, parallel_m3, .. } = conductance;
        Some(joint.leak_rate([medium_m3, parallel_m3], area_fraction, self.longest_wave_m()))
    }

    fn is_closed_by_yielding(&self, load: usize) -> bool {
        self.closed_by_yielding_from_pa().is_some_and(|from_pa| self.pressure_pa(load) >= from_pa)
    }

    pub(super) fn constriction(&self, load: usize) -> Option<MagnifiedContact> {
        let pressure_pa = self.pressure_pa(load);
        if self.is_closed_by_yielding(load) {
            return None;
        }
        let find = || self.elastic.sealing.as_ref()?.critical_constriction(pressure_pa);
        *self.elastic.constrictions[load].get_or_init(find)
    }

    /// Computes the conductance of the gaps of a seal under a load; `None` without a seal and where it is tight.
    #[must_use]
    pub fn seal_conductance(&self, load: usize) -> Option<SealConductance> {
        if self.is_closed_by_yielding(load) {
            return None;
        }
        let conduct = || {
            let (sealing, flow) = self.elastic.sealing.as_ref().zip(self.elastic.flow.as_ref())?;
            let pressure_over_tight = self.pressure_pa(load) / sealing.tight_pressure_pa();
            flow.conductance(pressure_over_tight, self.separation(load)?.gap.mean_gap_m)
        };
        *self.conductances[load].get_or_init(conduct)
    }

    /// Returns the share of the area in contact under a load that decides a seal, by a fit to boundary elements; `None` without a seal.
    #[must_use]
    pub fn sealing_area_fraction(&self, load: usize) -> Option<f64> {
        Some(self.elastic.sealing.as_ref()?.area_fraction(self.pressure_pa(load)))
    }

    /// Returns the longest wave of the spectrum \[m\], without that of a part that is not flat.
    #[must_use]
    pub fn longest_wave_m(&self) -> f64 {
        self.inputs.results.psd.longest_wavelength_m()
    }
}
