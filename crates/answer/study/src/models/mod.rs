//! The three theories of contact and their models.
//!
//! Each theory has a module with its models, their bodies and options, the rows of its curves, and their columns. This module
//! has the enums over the theories, `entry` the table of models that the command line, scenes, tables of populations and
//! sensitivities go by.

mod entry;
pub mod persson;
mod stacked;
pub(crate) mod statistical;

use std::ops::Range;
use std::sync::LazyLock;

use ::persson::Band;
use ::persson::Cut;
use ::persson::corrections::Correction;
use asperity::{Hardness, MaterialPair, NixGao};
use serde::Serialize;
use spectrum::Normalisation;
use stacked_contact::{Level, StackedModel};
use stat_contact::{AsperityLaw, Condition, InterferenceLaw};
use tables::Table;

pub use self::entry::{ModelEntry, named, of_framework, with_gaps};
pub use self::persson::{Persson, PerssonCuts, PerssonSurface};
use self::statistical::PressedAsperities;
pub use self::statistical::{CutoffState, Pressable, STATE_DETAILS, Statistical};
use crate::hardness_and_strength::HARDNESS_OVER_STRENGTH;
pub use crate::model_options::{Choice, ModelOptions};
use crate::plan::error::PlanError;
use crate::plan::gap::{GapChoices, GapError, GapState};
use crate::plan::prepared_spectrum::{Cutoffs, PreparedSpectrum};
use crate::plan::run::Run;
use crate::plan::work::Work;

/// The theory by which a model gets from the roughness to the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Framework {
    /// Scale upon scale.
    Stacked,
    /// A population of asperities.
    Statistical,
    /// The pressure spreads as roughness is taken in, without asperities.
    Persson,
}

units::named!(Framework, "theory", {
    Stacked => "stacked",
    Statistical => "statistical",
    Persson => "persson",
});

impl Framework {
    /// Returns the words for one of its models, e.g. `stacked model`.
    #[must_use]
    pub fn noun(self) -> &'static str {
        match self {
            Framework::Stacked => "stacked model",
            Framework::Statistical => "statistical model",
            Framework::Persson => "model of Persson's theory",
        }
    }

    /// Returns the normalisation of the moments that its models take, where `chosen` is that of the user, or nothing for
    /// models without moments.
    #[must_use]
    pub fn normalisation(self, chosen: Option<Normalisation>) -> Option<Normalisation> {
        match self {
            Framework::Stacked => None,
            Framework::Statistical => Some(chosen.unwrap_or_default()),
            Framework::Persson => Some(Normalisation::Parseval),
        }
    }

    /// Returns true if the user chooses the normalisation of the moments.
    #[must_use]
    pub fn takes_normalisation(self) -> bool {
        self == Framework::Statistical
    }

    /// Returns true if every row is a state that is solved for: within a tolerance, and at a separation as well as under a
    /// load.
    #[must_use]
    pub fn has_states(self) -> bool {
        self == Framework::Statistical
    }

    /// Returns true if its models know a distance between the surfaces.
    #[must_use]
    pub fn has_gaps(self) -> bool {
        self != Framework::Stacked
    }

    /// Returns true if a model that yields takes the hardness of the material rather than its strength.
    #[must_use]
    pub fn takes_hardness(self) -> bool {
        self == Framework::Persson
    }
}

/// Every model, in the order of the documentation.
pub static MODELS: LazyLock<Vec<ModelEntry>> =
    LazyLock::new(|| [stacked::MODELS, statistical::MODELS, persson::MODELS].concat());

/// A theory with its law and the bodies in contact.
#[derive(Debug, Clone, PartialEq)]
pub enum Theory {
    /// Scale upon scale.
    Stacked(StackedModel),
    /// Asperities of Gaussian heights.
    Statistical(Statistical),
    /// Persson's theory, without asperities.
    Persson(Persson),
}

/// A model of a material: an entry of the table of models with its theory.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveModel {
    /// The entry of the model in the table of models.
    pub entry: &'static ModelEntry,
    /// The theory with its law.
    pub theory: Theory,
}

/// A curve to be computed: the cutoffs of its model on a prepared spectrum.
pub(crate) struct Job<'j> {
    pub prepared: &'j PreparedSpectrum,
    pub cutoffs: Cutoffs,
    pub run: Run<'j>,
    /// Builds the roughness of a band for Persson's theory.
    pub roughness: &'j (dyn Fn(Band) -> ::persson::Roughness + Sync),
}

impl CurveModel {
    /// Returns the stack, or nothing for another theory.
    #[must_use]
    pub fn stacked(&self) -> Option<&StackedModel> {
        if let Theory::Stacked(model) = &self.theory { Some(model) } else { None }
    }

