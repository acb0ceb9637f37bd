//! The two bodies in contact, and the coefficients that the laws derive from them.

use std::f64::consts::{PI, SQRT_2};

use crate::elastic_body::ElasticBody;
use crate::layer::{Layer, LayerCompliance};

/// Rough body and the counterface that presses on it; one of them may yield.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct MaterialPair {
    body: ElasticBody,
    #[serde(skip)]
    counterface: Option<ElasticBody>,
    #[serde(skip)]
    layer: Option<Layer>,
    yielding_body: ElasticBody,
    composite_modulus_pa: f64,
    /// Coefficient C = 1.295 exp(0.736 nu) of the body that yields ([`ElasticBody::spherical_yield_coefficient`]).
    #[serde(skip)]
    pub(crate) spherical_yield_coefficient: f64,
    /// The logarithm of C.
    #[serde(skip)]
    pub(crate) log_spherical_yield_coefficient: f64,
    /// Coefficient E* B_c/Sy = sqrt(2)/(3 pi) exp(2 (nu + 1)/3), with B_c the aspect ratio at which a sinusoid first
    /// yields before complete contact (Krithivasan & Jackson 2007).
    #[serde(skip)]
    pub(crate) sinusoidal_yield_coefficient: f64,
}

impl MaterialPair {
    /// Pairs the body with a rigid counterface, which adds no compliance: E* = E/(1 - nu^2).
    #[must_use]
    pub fn against_rigid(body: ElasticBody) -> Self {
        Self::with_composite_modulus(body, None, body, body.plane_strain_modulus_pa())
    }

    /// Pairs the body with an elastic counterface: 1/E* = sum (1 - nu^2)/E over both. Only the body yields.
    #[must_use]
    pub fn against(body: ElasticBody, counterface: ElasticBody) -> Self {
        Self::with_composite_modulus(body, Some(counterface), body, composite_modulus_pa(body, counterface))
    }

    /// Pairs the body with an elastic counterface that yields in its place: E* is that of [`Self::against`], and the
    /// yield criteria take Poisson's ratio of the counterface.
    #[must_use]
    pub fn against_yielding(body: ElasticBody, counterface: ElasticBody) -> Self {
        Self::with_composite_modulus(
            body,
            Some(counterface),
            counterface,
            composite_modulus_pa(body, counterface),
        )
    }

    fn with_composite_modulus(
        body: ElasticBody,
        counterface: Option<ElasticBody>,
        yielding_body: ElasticBody,
        composite_modulus_pa: f64,
    ) -> Self {
        let nu = yielding_body.poisson_ratio();
        MaterialPair {
            body,
            counterface,
            layer: None,
            yielding_body,
            composite_modulus_pa,
            spherical_yield_coefficient: yielding_body.spherical_yield_coefficient(),
            log_spherical_yield_coefficient: 1.295f64.ln() + 0.736 * nu,
            sinusoidal_yield_coefficient: SQRT_2 / (3.0 * PI) * (2.0 * (nu + 1.0) / 3.0).exp(),
        }
    }

    /// Returns the pair with its rough body as a layer, if there is one: of its own material, with the thickness and on the base
    /// of `layer`. E* stays that of the rough body's material and the counterface, which short waves feel.
    #[must_use]
    pub fn bonded(self, layer: Option<Layer>) -> Self {
        MaterialPair { layer: layer.map(|layer| layer.with_body(self.body)), ..self }
    }

    /// The layer that the rough body is; none if it is a half-space.
    #[must_use]
    pub fn layer(&self) -> Option<Layer> {
        self.layer
    }

    /// Displacement of both bodies under waves of pressure, if the rough one is a layer.
    #[must_use]
    pub fn layer_compliance(&self) -> Option<LayerCompliance> {
        self.layer.map(|layer| LayerCompliance::new(&layer, self.composite_modulus_pa))
    }

    /// The rough body.
    #[must_use]
    pub fn body(&self) -> ElasticBody {
        self.body
    }

    /// The counterface; none if it is rigid.
    #[must_use]
    pub fn counterface(&self) -> Option<ElasticBody> {
        self.counterface
    }

    /// The body that yields: the rough one, or the counterface of [`Self::against_yielding`].
    #[must_use]
    pub fn yielding_body(&self) -> ElasticBody {
        self.yielding_body
    }

    /// Composite modulus E* \[Pa\], finite and above 0 for bodies whose moduli are.
    #[must_use]
    pub fn composite_modulus_pa(&self) -> f64 {
        self.composite_modulus_pa
    }
}

/// Composite modulus E* \[Pa\] of two elastic bodies.
fn composite_modulus_pa(body: ElasticBody, counterface: ElasticBody) -> f64 {
    let (first, second) = (body.plane_strain_modulus_pa(), counterface.plane_strain_modulus_pa());
    1.0 / (1.0 / first + 1.0 / second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rigid_counterface_is_the_limit_of_a_stiff_one() {
        let body = ElasticBody::new(463e9, 0.2).unwrap();
        let stiff = ElasticBody::new(1e30, 0.2).unwrap();
        let rigid = MaterialPair::against_rigid(body).composite_modulus_pa();
        assert!((MaterialPair::against(body, stiff).composite_modulus_pa() / rigid - 1.0).abs() < 1e-15);
    }

    #[test]
    fn two_equal_bodies_halve_the_modulus() {
        let body = ElasticBody::new(210e9, 0.3).unwrap();
        let (alone, both) = (MaterialPair::against_rigid(body), MaterialPair::against(body, body));
        assert!((both.composite_modulus_pa() * 2.0 / alone.composite_modulus_pa() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_counterface_that_yields_is_the_body_that_yields_with_the_names_exchanged() {
        let [glass, gold] = [(73e9, 0.17), (78e9, 0.44)].map(|(e, nu)| ElasticBody::new(e, nu).unwrap());
        let (flows, exchanged) =
            (MaterialPair::against_yielding(glass, gold), MaterialPair::against(gold, glass));
        assert_eq!(flows.spherical_yield_coefficient, exchanged.spherical_yield_coefficient);
        assert_eq!(flows.sinusoidal_yield_coefficient, exchanged.sinusoidal_yield_coefficient);
        assert_eq!(flows.composite_modulus_pa(), exchanged.composite_modulus_pa());
        assert_eq!((flows.body(), flows.yielding_body()), (glass, gold));
    }

    #[test]
    fn values_outside_their_bounds_are_named() {
        let message = |e, nu| ElasticBody::new(e, nu).unwrap_err().to_string();
        assert_eq!(message(-1.0, 0.3), "Young's modulus in Pa is -1; it must be finite and greater than 0");
        assert_eq!(message(1e9, 0.6), "Poisson's ratio is 0.6; it must be greater than -1 and at most 0.5");
        assert_eq!(
            message(1e9, f64::NAN),
            "Poisson's ratio is NaN; it must be greater than -1 and at most 0.5"
        );
        assert!(ElasticBody::new(1e9, -1.0).is_err());
        assert!(ElasticBody::new(1e9, 0.5).is_ok());
        assert!(ElasticBody::new(f64::INFINITY, 0.3).is_err());
    }
}
