//! Elastic contact of two rough faces (Greenwood & Tripp 1970, Proc. Inst. Mech. Eng. 185:625).

use std::f64::consts::{PI, SQRT_2};
use std::ops::RangeInclusive;

use asperity::{AsperityError, Bound};

use crate::{PartialMoment, Population};

/// Two alike rough faces whose spherical summits meet off their axes, each of eta summits per area with the radius beta; sigma is the
/// standard deviation of the sum of their summit heights. With the separation h of the mean planes of the summits,
///
/// p = (16 sqrt(2) pi/15) (eta beta sigma)^2 sqrt(sigma/beta) E* F_5/2(h/sigma),  A/A_n = pi^2 (eta beta sigma)^2 F_2(h/sigma).
///
/// A rough face on a smooth one follows Greenwood & Williamson instead: [`StatisticalContact`](crate::StatisticalContact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodTripp {
    contact_modulus_pa: f64,
    summits: Population,
}

/// Pressure and area of a contact at a separation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeparationPoint {
    /// Separation h \[m\].
    pub separation_m: f64,
    /// Nominal pressure \[Pa\], above 0.
    pub pressure_pa: f64,
    /// Real over nominal area, above 0.
    pub area_fraction: f64,
}

/// The law that is nearest to a curve of pressure and area, and its distance from it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct GreenwoodTrippFit {
    /// The law.
    pub law: GreenwoodTripp,
    /// The least and the largest h/sigma of the points that count.
    pub range: [f64; 2],
    /// Root mean square, and largest absolute value, of ln(pressure of the law over that of the curve).
    pub ln_pressure_errors: [f64; 2],
    /// Root mean square, and largest absolute value, of ln(area of the law over that of the curve).
    pub ln_area_errors: [f64; 2],
}

impl GreenwoodTripp {
    /// Separations over sigma that count in a [`fit`](Self::fit): 0.5 to 3, with rounding.
    pub const FITTED: RangeInclusive<f64> = 0.499_999..=3.000_001;

    /// Least range of separations over sigma that tells one law from another.
    pub const LEAST_SPAN: f64 = 1.0;

    /// Creates the contact of two alike faces under a contact modulus E* \[Pa\], 1/E* the sum of (1 - nu^2)/E over both; `summits` has
    /// eta and beta of each face, and sigma of both together.
    ///
    /// # Errors
    /// [`AsperityError`] for a modulus that is not positive and within thirty decades of 1 ([`Bound::Magnitude`]).
    pub fn new(contact_modulus_pa: f64, summits: Population) -> Result<Self, AsperityError> {
        Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
        Ok(GreenwoodTripp { contact_modulus_pa, summits })
    }

    /// Creates the contact of two alike faces from the summits of their sum, which is one equivalent rough face on a plane. Each face
    /// has half of every spectral moment of the sum: its summits are as dense, have sqrt(2) of the radius, and the standard deviation
    /// of both together is that of the sum.
    ///
    /// # Errors
    /// [`AsperityError`] for values out of their bounds.
    pub fn from_sum(contact_modulus_pa: f64, sum: &Population) -> Result<Self, AsperityError> {
        let summits = Population::new(SQRT_2 * sum.radius_m(), sum.density_per_m2(), sum.sigma_s_m())?;
        Self::new(contact_modulus_pa, summits)
    }

    /// Creates the contact of two different faces. Where summits of the radii beta_1 and beta_2 meet at a distance r, they overlap by
    /// r^2/(2 (beta_1 + beta_2)) less, and touch like a sphere of the radius beta_1 beta_2/(beta_1 + beta_2). Pressure and area are
    /// those of two alike faces with beta = 2 beta_1 beta_2/(beta_1 + beta_2), (eta beta)^2 = eta_1 beta_1 eta_2 beta_2 and
    /// sigma^2 = sigma_1^2 + sigma_2^2.
    ///
    /// # Errors
    /// [`AsperityError`] for values out of their bounds.
    pub fn from_faces(contact_modulus_pa: f64, faces: [&Population; 2]) -> Result<Self, AsperityError> {
        let radius_m = 2.0 / faces.map(|face| 1.0 / face.radius_m()).iter().sum::<f64>();
        let [first, second] = faces.map(|face| (face.density_per_m2() * face.radius_m()).sqrt());
        let [sigma_1_m, sigma_2_m] = faces.map(Population::sigma_s_m);
        let summits = Population::new(radius_m, first * second / radius_m, sigma_1_m.hypot(sigma_2_m))?;
        Self::new(contact_modulus_pa, summits)
    }

