//! Mean gap and stiffness under loads, and laws made from them.

use elements::{PressedLoad, Pressing, Surfaces};
use findings::doubts::{self, PressedBodies};
use interface::conductance::MOST_PLASTIC_SHARE;
use interface::finite_elements::{Column, ContactLaw, ExponentialLaw, LawPoint, UnitSystem};
use numerics::parallel::Progress;
use persson::Band;
use persson::separation::LIGHT_CONTACT;
use serde::{Deserialize, Serialize};
use spectrum::Normalisation;
use study::gap_law::{GapChoices, GapLaw, GapState};
use study::material::Material;
use study::models::{Choice, Framework, ModelEntry, ModelOptions};
use study::plan::{Needs, Plan, PlanError, Tolerance};
use study::result_tables;
use study::surface::Surface;
use units::display::{pressure, three_digits};
use units::{Pressure, PressureRange, Remark, RemarkCode, RemarkLevel, Spelling};

use crate::choices;
use crate::elements::{ELEMENTS, RandomInput, random_surfaces, remarks_on_pressed};
use crate::loads::{LoadInput, nominal_pressure, pressures_pa};
use crate::note::{FEW_TOUCH, remark_on_model, remarks_on_separation};
use crate::option::{first_given, not_of_model};
use crate::{Answer, MaterialInput, QuestionError, SamplingInput};

/// The light-load law holds within this share of the pressure.
const LIGHT_LOADS_SHARE: f64 = 0.01;

/// Ranges of boundary elements that yield over the elastic theory, on 72 spectra (`docs/develop/trials.md`, After yielding); slopes are
/// those between two loads.
const OFF_BY_FLOW: &str = "Boundary elements that flow have 0.9 to 1.2 times the elastic slope -dp/du where less than 30 % flows, 0.7 to 1 times \
                           at 90 to 97 % and 0.55 to 0.9 times above, and 1.17 to 0.34 times the elastic mean gap; their mean planes \
                           are closer still. The models persson-plastic and bem have both.";

/// Closed form of peaks that flow over boundary elements that do, on 24 spectra (`docs/develop/trials.md`, After yielding).
const YIELDS: &str = "The overclosure is that of the mean planes on loading, whose distance is within 0.06 rms heights below and 0.20 above that \
                      of boundary elements that flow in nine of ten trials. On unloading the contact is stiffer.";

/// A model of gaps, its material and its spectrum: what gaps and laws have in common.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GapModel {
    /// The model; boundary elements if absent.
    pub model: Option<&'static ModelEntry>,
    /// Choices that the model leaves open.
    pub options: ModelOptions,
    /// The bodies in contact.
    pub material: MaterialInput,
    /// Scales that take part.
    pub sampling: SamplingInput,
    /// Normalisation of moments, for statistical models.
    pub normalisation: Option<Normalisation>,
    /// Relative tolerance of statistical states, in (0, 0.01\], for statistical models.
    pub tolerance: Option<Tolerance>,
}

/// Mean gap and stiffness of a surface under loads, with its whole spectrum.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GapQuestion {
    /// Model, material and spectrum.
    pub by: GapModel,
    /// Nominal pressures.
    pub pressures: Vec<LoadInput>,
    /// Nominal pressures as ranges, behind the others.
    pub pressure_ranges: Vec<PressureRange>,
    /// Random surfaces, for boundary elements.
    pub random: RandomInput,
}

/// A law of pressure against overclosure between two pressures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LawQuestion {
    /// Model, material and spectrum.
    pub by: GapModel,
    /// The least nominal pressure.
    pub from: Pressure,
    /// The largest nominal pressure.
    pub to: Pressure,
}

impl Default for LawQuestion {
    fn default() -> Self {
        let by = GapModel::default();
        LawQuestion { by, from: Pressure::Pascals(1e3), to: Pressure::Pascals(1e8) }
    }
}

