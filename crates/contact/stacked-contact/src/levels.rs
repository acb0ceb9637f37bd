//! Levels of a stack, scale by scale: Archard (1957); Ciavarella & Demelio (2001); Jackson & Streator (2006).

use crate::descent::{Descent, Step};
use crate::{Level, Scale, StackedModel};

/// Returns the levels of a stack under a nominal pressure p > 0 \[Pa\], computed lazily.
///
/// The scales come from long to short wavelengths.
pub fn levels(
    model: &StackedModel,
    nominal_pressure_pa: f64,
    scales: impl IntoIterator<Item = Scale>,
) -> impl Iterator<Item = Level> {
    let mut descent = Descent::new(model, nominal_pressure_pa);
    scales.into_iter().map(move |scale| descent.level_below(&mut Step::new(scale)))
}

/// Returns the levels of a stack under each of the nominal pressures p > 0 \[Pa\], computed lazily: those of the
/// first scale in the order of the pressures, then those of the second, and so on. The digits are those of
/// [`levels`], but the work that the loads share is done once.
pub fn levels_under_loads(
    model: &StackedModel,
    nominal_pressures_pa: &[f64],
    scales: impl IntoIterator<Item = Scale>,
) -> impl Iterator<Item = Level> {
    let mut descents: Vec<Descent> =
        nominal_pressures_pa.iter().map(|&pressure_pa| Descent::new(model, pressure_pa)).collect();
    let mut steps = scales.into_iter().map(Step::new);
    let (mut step, mut load) = (None, descents.len());
    std::iter::from_fn(move || {
        if load == descents.len() {
            (step, load) = (steps.next(), 0);
        }
        let level = descents.get_mut(load)?.level_below(step.as_mut()?);
        load += 1;
        Some(level)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Regime, YieldingAreaLaw};
    use asperity::{ElasticBody, MaterialPair, NixGao};

    fn pair() -> MaterialPair {
        MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap())
    }

    /// A self-affine stack: 60 scales, ten per decade, Hurst exponent 0.8 above 100 nm and 0.3 below.
    fn scales() -> impl Iterator<Item = Scale> + Clone {
        (0..60).map(|i| {
            let wavelength_m = 1e-3 * 10f64.powf(-f64::from(i) / 10.0);
            let hurst_exponent = if wavelength_m > 1e-7 { 0.8 } else { 0.3 };
            Scale { wavelength_m, amplitude_m: 2e-9 * (wavelength_m / 1e-7).powf(hurst_exponent) }
        })
    }

    fn models() -> [StackedModel; 5] {
        let constant = NixGao::constant(1.8e9).unwrap();
        let gradient = constant.with_strain_gradient(5e-6).unwrap();
        let yielding = |strength, area| StackedModel::ElasticPlastic { pair: pair(), strength, area };
        let of = |area| [constant, gradient].map(|strength| yielding(strength, area));
        let [[blended, growing], shapes] = [YieldingAreaLaw::Blended, YieldingAreaLaw::ElasticShape].map(of);
        [StackedModel::Elastic { pair: pair() }, blended, growing, shapes[0], shapes[1]]
    }

    #[test]
    fn load_is_conserved_and_the_area_only_shrinks() {
        for model in models() {
            let curve: Vec<Level> = levels(&model, 5.4e6, scales()).collect();
            assert!(curve.is_sorted_by(|a, b| a.area_fraction >= b.area_fraction));
            for level in &curve {
                assert!((level.area_fraction * level.real_pressure_pa / 5.4e6 - 1.0).abs() < 1e-14);
                assert_eq!(level.regime == Regime::Flattened, level.real_pressure_pa == level.pressure_in_pa);
            }
        }
    }

    #[test]
    fn cutting_the_stack_short_gives_the_same_levels() {
        for model in models() {
            let whole: Vec<Level> = levels(&model, 5.4e5, scales()).collect();
            let short: Vec<Level> = levels(&model, 5.4e5, scales().take(17)).collect();
            assert_eq!(whole[..17], short);
        }
    }

    #[test]
    fn loads_taken_together_give_the_digits_of_each_alone() {
        let loads_pa = [5.4e3, 5.4e5, 5.4e7, 5.4e9, 1e12];
        for model in models() {
            let together: Vec<Level> = levels_under_loads(&model, &loads_pa, scales()).collect();
            for (load, &load_pa) in loads_pa.iter().enumerate() {
                let of_load = together.iter().skip(load).step_by(loads_pa.len()).copied();
                assert!(of_load.eq(levels(&model, load_pa, scales())), "{model:?} {load_pa}");
            }
            assert_eq!(levels_under_loads(&model, &[], scales()).count(), 0);
        }
    }

    #[test]
    fn only_the_scales_asked_for_are_computed() {
        let mut drawn = 0;
        let counted = scales().inspect(|_| drawn += 1);
        assert_eq!(levels(&models()[1], 5.4e6, counted).take(3).count(), 3);
        assert_eq!(drawn, 3);
        let counted = scales().inspect(|_| drawn += 1);
        assert_eq!(levels_under_loads(&models()[1], &[5.4e6, 5.4e7], counted).take(4).count(), 4);
        assert_eq!(drawn, 3 + 2);
    }

    #[test]
    fn a_pressure_beyond_every_scale_flattens_them_all() {
        for model in models() {
            assert!(levels(&model, 1e13, scales()).all(|level| level.regime == Regime::Flattened));
            assert!(levels(&model, 1e13, scales()).all(|level| level.area_fraction == 1.0));
        }
    }

    #[test]
    fn plastic_flow_enlarges_the_area_and_a_growing_strength_takes_it_back() {
        let last = |model| levels(&model, 5.4e6, scales()).last().unwrap().area_fraction;
        let [elastic, plastic, gradient, ..] = models().map(last);
        assert!(plastic > gradient && gradient >= elastic, "{plastic} > {gradient} >= {elastic}");
    }

    #[test]
    fn the_first_scale_has_the_macroscopic_strength_and_the_others_a_higher_one() {
        let curve: Vec<Level> = levels(&models()[2], 5.4e6, scales()).collect();
        assert_eq!(curve[0].yield_strength_pa, Some(1.8e9));
        assert!(curve[1..].iter().all(|level| level.yield_strength_pa > Some(1.8e9)));
        assert!(levels(&models()[0], 5.4e6, scales()).all(|level| level.yield_strength_pa.is_none()));
    }

    proptest::proptest! {
        #[test]
        fn pressures_scale_with_the_moduli(factor in 1e-3..1e3f64, pressure_pa in 1e3..1e10f64) {
            let scaled = |factor: f64| {
                let pair = MaterialPair::against_rigid(ElasticBody::new(463e9 * factor, 0.2).unwrap());
                let strength = NixGao::constant(1.8e9 * factor).unwrap();
                let model = StackedModel::ElasticPlastic { pair, strength, area: Default::default() };
                levels(&model, pressure_pa * factor, scales()).last().unwrap()
            };
            let (one, other) = (scaled(1.0), scaled(factor));
            proptest::prop_assert!((one.area_fraction / other.area_fraction - 1.0).abs() < 1e-9);
        }

        #[test]
        fn the_final_area_grows_with_the_load(pressure_pa in 1e3..1e9f64, factor in 1.01..10.0f64) {
            for model in models() {
                let area = |p| levels(&model, p, scales()).last().unwrap().area_fraction;
                proptest::prop_assert!(area(pressure_pa * factor) > area(pressure_pa) * (1.0 - 1e-3));
            }
        }
    }
}
