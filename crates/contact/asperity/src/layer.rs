//! An elastic layer bonded to a rigid or an elastic base: its displacement under waves of pressure, over that of a half-space
//! of the layer's material.
//!
//! A wave of pressure of the wavevector q displaces the surface by 2/(E1* q) S(k) times its pressure, with k = q t, the
//! thickness t and E1* = E1/(1 - nu1^2) of the layer. The surface carries no shear, and nothing slips at the base. On a rigid
//! base, with nu = nu1,
//!
//! S = \[(3 - 4 nu) sinh 2k - 2k\]/\[5 + 2 k^2 - 4 nu (3 - 2 nu) + (3 - 4 nu) cosh 2k\],
//!
//! and on an elastic one (the problem of Burmister 1945, J. Appl. Phys. 16:89), with the ratio mu = G1/G2 of shear moduli,
//! e = exp(-2k), lam = 1 - 4 (1 - nu1)/(1 + mu (3 - 4 nu2)) and kap = (mu - 1)/(mu + 3 - 4 nu1),
//!
//! S = \[1 + 4 k kap e - lam kap e^2\]/\[1 - (lam + kap + 4 kap k^2) e + lam kap e^2\].
//!
//! Both are written here in forms that neither overflow nor cancel: see `docs/theory/layers.md`.

use crate::elastic_body::ElasticBody;
use crate::{AsperityError, Bound};

/// Elastic layer bonded to a base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    body: ElasticBody,
    thickness_m: f64,
    base: Option<ElasticBody>,
}

impl Layer {
    /// Range of Poisson's ratio of a layer; 0.5 is incompressible.
    pub const POISSON_RATIO: Bound = Bound::Within { at_least: 0.0, at_most: 0.5 };

    /// Creates a layer of a material with a thickness \[m\] on a base, which is rigid if absent.
    ///
    /// # Errors
    /// [`AsperityError`] unless the thickness is positive and within thirty decades of 1, and Poisson's ratio of the layer lies
    /// in \[0, 0.5\].
    pub fn new(
        body: ElasticBody,
        thickness_m: f64,
        base: Option<ElasticBody>,
    ) -> Result<Self, AsperityError> {
        Self::POISSON_RATIO.check("Poisson's ratio of the layer", body.poisson_ratio())?;
        let thickness_m = Bound::Magnitude.check("thickness of the layer in m", thickness_m)?;
        Ok(Layer { body, thickness_m, base })
    }

    /// Material of the layer.
    #[must_use]
    pub fn body(&self) -> ElasticBody {
        self.body
    }

    /// Thickness t \[m\], above 0.
    #[must_use]
    pub fn thickness_m(&self) -> f64 {
        self.thickness_m
    }

    /// Base under the layer; none if it is rigid.
    #[must_use]
    pub fn base(&self) -> Option<ElasticBody> {
        self.base
    }

    /// Returns a layer of another material, with the same thickness and base.
    #[must_use]
    pub(crate) fn with_body(self, body: ElasticBody) -> Self {
        Layer { body, ..self }
    }

    /// Displacement S(k) of a wave over that of a half-space of the layer's material, for k = q t >= 0. It tends to 1 for short
    /// waves and, on an elastic base, to E1*/E2* for long ones; on a rigid base it vanishes with k.
    #[must_use]
    pub fn relative_displacement(&self, k: f64) -> f64 {
        Kernel::new(self).at(k)
    }

    /// Displacement \[m/Pa\] of the mean plane per uniform pressure. On a rigid base it is that of the layer, t/M with
    /// M = E (1 - nu)/((1 + nu)(1 - 2 nu)); on an elastic base, whose own is infinite, it is what the layer adds to it:
    /// t (1 + A)(1 - 2 nu1 - A)/(2 G1 (1 - nu1)) with A = mu (1 - 2 nu2), which is negative for a stiff layer.
    #[must_use]
    pub fn uniform_compliance_m_per_pa(&self) -> f64 {
        let nu = self.body.poisson_ratio();
        let shear_pa = self.body.shear_modulus_pa();
        let of_base = self
            .base
            .map_or(0.0, |base| shear_pa / base.shear_modulus_pa() * (1.0 - 2.0 * base.poisson_ratio()));
        self.thickness_m * (1.0 + of_base) * (1.0 - 2.0 * nu - of_base) / (2.0 * shear_pa * (1.0 - nu))
    }

    /// Plane-strain modulus E1* \[Pa\].
    pub(crate) fn plane_strain_modulus_pa(&self) -> f64 {
        self.body.plane_strain_modulus_pa()
    }
}