    /// Returns the statistical theory, or nothing for another one.
    #[must_use]
    pub fn statistical(&self) -> Option<&Statistical> {
        if let Theory::Statistical(model) = &self.theory { Some(model) } else { None }
    }

    /// Returns Persson's theory, or nothing for another one.
    #[must_use]
    pub fn persson(&self) -> Option<&Persson> {
        if let Theory::Persson(model) = &self.theory { Some(model) } else { None }
    }

    /// Returns the bodies in contact.
    #[must_use]
    pub fn pair(&self) -> MaterialPair {
        match &self.theory {
            Theory::Stacked(model) => *model.pair(),
            Theory::Statistical(model) => model.pair,
            Theory::Persson(model) => model.pair,
        }
    }

    /// Returns the same model of other bodies in contact, with its strength and its options.
    #[must_use]
    pub fn with_pair(&self, pair: MaterialPair) -> Self {
        self.with_theory(match &self.theory {
            Theory::Stacked(model) => stacked::with_pair(model, pair),
            Theory::Statistical(model) => Theory::Statistical(Statistical { pair, ..*model }),
            Theory::Persson(model) => Theory::Persson(Persson { pair, ..model.clone() }),
        })
    }

    /// Returns the strength of the body that yields, or nothing for an elastic model.
    #[must_use]
    pub fn strength(&self) -> Option<NixGao> {
        match &self.theory {
            Theory::Stacked(model) => model.strength(),
            Theory::Statistical(model) => model.law?.strength(),
            Theory::Persson(model) => Some(model.plastic.as_ref()?.strength),
        }
    }

    /// Returns the same model with another strength, or nothing for one that never yields.
    #[must_use]
    pub fn with_strength(&self, strength: NixGao) -> Option<Self> {
        Some(self.with_theory(match &self.theory {
            Theory::Stacked(model) => Theory::Stacked(model.with_strength(strength)?),
            Theory::Statistical(model) => model.with_law(|law| law.with_strength(strength))?,
            Theory::Persson(model) => model.with_strength(strength)?,
        }))
    }

