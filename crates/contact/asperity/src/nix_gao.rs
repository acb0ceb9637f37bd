//! Strength that grows as the deformation gets shallower: Nix & Gao (1998); Jackson & Jacobs, Eq. (8).

use crate::{AsperityError, Bound};

/// Yield strength Sy = S0 sqrt(1 + h*/h_p) \[Pa\], constant if no strain-gradient length is given: Nix & Gao (1998);
/// Jackson & Jacobs, Eq. (8); `docs/theory/models.md`, section 2.7. As a continuum law it loses its meaning at depths of a
/// few atoms, which are not refused.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct NixGao {
    macroscopic_strength_pa: f64,
    strain_gradient_length_m: Option<f64>,
    cap_pa: Option<f64>,
}

impl NixGao {
    /// Creates a strength S0 \[Pa\] that is the same at every depth.
    ///
    /// # Errors
    /// [`AsperityError`] unless S0 is positive and within thirty decades of 1.
    pub fn constant(macroscopic_strength_pa: f64) -> Result<Self, AsperityError> {
        let macroscopic_strength_pa =
            Bound::Magnitude.check("yield strength in Pa", macroscopic_strength_pa)?;
        Ok(NixGao { macroscopic_strength_pa, strain_gradient_length_m: None, cap_pa: None })
    }

    /// Returns this strength growing with the strain-gradient length h* \[m\].
    ///
    /// # Errors
    /// [`AsperityError`] unless h* is positive and within thirty decades of 1.
    pub fn with_strain_gradient(self, length_m: f64) -> Result<Self, AsperityError> {
        let length_m = Bound::Magnitude.check("strain-gradient length in m", length_m)?;
        Ok(NixGao { strain_gradient_length_m: Some(length_m), ..self })
    }

    /// Returns this strength limited to `cap_pa` (E/10 is the usual limit). The published law has no cap.
    ///
    /// # Errors
    /// [`AsperityError`] unless the cap is at least S0 and within thirty decades of 1.
    pub fn with_cap(self, cap_pa: f64) -> Result<Self, AsperityError> {
        let cap_pa = Bound::AtLeast(self.macroscopic_strength_pa).check("strength cap in Pa", cap_pa)?;
        let cap_pa = Bound::Magnitude.check("strength cap in Pa", cap_pa)?;
        Ok(NixGao { cap_pa: Some(cap_pa), ..self })
    }

    /// Macroscopic strength S0 \[Pa\], at large depth.
    #[must_use]
    pub fn macroscopic_strength_pa(&self) -> f64 {
        self.macroscopic_strength_pa
    }

    /// Strain-gradient length h* \[m\]; `None` if the strength does not depend on depth.
    #[must_use]
    pub fn strain_gradient_length_m(&self) -> Option<f64> {
        self.strain_gradient_length_m
    }

    /// Upper limit of the strength \[Pa\], if any.
    #[must_use]
    pub fn cap_pa(&self) -> Option<f64> {
        self.cap_pa
    }

    /// Depth \[m\] below which the cap holds, and at which the strength has a kink.
    #[must_use]
    pub fn cap_depth_m(&self) -> Option<f64> {
        self.strain_gradient_length_m?;
        self.depth_of_strength_m(self.cap_pa?)
    }

    /// Smallest depth \[m\] from which on the strength is at most `strength_pa`: 0 if it is so everywhere, `None` if
    /// it is nowhere.
    #[must_use]
    pub fn depth_of_strength_m(&self, strength_pa: f64) -> Option<f64> {
        if self.cap_pa.is_some_and(|cap| cap < strength_pa) {
            return Some(0.0);
        }
        let ratio = strength_pa / self.macroscopic_strength_pa;
        match self.strain_gradient_length_m {
            None => (ratio >= 1.0).then_some(0.0),
            Some(length_m) => (ratio > 1.0).then(|| length_m / ((ratio - 1.0) * (ratio + 1.0))),
        }
    }

    /// Strength \[Pa\] at the deformation depth h_p >= 0 \[m\]. Without a cap it diverges as the depth vanishes: no
    /// deformation, no plasticity.
    #[inline]
    #[must_use]
    pub fn at_depth_pa(&self, depth_m: f64) -> f64 {
        let Some(length_m) = self.strain_gradient_length_m else { return self.macroscopic_strength_pa };
        let grown = self.macroscopic_strength_pa * (1.0 + length_m / depth_m).sqrt();
        match self.cap_pa {
            Some(cap_pa) if cap_pa < grown => cap_pa,
            _ => grown,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uncd() -> NixGao {
        NixGao::constant(1.8e9).unwrap().with_strain_gradient(5e-6).unwrap()
    }

    #[test]
    fn strength_is_the_macroscopic_one_at_depth_and_infinite_at_none() {
        assert!((uncd().at_depth_pa(1e6) / 1.8e9 - 1.0).abs() < 1e-11);
        assert_eq!(uncd().at_depth_pa(0.0), f64::INFINITY);
        assert!((uncd().at_depth_pa(5e-6) / (1.8e9 * std::f64::consts::SQRT_2) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_cap_holds_and_may_not_undercut_the_strength_itself() {
        let capped = uncd().with_cap(46.3e9).unwrap();
        assert_eq!(capped.at_depth_pa(0.0), 46.3e9);
        assert_eq!(capped.at_depth_pa(1e-3), uncd().at_depth_pa(1e-3));
        assert_eq!(
            uncd().with_cap(1e9).unwrap_err().to_string(),
            "strength cap in Pa is 1e9; it must be finite and at least 1.8e9"
        );
    }

    #[test]
    fn the_depth_of_a_strength_inverts_the_strength_at_a_depth() {
        for depth in [1e-12, 3e-8, 4e-5] {
            let back = uncd().depth_of_strength_m(uncd().at_depth_pa(depth)).unwrap();
            assert!((back / depth - 1.0).abs() < 1e-12, "{depth}");
        }
        let capped = uncd().with_cap(18e9).unwrap();
        assert!((capped.at_depth_pa(capped.cap_depth_m().unwrap()) / 18e9 - 1.0).abs() < 1e-15);
        assert_eq!(capped.depth_of_strength_m(20e9), Some(0.0));
        assert_eq!(uncd().depth_of_strength_m(1.8e9), None);
        let constant = NixGao::constant(1.8e9).unwrap();
        assert_eq!(constant.depth_of_strength_m(1.8e9), Some(0.0));
        assert_eq!(constant.depth_of_strength_m(1.7e9), None);
        assert_eq!(constant.with_cap(2e9).unwrap().cap_depth_m(), None);
    }

    #[test]
    fn diamond_hardens_to_tens_of_gigapascals_at_nanometres() {
        // Jackson & Jacobs state 29 GPa at 10-40 nm and 40-45 GPa at a few nm.
        assert!((20e9..41e9).contains(&uncd().at_depth_pa(20e-9)));
        assert!((39e9..90e9).contains(&uncd().at_depth_pa(5e-9)));
    }
}
