//! A curve over cutoffs, by any model.

use findings::doubts::{self, RealPressures};
use numerics::parallel::Progress;
use persson::Band;
use persson::separation::LightLoads;
use scene::Scene;
use serde::{Deserialize, Serialize};
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::Population;
use study::figure::Figure;
use study::material::Material;
use study::models::{ModelEntry, ModelOptions};
use study::plan::{
    Curve, CurveResult, Cutoffs, Load, LoadRange, Needs, NominalPressure, Part, PerssonSurface, Plan,
    PlanError, Sampling, Stream, Tolerance,
};
use study::surface::Surface;
use tables::{Cells, Table};
use units::{PressureRange, Remark, RemarkCode};

use crate::choices;
use crate::loads::{LoadInput, resolved};
use crate::note::{remark_on_model, remark_on_sampling, remarks_on_correction, remarks_on_separation};
use crate::option::{first_given, not_of_model};
use crate::{Answer, CurveCounts, MaterialInput, QuestionError, SamplingInput};

/// The contact over the cutoffs of a spectrum, under loads and at separations.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CurveQuestion {
    /// The model.
    pub model: Option<&'static ModelEntry>,
    /// The name of the curve in notes and figures; the model's if absent.
    pub name: Option<String>,
    /// Choices that the model leaves open.
    pub options: ModelOptions,
    /// The bodies in contact.
    pub material: MaterialInput,
    /// Nominal pressures.
    pub pressures: Vec<LoadInput>,
    /// Nominal pressures as ranges, behind the others.
    pub pressure_ranges: Vec<PressureRange>,
    /// Separations \[m\] from the mean of the asperity heights, for statistical models.
    pub separations_m: Vec<f64>,
    /// Scales that take part.
    pub sampling: SamplingInput,
    /// Normalisation of moments, for statistical models.
    pub normalisation: Option<Normalisation>,
    /// Amplitude of a scale, for all models but statistical ones.
    pub amplitude: Option<AmplitudeDefinition>,
    /// Relative tolerance of statistical states, in (0, 0.01\].
    pub tolerance: Option<Tolerance>,
    /// Cutoffs at which the contact is wanted.
    pub cutoffs: Cutoffs,
    /// True appends columns on how each row was found.
    pub details: bool,
    /// True draws the area against the cutoff as well.
    pub figure: bool,
}

impl CurveQuestion {
    /// Beyond this many lines a figure is unreadable.
    pub const MOST_LINES: usize = 24;