    /// Returns the hardness \[Pa\] at which the model flows at long wavelengths, or nothing for an elastic one. The laws of
    /// asperities flow at three times their strength, Persson's theory at the hardness of the material.
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        match &self.theory {
            Theory::Persson(model) => Some(model.plastic.as_ref()?.hardness_pa),
            _ => Some(HARDNESS_OVER_STRENGTH * self.strength()?.macroscopic_strength_pa()),
        }
    }

    /// Returns true if its strength or its hardness grows at small scales.
    #[must_use]
    pub fn strength_grows(&self) -> bool {
        self.has_strain_gradient() || self.persson().is_some_and(|model| model.growth().is_some())
    }

    fn has_strain_gradient(&self) -> bool {
        self.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some())
    }

    /// Returns the options in which the model differs from the defaults of its entry.
    #[must_use]
    pub fn options(&self) -> ModelOptions {
        let own = match &self.theory {
            Theory::Stacked(model) => stacked::options(model),
            Theory::Statistical(model) => model.options(),
            Theory::Persson(model) => model.options(),
        };
        ModelOptions { strain_gradient: self.has_strain_gradient(), ..own }
    }

    /// Returns true if it stands on the amplitudes of scales.
    #[must_use]
    pub fn needs_amplitudes(&self) -> bool {
        match &self.theory {
            Theory::Stacked(_) => true,
            Theory::Statistical(_) => false,
            Theory::Persson(_) => self.has_strain_gradient(),
        }
    }

    /// Returns true if it stands on spectral moments.
    #[must_use]
    pub fn needs_moments(&self) -> bool {
        self.entry.framework.normalisation(None).is_some()
    }

    /// Returns true if separations are conditions of the model besides loads.
    #[must_use]
    pub fn takes_separations(&self) -> bool {
        self.entry.framework.has_states()
    }

    /// Returns the same model with another correction of Persson's elastic theory, or nothing for one that has none.
    #[must_use]
    pub fn with_correction(&self, correction: Option<Correction>) -> Option<Self> {
        let model = self.persson().filter(|model| model.plastic.is_none())?;
        Some(self.with_theory(Theory::Persson(Persson { correction, ..model.clone() })))
    }

    /// Returns the same model with a cutoff of another spectrum, or nothing for a theory other than Persson's.
    #[must_use]
    pub fn with_band(&self, band: Band) -> Option<Self> {
        Some(self.with_theory(Theory::Persson(Persson { band, ..self.persson()?.clone() })))
    }

    /// Returns the same model with the hardness of its spheres in another form, or nothing for one that has none.
    #[must_use]
    pub fn with_hardness(&self, hardness: Hardness) -> Option<Self> {
        Some(self.with_theory(self.statistical()?.with_law(|law| law.with_hardness(hardness))?))
    }

    /// Returns the same model with another interference law, or nothing for one that has none.
    #[must_use]
    pub fn with_interference(&self, interference: InterferenceLaw) -> Option<Self> {
        Some(self.with_theory(self.statistical()?.with_law(|law| law.with_interference(interference))?))
    }

    /// Returns the form of the hardness of its spheres, or nothing for a model that has none.
    #[must_use]
    pub fn hardness(&self) -> Option<Hardness> {
        match self.statistical()?.law? {
            AsperityLaw::EpSphere { hardness, .. } => Some(hardness),
            _ => None,
        }
    }

    /// Returns the interference law, or nothing for a model that has none.
    #[must_use]
    pub fn interference(&self) -> Option<InterferenceLaw> {
        match self.statistical()?.law? {
            AsperityLaw::ElasticSine { interference } => Some(interference),
            _ => None,
        }
    }

    fn with_theory(&self, theory: Theory) -> Self {
        CurveModel { entry: self.entry, theory }
    }

    /// Returns the most rows of a block.
    pub(crate) fn rows_per_block(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> usize {
        match &self.theory {
            Theory::Stacked(_) => prepared.scales.len(),
            Theory::Statistical(_) => prepared.cutoff_count(cutoffs),
            Theory::Persson(_) => prepared.psd.len(),
        }
    }

    /// Checks that every cutoff can be computed.
    ///
    /// # Errors
    /// [`PlanError`] for a spectrum that the theory cannot take.
    pub(crate) fn check(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> Result<(), PlanError> {
        self.statistical().map_or(Ok(()), |model| model.check(prepared, cutoffs))
    }

    /// Computes a block of rows for every condition, and counts the work. `places` are the needed rows of a block, which
    /// statistical models alone compute piece by piece.
    ///
    /// # Errors
    /// [`PlanError`] for values out of the theory's bounds, and if the work was cancelled.
    pub(crate) fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        places: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let pressures_pa =
            || -> Vec<f64> { conditions.iter().filter_map(|condition| condition.pressure_pa()).collect() };
        match &self.theory {
            Theory::Stacked(model) => stacked::blocks(model, job, &pressures_pa()),
            Theory::Statistical(model) => model.blocks(job, conditions, places),
            Theory::Persson(model) => model.blocks(job, &pressures_pa()),
        }
    }

    /// Returns the surface with its whole spectrum, or nothing for a theory without distances.
    ///
    /// # Errors
    /// [`GapError`] for a spectrum that has no gap.
    pub(crate) fn surface(
        &self,
        prepared: &PreparedSpectrum,
        roughness: impl FnOnce() -> ::persson::Roughness,
        choices: &GapChoices,
    ) -> Result<Option<LoadedSurface>, GapError> {
        Ok(match &self.theory {
            Theory::Stacked(_) => None,
            Theory::Statistical(model) => {
                Some(LoadedSurface::Asperities(model.surface(prepared, choices.tolerance.value())?))
            }
            Theory::Persson(model) => {
                Some(LoadedSurface::Persson(Box::new(model.surface(roughness(), choices.energy_factor)?)))
            }
        })
    }
}

/// A surface with its whole spectrum, as a model presses it.
#[derive(Debug)]
pub(crate) enum LoadedSurface {
    Asperities(PressedAsperities),
    Persson(Box<PerssonSurface>),
}

impl LoadedSurface {
    /// Returns the surface under a nominal pressure > 0 \[Pa\].
    ///
    /// # Errors
    /// [`GapError`] for a pressure that cannot be carried.
    pub fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        match self {
            LoadedSurface::Asperities(surface) => surface.at(pressure_pa),
            LoadedSurface::Persson(surface) => surface.at(pressure_pa),
        }
    }

    /// Returns the surface of Persson's theory, or nothing for another one.
    pub fn persson(&self) -> Option<&PerssonSurface> {
        if let LoadedSurface::Persson(surface) = self { Some(surface) } else { None }
    }
}

/// A curve against cutoff: for every load its rows, from long to short wavelengths.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveResult {
    /// Levels of the stack; only the last one if only the shortest cutoff is needed.
    Stacked(Vec<Vec<Level>>),
    /// States of the population that each cutoff leaves; the separations follow the loads.
    Statistical(Vec<Vec<CutoffState>>),
    /// Cuts of Persson's theory.
    Persson(PerssonCuts),
}

impl CurveResult {
    /// Returns the levels of a stack, or nothing for another theory.
    #[must_use]
    pub fn stacked(&self) -> Option<&[Vec<Level>]> {
        if let CurveResult::Stacked(blocks) = self { Some(blocks) } else { None }
    }