/// The form in which a law is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LawForm {
    /// Rows of pressure and overclosure.
    Table,
    /// The exponential law of light loads, which Persson's theory has.
    Exponential,
}

units::named!(LawForm, "form of the law", { Table => "table", Exponential => "exponential" });

/// A law of gaps of a surface.
#[derive(Debug)]
pub struct FoundLaw {
    /// The model.
    pub model: &'static ModelEntry,
    /// The law under any load.
    pub law: GapLaw,
    /// The least and the largest nominal pressure \[Pa\].
    pub range_pa: [f64; 2],
    /// Notes for the reader of the law.
    pub notes: Vec<Remark>,
    /// Shares of the contact that flow at both ends of the range, where an elastic model leaves out that more than [`MOST_PLASTIC_SHARE`] does.
    pub(crate) flows: Option<[f64; 2]>,
}

impl FoundLaw {
    /// Describes the model and every caution in lines, for the comments of a file.
    #[must_use]
    pub fn description(&self, spelling: &dyn Spelling) -> Vec<String> {
        let model = format!("{}: {}", self.model.full_name, self.model.citation);
        let flows = self.flows.map(|[from, to]| {
            let [from_pa, to_pa] = self.range_pa.map(pressure);
            let [from, to] = [from, to].map(|share| three_digits(100.0 * share));
            format!(
                "Caution: this model is elastic, and the contact flows: by Persson's theory, which overstates it, {from} % of the contact at \
                 {from_pa} and {to} % at {to_pa}. {OFF_BY_FLOW}"
            )
        });
        let yields = self.law.yields().then(|| YIELDS.to_owned());
        std::iter::once(model).chain(yields).chain(cautions(&self.notes, spelling)).chain(flows).collect()
    }

    /// The law of light loads in the form that finite element codes take, and a remark if it is off by more than a share of the
    /// pressure in the range.
    ///
    /// # Errors
    /// [`QuestionError::NoExponentialLaw`] if the model is not Persson's theory.
    pub fn exponential(&self, share: f64) -> Result<(ExponentialLaw, Option<Remark>), QuestionError> {
        ContactLaw::TOLERANCES
            .check("error of the law", share)
            .map_err(|error| QuestionError::Value { option: "error", error })?;
        let law = self.law.exponential(share).ok_or(QuestionError::NoExponentialLaw(self.model))?;
        let remark = Remark::new(RemarkCode::BeyondExponentialLaw)
            .with("share", share)
            .with("up_to_pa", law.holds_up_to_pa)
            .with("to_pa", self.range_pa[1]);
        Ok((law, (law.holds_up_to_pa < self.range_pa[1]).then_some(remark)))
    }

    /// Columns that plain tables have besides where peaks flow: mean gap, and stiffness on unloading.
    #[must_use]
    pub fn columns(&self, law: &ContactLaw, units: UnitSystem) -> Vec<Column> {
        if !self.law.yields() {
            return Vec::new();
        }
        let (pa, m) = (units.pressure_symbol(), units.length_symbol());
        let column = |name: String, value: fn(GapState) -> Option<f64>, unit: f64| {
            let at = |point: &LawPoint| Some(value(self.law.at(point.pressure_pa).ok()?)? * unit);
            Column { name, values: law.points.iter().map(at).collect() }
        };
        let stiffness = units.pressure(1.0) / units.length(1.0);
        vec![
            column(format!("mean_gap_{m}"), |state| state.mean_gap_m, units.length(1.0)),
            column(format!("unloading_stiffness_{pa}_per_{m}"), |state| state.stiffness_pa_per_m, stiffness),
        ]
    }

    /// Samples the law between its pressures, straight within a relative `tolerance` of the pressure. `progress` advances once
    /// per state that is computed; how many are needed shows only in the end.
    ///
    /// # Errors
    /// [`QuestionError::Sampling`] for pressures between which the gap does not close, and if `progress` is cancelled.
    pub fn sampled(&self, tolerance: f64, progress: &dyn Progress) -> Result<ContactLaw, QuestionError> {
        Ok(self.law.sampled(self.range_pa, tolerance, progress)?)
    }
}

