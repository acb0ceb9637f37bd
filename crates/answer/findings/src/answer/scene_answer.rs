//! The answer of a scene: the contact areas, the scales that decide them, and disagreements between models.

use serde::Serialize;
use spectrum::Hole;
use stacked_contact::setting_level;

use crate::features::{Convergence, DecadeShare, Point, convergence, decade_shares, parts_at, ratio};
use scene::Scene;
use study::plan::{Curve, CurveResult, Cutoffs, Load, Results};
use topography::InstrumentsDisagree;

/// The smallest number of scales of a spectrum, over [`MIN_DECADES`], from which the deciding scales can be found.
pub const MIN_SCALES: usize = 5;
/// The fewest decades for [`MIN_SCALES`].
pub const MIN_DECADES: f64 = 1.0;

/// The factor from which on models disagree.
pub const DISAGREEMENT: f64 = 2.0;

/// The findings on the areas of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneAnswer {
    /// For every curve and load of the scene the final area; `None` if the cutoffs leave no asperities.
    pub curves: Vec<Vec<Option<LoadAnswer>>>,
    /// For every load with several curves, the distance of their final areas.
    pub disagreements: Vec<Disagreement>,
    /// The number of scales of the spectrum, if it is below the minimum.
    pub too_few_scales: Option<usize>,
    /// The instruments of the spectrum, if they do not show the same surface.
    pub instruments_disagree: Option<InstrumentsDisagree>,
}

/// The final area of a curve under one load, and the scales that decide it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoadAnswer {
    /// Contact area over nominal area at the shortest wavelength.
    pub area_fraction: f64,
    /// Mean pressure on that area \[Pa\].
    pub real_pressure_pa: f64,
    /// The wavelength at which the area has settled within 1 %.
    pub within_1_percent: Convergence,
    /// The wavelength at which the area has settled within 0.1 %.
    pub within_01_percent: Convergence,
    /// True if the area was computed at every cutoff; otherwise settling and deciding scales are unknown.
    pub followed: bool,
    /// True if the area is that of the surface: the spectrum extends far enough below the settling wavelength, has
    /// enough scales, and its instruments agree.
    pub settled: bool,
    /// The share of each decade of wavelengths in the area.
    pub decades: Vec<DecadeShare>,
    /// The scale of a stack that sets the real pressure.
    pub setting: Option<SettingScale>,
    /// Share of the load on asperities outside the range their law was fitted in, of a statistical model.
    pub out_of_range_load_share: Option<f64>,
}

/// The scale of a stack that takes the highest pressure to flatten.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SettingScale {
    /// Its wavelength \[m\].
    pub wavelength_m: f64,
    /// Its aspect ratio.
    pub aspect_ratio: f64,
    /// The pressure of its complete contact \[Pa\], which the real pressure does not exceed.
    pub full_contact_pressure_pa: f64,
}

/// The disagreement of the curves of a scene under one load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Disagreement {
    /// The load, by index.
    pub load: usize,
    /// The curve of the smallest area, by index.
    pub least: usize,
    /// The curve of the largest area, by index.
    pub most: usize,
    /// The largest final area over the least.
    pub ratio: f64,
    /// The longest cutoff \[m\] below which these two curves stay a factor of [`DISAGREEMENT`] or more apart; `None`
    /// unless both were computed at every cutoff.
    pub parting_wavelength_m: Option<f64>,
}

