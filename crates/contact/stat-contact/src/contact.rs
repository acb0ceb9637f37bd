//! Contact of a population under a law.

use asperity::{AsperityError, MaterialPair};

use crate::asperities::answers::Asperities;
use crate::asperities::exponential_heights::ExponentialHeights;
use crate::asperities::hertz_ellipses::ElasticSummits;
use crate::quadrature::Precision;
use crate::quadrature::frames::Frames;
use crate::{AsperityLaw, Condition, ContactState, NayakSummits, Population, StateTable, Sweep};

/// Gaussian asperities pressed by a rigid flat (Greenwood & Williamson 1966; `docs/theory/models.md`, section 3) under any
/// of the laws: p(d) = eta Int_0^inf F(w) g(d + w) dw, and likewise the area over the nominal one, limited to 1.
/// Alternatively the summits of a surface, with their spread of curvature and height.
#[derive(Debug)]
pub struct StatisticalContact {
    asperities: Box<dyn Asperities>,
    /// Standard deviation of the asperity heights; for summits, of the surface heights.
    sigma_s_m: f64,
}

impl StatisticalContact {
    /// Creates the contact of a population of a material under a law.
    #[must_use]
    pub fn new(pair: &MaterialPair, population: &Population, law: &AsperityLaw) -> Self {
        let asperities = law.asperities(pair, population);
        StatisticalContact { asperities, sigma_s_m: population.sigma_s_m() }
    }

    /// Creates the contact of elastic spheres with exponential heights
    /// ([`SummitHeights::Exponential`](crate::SummitHeights::Exponential)).
    #[must_use]
    pub fn from_exponential(pair: &MaterialPair, population: &Population) -> Self {
        let asperities = Box::new(ExponentialHeights::new(pair, population));
        StatisticalContact { asperities, sigma_s_m: population.sigma_s_m() }
    }

    /// Creates the elastic contact of the summits of a surface (Bush, Gibson & Thomas 1975; `docs/theory/models.md`, section
    /// 3.6). Its separations are measured from the mean plane of the surface.
    #[must_use]
    pub fn from_summits(pair: &MaterialPair, summits: &NayakSummits) -> Self {
        StatisticalContact {
            asperities: Box::new(ElasticSummits::new(pair, summits)),
            sigma_s_m: summits.m0_m2().sqrt(),
        }
    }

    /// Returns the state at a separation d \[m\], of either sign, from the mean of the asperity heights or, for
    /// summits, from the mean plane of the surface. `tolerance` is the relative error of pressure and area fraction,
    /// limited to 1e-13 to 1e-2.
    ///
    /// # Errors
    /// [`AsperityError`] if the separation is not finite, or beyond 1e30 m.
    pub fn at_separation(&self, separation_m: f64, tolerance: f64) -> Result<ContactState, AsperityError> {
        self.sweep(tolerance).at_separation(separation_m)
    }

    /// Returns the state that carries a pressure \[Pa\] over the nominal area, found to rounding on a quadrature of
    /// the relative `tolerance` of [`at_separation`](Self::at_separation). If several separations carry it, the
    /// largest is taken.
    ///
    /// A neighbouring state as `start` saves a few evaluations and changes nothing else. For a pressure that no
    /// separation carries (see [`highest_pressure_pa`](Self::highest_pressure_pa)) the state has no separation, the reason
    /// why, and the area fraction 1 of complete contact or that of all flattened asperities.
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

    /// Returns the state at a pressure, which a neighbouring state as `start` makes cheaper, or at a separation.
    ///
    /// # Errors
    /// The errors of [`at_pressure`](Self::at_pressure) and [`at_separation`](Self::at_separation).
    pub fn at(
        &self,
        condition: Condition,
        tolerance: f64,
        start: Option<&ContactState>,
    ) -> Result<ContactState, AsperityError> {
        self.sweep(tolerance).starting_at(start).at(condition)
    }

    /// Computes states at many separations and pressures, to a relative `tolerance` as in
    /// [`at_separation`](Self::at_separation), for less than as many single calls.
    pub fn sweep(&self, tolerance: f64) -> Sweep<'_> {
        Sweep::on(self.frames(tolerance))
    }

    /// Tabulates the states between two conditions, to a relative `tolerance` as in
    /// [`at_separation`](Self::at_separation): for a hundred states and more, at tolerances of some digits.
    ///
    /// # Errors
    /// The errors of [`at_pressure`](Self::at_pressure) and [`at_separation`](Self::at_separation).
    pub fn table(&self, ends: [Condition; 2], tolerance: f64) -> Result<StateTable<'_>, AsperityError> {
        StateTable::new(self.frames(tolerance), ends)
    }

    fn frames(&self, tolerance: f64) -> Frames<'_> {
        Frames::new(&*self.asperities, self.sigma_s_m, Precision::new(tolerance))
    }

    /// Pressure \[Pa\] below which every pressure is carried at some separation: complete contact of every sinusoid,
    /// the highest pressure of sinusoids that soften with depth, or all spheres flattened. Infinite for spheres whose
    /// force is not held.
    #[must_use]
    pub fn highest_pressure_pa(&self) -> f64 {
        self.sweep(Precision::FINEST).highest_pressure_pa()
    }
}
