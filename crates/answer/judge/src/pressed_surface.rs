//! The pressed surface to look at: heights, and the points that touch under each load.

use numerics::parallel::{NestedProgress, Progress};
use spectrum::random_surfaces::{Phases, RandomSurface, Synthesis};

use crate::JudgeError;
use crate::body::Reference;
use crate::case::Case;
use crate::headline::{Basis, Headline};
use crate::layout::{FLOWING, SAME_PRESSURE};
use crate::maps::Press;
use crate::standing_maps::{StandingContact, StandingMaps};
use crate::window::{Window, bands, decades_held, points_per_shortest};

/// Points along each side of a surface that is made to be looked at, under few pressures and under many.
const POINTS: [usize; 2] = [256, 128];
/// The most pressures that are few.
const FEW: usize = 3;

/// A surface that was pressed as the best estimate of each load has it, to be looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct PressedSurface {
    /// The name of the measured map; `None` for a Gaussian surface of the spectrum's longest waves.
    pub map: Option<String>,
    /// Heights \[m\], row by row.
    pub heights_m: Vec<f64>,
    /// Points along x.
    pub columns: usize,
    /// The side along x \[m\].
    pub length_x_m: f64,
    /// The side along y \[m\].
    pub length_y_m: f64,
    /// The shortest wavelength of a Gaussian surface \[m\]; finer waves are left out. `None` where all waves are there.
    pub shortest_m: Option<f64>,
    /// The contacts, one for each load whose best estimate is one of elements, unless all of the surface flows.
    pub contacts: Vec<SeenContact>,
}

/// The contact of a surface under a load.
#[derive(Debug, Clone, PartialEq)]
pub struct SeenContact {
    /// The load, by index.
    pub load: usize,
    /// True for each point in contact, row by row.
    pub touching: Vec<bool>,
}

impl SeenContact {
    /// Returns the share of the points in contact.
    #[must_use]
    pub fn area_fraction(&self) -> f64 {
        self.touching.iter().filter(|touches| **touches).count() as f64 / self.touching.len() as f64
    }
}

impl PressedSurface {
    /// Takes the map that stands for the surface, or else presses a surface of the longest waves under every load; `None` if there is
    /// nothing to press.
    pub(crate) fn new(
        case: &Case<'_>,
        headlines: &[Headline],
        standing: StandingMaps,
        seed: u64,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, JudgeError> {
        let pressed: Vec<(usize, Reference)> = headlines.iter().filter_map(pressed).collect();
        let surface = match Self::of_map(case, &pressed, standing) {
            Some(map) => Some(map),
            None => Self::of_waves(case, &pressed, seed, progress)?,
        };
        Ok(surface.filter(|surface| !surface.contacts.is_empty()))
    }

    /// The first of the standing maps, as it was pressed already.
    fn of_map(case: &Case<'_>, pressed: &[(usize, Reference)], standing: StandingMaps) -> Option<Self> {
        let StandingMaps { first, contacts, names, .. } = standing;
        let is_best =
            |contact: &StandingContact| pressed.contains(&(contact.load, case.references[contact.body]));
        let seen = |contact: StandingContact| SeenContact { load: contact.load, touching: contact.touching };
        let contacts = contacts.into_iter().filter(is_best).map(seen).collect();
        Some(PressedSurface { map: names.into_iter().next(), ..Self::new_of(first?, None, contacts) })
    }

    /// A Gaussian surface of the longest waves.
    fn of_waves(
        case: &Case<'_>,
        pressed: &[(usize, Reference)],
        seed: u64,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, JudgeError> {
        let Some(waves) = &case.waves else { return Ok(None) };
        let is_alike = |a: &(usize, Reference), b: &(usize, Reference)| {
            let ratio = case.nominal_pressure_pa(a.0) / case.nominal_pressure_pa(b.0);
            a.1 == b.1 && (ratio - 1.0).abs() < SAME_PRESSURE
        };
        let mut distinct: Vec<(usize, Reference)> = Vec::new();
        for one in pressed {
            if !distinct.iter().any(|other| is_alike(one, other)) {
                distinct.push(*one);
            }
        }
        let points = POINTS[usize::from(distinct.len() > FEW)];
        let per_shortest = points_per_shortest(waves, case.band(), points);
        let band = bands(case.band(), decades_held(points, per_shortest))[0];
        // Noise may leave the longest waves, or a wave of the box, no roughness.
        let Ok(window) = Window::new(waves, band, points, per_shortest) else { return Ok(None) };
        let synthesis = Synthesis::square(points, window.box_m, seed, Phases::FixedModulus);
        let Ok(surface) = window.waves.realised(&synthesis, 0) else { return Ok(None) };
        let forms = case.forms(&window);
        let progress = NestedProgress(progress);
        let touching = numerics::parallel::try_map(&distinct, |&(load, reference)| {
            let pressure_pa = case.pressure_pa(&forms, reference, load);
            let saturation_pa = case.saturation_pa(reference, band.middle_m());
            if saturation_pa.is_some_and(|bound_pa| pressure_pa > FLOWING * bound_pa) {
                return Ok::<_, JudgeError>(None);
            }
            let press = Press { case, pressure_pa, saturation_pa };
            Ok(press.on(&surface, false, &progress)?.map(|(contact, _)| contact.touching()))
        })?;
        let of_load = |one: &(usize, Reference)| {
            let alike = distinct.iter().position(|other| is_alike(one, other))?;
            Some(SeenContact { load: one.0, touching: touching[alike].clone()? })
        };
        let contacts = pressed.iter().filter_map(of_load).collect();
        let is_cut = band.shortest_m > case.band().shortest_m;
        let shortest_m = is_cut.then_some(band.shortest_m);
        Ok(Some(Self::new_of(surface, shortest_m, contacts)))
    }

    fn new_of(surface: RandomSurface, shortest_m: Option<f64>, contacts: Vec<SeenContact>) -> Self {
        PressedSurface {
            map: None,
            columns: surface.points_x,
            length_x_m: surface.length_x_m,
            length_y_m: surface.length_y_m,
            heights_m: surface.heights_m,
            shortest_m,
            contacts,
        }
    }
}

/// The load of a headline, and the elements of its best estimate.
fn pressed(headline: &Headline) -> Option<(usize, Reference)> {
    match headline.basis {
        Basis::Elements(reference) => Some((headline.load, reference)),
        Basis::RangeOfModels { .. } => None,
    }
}
