//! Draws of the quantities of an interface.

use scene::Scene;
use study::interface::{InterfaceInputs, InterfaceStates, Quantity, Slot};
use study::plan::{Needs, Plan, Results};

use spectrum::ProfilePsd;

use crate::material_draws::DrawnMaterial;
use crate::quantiles::{Interval, interval, percentiles_about};
use crate::results::{AreaInterval, OpenChannel, QuantityInterval};

/// The requested quantities of an interface, for many spectra and bodies.
#[derive(Debug)]
pub(crate) struct Quantities<'p> {
    scene: &'p Scene,
    /// Those of the scene itself.
    plain: InterfaceStates<'p>,
    slots: Vec<Slot>,
}

/// ln of every requested quantity in a draw; `None` without a value.
pub(crate) type DrawnQuantities = Vec<Option<f64>>;

/// ln of the leak of a draw that is tight: as good as none.
const SHUT: f64 = -700.0;
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
        let plain = scene.interface_states(results)?;
        Some(Quantities { scene, slots: plain.slots(), plain })
    }

    /// Finds the intervals at a level of all quantities with a value, from those of all draws and the best spectrum, if it is
    /// uncertain. A quantity from the area of a curve takes the interval of that area.
    pub fn intervals(
        &self,
        drawn: &[Option<DrawnQuantities>],
        best: Option<&ProfilePsd>,
        level: f64,
        areas: &[AreaInterval],
    ) -> QuantityDraws {
        if drawn.iter().all(Option::is_none) {
            return QuantityDraws::default();
        }
        let best = best.and_then(|psd| self.of_spectrum(psd));
        let plain = &self.plain;
        let of_slot = |(at, slot): (usize, &Slot)| {
            let value = plain.value(*slot).ok().flatten()?;
            if let Some(curve) = slot.curve {
                let is_its = |area: &&AreaInterval| area.curve == curve && Some(area.load) == slot.load;
                return areas
                    .iter()
                    .find(is_its)
                    .map(|area| QuantityInterval::in_proportion(*slot, value, area));
            }
            let known = || drawn.iter().filter_map(|draw| draw.as_ref()?[at]);
            let missing = match slot.quantity {
                // A seal that is shut leaks nothing, and where all has flowed no gap is left.
                Quantity::MeanGap => Some(SHUT),
                quantity if quantity.is_of_leak() => Some(SHUT),
                // Contact that has flowed altogether is as stiff as any other draw at least.
                quantity if quantity.follows_stiffness() => known().reduce(f64::max),
                _ => None,
            };
            let ln_values: Vec<f64> =
                drawn.iter().filter_map(|draw| draw.as_ref()?[at].or(missing)).collect();
            let found = match best.as_ref().and_then(|best| best[at]) {
                // Leaks scatter over decades to one side, and their mirror image is not an interval.
                Some(best) => percentiles_about(best, &ln_values, level),
                None => interval(&ln_values, level),
            };
            let is_known = ln_values.len() as f64 >= MIN_SHARE_WITH_VALUE * drawn.len() as f64;
            let factor = slot.load.map_or(1.0, |load| plain.light_contact_factor(load));
            let found = found.filter(|_| is_known).map(|found| QuantityInterval::new(*slot, value, &found));
            found.map(|found| found.with_stiffness_within(factor))
        };
        let open = |(at, slot): (usize, &Slot)| {
            let is_open = |draw: &&DrawnQuantities| draw[at].is_some();
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

    /// ln of every value for the spectrum of the scene and drawn bodies. Bodies of the scene's own elasticity share what does not
    /// depend on the hardness.
    pub fn with_bodies(&self, drawn: Option<DrawnMaterial>) -> Option<DrawnQuantities> {
        let inputs = &self.plain.inputs;
        match drawn {
            Some(drawn) if drawn.pair != inputs.pair => self.of(inputs.results, Some(drawn)),
            _ => Some(self.ln_values(&self.plain.with_hardness(self.hardness_pa(drawn)))),
        }
    }

    /// ln of every value for the results of a spectrum, and drawn bodies.
    pub fn of(&self, results: &Results, drawn: Option<DrawnMaterial>) -> Option<DrawnQuantities> {
        let inputs = InterfaceInputs {
            results,
            pair: drawn.map_or(self.plain.inputs.pair, |drawn| drawn.pair),
            hardness_pa: self.hardness_pa(drawn),
            ..self.plain.inputs.clone()
        };
        self.plain.drawn(inputs).map(|states| self.ln_values(&states))
    }

    fn of_spectrum(&self, psd: &ProfilePsd) -> Option<DrawnQuantities> {
        let needs = Needs { moments: self.scene.needs.moments, ..Needs::default() };
        let plan = Plan { psd, sampling: self.scene.sampling, needs };
        self.of(&plan.compute().ok()?, None)
    }

    fn hardness_pa(&self, drawn: Option<DrawnMaterial>) -> Option<f64> {
        let over_centre = drawn.map_or(1.0, |drawn| drawn.strength_over_centre);
        self.plain.inputs.hardness_pa.map(|hardness_pa| over_centre * hardness_pa)
    }

    fn ln_values(&self, states: &InterfaceStates<'_>) -> DrawnQuantities {
        let ln_value = |slot: &Slot| match slot.curve {
            Some(_) => None,
            None => states.value(*slot).ok().flatten().map(f64::ln),
        };
        self.slots.iter().map(ln_value).collect()
    }
}

impl QuantityInterval {
    fn new(slot: Slot, value: f64, found: &Interval) -> Self {
        // Between a tight draw and one that leaks lies nothing.
        let value_of = |ln: f64| if ln < 0.5 * SHUT { 0.0 } else { ln.exp() };
        QuantityInterval {
            slot,
            value,
            median: value_of(found.median.value),
            low: value_of(found.low.value),
            high: value_of(found.high.value),
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
