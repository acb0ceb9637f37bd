//! The layout of a judgement, fixed before anything is solved: grid, windows, surfaces, and the pressures on each window.

use scene::JudgeSettings;
use serde::Serialize;

use crate::body::Reference;
use crate::case::{Case, WindowForms};
use crate::waves::Waves;
use crate::window::{Window, bands, decades_held, points_per_shortest};

/// The number of surfaces in each window, if the budget allows and no other is given.
const DEFAULT_REALISATIONS: usize = 4;

/// Grids that are tried, from fine to coarse: their sides have small factors, which fast Fourier transforms like.
pub(crate) const GRIDS: [usize; 10] = [1024, 768, 512, 384, 256, 192, 128, 96, 64, 48];

/// Pressures that differ by less than this share a solution.
pub(crate) const SAME_PRESSURE: f64 = 0.01;
/// Above this share of the hardness the whole contact yields: the area fraction lies between p/H and 1.
pub(crate) const FLOWING: f64 = 0.98;
/// With fewer points in contact the grid says little about the area.
pub(crate) const MIN_POINTS: f64 = 200.0;
/// Points that touch under the load from which an area is carried down: with fewer, surfaces scatter more than the closed form errs.
const POINTS_TO_CARRY: f64 = 2000.0;
/// The fewest surfaces that have a scatter.
const MIN_REALISATIONS: usize = 2;
/// From so many windows on that may scatter, pairs of surfaces know their scatter as well together as four surfaces do alone.
const WINDOWS_THAT_POOL: usize = 8;
/// The slope of area against p/(E* h') at light load, to estimate how many points will touch.
const SLOPE_OF_AREA: f64 = 2.0;
/// Area fraction from which on a window is nearly flat, so that its elements say little about the area of the surface.
const NEARLY_FLAT: f64 = 0.9;
/// The share of the budget that is left for a longer last window, if the last one is nearly flat.
const SHARE_FOR_LAST: f64 = 0.5;

/// A pressure on a window that elements solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Press {
    /// The window, by index.
    pub window: usize,
    /// The mean pressure \[Pa\].
    pub pressure_pa: f64,
    /// The bound \[Pa\] on the pressure of every point.
    pub saturation_pa: Option<f64>,
}

impl Press {
    /// True if a pressure \[Pa\] is so near to that of the press that they share a solution.
    pub fn has_pressure(&self, pressure_pa: f64) -> bool {
        (self.pressure_pa / pressure_pa - 1.0).abs() < SAME_PRESSURE
    }
}

/// A window under one load of the scene, for one of the bodies that are pressed; all by index.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    pub body: usize,
    pub window: usize,
    pub load: usize,
}

/// The plan for a cell of the layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PlannedPress {
    /// Elements solve it: the index of the press.
    Solve(usize),
    /// Few points of the last window would touch. Elements solve a pressure under which enough do, by the index of the press, and the
    /// closed form carries the area down to the load.
    CarryDown(usize),
    /// The whole contact yields: the area is between p/H and 1.
    Flows {
        /// Mean pressure over hardness.
        share: f64,
    },
    /// Too few points of another window would touch.
    TooLight,
    /// The budget leaves this load out.
    LoadNotChosen,
    /// The hardness grows, so that the area has a range alone.
    HasRange,
}

/// Everything that will be pressed.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Points along each side of all windows but the last, which may have more.
    pub grid: usize,
    /// Surfaces in each window but the last.
    realisations: usize,
    /// Surfaces in the last window.
    realisations_of_last: usize,
    pub windows: Vec<Window>,
    /// The closed forms about every window.
    pub forms: Vec<WindowForms>,
    /// The number of further windows, which have no roughness.
    pub left_out: usize,
    pub presses: Vec<Press>,
    /// The loads that are judged, by index.
    pub loads: Vec<usize>,
    /// Estimated cost, at most: operator applications times grid points.
    pub cost: f64,
    /// The plan for every cell, by [`Layout::index`].
    planned: Vec<PlannedPress>,
    loads_of_scene: usize,
}

