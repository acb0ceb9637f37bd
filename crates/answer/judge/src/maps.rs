//! Measured maps pressed by boundary elements, compared with Gaussian surfaces that have the same waves. The difference
//! is the effect of everything that a spectrum omits.

use elements::half_space::{Contact, Grid, Loading};
use measurements::MapPatch;
use numerics::parallel::Progress;
use serde::Serialize;
use spectrum::random_surfaces::{MapWaves, RandomSurface};

use crate::JudgeError;
use crate::case::Case;
use crate::layout::MIN_POINTS;
use crate::solve::{Solved, TOLERANCE};
use crate::verdict::ERRORS_GIVEN;
use crate::verdicts::ElementArea;
use crate::window::POINTS_PER_SHORTEST;

/// Gaussian surfaces beside each map.
const TWINS: u64 = 4;
/// The pressure over E* h' at which nearly all of a map touches.
const NEARLY_FULL: f64 = 1.0;
/// The least difference between a map and its twins that counts.
const LEAST_DIFFERENCE: f64 = 0.15;
/// Standard errors of its twins by which a map differs from them.
const ERRORS_APART: f64 = 3.0;

/// The area of a measured map under a load, and that of Gaussian surfaces with the same waves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapVerdict {
    /// The name of the measurement.
    pub map: String,
    /// The load, by index: the first of those with the same pressure on the map.
    pub load: usize,
    /// The mean pressure on the map, by the closed form for the longer waves, over E* times the rms gradient of the map; more where few
    /// points would bear it.
    pub pressure_over_gradient: f64,
    /// The rms gradient of the map over that of isotropic surfaces with its spectrum.
    pub gradient_over_spectrum: f64,
    /// The area fraction of the map.
    pub area_fraction: f64,
    /// The area fraction of Gaussian surfaces with its spectrum: with the amplitudes of its waves and random phases, as steep as the
    /// spectrum says in every direction.
    pub twins: ElementArea,
}

impl MapVerdict {
    /// The map's area over that of its twins.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.area_fraction / self.twins.area_fraction
    }

    /// Two standard errors of the ratio.
    #[must_use]
    pub fn ratio_error(&self) -> f64 {
        ERRORS_GIVEN * self.twins.relative_error() * self.ratio()
    }

    /// True if its slopes differ by direction so much that areas do.
    #[must_use]
    pub fn has_direction(&self) -> bool {
        self.gradient_over_spectrum.ln().abs() > LEAST_DIFFERENCE.ln_1p()
    }

    /// True if the map touches otherwise than its twins: its heights are not Gaussian, or its slopes differ by direction.
    #[must_use]
    pub fn differs(&self) -> bool {
        let apart = ERRORS_APART * self.twins.relative_error() * self.ratio();
        (self.ratio() - 1.0).abs() > apart.max(LEAST_DIFFERENCE)
    }
}

/// The loads and the resolution at which maps are pressed.
pub(crate) struct MapPressing<'p> {
    pub case: &'p Case<'p>,
    /// The loads, by index.
    pub loads: &'p [usize],
    pub seed: u64,
    /// The most points along a side.
    pub grid: usize,
}

/// Presses maps and their twins, elastically. Cancelled work is left out.
pub(crate) fn compare_maps(
    pressing: &MapPressing<'_>,
    progress: &dyn Progress,
) -> Result<Vec<MapVerdict>, JudgeError> {
    let found =
        numerics::parallel::try_map(pressing.case.maps(), |patch| compare_map(patch, pressing, progress))?;
    Ok(found.into_iter().flatten().collect())
}

