//! Tolerance of statistical states.

use asperity::{AsperityError, Bound};
use serde::{Deserialize, Serialize};
use units::{Remark, RemarkCode};

/// The relative error allowed of a statistical state. The value in use may be larger than the requested one, because
/// double precision limits it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "f64", into = "f64")]
pub struct Tolerance {
    used: f64,
    asked: f64,
}

impl Tolerance {
    const BOUND: Bound = Bound::LeftOpen { above: 0.0, at_most: 0.01 };

    /// The finest that the sums of a state reach in double precision.
    pub const FINEST: f64 = 1e-13;

    /// A tolerance in (0, 0.01]; one below [`FINEST`](Self::FINEST) is taken as that.
    ///
    /// # Errors
    /// [`AsperityError`] outside (0, 0.01].
    pub fn new(tolerance: f64) -> Result<Self, AsperityError> {
        let asked = Self::BOUND.check("tolerance", tolerance)?;
        Ok(Tolerance { used: asked.max(Self::FINEST), asked })
    }

    /// Returns the tolerance in use, from 1e-13 to 0.01.
    #[must_use]
    pub fn value(self) -> f64 {
        self.used
    }

    /// Returns the requested tolerance if it is finer than the finest that can be reached.
    #[must_use]
    pub fn asked_finer(self) -> Option<f64> {
        (self.asked < self.used).then_some(self.asked)
    }

    /// Returns the remark on a tolerance finer than the finest that can be reached.
    #[must_use]
    pub fn remark(self) -> Option<Remark> {
        let remark = Remark::new(RemarkCode::ToleranceTooFine).on("tolerance");
        self.asked_finer().map(|asked| remark.with("asked", asked).with("used", self.used))
    }
}

impl TryFrom<f64> for Tolerance {
    type Error = AsperityError;

    fn try_from(tolerance: f64) -> Result<Self, AsperityError> {
        Tolerance::new(tolerance)
    }
}

impl From<Tolerance> for f64 {
    fn from(tolerance: Tolerance) -> Self {
        tolerance.asked
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Tolerance { used: 1e-12, asked: 1e-12 }
    }
}

#[cfg(test)]
mod tests {
    use super::Tolerance;

    #[test]
    fn a_tolerance_beyond_double_precision_is_held_within_it_and_known_to_be() {
        let tolerance = Tolerance::new(1e-300).unwrap();
        assert_eq!((tolerance.value(), tolerance.asked_finer()), (1e-13, Some(1e-300)));
        assert_eq!(Tolerance::new(1e-13).unwrap().asked_finer(), None);
        assert!(Tolerance::new(0.0).is_err() && Tolerance::new(0.5).is_err());
    }
}
