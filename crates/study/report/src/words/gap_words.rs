//! The limits of mean gaps in words.

use persson::variance::Band;
use rough_bem::PressedLoad;
use study::gap_law::{GapLaw, GapState};
use units::display::{pressure, three_digits};

use crate::persson_words;
use questions::FEW_TOUCH;

/// The relative error of the pressure within which the law of light loads holds.
pub const LIGHT_LOADS_SHARE: f64 = 0.01;

/// The results of boundary elements in the form of a model: the mean of all surfaces under each load.
#[must_use]
pub fn states_of_elements(loads: &[PressedLoad]) -> Vec<GapState> {
    let state = |load: &PressedLoad| {
        let mean = load.mean();
        GapState {
            nominal_pressure_pa: load.nominal_pressure_pa,
            area_fraction: mean.best_area_fraction(),
            mean_gap_m: Some(mean.mean_gap_m),
            stiffness_pa_per_m: mean.stiffness_pa_per_m,
        }
    };
    loads.iter().map(state).collect()
}

/// The notes on a law: where its gap and stiffness mean little, and where the law of light loads holds. `least_pa` is the least
/// load, and `by_surface` the option for the waves of the surface.
#[must_use]
pub fn of_law(law: &GapLaw, least_pa: f64, by_surface: &str) -> Vec<String> {
    let (Some(light), Some(roughness)) = (law.light_loads(), law.roughness()) else { return Vec::new() };
    let mut notes = persson_words::separation(&light, roughness, law.rms_height_m(), least_pa);
    if law.band() == Some(Band::Profile) {
        notes.push(persson_words::by_profiles(by_surface));
    }
    notes.extend(law.light_load_limit_pa(LIGHT_LOADS_SHARE).map(|most_pa| {
        format!(
            "below {} the logarithmic law u = u0 ln(p00/p), K = p/u0 is within {} % of the pressure",
            pressure(most_pa),
            three_digits(100.0 * LIGHT_LOADS_SHARE)
        )
    }));
    notes
}

/// The notes on single states. `rms_height_m`, if given, adds the note on few asperities, which [`of_law`] has as well.
#[must_use]
pub fn of_states(states: &[GapState], rms_height_m: Option<f64>) -> Vec<String> {
    let counted = |which: &dyn Fn(&GapState) -> bool| states.iter().filter(|state| which(state)).count();
    let of_all = |count: usize| format!("at {count} of {} loads", states.len());
    let gap_m = |state: &GapState| state.mean_gap_m;
    let mut notes = Vec::new();
    let few = rms_height_m.map_or(0, |rms_height_m| {
        counted(&|state| gap_m(state).is_some_and(|gap_m| gap_m > FEW_TOUCH * rms_height_m))
    });
    if few > 0 {
        notes.push(format!(
            "{} the mean gap exceeds {FEW_TOUCH} rms heights: only a few asperities of a finite sample touch",
            of_all(few)
        ));
    }
    let below = counted(&|state| gap_m(state).is_some_and(|gap_m| gap_m < 0.0));
    if below > 0 {
        notes.push(format!(
            "{} the mean gap is negative: the model ignores that asperities push their neighbours down",
            of_all(below)
        ));
    }
    let none = counted(&|state| gap_m(state).is_none());
    if none > 0 {
        notes.push(format!(
            "{} there is no mean gap: more than 3 % of the contact is plastic, or it is complete",
            of_all(none)
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_counted_by_what_they_leave_open() {
        let state = |mean_gap_m| GapState {
            nominal_pressure_pa: 1e6,
            area_fraction: 0.1,
            mean_gap_m,
            stiffness_pa_per_m: None,
        };
        let states = [state(Some(4e-8)), state(Some(1e-8)), state(Some(-1e-9)), state(None)];
        let notes = of_states(&states, Some(1e-8));
        assert_eq!(notes.len(), 3);
        assert!(notes.iter().all(|note| note.starts_with("at 1 of 4 loads")), "{notes:?}");
        assert_eq!(of_states(&states, None).len(), 2);
        assert!(of_states(&states[1..2], Some(1e-8)).is_empty());
    }
}
