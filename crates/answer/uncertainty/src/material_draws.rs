//! Draws of the material within its uncertainties.

use asperity::{ElasticBody, MaterialPair, NixGao};
use chacha20::rand_core::Rng;
use rand_distr::{Beta, Distribution, StandardNormal, StandardUniform};
use scene::Scene;
use study::bodies::Body;
use study::material_spreads::MaterialSpreads;
use study::models::CurveModel;
use study::spread::{LARGEST_POISSON_RATIO, Spread};

/// The uncertain material of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialDraws {
    spreads: MaterialSpreads,
    pair: MaterialPair,
    counterface: Option<ElasticBody>,
    flows: Body,
}

/// A drawn material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnMaterial {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The ratio of yield strength and hardness to those of the plain run.
    pub strength_over_centre: f64,
    /// The strain-gradient length \[m\]; if absent, that of the plain run.
    pub strain_gradient_length_m: Option<f64>,
}

impl MaterialDraws {
    /// The material of a scene; `None` if it is exact.
    #[must_use]
    pub fn from_scene(scene: &Scene) -> Option<Self> {
        let material = scene.material.as_ref().filter(|_| !scene.spreads.is_empty())?;
        Some(MaterialDraws {
            spreads: scene.spreads.clone(),
            pair: material.pair,
            counterface: material.counterface(),
            flows: material.flows(),
        })
    }

    /// True if an elastic constant of a body is uncertain.
    #[must_use]
    pub fn elastic_scatters(&self) -> bool {
        !self.spreads.elastic_are_exact()
    }

    /// True if the strength or the strain-gradient length is uncertain.
    #[must_use]
    pub fn strength_scatters(&self) -> bool {
        self.spreads.strength.is_some() || self.spreads.strain_gradient_length.is_some()
    }

    /// Draws a material: elastic constants from one stream, strength and strain-gradient length from the other, each in
    /// a fixed order.
    pub fn draw(&self, elastic: &mut impl Rng, strength: &mut impl Rng) -> DrawnMaterial {
        let spreads = &self.spreads;
        let body = drawn_body(self.pair.body(), &spreads.youngs_modulus, &spreads.poisson_ratio, elastic);
        let counterface = self.counterface.map(|counterface| {
            drawn_body(
                counterface,
                &spreads.counterface_youngs_modulus,
                &spreads.counterface_poisson_ratio,
                elastic,
            )
        });
        DrawnMaterial {
            pair: self.flows.pair(body, counterface).bonded(self.pair.layer()),
            strength_over_centre: drawn(&spreads.strength, strength).unwrap_or(1.0),
            strain_gradient_length_m: drawn(&spreads.strain_gradient_length, strength),
        }
    }
}

impl DrawnMaterial {
    /// Returns the model with this material. A cap of the strength is kept, and raised if it is below the drawn
    /// strength.
    #[must_use]
    pub fn apply(&self, model: &CurveModel) -> CurveModel {
        let moved = model.with_pair(self.pair);
        let strength = moved.strength().and_then(|plain| self.strength(plain));
        strength.and_then(|strength| moved.with_strength(strength)).unwrap_or(moved)
    }

    /// The drawn strength in place of a plain one; `None` out of the range of magnitudes.
    fn strength(&self, plain: NixGao) -> Option<NixGao> {
        let strength_pa = self.strength_over_centre * plain.macroscopic_strength_pa();
        let mut strength = NixGao::constant(strength_pa).ok()?;
        if let Some(length_m) = plain.strain_gradient_length_m() {
            strength =
                strength.with_strain_gradient(self.strain_gradient_length_m.unwrap_or(length_m)).ok()?;
        }
        match plain.cap_pa() {
            Some(cap_pa) => strength.with_cap(cap_pa.max(strength_pa)).ok(),
            None => Some(strength),
        }
    }
}

/// Draws a body in place of a plain one. Returns the plain one if the draw leaves the range of magnitudes, which the
/// bounds of spreads prevent.
fn drawn_body(
    plain: ElasticBody,
    youngs_modulus: &Option<Spread>,
    poisson_ratio: &Option<Spread>,
    stream: &mut impl Rng,
) -> ElasticBody {
    let modulus_pa = drawn(youngs_modulus, stream).unwrap_or(plain.youngs_modulus_pa());
    let ratio = drawn(poisson_ratio, stream).unwrap_or(plain.poisson_ratio());
    ElasticBody::new(modulus_pa, ratio).unwrap_or(plain)
}

/// Draws from a spread, if there is one.
fn drawn(spread: &Option<Spread>, stream: &mut impl Rng) -> Option<f64> {
    let evenly = |stream: &mut _| -> f64 { StandardUniform.sample(stream) };
    Some(match spread.as_ref()? {
        Spread::LogNormal { median, sigma_ln } => {
            let normal: f64 = StandardNormal.sample(stream);
            median * (sigma_ln * normal).exp()
        }
        Spread::Beta { alpha, beta, .. } => {
            LARGEST_POISSON_RATIO * Beta::new(*alpha, *beta).ok()?.sample(stream)
        }
        Spread::Uniform { from, to } => from + (to - from) * evenly(stream),
        Spread::Values(values) => {
            let at = (evenly(stream) * values.len() as f64) as usize;
            *values.get(at).or(values.last())?
        }
    })
}
