//! Doubts about numbers that formulas accept: slopes, strengths and pressures that no such contact has.

mod real_pressure;

use spectrum::random_surfaces::{AreaSpectrum, Conversion};
use spectrum::{AmplitudeDefinition, Normalisation, ProfilePsd, amplitudes, cumulative_moments};

use crate::answer::SceneAnswer;
use scene::Scene;
use study::material::Material;
use study::plan::{Load, NominalPressure};
use study::validity::MODULUS_OVER_IDEAL_STRENGTH;
use units::{Remark, RemarkCode};

pub use real_pressure::{PressedBodies, ROUNDING, RealPressures, of_contact};

/// Moduli \[Pa\] of metals and ceramics typed without their prefix, or with mega for giga; with the factor left out.
const MISTYPED_MODULI: [(std::ops::Range<f64>, f64); 2] = [(0.0..1e3, 1e9), (10e6..1e9, 1e3)];
/// Poisson's ratio up to which a body is a metal or a ceramic rather than a polymer.
const HARD_RATIO: f64 = 0.35;

/// The slope and the aspect ratio above which the units of a spectrum are probably mistaken.
const STEEP: f64 = 1.0;
/// Exponent of the modulus of a layer below which boundary elements find more than 1.2 times the area of Persson's theory, beside
/// that on half-spaces.
const THIN_LAYER: f64 = -0.25;
/// Share of the roughness moved by levelling, and error of the rms gradient from the end of the spectrum, that are worth a note.
const LEAST_LEVELLED: f64 = 1e-3;
const LEAST_END_ERROR: f64 = 0.01;
/// The rms slope from which a mistaken unit of heights is more likely than any surface.
const FAR_TOO_STEEP: f64 = 30.0;

/// All doubts about a scene and its answer.
#[must_use]
pub fn of_scene(scene: &Scene, answer: &SceneAnswer) -> Vec<Remark> {
    let mut doubts = of_spectrum(&scene.surface.psd);
    doubts.extend(scene.material.iter().filter_map(of_material));
    doubts.extend(of_loads(&scene.needs.loads, scene.hardness_pa()));
    let mut pressures = RealPressures::new(scene.hardness_pa());
    for (curve, answers) in scene.needs.curves.iter().zip(&answer.curves) {
        for (load, answer) in scene.needs.loads.iter().zip(answers) {
            if let Some(answer) = answer {
                pressures.add(curve, answer.real_pressure_pa, || load.label.clone());
            }
        }
    }
    doubts.extend(pressures.doubts());
    doubts
}

/// Returns true for a doubt about what was typed, false for one about the area of a model.
#[must_use]
pub fn is_about_inputs(doubt: &Remark) -> bool {
    !matches!(doubt.code, RemarkCode::RealAboveHardness | RemarkCode::RealAboveThirdModulus)
}

/// Doubts about the slopes of a spectrum. A mistaken unit shows here.
#[must_use]
pub fn of_spectrum(psd: &ProfilePsd) -> Vec<Remark> {
    let moments = cumulative_moments(psd, Normalisation::default());
    let rms_slope = moments.last().map(|moments| moments.rms_slope());
    let scales = amplitudes(psd, AmplitudeDefinition::default());
    let aspect_ratios =
        scales.iter().map(|scale| (scale.wavelength_m, scale.amplitude_m / scale.wavelength_m));
    let steepest =
        aspect_ratios.filter(|(_, aspect_ratio)| *aspect_ratio > STEEP).max_by(|a, b| a.1.total_cmp(&b.1));
    let surface = rms_slope.and_then(of_slope);
    let scale = steepest.map(|(wavelength_m, aspect_ratio)| {
        Remark::new(RemarkCode::SteepScale)
            .with("wavelength_m", wavelength_m)
            .with("aspect_ratio", aspect_ratio)
    });
    surface.into_iter().chain(scale).collect()
}

/// Remarks on the surface that a spectrum of profiles is converted to.
#[must_use]
pub fn of_surface(psd: &ProfilePsd) -> Vec<Remark> {
    AreaSpectrum::from_profile(psd).map_or_else(|_| Vec::new(), |surface| of_conversion(surface.conversion()))
}

/// Remarks on the conversion of a spectrum of profiles to that of the surface.
#[must_use]
pub fn of_conversion(conversion: Conversion) -> Vec<Remark> {
    let Conversion { levelled_share, end_error, .. } = conversion;
    let levelled = (levelled_share > LEAST_LEVELLED)
        .then(|| Remark::new(RemarkCode::SpectrumLevelled).with("share", levelled_share));
    let end =
        (end_error > LEAST_END_ERROR).then(|| Remark::new(RemarkCode::SpectrumEnd).with("error", end_error));
    levelled.into_iter().chain(end).collect()
}

