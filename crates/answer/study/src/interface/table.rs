//! The quantities of an interface as a table for scripts.

use tables::Table;

use super::quantity::Slot;
use crate::plan::Needs;

/// The first columns of a table with a row per slot: `quantity, nominal_pressure_pa, curve`. The quantity includes its unit;
/// missing loads and curves are empty.
#[must_use]
pub fn slots_table(needs: &Needs, slots: &[Slot]) -> Table {
    let pressure = |slot: &Slot| Some(needs.loads[slot.load?].nominal_pressure_pa());
    let curve = |slot: &Slot| slot.curve.map_or_else(String::new, |curve| needs.curves[curve].name.clone());
    Table::default()
        .with_words("quantity", slots.iter().map(|slot| slot.quantity.key()))
        .with_numbers("nominal_pressure_pa", slots.iter().map(pressure))
        .with_text("curve", slots.iter().map(curve))
}
