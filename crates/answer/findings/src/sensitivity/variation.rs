//! Variations of the modelling choices of a scene.

use std::num::NonZeroU32;

use asperity::{Hardness, NixGao};
use persson::Band;
use persson::corrections::Correction;
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::InterferenceLaw;
use units::display::pressure;

use scene::Scene;
use study::choices_in_words;
use study::plan::CurveModel;
use study::validity::MODULUS_OVER_IDEAL_STRENGTH;

/// Densities of the spectrum that are tried, in scales per decade.
const SCALES_PER_DECADE: [u32; 3] = [5, 10, 20];

/// A modelling choice with another setting than that of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Variation {
    Normalisation(Normalisation),
    Amplitude(AmplitudeDefinition),
    ScalesPerDecade(NonZeroU32),
    Hardness(Hardness),
    Interference(InterferenceLaw),
    StrengthCap(Option<f64>),
    Correction(Option<Correction>),
    Band(Band),
}

/// Every variation of the choices of a scene.
pub(super) fn variations(scene: &Scene) -> Vec<Variation> {
    let needs = &scene.needs;
    let mut variations = Vec::new();
    let other = |normalisation| needs.moments.is_some_and(|own| own != normalisation);
    variations.extend(
        Normalisation::ALL.iter().filter(|way| other(**way)).map(|way| Variation::Normalisation(*way)),
    );
    let other = |definition| needs.amplitudes.is_some_and(|own| own != definition);
    variations.extend(
        AmplitudeDefinition::ALL.iter().filter(|way| other(**way)).map(|way| Variation::Amplitude(*way)),
    );
    let densities = SCALES_PER_DECADE.into_iter().filter_map(NonZeroU32::new);
    variations.extend(
        densities
            .filter(|density| scene.sampling.scales_per_decade != Some(*density))
            .map(Variation::ScalesPerDecade),
    );
    variations.extend(Hardness::ALL.iter().copied().map(Variation::Hardness));
    variations.extend(InterferenceLaw::ALL.iter().copied().map(Variation::Interference));
    let usual_cap_pa = scene
        .material
        .map(|material| material.pair.yielding_body().youngs_modulus_pa() / MODULUS_OVER_IDEAL_STRENGTH);
    variations.extend([Variation::StrengthCap(None), Variation::StrengthCap(usual_cap_pa)]);
    let corrections = std::iter::once(None).chain(Correction::ALL.iter().copied().map(Some));
    variations.extend(corrections.map(Variation::Correction));
    variations.extend(Band::ALL.iter().copied().map(Variation::Band));
    variations
}

impl Variation {
    /// The choice, for tables and reports.
    pub fn choice(&self) -> &'static str {
        match self {
            Variation::Normalisation(_) => "normalisation of moments",
            Variation::Amplitude(_) => "amplitude of a scale",
            Variation::ScalesPerDecade(_) => "scales per decade",
            Variation::Hardness(_) => "hardness of spheres",
            Variation::Interference(_) => "interference law of sinusoids",
            Variation::StrengthCap(_) => "cap of the strength",
            Variation::Correction(_) => "correction of Persson's theory",
            Variation::Band(_) => "spectrum that a cutoff ends",
        }
    }

    /// The setting, for tables and reports.
    pub fn setting(&self) -> String {
        match self {
            Variation::Normalisation(normalisation) => normalisation.to_string(),
            Variation::Amplitude(definition) => definition.to_string(),
            Variation::ScalesPerDecade(density) => density.to_string(),
            Variation::Hardness(hardness) => hardness.name().to_owned(),
            Variation::Interference(interference) => interference.to_string(),
            Variation::StrengthCap(None) | Variation::Correction(None) => "none".to_owned(),
            Variation::Correction(Some(correction)) => correction.to_string(),
            Variation::Band(band) => band.to_string(),
            Variation::StrengthCap(Some(cap_pa)) => format!("E/10 = {}", pressure(*cap_pa)),
        }
    }

    /// The setting in the words of the field.
    pub fn in_words(&self) -> String {
        match self {
            Variation::Normalisation(choice) => choices_in_words::normalisation(*choice).to_owned(),
            Variation::Amplitude(choice) => choices_in_words::amplitude(*choice).to_owned(),
            Variation::Hardness(choice) => choices_in_words::hardness(*choice).to_owned(),
            Variation::Interference(choice) => choices_in_words::interference(*choice).to_owned(),
            Variation::Correction(Some(choice)) => choices_in_words::correction(*choice).to_owned(),
            Variation::Band(choice) => choices_in_words::band(*choice).to_owned(),
            Variation::ScalesPerDecade(_) | Variation::StrengthCap(_) | Variation::Correction(None) => {
                self.setting()
            }
        }
    }

    /// The model with this setting; `None` if that is its own, or if it has no such choice.
    pub fn of(&self, model: &CurveModel) -> Option<CurveModel> {
        let statistical = model.statistical().is_some();
        let varied = match *self {
            Variation::Normalisation(_) if statistical => return Some(model.clone()),
            Variation::Amplitude(_) if model.needs_amplitudes() => return Some(model.clone()),
            Variation::ScalesPerDecade(_) => return Some(model.clone()),
            Variation::Hardness(hardness) => model.with_hardness(hardness)?,
            Variation::Interference(interference) => model.with_interference(interference)?,
            Variation::StrengthCap(cap_pa) => with_cap(model, cap_pa)?,
            Variation::Correction(correction) => model.with_correction(correction)?,
            Variation::Band(band) => model.with_band(band)?,
            Variation::Normalisation(_) | Variation::Amplitude(_) => return None,
        };
        (varied != *model).then_some(varied)
    }

    /// True if the spectrum, its moments and its amplitudes stay as they are.
    pub fn is_of_a_law(&self) -> bool {
        match self {
            Variation::Hardness(_)
            | Variation::Interference(_)
            | Variation::StrengthCap(_)
            | Variation::Correction(_)
            | Variation::Band(_) => true,
            Variation::Normalisation(_) | Variation::Amplitude(_) | Variation::ScalesPerDecade(_) => false,
        }
    }
}

/// Returns the model with its strength capped, or not capped, or nothing for one whose strength does not grow.
fn with_cap(model: &CurveModel, cap_pa: Option<f64>) -> Option<CurveModel> {
    let strength = model.strength().filter(|_| model.strength_grows())?;
    let constant = NixGao::constant(strength.macroscopic_strength_pa());
    let plain = match strength.strain_gradient_length_m() {
        Some(length_m) => constant.and_then(|constant| constant.with_strain_gradient(length_m)),
        None => constant,
    };
    // A cap below the strength itself is none of this body's.
    let capped = cap_pa.map_or(plain, |cap_pa| plain.and_then(|plain| plain.with_cap(cap_pa))).ok()?;
    model.with_strength(capped)
}
