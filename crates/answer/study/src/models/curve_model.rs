//! A model of a material.

use ::persson::corrections::Correction;
use ::persson::variance::Band;
use asperity::{Hardness, MaterialPair, NixGao};
use stacked_contact::StackedModel;
use stat_contact::{AsperityLaw, InterferenceLaw};

use super::persson::PerssonLaw;
use super::{ModelEntry, ModelOptions, MomentUse, Statistical, Theory};

/// A model of a material: an entry of the table of models with its theory.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveModel {
    entry: &'static ModelEntry,
    theory: Theory,
}

impl CurveModel {
    pub(super) fn new(entry: &'static ModelEntry, theory: Theory) -> Self {
        CurveModel { entry, theory }
    }

    /// Returns the entry of the model in the table of models.
    #[must_use]
    pub fn entry(&self) -> &'static ModelEntry {
        self.entry
    }

    /// Returns the theory with its law.
    #[must_use]
    pub fn theory(&self) -> &Theory {
        &self.theory
    }

    /// Returns the stack, or nothing for another theory.
    #[must_use]
    pub fn stacked(&self) -> Option<&StackedModel> {
        match &self.theory {
            Theory::Stacked(model) => Some(model),
            _ => None,
        }
    }

    /// Returns the statistical theory, or nothing for another one.
    #[must_use]
    pub fn statistical(&self) -> Option<&Statistical> {
        match &self.theory {
            Theory::Statistical(model) => Some(model),
            _ => None,
        }
    }

    /// Returns the law of Persson's theory, or nothing for another theory.
    #[must_use]
    pub fn persson(&self) -> Option<&PerssonLaw> {
        match &self.theory {
            Theory::Persson(model) => Some(&model.law),
            _ => None,
        }
    }

    /// Returns the options in which the model differs from the defaults of its entry.
    #[must_use]
    pub fn options(&self) -> ModelOptions {
        let law = self.theory.law();
        ModelOptions { strain_gradient: law.has_strain_gradient(), ..law.options() }
    }

    /// Returns the strength of the body that yields, or nothing for an elastic model.
    #[must_use]
    pub fn strength(&self) -> Option<NixGao> {
        self.theory.law().strength()
    }

    /// Returns true if it stands on the amplitudes of scales.
    #[must_use]
    pub fn needs_amplitudes(&self) -> bool {
        self.theory.law().needs_amplitudes()
    }

    /// Returns true if it stands on spectral moments.
    #[must_use]
    pub fn needs_moments(&self) -> bool {
        self.entry.framework.facts().moments != MomentUse::None
    }

    /// Returns true if separations are conditions of the model besides loads.
    #[must_use]
    pub fn takes_separations(&self) -> bool {
        self.entry.framework.facts().has_states
    }

    /// Returns true if its strength or its hardness grows at small scales.
    #[must_use]
    pub fn strength_grows(&self) -> bool {
        self.theory.law().strength_grows()
    }

    /// Returns the hardness \[Pa\] at which the model flows at long wavelengths, or nothing for an elastic one. The laws of
    /// asperities flow at three times their strength, Persson's theory at the hardness of the material.
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        self.theory.law().hardness_pa()
    }

    /// Returns the bodies in contact.
    #[must_use]
    pub fn pair(&self) -> MaterialPair {
        self.theory.law().pair()
    }

    /// Returns the same model of other bodies in contact, with its strength and its options.
    #[must_use]
    pub fn with_pair(&self, pair: MaterialPair) -> Self {
        self.with_theory(self.theory.law().with_pair(pair))
    }

    /// Returns the same model with another strength, or nothing for one that never yields.
    #[must_use]
    pub fn with_strength(&self, strength: NixGao) -> Option<Self> {
        self.theory.law().with_strength(strength).map(|theory| self.with_theory(theory))
    }

    /// Returns the same model with another correction of Persson's elastic theory, or nothing for one that has none.
    #[must_use]
    pub fn with_correction(&self, correction: Option<Correction>) -> Option<Self> {
        self.with_persson(|law| law.with_correction(correction))
    }

    /// Returns the same model with a cutoff of another spectrum, or nothing for a theory other than Persson's.
    #[must_use]
    pub fn with_band(&self, band: Band) -> Option<Self> {
        self.with_persson(|law| Some(PerssonLaw { band, ..law.clone() }))
    }

    /// Returns the same model with the hardness of its spheres in another form, or nothing for one that has none.
    #[must_use]
    pub fn with_hardness(&self, hardness: Hardness) -> Option<Self> {
        self.with_asperities(|law| law.with_hardness(hardness))
    }

    /// Returns the same model with another interference law, or nothing for one that has none.
    #[must_use]
    pub fn with_interference(&self, interference: InterferenceLaw) -> Option<Self> {
        self.with_asperities(|law| law.with_interference(interference))
    }

    /// Returns the form of the hardness of its spheres, or nothing for a model that has none.
    #[must_use]
    pub fn hardness(&self) -> Option<Hardness> {
        Hardness::ALL.into_iter().find(|hardness| self.with_hardness(*hardness).as_ref() == Some(self))
    }

    /// Returns the interference law, or nothing for a model that has none.
    #[must_use]
    pub fn interference(&self) -> Option<InterferenceLaw> {
        InterferenceLaw::ALL.iter().copied().find(|law| self.with_interference(*law).as_ref() == Some(self))
    }

    fn with_theory(&self, theory: Theory) -> Self {
        CurveModel { entry: self.entry, theory }
    }

    fn with_persson(&self, change: impl FnOnce(&PerssonLaw) -> Option<PerssonLaw>) -> Option<Self> {
        let Theory::Persson(model) = &self.theory else { return None };
        Some(self.with_theory(model.with_law(change(&model.law)?)))
    }

    fn with_asperities(&self, change: impl FnOnce(AsperityLaw) -> Option<AsperityLaw>) -> Option<Self> {
        self.statistical()?.with_law(change).map(|theory| self.with_theory(theory))
    }
}
