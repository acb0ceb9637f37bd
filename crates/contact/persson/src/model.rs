//! Persson's theory as a model: one pass along a spectrum under one load.

use crate::areas::ContactAreas;
use crate::corrections::Correction;
use crate::energy::EnergyFactor;
use crate::growing_hardness::areas_along;
use crate::hardness_laws::{CappedHardness, HardnessError, HardnessGrowth};
use crate::roughness::{Place, Roughness};
use crate::separation::{Separation, SeparationLaw};
use crate::{constant_hardness, elastic};

/// Deformation of the surface.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum PerssonModel {
    /// Elastic contact.
    Elastic {
        /// The contact modulus E* > 0 \[Pa\].
        contact_modulus_pa: f64,
        /// Correction fitted to simulations.
        correction: Option<Correction>,
    },
    /// Elastic contact up to a hardness.
    ElasticPlastic {
        /// The contact modulus E* > 0 \[Pa\].
        contact_modulus_pa: f64,
        /// Hardness along the spectrum.
        hardness: CappedHardness,
    },
}

/// Contact with the spectrum cut off at a wavelength.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Cut {
    /// Cutoff \[m\].
    pub wavelength_m: f64,
    /// Shares of the nominal area.
    pub areas: ContactAreas,
    /// Mean pressure on the area in contact \[Pa\].
    pub real_pressure_pa: f64,
    /// Rms gradient of the surface up to the cutoff. From 0.2 on the flattening pressure exceeds E*/10.
    pub rms_gradient: f64,
    /// Mean separation of the elastic theory \[m\]; `None` if more than 3 % of the contact is plastic.
    pub mean_gap_m: Option<f64>,
    /// Stiffness \[Pa/m\]; `None` if more than 3 % of the contact is plastic, or if nothing has been flattened.
    pub stiffness_pa_per_m: Option<f64>,
}

impl Cut {
    fn new(place: &Place, areas: ContactAreas, separation: Separation, pressure_pa: f64) -> Self {
        let elastic = areas.plastic <= MOST_PLASTIC * areas.contact();
        let if_elastic = |value: f64| Some(value).filter(|value| elastic && value.is_finite());
        Cut {
            mean_gap_m: if_elastic(separation.mean_gap_m),
            stiffness_pa_per_m: if_elastic(separation.stiffness_pa_per_m),
            ..Cut::without_separation(place, areas, pressure_pa)
        }
    }

    /// Returns the contact of these shares of the nominal area at a place, under a nominal pressure p > 0 \[Pa\], without mean
    /// gap and stiffness.
    #[must_use]
    pub fn without_separation(place: &Place, areas: ContactAreas, pressure_pa: f64) -> Self {
        Cut {
            wavelength_m: place.wavelength_m,
            areas,
            real_pressure_pa: pressure_pa / areas.contact(),
            rms_gradient: place.rms_gradient(),
            mean_gap_m: None,
            stiffness_pa_per_m: None,
        }
    }
}

/// Share of the contact that may be plastic before the elastic separation loses its meaning.
const MOST_PLASTIC: f64 = 0.03;

impl PerssonModel {
    /// Returns the contact at each cutoff of a roughness under a nominal pressure p > 0 \[Pa\], with the separation
    /// of that roughness.
    ///
    /// # Errors
    /// The errors of [`areas`](Self::areas).
    pub fn along(
        &self,
        roughness: &Roughness,
        separation: &SeparationLaw,
        pressure_pa: f64,
    ) -> Result<Vec<Cut>, HardnessError> {
        let areas = self.areas(roughness, pressure_pa)?;
        let separations = separation.along(pressure_pa);
        let places = roughness.places().iter().zip(areas).zip(separations);
        Ok(places
            .map(|((place, areas), separation)| Cut::new(place, areas, separation, pressure_pa))
            .collect())
    }

    /// Returns the contact at the last cutoff, which is the whole spectrum; `None` if the roughness is empty.
    ///
    /// # Errors
    /// The errors of [`areas`](Self::areas).
    pub fn at_last(
        &self,
        roughness: &Roughness,
        separation: &SeparationLaw,
        pressure_pa: f64,
    ) -> Result<Option<Cut>, HardnessError> {
        let last = roughness.places().last().zip(self.areas_at_last(roughness, pressure_pa)?);
        Ok(last.map(|(place, areas)| Cut::new(place, areas, separation.whole(pressure_pa), pressure_pa)))
    }

    /// Contact modulus E* \[Pa\].
    #[must_use]
    pub fn contact_modulus_pa(&self) -> f64 {
        match *self {
            PerssonModel::Elastic { contact_modulus_pa, .. }
            | PerssonModel::ElasticPlastic { contact_modulus_pa, .. } => contact_modulus_pa,
        }
    }

