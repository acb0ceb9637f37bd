//! State of a contact at one separation.

use approx::{AbsDiffEq, RelativeEq};

use crate::asperities::answers::{Asperities, Response};
use crate::exponential::{ExponentialSpheres, ExponentialState};
use crate::gaussian::density::{log_reference_density, reference_density, tail};

/// State of a population in contact with a flat.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct ContactState {
    /// Separation d \[m\] of the flat from the mean of the asperity heights or, for summits, from the mean plane of
    /// the surface; negative below it. `None` if no separation carries the pressure.
    pub separation_m: Option<f64>,
    /// Pressure over the nominal area \[Pa\]; zero if it is below the smallest double, see `ln_pressure_pa`.
    pub pressure_pa: f64,
    /// Real over nominal area of contact, in \[0, 1\]; zero if it is below the smallest double.
    pub area_fraction: f64,
    /// Natural logarithm of the pressure in Pa.
    pub ln_pressure_pa: f64,
    /// Natural logarithm of the area fraction, at most 0.
    pub ln_area_fraction: f64,
    /// Cautious estimate of the relative numerical error of pressure and area fraction at the separation, not of the
    /// law.
    pub error_estimate: f64,
    /// Number of evaluations of the law of one asperity; 0 if the integrals have a closed form.
    pub evaluations: usize,
    /// Share of the load, in \[0, 1\], carried by asperities outside the range their law was fitted in: those that
    /// yield with Sy/E* > 0.01 or a/R > 0.41 (spheres) or r > 100 (sinusoids); 0 for elastic laws.
    pub out_of_range_load_share: f64,
    /// Share of the touching asperities, in \[0, 1\], that are flattened and carry no more than they do; `None` for laws
    /// that hold no force.
    pub flattened_share: Option<f64>,
    /// True if the sum of the areas exceeds the nominal area by more than its error, and was limited to it.
    pub clamped: bool,
    /// Separation over which the pressure would fall by a factor e at the current slope \[m\]: -p/(dp/dd).
    #[serde(skip)]
    pub(crate) decay_length_m: Option<f64>,
}

/// Reason why no separation carries a pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoSeparation {
    /// It is beyond complete contact of every asperity: the area fraction is 1.
    CompleteContact,
    /// It is more than all flattened asperities carry: the area is that of all of them, and the real one is at least
    /// as large.
    AllFlattened,
}

impl ContactState {
    /// Returns the reason why no separation carries the pressure; `None` if one does.
    #[must_use]
    pub fn no_separation(&self) -> Option<NoSeparation> {
        let is_complete = self.area_fraction == 1.0;
        let reason = if is_complete { NoSeparation::CompleteContact } else { NoSeparation::AllFlattened };
        self.separation_m.is_none().then_some(reason)
    }

    /// Stiffness K = -dp/dd over the nominal area \[Pa/m\]. The separation enters the integral over the heights by
    /// their density alone, g'(z) = -z g(z)/sigma_s^2, so that K = p z/sigma_s^2, with z the mean height of the
    /// asperities at the flat, weighted by their load. No force is differentiated: kinks cost nothing, and where a
    /// force steps, K includes the asperities on the step. Negative where the pressure falls as the surfaces
    /// approach.
    ///
    /// `None` if the contact is complete, and from a million standard deviations below the mean down, where all
    /// heights are taken as one.
    #[must_use]
    pub fn stiffness_pa_per_m(&self) -> Option<f64> {
        self.decay_length_m.map(|decay_length_m| self.pressure_pa / decay_length_m)
    }

    /// State of spheres with exponential heights at a separation \[m\].
    pub(crate) fn of_exponential(spheres: &ExponentialSpheres, separation_m: f64) -> Self {
        let ExponentialState { ln_pressure_pa, ln_area_fraction, decay_length_m } =
            spheres.at_separation(separation_m);
        ContactState {
            separation_m: Some(separation_m),
            pressure_pa: ln_pressure_pa.exp(),
            area_fraction: ln_area_fraction.exp().min(1.0),
            ln_pressure_pa,
            ln_area_fraction: ln_area_fraction.min(0.0),
            error_estimate: 4.0 * f64::EPSILON * (1.0 + ln_pressure_pa.abs()),
            evaluations: 0,
            out_of_range_load_share: 0.0,
            flattened_share: None,
            clamped: ln_area_fraction > 0.0,
            decay_length_m: Some(decay_length_m),
        }
    }

    /// State of integrals at a separation \[m\] that is u sigma_s within rounding. The caller fills in the evaluations.
    #[inline]
    pub(crate) fn at_separation(integrals: &Integrals, separation_m: f64, sigma_s_m: f64) -> Self {
        // ln p falls like u^2/2: at sixty sigma the rounding of u itself shows in the thirteenth digit of p.
        let rounding = (-integrals.u).mul_add(sigma_s_m, separation_m) / sigma_s_m;
        let state = Self::of(integrals, rounding, sigma_s_m);
        ContactState { separation_m: Some(separation_m), ..state }
    }

