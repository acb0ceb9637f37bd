//! Elastic contact of two rough faces (Greenwood & Tripp 1970, Proc. Inst. Mech. Eng. 185:625).

use std::f64::consts::{PI, SQRT_2};
use std::ops::RangeInclusive;

use asperity::{AsperityError, Bound};

use crate::{PartialMoment, Population};

/// Two rough faces whose spherical summits meet off their axes, both of eta summits per area and of the radius beta; sigma is the
/// standard deviation of the sum of their summit heights. With the separation h of the mean planes of the summits,
///
/// p = (16 sqrt(2) pi/15) (eta beta sigma)^2 sqrt(sigma/beta) E* F_5/2(h/sigma),  A/A_n = pi^2 (eta beta sigma)^2 F_2(h/sigma).
///
/// A rough face on a smooth one follows Greenwood & Williamson instead: [`StatisticalContact`](crate::StatisticalContact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodTripp {
    density_per_m2: f64,
    radius_m: f64,
    sigma_m: f64,
    contact_modulus_pa: f64,
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
    /// Separations over sigma that count in a [`fit`](Self::fit).
    pub const FITTED: RangeInclusive<f64> = 0.5..=3.0;

    /// Creates the contact of two alike faces: a contact modulus E* \[Pa\], 1/E* the sum of (1 - nu^2)/E over both, eta summits per
    /// area of each \[m^-2\], the radius beta of these \[m\], and sigma of both together \[m\].
    ///
    /// # Errors
    /// [`AsperityError`] unless all are positive and within thirty decades of 1 ([`Bound::Magnitude`]).
    pub fn new(
        contact_modulus_pa: f64,
        density_per_m2: f64,
        radius_m: f64,
        sigma_m: f64,
    ) -> Result<Self, AsperityError> {
        let alike = Population::new(radius_m, density_per_m2, sigma_m)?;
        Bound::Magnitude.check("contact modulus in Pa", contact_modulus_pa)?;
        Ok(Self::unchecked(contact_modulus_pa, alike.density_per_m2(), alike.radius_m(), sigma_m))
    }

    /// Creates the contact of two alike faces from the summits of their sum, which is one equivalent rough face on a plane. Each face
    /// has half of every spectral moment of the sum: its summits are as dense, have sqrt(2) of the radius, and the standard deviation
    /// of both together is that of the sum.
    ///
    /// # Errors
    /// [`AsperityError`] for a contact modulus \[Pa\] out of its bounds.
    pub fn from_sum(contact_modulus_pa: f64, sum: &Population) -> Result<Self, AsperityError> {
        Self::new(contact_modulus_pa, sum.density_per_m2(), SQRT_2 * sum.radius_m(), sum.sigma_s_m())
    }

    /// Creates the contact of two faces. Where summits of the radii beta_1 and beta_2 meet at a distance r, they overlap by
    /// r^2/(2 (beta_1 + beta_2)) less, and touch like a sphere of the radius beta_1 beta_2/(beta_1 + beta_2). Pressure and area are
    /// those of two alike faces with beta = 2 beta_1 beta_2/(beta_1 + beta_2), (eta beta)^2 = eta_1 beta_1 eta_2 beta_2 and
    /// sigma^2 = sigma_1^2 + sigma_2^2.
    ///
    /// # Errors
    /// [`AsperityError`] for a contact modulus \[Pa\] out of its bounds.
    pub fn from_faces(contact_modulus_pa: f64, faces: [&Population; 2]) -> Result<Self, AsperityError> {
        let [one, other] = faces.map(Population::radius_m);
        let radius_m = 2.0 / (1.0 / one + 1.0 / other);
        let [first, second] = faces.map(|face| (face.density_per_m2() * face.radius_m()).sqrt());
        let [sigma_1_m, sigma_2_m] = faces.map(Population::sigma_s_m);
        Self::new(contact_modulus_pa, first * second / radius_m, radius_m, sigma_1_m.hypot(sigma_2_m))
    }

    /// Fits the law to a curve of pressure and area by least squares of both logarithms, each point with the range of h/sigma that it
    /// stands for as weight; points outside of [`FITTED`](Self::FITTED) do not count. `sigma_m` \[m\] is that of the curve and is not
    /// fitted: the amplitude of the area is (eta beta sigma)^2, that of the pressure (eta beta sigma)^2 sqrt(sigma/beta) E*.
    /// Pressures alone have this amplitude and no eta or beta; eta and beta follow from both amplitudes and sigma.
    ///
    /// `None` for fewer than two separations in the range, and amplitudes out of bounds.
    #[must_use]
    pub fn fit(
        contact_modulus_pa: f64,
        sigma_m: f64,
        points: &[SeparationPoint],
    ) -> Option<GreenwoodTrippFit> {
        let over_sigma = |point: &SeparationPoint| point.separation_m / sigma_m;
        let mut counted: Vec<&SeparationPoint> =
            points.iter().filter(|point| Self::FITTED.contains(&over_sigma(point))).collect();
        counted.sort_by(|one, other| one.separation_m.total_cmp(&other.separation_m));
        let places: Vec<f64> = counted.iter().map(|point| over_sigma(point)).collect();
        let [least, most] = [*places.first()?, *places.last()?];
        let last = places.len() - 1;
        let weight = |at: usize| 0.5 * (places[(at + 1).min(last)] - places[at.saturating_sub(1)]);
        let mean = |of: &dyn Fn(&SeparationPoint) -> f64| {
            let sum: f64 = counted.iter().enumerate().map(|(at, point)| weight(at) * of(point)).sum();
            sum / (most - least)
        };
        let unit = Self::unchecked(contact_modulus_pa, 1.0 / (sigma_m * sigma_m), sigma_m, sigma_m);
        let ln_pressure = mean(&|point| (point.pressure_pa / unit.pressure_pa(point.separation_m)).ln());
        let ln_area = mean(&|point| (point.area_fraction / unit.area_fraction(point.separation_m)).ln());
        let radius_m = sigma_m * (2.0 * (ln_area - ln_pressure)).exp();
        let density_per_m2 = (0.5 * ln_area).exp() / (radius_m * sigma_m);
        let law = Self::new(contact_modulus_pa, density_per_m2, radius_m, sigma_m).ok()?;
        let errors = |of: &dyn Fn(&SeparationPoint) -> f64| {
            let largest = counted.iter().map(|point| of(point).abs()).fold(0.0, f64::max);
            [mean(&|point| of(point).powi(2)).sqrt(), largest]
        };
        Some(GreenwoodTrippFit {
            law,
            range: [least, most],
            ln_pressure_errors: errors(&|point| {
                (law.pressure_pa(point.separation_m) / point.pressure_pa).ln()
            }),
            ln_area_errors: errors(&|point| {
                (law.area_fraction(point.separation_m) / point.area_fraction).ln()
            }),
        })
    }

    fn unchecked(contact_modulus_pa: f64, density_per_m2: f64, radius_m: f64, sigma_m: f64) -> Self {
        GreenwoodTripp { density_per_m2, radius_m, sigma_m, contact_modulus_pa }
    }

    /// Summits per area of each face, eta \[m^-2\].
    #[must_use]
    pub fn density_per_m2(&self) -> f64 {
        self.density_per_m2
    }

    /// Radius of the summits of each face, beta \[m\].
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Standard deviation of the sum of the summit heights, sigma \[m\].
    #[must_use]
    pub fn sigma_m(&self) -> f64 {
        self.sigma_m
    }

    /// Contact modulus E* \[Pa\], 1/E* the sum of (1 - nu^2)/E over both bodies.
    #[must_use]
    pub fn contact_modulus_pa(&self) -> f64 {
        self.contact_modulus_pa
    }

    /// The product eta beta sigma.
    #[must_use]
    pub fn density_radius_sigma(&self) -> f64 {
        self.density_per_m2 * self.radius_m * self.sigma_m
    }

    /// The ratio sigma/beta.
    #[must_use]
    pub fn sigma_over_radius(&self) -> f64 {
        self.sigma_m / self.radius_m
    }

    /// Computes the nominal pressure \[Pa\] at a finite separation h \[m\] of either sign.
    #[must_use]
    pub fn pressure_pa(&self, separation_m: f64) -> f64 {
        let amplitude =
            16.0 * SQRT_2 * PI / 15.0 * self.density_radius_sigma().powi(2) * self.sigma_over_radius().sqrt();
        amplitude * self.contact_modulus_pa * PartialMoment::FiveHalves.above(separation_m / self.sigma_m)
    }

    /// Computes the real over the nominal area at a finite separation h \[m\] of either sign. It is not limited to 1: beyond some
    /// hundredths neighbouring spots meet, which the law leaves out.
    #[must_use]
    pub fn area_fraction(&self, separation_m: f64) -> f64 {
        (PI * self.density_radius_sigma()).powi(2) * PartialMoment::Second.above(separation_m / self.sigma_m)
    }
}
