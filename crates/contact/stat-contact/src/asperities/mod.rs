//! Populations of asperities under their laws, as seen by a quadrature over the interference: [`answers`] has the
//! trait, [`pieces`] the intervals and coordinates in which a law is smooth. Each law has a file, and a variant of
//! [`AsperityLaw`] with its parameters.

pub mod answers;
pub mod bem_sines;
pub mod elastic_plastic_sines;
pub mod elastic_plastic_spheres;
pub mod elastic_sines;
pub mod exponential_heights;
pub mod gradient_breaks;
pub mod gradient_law;
pub mod gradient_sines;
pub mod hertz_ellipses;
pub mod one_by_one;
pub mod pieces;
pub mod sine_charts;

use asperity::{Hardness, MaterialPair, NixGao};
use units::named;

use self::answers::Asperities;
use self::bem_sines::BemSines;
use self::elastic_plastic_sines::ElasticPlasticSines;
use self::elastic_plastic_spheres::ElasticPlasticSpheres;
use self::elastic_sines::ElasticSines;
use self::gradient_sines::GradientSines;
use self::one_by_one::elastic_spheres;
use crate::Population;

/// Response of one asperity to the flat that presses on it (`docs/theory/models.md`, sections 2 and 3.1).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub enum AsperityLaw {
    /// An elastic sphere (Greenwood & Williamson 1966).
    Hertz,
    /// Elastic-plastic sphere of Jackson & Green (2005; section 2.2); the area of one never exceeds pi R^2.
    EpSphere {
        /// Yield strength, at the depth of the interference.
        strength: NixGao,
        /// Decrease of the hardness as the contact grows.
        hardness: Hardness,
        /// Contact radius over sphere radius, in (0, 1\], from which on force and area no longer grow
        /// ([`Flattening::held_from`]); `None` if the force grows without bound.
        held_from: Option<f64>,
    },
    /// The elastic sinusoid of Johnson, Greenwood & Higginson (1985; section 2.3), with the density and the curvature
    /// of the population (Jackson & Jacobs, Eqs. 6 and 7).
    ElasticSine {
        /// Relation between pressure and interference.
        interference: InterferenceLaw,
    },
    /// The elastic-plastic sinusoid of Krithivasan & Jackson (2007; section 2.4), pressed by the mean gap of Rostami &
    /// Jackson (2013; section 2.6).
    EpSine {
        /// Yield strength, at the depth of the interference.
        strength: NixGao,
    },
}

impl AsperityLaw {
    /// Strength of the asperities, if they yield.
    #[must_use]
    pub fn strength(mut self) -> Option<NixGao> {
        self.strength_mut().copied()
    }

    /// Returns this law with another strength; `None` if it never yields.
    #[must_use]
    pub fn with_strength(mut self, strength: NixGao) -> Option<Self> {
        *self.strength_mut()? = strength;
        Some(self)
    }

    /// Returns this law with another form of the hardness; `None` if it has no hardness.
    #[must_use]
    pub fn with_hardness(self, hardness: Hardness) -> Option<Self> {
        match self {
            AsperityLaw::EpSphere { strength, held_from, .. } => {
                Some(AsperityLaw::EpSphere { strength, hardness, held_from })
            }
            _ => None,
        }
    }

    /// Returns this law with another relation between pressure and interference; `None` if it has only one.
    #[must_use]
    pub fn with_interference(self, interference: InterferenceLaw) -> Option<Self> {
        match self {
            AsperityLaw::ElasticSine { .. } => Some(AsperityLaw::ElasticSine { interference }),
            _ => None,
        }
    }

    fn strength_mut(&mut self) -> Option<&mut NixGao> {
        match self {
            AsperityLaw::Hertz | AsperityLaw::ElasticSine { .. } => None,
            AsperityLaw::EpSphere { strength, .. } => Some(strength),
            AsperityLaw::EpSine { strength } => Some(strength),
        }
    }

    /// Population of asperities that follow this law.
    pub(crate) fn asperities(self, pair: &MaterialPair, population: &Population) -> Box<dyn Asperities> {
        match self {
            AsperityLaw::Hertz => elastic_spheres(pair, population),
            AsperityLaw::EpSphere { strength, hardness, held_from } => {
                let spheres = ElasticPlasticSpheres::new(pair, population, strength, hardness);
                Box::new(match held_from {
                    Some(radius_share) => spheres.held_from(radius_share),
                    None => spheres,
                })
            }
            AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson } => {
                Box::new(ElasticSines::new(pair, population))
            }
            AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem } => {
                Box::new(BemSines::new(pair, population))
            }
            AsperityLaw::EpSine { strength } if strength.strain_gradient_length_m().is_none() => {
                let strength_pa = strength.macroscopic_strength_pa();
                Box::new(ElasticPlasticSines::new(pair, population, strength_pa))
            }
            AsperityLaw::EpSine { strength } => Box::new(GradientSines::new(pair, population, strength)),
        }
    }
}