impl Layout {
    /// The finest layout that the budget allows; `None` if even the coarsest is beyond it.
    pub fn within(settings: &JudgeSettings, case: &Case<'_>, waves: &Waves) -> Option<Self> {
        let grids: Vec<usize> = settings.grid.map_or_else(|| GRIDS.to_vec(), |grid| vec![grid]);
        let realisations = settings.realisations.unwrap_or(DEFAULT_REALISATIONS);
        // Fineness is given up first, then loads, then surfaces.
        for loads in loads_given_up(&case.loads_by_pressure) {
            for &grid in &grids {
                let layout = Layout::new(grid, realisations, &loads, case, waves);
                let prolongs = settings.grid.is_none() && layout.ends_nearly_flat(case);
                let share = if prolongs { 1.0 - SHARE_FOR_LAST } else { 1.0 };
                if layout.cost <= share * settings.budget {
                    let longer = prolongs.then(|| layout.with_longer_end(settings.budget, case, waves));
                    let chosen = longer.flatten().unwrap_or(layout);
                    return Some(match settings.realisations {
                        Some(_) => chosen,
                        None => chosen.in_pairs(case),
                    });
                }
            }
        }
        let (Some(&grid), None) = (grids.last(), settings.realisations) else { return None };
        let fewest = loads_given_up(&case.loads_by_pressure).pop().unwrap_or_default();
        let layout = Layout::new(grid, MIN_REALISATIONS, &fewest, case, waves);
        (layout.cost <= settings.budget).then_some(layout)
    }

    fn new(grid: usize, realisations: usize, loads: &[usize], case: &Case<'_>, waves: &Waves) -> Self {
        let points_per_shortest = points_per_shortest(waves, case.band(), grid);
        let bands = bands(case.band(), decades_held(grid, points_per_shortest));
        // Noise may leave a band of the surface without waves.
        let windows: Vec<Window> = bands
            .iter()
            .filter_map(|band| Window::new(waves, *band, grid, points_per_shortest).ok())
            .collect();
        let mut layout = Layout {
            left_out: bands.len() - windows.len(),
            grid,
            realisations,
            realisations_of_last: realisations,
            forms: Vec::new(),
            windows,
            presses: Vec::new(),
            loads: loads.to_vec(),
            cost: 0.0,
            planned: Vec::new(),
            loads_of_scene: case.loads(),
        };
        layout.plan_all(case);
        layout
    }

    /// Plans every cell for the windows.
    fn plan_all(&mut self, case: &Case<'_>) {
        self.forms = self.windows.iter().map(|window| case.forms(window)).collect();
        self.presses.clear();
        self.planned.clear();
        for &reference in &case.references {
            for window in 0..self.windows.len() {
                for load in 0..case.loads() {
                    let planned = self.plan(reference, window, load, case);
                    self.planned.push(planned);
                }
            }
        }
        self.cost = self.estimated_cost();
    }

    /// True if elements would be pressed nearly flat on the last window under a load whose area longer waves decide: the closed
    /// form for these would then give the area of the surface alone. A window that touches because it flows is another matter.
    fn ends_nearly_flat(&self, case: &Case<'_>) -> bool {
        let Some(window) = self.windows.len().checked_sub(1) else { return false };
        let forms = &self.forms[window];
        let is_nearly_flat = |body: usize, load: usize| {
            let PlannedPress::Solve(press) = self.planned(Cell { body, window, load }) else { return false };
            let Press { pressure_pa, saturation_pa, .. } = self.presses[press];
            let flowing = saturation_pa.map_or(0.0, |bound_pa| pressure_pa / bound_pa);
            let (own, share) = case.area_and_share(forms, case.references[body], load);
            own > NEARLY_FLAT && share.max(flowing) < NEARLY_FLAT
        };
        (0..case.references.len()).any(|body| self.loads.iter().any(|&load| is_nearly_flat(body, load)))
    }

    /// The layout with its last window prolonged towards longer waves until it is not nearly flat any more, or as far as the
    /// budget allows; `None` if it does not allow any.
    fn with_longer_end(&self, budget: f64, case: &Case<'_>, waves: &Waves) -> Option<Self> {
        let last = self.windows.last()?;
        let mut found = None;
        for &points in GRIDS.iter().rev().filter(|points| **points > self.grid) {
            let mut windows = self.windows.clone();
            *windows.last_mut()? = last.prolonged(waves, case.band().longest_m, points).ok()?;
            let mut longer = Layout {
                windows,
                forms: Vec::new(),
                presses: Vec::new(),
                planned: Vec::new(),
                loads: self.loads.clone(),
                ..*self
            };
            longer.plan_all(case);
            if longer.cost > budget {
                break;
            }
            let is_decisive = !longer.ends_nearly_flat(case);
            found = Some(longer);
            if is_decisive {
                break;
            }
        }
        found
    }

