//! The answer to a scene's question: how much touches, which scales decide it, and where the models disagree.

use serde::Serialize;
use spectrum::Hole;
use stacked_contact::setting_level;

use crate::features::{Convergence, DecadeShare, Point, convergence, decade_shares, parts_at, ratio};
use scene::Scene;
use study::plan::{Curve, CurveResult, Cutoffs, Load, Results};
use topography::InstrumentsDisagree;

/// From so many scales on, over so many decades, a spectrum can tell which of them matter.
pub const LEAST_SCALES: usize = 5;
/// See [`LEAST_SCALES`].
pub const LEAST_DECADES: f64 = 1.0;

/// The factor from which on models are said to disagree.
pub const DISAGREEMENT: f64 = 2.0;

/// What a scene found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// For every curve of the scene, for every load, what it ends in; none where the cutoffs leave no asperities.
    pub curves: Vec<Vec<Option<LoadAnswer>>>,
    /// For every load under which there are curves to compare, how far apart they end.
    pub disagreements: Vec<Disagreement>,
    /// How many scales the spectrum has, where they are too few to tell which of them matter.
    pub too_few_scales: Option<usize>,
    /// The instruments that made the spectrum, where they do not show the same surface.
    pub instruments_disagree: Option<InstrumentsDisagree>,
}

/// What a curve ends in under one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoadAnswer {
    /// Contact area over nominal area at the shortest wavelength.
    pub area_fraction: f64,
    /// Mean pressure on that area \[Pa\].
    pub real_pressure_pa: f64,
    /// Where the area has settled within 1 %.
    pub within_1_percent: Convergence,
    /// Where the area has settled within 0.1 %.
    pub within_01_percent: Convergence,
    /// Whether the area was followed from cutoff to cutoff; else nothing tells where it settles, nor which scales decide it.
    pub followed: bool,
    /// Whether the spectrum goes far enough below the former, has scales enough and is of one surface, for the area to be the
    /// surface's own rather than that of a spectrum cut short or of a step between two instruments.
    pub settled: bool,
    /// How much each decade of wavelengths decides.
    pub decades: Vec<DecadeShare>,
    /// The scale that sets the real pressure, of a stack.
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

/// How far apart the curves of a scene end under one load.
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
    /// The cutoff \[m\] from which on, at every shorter one, these two are a factor of [`DISAGREEMENT`] or more apart, where
    /// both were followed there.
    pub parting_wavelength_m: Option<f64>,
}

impl Answer {
    /// The answer that the results of a scene hold.
    pub fn of(scene: &Scene, results: &Results) -> Self {
        let needs = &scene.needs;
        let scans = scene.surface.made_from.as_ref();
        let instruments_disagree = scans.and_then(|scans| scans.spectrum.instruments_disagree());
        let wavelengths_m = results.psd.wavelengths_m();
        let decades = (wavelengths_m[0] / wavelengths_m[wavelengths_m.len() - 1]).log10();
        let enough = wavelengths_m.len() >= LEAST_SCALES && decades >= LEAST_DECADES;
        let can_settle = enough && instruments_disagree.is_none();
        let of_curve = |(curve, result): (&Curve, &CurveResult)| {
            let of_load = |(block, load): (usize, &Load)| {
                let answer = LoadAnswer::of(curve, result, block, load.nominal_pressure_pa(), can_settle)?;
                Some(answer.of_spectrum_with(scene.surface.holes()))
            };
            needs.loads.iter().enumerate().map(of_load).collect()
        };
        let curves: Vec<Vec<Option<LoadAnswer>>> =
            needs.curves.iter().zip(&results.curves).map(of_curve).collect();
        let disagreements =
            (0..needs.loads.len()).filter_map(|load| Disagreement::at(load, &curves, results)).collect();
        let too_few_scales = (!enough).then_some(wavelengths_m.len());
        Answer { curves, disagreements, too_few_scales, instruments_disagree }
    }
}

impl LoadAnswer {
    fn of(
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

    /// Where the area has settled within a tolerance \[m\], one of the two above; `None` where the spectrum cannot tell.
    #[must_use]
    pub fn settled_at_m(&self, within: Convergence) -> Option<f64> {
        within.if_converged_m().filter(|_| self.settled)
    }

    /// The same answer for a spectrum with these holes, in which decades were not measured.
    fn of_spectrum_with(mut self, holes: &[Hole]) -> Self {
        for decade in &mut self.decades {
            *decade = decade.of_spectrum_with(holes);
        }
        self
    }

    /// The decade of wavelengths that decides most.
    pub fn decisive_decade(&self) -> Option<&DecadeShare> {
        self.decades.iter().reduce(|most, other| if other.share > most.share { other } else { most })
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
