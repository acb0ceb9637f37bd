//! A population under a law, asked for its state.

use asperity::{AsperityError, MaterialPair};

use crate::asperities::answers::Asperities;
use crate::asperities::bem_sines::BemSines;
use crate::asperities::elastic_plastic_sines::ElasticPlasticSines;
use crate::asperities::elastic_plastic_spheres::ElasticPlasticSpheres;
use crate::asperities::elastic_sines::ElasticSines;
use crate::asperities::gradient_sines::GradientSines;
use crate::asperities::hertz_spheres::ElasticSpheres;
use crate::quadrature::frames::Frames;
use crate::quadrature::precision::Precision;
use crate::{AsperityLaw, ContactState, InterferenceLaw, Population, Sweep};

/// Gaussian asperities pressed by a rigid flat (Greenwood & Williamson 1966; `docs/models.md`, section 3), under any of
/// the laws: p(d) = eta Int_0^inf F(w) g(d + w) dw, and the same of the area over the nominal one, held at 1.
#[derive(Debug)]
pub struct StatisticalContact {
    asperities: Box<dyn Asperities>,
    sigma_s_m: f64,
}

impl StatisticalContact {
    /// The contact of a population of a material under a law.
    #[must_use]
    pub fn new(pair: &MaterialPair, population: &Population, law: &AsperityLaw) -> Self {
        let asperities: Box<dyn Asperities> = match *law {
            AsperityLaw::Hertz => Box::new(ElasticSpheres::new(pair, population)),
            AsperityLaw::EpSphere { strength, hardness } => {
                Box::new(ElasticPlasticSpheres::new(pair, population, strength, hardness))
            }
            AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson } => {
                Box::new(ElasticSines::new(pair, population))
            }
            AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem } => {
                Box::new(BemSines::new(pair, population))
            }
            AsperityLaw::EpSine { strength } if strength.strain_gradient_length_m().is_none() => {
                let strength_pa = strength.macroscopic_strength_pa();
                Box::new(ElasticPlasticSines::new(pair, population, strength_pa))
            }
            AsperityLaw::EpSine { strength } => Box::new(GradientSines::new(pair, population, strength)),
        };
        StatisticalContact { asperities, sigma_s_m: population.sigma_s_m() }
    }

    /// The state at a separation d \[m\] from the mean of the asperity heights, of either sign, to a relative `tolerance`
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