impl GapModel {
    /// Refuses options that the model ignores.
    pub(crate) fn check(&self) -> Result<(), QuestionError> {
        let options = &self.options;
        let Some(entry) = self.model else {
            let given = [
                ("normalisation", self.normalisation.is_some()),
                ("tolerance", self.tolerance.is_some()),
                ("strain_gradient_length", self.material.strain_gradient_length_m.is_some()),
                ("strength_cap", self.material.strength_cap.is_some()),
                ("scales_per_decade", self.sampling.scales_per_decade.is_some()),
                ("cutoff", self.sampling.cutoff_m.is_some()),
            ];
            let of_models = options.given().map(|choice| (choice.key(), true));
            let reason = Remark::new(RemarkCode::ElasticElements).with("model", "bem");
            return Ok(first_given(of_models.chain(given), reason)?);
        };
        let framework = entry.framework;
        let of_other_frameworks = [
            ("normalisation", self.normalisation.is_some() && !framework.takes_normalisation()),
            ("tolerance", self.tolerance.is_some() && !framework.has_states()),
            // Exponential heights have no mean plane of a surface.
            ("summit_heights", options.summit_heights.is_some()),
        ];
        let of_asperities = [Choice::Hardness, Choice::Interference, Choice::StrainGradient];
        let missing = options.given().filter(|choice| of_asperities.contains(choice) && !entry.has(*choice));
        let missing = missing.map(|choice| (choice.key(), true));
        first_given(of_other_frameworks.into_iter().chain(missing), not_of_model(entry.name))?;
        Ok(choices::check(options, entry, self.material.strength_cap.is_some())?)
    }

    /// The law with the whole spectrum.
    pub(crate) fn law(
        &self,
        entry: &'static ModelEntry,
        material: &Material,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<GapLaw, QuestionError> {
        self.sampling.check(surface)?;
        let model = entry.build(material, &self.options)?;
        let moments = entry.framework.normalisation(self.normalisation);
        let needs = Needs {
            moments: Some(moments.unwrap_or_default()),
            amplitudes: model.needs_amplitudes().then(Default::default),
            ..Needs::default()
        };
        let plan = Plan { psd: &surface.psd, sampling: self.sampling.sampling(), needs };
        let results = plan.compute_observed(progress)?;
        let choices = GapChoices {
            energy_factor: self.options.gamma.unwrap_or_default(),
            band: self.options.band.unwrap_or_default(),
            tolerance: self.tolerance.unwrap_or_default(),
        };
        Ok(GapLaw::of(&model, &plan, &results, &choices)?)
    }

    /// Doubts about pressures \[Pa\] with their shares in contact, by a law or by elements that do not yield; `remedy` is a model that
    /// yields.
    pub(crate) fn doubts(
        &self,
        material: &Material,
        areas: impl Iterator<Item = (f64, f64)>,
        remedy: Option<&'static str>,
    ) -> Vec<Remark> {
        let grows = self.options.strain_gradient || self.options.hardness_law.is_some();
        let bodies = PressedBodies {
            name: self.model.map_or(ELEMENTS, |entry| entry.full_name),
            modulus_pa: material.pair.composite_modulus_pa(),
            hardness_pa: material.hardness_pa().filter(|_| !grows),
            is_elastic: !self.model.is_some_and(|entry| entry.has(Choice::Strength)),
        };
        doubts::of_contact(&bodies, remedy.map(|model| ("model", model)), &areas.collect::<Vec<_>>())
    }

    /// Notes known before anything is computed.
    pub(crate) fn notes(&self, material: &Material, surface: &Surface) -> Vec<Remark> {
        let too_fine = self.tolerance.and_then(Tolerance::remark);
        let doubt = doubts::of_bodies(material);
        let surface_notes = surface.notes.iter().cloned();
        let of_model = self.model.and_then(|entry| remark_on_model(material, entry, &surface.psd));
        let of_spectrum = doubts::of_spectrum(&surface.psd).into_iter();
        let cuts_surface = self.options.band.unwrap_or_default() == Band::Surface
            && self.model.is_some_and(|entry| entry.framework == Framework::Persson);
        let of_surface = cuts_surface.then(|| doubts::of_surface(&surface.psd)).into_iter().flatten();
        let notes = too_fine.into_iter().chain(doubt).chain(surface_notes).chain(of_model);
        notes.chain(of_spectrum).chain(of_surface).collect()
    }
}

impl GapQuestion {
    /// Finds options that the model ignores, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.by.check()?;
        if let Some(entry) = self.by.model {
            first_given(self.random.given(), not_of_model(entry.name).with("models", "bem"))?;
        }
        self.loads().map(drop)
    }

