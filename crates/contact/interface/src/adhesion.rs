//! Two criteria of adhesion. Neither is a verdict, and neither changes the contact.

use units::{Bound, OutOfBounds};

/// Value of [`fuller_tabor`] above which the surfaces in their experiments did not stick (approximate).
pub const NOT_STICKY_ABOVE: f64 = 10.0;

/// Returns the adhesion parameter of Fuller & Tabor (1975), Proc. R. Soc. A 345:327, for the summits of a surface with a
/// cutoff: theta = E* sigma_s^(3/2)/(sqrt(R) w), from a contact modulus E* \[Pa\], the standard deviation sigma_s of the
/// summits' heights \[m\], the mean radius R of the summits \[m\] and the work of adhesion w \[J/m^2\].
///
/// # Errors
/// [`OutOfBounds`] unless all are positive and within thirty decades of 1.
pub fn fuller_tabor(
    contact_modulus_pa: f64,
    summit_deviation_m: f64,
    summit_radius_m: f64,
    work_of_adhesion_j_per_m2: f64,
) -> Result<f64, OutOfBounds> {
    let modulus_pa = Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
    let deviation_m = Bound::Magnitude.check("deviation of summit heights in m", summit_deviation_m)?;
    let radius_m = Bound::Magnitude.check("summit radius in m", summit_radius_m)?;
    let work_j_per_m2 = work(work_of_adhesion_j_per_m2)?;
    Ok(modulus_pa * deviation_m * (deviation_m / radius_m).sqrt() / work_j_per_m2)
}

/// Criterion of Pastewka & Robbins (2014), Proc. Natl. Acad. Sci. 111:3298, for a surface with a cutoff. The surface
/// is sticky if
///
/// (h' dr/(kappa l_a)) (h' d_rep/(4 dr))^(2/3) < pi (3/16)^(2/3), l_a = w/E*, d_rep = 4 h'/h'',
///
/// with h' the rms gradient and h'' the rms Laplacian of the surface (a cap of radius R has 2/R, and d_rep is the
/// width over which its slope reaches h'), dr the range of the attraction, and kappa the coefficient of A/A_0 = kappa
/// p/(E* h') without adhesion. Its constants are quoted at second hand, and it is contested (Ciavarella 2016,
/// arXiv:1602.02555): report the left side beside the limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StickyContact {
    /// Rms gradient h' of the surface.
    pub rms_gradient: f64,
    /// Rms Laplacian h'' of the surface \[1/m\]; sqrt(8 m4/3) of an isotropic one.
    pub rms_laplacian_per_m: f64,
    /// Contact modulus E* \[Pa\].
    pub contact_modulus_pa: f64,
    /// Work of adhesion w \[J/m^2\].
    pub work_of_adhesion_j_per_m2: f64,
    /// Range of the attraction dr \[m\].
    pub range_m: f64,
    /// Coefficient kappa, usually [`StickyContact::USUAL_KAPPA`].
    pub kappa: f64,
}

impl StickyContact {
    /// Limit pi (3/16)^(2/3) of the left side; a sticky surface is below it.
    pub const LIMIT: f64 = 1.029_162_738_875_667_7;

    /// Coefficient kappa of A/A_0 = kappa p/(E* h') at light loads.
    pub const USUAL_KAPPA: f64 = 2.0;

    /// Returns the left side of the criterion.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless all inputs are positive and within thirty decades of 1.
    pub fn left_side(&self) -> Result<f64, OutOfBounds> {
        let gradient = Bound::Magnitude.check("rms gradient", self.rms_gradient)?;
        let laplacian_per_m = Bound::Magnitude.check("rms Laplacian in 1/m", self.rms_laplacian_per_m)?;
        let modulus_pa = Bound::Magnitude.check("contact modulus in Pa", self.contact_modulus_pa)?;
        let range_m = Bound::Magnitude.check("range of the attraction in m", self.range_m)?;
        let kappa = Bound::Magnitude.check("kappa of area over load", self.kappa)?;
        let adhesion_length_m = work(self.work_of_adhesion_j_per_m2)? / modulus_pa;
        let repulsive_width_m = 4.0 * gradient / laplacian_per_m;
        let strength = gradient * range_m / (kappa * adhesion_length_m);
        let shape = libm::cbrt(gradient * repulsive_width_m / (4.0 * range_m));
        Ok(strength * shape * shape)
    }
}

fn work(work_of_adhesion_j_per_m2: f64) -> Result<f64, OutOfBounds> {
    Bound::Magnitude.check("work of adhesion in J/m^2", work_of_adhesion_j_per_m2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn theta_is_the_summits_own_parameter() {
        // 1e6 Pa (1e-6 m)^1.5/(sqrt(1e-4 m) 0.05 J/m^2).
        let theta = fuller_tabor(1e6, 1e-6, 1e-4, 0.05).unwrap();
        assert!((theta / 2.0 - 1.0).abs() < 1e-14, "{theta}");
        let rougher = fuller_tabor(1e6, 4e-6, 1e-4, 0.05).unwrap();
        assert!((rougher / theta - 8.0).abs() < 1e-13);
        assert!(fuller_tabor(1e6, 1e-6, 1e-4, 0.0).is_err());
    }

    #[test]
    fn the_left_side_goes_with_its_powers() {
        let contact = StickyContact {
            rms_gradient: 0.1,
            rms_laplacian_per_m: 1e8,
            contact_modulus_pa: 1e9,
            work_of_adhesion_j_per_m2: 0.05,
            range_m: 0.5e-9,
            kappa: StickyContact::USUAL_KAPPA,
        };
        let left = |contact: &StickyContact| contact.left_side().unwrap();
        // h' dr/(kappa l_a) = 0.1 0.5e-9/(2 5e-11) = 0.5; h' d_rep/(4 dr) = 0.1 4e-9/2e-9 = 0.2.
        assert!((left(&contact) / (0.5 * 0.2f64.powf(2.0 / 3.0)) - 1.0).abs() < 1e-14);
        let power = |changed: StickyContact| (left(&changed) / left(&contact)).ln() / 2f64.ln();
        assert!((power(StickyContact { rms_gradient: 0.2, ..contact }) - 7.0 / 3.0).abs() < 1e-13);
        assert!((power(StickyContact { range_m: 1e-9, ..contact }) - 1.0 / 3.0).abs() < 1e-13);
        let more_work = StickyContact { work_of_adhesion_j_per_m2: 0.1, ..contact };
        assert!((power(more_work) + 1.0).abs() < 1e-13);
        let error = StickyContact { kappa: 0.0, ..contact }.left_side().unwrap_err();
        assert!(error.to_string().contains("kappa"), "{error}");
    }

    #[test]
    fn the_limit_agrees_with_its_formula() {
        let limit = std::f64::consts::PI * (3.0f64 / 16.0).powf(2.0 / 3.0);
        assert!((StickyContact::LIMIT / limit - 1.0).abs() < 1e-15, "{limit:.17}");
    }
}
