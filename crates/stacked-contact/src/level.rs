//! The stack itself: Archard (1957); Ciavarella & Demelio (2001); Jackson & Streator (2006).
//!
//! Level i has the area A_i = A_{i-1} phi(p_i; B_i), and hands the pressure p_{i+1} = p_i/phi_i on. Since pressure
//! times area is the load, A_i/A_n is the nominal pressure over p_{i+1}: taken from there, it does not gather the
//! rounding of a product over all levels, and the pressure itself forgets its rounding as it goes.

use asperity::{ElasticPlasticSinusoid, ElasticSinusoid, MaterialPair, NixGao};

use crate::StackedModel;

/// One wavelength of the roughness.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Scale {
    /// Wavelength lambda > 0 \[m\].
    pub wavelength_m: f64,
    /// Amplitude Delta > 0 \[m\] of the sinusoid that stands for it.
    pub amplitude_m: f64,
}

impl Scale {
    /// Aspect ratio B = Delta/lambda, above 0 (Jackson & Jacobs, section 1.6 of `docs/models.md`).
    pub fn aspect_ratio(&self) -> f64 {
        self.amplitude_m / self.wavelength_m
    }
}

/// What a scale does under the pressure that reaches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// It touches in part, without yielding.
    Elastic,
    /// It touches in part, and yields.
    Plastic,
    /// It touches everywhere and changes nothing.
    Flattened,
}

impl Regime {
    /// The regime's name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Regime::Elastic => "elastic",
            Regime::Plastic => "plastic",
            Regime::Flattened => "flattened",
        }
    }
}

/// The contact after one more scale of roughness has been taken into account.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Level {
    /// Wavelength of the scale \[m\].
    pub wavelength_m: f64,
    /// Amplitude of the scale \[m\].
    pub amplitude_m: f64,
    /// Mean pressure \[Pa\] on the contact before this scale.
    pub pressure_in_pa: f64,
    /// Mean pressure \[Pa\] on the contact after this scale, the load over the real area.
    pub real_pressure_pa: f64,
    /// Contact area over nominal area, in (0, 1].
    pub area_fraction: f64,
    /// Yield strength \[Pa\] at this scale; absent in the elastic model, infinite where nothing was deformed above.
    pub yield_strength_pa: Option<f64>,
    /// Aspect ratio over the critical one, r = B/B_c, 0 for an infinite strength; absent in the elastic model. Above
    /// 100 the law is beyond trust.
    pub aspect_ratio_over_critical: Option<f64>,
    /// What the scale does.
    pub regime: Regime,
}

impl approx::AbsDiffEq for Level {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        0.0
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.agrees(other, |a, b| f64::abs_diff_eq(&a, &b, epsilon))
    }
}

impl approx::RelativeEq for Level {
    fn default_max_relative() -> f64 {
        f64::default_max_relative()
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        self.agrees(other, |a, b| f64::relative_eq(&a, &b, epsilon, max_relative))
    }
}

impl Level {
    fn agrees(&self, other: &Self, close: impl Fn(f64, f64) -> bool) -> bool {
        let optional = |pair| match pair {
            (Some(a), Some(b)) => close(a, b),
            (a, b) => a == b,
        };
        let numbers =
            |l: &Self| [l.wavelength_m, l.amplitude_m, l.pressure_in_pa, l.real_pressure_pa, l.area_fraction];
        self.regime == other.regime
            && optional((self.yield_strength_pa, other.yield_strength_pa))
            && optional((self.aspect_ratio_over_critical, other.aspect_ratio_over_critical))
            && numbers(self).into_iter().zip(numbers(other)).all(|(a, b)| close(a, b))
    }
}

/// The levels of a stack under a nominal pressure p > 0 \[Pa\], computed as they are asked for.
///
/// The scales come from long to short wavelengths.
pub fn levels(
    model: &StackedModel,
    nominal_pressure_pa: f64,
    scales: impl IntoIterator<Item = Scale>,
) -> impl Iterator<Item = Level> {
    debug_assert!(nominal_pressure_pa > 0.0);
    let mut response = Response::new(model);
    let mut pressure_pa = nominal_pressure_pa;
    scales.into_iter().map(move |scale| {
        let pressure_in_pa = pressure_pa;
        let Contact { area_fraction, yields, yield_strength_pa, aspect_ratio_over_critical } =
            response.press(scale, pressure_in_pa);
        pressure_pa = pressure_in_pa / area_fraction;
        Level {
            wavelength_m: scale.wavelength_m,
            amplitude_m: scale.amplitude_m,
            pressure_in_pa,
            real_pressure_pa: pressure_pa,
            area_fraction: nominal_pressure_pa / pressure_pa,
            yield_strength_pa,
            aspect_ratio_over_critical,
            regime: match (area_fraction == 1.0, yields) {
                (true, _) => Regime::Flattened,
                (false, true) => Regime::Plastic,
                (false, false) => Regime::Elastic,
            },
        }
    })
}