    /// Number of steps that the progress will count: those of boundary elements, and none for models.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn steps(&self, surface: &Surface) -> Result<usize, QuestionError> {
        if self.by.model.is_some() {
            return Ok(0);
        }
        let (material, pressures_pa) = self.loads()?;
        let pressing = yielding(&material, pressures_pa);
        let (random, _) = random_surfaces(surface, &self.random, &pressing)?;
        Ok(elements::progress_steps(&Surfaces::Random(random), &pressing))
    }

    /// Computes the gaps.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        self.check()?;
        let (material, pressures_pa) = self.loads()?;
        let mut notes = self.by.notes(&material, surface);
        let Some(entry) = self.by.model else {
            let pressing = yielding(&material, pressures_pa);
            let (states, found) = self.by_elements(&pressing, surface, progress)?;
            notes.extend(found);
            return Ok(Answer { table: result_tables::gaps(&states, None), notes, figure: None });
        };
        let law = self.by.law(entry, &material, surface, progress)?;
        let states = numerics::parallel::try_map(&pressures_pa, |&pressure_pa| {
            if progress.is_cancelled() {
                return Err(QuestionError::Plan(PlanError::Cancelled));
            }
            Ok(law.at(pressure_pa)?)
        })?;
        notes.extend(remarks_on_gap_law(&law, &pressures_pa));
        let areas = states.iter().map(|state| (state.nominal_pressure_pa, state.area_fraction));
        notes.extend(self.by.doubts(&material, areas, Some("bem")));
        let is_elastic_theory = law.light_loads().is_some() && !law.yields();
        let rms_height_m = (!is_elastic_theory).then_some(law.rms_height_m);
        notes.extend(remarks_on_gaps(&states, rms_height_m));
        let table = result_tables::gaps(&states, law.light_loads().filter(|_| !law.yields()).as_ref());
        Ok(Answer { table, notes, figure: None })
    }

    fn loads(&self) -> Result<(Material, Vec<f64>), QuestionError> {
        let material = self.by.material.material()?;
        let pressures_pa = pressures_pa(&self.pressures, &self.pressure_ranges, &material)?;
        Ok((material, pressures_pa))
    }

    /// Presses random surfaces, which do not yield, under the loads of this question.
    pub(crate) fn states_of_elements(
        &self,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<(Vec<GapState>, Vec<Remark>), QuestionError> {
        let (material, pressures_pa) = self.loads()?;
        let pressing = Pressing { saturation_pa: None, ..yielding(&material, pressures_pa) };
        self.by_elements(&pressing, surface, progress)
    }

    /// The mean of random surfaces under boundary elements.
    fn by_elements(
        &self,
        pressing: &Pressing,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<(Vec<GapState>, Vec<Remark>), QuestionError> {
        let (random, mut notes) = random_surfaces(surface, &self.random, pressing)?;
        let rms_height_m = random.band.mean_square_height_m2().sqrt();
        let surfaces = Surfaces::Random(random);
        let pressed = elements::press::<QuestionError>(&surfaces, pressing, |_| Ok(()), progress)?;
        let states = states_of_elements(&pressed, pressing.saturation_pa);
        notes.extend(remarks_on_pressed(&pressed));
        notes.extend(remarks_on_gaps(&states, Some(rms_height_m)));
        Ok((states, notes))
    }
}

/// Loads on a material that yields at its hardness, if it has one.
pub(crate) fn yielding(material: &Material, pressures_pa: Vec<f64>) -> Pressing {
    let loads = pressures_pa.into_iter().map(elements::ImposedLoad::PressurePa).collect();
    let saturation_pa = material.hardness_pa();
    Pressing { loads, stiffness: true, saturation_pa, ..Pressing::between(&material.pair) }
}

impl LawQuestion {
    /// Finds options that the model ignores, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.by.check()?;
        self.range_pa(&self.by.material.material()?).map(drop)
    }

    /// Finds the law.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<FoundLaw, QuestionError> {
        self.by.check()?;
        let entry = self.by.model.ok_or(QuestionError::missing("model"))?;
        let material = self.by.material.material()?;
        let range_pa = self.range_pa(&material)?;
        let mut notes = self.by.notes(&material, surface);
        let law = self.by.law(entry, &material, surface, progress)?;
        notes.extend(remarks_on_gap_law(&law, &range_pa));
        let area = |&end_pa: &f64| Some((end_pa, law.at(end_pa).ok()?.area_fraction));
        notes.extend(self.by.doubts(&material, range_pa.iter().filter_map(area), None));
        let flows = if entry.has(Choice::Strength) { None } else { self.flows(&material, surface, progress) };
        Ok(FoundLaw {
            model: entry,
            law,
            range_pa,
            notes,
            flows: flows.filter(|[from, to]| from.max(*to) > MOST_PLASTIC_SHARE),
        })
    }

    /// Shares of the contact that flow at both ends of the range by Persson's theory; `None` without a hardness, and on a layer.
    fn flows(&self, material: &Material, surface: &Surface, progress: &dyn Progress) -> Option<[f64; 2]> {
        material.hardness_pa()?;
        let flowing =
            |entry: &&ModelEntry| entry.framework == Framework::Persson && entry.has(Choice::Strength);
        let theory = study::models::with_gaps().find(flowing)?;
        let options = ModelOptions::default();
        let by = GapModel { options, normalisation: None, tolerance: None, ..self.by.clone() };
        let law = by.law(theory, material, surface, progress).ok()?;
        let [from_pa, to_pa] = self.range_pa(material).ok()?;
        Some([law.flowed_share(from_pa)?, law.flowed_share(to_pa)?])
    }

    pub(crate) fn range_pa(&self, material: &Material) -> Result<[f64; 2], QuestionError> {
        let [from, to] =
            [self.from, self.to].map(|end| nominal_pressure("pressure_range", None, end, material));
        Ok([from?.pa(), to?.pa()])
    }
}

