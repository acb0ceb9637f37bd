//! Persson's theory as a model of curves, and a spectrum as that theory takes it.

use asperity::{MaterialPair, NixGao};
use persson::hardness_laws::{Hardness, HardnessError, HardnessGrowth};
use persson::variance::Band;
use persson::{PerssonModel, Roughness, RoughnessSample};
use spectrum::{Moments, Normalisation, ProfilePsd};
use stacked_contact::Scale;

/// Whether the surface flows, as it is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Deformation {
    /// It does not.
    Elastic,
    /// It does at a hardness.
    ElasticPlastic,
}

units::named!(Deformation, "model", { Elastic => "elastic", ElasticPlastic => "elastic-plastic" });

/// How the surface deforms in Persson's theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PerssonLaw {
    /// Elastically.
    Elastic,
    /// Elastically up to a hardness, which grows as the strength does.
    ElasticPlastic {
        /// The strength of the rough body.
        strength: NixGao,
        /// H/S0, 3 but for what rounding a given pair of them allows.
        hardness_over_strength: f64,
    },
}

impl PerssonLaw {
    /// The elastic energy factor of separations (Almqvist et al. 2011).
    pub const ENERGY_FACTOR: f64 = 0.45;

    /// The strength of the rough body, where it yields.
    #[must_use]
    pub fn strength(&self) -> Option<NixGao> {
        match *self {
            PerssonLaw::Elastic => None,
            PerssonLaw::ElasticPlastic { strength, .. } => Some(strength),
        }
    }

    /// The same law of another strength; `None` where it never yields.
    #[must_use]
    pub fn with_strength(self, strength: NixGao) -> Option<Self> {
        match self {
            PerssonLaw::Elastic => None,
            PerssonLaw::ElasticPlastic { hardness_over_strength, .. } => {
                Some(PerssonLaw::ElasticPlastic { strength, hardness_over_strength })
            }
        }
    }

    /// The theory for bodies in contact.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    pub fn model(&self, pair: &MaterialPair) -> Result<PerssonModel, HardnessError> {
        let contact_modulus_pa = pair.composite_modulus_pa();
        match *self {
            PerssonLaw::Elastic => Ok(PerssonModel::Elastic { contact_modulus_pa, correction: None }),
            PerssonLaw::ElasticPlastic { strength, hardness_over_strength } => {
                let hardness_pa = hardness_over_strength * strength.macroscopic_strength_pa();
                let cap_pa = strength.cap_pa().map(|cap_pa| hardness_over_strength * cap_pa);
                let (growth, cap_pa) = match strength.strain_gradient_length_m() {
                    Some(length_m) => (HardnessGrowth::NixGao { hardness_pa, length_m }, cap_pa),
                    None => (HardnessGrowth::Constant { hardness_pa }, None),
                };
                Ok(PerssonModel::ElasticPlastic {
                    contact_modulus_pa,
                    hardness: Hardness::new(growth, cap_pa)?,
                })
            }
        }
    }
}

/// A spectrum with the moments, of a normalisation, that it has from the second wavelength on, and the amplitudes of its
/// scales; without amplitudes no hardness can follow them. `beyond` is the spectrum with what a cutoff has left out of it.
#[must_use]
pub fn roughness<'m>(
    psd: &ProfilePsd,
    moments: impl Iterator<Item = &'m Moments>,
    normalisation: Normalisation,
    scales: &[Scale],
    beyond: &ProfilePsd,
    band: Band,
) -> Roughness {
    let parseval = Normalisation::Parseval.factor() / normalisation.factor();
    let moments = moments.map(|m| [m.m0_m2, m.m2, m.m4_per_m2].map(|moment| parseval * moment));
    let samples: Vec<RoughnessSample> = psd
        .wavelengths_m()
        .iter()
        .zip(psd.c1d_m3())
        .zip(std::iter::once([0.0; 3]).chain(moments))
        .enumerate()
        .map(|(at, ((&wavelength_m, &c1d_m3), moments))| {
            let amplitude_m = scales.get(at).map_or(f64::INFINITY, |scale| scale.amplitude_m);
            RoughnessSample { wavelength_m, c1d_m3, moments, amplitude_m }
        })
        .collect();
    let shortest_m = psd.shortest_wavelength_m();
    let beyond: Vec<(f64, f64)> = beyond
        .wavelengths_m()
        .iter()
        .copied()
        .zip(beyond.c1d_m3().iter().copied())
        .filter(|(wavelength_m, _)| *wavelength_m < shortest_m)
        .collect();
    Roughness::new(&samples, &beyond, band)
}