    /// State of integrals at the separation u + rounding, in units of sigma_s. The caller fills in the separation in
    /// metres and the evaluations.
    #[inline]
    pub(crate) fn of(integrals: &Integrals, rounding: f64, sigma_s_m: f64) -> Self {
        let &Integrals { u, mean_height, .. } = integrals;
        let correction = -mean_height * rounding;
        let log_density = log_reference_density(u) + correction;
        let scale = reference_density(u) * (1.0 + correction);
        let pressure = Product::new(integrals.pressure_pa, scale, log_density);
        let area_fraction = Product::new(integrals.area_fraction, scale, log_density);
        ContactState {
            separation_m: None,
            pressure_pa: pressure.value,
            area_fraction: area_fraction.value.min(1.0),
            ln_pressure_pa: pressure.logarithm,
            ln_area_fraction: area_fraction.logarithm.min(0.0),
            error_estimate: integrals.relative_error,
            evaluations: 0,
            out_of_range_load_share: integrals.out_of_range_load_share,
            flattened_share: None,
            clamped: area_fraction.logarithm > integrals.relative_error,
            decay_length_m: Some(sigma_s_m / mean_height),
        }
    }

    /// State with every asperity pressed to the interference -d; `neglected` is the relative error of leaving out the
    /// spread.
    pub(crate) fn without_spread(separation_m: f64, response: &Response, neglected: f64) -> Self {
        // Share 1/u^2 of the response that the spread would change, at the depth from which it is left out.
        const ROUNDING: f64 = 1e-12;
        // Evaluations at the mean height and beside it.
        const EVALUATIONS: usize = 3;
        ContactState {
            separation_m: Some(separation_m),
            pressure_pa: response.pressure_pa,
            area_fraction: response.area_fraction.min(1.0),
            ln_pressure_pa: response.pressure_pa.ln(),
            ln_area_fraction: response.area_fraction.ln().min(0.0),
            error_estimate: ROUNDING + neglected,
            evaluations: EVALUATIONS,
            out_of_range_load_share: 0.0,
            flattened_share: None,
            clamped: response.area_fraction > 1.0,
            decay_length_m: None,
        }
    }

    /// State under a pressure \[Pa\] that no separation carries: complete contact, or all asperities flattened with
    /// less area than the nominal one.
    pub(crate) fn beyond(asperities: &dyn Asperities, pressure_pa: f64) -> Self {
        let flattened = asperities.flattened_from_m().and(asperities.saturation());
        let area_fraction = flattened.map_or(1.0, |(_, response)| response.area_fraction.min(1.0));
        ContactState {
            separation_m: None,
            pressure_pa,
            area_fraction,
            ln_pressure_pa: pressure_pa.ln(),
            ln_area_fraction: area_fraction.ln(),
            error_estimate: 0.0,
            evaluations: 0,
            out_of_range_load_share: if area_fraction == 1.0 { 0.0 } else { 1.0 },
            flattened_share: flattened.map(|_| 1.0),
            clamped: false,
            decay_length_m: None,
        }
    }

    /// Returns this state, of a separation, with the share of flattened asperities.
    #[inline]
    pub(crate) fn with_flattened_share(self, asperities: &dyn Asperities, sigma_s_m: f64) -> Self {
        let share = |separation_m: f64| {
            let (u, from) = (separation_m / sigma_s_m, asperities.flattened_from_m()? / sigma_s_m);
            Some((tail(u, from) / tail(u, 0.0)).min(1.0))
        };
        ContactState { flattened_share: self.separation_m.map_or(self.flattened_share, share), ..self }
    }

    /// Largest deviation between the quantities of two states, each relative to the larger: pressure and area (also
    /// where they underflow), and the separations, which must both be present or absent.
    fn largest_deviation(&self, other: &Self) -> f64 {
        let relative = |a: f64, b: f64| if a == b { 0.0 } else { (a - b).abs() / a.abs().max(b.abs()) };
        let separations = match (self.separation_m, other.separation_m) {
            (Some(a), Some(b)) => relative(a, b),
            (None, None) => 0.0,
            _ => f64::INFINITY,
        };
        let logarithmic = |a: f64, b: f64| if a == b { 0.0 } else { (a - b).abs() };
        separations
            .max(logarithmic(self.ln_pressure_pa, other.ln_pressure_pa))
            .max(logarithmic(self.ln_area_fraction, other.ln_area_fraction))
    }
}

/// Integrals at one separation, over the reference density there, as a state needs them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Integrals {
    /// Separation in units of sigma_s.
    pub u: f64,
    pub pressure_pa: f64,
    pub area_fraction: f64,
    /// Mean height u + s of the asperities, weighted by load.
    pub mean_height: f64,
    /// Estimate of the larger relative error of pressure and area.
    pub relative_error: f64,
    /// Share of the load outside the range that the law was fitted in.
    pub out_of_range_load_share: f64,
}

/// Integral times density, and its logarithm.
struct Product {
    value: f64,
    logarithm: f64,
}

impl Product {
    /// Multiplies a positive integral over the reference density by that density, given with its logarithm.
    fn new(sum: f64, density: f64, log_density: f64) -> Self {
        // If the density is subnormal, its product with a large number may not be.
        let value = sum * density;
        if density.is_normal() && value.is_normal() {
            return Product { value, logarithm: value.ln() };
        }
        let logarithm = sum.ln() + log_density;
        Product { value: if density.is_normal() { value } else { logarithm.exp() }, logarithm }
    }
}

impl AbsDiffEq for ContactState {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::EPSILON
    }

    /// Compares relatively, as [`RelativeEq`] does: the quantities of a state have different units.
    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.largest_deviation(other) <= epsilon
    }
}

impl RelativeEq for ContactState {
    fn default_max_relative() -> f64 {
        1e-10
    }

    /// Returns true if separation, pressure and area fraction agree; cost and error estimates may differ.
    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        self.largest_deviation(other) <= max_relative.max(epsilon)
    }
}
