//! The standard normal distribution.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use crate::newton_in_bracket;

/// Density exp(-z^2/2)/sqrt(2 pi).
#[must_use]
pub fn density(z: f64) -> f64 {
    (-0.5 * z * z).exp() / TAU.sqrt()
}

/// Share Q(z) above z.
#[must_use]
pub fn share_above(z: f64) -> f64 {
    0.5 * libm::erfc(FRAC_1_SQRT_2 * z)
}

/// Level above which a share in (0, 1) lies: the inverse of [`share_above`].
#[must_use]
pub fn level_of_share(share: f64) -> f64 {
    if share > 0.5 {
        // The complement keeps its digits: it is exact for shares from a half on.
        return -level_of_share(1.0 - share);
    }
    // Of ln(share above) the slope is that of a nearly straight line in the far tail.
    newton_in_bracket(0.0, 38.0, 1.0, |level| {
        let above = share_above(level);
        (share.ln() - above.ln(), density(level) / above)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_and_shares_are_inverse() {
        for share in [1e-200, 1e-12, 0.02, 0.5, 0.7, 1.0 - 1e-12] {
            let level = level_of_share(share);
            let within = 1e-14 * (1.0 + level * level);
            assert!((share_above(level) / share - 1.0).abs() < within, "{share}");
        }
        // Abramowitz & Stegun, table 26.5: Q(x) = 0.025.
        assert!((level_of_share(0.025) - 1.959_963_984_540_054).abs() < 1e-14);
        assert!((density(1.0) - 0.241_970_724_519_143_35).abs() < 1e-16);
    }
}