    /// The layout with two surfaces in each window but the last, if enough windows scatter to pool it. Pooling spares half of the
    /// work, and leaves errors as they are; grid and windows stay those of all surfaces.
    fn in_pairs(mut self, case: &Case<'_>) -> Self {
        let scatters = |window: &usize| {
            let is_partial = |(body, load): (usize, usize)| {
                let reference = case.references[body];
                matches!(
                    self.planned(Cell { body, window: *window, load }),
                    PlannedPress::Solve(_) | PlannedPress::CarryDown(_)
                ) && case.area_and_share(&self.forms[*window], reference, load).0 < NEARLY_FLAT
            };
            let bodies = 0..case.references.len();
            bodies.flat_map(|body| self.loads.iter().map(move |&load| (body, load))).any(is_partial)
        };
        if (0..self.windows.len()).filter(scatters).count() >= WINDOWS_THAT_POOL {
            self.realisations = MIN_REALISATIONS;
        }
        self
    }

    /// The number of surfaces in a window.
    pub fn realisations_of(&self, window: usize) -> usize {
        if self.is_last(window) { self.realisations_of_last } else { self.realisations }
    }

    /// True for the last window, on whose area that of the whole band rests.
    pub fn is_last(&self, window: usize) -> bool {
        window + 1 == self.windows.len()
    }

    /// True if windows have too few surfaces for a scatter of their own, and pool it.
    pub fn pools_scatter(&self) -> bool {
        self.realisations < self.realisations_of_last
    }

    /// The number of solutions: one for each pressure and surface.
    pub fn solutions(&self) -> usize {
        self.presses.iter().map(|press| self.realisations_of(press.window)).sum()
    }

    /// The plan for a cell.
    pub fn planned(&self, cell: Cell) -> PlannedPress {
        self.planned[self.index(cell)]
    }

    fn index(&self, Cell { body, window, load }: Cell) -> usize {
        (body * self.windows.len() + window) * self.loads_of_scene + load
    }

    /// True if the one window is the whole band of the spectrum.
    pub fn is_whole_band(&self) -> bool {
        self.windows.len() == 1 && self.left_out == 0
    }

    fn plan(&mut self, reference: Reference, window: usize, load: usize, case: &Case<'_>) -> PlannedPress {
        if !self.loads.contains(&load) {
            return PlannedPress::LoadNotChosen;
        }
        if reference == Reference::Growing {
            return PlannedPress::HasRange;
        }
        let flattening_gradient = self.windows[window].flattening_gradient;
        let forms = &self.forms[window];
        let pressure_pa = case.pressure_pa(forms, reference, load);
        let saturation_pa = case.saturation_pa(reference, forms.band.middle_m());
        let share = saturation_pa.map(|bound_pa| pressure_pa / bound_pa);
        if let Some(share) = share.filter(|share| *share > FLOWING) {
            return PlannedPress::Flows { share: share.min(1.0) };
        }
        let flattens_pa = case.composite_modulus_pa * flattening_gradient;
        // A surface that flows touches over p/H at least.
        let area_per_pa = (SLOPE_OF_AREA / flattens_pa).max(saturation_pa.map_or(0.0, f64::recip));
        let grid_points = self.windows[window].grid_points();
        let pressure_of = |points: f64| points / (area_per_pa * grid_points);
        let enough_pa = pressure_of(POINTS_TO_CARRY.min(FLOWING * grid_points));
        if self.is_last(window) && pressure_pa < enough_pa {
            PlannedPress::CarryDown(self.press(Press { window, pressure_pa: enough_pa, saturation_pa }))
        } else if pressure_pa > pressure_of(MIN_POINTS) {
            PlannedPress::Solve(self.press(Press { window, pressure_pa, saturation_pa }))
        } else {
            PlannedPress::TooLight
        }
    }

