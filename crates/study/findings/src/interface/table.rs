//! The quantities of an interface as a table that others script against.

use tables::Table;

use study::interface::Slot;
use study::plan::Needs;

/// The beginning of a row per slot: `quantity, nominal_pressure_pa, curve`; the quantity carries its unit, and what a slot does not
/// have is empty.
#[must_use]
pub fn of_slots(needs: &Needs, slots: &[Slot]) -> Table {
    let pressure = |slot: &Slot| Some(needs.loads[slot.load?].nominal_pressure_pa());
    let curve = |slot: &Slot| slot.curve.map_or_else(String::new, |curve| needs.curves[curve].name.clone());
    Table::default()
        .with_words("quantity", slots.iter().map(|slot| slot.quantity.key()))
        .with_numbers("nominal_pressure_pa", slots.iter().map(pressure))
        .with_text("curve", slots.iter().map(curve))
}
