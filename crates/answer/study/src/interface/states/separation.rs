//! Gap and stiffness under a load, of elastic peaks and of those that flow.

use persson::separation::Separation;
use persson::yielding::{SpotFactor, YieldedGap, YieldedSeparation, YieldingLaw};
use persson::{constant_hardness, elastic};

use super::InterfaceStates;

impl InterfaceStates<'_> {
    /// Returns the factors of spots that have flowed, each of which is computed for these inputs.
    pub(super) fn known_spots(&self) -> Vec<SpotFactor> {
        for load in 0..self.inputs.pressures.len() {
            let _ = self.separation(load);
        }
        self.spots.clone()
    }

    /// Mean gap \[m\] under any nominal pressure > 0 \[Pa\], of peaks that flow where a hardness is given; `None` where all has flowed.
    #[must_use]
    pub fn mean_gap_under_m(&self, pressure_pa: f64) -> Option<f64> {
        Some(self.gap_at(pressure_pa)?.mean_gap_m)
    }

    /// Gap and stiffness of elastic peaks under any nominal pressure > 0 \[Pa\].
    #[must_use]
    pub fn separation_under(&self, pressure_pa: f64) -> Separation {
        self.elastic.separation.whole(pressure_pa)
    }

    /// The share of the contact that has flowed under a load by the theory with a constant hardness; `None` without one.
    #[must_use]
    pub fn plastic_share(&self, load: usize) -> Option<f64> {
        let hardness_pa = self.inputs.hardness_pa?;
        let spread_pa = self.elastic.spread_pa(self.modulus_pa());
        Some(constant_hardness::areas(self.pressure_pa(load), spread_pa, hardness_pa).plastic_share())
    }

    /// Returns true if gap and stiffness leave out that peaks flow, as they do on a layer and where the hardness grows.
    #[must_use]
    pub fn leaves_out_yielding(&self) -> bool {
        self.inputs.hardness_grows || self.inputs.pair.layer_compliance().is_some()
    }

    pub(super) fn stiffness_pa_per_m(&self, load: usize) -> Option<f64> {
        let stiffness = self.separation(load)?.unloading_stiffness_pa_per_m;
        Some(stiffness).filter(|stiffness| stiffness.is_finite())
    }

    pub(super) fn finite_stiffness_pa_per_m(&self, pressure_pa: f64) -> Option<f64> {
        Some(self.elastic.separation.whole(pressure_pa).stiffness_pa_per_m)
            .filter(|stiffness| stiffness.is_finite())
    }

    /// The share in contact under any pressure \[Pa\] by the elastic theory.
    pub(super) fn elastic_area_fraction(&self, pressure_pa: f64) -> Option<f64> {
        Some(elastic::area_fraction(pressure_pa, self.elastic.spread_pa(self.modulus_pa())))
    }

    pub(super) fn elastic_separation(&self, load: usize) -> Separation {
        *self.elastic.separations[load].get_or_init(|| self.elastic.separation.whole(self.pressure_pa(load)))
    }

    /// Gap and stiffness under a load, of elastic peaks, or of those that flow at the hardness; `None` where all has flowed.
    pub(super) fn separation(&self, load: usize) -> Option<YieldedSeparation> {
        let Some(hardness_pa) = self.constant_hardness_pa() else {
            return Some(self.elastic_separation(load).into());
        };
        let find = || self.yielding().at(self.pressure_pa(load), hardness_pa, &self.spots[load]);
        *self.yielded[load].get_or_init(find)
    }

    /// Gap under any pressure \[Pa\]; `None` where all has flowed.
    pub(super) fn gap_at(&self, pressure_pa: f64) -> Option<YieldedGap> {
        match self.constant_hardness_pa() {
            Some(hardness_pa) => self.yielding().gap(pressure_pa, hardness_pa),
            None => Some(YieldedSeparation::from(self.elastic.separation.whole(pressure_pa)).gap),
        }
    }

    fn constant_hardness_pa(&self) -> Option<f64> {
        self.inputs.hardness_pa.filter(|_| !self.inputs.hardness_grows)
    }

    fn yielding(&self) -> &YieldingLaw {
        let spread_pa = || self.elastic.spread_pa(self.modulus_pa());
        self.elastic.yielding.get_or_init(|| YieldingLaw::new(&self.elastic.separation, spread_pa()))
    }
}
