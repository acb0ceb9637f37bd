//! Materials, usual and unusual, as plain numbers.

use asperity::{AsperityError, ElasticBody, MaterialPair, NixGao};

use crate::Draw;

/// Range of the numbers of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reach {
    /// Usual: ratios of lengths and of pressures of real surfaces, with some decades to spare.
    Usual,
    /// Wide: each number independently, over everything physical and far beyond.
    Wide,
    /// Edge: as wide, with some numbers from the edges of the doubles. Results may leave their range there, but are
    /// never NaN.
    Edge,
}

impl Reach {
    /// Draws a range: half of the cases usual, a tenth at the edge.
    pub fn draw(draw: &mut Draw) -> Self {
        use Reach::{Edge, Usual, Wide};
        draw.one_of(&[Usual, Usual, Usual, Usual, Usual, Wide, Wide, Wide, Wide, Edge])
    }

    /// Draws a number between 10^low and 10^high, sometimes replaced by one from the edge of the doubles.
    pub fn number(self, draw: &mut Draw, low: f64, high: f64) -> f64 {
        const SHARE: f64 = 0.25;
        let number = draw.decades(low, high);
        if self == Reach::Edge && draw.chance(SHARE) { draw.edge() } else { number }
    }

    /// Draws a modulus \[Pa\].
    pub(crate) fn modulus_pa(self, draw: &mut Draw) -> f64 {
        if self == Reach::Usual { draw.decades(6.0, 12.0) } else { self.number(draw, 0.0, 14.0) }
    }
}

/// Material pair and its strength, in SI units; printed, it is a literal that recreates it to the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus of the body that yields \[Pa\].
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio of the body that yields.
    pub poisson_ratio: f64,
    /// Young's modulus \[Pa\] and Poisson's ratio of the counterface; rigid if `None`.
    pub counterface: Option<(f64, f64)>,
    /// Macroscopic strength S0 \[Pa\].
    pub strength_pa: f64,
    /// Strain-gradient length h* \[m\].
    pub strain_gradient_length_m: Option<f64>,
    /// Upper limit of the strength \[Pa\].
    pub strength_cap_pa: Option<f64>,
}

impl Material {
    /// Draws a random material. Strain-gradient lengths lie around a length \[m\] of the case.
    pub fn draw(draw: &mut Draw, reach: Reach, gradient: bool, around_m: f64) -> Self {
        let [modulus, strength, length] = match reach {
            Reach::Usual => [(8.0, 12.0), (-4.0, -1.0), (-2.0, 4.0)],
            _ => [(0.0, 14.0), (-12.0, 3.0), (-9.0, 9.0)],
        };
        let youngs_modulus_pa = reach.number(draw, modulus.0, modulus.1);
        let poisson_ratio = Self::draw_poisson_ratio(draw, reach);
        let counterface = draw
            .chance(0.1)
            .then(|| (reach.number(draw, modulus.0, modulus.1), Self::draw_poisson_ratio(draw, reach)));
        let strength_pa = youngs_modulus_pa * reach.number(draw, strength.0, strength.1);
        let strain_gradient_length_m = gradient.then(|| around_m * reach.number(draw, length.0, length.1));
        let strength_cap_pa = draw.chance(0.15).then(|| strength_pa * reach.number(draw, 0.0, 3.0));
        Material {
            youngs_modulus_pa,
            poisson_ratio,
            counterface,
            strength_pa,
            strain_gradient_length_m,
            strength_cap_pa,
        }
    }

    fn draw_poisson_ratio(draw: &mut Draw, reach: Reach) -> f64 {
        let ordinary = draw.between(0.0, 0.5);
        let any = draw.between(-1.0, 0.5);
        let end = draw.one_of(&[(-1f64).next_up(), -0.999_999, -0.0, 0.0, 0.5f64.next_down(), 0.5]);
        match reach {
            Reach::Usual => draw.one_of(&[ordinary, ordinary, ordinary, any, end]),
            _ => draw.one_of(&[ordinary, any, end]),
        }
    }

    /// Material pair.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn pair(&self) -> Result<MaterialPair, AsperityError> {
        let body = ElasticBody::new(self.youngs_modulus_pa, self.poisson_ratio)?;
        Ok(match self.counterface {
            Some((modulus_pa, ratio)) => MaterialPair::against(body, ElasticBody::new(modulus_pa, ratio)?),
            None => MaterialPair::against_rigid(body),
        })
    }

    /// Strength of the body that yields.
    ///
    /// # Errors
    /// [`AsperityError`] if a number is refused.
    pub fn strength(&self) -> Result<NixGao, AsperityError> {
        let mut strength = NixGao::constant(self.strength_pa)?;
        if let Some(length_m) = self.strain_gradient_length_m {
            strength = strength.with_strain_gradient(length_m)?;
        }
        if let Some(cap_pa) = self.strength_cap_pa {
            strength = strength.with_cap(cap_pa)?;
        }
        Ok(strength)
    }
}
