//! The stack itself: Archard (1957); Ciavarella & Demelio (2001); Jackson & Streator (2006).
//!
//! Level i has the area A_i = A_{i-1} phi(p_i; B_i), and hands the pressure p_{i+1} = p_i/phi_i on. Since pressure
//! times area is the load, A_i/A_n is the nominal pressure over p_{i+1}: taken from there, it does not gather the
//! rounding of a product over all levels, and the pressure itself forgets its rounding as it goes.
//!
//! The pressure only rises, and a flatter scale takes less of it to come into complete contact. So a scale that is no
//! steeper than what is flattened already costs a comparison.

use asperity::{ElasticPlasticSinusoid, ElasticSinusoid, MaterialPair, NixGao, YieldingArea};

use crate::{Level, Regime, Scale, StackedModel};

/// Aspect ratio over the critical one up to which a steeper scale of the same strength takes more pressure to flatten.
/// From r = 4600 (nu = -1) to 5200 (nu = 1/2) on it takes less, because the fitted area overshoots.
const STEEPER_IS_HARDER_TO_FLATTEN_UP_TO: f64 = 4000.0;

/// The levels of a stack under a nominal pressure p > 0 \[Pa\], computed as they are asked for.
///
/// The scales come from long to short wavelengths.
pub fn levels(
    model: &StackedModel,
    nominal_pressure_pa: f64,
    scales: impl IntoIterator<Item = Scale>,
) -> impl Iterator<Item = Level> {
    let model = *model;
    let mut descent = Descent::new(&model, nominal_pressure_pa);
    scales.into_iter().map(move |scale| descent.pass(&mut Step::new(&model, scale)))
}

/// The levels of a stack under each of the nominal pressures p > 0 \[Pa\], computed as they are asked for: those of the
/// first scale in the order of the pressures, then those of the second, and so on. The digits are those of [`levels`],
/// but what the loads have in common is computed once.
pub fn levels_under_loads(
    model: &StackedModel,
    nominal_pressures_pa: &[f64],
    scales: impl IntoIterator<Item = Scale>,
) -> impl Iterator<Item = Level> {
    let model = *model;
    let mut descents: Vec<Descent> =
        nominal_pressures_pa.iter().map(|&pressure_pa| Descent::new(&model, pressure_pa)).collect();
    let mut steps = scales.into_iter().map(move |scale| Step::new(&model, scale));
    let mut step = if descents.is_empty() { None } else { steps.next() };
    let mut load = 0;
    std::iter::from_fn(move || {
        if load == descents.len() {
            load = 0;
            step = steps.next();
        }
        let level = descents[load].pass(step.as_mut()?);
        load += 1;
        Some(level)
    })
}

/// A scale, with what it answers to every load.
pub(crate) struct Step {
    scale: Scale,
    aspect_ratio: f64,
    law: Law,
}

/// How a scale deforms.
enum Law {
    Elastic(ElasticSinusoid),
    /// At one strength for all loads; the area of the yielding scale is worked out once a load makes it yield.
    Plastic(ElasticPlasticSinusoid, Option<YieldingArea>),
    /// At the strength that each load has left to it.
    Hardening(MaterialPair, NixGao),
}

impl Step {
    pub fn new(model: &StackedModel, scale: Scale) -> Self {
        let aspect_ratio = scale.aspect_ratio();
        let law = match *model {
            StackedModel::Elastic { pair } => Law::Elastic(ElasticSinusoid::new(&pair, aspect_ratio)),
            StackedModel::ElasticPlastic { pair, strength } => match strength.strain_gradient_length_m() {
                Some(_) => Law::Hardening(pair, strength),
                None => {
                    let strength_pa = strength.macroscopic_strength_pa();
                    Law::Plastic(ElasticPlasticSinusoid::new(&pair, aspect_ratio, strength_pa), None)
                }
            },
        };
        Step { scale, aspect_ratio, law }
    }
}

/// A stack under one load, on the way from long to short wavelengths.
pub(crate) struct Descent {
    nominal_pressure_pa: f64,
    /// Mean pressure \[Pa\] on the contact so far.
    pressure_pa: f64,
    /// Scales of at most this aspect ratio are in complete contact.
    flat_up_to: f64,
    /// p*/B \[Pa\].
    complete_pressure_over_aspect_ratio_pa: f64,
    /// Strength \[Pa\] that the next scale meets; absent in the elastic model.
    next_strength_pa: Option<f64>,
}

