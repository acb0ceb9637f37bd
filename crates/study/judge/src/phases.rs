//! What the spectrum leaves out: a measured map under the elements, beside Gaussian surfaces of its own waves.

use gaussian_surfaces::{MapWaves, Surface};
use half_space::{Grid, Loading, PeriodicElements};
use measurements::MapPatch;
use parallel::Progress;
use serde::Serialize;
use topography::{Detrend, detrended_m};

use crate::JudgeError;
use crate::solve::{Solved, TOLERANCE};
use crate::verdicts::Judged;
use crate::window::POINTS_PER_SHORTEST;

/// More maps than this are not pressed.
const MOST_MAPS: usize = 3;
/// Gaussian surfaces beside each map.
const TWINS: u64 = 4;
/// With fewer points in contact a map of that size says little; with E* h' for its pressure all of it touches.
const LEAST_POINTS: f64 = 200.0;
/// See [`LEAST_POINTS`].
const NEARLY_FULL: f64 = 1.0;

/// A map under a load, and Gaussian surfaces of the same waves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OfMap {
    /// The name of the measurement.
    pub map: String,
    /// The load, by index: the first of those that press the map alike.
    pub load: usize,
    /// The mean pressure on the map \[Pa\], which longer waves leave, over E* times its own rms gradient.
    pub pressure_over_gradient: f64,
    /// The area fraction of the map.
    pub area_fraction: f64,
    /// That of Gaussian surfaces whose waves are as high and whose phases are random.
    pub twins: Judged,
}

impl OfMap {
    /// The map's area over that of its twins.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.area_fraction / self.twins.area_fraction
    }
}

/// What maps are pressed by.
pub(crate) struct Pressed<'p> {
    pub composite_modulus_pa: f64,
    pub seed: u64,
    /// Points along a side at most.
    pub grid: usize,
    /// The mean pressure \[Pa\] that waves longer than a length \[m\] leave under each load, by its index.
    pub pressures_pa: &'p (dyn Fn(f64) -> Vec<(usize, f64)> + Sync),
}

/// Presses maps and their twins, elastically. What is cancelled is left out.
pub(crate) fn of_maps(
    maps: &[MapPatch],
    pressed: &Pressed<'_>,
    progress: &dyn Progress,
) -> Result<Vec<OfMap>, JudgeError> {
    let told = &maps[..maps.len().min(MOST_MAPS)];
    let found = parallel::try_map(told, |patch| of_map(patch, pressed, progress))?;
    Ok(found.into_iter().flatten().collect())
}

fn of_map(
    patch: &MapPatch,
    pressed: &Pressed<'_>,
    progress: &dyn Progress,
) -> Result<Vec<OfMap>, JudgeError> {
    let map = patch.map.middle(pressed.grid);
    let is_whole = map == patch.map;
    let lengths_m = [map.columns() as f64 * map.spacing_x_m(), map.rows() as f64 * map.spacing_y_m()];
    let heights_m = detrended_m(&map, Detrend::Plane);
    let waves = MapWaves::new(
        &heights_m,
        map.columns(),
        lengths_m,
        patch.is_periodic && is_whole,
        POINTS_PER_SHORTEST,
    );
    let surface = waves.surface();
    let gradient_pa = pressed.composite_modulus_pa * surface.mean_square_gradient().sqrt();
    let points = (map.columns() * map.rows()) as f64;
    let mut found: Vec<OfMap> = Vec::new();
    for (load, pressure_pa) in (pressed.pressures_pa)(lengths_m[0].min(lengths_m[1])) {
        let pressure_over_gradient = pressure_pa / gradient_pa;
        let known = |of: &OfMap| (of.pressure_over_gradient / pressure_over_gradient - 1.0).abs() < 0.01;
        let says_something = 2.0 * pressure_over_gradient * points > LEAST_POINTS
            && pressure_over_gradient < NEARLY_FULL
            && !found.iter().any(known);
        if !says_something {
            continue;
        }
        let area = |surface: &Surface| area_fraction(surface, pressure_pa, pressed, progress);
        let Some(area_fraction) = area(&surface)? else { return Ok(found) };
        let twins = (0..TWINS).map(|at| area(&waves.twin(pressed.seed, at)));
        let Some(twins) = twins.collect::<Result<Option<Vec<f64>>, JudgeError>>()? else { return Ok(found) };
        let Solved { area_fraction: of_twins, standard_error } = Solved::of(&twins);
        let twins = Judged { area_fraction: of_twins, standard_error };
        found.push(OfMap { map: patch.name.clone(), load, pressure_over_gradient, area_fraction, twins });
    }
    Ok(found)
}

fn area_fraction(
    surface: &Surface,
    nominal_pressure_pa: f64,
    pressed: &Pressed<'_>,
    progress: &dyn Progress,
) -> Result<Option<f64>, JudgeError> {
    if progress.is_cancelled() {
        return Ok(None);
    }
    let (rows, columns) = (surface.points_y(), surface.points_x());
    let grid = Grid::new(rows, columns, surface.length_x_m(), surface.length_y_m())?;
    let loading = Loading {
        contact_modulus_pa: pressed.composite_modulus_pa,
        nominal_pressure_pa,
        saturation_pa: None,
        tolerance: TOLERANCE,
    };
    let contact = PeriodicElements::new(grid, surface.heights_m())?.press(&loading, progress)?;
    Ok(Some(contact.area_fraction_corrected))
}
