//! Draws of the quantities of an interface.

use scene::Scene;
use study::Progress;
use study::interface::{InterfaceInputs, InterfaceStates};
use study::interface::{Quantity, Slot};
use study::plan::{Needs, Plan, Results};

use spectrum::ProfilePsd;

use crate::inputs::Inputs;
use crate::material_draws::DrawnMaterial;
use crate::quantiles::{Interval, interval, percentiles_about};
use crate::results::{AreaInterval, OpenChannel, QuantityInterval};
use crate::surface_scatter::DrawOf;

/// The requested quantities of an interface, for many spectra and bodies.
#[derive(Debug)]
pub(crate) struct Quantities<'p> {
    scene: &'p Scene,
    results: &'p Results,
    slots: Vec<Slot>,
}

/// The smallest share of draws that must have a value for a quantity to have an interval.
const MIN_SHARE_WITH_VALUE: f64 = 0.9;

/// The results of the draws.
#[derive(Debug, Default)]
pub(crate) struct QuantityDraws {
    pub intervals: Vec<QuantityInterval>,
    pub open_channels: Vec<OpenChannel>,
}

impl<'p> Quantities<'p> {
    /// The quantities of a scene; `None` if it requests none.
    pub fn from_scene(scene: &'p Scene, results: &'p Results) -> Option<Self> {
        let slots = scene.interface_states(results)?.slots();
        Some(Quantities { scene, results, slots })
    }

    /// Computes the intervals of all quantities with a value from the first `draws` draws, at a level; empty if cancelled. A
    /// quantity from the area of a curve takes the interval of that area. `progress` advances once per draw.
    pub fn intervals(
        &self,
        inputs: &Inputs,
        draws: usize,
        level: f64,
        areas: &[AreaInterval],
        progress: &dyn Progress,
    ) -> QuantityDraws {
        let numbers: Vec<u64> = (0..draws as u64).collect();
        let of_draw = |&number: &u64| {
            if progress.is_cancelled() {
                return None;
            }
            let found = self.draw(inputs, DrawOf::all(number));
            progress.advance(1);
            found
        };
        let drawn: Vec<Option<Vec<Option<f64>>>> = numerics::parallel::map(&numbers, of_draw);
        if progress.is_cancelled() || drawn.iter().all(Option::is_none) {
            return QuantityDraws::default();
        }
        let best = inputs.surface_scatters().then(|| self.best(inputs)).flatten();
        let Some(plain) = self.scene.interface_states(self.results) else {
            return QuantityDraws::default();
        };
        let of_slot = |(at, slot): (usize, &Slot)| {
            let value = plain.value(*slot).ok().flatten()?;
            if let Some(curve) = slot.curve {
                let is_its = |area: &&AreaInterval| area.curve == curve && Some(area.load) == slot.load;
                return areas
                    .iter()
                    .find(is_its)
                    .map(|area| QuantityInterval::in_proportion(*slot, value, area));
            }
            let ln_values: Vec<f64> = drawn.iter().filter_map(|draw| draw.as_ref()?[at]).collect();
            let found = match best.as_ref().and_then(|best| best[at]) {
                // Leaks scatter over decades to one side, and their mirror image is not an interval.
                Some(best) => percentiles_about(best, &ln_values, level),
                None => interval(&ln_values, level),
            };
            let is_known = ln_values.len() as f64 >= MIN_SHARE_WITH_VALUE * draws as f64;
            let factor = slot.load.map_or(1.0, |load| plain.light_contact_factor(load));
            let found = found.filter(|_| is_known).map(|found| QuantityInterval::new(*slot, value, &found));
            found.map(|found| found.with_stiffness_within(factor))
        };
        let open = |(at, slot): (usize, &Slot)| {
            let is_open = |draw: &&Vec<Option<f64>>| draw[at].is_some();
            let drawn = || drawn.iter().flatten();
            let is_channel = slot.quantity == Quantity::ChannelWavelength;
            let load = slot.load.filter(|_| is_channel)?;
            let share = drawn().filter(is_open).count() as f64 / drawn().count() as f64;
            Some(OpenChannel { load, share })
        };
        QuantityDraws {
            intervals: self.slots.iter().enumerate().filter_map(of_slot).collect(),
            open_channels: self.slots.iter().enumerate().filter_map(open).collect(),
        }
    }

    /// ln of every value in a draw; `None` if the draw is out of the range of spectra.
    fn draw(&self, inputs: &Inputs, of: DrawOf) -> Option<Vec<Option<f64>>> {
        let material = inputs.material(of);
        match inputs.psd(of)? {
            None => self.ln_values(&self.scene.plan(), self.results, material),
            Some(psd) => self.of_spectrum(&psd, material),
        }
    }

    /// ln of every value for the best estimates.
    fn best(&self, inputs: &Inputs) -> Option<Vec<Option<f64>>> {
        self.of_spectrum(&inputs.best_psd()??, None)
    }

    fn ln_values(
        &self,
        plan: &Plan<'_>,
        results: &Results,
        drawn: Option<DrawnMaterial>,
    ) -> Option<Vec<Option<f64>>> {
        let scene = self.scene;
        let material = scene.material.as_ref()?;
        let over_centre = drawn.map_or(1.0, |drawn| drawn.strength_over_centre);
        let interface_inputs = InterfaceInputs {
            results,
            normalisation: scene.needs.moments?,
            pair: drawn.map_or(material.pair, |drawn| drawn.pair),
            hardness_pa: material.hardness_pa().map(|hardness_pa| over_centre * hardness_pa),
            pressures: scene.needs.loads.iter().map(|load| load.nominal_pressure).collect(),
        };
        let states = InterfaceStates::new(scene.interface.as_ref()?, plan, interface_inputs)?;
        let ln_value = |slot: &Slot| match slot.curve {
            Some(_) => None,
            None => states.value(*slot).ok().flatten().map(f64::ln),
        };
        Some(self.slots.iter().map(ln_value).collect())
    }

    fn of_spectrum(&self, psd: &ProfilePsd, drawn: Option<DrawnMaterial>) -> Option<Vec<Option<f64>>> {
        let needs = Needs { moments: self.scene.needs.moments, ..Needs::default() };
        let plan = Plan { psd, sampling: self.scene.sampling, needs };
        self.ln_values(&plan, &plan.compute().ok()?, drawn)
    }
}

impl QuantityInterval {
    fn new(slot: Slot, value: f64, found: &Interval) -> Self {
        QuantityInterval {
            slot,
            value,
            median: found.median.value.exp(),
            low: found.low.value.exp(),
            high: found.high.value.exp(),
            monte_carlo_error: found.relative_error(),
        }
    }

    /// The interval with the error of a stiffness that may be `factor` times as large or as small. Both errors are independent:
    /// their logarithms add as squares.
    fn with_stiffness_within(self, factor: f64) -> Self {
        if !self.slot.quantity.follows_stiffness() {
            return self;
        }
        let widened = |end: f64| ((end / self.median).ln().hypot(factor.ln())).exp();
        let [low, high] = [self.median / widened(self.low), self.median * widened(self.high)];
        QuantityInterval { low, high, ..self }
    }

    fn in_proportion(slot: Slot, value: f64, area: &AreaInterval) -> Self {
        let factor = value / area.area_fraction;
        QuantityInterval {
            slot,
            value,
            median: factor * area.median,
            low: factor * area.low,
            high: factor * area.high,
            monte_carlo_error: area.monte_carlo_error,
        }
    }
}