/// Mean gap of the elastic sinusoid over its mean pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InterferenceLaw {
    /// The fit of Rostami & Jackson (2013), not Hertzian at light pressure.
    #[default]
    RostamiJackson,
    /// Boundary-element solutions, Hertzian at light pressure (section 3.3).
    Bem,
}

/// Quantity of a flattened sphere that no longer grows (`docs/theory/models.md`, section 3.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flattening {
    /// The area alone, at the cross-section pi R^2 (Jackson & Jacobs): the mean pressure grows without bound.
    Area,
    /// Area and force, from the contact radius [`Flattening::HELD_FROM`] R on.
    #[default]
    AreaAndForce,
}

named!(Flattening, "flattening", {
    Area => "area",
    AreaAndForce => "area-and-force",
});

impl Flattening {
    /// Contact radius over sphere radius from which area and force are held: the end of the finite-element results
    /// that the law was fitted to. Of the radii from there on it is the nearest to elements that flow; smaller ones are
    /// nearer still, but give up a part of the fit and carry fewer loads (`docs/develop/trials.md`).
    pub const HELD_FROM: f64 = asperity::FITTED_CONTACT_RADIUS_OVER_RADIUS;

    /// Contact radius over sphere radius from which on force and area are held; `None` if the force is not.
    #[must_use]
    pub fn held_from(self) -> Option<f64> {
        (self == Flattening::AreaAndForce).then_some(Self::HELD_FROM)
    }
}

named!(InterferenceLaw, "interference law", {
    RostamiJackson => "rostami-jackson",
    Bem => "bem",
});

#[cfg(test)]
mod tests {
    use super::pieces::{Chart, Points};
    use super::*;

    #[test]
    fn names_parse_as_printed() {
        for law in InterferenceLaw::ALL {
            assert_eq!(law.to_string().parse::<InterferenceLaw>().as_ref(), Ok(law));
        }
    }

    #[test]
    fn a_yielding_law_takes_another_strength_and_keeps_its_other_options() {
        let [soft, hard] = [1e9, 2e9].map(|strength_pa| NixGao::constant(strength_pa).unwrap());
        let (hardness, held_from) = (Hardness::Cosine, Some(0.5));
        let law = AsperityLaw::EpSphere { strength: soft, hardness, held_from };
        let harder = law.with_strength(hard).unwrap();
        assert_eq!(harder, AsperityLaw::EpSphere { strength: hard, hardness, held_from });
        assert_eq!((law.strength(), harder.strength()), (Some(soft), Some(hard)));
        assert_eq!((AsperityLaw::Hertz.strength(), AsperityLaw::Hertz.with_strength(hard)), (None, None));
    }

    /// Evaluates a smooth piece of a law at seven places: a row for each quantity.
    fn rows(asperities: &dyn Asperities, chart: Chart<'_>, places: &[f64]) -> [Vec<f64>; 4] {
        let mut rows = std::array::from_fn(|_| vec![0.0; places.len()]);
        let [interferences_m, slopes_m, pressures_pa, area_fractions] = &mut rows;
        match chart {
            Chart::Interference => asperities.at_interferences(places, pressures_pa, area_fractions),
            Chart::Law(chart) => chart
                .at_coordinates(places, Points { interferences_m, slopes_m, pressures_pa, area_fractions }),
        }
        rows
    }

    #[test]
    fn several_places_at_once_have_the_digits_of_each_alone() {
        let pair = MaterialPair::against_rigid(asperity::ElasticBody::new(2e11, 0.3).unwrap());
        let population = Population::new(1e-6, 1e12, 1e-8).unwrap();
        let constant = NixGao::constant(2e9).unwrap();
        let growing = constant.with_strain_gradient(1e-7).unwrap();
        let elastic =
            InterferenceLaw::ALL.iter().map(|&interference| AsperityLaw::ElasticSine { interference });
        let plastic = [constant, growing].into_iter().flat_map(|strength| {
            let spheres = [Hardness::JacksonGreen2005, Hardness::Cosine];
            let spheres =
                spheres.map(|hardness| AsperityLaw::EpSphere { strength, hardness, held_from: None });
            spheres.into_iter().chain([AsperityLaw::EpSine { strength }])
        });
        for law in elastic.chain(plastic).chain([AsperityLaw::Hertz]) {
            let asperities = law.asperities(&pair, &population);
            for piece in asperities.pieces(1e-12, 1e-7) {
                let place = |w: f64| match piece.chart {
                    Chart::Interference => w,
                    Chart::Law(chart) => chart.coordinate(w),
                };
                let (from, to) = (place(piece.from_m.max(1e-12)), place(piece.to_m.min(1e-7)));
                // As many as leave a part of a vector over.
                let places: Vec<f64> = (1..8).map(|k| from + (to - from) * f64::from(k) / 8.0).collect();
                let together = rows(&*asperities, piece.chart, &places);
                for (at, place) in places.iter().enumerate() {
                    let alone = rows(&*asperities, piece.chart, &[*place]);
                    let pairs = together.iter().zip(&alone);
                    assert!(pairs.clone().all(|(row, alone)| row[at] == alone[0]), "{law:?} {place:e}");
                }
            }
        }
    }
}
