//! Choice of the spectrum that a cutoff applies to.
//!
//! Cutting off the spectrum of profiles is not cutting off the surface: C1D at q holds every wave of the surface with
//! |q'| > q.

use serde::{Deserialize, Serialize};
use units::named;

/// Spectrum that a cutoff applies to.
///
/// The surface is the default of areas, gaps and stiffnesses, because it is nearer to boundary elements: on twenty
/// spectra under five loads areas by the waves of profiles are 0.58 to 0.96 of theirs (rms 32 %), those by the waves of the
/// surface 0.66 to 0.97 (24 %), and stiffnesses 0.52 to 1.29 and 0.79 to 1.11 (`docs/develop/trials.md`). With Nayak's alpha areas are
/// 10 and 3.2 % off (`docs/develop/trials.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Band {
    /// Spectrum of profiles: h'^2 = 2 m2 up to the cutoff.
    #[serde(rename = "1d")]
    Profile,
    /// Spectrum of the surface: its waves up to the cutoff.
    #[default]
    #[serde(rename = "2d")]
    Surface,
}

named!(Band, "band", { Profile => "1d", Surface => "2d" });
