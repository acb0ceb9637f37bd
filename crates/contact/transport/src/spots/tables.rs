//! Spots and resistances as tables.

use elements::PressedLoad;
use tables::Table;
use units::OutOfBounds;

use super::{ContactResistance, ContactSpot, FieldSpots, Spots};

/// Table with a row per spot, the one of the most points first, in blocks of loads and of surfaces: `nominal_pressure_pa, realisation,
/// spot, x_m, y_m, radius_m, area_m2, current_share`, with realisations and spots counted from 1. Surfaces whose spots are out of range
/// have no rows.
#[must_use]
pub fn spots_table(fields: &[FieldSpots]) -> Table {
    let mut fields: Vec<&FieldSpots> = fields.iter().collect();
    fields.sort_by_key(|field| (field.load, field.surface));
    let rows: Vec<(&FieldSpots, usize, &ContactSpot)> = fields
        .iter()
        .flat_map(|field| {
            let spots = field.solved.iter().flat_map(|solved| &solved.spots);
            spots.zip(1..).map(move |(spot, at)| (*field, at, spot))
        })
        .collect();
    let column = |of: fn(&(&FieldSpots, usize, &ContactSpot)) -> f64| rows.iter().map(of).collect::<Vec<_>>();
    Table::default()
        .with_numbers("nominal_pressure_pa", column(|(field, ..)| field.nominal_pressure_pa))
        .with_numbers("realisation", column(|(field, ..)| (field.surface + 1) as f64))
        .with_numbers("spot", column(|(_, at, _)| *at as f64))
        .with_numbers("x_m", column(|(.., spot)| spot.x_m))
        .with_numbers("y_m", column(|(.., spot)| spot.y_m))
        .with_numbers("radius_m", column(|(.., spot)| spot.radius_m()))
        .with_numbers("area_m2", column(|(.., spot)| spot.area_m2))
        .with_numbers("current_share", column(|(.., spot)| spot.current_share))
}

/// Adds to a table with a row per load, or with a row per surface and load if `per_realisation`, in blocks of loads: `spots,
/// largest_share, resistance_ohm, resistance_from_stiffness_ohm, resistance_from`. A mean over surfaces is one of their numbers of spots,
/// their largest shares, and their conductances.
///
/// # Errors
/// [`OutOfBounds`] for a stiffness or an area out of bounds.
pub fn with_resistances(
    table: Table,
    loads: &[PressedLoad],
    per_realisation: bool,
    fields: &[FieldSpots],
) -> Result<Table, OutOfBounds> {
    let mut rows = Vec::new();
    for (load, pressed) in loads.iter().enumerate() {
        let mut of_load = Vec::new();
        for (surface, state) in pressed.states.iter().enumerate() {
            let field = fields.iter().find(|field| (field.load, field.surface) == (load, surface));
            let resistance = |field: &FieldSpots| Row::new(field, state.stiffness_pa_per_m);
            of_load.extend(field.map(resistance).transpose()?);
        }
        if per_realisation {
            rows.extend(of_load);
        } else {
            rows.push(Row::mean(&of_load));
        }
    }
    let column = |of: fn(&Row) -> Option<f64>| rows.iter().map(of).collect::<Vec<_>>();
    Ok(table
        .with_numbers("spots", column(|row| row.spots))
        .with_numbers("largest_share", column(|row| row.largest_share))
        .with_numbers("resistance_ohm", column(|row| row.conductance_s.map(f64::recip)))
        .with_numbers("resistance_from_stiffness_ohm", column(|row| row.from_stiffness_s.map(f64::recip)))
        .with_words("resistance_from", rows.iter().map(|row| row.source)))
}

/// Resistance of a surface under a load, or of several.
#[derive(Debug, Clone, Copy)]
struct Row {
    spots: Option<f64>,
    largest_share: Option<f64>,
    conductance_s: Option<f64>,
    from_stiffness_s: Option<f64>,
    source: &'static str,
}

impl Row {
    fn new(field: &FieldSpots, stiffness_pa_per_m: Option<f64>) -> Result<Self, OutOfBounds> {
        let resistance = field.resistance(stiffness_pa_per_m)?;
        let from_stiffness =
            stiffness_pa_per_m.map(|stiffness| field.resistance_from_stiffness_ohm(stiffness)).transpose()?;
        let solved = field.solved.as_ref().ok();
        Ok(Row {
            spots: solved.map(|solved| solved.spots.len() as f64),
            largest_share: solved.map(Spots::largest_share),
            conductance_s: resistance.map(|resistance| resistance.ohm().recip()),
            from_stiffness_s: from_stiffness.map(f64::recip),
            source: match resistance {
                Some(ContactResistance::Spots(_)) => "spots",
                Some(ContactResistance::Stiffness(_)) => "stiffness",
                None => "",
            },
        })
    }

    fn mean(rows: &[Row]) -> Self {
        let mean = |of: fn(&Row) -> Option<f64>| {
            let values: Option<Vec<f64>> = rows.iter().map(of).collect();
            values.map(|values| values.iter().sum::<f64>() / values.len() as f64)
        };
        let first = rows.first().map_or("", |row| row.source);
        Row {
            spots: mean(|row| row.spots),
            largest_share: mean(|row| row.largest_share),
            conductance_s: mean(|row| row.conductance_s),
            from_stiffness_s: mean(|row| row.from_stiffness_s),
            source: if rows.iter().all(|row| row.source == first) { first } else { "both" },
        }
    }
}
