//! Nominal contacts that are not flat: a deviation H over a length L, and two limits of what it does.
//!
//! One limit is a wave of wavelength 2 L and mean square height H^2/8: among the roughness, where who has the spectrum adds it, or as a
//! smooth ridge, which touches by Westergaard. The other is a spherical cap of height H on a disc of diameter L, R = L^2/(8 H), which
//! touches by Hertz on a part of the disc. Where the smooth bodies touch, the roughness has the local pressure.

use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

use numerics::GaussLegendre;
use serde::Serialize;
use units::{Bound, Length, OutOfBounds};

/// Deviation of a nominal contact from a plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Flatness {
    height_m: f64,
    span_m: f64,
}

/// A spherical cap pressed on a flat by Hertz's theory: the part of the nominal contact that it loads, and the gap around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cap {
    pressure_pa: f64,
    modulus_pa: f64,
    radius_of_cap_m: f64,
    /// Radius of the nominal contact \[m\].
    nominal_m: f64,
    /// Radius of the contact over that, at most 1.
    relative_radius: f64,
}

/// A straight wave pressed on a flat by the theory of Westergaard (1939), J. Appl. Mech. 6:A49.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ridge {
    pressure_pa: f64,
    modulus_pa: f64,
    wavelength_m: f64,
    /// Amplitude of the wave \[m\].
    amplitude_m: f64,
    /// Nominal pressure over that which flattens the wave, at most 1.
    relative_pressure: f64,
}

/// A smooth deviation from a plane under a nominal pressure.
pub trait Deviation {
    /// Share of the nominal contact over which contact spreads; 1 where all of it is loaded.
    fn share(&self) -> f64;

    /// Mean over the nominal contact of a quantity per area that depends on the local pressure \[Pa\], and is 0 outside the contact.
    fn mean_inside(&self, of: impl Fn(f64) -> f64) -> f64;

    /// Mean over the nominal contact of a quantity per area that depends on the gap \[m\] between the smooth bodies, and is 0 inside the
    /// contact.
    fn mean_outside(&self, of: impl Fn(f64) -> f64) -> f64;

    /// Compliance per nominal area \[m/Pa\] in excess of that of flat faces.
    fn compliance_m_per_pa(&self) -> f64;
}

/// Flatness that is not of the form `H over L`.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{text:?} is no flatness; write height over length, as 5 um over 40 mm{}", reason(.problem))]
pub struct FlatnessError {
    text: String,
    problem: Option<String>,
}

/// Factor, either way, by which both limits together miss gap, stiffness and heat of elements on surfaces with a real long wave
/// (`docs/develop/trials.md`).
pub const LIMITS_WITHIN: f64 = 1.2;

static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(24));

impl Flatness {
    /// Creates the flatness of a height H from valley to peak over a length L \[m\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive, within thirty decades of 1, and H is below a tenth of L.
    pub fn new(height_m: f64, span_m: f64) -> Result<Self, OutOfBounds> {
        let height_m = Bound::Magnitude.check("height of a flatness in m", height_m)?;
        let span_m = Bound::Magnitude.check("length of a flatness in m", span_m)?;
        let below_a_tenth = Bound::Between { above: 0.0, below: 0.1 };
        below_a_tenth.check("height of a flatness over its length", height_m / span_m)?;
        Ok(Flatness { height_m, span_m })
    }

    /// Height H from valley to peak \[m\].
    #[must_use]
    pub fn height_m(&self) -> f64 {
        self.height_m
    }

    /// Length L \[m\].
    #[must_use]
    pub fn span_m(&self) -> f64 {
        self.span_m
    }

    /// Wavelength 2 L \[m\] of the deviation as a wave.
    #[must_use]
    pub fn wavelength_m(&self) -> f64 {
        2.0 * self.span_m
    }

    /// Mean square height H^2/8 \[m^2\] of that wave.
    #[must_use]
    pub fn mean_square_height_m2(&self) -> f64 {
        self.height_m * self.height_m / 8.0
    }