impl SceneAnswer {
    /// Extracts the answer from the results of a scene.
    pub fn from_results(scene: &Scene, results: &Results) -> Self {
        let needs = &scene.needs;
        let mut faces = scene.surface.each().into_iter().filter_map(|face| face.made_from.as_ref());
        let instruments_disagree = faces.find_map(|scans| scans.spectrum.instruments_disagree());
        let wavelengths_m = results.psd.wavelengths_m();
        let decades = (wavelengths_m[0] / wavelengths_m[wavelengths_m.len() - 1]).log10();
        let enough = wavelengths_m.len() >= MIN_SCALES && decades >= MIN_DECADES;
        let can_settle = enough && instruments_disagree.is_none();
        let of_curve = |(curve, result): (&Curve, &CurveResult)| {
            let of_load = |(block, load): (usize, &Load)| {
                let answer = LoadAnswer::new(curve, result, block, load.nominal_pressure_pa(), can_settle)?;
                Some(answer.of_spectrum_with(&scene.surface.holes))
            };
            needs.loads.iter().enumerate().map(of_load).collect()
        };
        let curves: Vec<Vec<Option<LoadAnswer>>> =
            needs.curves.iter().zip(&results.curves).map(of_curve).collect();
        let disagreements =
            (0..needs.loads.len()).filter_map(|load| Disagreement::at(load, &curves, results)).collect();
        let too_few_scales = (!enough).then_some(wavelengths_m.len());
        SceneAnswer { curves, disagreements, too_few_scales, instruments_disagree }
    }
}

impl LoadAnswer {
    fn new(
        curve: &Curve,
        result: &CurveResult,
        block: usize,
        pressure_pa: f64,
        can_settle: bool,
    ) -> Option<Self> {
        let points = result.area_fractions(block);
        let &(_, area_fraction) = points.last()?;
        let within = |tolerance| convergence(&points, tolerance);
        let within_1_percent = within(0.01)?;
        let followed = curve.cutoffs == Cutoffs::Every;
        // In complete contact the load sets the pressure.
        let stack = curve.model.stacked().zip(result.stacked()).filter(|_| area_fraction < 1.0 && followed);
        let setting = stack.and_then(|(model, blocks)| setting_level(model, &blocks[block]));
        let out_of_range =
            result.statistical().and_then(|blocks| blocks[block].last()).and_then(|row| row.contact);
        Some(LoadAnswer {
            area_fraction,
            real_pressure_pa: pressure_pa / area_fraction,
            within_1_percent,
            within_01_percent: within(0.001)?,
            followed,
            settled: followed && can_settle && within_1_percent.converged,
            decades: if followed { decade_shares(&points) } else { Vec::new() },
            setting: setting.map(|(level, full_contact_pressure_pa)| SettingScale {
                wavelength_m: level.wavelength_m,
                aspect_ratio: level.amplitude_m / level.wavelength_m,
                full_contact_pressure_pa,
            }),
            out_of_range_load_share: out_of_range.map(|(_, state)| state.out_of_range_load_share),
        })
    }

    /// The wavelength \[m\] at which the area has settled, by one of the two convergences of this answer; `None` if the
    /// spectrum cannot show it.
    #[must_use]
    pub fn settled_at_m(&self, within: Convergence) -> Option<f64> {
        within.if_converged_m().filter(|_| self.settled)
    }

    /// Marks the decades that lie mostly in holes of the spectrum as not measured.
    fn of_spectrum_with(mut self, holes: &[Hole]) -> Self {
        for decade in &mut self.decades {
            *decade = decade.of_spectrum_with(holes);
        }
        self
    }
}

impl Disagreement {
    fn at(load: usize, curves: &[Vec<Option<LoadAnswer>>], results: &Results) -> Option<Self> {
        let area = |curve: usize| curves[curve][load].as_ref().map(|answer| answer.area_fraction);
        let areas = || (0..curves.len()).filter_map(|curve| area(curve).map(|area| (curve, area)));
        let (least, least_area) = areas().reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        let (most, most_area) = areas().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let points = |curve: usize| -> Vec<Point> { results.curves[curve].area_fractions(load) };
        let followed = |curve: usize| curves[curve][load].as_ref().is_some_and(|answer| answer.followed);
        (areas().count() > 1).then(|| Disagreement {
            load,
            least,
            most,
            ratio: most_area / least_area,
            parting_wavelength_m: if followed(least) && followed(most) {
                parts_at(&ratio(&points(most), &points(least)), DISAGREEMENT)
            } else {
                None
            },
        })
    }
}
