//! What is going to be pressed, fixed before anything is: grid, windows, surfaces, and the pressures of each window.

use gaussian_surfaces::AreaSpectrum;
use serde::Serialize;

use crate::settings::{DEFAULT_REALISATIONS, GRIDS, Settings};
use crate::window::{Band, Window, bands, decades_held};

/// Pressures that differ by less than this share a solution.
const SAME_PRESSURE: f64 = 0.01;
/// Above this share of the hardness everything flows: contact is between p/H and 1.
const FLOWING: f64 = 0.98;
/// With fewer points in contact the grid says little of the area.
const LEAST_POINTS: f64 = 200.0;
/// Surfaces without which there is no scatter.
const LEAST_REALISATIONS: usize = 2;
/// The slope of area against p/(E* h') at light load, for an estimate of how many points will touch.
const SLOPE_OF_AREA: f64 = 2.0;

/// A pressure on a window that elements are asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Press {
    /// The window, by index.
    pub window: usize,
    /// The mean pressure \[Pa\].
    pub pressure_pa: f64,
    /// What no point's pressure exceeds \[Pa\].
    pub saturation_pa: Option<f64>,
}

/// What elements can say of a pressure on a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Asked {
    /// It is solved, by index of the press.
    Solved(usize),
    /// Everything flows: the area is between p/H and 1.
    Flowing {
        /// Mean pressure over hardness.
        share: f64,
    },
    /// Too few points of the grid would touch.
    TooLight,
    /// The load is not one of those that the budget allows.
    NotChosen,
}

/// The whole of what will be pressed.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Points along each side.
    pub grid: usize,
    /// Surfaces in each window.
    pub realisations: usize,
    pub windows: Vec<Window>,
    /// How many windows have no roughness.
    pub left_out: usize,
    pub presses: Vec<Press>,
    /// For every body, window and load, what is asked.
    pub asked: Vec<Vec<Vec<Asked>>>,
    /// The loads that are judged, by index.
    pub loads: Vec<usize>,
    /// Operators times points, as reckoned beforehand.
    pub cost: f64,
}

/// What the layout is made of.
pub(crate) struct Ground<'g> {
    pub surface: &'g AreaSpectrum,
    pub band: Band,
    pub composite_modulus_pa: f64,
    /// The bound on pressure \[Pa\] of every body that elements are asked for.
    pub saturations_pa: &'g [Option<f64>],
    /// How many loads the scene has, in the order of their pressures.
    pub loads_by_pressure: &'g [usize],
    /// The mean real pressure \[Pa\] at a wavelength \[m\], for a body and a load.
    pub pressure_pa: &'g (dyn Fn(usize, usize, f64) -> f64 + 'g),
}

impl Layout {
    /// The finest layout that the budget allows; `None` where even the coarsest is beyond it.
    pub fn within(settings: &Settings, ground: &Ground<'_>) -> Option<Self> {
        let grids: Vec<usize> = settings.grid.map_or_else(|| GRIDS.to_vec(), |grid| vec![grid]);
        let realisations = settings.realisations.unwrap_or(DEFAULT_REALISATIONS);
        // What a scene gives up first: fineness, then loads, then surfaces.
        for loads in loads_given_up(ground.loads_by_pressure) {
            for &grid in &grids {
                let layout = Layout::of(grid, realisations, &loads, ground);
                if layout.cost <= settings.budget {
                    return Some(layout);
                }
            }
        }
        let (Some(&grid), None) = (grids.last(), settings.realisations) else { return None };
        let fewest = loads_given_up(ground.loads_by_pressure).pop().unwrap_or_default();
        let layout = Layout::of(grid, LEAST_REALISATIONS, &fewest, ground);
        (layout.cost <= settings.budget).then_some(layout)
    }

    fn of(grid: usize, realisations: usize, loads: &[usize], ground: &Ground<'_>) -> Self {
        let bands = bands(ground.band, decades_held(grid));
        // Noise may leave a band of the surface without waves.
        let windows: Vec<Window> =
            bands.iter().filter_map(|band| Window::of(ground.surface, *band).ok()).collect();
        let mut layout = Layout {
            left_out: bands.len() - windows.len(),
            grid,
            realisations,
            windows,
            presses: Vec::new(),
            asked: Vec::new(),
            loads: loads.to_vec(),
            cost: 0.0,
        };
        for body in 0..ground.saturations_pa.len() {
            let of_windows = (0..layout.windows.len()).map(|window| {
                let of_load = |load| layout.ask(body, window, load, ground);
                (0..ground.loads_by_pressure.len()).map(of_load).collect()
            });
            let of_windows = of_windows.collect();
            layout.asked.push(of_windows);
        }
        layout.cost = layout.reckoned();
        layout
    }

    fn ask(&mut self, body: usize, window: usize, load: usize, ground: &Ground<'_>) -> Asked {
        if !self.loads.contains(&load) {
            return Asked::NotChosen;
        }
        let of_window = &self.windows[window];
        let pressure_pa = (ground.pressure_pa)(body, load, of_window.band.longest_m);
        let saturation_pa = ground.saturations_pa[body];
        if let Some(share) = saturation_pa.map(|bound_pa| pressure_pa / bound_pa).filter(|s| *s > FLOWING) {
            return Asked::Flowing { share: share.min(1.0) };
        }
        let over_gradient = pressure_pa / (ground.composite_modulus_pa * of_window.rms_gradient);
        if SLOPE_OF_AREA * over_gradient * (self.grid * self.grid) as f64 <= LEAST_POINTS {
            return Asked::TooLight;
        }
        let same = |press: &Press| {
            press.window == window
                && press.saturation_pa == saturation_pa
                && (press.pressure_pa / pressure_pa - 1.0).abs() < SAME_PRESSURE
        };
        Asked::Solved(self.presses.iter().position(same).unwrap_or_else(|| {
            self.presses.push(Press { window, pressure_pa, saturation_pa });
            self.presses.len() - 1
        }))
    }

    /// Operators times points of all presses.
    fn reckoned(&self) -> f64 {
        let solutions = self.realisations * self.presses.len();
        solutions as f64 * (self.grid * self.grid) as f64 * operators(self.grid)
    }
}

/// Operators that a solution takes on a grid: a line through the largest of the counts measured for windows of Hurst exponents
/// 0.5 and 0.8, elastic and saturated, from light loads to full contact, at the judge's tolerance.
fn operators(grid: usize) -> f64 {
    20.0 * (grid as f64 / 64.0).powf(0.3)
}

/// Which loads are judged, giving up more and more of them: all, then the least, the middle and the largest, then the middle.
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

/// What was fixed beforehand, for whoever reads the result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Extent {
    /// Points along each side of a surface.
    pub grid: usize,
    /// Surfaces in each window.
    pub realisations: usize,
    /// The seed of the surfaces.
    pub seed: u64,
    /// How many windows the spectrum was cut into; one where the grid holds the whole of it.
    pub windows: usize,
    /// How many more had no roughness, as noise may leave of a spectrum.
    pub left_out: usize,
    /// How many pressures on windows were solved.
    pub solved: usize,
    /// How many of the scene's loads were judged.
    pub loads: usize,
    /// Operators times points, as reckoned beforehand.
    pub reckoned: f64,
    /// Operators times points that were spent.
    pub spent: f64,
    /// What could have been.
    pub budget: f64,
}
