//! A surface of a scene by its roughness parameters.

use serde_spanned::Spanned;
use spectrum::{RoughnessParameters, SelfAffineProfile};

use super::error::{SceneError, SceneProblem};
use super::raw::{RawSurface, given};
use study::given_roughness::{ASSUMED_HURST, GivenRoughness, RollOffFrom};
use study::surface::Surface;

/// The keys of a surface's roughness parameters, and whether each is given.
pub(super) fn keys(surface: &RawSurface) -> [(&'static str, bool); 5] {
    [
        ("rms_height", surface.rms_height.is_some()),
        ("rms_slope", surface.rms_slope.is_some()),
        ("mean_width", surface.mean_width.is_some()),
        ("rolloff_wavelength", surface.rolloff_wavelength.is_some()),
        ("hurst", surface.hurst.is_some()),
    ]
}

/// Makes the surface with these parameters.
///
/// `rms_height` is Rq and `rms_slope` Rdq, both of a profile. One of `mean_width`, RSm, and `rolloff_wavelength` gives
/// the width of its widest features. RSm cannot replace the slope: the standard ignores narrow elements, which are the
/// steep ones.
pub(super) fn resolve_roughness(key: &str, raw: &Spanned<RawSurface>) -> Result<Surface, SceneError> {
    let surface = raw.get_ref();
    let refused = |message: String| SceneError::at(raw.span(), message);
    let (rolloff_m, rolloff_from) = match (given(&surface.mean_width), given(&surface.rolloff_wavelength)) {
        (Some(width), None) => (width.m, RollOffFrom::MeanWidth),
        (None, Some(rolloff)) => (rolloff.m, RollOffFrom::Given),
        (Some(_), Some(_)) => {
            return Err(refused(format!(
                "[{key}] has both mean_width and rolloff_wavelength, and the former is taken for the latter; keep one of them"
            )));
        }
        (None, None) => {
            return Err(refused(format!(
                "[{key}] needs mean_width (RSm) or rolloff_wavelength beside rms_height and rms_slope: height and slope do not \
                 tell how wide features are"
            )));
        }
    };
    let missing = |name: &str| SceneError::at(raw.span(), SceneProblem::MissingKey { key: name.to_owned() });
    let parameters = RoughnessParameters {
        rms_height_m: given(&surface.rms_height).ok_or_else(|| missing("rms_height"))?.m,
        rms_slope: *surface.rms_slope.as_ref().ok_or_else(|| missing("rms_slope"))?.get_ref(),
        rolloff_m,
        hurst_exponent: surface.hurst.as_ref().map_or(ASSUMED_HURST, |hurst| *hurst.get_ref()),
    };
    let profile = SelfAffineProfile::new(parameters).map_err(|error| refused(format!("[{key}]: {error}")))?;
    let hurst_is_assumed = surface.hurst.is_none();
    Surface::of_roughness(GivenRoughness { profile, rolloff_from, hurst_is_assumed })
        .map_err(|error| SceneError::at(raw.span(), error))
}
