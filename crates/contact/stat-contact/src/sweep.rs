//! Many states of one population.

use asperity::{AsperityError, Bound};

use crate::far::FarBelow;
use crate::quadrature::frames::Frames;
use crate::search::problem::{Answer, CellSolution, Neighbour, Search};
use crate::{Condition, ContactState};

/// States of one population under one law, computed one after the other; the evaluations for one serve those after it
/// ([`StatisticalContact::sweep`](crate::StatisticalContact::sweep)).
///
/// Each state has the digits of [`StatisticalContact::at_separation`](crate::StatisticalContact::at_separation) or
/// [`StatisticalContact::at_pressure`](crate::StatisticalContact::at_pressure), in any order. Its `evaluations` are
/// those that it has added, and depend on the order. States in the order of their separations or pressures cost
/// least.
///
/// ```
/// use asperity::{ElasticBody, MaterialPair};
/// use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};
///
/// let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2)?);
/// let law = AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson };
/// let contact = StatisticalContact::new(&pair, &Population::new(45.6e-9, 26e12, 6.66e-9)?, &law);
/// let mut sweep = contact.sweep(1e-10);
/// let light = sweep.at_pressure(50e6)?;
/// let heavy = sweep.at_pressure(51e6)?;
/// assert_eq!(heavy.separation_m, contact.at_pressure(51e6, 1e-10, None)?.separation_m);
/// assert!(heavy.evaluations < light.evaluations);
/// # Ok::<(), asperity::AsperityError>(())
/// ```
#[must_use]
pub struct Sweep<'a> {
    frames: Frames<'a>,
    /// Last state from which a search can start.
    near: Option<Neighbour>,
}

impl<'a> Sweep<'a> {
    /// Range of pressures \[Pa\].
    pub const PRESSURE_PA: Bound = Bound::LeftOpen { above: 0.0, at_most: 1e60 };

    /// Range of separations \[m\].
    pub const SEPARATION_M: Bound = Bound::Signed;

    #[inline]
    pub(crate) fn on(frames: Frames<'a>) -> Self {
        Sweep { frames, near: None }
    }

    /// Sets a state from which the next search starts, if it has a separation.
    #[inline]
    pub(crate) fn starting_at(self, state: Option<&ContactState>) -> Self {
        let near = state.and_then(|state| state.separation_m).map(|d| d / self.frames.sigma_s_m);
        Sweep { near: near.map(|u| Neighbour { u, sums: None }), ..self }
    }

    /// Returns the state at a pressure or a separation.
    ///
    /// # Errors
    /// The errors of [`at_pressure`](Self::at_pressure) and [`at_separation`](Self::at_separation).
    pub fn at(&mut self, condition: Condition) -> Result<ContactState, AsperityError> {
        match condition {
            Condition::Pressure(pressure_pa) => self.at_pressure(pressure_pa),
            Condition::Separation(separation_m) => self.at_separation(separation_m),
        }
    }

    /// Returns the state at a separation d \[m\] from the mean of the asperity heights, of either sign.
    ///
    /// # Errors
    /// The errors of [`StatisticalContact::at_separation`](crate::StatisticalContact::at_separation).
    pub fn at_separation(&mut self, separation_m: f64) -> Result<ContactState, AsperityError> {
        let separation_m = Self::SEPARATION_M.check("separation in m", separation_m)?;
        if let Some(spheres) = self.frames.asperities.exponential() {
            return Ok(ContactState::of_exponential(spheres, separation_m));
        }
        let state = self.state_at_separation(separation_m);
        Ok(state.with_flattened_share(self.frames.asperities, self.frames.sigma_s_m))
    }

    fn state_at_separation(&mut self, separation_m: f64) -> ContactState {
        if let Some(state) = self.far_below().at_separation(separation_m) {
            return state;
        }
        let sigma_s_m = self.frames.sigma_s_m;
        let u = separation_m / sigma_s_m;
        let spent = self.frames.evaluations();
        let (sums, integrals) = self.frames.at(u).integrals_at(u);
        self.near = Some(Neighbour { u, sums: Some(sums) });
        let state = ContactState::at_separation(&integrals, separation_m, sigma_s_m);
        let evaluations = self.frames.evaluations() - spent;
        ContactState { evaluations, ..state }
    }

    /// Returns the state that carries a pressure \[Pa\] over the nominal area.
    ///
    /// # Errors
    /// The errors of [`StatisticalContact::at_pressure`](crate::StatisticalContact::at_pressure).
    pub fn at_pressure(&mut self, pressure_pa: f64) -> Result<ContactState, AsperityError> {
        let pressure_pa = Bound::Positive.check("pressure in Pa", pressure_pa)?;
        let pressure_pa = Self::PRESSURE_PA.check("pressure in Pa", pressure_pa)?;
        if let Some(spheres) = self.frames.asperities.exponential() {
            let state = ContactState::of_exponential(spheres, spheres.separation_m(pressure_pa));
            return Ok(ContactState { pressure_pa, ln_pressure_pa: pressure_pa.ln(), ..state });
        }
        let state = self.state_at_pressure(pressure_pa);
        Ok(state.with_flattened_share(self.frames.asperities, self.frames.sigma_s_m))
    }

    fn state_at_pressure(&mut self, pressure_pa: f64) -> ContactState {
        let asperities = self.frames.asperities;
        let beyond = || ContactState::beyond(asperities, pressure_pa);
        let asked = |state| ContactState { pressure_pa, ln_pressure_pa: pressure_pa.ln(), ..state };
        if pressure_pa >= self.frames.asperities.highest_response_pa() {
            return beyond();
        }
        let far_below = self.far_below();
        // If the highest pressure is carried far below, no nearer separation carries more.
        if far_below.highest_pressure_pa().is_some_and(|highest_pa| pressure_pa > highest_pa) {
            return beyond();
        }
        if let Some(separation_m) = far_below.separation_m(pressure_pa.ln()) {
            return asked(far_below.state(separation_m));
        }
        let (near, spent) = (self.near, self.frames.evaluations());
        let answer = Search { frames: &mut self.frames, pressure_pa }.largest(near);
        let Some(Answer { found: CellSolution { cell, u }, missed_by }) = answer else {
            return beyond();
        };
        let evaluations = self.frames.evaluations() - spent;
        let sigma_s_m = self.frames.sigma_s_m;
        let (sums, integrals) = self.frames.frame(cell).integrals_at(u);
        self.near = Some(Neighbour { u, sums: Some(sums) });
        let state = ContactState::of(&integrals, 0.0, sigma_s_m);
        let error_estimate = state.error_estimate + missed_by;
        let separation_m = Some(u * sigma_s_m);
        asked(ContactState { separation_m, error_estimate, evaluations, ..state })
    }

    /// Pressure \[Pa\] below which every pressure is carried at some separation.
    pub(crate) fn highest_pressure_pa(&mut self) -> f64 {
        let far = self.far_below().highest_pressure_pa();
        far.unwrap_or_else(|| Search { frames: &mut self.frames, pressure_pa: 0.0 }.highest_pressure_pa())
    }

    fn far_below(&self) -> FarBelow<'a> {
        FarBelow::new(self.frames.asperities, self.frames.sigma_s_m)
    }
}