    /// Nominal pressure \[Pa\] from which on the cap touches over the whole disc, 16 E* H/(3 pi L).
    #[must_use]
    pub fn flattening_pressure_pa(&self, modulus_pa: f64) -> f64 {
        16.0 / (3.0 * PI) * modulus_pa * (self.height_m / self.span_m)
    }

    /// Presses the deviation as a ridge under a nominal pressure p > 0 \[Pa\], with a contact modulus E* > 0 \[Pa\]. The wave is flat from
    /// pi E* (H/2)/(2 L) on.
    #[must_use]
    pub fn ridge(&self, pressure_pa: f64, modulus_pa: f64) -> Ridge {
        let (wavelength_m, amplitude_m) = (self.wavelength_m(), 0.5 * self.height_m);
        let flat_from_pa = PI * modulus_pa * (amplitude_m / wavelength_m);
        let relative_pressure = (pressure_pa / flat_from_pa).min(1.0);
        Ridge { pressure_pa, modulus_pa, wavelength_m, amplitude_m, relative_pressure }
    }

    /// Presses the deviation as a cap under a nominal pressure p > 0 \[Pa\] of the disc of diameter L, with a contact modulus E* > 0
    /// \[Pa\]: a^3 = 3 F R/(4 E*).
    #[must_use]
    pub fn cap(&self, pressure_pa: f64, modulus_pa: f64) -> Cap {
        let nominal_m = 0.5 * self.span_m;
        let radius_of_cap_m = self.span_m * (self.span_m / self.height_m) / 8.0;
        // In radii of the nominal contact, F = pi p and a^3 = (3 pi/4) (p/E*) (R/b).
        let cube = 0.75 * PI * (pressure_pa / modulus_pa) * (radius_of_cap_m / nominal_m);
        Cap { pressure_pa, modulus_pa, radius_of_cap_m, nominal_m, relative_radius: cube.cbrt().min(1.0) }
    }
}

impl Deviation for Cap {
    /// Returns (a/b)^2.
    fn share(&self) -> f64 {
        self.relative_radius * self.relative_radius
    }

    fn mean_inside(&self, of: impl Fn(f64) -> f64) -> f64 {
        if self.relative_radius >= 1.0 {
            return of(self.pressure_pa);
        }
        // p = p_0 t with t^2 = 1 - (r/a)^2, and p_0 one and a half times the mean.
        let peak_pa = 1.5 * self.pressure_pa / self.share();
        self.share() * RULE.over(0.0, 1.0).map(|(t, weight)| 2.0 * t * weight * of(peak_pa * t)).sum::<f64>()
    }

    fn mean_outside(&self, of: impl Fn(f64) -> f64) -> f64 {
        let from = self.relative_radius;
        RULE.over(from, 1.0).map(|(radius, weight)| 2.0 * radius * weight * of(self.gap_m(radius))).sum()
    }

    /// Returns psi/(2 E* a) per nominal area, of the constriction towards the contact, with psi = (1 - a/b)^1.5 (Cooper, Mikic &
    /// Yovanovich 1969, Int. J. Heat Mass Transfer 12:279).
    fn compliance_m_per_pa(&self) -> f64 {
        let narrows = (1.0 - self.relative_radius).powf(1.5);
        0.5 * PI * narrows * (self.nominal_m / self.modulus_pa) / self.relative_radius
    }
}

impl Cap {
    /// Gap \[m\] between the smooth bodies at a radius over that of the nominal contact (Johnson 1985, Contact Mechanics, Eq. 3.42):
    /// a^2/(pi R) \[sqrt(s^2 - 1) - (2 - s^2) arccos(1/s)\] at s = r/a.
    fn gap_m(&self, relative_radius: f64) -> f64 {
        let s = (relative_radius / self.relative_radius).max(1.0);
        let shape = (s * s - 1.0).sqrt() - (2.0 - s * s) * (1.0 / s).acos();
        let contact_m = self.relative_radius * self.nominal_m;
        contact_m / PI * (contact_m / self.radius_of_cap_m) * shape
    }
}

impl Deviation for Ridge {
    /// Returns 2 a/lambda, with sin^2(pi a/lambda) the pressure over that of a flat wave.
    fn share(&self) -> f64 {
        2.0 / PI * self.relative_pressure.sqrt().asin()
    }