/// What one scale answers to the pressure on it.
struct Contact {
    area_fraction: f64,
    yields: bool,
    yield_strength_pa: Option<f64>,
    aspect_ratio_over_critical: Option<f64>,
}

/// The model, and what it remembers of the scale above.
enum Response {
    Elastic { pair: MaterialPair },
    ElasticPlastic { pair: MaterialPair, strength: NixGao, next_strength_pa: f64 },
}

impl Response {
    fn new(model: &StackedModel) -> Self {
        match *model {
            StackedModel::Elastic { pair } => Response::Elastic { pair },
            // The first scale has nothing above it: it meets the macroscopic strength.
            StackedModel::ElasticPlastic { pair, strength } => Response::ElasticPlastic {
                pair,
                strength,
                next_strength_pa: strength.macroscopic_strength_pa(),
            },
        }
    }

    fn press(&mut self, scale: Scale, pressure_pa: f64) -> Contact {
        match self {
            Response::Elastic { pair } => Contact {
                area_fraction: ElasticSinusoid::new(pair, scale.aspect_ratio()).area_fraction(pressure_pa),
                yields: false,
                yield_strength_pa: None,
                aspect_ratio_over_critical: None,
            },
            Response::ElasticPlastic { pair, strength, next_strength_pa } => {
                let yield_strength_pa = *next_strength_pa;
                let sinusoid = ElasticPlasticSinusoid::new(pair, scale.aspect_ratio(), yield_strength_pa);
                if strength.strain_gradient_length_m().is_some() {
                    let depth_m = scale.amplitude_m * sinusoid.deformation_over_amplitude(pressure_pa);
                    *next_strength_pa = strength.at_depth_pa(depth_m);
                }
                Contact {
                    area_fraction: sinusoid.area_fraction(pressure_pa),
                    yields: sinusoid.yields_at(pressure_pa),
                    yield_strength_pa: Some(yield_strength_pa),
                    aspect_ratio_over_critical: Some(sinusoid.aspect_ratio_over_critical()),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::ElasticBody;

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

    fn models() -> [StackedModel; 3] {
        let constant = NixGao::constant(1.8e9).unwrap();
        let gradient = constant.with_strain_gradient(5e-6).unwrap();
        [
            StackedModel::Elastic { pair: pair() },
            StackedModel::ElasticPlastic { pair: pair(), strength: constant },
            StackedModel::ElasticPlastic { pair: pair(), strength: gradient },
        ]
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
    fn only_the_scales_asked_for_are_computed() {
        let mut drawn = 0;
        let counted = scales().inspect(|_| drawn += 1);
        assert_eq!(levels(&models()[1], 5.4e6, counted).take(3).count(), 3);
        assert_eq!(drawn, 3);
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
        let [elastic, plastic, gradient] = models().map(last);
        assert!(plastic > gradient && gradient >= elastic, "{plastic} > {gradient} >= {elastic}");
    }

    #[test]
    fn the_first_scale_has_the_macroscopic_strength_and_the_others_a_higher_one() {
        let curve: Vec<Level> = levels(&models()[2], 5.4e6, scales()).collect();
        assert_eq!(curve[0].yield_strength_pa, Some(1.8e9));
        assert!(curve[1..].iter().all(|level| level.yield_strength_pa > Some(1.8e9)));
        assert!(levels(&models()[0], 5.4e6, scales()).all(|level| level.yield_strength_pa.is_none()));
    }

    #[test]
    fn levels_compare_by_relative_tolerance() {
        let level = levels(&models()[1], 5.4e6, scales()).nth(20).unwrap();
        let near = Level { area_fraction: level.area_fraction * (1.0 + 1e-12), ..level };
        approx::assert_relative_eq!(level, near, max_relative = 1e-11);
        approx::assert_relative_ne!(level, near, max_relative = 1e-13);
        approx::assert_relative_ne!(level, Level { regime: Regime::Flattened, ..level }, max_relative = 1.0);
    }

    proptest::proptest! {
        #[test]
        fn pressures_scale_with_the_moduli(factor in 1e-3..1e3f64, pressure_pa in 1e3..1e10f64) {
            let scaled = |factor: f64| {
                let pair = MaterialPair::against_rigid(ElasticBody::new(463e9 * factor, 0.2).unwrap());
                let strength = NixGao::constant(1.8e9 * factor).unwrap();
                let model = StackedModel::ElasticPlastic { pair, strength };
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
