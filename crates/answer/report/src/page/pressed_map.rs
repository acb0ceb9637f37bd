//! A measured map under a load: numbers in words, and the state of each point, for a page that stays open.

use elements::{ContactField, ElementsError, PointState, PressedLoad};
use numerics::parallel::Progress;
use questions::MapQuestion;
use serde::Serialize;
use std::sync::{Mutex, PoisonError};
use units::SceneKeys;
use units::display::{length, pressure, share, three_digits};

/// A measured map under a load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PressedMap {
    /// The nominal pressure in print.
    pub load: String,
    /// The area fraction: extrapolated to a finer grid where the grid resolves the spots, else corrected.
    pub area_fraction: f64,
    /// The area fraction in print.
    pub area: String,
    /// Further quantities and their values in print.
    pub quantities: Vec<(&'static str, String)>,
    /// Cautions, a sentence each.
    pub notes: Vec<String>,
    /// The state of each point, row by row: 0 apart, 1 touching, 2 yielding.
    pub states: Vec<u8>,
}

impl PressedMap {
    /// Presses a map under a nominal pressure \[Pa\]; `begin` receives the number of steps and returns their progress.
    ///
    /// # Errors
    /// [`ElementsError`] for a pressure that the surface cannot carry, and if `progress` cancels.
    pub fn new<P: Progress>(
        question: &MapQuestion,
        nominal_pressure_pa: f64,
        begin: impl FnOnce(usize) -> P,
    ) -> Result<Self, ElementsError> {
        let prepared = question.under(nominal_pressure_pa)?;
        let progress = begin(prepared.steps());
        let states = Mutex::new(Vec::new());
        let see = |field: &ContactField<'_>| {
            let found = field.states().map(|state| match state {
                PointState::Open => 0,
                PointState::Touching => 1,
                PointState::Yielding => 2,
            });
            *states.lock().unwrap_or_else(PoisonError::into_inner) = found.collect();
            Ok::<(), ElementsError>(())
        };
        let (pressed, found) = prepared.answer(see, &progress)?;
        let notes = prepared.notes.iter().chain(&found).map(|note| note.words(&SceneKeys)).collect();
        let area_fraction = pressed.first().map_or(0.0, best_area);
        Ok(PressedMap {
            load: pressure(nominal_pressure_pa),
            area_fraction,
            area: share(area_fraction),
            quantities: pressed.first().map_or_else(Vec::new, quantities),
            notes,
            states: states.into_inner().unwrap_or_else(PoisonError::into_inner),
        })
    }

    /// Says which points of a map are pressed, between which edges.
    #[must_use]
    pub fn describe(question: &MapQuestion) -> String {
        let relief = &question.relief;
        let [columns, rows] = question.points_of_whole;
        let part = match question.is_whole() {
            true => format!("all {columns} × {rows} points"),
            false => format!("the middle {} × {} of {columns} × {rows} points", relief.columns, relief.rows),
        };
        let edges = match relief.boundary {
            elements::Boundary::Periodic => "repeated without end",
            elements::Boundary::Free => "with free edges",
        };
        format!("{part}, {} × {}, {edges}", length(relief.length_x_m), length(relief.length_y_m))
    }
}

fn best_area(load: &PressedLoad) -> f64 {
    let mean = load.mean();
    mean.area_fraction_extrapolated.unwrap_or(mean.area_fraction_corrected)
}

fn quantities(load: &PressedLoad) -> Vec<(&'static str, String)> {
    let mean = load.mean();
    let yields = mean.plastic_area_fraction_corrected;
    let all = [
        (yields > 0.0).then(|| ("yielding area", share(yields))),
        Some(("mean gap", length(mean.mean_gap_m))),
        Some(("largest pressure", pressure(mean.largest_pressure_pa))),
        mean.stiffness_pa_per_m
            .map(|stiffness| ("stiffness", format!("{} Pa/m", units::display::typeset_digits(stiffness)))),
        Some(("points in contact", three_digits(mean.area_fraction * 100.0) + " %")),
    ];
    all.into_iter().flatten().collect()
}