    /// Finds options that the model ignores, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.resolve().map(drop)
    }

    /// The curve, its loads and all else that a plan needs.
    ///
    /// # Errors
    /// Returns the errors of [`check`](Self::check).
    pub fn needs(&self) -> Result<Needs, QuestionError> {
        self.resolve().map(|resolved| resolved.needs)
    }

    /// Prepares the curve of a surface.
    ///
    /// # Errors
    /// Returns the errors of [`check`](Self::check), and an error for a cutoff that leaves nothing out.
    pub fn on<'s>(&self, surface: &'s Surface) -> Result<PreparedCurve<'s>, QuestionError> {
        let Resolved { material, entry, tolerance, needs } = self.resolve()?;
        self.sampling.check(surface)?;
        let mut notes = Vec::new();
        notes.extend(tolerance.remark());
        notes.extend(remark_on_model(&material, entry, &surface.psd));
        notes.extend(doubts::of_bodies(&material));
        notes.extend(surface.notes.iter().cloned());
        Ok(PreparedCurve {
            plan: Plan { psd: &surface.psd, sampling: self.sampling.sampling(), needs },
            hardness_pa: material.hardness_pa(),
            details: self.details,
            figure: self.figure,
            notes,
        })
    }

    /// Answers at once; a long table is better had in parts ([`CurveStream::parts`]).
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        self.on(surface)?.answer(progress)
    }

    fn resolve(&self) -> Result<Resolved, QuestionError> {
        let entry = self.model.ok_or(QuestionError::missing("model"))?;
        let framework = entry.framework;
        choices::check(&self.options, entry, self.material.strength_cap.is_some())?;
        let of_other_frameworks = [
            ("normalisation", self.normalisation.is_some() && !framework.takes_normalisation()),
            ("tolerance", self.tolerance.is_some() && !framework.has_states()),
            ("separation", !self.separations_m.is_empty() && !framework.has_states()),
        ];
        first_given(of_other_frameworks, not_of_model(entry.name))?;
        let material = self.material.material()?;
        let tolerance = self.tolerance.unwrap_or_default();
        let model = entry.build(&material, &self.options)?;
        let needs_amplitudes = model.needs_amplitudes();
        let reason =
            not_of_model(entry.name).with("models", "scales of a stack and hardnesses that grow by nix-gao");
        // Python gives the default.
        let is_chosen = self.amplitude.is_some_and(|definition| definition != AmplitudeDefinition::default());
        first_given([("amplitude", is_chosen && !needs_amplitudes)], reason)?;
        let (loads, load_ranges) = resolved(&self.pressures, &self.pressure_ranges, &material)?;
        if loads.is_empty() && load_ranges.is_empty() && self.separations_m.is_empty() {
            return Err(QuestionError::Missing(match framework.has_states() {
                true => vec!["pressure", "separation"],
                false => vec!["pressure"],
            }));
        }
        let mut needs = Needs {
            moments: framework.normalisation(self.normalisation),
            amplitudes: needs_amplitudes.then(|| self.amplitude.unwrap_or_default()),
            curves: vec![Curve {
                name: self.name.clone().unwrap_or_else(|| entry.curve_name(&self.options)),
                model,
                cutoffs: self.cutoffs,
            }],
            loads,
            load_ranges,
            separations_m: self.separations_m.clone(),
            tolerance,
            ..Needs::default()
        };
        if self.figure {
            let lines = needs.load_count() + needs.separations_m.len();
            if lines > Self::MOST_LINES {
                let (drawn, most) = ("line for each pressure and separation", Self::MOST_LINES);
                return Err(QuestionError::TooManyLines { drawn, lines, most });
            }
            // Lines have labels.
            let of_ranges = std::mem::take(&mut needs.load_ranges);
            let pressures = of_ranges.into_iter().flat_map(LoadRange::pressures);
            needs.loads.extend(
                pressures.map(|nominal_pressure| Load { nominal_pressure, label: nominal_pressure.label() }),
            );
        }
        Ok(Resolved { material, entry, tolerance, needs })
    }
}

/// A question with everything looked up.
struct Resolved {
    material: Material,
    entry: &'static ModelEntry,
    tolerance: Tolerance,
    needs: Needs,
}

/// Refuses loads that the hardness of Persson's theory cannot carry; if it carries the largest, it carries all.
fn check_loads(surface: &PerssonSurface, needs: &Needs) -> Result<(), QuestionError> {
    let PerssonSurface { model, roughness, separation, .. } = surface;
    let at = |pressure: NominalPressure| model.at_last(roughness, separation, pressure.pa());
    let largest = needs.pressures().max_by(|a, b| a.pa().total_cmp(&b.pa()));
    if largest.is_some_and(|largest| at(largest).is_err()) {
        for pressure in needs.pressures() {
            at(pressure)?;
        }
    }
    Ok(())
}

/// A curve of a surface, ready to be computed.
pub struct PreparedCurve<'s> {
    plan: Plan<'s>,
    hardness_pa: Option<f64>,
    details: bool,
    figure: bool,
    /// Notes from before the spectrum was sampled.
    notes: Vec<Remark>,
}

impl<'s> PreparedCurve<'s> {
    /// A curve of a scene, by index.
    #[must_use]
    pub fn of_scene(scene: &'s Scene, curve: usize) -> Self {
        let material = scene.material.as_ref();
        let curve = scene.needs.curves[curve].clone();
        let tolerance = scene.needs.tolerance;
        let has_states = curve.model.takes_separations();
        let mut notes: Vec<Remark> = tolerance.remark().filter(|_| has_states).into_iter().collect();
        let of_model = |material| remark_on_model(material, curve.model.entry, &scene.surface.psd);
        notes.extend(material.and_then(of_model));
        notes.extend(material.into_iter().flat_map(doubts::of_bodies));
        notes.extend(scene.surface.notes.iter().cloned());
        let needs =
            Needs { curves: vec![curve], sweeps: Vec::new(), fit_band_m: None, ..scene.needs.clone() };
        PreparedCurve {
            plan: Plan { psd: &scene.surface.psd, sampling: scene.sampling, needs },
            hardness_pa: scene.hardness_pa(),
            details: false,
            figure: false,
            notes,
        }
    }

