//! Presses every surface under every load.

use crate::half_space::{HalfSpaceError, PROGRESS_STEPS};
use numerics::parallel::{NestedProgress, Progress};

use crate::error::ElementsError;
use crate::field::ContactField;
use crate::mean::PressedLoad;
use crate::pressing::{ImposedLoad, Pressing};
use crate::relief::Relief;
use crate::specimen::{SpecimenCompliance, stiffness_without};
use crate::state::PressedState;
use crate::surfaces::Surfaces;

/// Number of progress steps of [`press`].
#[must_use]
pub fn progress_steps(surfaces: &Surfaces, pressing: &Pressing) -> usize {
    surfaces.count() * pressing.loads.len() * PROGRESS_STEPS
}

/// Presses every surface under every load, each pair by itself: on as many threads as there are, and with the same
/// digits on any number of them. `see` receives the pressures and gaps of each pair as it is solved, in no particular
/// order.
///
/// # Errors
/// [`ElementsError`] for invalid surfaces and loads, and if `progress` cancels; the first error of `see`.
pub fn press<E: From<ElementsError> + Send>(
    surfaces: &Surfaces,
    pressing: &Pressing,
    see: impl Fn(&ContactField<'_>) -> Result<(), E> + Sync,
    progress: &dyn Progress,
) -> Result<Vec<PressedLoad>, E> {
    let (count, loads) = (surfaces.count(), pressing.loads.len());
    if count * loads == 0 {
        return Err(ElementsError::Nothing { surfaces: count, loads }.into());
    }
    pressing.check().map_err(ElementsError::from)?;
    let compliances = compliances_m_per_pa(surfaces, pressing, progress)?;
    let states = numerics::parallel::map_indices(count * loads, |pair| {
        let (load, surface) = (pair / count, pair % count);
        let compliance_m_per_pa = compliances.get(surface).copied().unwrap_or_default();
        press_once(surfaces, surface, pressing, compliance_m_per_pa, load, &see, progress)
    });
    let mut states = states.into_iter();
    let of_load = |load: &ImposedLoad| {
        let states = states.by_ref().take(count).collect::<Result<Vec<PressedState>, E>>()?;
        let nominal_pressure_pa = match *load {
            ImposedLoad::PressurePa(pressure_pa) => pressure_pa,
            _ => states.iter().map(|state| state.numbers.nominal_pressure_pa).sum::<f64>() / count as f64,
        };
        Ok(PressedLoad { nominal_pressure_pa, states })
    };
    pressing.loads.iter().map(of_load).collect()
}

/// Compliance of each specimen as a whole \[m/Pa\]; none if nothing is taken out.
fn compliances_m_per_pa(
    surfaces: &Surfaces,
    pressing: &Pressing,
    progress: &dyn Progress,
) -> Result<Vec<f64>, ElementsError> {
    let (kind, modulus_pa) = (pressing.compliance, pressing.contact_modulus_pa);
    if kind == SpecimenCompliance::None {
        return Ok(Vec::new());
    }
    let of_surface = |surface| {
        let outline = surfaces.relief(surface)?.outline()?;
        Ok(outline.compliance_m_per_pa(kind, modulus_pa, progress)?)
    };
    numerics::parallel::map_indices(surfaces.count(), of_surface).into_iter().collect()
}

/// Presses one surface under one load, and on every second point of its grid.
fn press_once<E: From<ElementsError>>(
    surfaces: &Surfaces,
    surface: usize,
    pressing: &Pressing,
    compliance_m_per_pa: f64,
    load: usize,
    see: &impl Fn(&ContactField<'_>) -> Result<(), E>,
    progress: &dyn Progress,
) -> Result<PressedState, E> {
    // Avoids making a surface after cancellation.
    if progress.is_cancelled() {
        return Err(ElementsError::from(HalfSpaceError::Cancelled).into());
    }
    let relief = surfaces.relief(surface).map_err(ElementsError::from)?;
    let mut elements = relief.elements(pressing.layer.as_ref()).map_err(ElementsError::from)?;
    let rms_gradient = surfaces.rms_gradient(&relief);
    let contact = pressing.press(load, rms_gradient, &mut elements, progress).map_err(ElementsError::from)?;
    let stiffness_pa_per_m = if pressing.stiffness {
        let modulus_pa = pressing.contact_modulus_pa;
        let whole =
            elements.stiffness_pa_per_m(&contact, modulus_pa, progress).map_err(ElementsError::from)?;
        whole.and_then(|whole| stiffness_without(compliance_m_per_pa, whole))
    } else {
        None
    };
    drop(elements);
    // Areas are extrapolated at the same load.
    let loading = pressing.loading(contact.numbers.nominal_pressure_pa);
    let pressed =
        |relief: Relief| relief.elements(pressing.layer.as_ref())?.press(&loading, &NestedProgress(progress));
    let coarser = surfaces.coarser(&relief).map(pressed).transpose().map_err(ElementsError::from)?;
    see(&ContactField {
        load,
        surface,
        relief: &relief,
        nominal_pressure_pa: contact.numbers.nominal_pressure_pa,
        contact_modulus_pa: pressing.contact_modulus_pa,
        saturation_pa: pressing.saturation_pa,
        pressures_pa: &contact.pressures_pa,
        gaps_m: &contact.gaps_m,
    })?;
    let open = relief.open_paths(&contact).map_err(ElementsError::from)?;
    let area_fraction_coarser = coarser.map(|coarser| coarser.numbers.area_fraction_corrected);
    Ok(PressedState {
        numbers: contact.numbers,
        area_fraction_coarser,
        stiffness_pa_per_m,
        compliance_m_per_pa,
        open,
    })
}
