//! Maps that stand for the whole surface: pressed as they were scanned, they have the area that a spectrum only estimates.

use measurements::MapPatch;
use numerics::parallel::{NestedProgress, Progress};
use spectrum::random_surfaces::RandomSurface;

use crate::JudgeError;
use crate::body::Reference;
use crate::case::Case;
use crate::layout::{FLOWING, GRIDS, operators};
use crate::maps::{Press, waves};
use crate::solve::Solved;
use crate::verdicts::{ElementArea, PressedMaps};

/// The least share of the band's mean-square gradient that a map holds to stand for the surface.
const LEAST_SHARE: f64 = 0.95;
/// Points on a wave that a map just does not resolve along a diagonal: all its waves have more.
const ALL_WAVES: f64 = std::f64::consts::SQRT_2;
/// The fewest points in contact that say more of a map than Gaussian surfaces do.
const MIN_POINTS: f64 = 20.0;
/// The relative standard error of maps that do not repeat themselves: areas of three with free edges, or between their mirror images, lie
/// factors of 1.12 to 1.3 from those of repeated ones.
const EDGE_ERROR: f64 = 0.08;
/// A spectrum that ends at so many points on its shortest wave, or fewer, has all waves of the map.
const ENDS_WITH_MAP: f64 = 2.5;

/// The area of the maps that stand for the surface, with their gap and stiffness, between the bodies of a reference under a load; both
/// by index.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StandingArea {
    pub body: usize,
    pub load: usize,
    pub elements: ElementArea,
    pub maps: PressedMaps,
}

/// The contact of a map between the bodies of a reference under a load; both by index.
#[derive(Debug)]
pub(crate) struct StandingContact {
    pub body: usize,
    pub load: usize,
    /// True for each point in contact, row by row.
    pub touching: Vec<bool>,
}

/// The maps that stand for the surface.
#[derive(Debug, Default)]
pub(crate) struct StandingMaps {
    /// Their areas.
    pub areas: Vec<StandingArea>,
    /// Their names.
    pub names: Vec<String>,
    /// Their rms gradient over that of isotropic surfaces with their spectrum.
    pub gradient_over_spectrum: f64,
    /// The first of them as it was pressed; `None` without one.
    pub first: Option<RandomSurface>,
    /// Its contacts.
    pub contacts: Vec<StandingContact>,
}

/// Presses the maps that hold nearly all slopes of the band, as finely as the budget allows, between all bodies under these loads.
pub(crate) fn press_standing_maps(
    case: &Case<'_>,
    loads: &[usize],
    budget: f64,
    progress: &dyn Progress,
) -> Result<StandingMaps, JudgeError> {
    let maps = case.maps();
    let presses = (maps.len() * loads.len() * case.references.len()) as f64;
    let cost = |points: usize| presses * operators(points) * (points * points) as f64;
    let Some(points) = GRIDS.into_iter().find(|points| cost(*points) <= budget) else {
        return Ok(StandingMaps::default());
    };
    let standing: Vec<MapPatch> =
        maps.iter().map(|map| map.middle(points)).filter(|map| stands(map, case)).collect();
    let surfaces: Vec<(RandomSurface, bool)> =
        standing.iter().map(|map| (surface(map, case), map.is_periodic)).collect();
    let bodies = 0..case.references.len();
    let cells: Vec<(usize, usize)> =
        bodies.flat_map(|body| loads.iter().map(move |&load| (body, load))).collect();
    let progress = NestedProgress(progress);
    let pressed = numerics::parallel::try_map(&cells, |&cell| {
        let of_maps: Result<Option<Vec<(StandingArea, StandingContact)>>, JudgeError> =
            surfaces.iter().map(|surface| press(surface, case, cell, &progress)).collect();
        let (areas, contacts): (Vec<_>, Vec<_>) = of_maps?.unwrap_or_default().into_iter().unzip();
        Ok::<_, JudgeError>(mean(&areas).zip(contacts.into_iter().next()))
    })?;
    let (areas, contacts) = pressed.into_iter().flatten().unzip();
    let squares = standing.iter().map(|map| map.gradient_over_spectrum.powi(2));
    Ok(StandingMaps {
        areas,
        contacts,
        names: standing.iter().map(|map| map.name.clone()).collect(),
        gradient_over_spectrum: (squares.sum::<f64>() / standing.len().max(1) as f64).sqrt(),
        first: surfaces.into_iter().next().map(|(surface, _)| surface),
    })
}

/// Returns true if the waves of a map hold nearly all slopes of the band.
fn stands(map: &MapPatch, case: &Case<'_>) -> bool {
    let [x_m, y_m] = map.sides_m();
    let square = |wavelength_m: f64| case.rms_pressure_pa(wavelength_m.max(case.band().shortest_m)).powi(2);
    let shortest_m = 2.0 * map.map.spacing_x_m().max(map.map.spacing_y_m());
    square(shortest_m) - square(x_m.min(y_m)) >= LEAST_SHARE * square(case.band().shortest_m)
}

