//! Mean gap and stiffness of contact that flows at a constant hardness.
//!
//! Between two limits, with the share f of the contact that has flowed ([`constant_hardness`]): the elastic theory
//! ([`separation`](crate::separation)) at f = 0, and the bent surface that the other body cuts at f = 1. A mean gap is (1 - f) times the elastic
//! one and f times the lower of both, since each leaves out what the other closes; the distance of the mean planes is
//! mixed alike. Stiffnesses of both kinds of contact add like K^2 = K_el^2 + f K_fl^2, which holds in both limits, and within the table of
//! `docs/develop/trials.md` between them.

use std::sync::OnceLock;

use crate::constant_hardness;
use crate::flowed_surface::{FlowedSurface, Waves};
use crate::separation::{Separation, SeparationLaw};

/// Separation of a rough surface from a flat where peaks flow at a constant hardness.
#[derive(Debug, Clone)]
pub struct YieldingLaw {
    elastic: SeparationLaw,
    spread_pa: f64,
    /// Waves of the surface; none on a layer, where the elastic theory stays.
    waves: Option<Waves>,
}

/// Factor of the stiffness of spots that have flowed, which draws of nearly the same surface and load share.
pub type SpotFactor = OnceLock<f64>;

/// Gap of bodies whose contact has flowed in part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldedGap {
    /// Mean of the open gap over the nominal area \[m\].
    pub mean_gap_m: f64,
    /// Distance of the mean planes of the undeformed faces \[m\]: less than the mean gap by the mean depth that has flowed.
    pub mean_plane_distance_m: f64,
}

/// Gap and stiffness of bodies whose contact has flowed in part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldedSeparation {
    /// The gap.
    pub gap: YieldedGap,
    /// Stiffness of unloading, which conducts heat and current \[Pa/m\].
    pub unloading_stiffness_pa_per_m: f64,
}

impl From<Separation> for YieldedSeparation {
    fn from(elastic: Separation) -> Self {
        let Separation { mean_gap_m, stiffness_pa_per_m } = elastic;
        YieldedSeparation {
            gap: YieldedGap { mean_gap_m, mean_plane_distance_m: mean_gap_m },
            unloading_stiffness_pa_per_m: stiffness_pa_per_m,
        }
    }
}

/// Elastic contact, and the share of it that has flowed with the surface of contact that has flowed altogether.
struct Limits<'w> {
    elastic: Separation,
    flowed: Option<(f64, FlowedSurface<'w>)>,
}

impl YieldingLaw {
    /// Creates the law from that of elastic contact, with the spread of the pressure that would flatten the surface \[Pa\].
    #[must_use]
    pub fn new(elastic: &SeparationLaw, spread_pa: f64) -> Self {
        YieldingLaw { elastic: elastic.clone(), spread_pa, waves: Waves::from_law(elastic) }
    }

    /// Computes the gap under a nominal pressure p > 0 \[Pa\] at a hardness H > 0 \[Pa\]; `None` for p >= H, where everything touches and
    /// flows.
    #[must_use]
    pub fn gap(&self, pressure_pa: f64, hardness_pa: f64) -> Option<YieldedGap> {
        Some(self.limits(pressure_pa, hardness_pa)?.gap())
    }

    /// Computes gap and stiffness under a nominal pressure p > 0 \[Pa\] at a hardness H > 0 \[Pa\]; `None` for p >= H. An empty spot
    /// factor is computed.
    #[must_use]
    pub fn at(&self, pressure_pa: f64, hardness_pa: f64, spots: &SpotFactor) -> Option<YieldedSeparation> {
        let limits = self.limits(pressure_pa, hardness_pa)?;
        let of_flowed = |(share, surface): &(f64, FlowedSurface<'_>)| {
            let factor = spots.get_or_init(|| surface.spot_factor());
            share.sqrt() * factor * self.elastic.contact_modulus_pa() * surface.stiffness_scale_per_m()
        };
        let of_flowed_pa_per_m = limits.flowed.as_ref().map_or(0.0, of_flowed);
        Some(YieldedSeparation {
            gap: limits.gap(),
            unloading_stiffness_pa_per_m: limits.elastic.stiffness_pa_per_m.hypot(of_flowed_pa_per_m),
        })
    }

    fn limits(&self, pressure_pa: f64, hardness_pa: f64) -> Option<Limits<'_>> {
        if pressure_pa >= hardness_pa {
            return None;
        }
        let share = constant_hardness::areas(pressure_pa, self.spread_pa, hardness_pa).plastic_share();
        let flowed = self.waves.as_ref().filter(|_| share > 0.0).map(|waves| {
            let modulus_pa = self.elastic.contact_modulus_pa();
            (share, waves.flowed(pressure_pa / hardness_pa, hardness_pa / modulus_pa))
        });
        Some(Limits { elastic: self.elastic.whole(pressure_pa), flowed })
    }
}