/// Words the cautions among notes in lines, for the comments of a file.
pub(crate) fn cautions(notes: &[Remark], spelling: &dyn Spelling) -> Vec<String> {
    let cautions = notes.iter().filter(|note| note.level == RemarkLevel::Caution);
    cautions.map(|note| format!("Caution: {}.", note.words(spelling))).collect()
}

/// Makes remarks on loads for which gap and stiffness of a law mean little, and for which the law of light loads holds; `pressures_pa`
/// are the loads.
#[must_use]
pub fn remarks_on_gap_law(law: &GapLaw, pressures_pa: &[f64]) -> Vec<Remark> {
    let least_pa = pressures_pa.iter().copied().fold(f64::INFINITY, f64::min);
    let (Some(light), Some(roughness)) = (law.light_loads(), law.roughness()) else {
        // Asperities push each other down from light loads on, which their laws leave out.
        let most_pa = pressures_pa.iter().copied().fold(0.0, f64::max);
        let is_light = law.at(most_pa).is_ok_and(|state| state.area_fraction <= LIGHT_CONTACT);
        let remark = || Remark::new(RemarkCode::BeyondLightLoads).with("area", LIGHT_CONTACT);
        return (!is_light).then(remark).into_iter().collect();
    };
    let mut remarks = remarks_on_separation(&light, roughness, law.rms_height_m, least_pa);
    // Peaks that flow are nearer: their own gaps tell how few touch.
    remarks.retain(|remark| !law.yields() || remark.code != RemarkCode::FewTouchBelow);
    if law.band() == Some(Band::Profile) {
        remarks.push(Remark::new(RemarkCode::WavesOfProfiles).on("band"));
    }
    let light_loads = |up_to_pa: f64| {
        Remark::new(RemarkCode::LightLoads).with("up_to_pa", up_to_pa).with("share", LIGHT_LOADS_SHARE)
    };
    remarks.extend(law.light_load_limit_pa(LIGHT_LOADS_SHARE).map(light_loads));
    remarks
}

