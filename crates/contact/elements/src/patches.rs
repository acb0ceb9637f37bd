//! Contact patches of pressed surfaces.

use crate::half_space::{HalfSpaceError, Patch};
use tables::Table;

use crate::boundary::Boundary;
use crate::field::{ContactField, PointState};

/// Patches of one surface under one load.
#[derive(Clone, Debug, PartialEq)]
pub struct PressedPatches {
    /// Index of the load.
    pub load: usize,
    /// Number of the surface.
    pub surface: usize,
    /// Nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Patches, the largest first.
    pub patches: Vec<Patch>,
}

impl ContactField<'_> {
    /// Finds the connected regions of the points in contact, as the areas count them.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a map of another size than its grid.
    pub fn patches(&self) -> Result<PressedPatches, HalfSpaceError> {
        let is_contact: Vec<bool> = self.states().map(|state| state != PointState::Open).collect();
        Ok(PressedPatches {
            load: self.load,
            surface: self.surface,
            nominal_pressure_pa: self.nominal_pressure_pa,
            patches: crate::half_space::patches(
                &self.relief.grid()?,
                self.relief.boundary == Boundary::Periodic,
                &is_contact,
            )?,
        })
    }
}

/// Table with a row per patch, the largest first, in blocks of loads and of surfaces: `nominal_pressure_pa, realisation,
/// patch, points, area_m2, perimeter_m`, with realisations and patches counted from 1.
#[must_use]
pub fn patches_table(mut pressed: Vec<PressedPatches>) -> Table {
    pressed.sort_by_key(|of_surface| (of_surface.load, of_surface.surface));
    let rows: Vec<(&PressedPatches, usize, &Patch)> = pressed
        .iter()
        .flat_map(|of_surface| {
            of_surface.patches.iter().zip(1..).map(move |(patch, at)| (of_surface, at, patch))
        })
        .collect();
    let column = |of: fn(&(&PressedPatches, usize, &Patch)) -> f64| rows.iter().map(of).collect::<Vec<_>>();
    Table::default()
        .with_numbers("nominal_pressure_pa", column(|(pressed, ..)| pressed.nominal_pressure_pa))
        .with_numbers("realisation", column(|(pressed, ..)| (pressed.surface + 1) as f64))
        .with_numbers("patch", column(|(_, at, _)| *at as f64))
        .with_numbers("points", column(|(.., patch)| patch.points as f64))
        .with_numbers("area_m2", column(|(.., patch)| patch.area_m2))
        .with_numbers("perimeter_m", column(|(.., patch)| patch.perimeter_m))
}