    fn mean_inside(&self, of: impl Fn(f64) -> f64) -> f64 {
        // With s = sin(pi x/lambda) = s_a sin(theta), p = 2 pbar cos(pi x/lambda) cos(theta)/s_a.
        let edge = self.relative_pressure.sqrt();
        let at = |(theta, weight): (f64, f64)| {
            let cosine = (1.0 - (edge * theta.sin()).powi(2)).sqrt();
            let local_pa = 2.0 * self.pressure_pa * cosine * theta.cos() / edge;
            weight * edge * theta.cos() / cosine * of(local_pa)
        };
        if edge >= 1.0 {
            return of(self.pressure_pa);
        }
        2.0 / PI * RULE.over(0.0, 0.5 * PI).map(at).sum::<f64>()
    }

    fn mean_outside(&self, of: impl Fn(f64) -> f64) -> f64 {
        let edge = self.relative_pressure.sqrt();
        let nodes = RULE.over(edge.asin(), 0.5 * PI);
        2.0 / PI * nodes.map(|(angle, weight)| weight * of(self.gap_m(angle.sin()))).sum::<f64>()
    }

    /// Returns lambda/(pi E*) ln(p_flat/p), the derivative of the mean gap of the wave.
    fn compliance_m_per_pa(&self) -> f64 {
        self.wavelength_m / (PI * self.modulus_pa) * -self.relative_pressure.ln()
    }
}

impl Ridge {
    /// Gap \[m\] between the smooth bodies at s = sin(pi x/lambda), 2 Delta \[s sqrt(s^2 - s_a^2) - s_a^2 arcosh(s/s_a)\], from the
    /// pressure continued beyond the contact.
    fn gap_m(&self, sine: f64) -> f64 {
        let edge = self.relative_pressure.sqrt();
        let sine = sine.max(edge);
        let shape = sine * (sine * sine - edge * edge).sqrt() - edge * edge * (sine / edge).acosh();
        2.0 * self.amplitude_m * shape
    }
}

impl FromStr for Flatness {
    type Err = FlatnessError;

    /// Reads `5 um over 40 mm`.
    fn from_str(text: &str) -> Result<Self, FlatnessError> {
        let refused = |problem: Option<String>| FlatnessError { text: text.to_owned(), problem };
        let (height, span) = text.split_once(" over ").ok_or_else(|| refused(None))?;
        let length =
            |part: &str| part.trim().parse::<Length>().map_err(|error| refused(Some(error.to_string())));
        let (height, span) = (length(height)?, length(span)?);
        if height.m > span.m {
            return Err(refused(Some("the height comes first, and the length behind it".to_owned())));
        }
        Flatness::new(height.m, span.m).map_err(|error| refused(Some(error.to_string())))
    }
}

impl fmt::Display for Flatness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} over {}", units::display::length(self.height_m), units::display::length(self.span_m))
    }
}