/// Displacement under waves of pressure of a pair whose rough body is a layer, over that at the shortest waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerCompliance {
    kernel: Kernel,
    thickness_m: f64,
    /// Share of the layer in the displacement of both bodies under short waves: E*/E1*.
    share: f64,
}

impl LayerCompliance {
    /// Creates the compliance of a layer in a pair of a composite modulus E* \[Pa\], at most that of the layer.
    pub(crate) fn new(layer: &Layer, composite_modulus_pa: f64) -> Self {
        LayerCompliance {
            kernel: Kernel::new(layer),
            thickness_m: layer.thickness_m,
            share: composite_modulus_pa / layer.plane_strain_modulus_pa(),
        }
    }

    /// Displacement of a wave of the wavevector q \[rad/m\] over that of half-spaces with the composite modulus E* of layer and
    /// counterface: E*/E*(q), with 1/E*(q) = S(q t)/E1* + 1/Ec*.
    #[must_use]
    pub fn relative_at(&self, wavevector_rad_per_m: f64) -> f64 {
        self.share * self.kernel.at(wavevector_rad_per_m * self.thickness_m) + (1.0 - self.share)
    }
}

/// Constants of S(k).
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kernel {
    Rigid { nu: f64 },
    Elastic { lam: f64, kap: f64, at_zero: [f64; 2] },
}

impl Kernel {
    fn new(layer: &Layer) -> Self {
        let nu = layer.body.poisson_ratio();
        let Some(base) = layer.base else { return Kernel::Rigid { nu } };
        let (mu, nu2) = (layer.body.shear_modulus_pa() / base.shear_modulus_pa(), base.poisson_ratio());
        let (of_base, of_layer) = (1.0 + mu * (3.0 - 4.0 * nu2), mu + 3.0 - 4.0 * nu);
        // 1 - lam - kap + lam kap = (1 - lam)(1 - kap).
        let denominator = 16.0 * (1.0 - nu) * (1.0 - nu) / (of_base * of_layer);
        Kernel::Elastic {
            lam: 1.0 - 4.0 * (1.0 - nu) / of_base,
            kap: (mu - 1.0) / of_layer,
            at_zero: [denominator * (mu * (1.0 - nu2) / (1.0 - nu)), denominator],
        }
    }

    /// Computes S(k).
    fn at(&self, k: f64) -> f64 {
        match *self {
            Kernel::Rigid { nu } if k < 0.5 => {
                let x = 2.0 * k;
                let numerator = 4.0 * (1.0 - 2.0 * nu) * k + (3.0 - 4.0 * nu) * sinh_less_argument(x);
                let denominator =
                    5.0 + 2.0 * k * k - 4.0 * nu * (3.0 - 2.0 * nu) + (3.0 - 4.0 * nu) * x.cosh();
                numerator / denominator
            }
            Kernel::Rigid { nu } => {
                let e = (-2.0 * k).exp();
                let factor = 3.0 - 4.0 * nu;
                let numerator = -factor * (-4.0 * k).exp_m1() - 4.0 * k * e;
                let polynomial = 5.0 + 2.0 * k * k - 12.0 * nu + 8.0 * nu * nu;
                numerator / (factor * (1.0 + e * e) + 2.0 * e * polynomial)
            }
            Kernel::Elastic { lam, kap, at_zero: [numerator, denominator] } => {
                let e = (-2.0 * k).exp();
                let of_square = lam * kap * (-4.0 * k).exp_m1();
                let numerator = numerator + 4.0 * k * kap * e - of_square;
                let denominator =
                    denominator - (lam + kap) * (-2.0 * k).exp_m1() - 4.0 * kap * k * k * e + of_square;
                numerator / denominator
            }
        }
    }
}