    /// The place of a press, which is added unless there is one so near that they share a solution.
    fn press(&mut self, press: Press) -> usize {
        let is_same = |other: &Press| {
            other.window == press.window
                && other.saturation_pa == press.saturation_pa
                && other.has_pressure(press.pressure_pa)
        };
        self.presses.iter().position(is_same).unwrap_or_else(|| {
            self.presses.push(press);
            self.presses.len() - 1
        })
    }

    /// Operator applications times grid points of all presses.
    fn estimated_cost(&self) -> f64 {
        let of_press = |press: &Press| {
            let window = &self.windows[press.window];
            self.realisations_of(press.window) as f64 * window.grid_points() * operators(window.points)
        };
        self.presses.iter().map(of_press).sum()
    }

    /// The extent of the layout, with the cost that was spent on it.
    pub fn extent(&self, settings: &JudgeSettings, spent: f64) -> Extent {
        Extent {
            grid: self.grid,
            grid_of_last: self.windows.last().map_or(self.grid, |window| window.points),
            realisations: self.realisations,
            realisations_of_last: self.realisations_of_last,
            seed: settings.seed,
            windows: self.windows.len(),
            left_out: self.left_out,
            solved: self.presses.len(),
            loads: self.loads.len(),
            estimated: self.cost,
            spent,
            budget: settings.budget,
        }
    }
}

/// The operator applications of a solution on a grid: a line through the largest counts measured for windows of Hurst
/// exponents 0.5 and 0.8, elastic and saturated, from light loads to full contact, at the judge's tolerance.
pub(crate) fn operators(grid: usize) -> f64 {
    20.0 * (grid as f64 / 64.0).powf(0.3)
}

/// The loads that are judged, fewer at each step: all, then the least, the middle and the largest, then the middle.
fn loads_given_up(by_pressure: &[usize]) -> Vec<Vec<usize>> {
    let (middle, last) = (by_pressure.len() / 2, by_pressure.len().saturating_sub(1));
    let mut choices = vec![by_pressure.to_vec()];
    if by_pressure.len() > 3 {
        choices.push([0, middle, last].map(|at| by_pressure[at]).to_vec());
    }
    if by_pressure.len() > 1 {
        choices.push(vec![by_pressure[middle]]);
    }
    choices
}

/// The surfaces and pressures of a judgement, and their cost in operator applications times grid points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Extent {
    /// Points along each side of a surface.
    pub grid: usize,
    /// Points along each side of the surfaces of the last window, which is prolonged if it would be pressed flat.
    pub grid_of_last: usize,
    /// Surfaces in each window but the last.
    pub realisations: usize,
    /// Surfaces in the last window, on which the area of the whole band rests.
    pub realisations_of_last: usize,
    /// The seed of the surfaces.
    pub seed: u64,
    /// The number of windows of the spectrum; one if the grid holds the whole band.
    pub windows: usize,
    /// The number of further windows, left out because noise left them no roughness.
    pub left_out: usize,
    /// The number of pressures on windows that were solved.
    pub solved: usize,
    /// The number of loads of the scene that were judged.
    pub loads: usize,
    /// The cost estimated beforehand.
    pub estimated: f64,
    /// The cost spent.
    pub spent: f64,
    /// The cost allowed.
    pub budget: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_given_up_from_all_to_the_least_the_middle_and_the_largest_to_the_middle() {
        let cases: [(&[usize], &[&[usize]]); 5] = [
            (&[], &[&[]]),
            (&[0], &[&[0]]),
            (&[1, 0], &[&[1, 0], &[0]]),
            (&[2, 0, 1], &[&[2, 0, 1], &[0]]),
            (&[3, 1, 0, 4, 2], &[&[3, 1, 0, 4, 2], &[3, 0, 2], &[0]]),
        ];
        for (loads, choices) in cases {
            assert_eq!(loads_given_up(loads), choices);
        }
    }

    #[test]
    fn pressures_within_a_hundredth_share_a_solution() {
        let press = Press { window: 0, pressure_pa: 2e6, saturation_pa: None };
        for (over, shares) in [(0.985, false), (0.995, true), (1.0, true), (1.005, true), (1.015, false)] {
            assert_eq!(press.has_pressure(2e6 * over), shares, "{over}");
        }
        assert!((operators(64) - 20.0).abs() < 1e-12 && ((operators(128) / 20.0).log2() - 0.3).abs() < 1e-12);
    }
}