fn reason(problem: &Option<String>) -> String {
    problem.as_ref().map_or_else(String::new, |problem| format!(": {problem}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flatness() -> Flatness {
        "5 um over 25 mm".parse().unwrap()
    }

    fn off(one: f64, other: f64) -> f64 {
        (one / other - 1.0).abs()
    }

    #[test]
    fn a_cap_touches_by_hertz() {
        let cap = flatness().cap(1e5, 38e9);
        // R = 15.625 m, F = 49.087 N: a^3 = 3 F R/(4 E*), a = 2.4740 mm.
        let force_n = 1e5 * PI * 0.0125f64.powi(2);
        let radius_m = (0.75 * force_n * 15.625 / 38e9).cbrt();
        assert!(off(cap.share(), (radius_m / 0.0125).powi(2)) < 1e-12);
        // The force is carried, whatever the pressure is where.
        assert!(off(cap.mean_inside(|pressure_pa| pressure_pa), 1e5) < 1e-12);
        assert!(off(cap.mean_inside(|_| 1.0), cap.share()) < 1e-12);
        assert!(off(cap.mean_outside(|_| 1.0), 1.0 - cap.share()) < 1e-12);
        // The stiffness of a Hertzian contact is 2 E* a.
        let narrows = (1.0 - radius_m / 0.0125).powf(1.5);
        let per_area = 2.0 * 38e9 * radius_m / (PI * 0.0125f64.powi(2));
        assert!(off(cap.compliance_m_per_pa(), narrows / per_area) < 1e-12);
    }

    #[test]
    fn the_gap_around_a_light_contact_is_the_cap() {
        // Half of the height is the mean of a paraboloid; the contact lies a^2/R deeper.
        let cap = flatness().cap(1.0, 38e9);
        let contact_m = cap.share().sqrt() * 0.0125;
        let by_shape_m = 2.5e-6 - contact_m * contact_m / 15.625;
        assert!(
            off(cap.mean_outside(|gap_m| gap_m), by_shape_m) < 0.01,
            "{}",
            cap.mean_outside(|gap_m| gap_m)
        );
        assert!(cap.gap_m(cap.share().sqrt()).abs() < 1e-20);
        // At twice the radius of the contact, 3.8264 a^2/(pi R).
        let at_two = cap.gap_m(2.0 * cap.share().sqrt()) * PI * 15.625 / (contact_m * contact_m);
        assert!(off(at_two, 3f64.sqrt() + 2.0 * PI / 3.0) < 1e-12, "{at_two}");
    }

    #[test]
    fn a_ridge_touches_by_westergaard() {
        // E* Delta/lambda pi = 38e9 * 2.5e-6/50e-3 pi = 5.969 MPa.
        let flat_pa = PI * 38e9 * 2.5e-6 / 50e-3;
        for relative in [1e-4_f64, 0.03, 0.4, 0.95] {
            let ridge = flatness().ridge(relative * flat_pa, 38e9);
            assert!(off((0.5 * PI * ridge.share()).sin().powi(2), relative) < 1e-12);
            assert!(off(ridge.mean_inside(|pressure_pa| pressure_pa), relative * flat_pa) < 1e-10);
            assert!(off(ridge.mean_inside(|_| 1.0), ridge.share()) < 1e-6);
            // The mean gap is Delta [1 - P (1 - ln P)] at P = p/p_flat, and its slope is the compliance.
            let mean_m = 2.5e-6 * (1.0 - relative * (1.0 - relative.ln()));
            assert!(off(ridge.mean_outside(|gap_m| gap_m), mean_m) < 1e-3, "{relative}");
            let slope = 2.5e-6 / flat_pa * -relative.ln();
            assert!(off(ridge.compliance_m_per_pa(), slope) < 1e-10);
        }
    }

    #[test]
    fn what_is_pressed_flat_is_flat() {
        let cap = flatness().cap(1e9, 38e9);
        assert_eq!(
            (cap.share(), cap.mean_outside(|gap_m| gap_m), cap.compliance_m_per_pa()),
            (1.0, 0.0, 0.0)
        );
        let ridge = flatness().ridge(1e9, 38e9);
        assert_eq!(
            (ridge.share(), ridge.mean_outside(|gap_m| gap_m), ridge.compliance_m_per_pa()),
            (1.0, 0.0, 0.0)
        );
        assert_eq!(cap.mean_inside(|pressure_pa| pressure_pa), 1e9);
        let from_pa = flatness().flattening_pressure_pa(38e9);
        assert!(flatness().cap(0.999 * from_pa, 38e9).share() < 1.0);
        assert_eq!(flatness().cap(1.001 * from_pa, 38e9).share(), 1.0);
    }

    #[test]
    fn flatness_is_typed_as_height_over_length() {
        let read = flatness();
        assert!(off(read.height_m(), 5e-6) < 1e-15 && off(read.span_m(), 25e-3) < 1e-15);
        assert!(off(read.mean_square_height_m2(), 25e-12 / 8.0) < 1e-14);
        assert_eq!(read.to_string().parse(), Ok(read));
        for wrong in
            ["5 um", "5 over 25 mm", "5 um over 25", "25 mm over 5 um", "0 um over 25 mm", "5 um/25 mm"]
        {
            assert!(wrong.parse::<Flatness>().is_err(), "{wrong}");
        }
    }
}