/// The remark on a layer, which Persson's theory takes by its modulus at each wavelength.
#[must_use]
pub fn of_layer(material: &Material, psd: &ProfilePsd) -> Option<Remark> {
    let exponent = judge::exponent_of_stiffness(psd, &material.pair.layer_compliance()?)?;
    let is_thin = exponent < THIN_LAYER;
    let code = if is_thin { RemarkCode::ThinLayer } else { RemarkCode::ModulusOfLayer };
    Some(Remark::new(code).with("exponent", exponent))
}

/// The note on points that lie further apart along one axis, as those of a size with swapped lengths do.
#[must_use]
pub fn of_spacing([x_m, y_m]: [f64; 2]) -> Option<Remark> {
    const EVEN: f64 = 0.01;
    let is_uneven = (x_m / y_m - 1.0).abs() > EVEN;
    is_uneven.then(|| Remark::new(RemarkCode::UnevenSpacing).with("x_m", x_m).with("y_m", y_m))
}

/// The doubt about the rms slope of a surface.
#[must_use]
pub fn of_slope(rms_slope: f64) -> Option<Remark> {
    let code = match rms_slope > FAR_TOO_STEEP {
        true => RemarkCode::FarTooSteepSurface,
        false => RemarkCode::SteepSurface,
    };
    (rms_slope > STEEP).then(|| Remark::new(code).with("rms_slope", rms_slope))
}

/// The doubt about a material, and the note on whose hardness is used where both bodies have one.
#[must_use]
pub fn of_bodies(material: &Material) -> Vec<Remark> {
    of_material(material).into_iter().chain(material.softer().and_then(|softer| softer.remark())).collect()
}

/// The doubt about a material that is stronger than solids are, or as soft as one whose prefix is mistaken.
#[must_use]
pub fn of_material(material: &Material) -> Option<Remark> {
    of_strength(material).or_else(|| {
        let body = material.pair.body();
        let (youngs_modulus_pa, poisson_ratio) = (body.youngs_modulus_pa(), body.poisson_ratio());
        let mistyped = MISTYPED_MODULI.iter().find(|(moduli_pa, _)| moduli_pa.contains(&youngs_modulus_pa));
        let (_, factor) = mistyped.filter(|_| poisson_ratio <= HARD_RATIO)?;
        let remark = Remark::new(RemarkCode::SofterThanItsRatio).with("youngs_modulus_pa", youngs_modulus_pa);
        Some(remark.with("probable_pa", factor * youngs_modulus_pa).with("poisson_ratio", poisson_ratio))
    })
}

fn of_strength(material: &Material) -> Option<Remark> {
    let yield_strength_pa = material.yield_strength_pa()?;
    let bound_pa = material.pair.yielding_body().youngs_modulus_pa() / MODULUS_OVER_IDEAL_STRENGTH;
    let remark = Remark::new(RemarkCode::StrongerThanSolids).with("yield_strength_pa", yield_strength_pa);
    (yield_strength_pa > bound_pa).then(|| remark.with("bound_pa", bound_pa))
}

/// The doubt about loads above the hardness \[Pa\].
#[must_use]
pub fn of_loads(loads: &[Load], hardness_pa: Option<f64>) -> Option<Remark> {
    let pressures = loads.iter().map(|load| (load.nominal_pressure, Some(load.label.as_str())));
    of_pressures(pressures, hardness_pa)
}

/// The doubt about nominal pressures above the hardness \[Pa\]; labels are optional.
#[must_use]
pub fn of_pressures<'l>(
    pressures: impl Iterator<Item = (NominalPressure, Option<&'l str>)>,
    hardness_pa: Option<f64>,
) -> Option<Remark> {
    let hardness_pa = hardness_pa?;
    let mut above = 0;
    let mut highest: Option<(NominalPressure, Option<&str>)> = None;
    for (pressure, label) in pressures.filter(|(pressure, _)| pressure.pa() > hardness_pa) {
        above += 1;
        if highest.is_none_or(|(highest, _)| pressure > highest) {
            highest = Some((pressure, label));
        }
    }
    highest.map(|(pressure, label)| {
        Remark::new(RemarkCode::NominalAboveHardness)
            .with("load", label.map_or_else(|| pressure.label(), str::to_owned))
            .with("pressure_pa", pressure.pa())
            .with("hardness_pa", hardness_pa)
            .with("in_hardnesses", pressure.pa() / hardness_pa)
            .with("others", above - 1)
    })
}