    /// Hardness \[Pa\] of a surface that yields, if it does not grow.
    #[must_use]
    pub fn constant_hardness_pa(&self) -> Option<f64> {
        match self {
            PerssonModel::ElasticPlastic { hardness, .. } => match *hardness.growth() {
                HardnessGrowth::Constant { hardness_pa } => Some(hardness_pa),
                _ => None,
            },
            PerssonModel::Elastic { .. } => None,
        }
    }

    /// Returns the shares of the nominal area at each cutoff of a roughness, under a nominal pressure p > 0 \[Pa\].
    ///
    /// # Errors
    /// [`HardnessError::Falling`], and [`HardnessError::Exceeded`] if a growing hardness is not above p at the longest wavelength.
    /// With a constant hardness everything touches and flows in that case.
    pub fn areas(&self, roughness: &Roughness, pressure_pa: f64) -> Result<Vec<ContactAreas>, HardnessError> {
        self.areas_from(0, roughness, pressure_pa)
    }

    /// Returns the shares of the nominal area at the last cutoff; `None` if the roughness is empty.
    ///
    /// # Errors
    /// The errors of [`areas`](Self::areas).
    pub fn areas_at_last(
        &self,
        roughness: &Roughness,
        pressure_pa: f64,
    ) -> Result<Option<ContactAreas>, HardnessError> {
        let last = roughness.places().len().saturating_sub(1);
        Ok(self.areas_from(last, roughness, pressure_pa)?.pop())
    }

    /// Returns the shares at the places from `first` on. The others are followed where the last ones depend on them.
    fn areas_from(
        &self,
        first: usize,
        roughness: &Roughness,
        pressure_pa: f64,
    ) -> Result<Vec<ContactAreas>, HardnessError> {
        let variances_pa2: Vec<f64> =
            roughness.places().iter().map(|place| place.variance_pa2(self.contact_modulus_pa())).collect();
        match self {
            PerssonModel::Elastic { correction, .. } => {
                let effective_pa2 = match correction {
                    None => variances_pa2,
                    Some(correction) => {
                        let alpha: Vec<f64> = roughness.places().iter().map(|place| place.alpha).collect();
                        correction.effective_variances_pa2(pressure_pa, &variances_pa2, &alpha)
                    }
                };
                let areas = |variance_pa2: &f64| ContactAreas {
                    elastic: elastic::area_fraction(pressure_pa, variance_pa2.sqrt()),
                    plastic: 0.0,
                    gap: elastic::gap_fraction(pressure_pa, variance_pa2.sqrt()),
                };
                Ok(effective_pa2.iter().skip(first).map(areas).collect())
            }
            PerssonModel::ElasticPlastic { hardness, .. } => {
                if let HardnessGrowth::Constant { hardness_pa } = *hardness.growth() {
                    let areas =
                        |variance: &f64| constant_hardness::areas(pressure_pa, variance.sqrt(), hardness_pa);
                    return Ok(variances_pa2.iter().skip(first).map(areas).collect());
                }
                let hardness_pa = hardness.at_longest_pa(roughness)?;
                if pressure_pa >= hardness_pa {
                    let wavelength_m =
                        roughness.places().first().map_or(f64::INFINITY, |place| place.wavelength_m);
                    return Err(HardnessError::Exceeded { pressure_pa, hardness_pa, wavelength_m });
                }
                let path = hardness.path(roughness, self.contact_modulus_pa())?;
                Ok(areas_along(&path, pressure_pa, &variances_pa2).split_off(first))
            }
        }
    }

