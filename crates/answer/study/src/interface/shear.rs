//! Tangential loads on an interface, with friction.

use ::interface::tangential::{ShearedBody, ShearedPair};
use asperity::{ElasticBody, MaterialPair};
use units::OutOfBounds;

/// A tangential load under a constant normal load, and Coulomb friction at every point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shear {
    /// Coefficient of friction f.
    pub friction: f64,
    /// The tangential load.
    pub load: ShearLoad,
}

/// A tangential load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShearLoad {
    /// Stress q on the nominal area \[Pa\].
    StressPa(f64),
    /// Share of friction times pressure, above 0 and below 1.
    ShareOfSliding(f64),
}

impl Shear {
    /// Returns the share of friction times a pressure \[Pa\]; everything slides at 1 and above.
    #[must_use]
    pub fn share_of_sliding(&self, pressure_pa: f64) -> f64 {
        match self.load {
            ShearLoad::StressPa(stress_pa) => stress_pa / (self.friction * pressure_pa),
            ShearLoad::ShareOfSliding(share) => share,
        }
    }
}

/// Pairs the bodies in contact with a coefficient of friction.
///
/// # Errors
/// [`OutOfBounds`] for a coefficient that is not positive, and for moduli out of their bounds.
pub fn sheared_pair(friction: f64, pair: &MaterialPair) -> Result<ShearedPair, OutOfBounds> {
    let sheared = |body: ElasticBody| ShearedBody {
        shear_modulus_pa: body.shear_modulus_pa(),
        poisson_ratio: body.poisson_ratio(),
    };
    let (body, counterface) = (sheared(pair.body()), pair.counterface().map(sheared));
    ShearedPair::new(friction, pair.composite_modulus_pa(), body, counterface)
}