    /// Returns the states of a statistical curve, or nothing for another theory.
    #[must_use]
    pub fn statistical(&self) -> Option<&[Vec<CutoffState>]> {
        if let CurveResult::Statistical(blocks) = self { Some(blocks) } else { None }
    }

    /// Returns the cuts of Persson's theory, or nothing for another theory.
    #[must_use]
    pub fn persson(&self) -> Option<&[Vec<Cut>]> {
        if let CurveResult::Persson(cuts) = self { Some(&cuts.blocks) } else { None }
    }

    /// Returns the number of blocks: one per load, and per separation.
    #[must_use]
    pub fn blocks(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.len(),
            CurveResult::Statistical(blocks) => blocks.len(),
            CurveResult::Persson(cuts) => cuts.blocks.len(),
        }
    }

    /// Returns the wavelengths \[m\], area fractions and real pressures \[Pa\] of the rows of a block with contact.
    fn points(&self, block: usize) -> Vec<[f64; 3]> {
        match self {
            CurveResult::Stacked(blocks) => blocks[block].iter().map(stacked::point).collect(),
            CurveResult::Statistical(blocks) => blocks[block].iter().filter_map(CutoffState::point).collect(),
            CurveResult::Persson(cuts) => cuts.blocks[block].iter().map(persson::point).collect(),
        }
    }

    /// Returns a block as points of wavelength \[m\] and area fraction; cutoffs without asperities have none.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    #[must_use]
    pub fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        self.points(block).into_iter().map(|[wavelength_m, area, _]| (wavelength_m, area)).collect()
    }

    /// Returns the highest real pressure \[Pa\] in a block, or 0 for one without contact.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    #[must_use]
    pub fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        self.points(block).into_iter().map(|[_, _, pressure_pa]| pressure_pa).fold(0.0, f64::max)
    }

    /// Returns some blocks of a curve as a table, under these nominal pressures \[Pa\]. `several` is true if the whole
    /// curve has more loads than one; `details` appends how each row was found.
    #[must_use]
    pub fn table(&self, pressures_pa: &[f64], several: bool, details: bool) -> Table {
        match self {
            CurveResult::Stacked(blocks) => {
                stacked::table(with_loads(blocks, pressures_pa, several), blocks, details)
            }
            CurveResult::Statistical(blocks) => statistical::table(blocks, details),
            CurveResult::Persson(cuts) => cuts.table(with_loads(&cuts.blocks, pressures_pa, several)),
        }
    }

    /// Returns the numbers of levels of stacks and of statistical states.
    pub(crate) fn levels_and_states(&self) -> [usize; 2] {
        match self {
            CurveResult::Stacked(blocks) => [blocks.iter().map(Vec::len).sum(), 0],
            CurveResult::Statistical(blocks) => {
                [0, blocks.iter().flatten().filter(|row| row.contact.is_some()).count()]
            }
            CurveResult::Persson(_) => [0, 0],
        }
    }

    /// Returns for every condition the block at its index, or the last row of that block.
    pub(crate) fn repeated(self, index_of: &[usize], cutoffs: Cutoffs) -> Self {
        match self {
            CurveResult::Stacked(blocks) => CurveResult::Stacked(repeated(blocks, index_of, cutoffs)),
            CurveResult::Statistical(blocks) => CurveResult::Statistical(repeated(blocks, index_of, cutoffs)),
            CurveResult::Persson(PerssonCuts { blocks, band }) => {
                CurveResult::Persson(PerssonCuts { blocks: repeated(blocks, index_of, cutoffs), band })
            }
        }
    }
}

fn repeated<T: Clone>(blocks: Vec<Vec<T>>, index_of: &[usize], cutoffs: Cutoffs) -> Vec<Vec<T>> {
    let no_repetitions = index_of.len() == blocks.len() && index_of.iter().copied().eq(0..blocks.len());
    match cutoffs {
        Cutoffs::Every if no_repetitions => blocks,
        Cutoffs::Every => index_of.iter().map(|&index| blocks[index].clone()).collect(),
        Cutoffs::Shortest => {
            index_of.iter().map(|&index| blocks[index].last().cloned().into_iter().collect()).collect()
        }
    }
}

/// Returns a table with the nominal pressure of each row, if there are several.
fn with_loads<T>(blocks: &[Vec<T>], pressures_pa: &[f64], several: bool) -> Table {
    let of_block = |(rows, &pressure_pa): (&Vec<T>, &f64)| std::iter::repeat_n(pressure_pa, rows.len());
    let table = Table::default();
    if !several {
        return table;
    }
    table.with_numbers("nominal_pressure_pa", blocks.iter().zip(pressures_pa).flat_map(of_block))
}
