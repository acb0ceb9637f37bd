//! A population under a law, asked for its state.

use asperity::{AsperityError, MaterialPair};

use crate::asperities::answers::Asperities;
use crate::asperities::hertz_ellipses::ElasticSummits;
use crate::quadrature::frames::Frames;
use crate::quadrature::precision::Precision;
use crate::{AsperityLaw, ContactState, NayakSummits, Population, Sweep};

/// Gaussian asperities pressed by a rigid flat (Greenwood & Williamson 1966; `docs/theory/models.md`, section 3), under
/// any of the laws: p(d) = eta Int_0^inf F(w) g(d + w) dw, and the same of the area over the nominal one, held at 1. Or
/// the summits of a surface, of any curvature and height.
#[derive(Debug)]
pub struct StatisticalContact {
    asperities: Box<dyn Asperities>,
    /// Standard deviation of their heights; of those of the surface where they are its summits.
    sigma_s_m: f64,
}

impl StatisticalContact {
    /// The contact of a population of a material under a law.
    #[must_use]
    pub fn new(pair: &MaterialPair, population: &Population, law: &AsperityLaw) -> Self {
        let asperities = law.asperities(pair, population);
        StatisticalContact { asperities, sigma_s_m: population.sigma_s_m() }
    }

    /// The contact of the summits of a surface, elastic (Bush, Gibson & Thomas 1975; `docs/theory/models.md`, section
    /// 3.6). Its separations are from the mean plane of the surface.
    #[must_use]
    pub fn of_summits(pair: &MaterialPair, summits: &NayakSummits) -> Self {
        StatisticalContact {
            asperities: Box::new(ElasticSummits::new(pair, summits)),
            sigma_s_m: summits.m0_m2().sqrt(),
        }
    }

    /// The state at a separation d \[m\] from the mean of the asperity heights, or from the mean plane of a surface whose summits they
    /// are, of either sign, to a relative `tolerance`
    /// of pressure and area fraction (1e-13 to 1e-2; values outside are taken as the nearer end).
    ///
    /// # Errors
    /// [`AsperityError`] where the separation is not finite, or beyond 1e30 m.
    pub fn at_separation(&self, separation_m: f64, tolerance: f64) -> Result<ContactState, AsperityError> {
        self.sweep(tolerance).at_separation(separation_m)
    }

    /// The state that carries a pressure \[Pa\] over the nominal area, found to rounding on a quadrature of the relative
    /// `tolerance` of [`at_separation`](Self::at_separation). Where several separations carry it, the largest is taken.
    ///
    /// A neighbouring state as `start` saves a few evaluations and changes nothing else. A pressure that no
    /// separation carries (see [`highest_pressure_pa`](Self::highest_pressure_pa)) is answered with complete contact:
    /// no separation, and area fraction 1.
    ///
    /// # Errors
    /// [`AsperityError`] unless the pressure is positive and at most 1e60 Pa.
    pub fn at_pressure(
        &self,
        pressure_pa: f64,
        tolerance: f64,
        start: Option<&ContactState>,
    ) -> Result<ContactState, AsperityError> {
        self.sweep(tolerance).starting_at(start).at_pressure(pressure_pa)
    }

    /// States at many separations and pressures, to a relative `tolerance` as [`at_separation`](Self::at_separation) takes
    /// it, for less than as many single ones.
    pub fn sweep(&self, tolerance: f64) -> Sweep<'_> {
        Sweep::on(Frames::new(&*self.asperities, self.sigma_s_m, Precision::new(tolerance)))
    }

    /// The pressure \[Pa\] below which every pressure is carried at some separation: complete contact of every sinusoid, or
    /// the most that sinusoids softening with depth carry. Infinite for spheres.
    #[must_use]
    pub fn highest_pressure_pa(&self) -> f64 {
        self.sweep(Precision::FINEST).highest_pressure_pa()
    }
}
