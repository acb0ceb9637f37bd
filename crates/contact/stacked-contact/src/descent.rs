//! Descent through a stack under one load.
//!
//! Level i has the area A_i = A_{i-1} phi(p_i; B_i), and passes the pressure p_{i+1} = p_i/phi_i on. Pressure times
//! area is the load, so A_i/A_n is the nominal pressure over p_{i+1}. Computed from there, it does not accumulate the
//! rounding of a product over all levels, and the pressure itself forgets its rounding on the way.
//!
//! The pressure only rises, and a flatter scale takes less of it to come into complete contact. So a scale that is no
//! steeper than one known to be flattened costs a comparison only.

use asperity::{ElasticPlasticSinusoid, ElasticSinusoid, NixGao, YieldingArea};

use crate::{Level, Regime, Scale, StackedModel, YieldingAreaLaw};

/// Aspect ratio over the critical one up to which a steeper scale of the same strength takes more pressure to
/// flatten. Beyond r = 4600 (nu = -1) to 5200 (nu = 1/2) it takes less, because the fitted area overshoots.
const STEEPER_IS_HARDER_TO_FLATTEN_UP_TO: f64 = 4000.0;

/// Scale, with the part of its response that several loads share.
pub(crate) struct Step {
    scale: Scale,
    aspect_ratio: f64,
    /// Area at a strength that does not depend on the load, computed once a load makes the scale yield.
    yielding_area: Option<YieldingArea>,
}

impl Step {
    pub fn new(scale: Scale) -> Self {
        Step { scale, aspect_ratio: scale.aspect_ratio(), yielding_area: None }
    }
}

/// Stack under one load, on the way from long to short wavelengths.
pub(crate) struct Descent<'m> {
    model: &'m StackedModel,
    nominal_pressure_pa: f64,
    /// Mean pressure \[Pa\] on the contact so far.
    pressure_pa: f64,
    /// Largest aspect ratio of the scales known to be in complete contact. Never falls.
    flattened_up_to: f64,
    /// Ratio p*/B \[Pa\]: this times an aspect ratio flattens it at any strength.
    complete_pressure_over_aspect_ratio_pa: f64,
    /// Depth \[m\] to which the scale above has been pressed, on which the strength may depend.
    depth_above_m: f64,
}

impl<'m> Descent<'m> {
    /// Starts above the first scale, under a nominal pressure p > 0 \[Pa\].
    pub fn new(model: &'m StackedModel, nominal_pressure_pa: f64) -> Self {
        debug_assert!(nominal_pressure_pa > 0.0);
        let (StackedModel::Elastic { pair } | StackedModel::ElasticPlastic { pair, .. }) = model;
        let complete_pressure_over_aspect_ratio_pa =
            ElasticSinusoid::new(pair, 1.0).complete_contact_pressure_pa();
        Descent {
            model,
            nominal_pressure_pa,
            pressure_pa: nominal_pressure_pa,
            flattened_up_to: nominal_pressure_pa / complete_pressure_over_aspect_ratio_pa,
            complete_pressure_over_aspect_ratio_pa,
            // The first scale has nothing above it and meets the macroscopic strength.
            depth_above_m: f64::INFINITY,
        }
    }

    /// True if every scale of at most this aspect ratio is known to be in complete contact.
    pub fn flattens(&self, aspect_ratio: f64) -> bool {
        aspect_ratio <= self.flattened_up_to
    }

    /// Presses one more scale, and returns the level below it.
    pub fn level_below(&mut self, step: &mut Step) -> Level {
        let pressure_in_pa = self.pressure_pa;
        let (yield_strength_pa, aspect_ratio_over_critical) = match self.model {
            StackedModel::Elastic { .. } => (None, None),
            StackedModel::ElasticPlastic { pair, strength, .. } => {
                let strength_pa = strength.at_depth_pa(self.depth_above_m);
                let sinusoid = ElasticPlasticSinusoid::new(pair, step.aspect_ratio, strength_pa);
                (Some(strength_pa), Some(sinusoid.aspect_ratio_over_critical()))
            }
        };
        let regime = self.press(step);
        Level {
            wavelength_m: step.scale.wavelength_m,
            amplitude_m: step.scale.amplitude_m,
            pressure_in_pa,
            real_pressure_pa: self.pressure_pa,
            area_fraction: self.nominal_pressure_pa / self.pressure_pa,
            yield_strength_pa,
            aspect_ratio_over_critical,
            regime,
        }
    }

    /// Presses one more scale, whose loss of area raises the pressure.
    pub fn press(&mut self, step: &mut Step) -> Regime {
        if self.flattens(step.aspect_ratio) {
            self.pass_flattened(step.scale);
            return Regime::Flattened;
        }
        let (area_fraction, regime) = match self.model {
            StackedModel::Elastic { pair } => {
                let sinusoid = ElasticSinusoid::new(pair, step.aspect_ratio);
                (sinusoid.area_fraction(self.pressure_pa), Regime::Elastic)
            }
            StackedModel::ElasticPlastic { pair, strength, area } => {
                let strength_pa = strength.at_depth_pa(self.depth_above_m);
                let sinusoid = ElasticPlasticSinusoid::new(pair, step.aspect_ratio, strength_pa);
                let yields = sinusoid.yields_at(self.pressure_pa);
                let area_fraction = self.press_sinusoid(&sinusoid, strength, *area, step);
                (area_fraction, if yields { Regime::Plastic } else { Regime::Elastic })
            }
        };
        if area_fraction == 1.0 {
            return Regime::Flattened;
        }
        self.pressure_pa /= area_fraction;
        self.flattened_from(self.pressure_pa / self.complete_pressure_over_aspect_ratio_pa);
        regime
    }

    /// Passes scales that are all flattened, given the last of them: they change only the depth above.
    pub fn pass_flattened(&mut self, last: Scale) {
        self.depth_above_m = last.amplitude_m;
    }

    /// Area fraction of a scale that may yield. If the strength depends on the depth, the depth of the scale is kept
    /// for the next one; if not, all scales flatter than a flattened one are known to be flattened.
    #[inline]
    fn press_sinusoid(
        &mut self,
        sinusoid: &ElasticPlasticSinusoid,
        strength: &NixGao,
        area: YieldingAreaLaw,
        step: &mut Step,
    ) -> f64 {
        let has_elastic_shape = area == YieldingAreaLaw::ElasticShape && sinusoid.yields_at(self.pressure_pa);
        let elastic_shape = || sinusoid.softened().area_fraction(self.pressure_pa);
        if strength.strain_gradient_length_m().is_some() {
            let (blended, deformation) = sinusoid.area_and_deformation(self.pressure_pa);
            self.depth_above_m = step.scale.amplitude_m * deformation;
            return if has_elastic_shape { elastic_shape() } else { blended };
        }
        let area_fraction = if has_elastic_shape {
            elastic_shape()
        } else if sinusoid.yields_at(self.pressure_pa) {
            step.yielding_area.get_or_insert_with(|| sinusoid.yielding_area()).fraction_at(self.pressure_pa)
        } else {
            sinusoid.elastic().area_fraction(self.pressure_pa)
        };
        let steeper_is_harder = sinusoid.aspect_ratio_over_critical() <= STEEPER_IS_HARDER_TO_FLATTEN_UP_TO;
        if area_fraction == 1.0 && steeper_is_harder {
            self.flattened_from(step.aspect_ratio);
        }
        area_fraction
    }

    /// Records that scales of at most this aspect ratio are in complete contact.
    fn flattened_from(&mut self, aspect_ratio: f64) {
        self.flattened_up_to = self.flattened_up_to.max(aspect_ratio);
    }
}
