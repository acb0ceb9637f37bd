//! Surfaces pressed by boundary elements, window by window.

use elements::half_space::{Grid, Loading};
use numerics::parallel::{NestedProgress, Progress};
use spectrum::random_surfaces::{Phases, Synthesis};
use units::RemarkCode;

use crate::JudgeError;
use crate::case::Case;
use crate::layout::{Layout, Press};
use crate::scatter::{AreasOnWindow, PooledScatter, mean_and_variance};
use crate::window::Window;
use study::student::widening;

/// Complementarity of a solution. Tightened a thousand times, areas move by a thousandth at most.
pub(crate) const TOLERANCE: f64 = 1e-4;
/// The relative error of a corrected area from the grid, at four points on the shortest wavelength.
const GRID_ERROR: f64 = 0.015;

/// The area of one press, averaged over all surfaces of its window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Solved {
    pub area_fraction: f64,
    pub standard_error: f64,
}

/// The solutions of all presses, and their cost in operator applications times grid points.
#[derive(Debug)]
pub(crate) struct Solutions {
    /// For every press its solution, or the reason why there is none.
    pub of_presses: Vec<Result<Solved, RemarkCode>>,
    pub spent: f64,
}

/// One surface of a window under all pressures on that window.
struct Task {
    window: usize,
    realisation: usize,
}

struct Outcome {
    window: usize,
    /// For every press of the window the area fraction, or the reason why there is none.
    areas: Vec<Result<f64, RemarkCode>>,
    operators: usize,
}

/// Presses every surface of every window. The digits do not depend on the number of threads.
pub(crate) fn solve(
    layout: &Layout,
    case: &Case<'_>,
    seed: u64,
    progress: &dyn Progress,
) -> Result<Solutions, JudgeError> {
    let tasks: Vec<Task> = (0..layout.windows.len())
        .flat_map(|window| {
            (0..layout.realisations_of(window)).map(move |realisation| Task { window, realisation })
        })
        .collect();
    let outcomes = numerics::parallel::try_map(&tasks, |task| {
        let presses = presses_of(layout, task.window);
        let window = &layout.windows[task.window];
        pressed(window, task, &presses, case, seed, progress)
    })?;
    let cost = |outcome: &Outcome| outcome.operators as f64 * layout.windows[outcome.window].grid_points();
    let spent = outcomes.iter().map(cost).sum();
    let areas_of = |(at, press): (usize, &Press)| {
        let place = layout.presses[..at].iter().filter(|other| other.window == press.window).count();
        let of_window = outcomes.iter().filter(|outcome| outcome.window == press.window);
        of_window.map(|outcome| outcome.areas[place]).collect()
    };
    let areas: Vec<Result<Vec<f64>, RemarkCode>> = layout.presses.iter().enumerate().map(areas_of).collect();
    let pooled = layout.pools_scatter().then(|| pooled_scatter(layout, &areas)).flatten();
    let solved = |(press, areas): (&Press, &Result<Vec<f64>, RemarkCode>)| {
        // The area of the whole band rests on the last window, which has enough surfaces for a scatter of its own.
        let pooled = pooled.filter(|_| !layout.is_last(press.window));
        areas.as_ref().map(|areas| Solved::from_surfaces(areas, pooled)).map_err(|reason| *reason)
    };
    Ok(Solutions { of_presses: layout.presses.iter().zip(&areas).map(solved).collect(), spent })
}

fn pooled_scatter(layout: &Layout, areas: &[Result<Vec<f64>, RemarkCode>]) -> Option<PooledScatter> {
    let on_windows = layout.presses.iter().zip(areas).filter_map(|(press, areas)| {
        let areas = areas.as_ref().ok()?;
        Some(AreasOnWindow { window: press.window, areas })
    });
    PooledScatter::new(on_windows)
}

fn presses_of(layout: &Layout, window: usize) -> Vec<Press> {
    layout.presses.iter().filter(|press| press.window == window).copied().collect()
}

