//! Many states of one population.

use asperity::AsperityError;

use crate::contact::Carried;
use crate::frames::Frames;
use crate::search::Neighbour;
use crate::{ContactState, StatisticalContact};

/// States of one population under one law, one after the other: what has been evaluated for one serves those after it.
///
/// Each has the digits that [`StatisticalContact::at_separation`] or [`StatisticalContact::at_pressure`] gives it, in
/// whatever order they are asked for; its `evaluations` are those that it has added, and do depend on the order. States
/// in the order of their separations or pressures cost least.
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
pub struct Sweep<'a> {
    contact: &'a StatisticalContact,
    frames: Frames<'a>,
    /// The last state that a search can start from.
    near: Option<Neighbour>,
}

impl<'a> Sweep<'a> {
    pub(crate) fn new(contact: &'a StatisticalContact, frames: Frames<'a>) -> Self {
        Sweep { contact, frames, near: None }
    }

    /// The state at a separation d \[m\] from the mean of the asperity heights, of either sign.
    ///
    /// # Errors
    /// Those of [`StatisticalContact::at_separation`].
    pub fn at_separation(&mut self, separation_m: f64) -> Result<ContactState, AsperityError> {
        let carried = self.contact.carried_at(separation_m, &mut self.frames)?;
        Ok(self.keep(carried))
    }

    /// The state that carries a pressure \[Pa\] over the nominal area.
    ///
    /// # Errors
    /// Those of [`StatisticalContact::at_pressure`].
    pub fn at_pressure(&mut self, pressure_pa: f64) -> Result<ContactState, AsperityError> {
        let carried = self.contact.carrying(pressure_pa, self.near, &mut self.frames)?;
        Ok(self.keep(carried))
    }

    fn keep(&mut self, Carried { state, near }: Carried) -> ContactState {
        self.near = near.or(self.near);
        state
    }
}