impl Limits<'_> {
    fn gap(&self) -> YieldedGap {
        let elastic_m = self.elastic.mean_gap_m;
        let Some((share, surface)) = &self.flowed else {
            return YieldedGap { mean_gap_m: elastic_m, mean_plane_distance_m: elastic_m };
        };
        let mixed = |flowed_m: f64| (1.0 - share) * elastic_m + share * elastic_m.min(flowed_m);
        YieldedGap {
            mean_gap_m: mixed(surface.mean_gap_m()),
            mean_plane_distance_m: mixed(surface.mean_plane_distance_m()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EnergyFactor;
    use crate::excursion::mean_depth_below;
    use crate::separation::SeparationKnot;

    use numerics::gaussian::level_of_share;

    const MODULUS_PA: f64 = 1e11;

    /// V ~ q^0.4 over two decades of wavevectors: the elastic law, the spread of its pressures, and the rms height.
    fn power_law() -> (SeparationLaw, f64, f64) {
        let variance_pa2 = |q: f64| 1e16 * ((q / 1e4).powf(0.4) - 1.0);
        let knot = |at: i32| {
            let wavevector_rad_per_m = 1e4 * 10f64.powf(f64::from(at) / 10.0);
            let variance_pa2 = variance_pa2(wavevector_rad_per_m);
            SeparationKnot { wavevector_rad_per_m, variance_pa2, variance_exponent: 0.4 }
        };
        let knots: Vec<SeparationKnot> = (0..=20).map(knot).collect();
        let elastic = SeparationLaw::new(&knots, MODULUS_PA, EnergyFactor::ALMQVIST);
        let mean_square_m2 = 4.0 * 1e16 / 1e22 * (0.4 / 1.6) / 1e8 * (1.0 - 100f64.powf(-1.6));
        (elastic, variance_pa2(1e6).sqrt(), mean_square_m2.sqrt())
    }

    fn at(law: &YieldingLaw, pressure_pa: f64, hardness_pa: f64) -> YieldedSeparation {
        law.at(pressure_pa, hardness_pa, &SpotFactor::new()).unwrap()
    }

    #[test]
    fn bodies_too_hard_to_flow_have_the_elastic_gap_and_stiffness() {
        let (elastic, spread_pa, _) = power_law();
        let law = YieldingLaw::new(&elastic, spread_pa);
        for share in [1e-4, 0.03, 0.8, 1.5] {
            let (found, known) =
                (at(&law, share * spread_pa, 12.0 * spread_pa), elastic.whole(share * spread_pa));
            assert!((found.gap.mean_gap_m / known.mean_gap_m - 1.0).abs() < 1e-10, "{share}");
            assert!((found.gap.mean_plane_distance_m / known.mean_gap_m - 1.0).abs() < 1e-10, "{share}");
            let stiffness = found.unloading_stiffness_pa_per_m / known.stiffness_pa_per_m;
            assert!((stiffness - 1.0).abs() < 1e-10, "{share}: {stiffness}");
        }
    }

    #[test]
    fn soft_bodies_have_the_gap_of_a_surface_whose_tops_are_cut_off() {
        let (elastic, spread_pa, rms_height_m) = power_law();
        let law = YieldingLaw::new(&elastic, spread_pa);
        let hardness_pa = 1e-7 * spread_pa;
        for share in [1e-3, 0.02, 0.3, 0.9] {
            let found = at(&law, share * hardness_pa, hardness_pa);
            let level = level_of_share(share);
            let off = found.gap.mean_gap_m / (rms_height_m * mean_depth_below(level)) - 1.0;
            assert!(off.abs() < 1e-6, "{share}: {off}");
            assert!((found.gap.mean_plane_distance_m - rms_height_m * level).abs() < 1e-6 * rms_height_m);
            let areas = constant_hardness::areas(share * hardness_pa, spread_pa, hardness_pa);
            assert!((areas.plastic / share - 1.0).abs() < 1e-12 && areas.elastic < 1e-12);
        }
        assert_eq!(law.at(hardness_pa, hardness_pa, &SpotFactor::new()), None);
    }

    #[test]
    fn more_load_closes_the_gap_and_stiffens_the_contact_at_every_hardness() {
        let (elastic, spread_pa, _) = power_law();
        let law = YieldingLaw::new(&elastic, spread_pa);
        for hardness in [0.01, 0.1, 0.4, 1.0, 2.0, 5.0].map(|share| share * spread_pa) {
            let loads = (0..40).map(|step| 1e-4 * 1.26f64.powi(step)).filter(|share| *share < 0.9);
            let found: Vec<YieldedSeparation> =
                loads.map(|share| at(&law, share * hardness, hardness)).collect();
            for pair in found.windows(2) {
                assert!(pair[1].gap.mean_gap_m < pair[0].gap.mean_gap_m, "{hardness} {pair:?}");
                assert!(
                    pair[1].gap.mean_plane_distance_m < pair[0].gap.mean_plane_distance_m,
                    "{hardness} {pair:?}"
                );
                let stiffer = pair[1].unloading_stiffness_pa_per_m / pair[0].unloading_stiffness_pa_per_m;
                assert!(stiffer > 1.0, "{hardness} {pair:?}");
            }
        }
    }
}
