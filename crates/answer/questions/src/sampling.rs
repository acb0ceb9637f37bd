//! Scales of the spectrum that take part.

use std::num::NonZeroU32;

use serde::{Deserialize, Serialize};
use study::plan::Sampling;
use study::surface::Surface;

use crate::QuestionError;

/// Scales of the spectrum that take part.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SamplingInput {
    /// Scales per decade to which the spectrum is resampled; as measured if absent.
    pub scales_per_decade: Option<NonZeroU32>,
    /// The shortest wavelength that takes part \[m\].
    pub cutoff_m: Option<f64>,
}

impl SamplingInput {
    /// The sampling as a plan takes it.
    #[must_use]
    pub fn sampling(self) -> Sampling {
        Sampling { scales_per_decade: self.scales_per_decade, cutoff_m: self.cutoff_m }
    }

    /// Refuses a cutoff below all data.
    ///
    /// # Errors
    /// [`QuestionError::CutoffBelowData`].
    pub fn check(self, surface: &Surface) -> Result<(), QuestionError> {
        let shortest_m = surface.psd.shortest_wavelength_m();
        match self.cutoff_m {
            Some(cutoff_m) if cutoff_m < shortest_m => {
                Err(QuestionError::CutoffBelowData { cutoff_m, shortest_m, surface: surface.name.clone() })
            }
            _ => Ok(()),
        }
    }
}
