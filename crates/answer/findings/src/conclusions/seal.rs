//! The seal: the pressure that closes it, and whether it is closed under each load.

use scene::Scene;
use serde::Serialize;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};

/// The conclusion on a seal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SealConclusion {
    /// The nominal pressure that closes the last channel, and the mechanism; `None` if no pressure of the theory does.
    pub closes: Option<SealClosing>,
    /// The loads, by index, under which the seal is closed.
    pub closed_under: Vec<usize>,
    /// The loads, by index, under which it leaks.
    pub open_under: Vec<usize>,
}

/// The pressure that closes a seal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SealClosing {
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// True if the contact flows before it would close elastically.
    pub by_yielding: bool,
}

impl SealConclusion {
    /// Draws the conclusion; `None` if the scene has no seal.
    pub(crate) fn new(scene: &Scene, states: &InterfaceStates<'_>) -> Option<Self> {
        states.request().seal?;
        let tight = Slot { quantity: Quantity::TightPressure, load: None, curve: None };
        let elastic_pa = states.value(tight).ok().flatten();
        let flowing_pa = states.closed_by_yielding_from_pa();
        let closes = match (elastic_pa, flowing_pa) {
            (Some(elastic_pa), Some(flowing_pa)) if flowing_pa < elastic_pa => {
                Some(SealClosing { nominal_pressure_pa: flowing_pa, by_yielding: true })
            }
            (Some(elastic_pa), _) => {
                Some(SealClosing { nominal_pressure_pa: elastic_pa, by_yielding: false })
            }
            (None, Some(flowing_pa)) => {
                Some(SealClosing { nominal_pressure_pa: flowing_pa, by_yielding: true })
            }
            (None, None) => None,
        };
        let is_closed = |load: &usize| {
            let pressure_pa = scene.needs.loads[*load].nominal_pressure_pa();
            closes.is_some_and(|closing| pressure_pa >= closing.nominal_pressure_pa)
        };
        let (closed_under, open_under) = (0..scene.needs.loads.len()).partition(is_closed);
        Some(SealConclusion { closes, closed_under, open_under })
    }
}
