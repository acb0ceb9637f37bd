//! Properties of a population's law that quadratures and searches use.

use super::pieces::Piece;
use crate::exponential::ExponentialSpheres;
use crate::summits::integrals::SummitIntegrals;

/// Response of a population whose asperities are all pressed to the same interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Response {
    /// Pressure eta F \[Pa\].
    pub pressure_pa: f64,
    /// Area fraction eta A.
    pub area_fraction: f64,
}

/// A population under a contact law.
///
/// The default methods describe a law without the feature: no saturation, no kink, a force that always rises.
pub(crate) trait Asperities: std::fmt::Debug + Send + Sync {
    /// The response at an interference > 0 \[m\].
    fn at_interference(&self, interference_m: f64) -> Response;

    /// The responses \[Pa, 1\] at interferences > 0 \[m\] between which the law has no break.
    fn at_interferences(
        &self,
        interferences_m: &[f64],
        pressures_pa: &mut [f64],
        area_fractions: &mut [f64],
    ) {
        for ((w, pressure_pa), area_fraction) in interferences_m.iter().zip(pressures_pa).zip(area_fractions)
        {
            let response = self.at_interference(*w);
            (*pressure_pa, *area_fraction) = (response.pressure_pa, response.area_fraction);
        }
    }

    /// The pressures \[Pa\] of the responses alone, at interferences > 0 \[m\] on any side of the breaks.
    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.at_interference(*w).pressure_pa;
        }
    }

    /// Hertz's law, if asperities follow it at small interferences.
    fn hertzian(&self) -> Option<Hertzian> {
        None
    }

    /// Integrals over summits, if curvatures are spread as well as heights. They replace everything but
    /// [`at_interference`](Self::at_interference).
    fn summits(&self) -> Option<&SummitIntegrals> {
        None
    }

    /// Spheres with exponential heights, if these are no Gaussian ones. They replace everything else.
    fn exponential(&self) -> Option<&ExponentialSpheres> {
        None
    }

    /// Smooth pieces that cover the interferences from `low_m` to `high_m`, in rising order; pieces outside may be
    /// left out. The last one ends at infinity or where [`saturation`](Self::saturation) begins.
    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>>;

    /// Interference from which on the response no longer changes, and that response.
    fn saturation(&self) -> Option<(f64, Response)> {
        None
    }

    /// Interference \[m\] from which on an asperity is flattened and carries no more, if that is not complete contact.
    fn flattened_from_m(&self) -> Option<f64> {
        None
    }

    /// Interference \[m\] of the strongest kink, if one stands out: complete contact.
    fn strongest_kink_m(&self) -> Option<f64> {
        self.saturation().map(|(from_m, _)| from_m)
    }

    /// Intervals of interference \[m\], below `high_m`, in which the law is used beyond its fitted range.
    fn out_of_fitted_range(&self, _high_m: f64) -> Vec<(f64, f64)> {
        Vec::new()
    }

    /// Largest eta F \[Pa\] at any interference; infinite if it grows without bound.
    fn highest_response_pa(&self) -> f64 {
        self.saturation().map_or(f64::INFINITY, |(_, response)| response.pressure_pa)
    }

    /// Shape of the force over the interference, smoothed by a Gaussian of standard deviation `sigma_s_m`.
    fn course(&self, _sigma_s_m: f64) -> Course {
        Course::Rises
    }

    /// Interferences \[m\] between which a force that otherwise rises falls smoothly, if it does.
    fn dip_m(&self) -> Option<[f64; 2]> {
        None
    }

    /// Interference \[m\] from which on a force with a maximum certainly falls.
    fn falls_from_m(&self) -> Option<f64> {
        None
    }
}

/// Population that follows Hertz's law at small interferences.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hertzian {
    /// Interference \[m\] up to which every asperity follows it.
    pub until_m: f64,
    /// Area fraction per interference \[1/m\].
    pub area_per_m: f64,
    /// Pressure eta F per interference^(3/2) \[Pa/m^1.5\].
    pub pressure_per_three_halves: f64,
}

/// Shape of a force over the interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Course {
    /// It never falls.
    Rises,
    /// It rises to a maximum and falls from there on. `certain` unless further maxima may follow, which are not
    /// searched for.
    Peaks { certain: bool },
    /// It steps down at one interference \[m\] and rises elsewhere.
    StepsDown { at_m: f64 },
}