/// Remarks on gaps that mean little, or are missing. `rms_height_m`, that of the surface, is for loads under which few asperities
/// touch; `None` if [`remarks_on_gap_law`] reports them.
pub(crate) fn remarks_on_gaps(states: &[GapState], rms_height_m: Option<f64>) -> Vec<Remark> {
    let few_touch_m = rms_height_m.map_or(f64::INFINITY, |rms_height_m| FEW_TOUCH * rms_height_m);
    let at = |code, is_found: &dyn Fn(Option<f64>) -> bool| {
        let loads = states.iter().filter(|state| is_found(state.mean_gap_m)).count();
        let remark = Remark::new(code).with("loads", loads).with("all", states.len());
        (loads > 0).then(|| remark.with("few_touch", FEW_TOUCH))
    };
    let remarks = [
        at(RemarkCode::FewTouch, &|gap_m| gap_m.is_some_and(|gap_m| gap_m > few_touch_m)),
        at(RemarkCode::NegativeGaps, &|gap_m| gap_m.is_some_and(|gap_m| gap_m < 0.0)),
        at(RemarkCode::MissingGaps, &|gap_m| gap_m.is_none()),
    ];
    remarks.into_iter().flatten().collect()
}

/// States of boundary elements in the form of models: the mean of all surfaces under each load, which flow at a hardness \[Pa\], if any.
pub(crate) fn states_of_elements(loads: &[PressedLoad], hardness_pa: Option<f64>) -> Vec<GapState> {
    let state = |load: &PressedLoad| {
        let mean = load.mean();
        GapState {
            nominal_pressure_pa: load.nominal_pressure_pa,
            area_fraction: load.area_fraction(hardness_pa),
            mean_gap_m: Some(mean.mean_gap_m),
            mean_plane_distance_m: Some(mean.mean_gap_m - mean.mean_plastic_depth_m),
            stiffness_pa_per_m: mean.stiffness_pa_per_m,
        }
    };
    loads.iter().map(state).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_counted_by_what_they_leave_open() {
        let state = |mean_gap_m| GapState {
            nominal_pressure_pa: 1e6,
            area_fraction: 0.1,
            mean_gap_m,
            mean_plane_distance_m: mean_gap_m,
            stiffness_pa_per_m: None,
        };
        let states = [state(Some(4e-8)), state(Some(1e-8)), state(Some(-1e-9)), state(None)];
        let counted = |rms_height_m| -> Vec<(RemarkCode, Option<f64>)> {
            let remarks = remarks_on_gaps(&states, rms_height_m);
            remarks.iter().map(|remark| (remark.code, remark.number("loads"))).collect()
        };
        let [few, negative, missing] =
            [RemarkCode::FewTouch, RemarkCode::NegativeGaps, RemarkCode::MissingGaps]
                .map(|code| (code, Some(1.0)));
        assert_eq!(counted(Some(1e-8)), [few, negative, missing]);
        assert_eq!(counted(None), [negative, missing]);
    }
}
