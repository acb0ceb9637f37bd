//! The elastic theory: Persson (2001), J. Chem. Phys. 115:3840; Manners & Greenwood (2006), Wear 261:600.
//!
//! Everything follows from the nominal pressure p and the spread s of the pressure that would flatten the roughness
//! completely, s = E* h'/2 with h' the rms gradient of the surface.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use numerics::newton_in_bracket;

/// Share in contact, erf(p/(sqrt(2) s)), in \[0, 1\]; 1 where nothing has to be flattened.
#[must_use]
pub fn area_fraction(pressure_pa: f64, spread_pa: f64) -> f64 {
    if spread_pa == 0.0 { 1.0 } else { libm::erf(FRAC_1_SQRT_2 * (pressure_pa / spread_pa)) }
}

/// Share out of contact, erfc(p/(sqrt(2) s)), which keeps its digits where it is small.
#[must_use]
pub fn gap_fraction(pressure_pa: f64, spread_pa: f64) -> f64 {
    if spread_pa == 0.0 { 0.0 } else { libm::erfc(FRAC_1_SQRT_2 * (pressure_pa / spread_pa)) }
}

/// Argument p/(sqrt(2) s) at which a share A in (0, 1) is in contact: the inverse of erf.
#[must_use]
pub fn argument_of_area(area_fraction: f64) -> f64 {
    // erf(6) is 1 to rounding. The function is concave: Newton's steps from the left of its zero stay on the left.
    let start = 0.5 * PI.sqrt() * area_fraction;
    newton_in_bracket(0.0, 6.0, start, |x: f64| {
        (libm::erf(x) - area_fraction, 2.0 / PI.sqrt() * (-x * x).exp())
    })
}

/// Density \[1/Pa\] of the stress sigma > 0 \[Pa\] over the nominal area: the Gaussian about p less its image about
/// -p. Its integral is the share in contact, its first moment is p.
#[must_use]
pub fn stress_density_per_pa(stress_pa: f64, pressure_pa: f64, spread_pa: f64) -> f64 {
    // The difference of the two Gaussians is the larger one times 1 - exp(-2 sigma p/s^2), which never cancels.
    let apart = (stress_pa - pressure_pa) / spread_pa;
    let image = -libm::expm1(-2.0 * (stress_pa / spread_pa) * (pressure_pa / spread_pa));
    (-0.5 * apart * apart).exp() * image / ((2.0 * PI).sqrt() * spread_pa)
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::GaussLegendre;

    #[test]
    fn light_loads_touch_in_proportion_and_nothing_to_flatten_is_full_contact() {
        let light = area_fraction(1e-9, 0.5);
        assert!((light / ((8.0 / PI).sqrt() * 1e-9) - 1.0).abs() < 1e-15);
        assert_eq!((area_fraction(1.0, 0.0), gap_fraction(1.0, 0.0)), (1.0, 0.0));
        assert!((gap_fraction(8.0, 1.0) / 1.244_192_114_854_356_8e-15 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_argument_of_an_area_inverts_the_area() {
        for share in [1e-300, 1e-12, 0.42, 0.5, 0.9, 1.0 - 1e-12] {
            assert!((libm::erf(argument_of_area(share)) / share - 1.0).abs() < 1e-15, "{share}");
        }
        // Computed with mpmath.
        assert!((argument_of_area(0.42) / 0.391_302_087_802_832_1 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_density_carries_the_load_over_the_area() {
        let rule = GaussLegendre::new(40);
        for pressure_pa in [1e-6, 0.3, 2.0] {
            let moment = |k: i32| -> f64 {
                let over = (0..8).flat_map(|i| rule.over(f64::from(i) * 2.0, f64::from(i + 1) * 2.0));
                over.map(|(stress, weight)| {
                    weight * stress.powi(k) * stress_density_per_pa(stress, pressure_pa, 1.0)
                })
                .sum()
            };
            assert!((moment(0) / area_fraction(pressure_pa, 1.0) - 1.0).abs() < 1e-13, "{pressure_pa}");
            assert!((moment(1) / pressure_pa - 1.0).abs() < 1e-13, "{pressure_pa}");
        }
    }
}