fn pressed(
    window: &Window,
    task: &Task,
    presses: &[Press],
    case: &Case<'_>,
    seed: u64,
    progress: &dyn Progress,
) -> Result<Outcome, JudgeError> {
    let mut outcome =
        Outcome { window: task.window, areas: vec![Err(RemarkCode::NotSolved); presses.len()], operators: 0 };
    if presses.is_empty() || progress.is_cancelled() {
        return Ok(outcome);
    }
    let box_m = window.box_m;
    // Every window has surfaces of its own.
    let seed = seed.wrapping_add((task.window as u64) << 32);
    let synthesis = Synthesis::square(window.points, box_m, seed, Phases::FixedModulus);
    // No wave of the box may lie in a band that noise has thinned.
    let Ok(surface) = window.waves.realised(&synthesis, task.realisation as u64) else {
        outcome.areas.fill(Err(RemarkCode::NoSurface));
        return Ok(outcome);
    };
    let grid = Grid::new(window.points, window.points, box_m, box_m)?;
    let mut elements = case.elements(grid, &surface.heights_m)?;
    let mut found: Vec<SurfaceSolution> = Vec::new();
    for at in from_high_bounds(presses) {
        if progress.is_cancelled() {
            break;
        }
        let press = &presses[at];
        let solution = match found.iter().find(|earlier| earlier.answers(press)) {
            Some(earlier) => *earlier,
            None => {
                let contact = elements.press(
                    &Loading {
                        contact_modulus_pa: case.composite_modulus_pa,
                        nominal_pressure_pa: press.pressure_pa,
                        saturation_pa: press.saturation_pa,
                        tolerance: TOLERANCE,
                    },
                    &NestedProgress(progress),
                )?;
                outcome.operators += contact.numbers.operators;
                let of_press = SurfaceSolution {
                    pressure_pa: press.pressure_pa,
                    largest_pressure_pa: contact.numbers.largest_pressure_pa,
                    area_fraction: contact.numbers.area_fraction_corrected,
                };
                found.push(of_press);
                of_press
            }
        };
        // Where everything in contact flows, the load alone decides, whatever the perimeter.
        let least = press.saturation_pa.map_or(0.0, |bound_pa| press.pressure_pa / bound_pa);
        outcome.areas[at] = Ok(solution.area_fraction.max(least));
        progress.advance(1);
    }
    Ok(outcome)
}

/// The presses by index, from no bound on the pressure to the lowest one.
fn from_high_bounds(presses: &[Press]) -> Vec<usize> {
    let bound_pa = |at: &usize| presses[*at].saturation_pa.unwrap_or(f64::INFINITY);
    let mut order: Vec<usize> = (0..presses.len()).collect();
    order.sort_by(|a, b| bound_pa(b).total_cmp(&bound_pa(a)));
    order
}

/// A solution on one surface.
#[derive(Debug, Clone, Copy)]
struct SurfaceSolution {
    pressure_pa: f64,
    largest_pressure_pa: f64,
    area_fraction: f64,
}

impl SurfaceSolution {
    /// True if the solution is also that of a press with a lower bound: its pressures stay below that bound everywhere.
    fn answers(&self, press: &Press) -> bool {
        press.saturation_pa.is_some_and(|bound_pa| self.largest_pressure_pa < bound_pa)
            && press.has_pressure(self.pressure_pa)
    }
}

impl Solved {
    /// Averages the areas of several surfaces, whose scatter is their own if none is pooled.
    pub fn from_surfaces(areas: &[f64], pooled: Option<PooledScatter>) -> Self {
        let (area_fraction, variance) = mean_and_variance(areas);
        let of_surfaces = match pooled {
            Some(pooled) => pooled.error_of_mean(areas),
            None => widening(areas.len()) * (variance / areas.len() as f64).sqrt(),
        };
        let standard_error = of_surfaces.hypot(GRID_ERROR * area_fraction);
        Solved { area_fraction, standard_error }
    }

    /// An area that is evenly distributed between a share of the surface and all of it.
    pub fn between(share: f64) -> Self {
        // The standard deviation of an even distribution.
        let standard_error = (1.0 - share) / 12f64.sqrt();
        Solved { area_fraction: 0.5 * (1.0 + share), standard_error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_of_few_surfaces_is_widened_and_holds_that_of_the_grid() {
        let solved = Solved::from_surfaces(&[0.1, 0.1, 0.1, 0.1], None);
        assert!((solved.area_fraction - 0.1).abs() < 1e-15);
        assert!((solved.standard_error / 0.1 - GRID_ERROR).abs() < 1e-12);
        let scattered = Solved::from_surfaces(&[0.09, 0.11], None);
        assert!((scattered.standard_error - (widening(2) * 0.01).hypot(0.1 * GRID_ERROR)).abs() < 1e-12);
    }
    #[test]
    fn a_solution_answers_presses_whose_bound_it_does_not_reach() {
        let found = SurfaceSolution { pressure_pa: 1.0, largest_pressure_pa: 9.0, area_fraction: 0.2 };
        let press = |pressure_pa, saturation_pa| Press { window: 0, pressure_pa, saturation_pa };
        assert!(found.answers(&press(1.005, Some(9.5))));
        assert!(!found.answers(&press(1.02, Some(9.5))) && !found.answers(&press(1.0, Some(9.0))));
        let presses = [press(1.0, Some(3.0)), press(1.0, None), press(2.0, Some(5.0))];
        assert_eq!(from_high_bounds(&presses), [1, 2, 0]);
    }

    #[test]
    fn an_area_that_may_be_anything_between_a_share_and_all_has_their_middle() {
        let between = Solved::between(0.7);
        assert!((between.area_fraction - 0.85).abs() < 1e-15);
        // The variance of an even distribution is the square of its width over 12.
        assert!((between.standard_error.powi(2) * 12.0 - 0.09).abs() < 1e-12);
    }
}
