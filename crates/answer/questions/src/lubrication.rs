//! Pressure and area of asperities against the separation of two faces, as solvers of mixed lubrication take them.

mod card;
mod pressed;

use std::f64::consts::LN_10;

use asperity::Bound;
use findings::doubts::{self, PressedBodies};
use numerics::parallel::Progress;
use numerics::zero_in_bracket;
use scene::Scene;
use serde::{Deserialize, Serialize};
use spectrum::Normalisation;
use stat_contact::{GreenwoodTripp, PartialMoment, Population, SeparationPoint};
use study::gap_law::GapError;
use study::material::Material;
use study::models::{Choice, Framework, ModelEntry};
use study::plan::{LoadRange, Needs, NominalPressure, Plan, PlanError};
use study::surface::Surface;
use units::{OutOfBounds, Pressure, Remark, RemarkCode};

pub use self::card::FoundLubrication;
use self::card::{Card, of_law, of_summits};
use self::pressed::medium;
use crate::gap::remarks_on_gap_law;
use crate::loads::nominal_pressure;
use crate::option::{first_given, not_of_model};
use crate::{GapModel, LawTableQuestion, MaterialInput, QuestionError, RandomInput, SamplingInput};

/// Rows of closed forms.
const ROWS: u32 = 26;
/// Largest separation over the rms height: Gaussian heights beyond it underflow.
const LARGEST_SEPARATION: f64 = 30.0;
const OF_SCENE: &str =
    "a scene has its own bodies and scales; leave out the options of bodies, cutoff and scales per decade";

/// Ends of a table of asperity pressures.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LubricationRange {
    /// The least and the largest nominal pressure.
    Pressures([Pressure; 2]),
    /// The least and the largest nominal separation over the rms height.
    Separations([f64; 2]),
}

/// Summits of two alike faces in place of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SummitInput {
    /// Summits per area of each face \[m^-2\].
    pub density_per_m2: f64,
    /// Radius of the summits \[m\].
    pub radius_m: f64,
    /// Rms height of both faces together \[m\].
    pub rms_height_m: f64,
}

/// Pressure and area of asperities against separation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LubricationQuestion {
    /// Model, bodies and scales; no model is boundary elements.
    pub by: GapModel,
    /// Ends of the table.
    pub range: LubricationRange,
    /// Random surfaces, for boundary elements.
    pub random: RandomInput,
    /// True presses the measured map itself by boundary elements, in place of random surfaces of its spectrum.
    pub as_scanned: bool,
    /// Summits of Greenwood & Tripp in place of model and surface.
    pub summits: Option<SummitInput>,
}

/// A surface under a load.
#[derive(Debug, Clone, Copy)]
struct SurfaceRow {
    point: SeparationPoint,
    mean_gap_m: f64,
    /// Flow factors over the cube of the mean gap: along x, along y, and the range of those of single surfaces.
    flow: Option<[f64; 4]>,
}

impl LubricationQuestion {
    /// Name of the quantity among those of laws.
    pub const QUANTITY: &'static str = "asperity-pressure";