    /// Scales that take part.
    #[must_use]
    pub fn sampling(&self) -> Sampling {
        self.plan.sampling
    }

    /// Nominal pressures \[Pa\] of the blocks of rows; absent for blocks of separations.
    #[must_use]
    pub fn pressures_pa(&self) -> Vec<Option<f64>> {
        let needs = &self.plan.needs;
        let of_separations = needs.separations_m.iter().map(|_| None);
        needs.pressures().map(|pressure| Some(pressure.pa())).chain(of_separations).collect()
    }

    /// Notes on rows that somebody else has computed, and on what they were made from.
    #[must_use]
    pub fn notes_on(&self, rows: &CurveResult) -> Vec<Remark> {
        let pressures_pa: Vec<f64> = self.plan.needs.pressures().map(NominalPressure::pa).collect();
        let mut remarks = self.remarks();
        remarks.add(rows, &pressures_pa);
        [self.notes.clone(), self.doubts(), remarks.notes()].concat()
    }

    /// Doubts about the spectrum and the loads.
    fn doubts(&self) -> Vec<Remark> {
        let Plan { psd, needs, .. } = &self.plan;
        let labels = needs.loads.iter().map(|load| Some(load.label.as_str())).chain(std::iter::repeat(None));
        let of_pressures = doubts::of_pressures(needs.pressures().zip(labels), self.hardness_pa);
        doubts::of_spectrum(psd).into_iter().chain(of_pressures).collect()
    }

    fn remarks(&self) -> Remarks<'_> {
        Remarks {
            curve: self.curve(),
            counts: CurveCounts::default(),
            pressures: RealPressures::new(self.hardness_pa)
                .with_remedy(self.curve().model.entry.yielding().map(|model| ("model", model))),
        }
    }

    /// Samples the spectrum and finds everything that can be wrong before there are rows.
    ///
    /// # Errors
    /// [`QuestionError::Plan`].
    pub fn stream(&self) -> Result<CurveStream<'_>, QuestionError> {
        let stream = self.plan.stream()?;
        let surface = self.plan.persson_surface(&self.curve().model, &stream.prepared)?;
        if let Some(surface) = &surface {
            check_loads(surface, &self.plan.needs)?;
        }
        Ok(CurveStream { prepared: self, stream, surface })
    }

    /// Answers at once.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let stream = self.stream()?;
        let mut notes = stream.notes();
        let found = stream.whole(progress)?;
        notes.extend(found.notes);
        Ok(Answer { notes, ..found })
    }

    /// Appends number of contacts and plasticity index to the details of populations; those of every curvature have neither.
    fn with_contacts(&self, table: Table) -> Table {
        let model = self.curve().model.statistical();
        let Some(model) = model.filter(|_| self.details) else { return table };
        let [radii, densities, sigmas, separations] =
            ["radius_m", "density_per_m2", "sigma_s_m", "separation_m"].map(|name| {
                match table.column(name) {
                    Some(Cells::Numbers(cells)) => cells.clone(),
                    _ => Vec::new(),
                }
            });
        let populations: Vec<_> = (0..separations.len())
            .map(|row| {
                model.law?;
                Population::new(radii[row]?, densities[row]?, sigmas[row]?).ok()
            })
            .collect();
        let contacts = populations.iter().zip(separations);
        let contacts = contacts
            .map(|(of, separation_m)| Some(of.as_ref()?.contacts_per_m2(separation_m?, model.heights)));
        let table = table.with_numbers("contacts_per_m2", contacts);
        let modulus_pa = model.pair.composite_modulus_pa();
        let index =
            |of: &Option<Population>| Some(of.as_ref()?.plasticity_index(modulus_pa, self.hardness_pa?));
        table.with_numbers("plasticity_index", populations.iter().map(index))
    }

    fn curve(&self) -> &Curve {
        &self.plan.needs.curves[0]
    }

    fn normalisation(&self) -> Normalisation {
        self.plan.needs.moments.unwrap_or_default()
    }
}