fn compare_map(
    patch: &MapPatch,
    pressing: &MapPressing<'_>,
    progress: &dyn Progress,
) -> Result<Vec<MapVerdict>, JudgeError> {
    let waves = waves(&patch.middle(pressing.grid), POINTS_PER_SHORTEST);
    let surface = waves.surface();
    let gradient_pa = pressing.case.composite_modulus_pa * surface.mean_square_gradient().sqrt();
    let points = surface.heights_m.len() as f64;
    let mut found: Vec<MapVerdict> = Vec::new();
    let shortest_side_m = surface.length_x_m.min(surface.length_y_m);
    for &load in pressing.loads {
        // A load that few points would bear is pressed as one that enough do.
        let least_pa = MIN_POINTS / (2.0 * points) * gradient_pa;
        let pressure_pa = pressing.case.pressure_at_pa(shortest_side_m, None, load).max(least_pa);
        let pressure_over_gradient = pressure_pa / gradient_pa;
        let known = |of: &MapVerdict| (of.pressure_over_gradient / pressure_over_gradient - 1.0).abs() < 0.01;
        if pressure_over_gradient >= NEARLY_FULL || found.iter().any(known) {
            continue;
        }
        let area = |surface: &RandomSurface, pressure_pa: f64| {
            let press = Press { case: pressing.case, pressure_pa, saturation_pa: None };
            Ok::<_, JudgeError>(
                press.on(surface, false, progress)?.map(|(found, _)| found.numbers.area_fraction_corrected),
            )
        };
        let Some(area_fraction) = area(&surface, pressure_pa)? else { return Ok(found) };
        // Twins as steep as the spectrum says touch as these do under the same pressure over their gradient.
        let of_twins_pa = patch.gradient_over_spectrum * pressure_pa;
        let twins = (0..TWINS).map(|at| area(&waves.twin(pressing.seed, at), of_twins_pa));
        let Some(twins) = twins.collect::<Result<Option<Vec<f64>>, JudgeError>>()? else { return Ok(found) };
        let Solved { area_fraction: of_twins, standard_error } = Solved::from_surfaces(&twins, None);
        let twins = ElementArea::new(of_twins, standard_error);
        found.push(MapVerdict {
            map: patch.name.clone(),
            load,
            pressure_over_gradient,
            gradient_over_spectrum: patch.gradient_over_spectrum,
            area_fraction,
            twins,
        });
    }
    Ok(found)
}

/// Returns the waves of a map that have at least so many points.
pub(crate) fn waves(patch: &MapPatch, least_points: f64) -> MapWaves {
    MapWaves::new(&patch.heights_m(), patch.map.columns(), patch.sides_m(), patch.is_periodic, least_points)
}

/// A mean pressure on a surface that is pressed as it is.
pub(crate) struct Press<'p> {
    pub case: &'p Case<'p>,
    pub pressure_pa: f64,
    /// The bound \[Pa\] on the pressure of every point.
    pub saturation_pa: Option<f64>,
}

impl Press<'_> {
    /// Presses a surface, and finds its stiffness \[Pa/m\] if that is wanted; `None` if the work is cancelled.
    pub fn on(
        &self,
        surface: &RandomSurface,
        wants_stiffness: bool,
        progress: &dyn Progress,
    ) -> Result<Option<(Contact, Option<f64>)>, JudgeError> {
        if progress.is_cancelled() {
            return Ok(None);
        }
        let (rows, columns) = (surface.points_y, surface.points_x);
        let grid = Grid::new(rows, columns, surface.length_x_m, surface.length_y_m)?;
        let loading = Loading {
            contact_modulus_pa: self.case.composite_modulus_pa,
            nominal_pressure_pa: self.pressure_pa,
            saturation_pa: self.saturation_pa,
            tolerance: TOLERANCE,
        };
        let mut elements = self.case.elements(grid, &surface.heights_m)?;
        let contact = elements.press(&loading, progress)?;
        let stiffness = || elements.stiffness_pa_per_m(&contact, loading.contact_modulus_pa, progress);
        let stiffness_pa_per_m = wants_stiffness.then(stiffness).transpose()?.flatten();
        Ok(Some((contact, stiffness_pa_per_m)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A map of this area and these slopes, beside twins of an area of 0.2 with a relative error.
    fn map(area_fraction: f64, gradient_over_spectrum: f64, relative_error: f64) -> MapVerdict {
        MapVerdict {
            map: String::new(),
            load: 0,
            pressure_over_gradient: 0.1,
            gradient_over_spectrum,
            area_fraction,
            twins: ElementArea::new(0.2, 0.2 * relative_error),
        }
    }

    #[test]
    fn a_map_differs_beyond_fifteen_percent_and_beyond_three_errors_of_its_twins() {
        let cases = [
            (0.2 * 1.14, 0.01, false),
            (0.2 * 1.16, 0.01, true),
            (0.2 * 0.86, 0.01, false),
            (0.2 * 0.84, 0.01, true),
            // Three errors of 10 % are 0.39 of a ratio of 1.3, and 0.45 of one of 1.5.
            (0.2 * 1.3, 0.1, false),
            (0.2 * 1.5, 0.1, true),
        ];
        for (area_fraction, error, differs) in cases {
            let map = map(area_fraction, 1.0, error);
            assert_eq!(map.differs(), differs, "{map:?}");
            assert!((map.ratio() / (area_fraction / 0.2) - 1.0).abs() < 1e-12);
            assert!((map.ratio_error() / (2.0 * error * area_fraction / 0.2) - 1.0).abs() < 1e-12);
        }
        for (gradient, has_direction) in
            [(1.0, false), (1.14, false), (1.16, true), (0.88, false), (0.86, true)]
        {
            assert_eq!(map(0.2, gradient, 0.01).has_direction(), has_direction, "{gradient}");
        }
    }
}