/// Computes sinh x - x for 0 <= x <= 1 without cancellation, by its series.
fn sinh_less_argument(x: f64) -> f64 {
    const RATIOS: [f64; 7] = [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0];
    let square = x * x;
    let series = RATIOS.iter().rev().fold(1.0, |sum, ratio| 1.0 + square / ratio * sum);
    x * square / 6.0 * series
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(modulus_pa: f64, poisson_ratio: f64) -> ElasticBody {
        ElasticBody::new(modulus_pa, poisson_ratio).unwrap()
    }

    fn layer(poisson_ratio: f64, base: Option<ElasticBody>) -> Layer {
        Layer::new(body(3e9, poisson_ratio), 2e-6, base).unwrap()
    }

    fn off(found: f64, expected: f64) -> f64 {
        (found / expected - 1.0).abs()
    }

    #[test]
    fn short_waves_feel_the_layer_alone() {
        for nu in [0.0, 0.3, 0.5] {
            for base in [None, Some(body(1e6, 0.4)), Some(body(9e11, 0.1))] {
                for k in [40.0, 355.0, 1e5, 1e60] {
                    assert!(off(layer(nu, base).relative_displacement(k), 1.0) < 1e-15, "{nu} {base:?} {k}");
                }
            }
        }
    }

    #[test]
    fn long_waves_feel_a_rigid_base_through_the_layer() {
        for nu in [0.0, 0.2, 0.45] {
            let expected = 1e-7 * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu) * (1.0 - nu));
            assert!(off(layer(nu, None).relative_displacement(1e-7), expected) < 1e-13, "{nu}");
        }
        assert!(off(layer(0.5, None).relative_displacement(1e-5), 2.0 / 3.0 * 1e-15) < 1e-9);
        assert_eq!(layer(0.3, None).relative_displacement(0.0), 0.0);
    }

    #[test]
    fn long_waves_feel_the_half_space_of_an_elastic_base() {
        for (nu, base) in [(0.0, body(1e6, 0.4)), (0.3, body(9e11, 0.1)), (0.5, body(4e9, 0.5))] {
            let layer = layer(nu, Some(base));
            let expected = layer.plane_strain_modulus_pa() / base.plane_strain_modulus_pa();
            assert!(off(layer.relative_displacement(0.0), expected) < 1e-14, "{nu}");
        }
    }

    #[test]
    fn a_stiff_base_is_a_rigid_one_in_the_limit() {
        for nu in [0.0, 0.3, 0.49] {
            for k in [0.01, 0.4, 0.6, 3.0] {
                let stiff = layer(nu, Some(body(3e25, 0.3))).relative_displacement(k);
                assert!(off(stiff, layer(nu, None).relative_displacement(k)) < 1e-11, "{nu} {k}");
            }
        }
    }

    #[test]
    fn a_layer_of_the_material_of_its_base_is_a_half_space() {
        for nu in [0.0, 0.3, 0.5] {
            let same = layer(nu, Some(body(3e9, nu)));
            for k in [0.0, 1e-4, 0.3, 1.0, 30.0] {
                assert!(off(same.relative_displacement(k), 1.0) < 1e-15, "{nu} {k}");
            }
            assert!(same.uniform_compliance_m_per_pa().abs() < 1e-15 * 2e-6 / 3e9);
        }
    }

    #[test]
    fn both_forms_on_a_rigid_base_meet() {
        for nu in [0.0, 0.3, 0.5] {
            let [below, above] = [0.5 - 1e-15, 0.5].map(|k| layer(nu, None).relative_displacement(k));
            assert!(off(below, above) < 2e-14, "{nu}: {below} {above}");
        }
    }

    #[test]
    fn uniform_pressure_squeezes_the_layer() {
        let nu: f64 = 0.3;
        let modulus_pa = 3e9 * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        assert!(off(layer(nu, None).uniform_compliance_m_per_pa(), 2e-6 / modulus_pa) < 1e-15);
        assert_eq!(layer(0.5, None).uniform_compliance_m_per_pa(), 0.0);
        // A stiff layer in place of a soft one displaces less.
        assert!(layer(0.3, Some(body(3e8, 0.3))).uniform_compliance_m_per_pa() < 0.0);
        assert!(layer(0.3, Some(body(3e10, 0.3))).uniform_compliance_m_per_pa() > 0.0);
    }

    #[test]
    fn an_elastic_counterface_adds_its_own_displacement() {
        let counterface = body(1e9, 0.4);
        let layer = layer(0.3, None);
        let pair = crate::MaterialPair::against(layer.body(), counterface).bonded(Some(layer));
        let compliance = pair.layer_compliance().unwrap();
        let q = 1e5;
        let [own, other] = [layer.plane_strain_modulus_pa(), counterface.plane_strain_modulus_pa()];
        let expected = layer.relative_displacement(q * 2e-6) / own + 1.0 / other;
        assert!(off(compliance.relative_at(q) / pair.composite_modulus_pa(), expected) < 1e-14);
    }

    #[test]
    fn bounds_are_checked() {
        assert!(Layer::new(body(3e9, -0.1), 1e-6, None).is_err());
        assert!(Layer::new(body(3e9, 0.3), 0.0, None).is_err());
        assert!(Layer::new(body(3e9, 0.3), -1e-6, None).is_err());
        assert!(Layer::new(body(3e9, 0.3), f64::NAN, None).is_err());
    }
}
