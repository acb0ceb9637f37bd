//! Causes of the area of a load: the hardness, the roughness of some scales, both, or nothing.

use findings::features::{DecadeShare, decisive_decade, slope_shares};
use judge::Reference;
use serde::Serialize;
use study::linear_laws::rms_gradients;
use study::models::Choice;

use super::area::Source;
use super::estimate::Estimate;
use super::evidence::Evidence;

/// The share of the nominal area from which on everything touches.
const FULL: f64 = 0.999;

/// An area of at most this times the load over the hardness hangs on the hardness alone.
const FLOWED: f64 = 1.1;

/// An area of at least this times that of elastic bodies, or of at most its inverse, hangs on the hardness as well.
const ELASTIC: f64 = 1.03;

/// A cause that an area hangs on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "hangs_on")]
pub enum Cause {
    /// The growth of the hardness at small scales, which is open.
    GrowthOfHardness {
        /// The area with a constant hardness over that with one that grows.
        ratio: f64,
    },
    /// The hardness: the area is the load over it, and roughness does not matter.
    Hardness {
        /// The hardness \[Pa\].
        hardness_pa: f64,
    },
    /// The slopes of the roughness, most of all those of a decade of wavelengths.
    Roughness {
        /// The decade, and its share of the mean square slope.
        decade: DecadeShare,
    },
    /// The hardness, and the slopes of the roughness.
    HardnessAndRoughness {
        /// The hardness \[Pa\].
        hardness_pa: f64,
        /// The decade, and its share of the mean square slope.
        decade: DecadeShare,
    },
    /// Adhesion, which no area counts: the surfaces stick.
    Adhesion,
    /// Nothing: everything touches.
    FullContact,
    /// Unknown: the surface has no slopes.
    Unknown,
}

impl Cause {
    /// Returns true if scales of roughness have a part in it.
    #[must_use]
    pub fn has_scales(self) -> bool {
        !matches!(self, Cause::Hardness { .. } | Cause::Adhesion | Cause::FullContact | Cause::Unknown)
    }

    /// Finds the cause of the area that is concluded for a load. What elements say goes before what a model says.
    pub(crate) fn new(evidence: &Evidence<'_>, load: &Estimate<'_>, sticks: bool) -> Self {
        if sticks {
            return Cause::Adhesion;
        }
        if let Some(ratio) = load.factor_of_hardness() {
            return Cause::GrowthOfHardness { ratio };
        }
        let flowing = Flowing::new(evidence, load);
        Self::of(load.area.area_fraction.unwrap_or(load.area.high), flowing, steepest(evidence))
    }

    fn of(area_fraction: f64, flowing: Option<Flowing>, decade: Option<DecadeShare>) -> Self {
        if area_fraction >= FULL {
            return Cause::FullContact;
        }
        match (flowing, decade) {
            (Some(Flowing { hardness_pa, least, .. }), _) if area_fraction <= FLOWED * least => {
                Cause::Hardness { hardness_pa }
            }
            (Some(Flowing { hardness_pa, elastic, .. }), Some(decade))
                if elastic.is_some_and(|elastic| area_fraction > ELASTIC * elastic) =>
            {
                Cause::HardnessAndRoughness { hardness_pa, decade }
            }
            (_, Some(decade)) => Cause::Roughness { decade },
            (_, None) => Cause::Unknown,
        }
    }
}

/// A contact that flows at a hardness.
#[derive(Debug, Clone, Copy)]
struct Flowing {
    hardness_pa: f64,
    /// The least area fraction, the load over the hardness.
    least: f64,
    /// The area fraction of elastic bodies, if elements of such bodies were pressed.
    elastic: Option<f64>,
}

impl Flowing {
    /// The contact of the estimate, if its bodies flow.
    fn new(evidence: &Evidence<'_>, load: &Estimate<'_>) -> Option<Self> {
        let hardness_pa = match load.area.source {
            Source::Elements(Reference::Yielding { hardness_pa }) => hardness_pa,
            Source::Model { curve } => {
                let flows = evidence.scene.needs.curves[curve].model.entry.has(Choice::Strength);
                evidence.scene.hardness_pa().filter(|_| flows)?
            }
            _ => return None,
        };
        let elastic = load.references.iter().find(|group| group.reference == Reference::Elastic);
        Some(Flowing {
            hardness_pa,
            least: load.nominal_pressure_pa / hardness_pa,
            elastic: elastic.and_then(|group| group.area_fraction),
        })
    }
}

/// The decade with the largest share of the mean square slope, on which the area depends; `None` of a surface without slopes.
fn steepest(evidence: &Evidence<'_>) -> Option<DecadeShare> {
    let psd = &evidence.results.psd;
    let shares = slope_shares(&rms_gradients(psd));
    let decade = decisive_decade(&shares)?.of_spectrum_with(&evidence.scene.surface.holes);
    Some(DecadeShare {
        longest_m: decade.longest_m.min(psd.longest_wavelength_m()),
        shortest_m: decade.shortest_m.max(psd.shortest_wavelength_m()),
        ..decade
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const DECADE: DecadeShare = DecadeShare { longest_m: 1e-4, shortest_m: 1e-5, share: 0.6, measured: true };

    fn flowing(elastic: Option<f64>) -> Option<Flowing> {
        Some(Flowing { hardness_pa: 1e9, least: 0.02, elastic })
    }

    #[test]
    fn an_area_of_the_load_over_the_hardness_hangs_on_nothing_else() {
        let cause = |area_fraction| Cause::of(area_fraction, flowing(Some(0.01)), Some(DECADE));
        assert_eq!(cause(0.02), Cause::Hardness { hardness_pa: 1e9 });
        assert_eq!(cause(0.022), Cause::Hardness { hardness_pa: 1e9 });
        assert_eq!(cause(0.0221), Cause::HardnessAndRoughness { hardness_pa: 1e9, decade: DECADE });
    }

    #[test]
    fn an_area_of_elastic_bodies_hangs_on_roughness() {
        assert_eq!(Cause::of(0.05, None, Some(DECADE)), Cause::Roughness { decade: DECADE });
        assert_eq!(Cause::of(0.05, flowing(Some(0.049)), Some(DECADE)), Cause::Roughness { decade: DECADE });
        assert_eq!(Cause::of(0.05, flowing(None), Some(DECADE)), Cause::Roughness { decade: DECADE });
        assert_eq!(Cause::of(0.05, flowing(None), None), Cause::Unknown);
    }

    #[test]
    fn full_contact_has_no_cause() {
        assert_eq!(Cause::of(0.999, None, Some(DECADE)), Cause::FullContact);
        assert_eq!(Cause::of(1.0, flowing(None), None), Cause::FullContact);
    }
}
