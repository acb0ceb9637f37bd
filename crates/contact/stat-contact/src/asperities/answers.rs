//! What a quadrature and a search need to know of a population's law.

use super::pieces::Piece;
use crate::summits::integrals::SummitIntegrals;

/// What a population answers if every asperity were pressed to the same interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Response {
    /// eta F \[Pa\].
    pub pressure_pa: f64,
    /// eta A.
    pub area_fraction: f64,
}

/// A population under a contact law.
///
/// What has a default is what a law without the feature answers: no saturation, no kink, a force that rises for ever.
pub(crate) trait Asperities: std::fmt::Debug + Send + Sync {
    /// The response at an interference > 0 \[m\].
    fn at_interference(&self, interference_m: f64) -> Response;

    /// The responses \[Pa, 1\] at interferences > 0 \[m\] that no break of the law divides.
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

    /// The responses' pressures \[Pa\] alone, at interferences > 0 \[m\] wherever the breaks are.
    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.at_interference(*w).pressure_pa;
        }
    }

    /// Hertz's law, where asperities follow it at first.
    fn hertzian(&self) -> Option<Hertzian> {
        None
    }

    /// The summits, where curvatures are spread as well as heights: their integrals take the place of everything but
    /// [`at_interference`](Self::at_interference).
    fn summits(&self) -> Option<&SummitIntegrals> {
        None
    }

    /// The smooth pieces that cover the interferences from `low_m` to `high_m`, in rising order; those outside may be
    /// left out. The last one ends at infinity or where [`saturation`](Self::saturation) begins.
    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece<'_>>;

    /// The interference from which on the response no longer changes, and that response.
    fn saturation(&self) -> Option<(f64, Response)> {
        None
    }

    /// The interference \[m\] of the kink that shows most, where one stands out: complete contact.
    fn strongest_kink_m(&self) -> Option<f64> {
        self.saturation().map(|(from_m, _)| from_m)
    }

    /// The intervals of interference \[m\], below `high_m`, in which the law is used beyond what it was fitted to.
    fn out_of_fitted_range(&self, _high_m: f64) -> Vec<(f64, f64)> {
        Vec::new()
    }

    /// The largest eta F \[Pa\] at any interference, infinite where it grows without end.
    fn highest_response_pa(&self) -> f64 {
        f64::INFINITY
    }

    /// How the force goes with the interference, seen through a Gaussian of standard deviation `sigma_s_m`.
    fn course(&self, _sigma_s_m: f64) -> Course {
        Course::Rises
    }

    /// For a force that rises on the whole: interferences \[m\] between which it falls smoothly, where it does.
    fn dip_m(&self) -> Option<[f64; 2]> {
        None
    }

    /// For a force with a maximum: an interference \[m\] from which on it certainly falls.
    fn falls_from_m(&self) -> Option<f64> {
        None
    }
}

/// A population that is Hertz's at small interferences.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hertzian {
    /// The interference \[m\] up to which every asperity is.
    pub until_m: f64,
    /// The area fraction per interference \[1/m\].
    pub area_per_m: f64,
    /// eta F per interference^(3/2) \[Pa/m^1.5\].
    pub pressure_per_three_halves: f64,
}

/// How a force goes with the interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Course {
    /// It never falls.
    Rises,
    /// It rises to a maximum and falls from there on. `certain` unless further maxima may follow, which are not looked for.
    Peaks { certain: bool },
    /// It steps down at one interference \[m\] and rises elsewhere.
    StepsDown { at_m: f64 },
}
