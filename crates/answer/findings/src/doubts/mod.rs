//! Doubts about numbers that formulas accept: slopes, strengths and pressures that no such contact has.

mod real_pressure;

use serde::Serialize;
use spectrum::{AmplitudeDefinition, Normalisation, ProfilePsd, amplitudes, cumulative_moments};

use crate::answer::Answer;
use scene::Scene;
use study::material::Material;
use study::plan::{Load, NominalPressure};
use study::validity::MODULUS_OVER_IDEAL_STRENGTH;

pub use real_pressure::RealPressures;

/// Moduli \[Pa\] of metals and ceramics typed without their prefix, or with mega for giga; with the factor left out.
const MISTYPED_MODULI: [(std::ops::Range<f64>, f64); 2] = [(0.0..1e3, 1e9), (10e6..1e9, 1e3)];
/// Poisson's ratio up to which a body is a metal or a ceramic rather than a polymer.
const HARD_RATIO: f64 = 0.35;

/// The slope and the aspect ratio above which the units of a spectrum are probably mistaken.
const STEEP: f64 = 1.0;

/// A value that can be computed with but is physically implausible.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Doubt {
    /// The rms slope of profiles is above 1.
    SteepSurface {
        /// The rms slope along a profile of the whole spectrum.
        rms_slope: f64,
    },
    /// A scale is higher than it is long.
    SteepScale {
        /// The wavelength \[m\] of the steepest scale.
        wavelength_m: f64,
        /// Its amplitude over its wavelength, above 1.
        aspect_ratio: f64,
    },
    /// The yield strength is above a tenth of Young's modulus.
    StrongerThanSolids {
        /// The yield strength \[Pa\].
        yield_strength_pa: f64,
        /// E/10 \[Pa\].
        bound_pa: f64,
    },
    /// Young's modulus is that of a polymer or of nothing solid, Poisson's ratio that of a metal.
    SofterThanItsRatio {
        /// Young's modulus \[Pa\].
        youngs_modulus_pa: f64,
        /// The modulus \[Pa\] that was probably meant.
        probable_pa: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
    },
    /// A load presses harder on the nominal area than the hardness.
    NominalAboveHardness {
        /// The load as typed.
        load: String,
        /// Its pressure \[Pa\].
        pressure_pa: f64,
        /// The hardness \[Pa\].
        hardness_pa: f64,
        /// The number of further loads above the hardness.
        others: usize,
    },
    /// The real pressure of a curve whose strength does not grow at small depths is above the hardness.
    RealAboveHardness {
        /// The highest real pressure.
        highest: HighestPressure,
        /// The hardness \[Pa\].
        hardness_pa: f64,
    },
    /// The real pressure of a curve is above a third of the composite modulus.
    RealAboveThirdModulus {
        /// The highest real pressure.
        highest: HighestPressure,
        /// E*/3 \[Pa\].
        bound_pa: f64,
    },
}

/// The highest of the real pressures that are above a bound.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HighestPressure {
    /// The curve.
    pub curve: String,
    /// The load as typed.
    pub load: String,
    /// The real pressure \[Pa\].
    pub pressure_pa: f64,
    /// The number of further curves above the bound.
    pub other_curves: usize,
}

impl Doubt {
    /// All doubts about a scene and its answer.
    #[must_use]
    pub fn of_scene(scene: &Scene, answer: &Answer) -> Vec<Doubt> {
        let mut doubts = Self::of_spectrum(&scene.surface.psd);
        doubts.extend(scene.material.iter().filter_map(Self::of_material));
        doubts.extend(Self::of_loads(&scene.needs.loads, scene.hardness_pa()));
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
    pub fn is_about_inputs(&self) -> bool {
        !matches!(self, Doubt::RealAboveHardness { .. } | Doubt::RealAboveThirdModulus { .. })
    }

    /// Doubts about the slopes of a spectrum. A mistaken unit shows here.
    #[must_use]
    pub fn of_spectrum(psd: &ProfilePsd) -> Vec<Doubt> {
        let moments = cumulative_moments(psd, Normalisation::default());
        let rms_slope = moments.last().map(|moments| moments.rms_slope());
        let scales = amplitudes(psd, AmplitudeDefinition::default());
        let aspect_ratios =
            scales.iter().map(|scale| (scale.wavelength_m, scale.amplitude_m / scale.wavelength_m));
        let steepest = aspect_ratios
            .filter(|(_, aspect_ratio)| *aspect_ratio > STEEP)
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let surface = rms_slope.and_then(Self::of_slope);
        let scale =
            steepest.map(|(wavelength_m, aspect_ratio)| Doubt::SteepScale { wavelength_m, aspect_ratio });
        surface.into_iter().chain(scale).collect()
    }

    /// The doubt about the rms slope of a surface.
    #[must_use]
    pub fn of_slope(rms_slope: f64) -> Option<Doubt> {
        (rms_slope > STEEP).then_some(Doubt::SteepSurface { rms_slope })
    }

    /// The doubt about a material that is stronger than solids are, or as soft as one whose prefix is mistaken.
    #[must_use]
    pub fn of_material(material: &Material) -> Option<Doubt> {
        Self::of_strength(material).or_else(|| {
            let body = material.pair.body();
            let (youngs_modulus_pa, poisson_ratio) = (body.youngs_modulus_pa(), body.poisson_ratio());
            let mistyped =
                MISTYPED_MODULI.iter().find(|(moduli_pa, _)| moduli_pa.contains(&youngs_modulus_pa));
            let (_, factor) = mistyped.filter(|_| poisson_ratio <= HARD_RATIO)?;
            let probable_pa = factor * youngs_modulus_pa;
            Some(Doubt::SofterThanItsRatio { youngs_modulus_pa, probable_pa, poisson_ratio })
        })
    }

    fn of_strength(material: &Material) -> Option<Doubt> {
        let yield_strength_pa = material.yield_strength_pa()?;
        let bound_pa = material.pair.yielding_body().youngs_modulus_pa() / MODULUS_OVER_IDEAL_STRENGTH;
        (yield_strength_pa > bound_pa).then_some(Doubt::StrongerThanSolids { yield_strength_pa, bound_pa })
    }

    /// The doubt about loads above the hardness \[Pa\].
    #[must_use]
    pub fn of_loads(loads: &[Load], hardness_pa: Option<f64>) -> Option<Doubt> {
        let pressures = loads.iter().map(|load| (load.nominal_pressure, Some(load.label.as_str())));
        Self::of_pressures(pressures, hardness_pa)
    }

    /// The doubt about nominal pressures above the hardness \[Pa\]; labels are optional.
    #[must_use]
    pub fn of_pressures<'l>(
        pressures: impl Iterator<Item = (NominalPressure, Option<&'l str>)>,
        hardness_pa: Option<f64>,
    ) -> Option<Doubt> {
        let hardness_pa = hardness_pa?;
        let mut above = 0;
        let mut highest: Option<(NominalPressure, Option<&str>)> = None;
        for (pressure, label) in pressures.filter(|(pressure, _)| pressure.pa() > hardness_pa) {
            above += 1;
            if highest.is_none_or(|(highest, _)| pressure > highest) {
                highest = Some((pressure, label));
            }
        }
        highest.map(|(pressure, label)| Doubt::NominalAboveHardness {
            load: label.map_or_else(|| pressure.label(), str::to_owned),
            pressure_pa: pressure.pa(),
            hardness_pa,
            others: above - 1,
        })
    }
}