impl Descent {
    pub fn new(model: &StackedModel, nominal_pressure_pa: f64) -> Self {
        debug_assert!(nominal_pressure_pa > 0.0);
        let (pair, strength) = match model {
            StackedModel::Elastic { pair } => (pair, None),
            StackedModel::ElasticPlastic { pair, strength } => (pair, Some(strength)),
        };
        let complete_pressure_over_aspect_ratio_pa =
            ElasticSinusoid::new(pair, 1.0).complete_contact_pressure_pa();
        Descent {
            nominal_pressure_pa,
            pressure_pa: nominal_pressure_pa,
            // p >= p*, which no strength raises.
            flat_up_to: nominal_pressure_pa / complete_pressure_over_aspect_ratio_pa,
            complete_pressure_over_aspect_ratio_pa,
            // The first scale has nothing above it.
            next_strength_pa: strength.map(NixGao::macroscopic_strength_pa),
        }
    }

    /// Whether every scale of at most this aspect ratio is in complete contact.
    pub fn flattens(&self, aspect_ratio: f64) -> bool {
        aspect_ratio <= self.flat_up_to
    }

    /// Takes one more scale into account.
    pub fn pass(&mut self, step: &mut Step) -> Level {
        let (pressure_in_pa, yield_strength_pa) = (self.pressure_pa, self.next_strength_pa);
        let Contact { area_fraction, yields, aspect_ratio_over_critical } = self.press(step);
        if area_fraction < 1.0 {
            self.pressure_pa = pressure_in_pa / area_fraction;
            self.flattens_up_to(self.pressure_pa / self.complete_pressure_over_aspect_ratio_pa);
        }
        Level {
            wavelength_m: step.scale.wavelength_m,
            amplitude_m: step.scale.amplitude_m,
            pressure_in_pa,
            real_pressure_pa: self.pressure_pa,
            area_fraction: self.nominal_pressure_pa / self.pressure_pa,
            yield_strength_pa,
            aspect_ratio_over_critical,
            regime: match (area_fraction == 1.0, yields) {
                (true, _) => Regime::Flattened,
                (false, true) => Regime::Plastic,
                (false, false) => Regime::Elastic,
            },
        }
    }

    /// Passes scales that are all in complete contact, given the last of them.
    pub fn pass_flattened(&mut self, model: &StackedModel, last: Scale) {
        if let StackedModel::ElasticPlastic { strength, .. } = model {
            self.next_strength_pa = Some(strength.at_depth_pa(last.amplitude_m));
        }
    }

    fn press(&mut self, step: &mut Step) -> Contact {
        let (pressure_pa, flattened) = (self.pressure_pa, self.flattens(step.aspect_ratio));
        match &mut step.law {
            Law::Elastic(sinusoid) => Contact {
                area_fraction: if flattened { 1.0 } else { sinusoid.area_fraction(pressure_pa) },
                yields: false,
                aspect_ratio_over_critical: None,
            },
            Law::Plastic(sinusoid, yielding_area) => {
                let aspect_ratio_over_critical = Some(sinusoid.aspect_ratio_over_critical());
                if flattened {
                    return Contact { area_fraction: 1.0, yields: false, aspect_ratio_over_critical };
                }
                let yields = sinusoid.yields_at(pressure_pa);
                let area_fraction = if yields {
                    yielding_area.get_or_insert_with(|| sinusoid.yielding_area()).fraction_at(pressure_pa)
                } else {
                    sinusoid.elastic().area_fraction(pressure_pa)
                };
                if area_fraction == 1.0
                    && sinusoid.aspect_ratio_over_critical() <= STEEPER_IS_HARDER_TO_FLATTEN_UP_TO
                {
                    self.flattens_up_to(step.aspect_ratio);
                }
                Contact { area_fraction, yields, aspect_ratio_over_critical }
            }
            Law::Hardening(pair, strength) => {
                let met_pa = self.next_strength_pa.unwrap_or(f64::INFINITY);
                let sinusoid = ElasticPlasticSinusoid::new(pair, step.aspect_ratio, met_pa);
                let (area_fraction, deformation) = if flattened {
                    (1.0, 1.0)
                } else {
                    (sinusoid.area_fraction(pressure_pa), sinusoid.deformation_over_amplitude(pressure_pa))
                };
                self.next_strength_pa = Some(strength.at_depth_pa(step.scale.amplitude_m * deformation));
                Contact {
                    area_fraction,
                    yields: sinusoid.yields_at(pressure_pa),
                    aspect_ratio_over_critical: Some(sinusoid.aspect_ratio_over_critical()),
                }
            }
        }
    }

    fn flattens_up_to(&mut self, aspect_ratio: f64) {
        self.flat_up_to = self.flat_up_to.max(aspect_ratio);
    }
}

/// What one scale answers to the pressure on it.
struct Contact {
    area_fraction: f64,
    yields: bool,
    aspect_ratio_over_critical: Option<f64>,
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
