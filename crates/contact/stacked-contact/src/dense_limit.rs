//! Limit of the pressure for a densely sampled stack (Jackson 2010).

use asperity::{ElasticPlasticSinusoid, ElasticSinusoid};

use crate::{Level, Scale, StackedModel, YieldingAreaLaw};

/// Largest pressure \[Pa\] at which one of the scales is in complete contact. The real pressure never exceeds it and
/// tends to it as the spectrum is sampled more densely, so the area tends to load over this pressure (or to the whole
/// nominal area if the nominal pressure is higher).
///
/// `None` without scales, and for a strength that depends on depth: it then depends on the load as well, see
/// [`setting_level`].
pub fn largest_full_contact_pressure_pa(
    model: &StackedModel,
    scales: impl IntoIterator<Item = Scale>,
) -> Option<f64> {
    let strength_pa = match model {
        StackedModel::Elastic { .. } => None,
        StackedModel::ElasticPlastic { strength, .. } if strength.strain_gradient_length_m().is_some() => {
            return None;
        }
        StackedModel::ElasticPlastic { strength, .. } => Some(strength.macroscopic_strength_pa()),
    };
    let pressed = scales.into_iter().map(|scale| (scale, strength_pa));
    largest_full_contact(model, pressed).map(|(_, pressure_pa)| pressure_pa)
}

/// Returns the level that sets the real pressure, and that pressure \[Pa\]: the level that takes the highest pressure
/// to come into complete contact at the strength it met. Among equals it is the one of the longest wavelength; `None`
/// without levels.
#[must_use]
pub fn setting_level<'l>(model: &StackedModel, levels: &'l [Level]) -> Option<(&'l Level, f64)> {
    let scale = |level: &Level| Scale { wavelength_m: level.wavelength_m, amplitude_m: level.amplitude_m };
    let pressed = levels.iter().map(|level| (scale(level), level.yield_strength_pa));
    largest_full_contact(model, pressed).map(|(index, pressure_pa)| (&levels[index], pressure_pa))
}

/// Index of the scale, each with its strength \[Pa\], that takes the highest pressure to flatten, and that pressure
/// \[Pa\].
fn largest_full_contact(
    model: &StackedModel,
    scales: impl IntoIterator<Item = (Scale, Option<f64>)>,
) -> Option<(usize, f64)> {
    let mut largest: Option<(usize, f64)> = None;
    for (index, (scale, strength_pa)) in scales.into_iter().enumerate() {
        let known_pa = largest.map_or(0.0, |(_, pressure_pa)| pressure_pa);
        let pressure_pa = match (model, strength_pa) {
            (StackedModel::ElasticPlastic { pair, area, .. }, Some(strength_pa)) => {
                let sinusoid = ElasticPlasticSinusoid::new(pair, scale.aspect_ratio(), strength_pa);
                // The pressure at which the blended fit is complete has to be searched for, and lies below this one.
                let complete_pa = sinusoid.complete_contact_pressure_pa();
                match area {
                    _ if complete_pa <= known_pa => continue,
                    YieldingAreaLaw::Blended => sinusoid.flattening_pressure_pa(),
                    YieldingAreaLaw::ElasticShape => complete_pa,
                }
            }
            (StackedModel::Elastic { pair } | StackedModel::ElasticPlastic { pair, .. }, _) => {
                ElasticSinusoid::new(pair, scale.aspect_ratio()).complete_contact_pressure_pa()
            }
        };
        if pressure_pa > known_pa {
            largest = Some((index, pressure_pa));
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::levels;
    use asperity::{ElasticBody, MaterialPair, NixGao};

    /// `per_decade` scales of a stack whose aspect ratio peaks at 10 nm.
    fn scales(per_decade: u32) -> impl Iterator<Item = Scale> + Clone {
        (0..=5 * per_decade).map(move |i| {
            let wavelength_m = 1e-4 * 10f64.powf(-f64::from(i) / f64::from(per_decade));
            let decades_off_peak = (wavelength_m / 1e-8).log10();
            Scale { wavelength_m, amplitude_m: wavelength_m * 0.04 * (-0.2 * decades_off_peak.powi(2)).exp() }
        })
    }

    #[test]
    fn the_real_pressure_stays_below_the_limit_and_nears_it_as_scales_get_denser() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
        let strength = NixGao::constant(1.8e9).unwrap();
        for model in [
            StackedModel::Elastic { pair },
            StackedModel::ElasticPlastic { pair, strength, area: Default::default() },
        ] {
            let share = |per_decade| {
                let limit = largest_full_contact_pressure_pa(&model, scales(per_decade)).unwrap();
                levels(&model, 1e6, scales(per_decade)).last().unwrap().real_pressure_pa / limit
            };
            let shares = [3, 10, 100, 3000].map(share);
            assert!(shares.is_sorted() && shares[3] <= 1.0 + 1e-12, "{shares:?}");
            assert!(shares[3] > 0.98, "{shares:?}");
        }
    }

    #[test]
    fn no_limit_is_claimed_where_the_strength_depends_on_depth() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
        let strength = NixGao::constant(1.8e9).unwrap().with_strain_gradient(5e-6).unwrap();
        let model = StackedModel::ElasticPlastic { pair, strength, area: Default::default() };
        assert_eq!(largest_full_contact_pressure_pa(&model, scales(10)), None);
        assert_eq!(largest_full_contact_pressure_pa(&StackedModel::Elastic { pair }, []), None);
    }

    #[test]
    fn the_setting_level_is_the_steepest_and_carries_the_limit() {
        let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
        let strength = NixGao::constant(1.8e9).unwrap();
        let gradient = strength.with_strain_gradient(5e-6).unwrap();
        for model in [
            StackedModel::Elastic { pair },
            StackedModel::ElasticPlastic { pair, strength, area: Default::default() },
            StackedModel::ElasticPlastic { pair, strength, area: YieldingAreaLaw::ElasticShape },
            StackedModel::ElasticPlastic { pair, strength: gradient, area: Default::default() },
        ] {
            let curve: Vec<Level> = levels(&model, 1e6, scales(10)).collect();
            let (level, pressure_pa) = setting_level(&model, &curve).unwrap();
            assert!((level.wavelength_m / 1e-8 - 1.0).abs() < 1e-9, "{}", level.wavelength_m);
            let limit = largest_full_contact_pressure_pa(&model, scales(10));
            assert!(limit.is_none_or(|limit_pa| limit_pa == pressure_pa));
            assert!(curve.last().unwrap().real_pressure_pa <= pressure_pa);
        }
        assert_eq!(setting_level(&StackedModel::Elastic { pair }, &[]), None);
    }
}