    /// Finds options without effect, among them those of `others`, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self, others: &LawTableQuestion) -> Result<(), QuestionError> {
        let reason = Remark::new(RemarkCode::OtherQuantity).with("quantity", Self::QUANTITY);
        first_given(others.options_of_tables(), reason)?;
        if let Some(correlation) = others.correlation {
            return Err(QuestionError::ConductanceOnly(correlation));
        }
        if let LubricationRange::Separations([from, to]) = self.range {
            let error = |error: OutOfBounds| QuestionError::Value { option: "separation_range", error };
            Bound::AtLeast(0.0).check("least separation over the rms height", from).map_err(error)?;
            let above = Bound::LeftOpen { above: from, at_most: LARGEST_SEPARATION };
            above.check("largest separation over the rms height", to).map_err(error)?;
        }
        let GapModel { options, sampling, normalisation, material, model, .. } = &self.by;
        let of_elements = self.random.given().into_iter().chain([("as_scanned", self.as_scanned)]);
        let unused = match (&self.summits, model) {
            (Some(_), _) => {
                let of_surfaces = [
                    ("scales_per_decade", sampling.scales_per_decade.is_some()),
                    ("cutoff", sampling.cutoff_m.is_some()),
                    ("normalisation", normalisation.is_some()),
                    ("strength_cap", material.strength_cap.is_some()),
                ];
                let given = options.given().map(|choice| (choice.key(), true)).chain(of_surfaces);
                let reason = Remark::new(RemarkCode::Replaced).with("other", "summit_density");
                return Ok(first_given(given.chain(of_elements), reason)?);
            }
            (None, Some(entry)) => first_given(of_elements, not_of_model(entry.name).with("models", "bem")),
            (None, None) if self.as_scanned => first_given(
                self.random.given(),
                Remark::new(RemarkCode::Replaced).with("other", "as_scanned"),
            ),
            (None, None) => Ok(()),
        };
        unused?;
        self.by.check()
    }

    /// Computes the table of a surface between the bodies of the question.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(
        &self,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<FoundLubrication, QuestionError> {
        self.of(&self.by.material.material()?, surface, progress)
    }

    /// Computes the table of the surface of a scene between the bodies of the scene.
    ///
    /// # Errors
    /// [`QuestionError`], also for bodies and scales of the question beside those of the scene.
    pub fn answer_scene(
        &self,
        scene: &Scene,
        progress: &dyn Progress,
    ) -> Result<FoundLubrication, QuestionError> {
        let GapModel { material, sampling, .. } = self.by;
        if material != MaterialInput::default() || sampling != SamplingInput::default() {
            return Err(QuestionError::Other(OF_SCENE.to_owned()));
        }
        let material = scene.material.as_ref().ok_or(QuestionError::ElasticConstant("youngs_modulus"))?;
        let mut question = self.clone();
        question.by.sampling.scales_per_decade = scene.sampling.scales_per_decade;
        question.by.sampling.cutoff_m = scene.sampling.cutoff_m;
        question.of(material, &scene.surface, progress)
    }

    /// Computes the table of the summits of the question, which is Greenwood & Tripp's own.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer_summits(&self) -> Result<FoundLubrication, QuestionError> {
        let SummitInput { density_per_m2, radius_m, rms_height_m } =
            self.summits.ok_or(QuestionError::missing("summit_density"))?;
        let material = self.by.material.of_half_spaces("Greenwood & Tripp's summits")?;
        let (modulus_pa, hardness_pa) = (material.pair.composite_modulus_pa(), material.hardness_pa());
        let summits = Population::new(radius_m, density_per_m2, rms_height_m).map_err(GapError::from)?;
        let law = GreenwoodTripp::new(modulus_pa, summits).map_err(GapError::from)?;
        let rows = self.rows(&material, rms_height_m, |pressure_pa| {
            let excess = |over_rms: f64| (law.pressure_pa(over_rms * rms_height_m) / pressure_pa).ln();
            let separation_m = zero_in_bracket(-1e6, LARGEST_SEPARATION, excess) * rms_height_m;
            let point =
                SeparationPoint { separation_m, pressure_pa, area_fraction: law.area_fraction(separation_m) };
            Some(SurfaceRow { point, mean_gap_m: overlapping_gap_m(separation_m, rms_height_m), flow: None })
        })?;
        let areas: Vec<_> = rows.iter().map(|row| (row.point.pressure_pa, row.point.area_fraction)).collect();
        let bodies = PressedBodies { name: "Greenwood & Tripp", modulus_pa, hardness_pa, is_elastic: true };
        let doubts = doubts::of_contact(&bodies, Some(("model", "bem")), &areas);
        let notes = doubts::of_bodies(&material).into_iter().chain(doubts).collect();
        let lines =
            vec![format!("Greenwood & Tripp's law of two alike faces: {}", of_law(&law)), CUT_OFF.into()];
        Card { rows, rms_height_m, modulus_pa, lines, notes }.found()
    }

    /// Rows of a closed form by its row under any pressure \[Pa\]; those that it has not are left out.
    fn rows(
        &self,
        material: &Material,
        rms_height_m: f64,
        row: impl Fn(f64) -> Option<SurfaceRow>,
    ) -> Result<Vec<SurfaceRow>, QuestionError> {
        let separation_m = |pressure_pa: f64| row(pressure_pa).map(|row| row.point.separation_m);
        let modulus_pa = material.pair.composite_modulus_pa();
        Ok(match self.range {
            LubricationRange::Pressures(ends) => {
                pressures_pa(ends, material, ROWS)?.filter_map(row).collect()
            }
            LubricationRange::Separations(ends) => evenly(ends, ROWS)
                .filter_map(|over_rms| {
                    pressure_at_pa(over_rms * rms_height_m, [rms_height_m, modulus_pa], separation_m)
                })
                .filter_map(&row)
                .collect(),
        })
    }

    fn of(
        &self,
        material: &Material,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<FoundLubrication, QuestionError> {
        let (mut card, band) = match self.by.model {
            Some(entry) => (self.closed_form(entry, material, surface, progress)?, None),
            None => self.pressed(material, surface, progress)?,
        };
        let moments = |face: &Surface| {
            let needs = Needs { moments: Some(Normalisation::Parseval), ..Needs::default() };
            let sampling = self.by.sampling.sampling();
            let results = Plan { psd: &face.psd, sampling, needs }.compute()?;
            Ok::<_, QuestionError>(results.moments.last().map(|(moments, _)| *moments))
        };
        let (sum, faces) = match (band, surface.parts.as_deref()) {
            (Some(band), _) => (Some(band), None),
            (None, Some([one, other])) => (moments(surface)?, moments(one)?.zip(moments(other)?)),
            (None, None) => (moments(surface)?, None),
        };
        card.lines.extend(of_summits(sum, faces, card.modulus_pa)?.into_iter().flatten());
        card.found()
    }

    /// Rows of a closed form.
    fn closed_form(
        &self,
        entry: &'static ModelEntry,
        material: &Material,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<Card, QuestionError> {
        let modulus_pa = material.pair.composite_modulus_pa();
        let law = self.by.law(entry, material, surface, progress)?;
        let rms_height_m = law.rms_height_m;
        let energy_factor = self.by.options.gamma.unwrap_or_default();
        let (is_persson, flows) = (entry.framework == Framework::Persson, entry.has(Choice::Strength));
        let elastic = law.roughness().filter(|_| !flows);
        let medium = elastic.map(|roughness| medium(roughness, modulus_pa, energy_factor));
        let row = |pressure_pa: f64| {
            let state = law.at(pressure_pa).ok()?;
            let separation_m = state.mean_plane_distance_m?;
            let point = SeparationPoint { separation_m, pressure_pa, area_fraction: state.area_fraction };
            // Asperities that are pressed one by one move no mean plane, and heights that overlap are cut off.
            let mean_gap_m =
                if is_persson { state.mean_gap_m? } else { overlapping_gap_m(separation_m, rms_height_m) };
            Some(SurfaceRow { point, mean_gap_m, flow: medium.as_ref().and_then(|medium| medium(&point)) })
        };
        let rows = self.rows(material, rms_height_m, row)?;
        if progress.is_cancelled() {
            return Err(QuestionError::Plan(PlanError::Cancelled));
        }
        let loads: Vec<f64> = rows.iter().map(|row| row.point.pressure_pa).collect();
        let mut notes = self.by.notes(material, surface);
        notes.extend(remarks_on_gap_law(&law, &loads));
        let areas = rows.iter().map(|row| (row.point.pressure_pa, row.point.area_fraction));
        notes.extend(self.by.doubts(material, areas, Some("bem")));
        let mean_gap = match (is_persson, flows) {
            (true, false) => "The mean gap is the separation: nothing flows.",
            (true, true) => "The separation is the mean gap less the mean depth that has flowed.",
            (false, _) => CUT_OFF,
        };
        let mut lines = vec![format!("{}: {}", entry.full_name, entry.citation), mean_gap.to_owned()];
        if rows.len() < ROWS as usize {
            lines.push("Rows at which the model has no gap are left out.".to_owned());
        }
        Ok(Card { rows, rms_height_m, modulus_pa, lines, notes })
    }
}

const CUT_OFF: &str =
    "The mean gap is that of Gaussian heights, cut off where they overlap: the model moves no mean plane.";

/// Values at equal distances between two ends, both included.
fn evenly([from, to]: [f64; 2], count: u32) -> impl Iterator<Item = f64> {
    let last = f64::from(count - 1);
    (0..count).map(move |at| (from * (last - f64::from(at)) + to * f64::from(at)) / last)
}

/// Nominal pressures \[Pa\] at equal ratios between two ends, both included.
fn pressures_pa(
    ends: [Pressure; 2],
    material: &Material,
    count: u32,
) -> Result<impl Iterator<Item = f64>, QuestionError> {
    let [from, to] = ends.map(|end| nominal_pressure("pressure_range", None, end, material));
    Ok(LoadRange::new(from?, to?, count).pressures().map(NominalPressure::pa))
}

/// Mean gap \[m\] of Gaussian heights at a separation of their mean planes \[m\], cut off where they overlap.
fn overlapping_gap_m(separation_m: f64, rms_height_m: f64) -> f64 {
    rms_height_m * PartialMoment::First.above(-separation_m / rms_height_m)
}

/// Finds the pressure \[Pa\] at which a separation that falls with it has a value \[m\]; `None` if it never has.
fn pressure_at_pa(
    wanted_m: f64,
    [scale_m, modulus_pa]: [f64; 2],
    separation_m: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    // Without a separation everything touches, or has flowed.
    let excess = |ln_pressure: f64| {
        separation_m(ln_pressure.exp()).map_or(-1.0, |found_m| (found_m - wanted_m) / scale_m)
    };
    let mut decades = (0..200).map(|at| modulus_pa.ln() - LN_10 * f64::from(at));
    let light = decades.find(|ln_pressure| excess(*ln_pressure) > 0.0)?;
    let ln_pressure = zero_in_bracket(light, light + LN_10, excess);
    (excess(ln_pressure).abs() < 1e-6).then(|| ln_pressure.exp())
}