    /// Fits the law to a curve by least squares of the logarithms of pressure and area, each point with the range of h/sigma that it
    /// stands for as weight; points outside of [`FITTED`](Self::FITTED) do not count. `sigma_m` \[m\] is known and not fitted: the
    /// amplitude of the area is (eta beta sigma)^2, that of the pressure (eta beta sigma)^2 sqrt(sigma/beta) E*. Pressures alone have
    /// neither eta nor beta; both follow from both amplitudes and sigma.
    ///
    /// `None` for points that span less than [`LEAST_SPAN`](Self::LEAST_SPAN) of the range, and amplitudes out of bounds.
    #[must_use]
    pub fn fit(
        contact_modulus_pa: f64,
        sigma_m: f64,
        points: &[SeparationPoint],
    ) -> Option<GreenwoodTrippFit> {
        let place = |point: &SeparationPoint| point.separation_m / sigma_m;
        let mut counted: Vec<_> =
            points.iter().filter(|point| Self::FITTED.contains(&place(point))).collect();
        counted.sort_by(|one, other| one.separation_m.total_cmp(&other.separation_m));
        let range = [place(counted.first()?), place(counted.last()?)];
        if range[1] - range[0] < Self::LEAST_SPAN {
            return None;
        }
        let last = counted.len() - 1;
        let mean = |of: &dyn Fn(&SeparationPoint) -> f64| {
            let weighted = (0..=last).map(|at| {
                let apart = place(counted[(at + 1).min(last)]) - place(counted[at.saturating_sub(1)]);
                0.5 * apart * of(counted[at])
            });
            weighted.sum::<f64>() / (range[1] - range[0])
        };
        let pressure = |law: &Self, point: &SeparationPoint| {
            (law.pressure_pa(point.separation_m) / point.pressure_pa).ln()
        };
        let area = |law: &Self, point: &SeparationPoint| {
            (law.area_fraction(point.separation_m) / point.area_fraction).ln()
        };
        let unit =
            Self::new(contact_modulus_pa, Population::new(sigma_m, sigma_m.powi(-2), sigma_m).ok()?).ok()?;
        let [ln_pressure, ln_area] =
            [mean(&|point| pressure(&unit, point)), mean(&|point| area(&unit, point))];
        let radius_m = sigma_m * (2.0 * (ln_pressure - ln_area)).exp();
        let density_per_m2 = (-0.5 * ln_area).exp() / (radius_m * sigma_m);
        let law =
            Self::new(contact_modulus_pa, Population::new(radius_m, density_per_m2, sigma_m).ok()?).ok()?;
        let errors = |of: &dyn Fn(&Self, &SeparationPoint) -> f64| {
            let largest = counted.iter().map(|point| of(&law, point).abs()).fold(0.0, f64::max);
            [mean(&|point| of(&law, point).powi(2)).sqrt(), largest]
        };
        let [ln_pressure_errors, ln_area_errors] = [errors(&pressure), errors(&area)];
        Some(GreenwoodTrippFit { law, range, ln_pressure_errors, ln_area_errors })
    }

    /// Summits of each face, with sigma of both together.
    #[must_use]
    pub fn summits(&self) -> &Population {
        &self.summits
    }

    /// The product eta beta sigma.
    #[must_use]
    pub fn density_radius_sigma(&self) -> f64 {
        self.summits.density_per_m2() * self.summits.radius_m() * self.summits.sigma_s_m()
    }

    /// The ratio sigma/beta.
    #[must_use]
    pub fn sigma_over_radius(&self) -> f64 {
        self.summits.sigma_s_m() / self.summits.radius_m()
    }

    /// Computes the nominal pressure \[Pa\] at a finite separation h \[m\] of either sign.
    #[must_use]
    pub fn pressure_pa(&self, separation_m: f64) -> f64 {
        let amplitude =
            16.0 * SQRT_2 * PI / 15.0 * self.density_radius_sigma().powi(2) * self.sigma_over_radius().sqrt();
        let moment = PartialMoment::FiveHalves.above(separation_m / self.summits.sigma_s_m());
        amplitude * self.contact_modulus_pa * moment
    }

    /// Computes the real over the nominal area at a finite separation h \[m\] of either sign. It is not limited to 1: beyond some
    /// hundredths neighbouring spots meet, which the law leaves out.
    #[must_use]
    pub fn area_fraction(&self, separation_m: f64) -> f64 {
        let moment = PartialMoment::Second.above(separation_m / self.summits.sigma_s_m());
        (PI * self.density_radius_sigma()).powi(2) * moment
    }
}
