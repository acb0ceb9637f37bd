//! Presses every surface under all loads in turn: each load goes on from the one before.

use numerics::parallel::{NestedProgress, Progress};

use crate::error::ElementsError;
use crate::half_space::{Contact, HalfSpaceError};
use crate::mean::PressedLoad;
use crate::pressing::{ImposedLoad, Pressing};
use crate::state::PressedState;
use crate::surfaces::{RandomSurfaces, Surfaces};

/// Presses every surface under all loads, the last load first, each from the pressures of the one pressed before: for many loads by
/// rising pressure on the same surfaces. States are those of [`press`](crate::press) within the tolerance, without areas on a coarser
/// grid. Surfaces are pressed on as many threads as there are, with the same digits on any number of them; `progress` advances once
/// per surface and load.
///
/// # Errors
/// [`ElementsError`] for invalid surfaces and loads, and if `progress` cancels.
pub fn press_in_turn(
    random: &RandomSurfaces,
    pressing: &Pressing,
    progress: &dyn Progress,
) -> Result<Vec<PressedLoad>, ElementsError> {
    let (surfaces, loads) = (random.realisations, pressing.loads.len());
    if surfaces * loads == 0 {
        return Err(ElementsError::Nothing { surfaces, loads });
    }
    pressing.check()?;
    let all = Surfaces::Random(random.clone());
    let pressed =
        numerics::parallel::map_indices(surfaces, |surface| press_surface(&all, surface, pressing, progress));
    let pressed = pressed.into_iter().collect::<Result<Vec<_>, _>>()?;
    let of_load = |load: usize| {
        let states: Vec<PressedState> = pressed.iter().map(|states| states[load]).collect();
        let sum_pa: f64 = states.iter().map(|state| state.numbers.nominal_pressure_pa).sum();
        PressedLoad { nominal_pressure_pa: sum_pa / surfaces as f64, states }
    };
    Ok((0..loads).map(of_load).collect())
}

/// States of a surface, in the order of the loads.
fn press_surface(
    surfaces: &Surfaces,
    surface: usize,
    pressing: &Pressing,
    progress: &dyn Progress,
) -> Result<Vec<PressedState>, ElementsError> {
    let relief = surfaces.relief(surface)?;
    let mut elements = relief.elements(pressing.layer.as_ref())?;
    let rms_gradient = surfaces.rms_gradient(&relief);
    let mut before: Option<Contact> = None;
    let mut states = Vec::new();
    for load in (0..pressing.loads.len()).rev() {
        if progress.is_cancelled() {
            return Err(HalfSpaceError::Cancelled.into());
        }
        let nested = &NestedProgress(progress);
        let contact = match pressing.loads[load] {
            ImposedLoad::PressurePa(pressure_pa) => {
                elements.press_from(before.as_ref(), &pressing.loading(pressure_pa), nested)?
            }
            _ => pressing.press(load, rms_gradient, &mut elements, nested)?,
        };
        let modulus_pa = pressing.contact_modulus_pa;
        let stiffness = pressing.stiffness.then(|| elements.stiffness_pa_per_m(&contact, modulus_pa, nested));
        states.push(PressedState {
            numbers: contact.numbers,
            area_fraction_coarser: None,
            stiffness_pa_per_m: stiffness.transpose()?.flatten(),
            compliance_m_per_pa: 0.0,
            open: relief.open_paths(&contact)?,
        });
        before = Some(contact);
        progress.advance(1);
    }
    states.reverse();
    Ok(states)
}
