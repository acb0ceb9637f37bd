//! States of populations of asperities, row by row of arrays.

use crate::rows::{ContactStates, StatesFound, rows_of};
use findings::doubts;
use serde::{Deserialize, Serialize};
use study::material::Material;
use study::models::{ModelEntry, ModelOptions};
use study::plan::Tolerance;
use units::{Remark, RemarkCode};

use crate::{CurveCounts, QuestionError, choices};

/// States of a statistical model, for rows of any roughness, material and condition.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StatesQuestion {
    /// The model.
    pub model: Option<&'static ModelEntry>,
    /// Choices that the model leaves open.
    pub options: ModelOptions,
    /// Relative tolerance of pressure and area, in (0, 0.01\].
    pub tolerance: Option<Tolerance>,
    /// Leaves rows that cannot be computed without results, instead of ending with the first.
    pub skips_bad_rows: bool,
}

impl StatesQuestion {
    /// Finds options that the model ignores, and a tolerance out of its bounds.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.states().map(drop)
    }

    /// Prepares the states; their rows are computed by [`ContactStates::compute`].
    ///
    /// # Errors
    /// Returns the errors of [`check`](Self::check).
    pub fn states(&self) -> Result<ContactStates, QuestionError> {
        let entry = self.model.ok_or(QuestionError::missing("model"))?;
        choices::check(&self.options, entry, false)?;
        let (options, tolerance) = (self.options.clone(), self.tolerance.unwrap_or_default());
        Ok(ContactStates { entry, options, tolerance, skips_bad_rows: self.skips_bad_rows })
    }

    /// Notes on the states of so many rows of some materials.
    #[must_use]
    pub fn notes_on<'m>(
        &self,
        materials: impl Iterator<Item = &'m Material>,
        found: &StatesFound,
        all: usize,
    ) -> Vec<Remark> {
        let StatesFound { counts, narrow, bad, first_bad, .. } = *found;
        let doubt = materials.map(doubts::of_bodies).find(|notes| !notes.is_empty()).unwrap_or_default();
        let bad = rows_of(RemarkCode::BadRows, bad, all).map(|mut remark| {
            remark.place.row = first_bad;
            remark
        });
        let counts = CurveCounts { states: counts, narrow, ..CurveCounts::default() };
        doubt.into_iter().chain(bad).chain(found.of_strength(all)).chain(counts.remarks()).collect()
    }
}
