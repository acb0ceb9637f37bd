//! The quantities of an interface as a table that others script against.

use findings::interface::{InterfaceStates, of_slots};
use scene::Scene;
use study::interface::Slot;
use tables::Table;
use uncertainty::{QuantityInterval, Uncertainty};

/// A row per quantity, load and curve that has a value: `quantity, nominal_pressure_pa, curve, value, median, low, high, level`. The
/// quantity carries its unit; what is the same under all loads has no pressure, what no draws were made for no interval.
pub(crate) fn of(states: &InterfaceStates<'_>, scene: &Scene, uncertainty: Option<&Uncertainty>) -> Table {
    let found: Vec<(Slot, f64)> = states
        .slots()
        .into_iter()
        .filter_map(|slot| Some((slot, states.value(slot).ok().flatten()?)))
        .collect();
    let slots: Vec<Slot> = found.iter().map(|(slot, _)| *slot).collect();
    let interval = |of: fn(&QuantityInterval) -> f64| {
        slots.iter().map(move |slot| uncertainty.and_then(|found| found.quantity(*slot)).map(of))
    };
    let level = |slot: &Slot| uncertainty.filter(|found| found.quantity(*slot).is_some());
    of_slots(&scene.needs, &slots)
        .with_numbers("value", found.iter().map(|(_, value)| *value))
        .with_numbers("median", interval(|interval| interval.median))
        .with_numbers("low", interval(|interval| interval.low))
        .with_numbers("high", interval(|interval| interval.high))
        .with_numbers("level", slots.iter().map(|slot| level(slot).map(|found| found.settings.level)))
}
