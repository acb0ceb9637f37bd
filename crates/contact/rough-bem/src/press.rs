//! Presses every surface under every load.

use half_space::{HalfSpaceError, PROGRESS_STEPS};
use parallel::Progress;

use crate::error::ElementsError;
use crate::field::Field;
use crate::mean::PressedLoad;
use crate::pressing::Pressing;
use crate::relief::Relief;
use crate::state::PressedState;
use crate::surfaces::Surfaces;

/// Number of progress steps of [`press`].
#[must_use]
pub fn progress_steps(surfaces: &Surfaces, pressing: &Pressing) -> usize {
    surfaces.count() * pressing.pressures_pa.len() * PROGRESS_STEPS
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
    see: impl Fn(&Field<'_>) -> Result<(), E> + Sync,
    progress: &dyn Progress,
) -> Result<Vec<PressedLoad>, E> {
    let (count, loads) = (surfaces.count(), pressing.pressures_pa.len());
    if count * loads == 0 {
        return Err(ElementsError::Nothing { surfaces: count, loads }.into());
    }
    pressing.check().map_err(ElementsError::from)?;
    let states = parallel::map_indices(count * loads, |pair| {
        let (load, surface) = (pair / count, pair % count);
        press_once(surfaces, surface, pressing, load, &see, progress)
    });
    let mut states = states.into_iter();
    let of_load = |nominal_pressure_pa: &f64| {
        let states = states.by_ref().take(count).collect::<Result<_, E>>()?;
        Ok(PressedLoad { nominal_pressure_pa: *nominal_pressure_pa, states })
    };
    pressing.pressures_pa.iter().map(of_load).collect()
}

/// Presses one surface under one load, and on every second point of its grid.
fn press_once<E: From<ElementsError>>(
    surfaces: &Surfaces,
    surface: usize,
    pressing: &Pressing,
    load: usize,
    see: &impl Fn(&Field<'_>) -> Result<(), E>,
    progress: &dyn Progress,
) -> Result<PressedState, E> {
    // Avoids making a surface after cancellation.
    if progress.is_cancelled() {
        return Err(ElementsError::from(HalfSpaceError::Cancelled).into());
    }
    let loading = pressing.loading(load);
    let relief = surfaces.relief(surface).map_err(ElementsError::from)?;
    let coarser = surfaces.coarser(&relief);
    let pressed = |relief: Relief| relief.press(&loading, &SilentProgress(progress));
    let coarser = coarser.map(pressed).transpose().map_err(ElementsError::from)?;
    let (contact, stiffness_pa_per_m) = if pressing.stiffness {
        relief.press_with_stiffness(&loading, progress).map_err(ElementsError::from)?
    } else {
        (relief.press(&loading, progress).map_err(ElementsError::from)?, None)
    };
    see(&Field {
        load,
        surface,
        relief: &relief,
        nominal_pressure_pa: loading.nominal_pressure_pa,
        contact_modulus_pa: loading.contact_modulus_pa,
        saturation_pa: loading.saturation_pa,
        pressures_pa: &contact.pressures_pa,
        gaps_m: &contact.gaps_m,
    })?;
    let open = relief.open_paths(&contact).map_err(ElementsError::from)?;
    Ok(PressedState::new(&contact, stiffness_pa_per_m, open, coarser.as_ref()))
}

/// Progress that can cancel the work but reports no steps, because there are few of them.
struct SilentProgress<'p>(&'p dyn Progress);

impl Progress for SilentProgress<'_> {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}