/// A curve that is computed part by part, so that neither its rows nor its loads need be held.
pub struct CurveStream<'p> {
    prepared: &'p PreparedCurve<'p>,
    stream: Stream<'p>,
    /// The surface, if the model is Persson's theory.
    surface: Option<PerssonSurface>,
}

impl CurveStream<'_> {
    /// Number of steps that the progress will count.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.stream.rows(self.prepared.curve())
    }

    /// The law of light loads, if the model is Persson's theory and the cutoff leaves roughness.
    #[must_use]
    pub fn light_loads(&self) -> Option<LightLoads> {
        self.surface.as_ref()?.separation.light_loads()
    }

    /// Notes known before any row is computed.
    #[must_use]
    pub fn notes(&self) -> Vec<Remark> {
        let PreparedCurve { plan, notes, .. } = self.prepared;
        let mut notes = notes.clone();
        let model = &self.prepared.curve().model;
        if model.stacked().is_some() {
            notes.push(remark_on_sampling(self.stream.psd()));
        } else if model.statistical().is_some() {
            notes.push(Remark::new(RemarkCode::FirstRowIsEmpty));
        }
        if let Some(PerssonSurface { roughness, separation, .. }) = &self.surface {
            if model.persson().is_some_and(|theory| theory.band == Band::Surface) {
                notes.extend(doubts::of_surface(self.stream.psd()));
            }
            let correction = model.persson().and_then(|theory| theory.correction);
            let of_correction = correction.map(|correction| remarks_on_correction(correction, roughness));
            notes.extend(of_correction.into_iter().flatten());
            let least_pa = plan.needs.pressures().map(NominalPressure::pa).fold(f64::INFINITY, f64::min);
            let moments = self.stream.prepared.moments.last();
            let parseval = Normalisation::Parseval.factor() / self.prepared.normalisation().factor();
            let rms_height_m = moments.map_or(0.0, |(moments, _)| parseval.sqrt() * moments.rms_height_m());
            let light = separation.light_loads();
            notes.extend(
                light
                    .iter()
                    .flat_map(|light| remarks_on_separation(light, roughness, rms_height_m, least_pa)),
            );
        }
        notes.extend(self.prepared.doubts());
        notes
    }

    /// Computes the table part by part; returns what is known of all of it.
    ///
    /// # Errors
    /// Returns the errors of `each`, and [`PlanError`].
    pub fn parts<E: From<PlanError>>(
        &self,
        progress: &dyn Progress,
        mut each: impl FnMut(Table) -> Result<(), E>,
    ) -> Result<Vec<Remark>, E> {
        let mut remarks = self.prepared.remarks();
        let several = self.prepared.plan.needs.load_count() > 1;
        let details = self.prepared.details;
        self.stream.parts(self.prepared.curve(), progress, |part: Part| {
            remarks.add(&part.rows, &part.pressures_pa);
            each(self.prepared.with_contacts(part.rows.table(&part.pressures_pa, several, details)))
        })?;
        Ok(remarks.notes())
    }

    /// Computes the table at once, and the figure if there is one. Its notes are those that [`parts`](Self::parts) returns.
    ///
    /// # Errors
    /// [`QuestionError::Plan`].
    pub fn whole(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let plan = &self.prepared.plan;
        let results = plan.compute_observed(progress)?;
        let needs = &plan.needs;
        let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
        let rows = &results.curves[0];
        let mut remarks = self.prepared.remarks();
        remarks.add(rows, &pressures_pa);
        let several = needs.load_count() > 1;
        let table = self.prepared.with_contacts(rows.table(&pressures_pa, several, self.prepared.details));
        let figure = self.prepared.figure.then(|| {
            let of = Figure::area_of_all(vec![0]);
            of.data(&results, needs, self.prepared.hardness_pa)
        });
        Ok(Answer { table, notes: remarks.notes(), figure })
    }
}

/// Remarks on rows, gathered part by part.
struct Remarks<'c> {
    curve: &'c Curve,
    counts: CurveCounts,
    pressures: RealPressures,
}

impl Remarks<'_> {
    fn add(&mut self, rows: &CurveResult, pressures_pa: &[f64]) {
        self.counts.add(rows);
        self.pressures.add_part(self.curve, rows, pressures_pa);
    }

    fn notes(self) -> Vec<Remark> {
        [self.counts.remarks(), self.pressures.doubts()].concat()
    }
}