/// Returns a map with the waves of the band that the scene presses.
fn surface(map: &MapPatch, case: &Case<'_>) -> RandomSurface {
    let waves = waves(map, ALL_WAVES);
    let spacing_m = map.map.spacing_x_m().max(map.map.spacing_y_m());
    let (surface, end_m) = (&case.scene.surface, case.band().shortest_m);
    let is_cut = end_m > (1.0 + 1e-9) * surface.psd.shortest_wavelength_m();
    // The last bin of a composite lies above the shortest wavelength that its scans show.
    let faces = surface.each().into_iter().filter_map(|face| face.made_from.as_ref());
    let scans = faces.flat_map(|made_from| &made_from.spectrum.scans);
    let shown_m = scans.map(|scan| scan.band.shortest_m).fold(end_m, f64::min);
    let shortest_m = if is_cut { end_m } else { shown_m };
    if shortest_m > ENDS_WITH_MAP * spacing_m { waves.down_to(shortest_m).surface() } else { waves.surface() }
}

/// Presses a map. The area lies between that of its points and that corrected by their perimeter, with the error of the edges; `None`
/// if that says little.
fn press(
    (surface, is_periodic): &(RandomSurface, bool),
    case: &Case<'_>,
    (body, load): (usize, usize),
    progress: &dyn Progress,
) -> Result<Option<(StandingArea, StandingContact)>, JudgeError> {
    let saturation_pa = match case.references[body] {
        Reference::Elastic => None,
        Reference::Yielding { hardness_pa } => Some(hardness_pa),
        Reference::Growing => return Ok(None),
    };
    let side_m = surface.length_x_m.min(surface.length_y_m);
    let pressure_pa = case.pressure_at_pa(side_m, saturation_pa, load);
    if saturation_pa.is_some_and(|bound_pa| pressure_pa > FLOWING * bound_pa) {
        return Ok(None);
    }
    let is_whole = pressure_pa == case.nominal_pressure_pa(load);
    let wants_stiffness = is_whole && case.scene.interface.is_some();
    let pressed = Press { case, pressure_pa, saturation_pa }.on(surface, wants_stiffness, progress)?;
    let Some((contact, stiffness_pa_per_m)) = pressed else { return Ok(None) };
    let found = contact.numbers;
    let points = found.area_fraction * surface.heights_m.len() as f64;
    if points < MIN_POINTS {
        return Ok(None);
    }
    let share = case.nominal_pressure_pa(load) / pressure_pa;
    let least = saturation_pa.map_or(0.0, |bound_pa| pressure_pa / bound_pa);
    let ends = [found.area_fraction_corrected, found.area_fraction].map(|area| share * area.max(least));
    // Both ends lie two standard errors from the middle.
    let elements = ElementArea::new(0.5 * (ends[0] + ends[1]), 0.25 * (ends[1] - ends[0]));
    // Of few points some lie at the edges. What flows has the area of the load over the hardness there as well.
    let elastic = 1.0 - (least / found.area_fraction).min(1.0);
    let of_edges = elastic * EDGE_ERROR.hypot(points.sqrt().recip());
    let elements = if *is_periodic { elements } else { elements.with_error(of_edges) };
    let maps = PressedMaps {
        mean_gap_m: is_whole.then_some(found.mean_gap_m),
        stiffness_pa_per_m,
        plastic_share: saturation_pa.map(|_| found.plastic_area_fraction / found.area_fraction),
    };
    let touching = contact.touching();
    Ok(Some((StandingArea { body, load, elements, maps }, StandingContact { body, load, touching })))
}

/// Averages maps at several places; `None` without a map.
fn mean(found: &[StandingArea]) -> Option<StandingArea> {
    let count = found.len() as f64;
    let areas: Vec<f64> = found.iter().map(|map| map.elements.area_fraction).collect();
    let Solved { area_fraction, standard_error } = Solved::from_surfaces(&areas, None);
    let between = found.iter().map(|map| map.elements.relative_error()).sum::<f64>() / count;
    let mean_of = |value: fn(&PressedMaps) -> Option<f64>| {
        let values: Option<Vec<f64>> = found.iter().map(|map| value(&map.maps)).collect();
        values.map(|values| values.iter().sum::<f64>() / count)
    };
    let maps = PressedMaps {
        mean_gap_m: mean_of(|maps| maps.mean_gap_m),
        stiffness_pa_per_m: mean_of(|maps| maps.stiffness_pa_per_m),
        plastic_share: mean_of(|maps| maps.plastic_share),
    };
    let elements = ElementArea::new(area_fraction, standard_error).with_error(between);
    found.first().map(|first| StandingArea { elements, maps, ..*first })
}
