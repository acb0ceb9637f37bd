//! A population under a law, asked for its state.

use asperity::{AsperityError, Bound, MaterialPair};

use crate::asperities::Asperities;
use crate::cell::Precision;
use crate::far::FarBelow;
use crate::frame::{Frame, Sums};
use crate::frames::Frames;
use crate::gaussian::{log_reference_density, reference_density};
use crate::gradient_sine::GradientSines;
use crate::search::{Found, Neighbour, Search};
use crate::sine::{BemSines, ElasticPlasticSines, ElasticSines};
use crate::sphere::{ElasticPlasticSpheres, ElasticSpheres};
use crate::{AsperityLaw, ContactState, InterferenceLaw, Population, Sweep};

/// A state, and where the next one may be looked for.
pub(crate) struct Carried {
    pub state: ContactState,
    /// `None` where the state was found without a frame.
    pub near: Option<Neighbour>,
}

/// Gaussian asperities pressed by a rigid flat (Greenwood & Williamson 1966; `docs/models.md`, section 3), under any of
/// the laws: p(d) = eta Int_0^inf F(w) g(d + w) dw, and the same of the area over the nominal one, held at 1.
#[derive(Debug)]
pub struct StatisticalContact {
    asperities: Box<dyn Asperities>,
    sigma_s_m: f64,
}

impl StatisticalContact {
    /// Pressures \[Pa\] that may be asked for.
    const PRESSURE_PA: Bound = Bound::LeftOpen { above: 0.0, at_most: 1e60 };

    /// The contact of a population of a material under a law.
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
        self.carried_at(separation_m, &mut self.frames(tolerance)).map(|at| at.state)
    }

    /// States at many separations and pressures, to a relative `tolerance` as [`at_separation`](Self::at_separation) takes
    /// it, for less than as many single ones.
    pub fn sweep(&self, tolerance: f64) -> Sweep<'_> {
        Sweep::new(self, self.frames(tolerance))
    }

    /// The state at a separation \[m\], on frames that may be there already.
    pub(crate) fn carried_at<'a>(
        &'a self,
        separation_m: f64,
        frames: &mut Frames<'a>,
    ) -> Result<Carried, AsperityError> {
        let separation_m = Bound::Signed.check("separation in m", separation_m)?;
        if let Some(state) = self.far_below().at_separation(separation_m) {
            return Ok(Carried { state, near: None });
        }
        let u = separation_m / self.sigma_s_m;
        // ln p falls like u^2/2: at sixty sigma the rounding of u itself shows in the thirteenth digit of p.
        let rounding = (-u).mul_add(self.sigma_s_m, separation_m) / self.sigma_s_m;
        let spent = frames.evaluations;
        let frame = frames.at(u);
        let (state, sums) = (self.state_on(frame, u, rounding), frame.sums_at(u));
        let evaluations = frames.evaluations - spent;
        let state = ContactState { separation_m: Some(separation_m), evaluations, ..state };
        Ok(Carried { state, near: Some(Neighbour { u, sums: Some(sums) }) })
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
        let near = start.and_then(|state| state.separation_m).map(|d| d / self.sigma_s_m);
        let near = near.map(|u| Neighbour { u, sums: None });
        self.carrying(pressure_pa, near, &mut self.frames(tolerance)).map(|carrying| carrying.state)
    }

    /// The state that carries a pressure \[Pa\], on frames that may be there already.
    pub(crate) fn carrying<'a>(
        &'a self,
        pressure_pa: f64,
        near: Option<Neighbour>,
        frames: &mut Frames<'a>,
    ) -> Result<Carried, AsperityError> {
        let complete = |pressure_pa| Ok(Carried { state: ContactState::complete(pressure_pa), near: None });
        let pressure_pa = Bound::Positive.check("pressure in Pa", pressure_pa)?;
        let pressure_pa = Self::PRESSURE_PA.check("pressure in Pa", pressure_pa)?;
        if pressure_pa >= self.asperities.highest_response_pa() {
            return complete(pressure_pa);
        }
        let far_below = self.far_below();
        // Where the highest pressure is carried far below, no nearer separation carries more.
        if far_below.highest_pressure_pa().is_some_and(|highest_pa| pressure_pa > highest_pa) {
            return complete(pressure_pa);
        }
        if let Some(separation_m) = far_below.separation_m(pressure_pa.ln()) {
            let state = far_below.state(separation_m);
            let state = ContactState { pressure_pa, ln_pressure_pa: pressure_pa.ln(), ..state };
            return Ok(Carried { state, near: None });
        }
        let spent = frames.evaluations;
        let Some(Found { cell, u }) = (Search { frames, pressure_pa }).run(near) else {
            return complete(pressure_pa);
        };
        let evaluations = frames.evaluations - spent;
        let frame = frames.of(cell);
        let (state, sums) = (self.state_on(frame, u, 0.0), frame.sums_at(u));
        let state = ContactState { pressure_pa, ln_pressure_pa: pressure_pa.ln(), evaluations, ..state };
        Ok(Carried { state, near: Some(Neighbour { u, sums: Some(sums) }) })
    }

    /// The pressure \[Pa\] below which every pressure is carried at some separation: complete contact of every sinusoid, or
    /// the most that sinusoids softening with depth carry. Infinite for spheres.
    pub fn highest_pressure_pa(&self) -> f64 {
        let far = self.far_below().highest_pressure_pa();
        let highest = |frames: &mut Frames<'_>| Search { frames, pressure_pa: 0.0 }.highest_pressure_pa();
        far.unwrap_or_else(|| highest(&mut self.frames(Precision::FINEST)))
    }

    fn far_below(&self) -> FarBelow<'_> {
        FarBelow::new(&*self.asperities, self.sigma_s_m)
    }

    fn frames(&self, tolerance: f64) -> Frames<'_> {
        Frames::new(&*self.asperities, self.sigma_s_m, Precision::new(tolerance))
    }

    /// The state at the separation u + rounding in units of sigma_s, on a frame near it.
    fn state_on(&self, frame: &mut Frame, u: f64, rounding: f64) -> ContactState {
        let sums = frame.sums_at(u);
        ContactState {
            error_estimate: frame.relative_error(&sums),
            out_of_range_load_share: frame.out_of_range_load_share(&sums),
            ..self.state(&sums, u, rounding)
        }
    }

    /// The same from the integrals at u.
    fn state(&self, sums: &Sums, u: f64, rounding: f64) -> ContactState {
        let correction = sums.log_pressure_slope() * rounding;
        let log_density = log_reference_density(u) + correction;
        let scale = reference_density(u) * (1.0 + correction);
        let ln_pressure_pa = sums.pressure_pa.ln() + log_density;
        let ln_area_fraction = sums.area_fraction.ln() + log_density;
        // Where the density has left the normal doubles, its product with a large number may not have.
        let product =
            |sum: f64, logarithm: f64| if scale.is_normal() { sum * scale } else { logarithm.exp() };
        ContactState {
            separation_m: Some(u * self.sigma_s_m),
            pressure_pa: product(sums.pressure_pa, ln_pressure_pa),
            area_fraction: product(sums.area_fraction, ln_area_fraction).min(1.0),
            ln_pressure_pa,
            ln_area_fraction: ln_area_fraction.min(0.0),
            error_estimate: 0.0,
            evaluations: 0,
            out_of_range_load_share: 0.0,
            clamped: ln_area_fraction > 0.0,
        }
    }
}
