//! The pressure that a densely sampled stack tends to (Jackson 2010).

use asperity::{ElasticPlasticSinusoid, ElasticSinusoid};

use crate::{Scale, StackedModel};

/// The largest pressure \[Pa\] at which one of the scales is in complete contact: the real pressure never exceeds it
/// and tends to it as the spectrum is sampled more densely, so the area tends to load over this pressure (or to the
/// whole nominal area, where the nominal pressure is higher).
///
/// `None` without scales, and for a strength that depends on depth: it then depends on the load as well.
pub fn largest_full_contact_pressure_pa(
    model: &StackedModel,
    scales: impl IntoIterator<Item = Scale>,
) -> Option<f64> {
    let full_contact_pressure_pa = |scale: Scale| match model {
        StackedModel::Elastic { pair } => {
            Some(ElasticSinusoid::new(pair, scale.aspect_ratio()).complete_contact_pressure_pa())
        }
        StackedModel::ElasticPlastic { strength, .. } if strength.strain_gradient_length_m().is_some() => {
            None
        }
        StackedModel::ElasticPlastic { pair, strength } => {
            let strength_pa = strength.macroscopic_strength_pa();
            Some(
                ElasticPlasticSinusoid::new(pair, scale.aspect_ratio(), strength_pa).flattening_pressure_pa(),
            )
        }
    };
    scales.into_iter().filter_map(full_contact_pressure_pa).reduce(f64::max)
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
        for model in [StackedModel::Elastic { pair }, StackedModel::ElasticPlastic { pair, strength }] {
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
        let model = StackedModel::ElasticPlastic { pair, strength };
        assert_eq!(largest_full_contact_pressure_pa(&model, scales(10)), None);
        assert_eq!(largest_full_contact_pressure_pa(&StackedModel::Elastic { pair }, []), None);
    }
}