    /// Mean separation and stiffness of the elastic theory along a roughness. They lose their meaning where more than a few per
    /// cent of the contact is plastic.
    #[must_use]
    pub fn separation(&self, roughness: &Roughness, energy_factor: EnergyFactor) -> SeparationLaw {
        SeparationLaw::from_roughness(roughness, self.contact_modulus_pa(), energy_factor)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::roughness::RoughnessSample;

    /// C1D ~ q^-2.6 over two decades, h' = 1 at its end.
    fn roughness() -> Roughness {
        let moment = |q: f64, k: f64| (q.powf(k) - 1.0) / k / 10.0;
        let sample = |i: i32| {
            let q = 10f64.powf(f64::from(i) / 10.0);
            let moments = [moment(q, -1.6), moment(q, 0.4), moment(q, 2.4)];
            RoughnessSample { wavelength_m: TAU / q, c1d_m3: q.powf(-2.6), moments, amplitude_m: 1.0 / q }
        };
        Roughness::new(&(0..=20).map(sample).collect::<Vec<_>>(), None)
    }

    fn plastic(growth: HardnessGrowth) -> PerssonModel {
        PerssonModel::ElasticPlastic {
            contact_modulus_pa: 1.0,
            hardness: CappedHardness::new(growth, None).unwrap(),
        }
    }

    #[test]
    fn nothing_is_flattened_at_the_longest_wavelength() {
        let elastic =
            PerssonModel::Elastic { contact_modulus_pa: 1.0, correction: Some(Correction::WangMuser) };
        let yielding = plastic(HardnessGrowth::Power { hardness_pa: 0.5, exponent: 0.2 });
        for model in [elastic.clone(), yielding, plastic(HardnessGrowth::Constant { hardness_pa: 0.5 })] {
            let areas = model.areas(&roughness(), 0.01).unwrap();
            assert_eq!(areas[0], ContactAreas::FULL);
            assert!(areas.is_sorted_by(|long, short| long.contact() > short.contact()), "{model:?}");
        }
    }

    #[test]
    fn plastic_contact_has_no_elastic_separation() {
        let along = |model: &PerssonModel| {
            let separation = model.separation(&roughness(), EnergyFactor::ALMQVIST);
            model.along(&roughness(), &separation, 0.01).unwrap()
        };
        let elastic = along(&PerssonModel::Elastic { contact_modulus_pa: 1.0, correction: None });
        assert_eq!((elastic[0].mean_gap_m, elastic[0].stiffness_pa_per_m), (Some(0.0), None));
        assert!(elastic[1..].iter().all(|cut| cut.mean_gap_m.is_some() && cut.stiffness_pa_per_m.is_some()));
        let yielding = along(&plastic(HardnessGrowth::Constant { hardness_pa: 0.6 }));
        for cut in &yielding[1..] {
            let is_plastic = cut.areas.plastic > 0.03 * cut.areas.contact();
            assert_eq!(
                (cut.mean_gap_m.is_none(), cut.stiffness_pa_per_m.is_none()),
                (is_plastic, is_plastic)
            );
            assert!((cut.real_pressure_pa * cut.areas.contact() / 0.01 - 1.0).abs() < 1e-15);
        }
        assert!(yielding.last().unwrap().mean_gap_m.is_none() && yielding[1].mean_gap_m.is_some());
        let model = PerssonModel::Elastic { contact_modulus_pa: 1.0, correction: None };
        let separation = model.separation(&roughness(), EnergyFactor::ALMQVIST);
        let last = model.at_last(&roughness(), &separation, 0.01).unwrap();
        assert_eq!(last.as_ref(), elastic.last());
    }

    #[test]
    fn the_last_areas_alone_are_those_of_the_curve() {
        let elastic = |correction| PerssonModel::Elastic { contact_modulus_pa: 1.0, correction };
        for model in [
            elastic(None),
            elastic(Some(Correction::WangMuser)),
            elastic(Some(Correction::AlgebraicNayak)),
            plastic(HardnessGrowth::Constant { hardness_pa: 0.3 }),
            plastic(HardnessGrowth::Power { hardness_pa: 0.3, exponent: 0.1 }),
        ] {
            let last = model.areas_at_last(&roughness(), 0.01).unwrap();
            assert_eq!(last.as_ref(), model.areas(&roughness(), 0.01).unwrap().last(), "{model:?}");
            let nothing = Roughness::new(&[], None);
            if !matches!(&model, PerssonModel::ElasticPlastic { hardness, .. }
                if !matches!(hardness.growth(), HardnessGrowth::Constant { .. }))
            {
                assert_eq!(model.areas_at_last(&nothing, 0.01).unwrap(), None);
            }
        }
    }

    #[test]
    fn a_growing_hardness_lies_between_a_constant_one_and_none() {
        let last = |model: &PerssonModel| model.areas(&roughness(), 0.01).unwrap()[20];
        let elastic = last(&PerssonModel::Elastic { contact_modulus_pa: 1.0, correction: None });
        let constant = last(&plastic(HardnessGrowth::Constant { hardness_pa: 0.3 }));
        let growing = last(&plastic(HardnessGrowth::Power { hardness_pa: 0.3, exponent: 0.1 }));
        assert!(elastic.contact() < growing.contact() && growing.contact() < constant.contact());
        assert!(0.0 < growing.plastic && growing.plastic < constant.plastic);
    }

    #[test]
    fn more_than_the_hardness_flows_where_it_is_constant_and_is_refused_where_it_grows() {
        let constant = plastic(HardnessGrowth::Constant { hardness_pa: 0.3 });
        assert!(constant.areas(&roughness(), 0.3).unwrap().iter().all(|areas| areas.plastic == 1.0));
        let growing = plastic(HardnessGrowth::Power { hardness_pa: 0.3, exponent: 0.1 });
        let error = growing.areas(&roughness(), 0.3).unwrap_err();
        assert!(
            matches!(error, HardnessError::Exceeded { pressure_pa: 0.3, hardness_pa: 0.3, .. }),
            "{error}"
        );
    }
}
