//! Promises of every state of the statistical model.

use std::fmt::Debug;

use asperity::Bound;
use stat_contact::{ContactState, StatisticalContact};

use crate::Reach;
use crate::reference_quadrature::integrals;
use crate::statistical::{Question, StatisticalCase};
use crate::tally::{Refused, Trial};

/// Limit of the law evaluations of a state at a separation, and of one at a pressure.
const MOST_EVALUATIONS: [f64; 2] = [5_000.0, 50_000.0];
/// Error of a round trip that is promised: in sigma_s times the condition number of the inverse, and relative in
/// pressure.
const ROUND_TRIP: f64 = 1e-10;
/// Relative rounding of the sums of a few hundred positive terms, with the law's own rounding in each.
const ROUNDING: f64 = 1e-13;

/// Selection of the costly checks for a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sample {
    /// Check against an independent quadrature.
    pub quadrature: bool,
    /// Check against the finest tolerance.
    pub finest: bool,
    /// Check of a table of states.
    pub table: bool,
}

impl Sample {
    /// Intervals of the checks, in states.
    const EVERY: [u64; 3] = [2000, 20, 100];

    /// Selects the checks of the state `index`.
    pub fn for_state(index: u64) -> Self {
        let [quadrature, finest, table] = Self::EVERY.map(|every| index.is_multiple_of(every));
        Sample { quadrature, finest, table }
    }
}

/// Contact, and what is asked of it.
pub(crate) struct Search<'a> {
    pub(crate) contact: &'a StatisticalContact,
    pub(crate) question: Question,
    pub(crate) tolerance: f64,
    /// Standard deviation of the heights \[m\].
    pub(crate) height_m: f64,
    /// True if the force of an asperity never falls with its interference.
    pub(crate) force_rises: bool,
    /// True if its area never falls either.
    pub(crate) area_rises: bool,
}

/// Tests one state.
///
/// # Errors
/// [`Refused`] if a constructor refuses its numbers.
pub fn try_state(sample: Sample, trial: &mut Trial<StatisticalCase>) -> Result<(), Refused> {
    let case = trial.case;
    let contact = &case.contact()?;
    let (force_rises, area_rises) = (case.kind.force_rises(), case.kind.area_rises());
    let StatisticalCase { question, tolerance, sigma_s_m: height_m, .. } = *case;
    let search = Search { contact, question, tolerance, height_m, force_rises, area_rises };
    let Some((_, separation_m)) = search.test(trial)? else { return Ok(()) };
    if sample.finest {
        error_bar(contact, separation_m, trial);
    }
    if sample.quadrature {
        other_quadrature(separation_m, trial);
    }
    if sample.table {
        tabulated(contact, separation_m, trial);
    }
    Ok(())
}

impl Search<'_> {
    /// Tests what holds whatever the asperities; returns the state and its separation \[m\] if more can be
    /// tested there.
    ///
    /// # Errors
    /// [`Refused`] if the question is out of bounds.
    pub(crate) fn test<C: Debug>(
        &self,
        trial: &mut Trial<C>,
    ) -> Result<Option<(ContactState, f64)>, Refused> {
        let state = self.contact.at(self.question, self.tolerance, None)?;
        sound(self.question, &state, trial);
        if trial.reach == Reach::Edge {
            self.edge(&state, trial);
            return Ok(None);
        }
        let Some(separation_m) = state.separation_m else {
            let highest_pa = self.contact.highest_pressure_pa();
            trial.bound(
                "a pressure without separation is beyond the highest",
                highest_pa,
                state.pressure_pa * (1.0 + 1e-9),
            );
            return Ok(None);
        };
        if !Bound::Signed.admits(separation_m) {
            // A soft sphere under a huge pressure sinks below the range of separations.
            return Ok(None);
        }
        match self.question {
            Question::Separation(_) => self.there_and_back(&state, separation_m, trial),
            Question::Pressure(pressure_pa) => {
                self.carries(separation_m, pressure_pa, &state, trial);
                self.any_start(separation_m, pressure_pa, trial);
            }
        }
        self.falls(separation_m, trial);
        Ok(Some((state, separation_m)))
    }

    /// At the edge of the doubles the other queries must give sound answers too.
    fn edge<C: Debug>(&self, state: &ContactState, trial: &mut Trial<C>) {
        trial.hold("highest pressure is no NaN", !self.contact.highest_pressure_pa().is_nan());
        if let (Question::Separation(_), true) =
            (self.question, state.pressure_pa.is_finite() && state.pressure_pa > 0.0)
        {
            let question = Question::Pressure(state.pressure_pa);
            if let Ok(back) = self.contact.at(question, self.tolerance, None) {
                sound(question, &back, trial);
            }
        }
    }

    /// Checks the way from a separation to its pressure and back.
    fn there_and_back<C: Debug>(&self, state: &ContactState, separation_m: f64, trial: &mut Trial<C>) {
        if !state.pressure_pa.is_normal() {
            return;
        }
        // A state may have a pressure that is too large to be given.
        let Ok(back) = self.contact.at_pressure(state.pressure_pa, self.tolerance, None) else { return };
        sound(Question::Pressure(state.pressure_pa), &back, trial);
        let estimates = state.error_estimate + back.error_estimate;
        let Some(found_m) = back.separation_m else {
            let highest_pa = self.contact.highest_pressure_pa();
            let allowed = state.pressure_pa * (1.0 + estimates + self.tolerance.min(1e-2) + 1e-12);
            trial.bound("a pressure that was carried has a separation", highest_pa, allowed);
            return;
        };
        let u = separation_m / self.height_m;
        let off = (found_m - separation_m) / self.height_m;
        let representable = f64::EPSILON * u.abs() * (8.0 + 4.0 * separation_m.abs().max(1e-300).ln().abs());
        // If several separations carry a pressure, the largest is the answer: then it need only carry it. At a maximum of
        // the pressure it may round beyond reach.
        let next_lower_pa = state.pressure_pa * (1.0 - 1e-9);
        let at_a_maximum = || {
            let lower =
                self.contact.at_pressure(next_lower_pa, self.tolerance, None).expect("a positive pressure");
            lower.separation_m.is_some_and(|lower_m| lower_m >= separation_m)
        };
        let another = !self.force_rises && (off > ROUND_TRIP || (off < -ROUND_TRIP && at_a_maximum()));
        if !another {
            // Condition number of the inverse, over the stretch between the two separations, where it is needed.
            let slope = || {
                let at_found =
                    self.contact.at_separation(found_m, self.tolerance).expect("a finite separation");
                (at_found.ln_pressure_pa - state.ln_pressure_pa).abs() / off.abs()
            };
            let well_conditioned = ROUND_TRIP + representable;
            let allowed = if off.abs() <= well_conditioned {
                well_conditioned
            } else {
                let inverse = 1.0 / slope();
                ROUND_TRIP * inverse.max(1.0) + (estimates + ROUNDING) * inverse + representable
            };
            trial.bound("d -> p -> d in units of its condition", off.abs(), allowed);
        }
        self.carries(found_m, state.pressure_pa, &back, trial);
    }

    /// Checks that the separation carries the pressure.
    fn carries<C: Debug>(
        &self,
        separation_m: f64,
        pressure_pa: f64,
        found: &ContactState,
        trial: &mut Trial<C>,
    ) {
        let Ok(again) = self.contact.at_separation(separation_m, self.tolerance) else { return };
        let off = (again.ln_pressure_pa - pressure_pa.ln()).abs();
        let mut allowed = ROUND_TRIP + found.error_estimate + again.error_estimate;
        allowed += 4.0 * f64::EPSILON * pressure_pa.ln().abs();
        let area_off = (again.ln_area_fraction - found.ln_area_fraction).abs();
        if off.max(area_off) > allowed {
            // Effect of the last places of d: up to u^2 above the mean plane, and far more just before complete self.contact.
            let places = (8.0 + 4.0 * separation_m.abs().max(1e-300).ln().abs()) * f64::EPSILON;
            let [nearer, farther] = [1.0 - places, 1.0 + places].map(|factor| {
                self.contact
                    .at_separation(factor * separation_m, self.tolerance)
                    .expect("a finite separation")
            });
            allowed += (nearer.ln_pressure_pa - farther.ln_pressure_pa).abs();
            allowed += (nearer.ln_area_fraction - farther.ln_area_fraction).abs();
        }
        trial.bound("p -> d -> p", off, allowed);
        trial.bound("area at p and at d", area_off, allowed);
    }

    /// Checks that the answer does not depend on the start of the search.
    fn any_start<C: Debug>(&self, separation_m: f64, pressure_pa: f64, trial: &mut Trial<C>) {
        let from = trial.draw.between(-40.0, 40.0);
        let start = self.contact.at_separation(from * self.height_m, 1e-3).expect("a finite separation");
        let led =
            self.contact.at_pressure(pressure_pa, self.tolerance, Some(&start)).expect("a positive pressure");
        let off =
            led.separation_m.map_or(f64::INFINITY, |led_m| (led_m - separation_m).abs() / self.height_m);
        let u = (separation_m / self.height_m).abs();
        let mut allowed = 1e-12 * (1.0 + u);
        if off > allowed {
            let slope = self.slope_of_ln_pressure(separation_m).map_or(0.0, f64::abs);
            allowed += 4.0 * f64::EPSILON / slope;
        }
        trial.bound("the start changes nothing", off, allowed);
    }

    /// Slope of ln p by d/sigma_s at the separation d \[m\], by a central difference; `None` if numbers are refused.
    fn slope_of_ln_pressure(&self, separation_m: f64) -> Option<f64> {
        const TOLERANCE: f64 = 1e-13;
        let u = separation_m / self.height_m;
        // ln p bends on the scale of 1 near the mean plane, and of |u| away from it, and u has to move.
        let step = 1e-3 / (1.0 + u.max(0.0)) + 1e-9 * u.abs();
        let at = |u: f64| self.contact.at_separation(u * self.height_m, TOLERANCE).ok();
        let [low, high] = [at(u - step)?, at(u + step)?];
        let width = (high.separation_m? - low.separation_m?) / self.height_m;
        Some((high.ln_pressure_pa - low.ln_pressure_pa) / width)
    }

    /// Checks that a slightly larger separation carries no more: anywhere if the force rises, above the mean plane in any
    /// case.
    fn falls<C: Debug>(&self, separation_m: f64, trial: &mut Trial<C>) {
        if !self.force_rises && separation_m <= 0.0 {
            return;
        }
        let larger_m = if trial.draw.chance(0.3) {
            separation_m.next_up()
        } else {
            separation_m + self.height_m * trial.draw.decades(-14.0, 0.5)
        };
        let [here, beyond] = [separation_m, larger_m]
            .map(|d_m| self.contact.at_separation(d_m, self.tolerance).expect("finite"));
        let rounding = ROUNDING + 4.0 * f64::EPSILON * here.ln_pressure_pa.abs();
        let allowed = here.error_estimate + beyond.error_estimate + rounding;
        trial.bound("p falls with d", (beyond.ln_pressure_pa - here.ln_pressure_pa).max(0.0), allowed);
        if !self.area_rises {
            return;
        }
        let area_rise = beyond.ln_area_fraction - here.ln_area_fraction;
        trial.bound(
            "area falls with d",
            area_rise.max(0.0),
            allowed + ROUNDING * here.ln_area_fraction.abs(),
        );
    }
}

/// Checks that hold for every state, however extreme its inputs.
fn sound<C: Debug>(question: Question, state: &ContactState, trial: &mut Trial<C>) {
    let logarithms = [state.ln_pressure_pa, state.ln_area_fraction];
    let numbers =
        [state.pressure_pa, state.area_fraction, state.error_estimate, state.out_of_range_load_share];
    trial.hold("no NaN", !numbers.iter().chain(&logarithms).any(|number| number.is_nan()));
    trial.hold("pressure at least 0", state.pressure_pa >= 0.0);
    trial.hold("area fraction in [0, 1]", (0.0..=1.0).contains(&state.area_fraction));
    trial.hold("ln area fraction at most 0", state.ln_area_fraction <= 0.0);
    trial.hold("error estimate at least 0", state.error_estimate >= 0.0);
    trial.hold("load out of range in [0, 1]", (0.0..=1.0).contains(&state.out_of_range_load_share));
    trial.hold("separation finite", state.separation_m.is_none_or(f64::is_finite));
    trial.hold("stiffness no NaN", !state.stiffness_pa_per_m().is_some_and(f64::is_nan));
    let [at_separation, at_pressure] = MOST_EVALUATIONS;
    let evaluations = state.evaluations as f64;
    match question {
        Question::Separation(_) => trial.bound("evaluations at a separation", evaluations, at_separation),
        Question::Pressure(_) => trial.bound("evaluations at a pressure", evaluations, at_pressure),
    }
    if trial.reach == Reach::Edge {
        return;
    }
    trial.hold("finite", logarithms.iter().chain(&numbers).all(|number| number.is_finite()));
    for (promise, number, logarithm) in [
        ("ln p is that of p", state.pressure_pa, state.ln_pressure_pa),
        ("ln area is that of the area", state.area_fraction, state.ln_area_fraction),
    ] {
        if number.is_normal() {
            trial.bound(promise, (number.ln() - logarithm).abs(), 1e-14 * (1.0 + logarithm.abs()));
        }
    }
    trial.hold("clamped means complete", !state.clamped || state.area_fraction == 1.0);
}

/// Checks the states of a table that begins at the separation.
fn tabulated(contact: &StatisticalContact, separation_m: f64, trial: &mut Trial<StatisticalCase>) {
    let case = trial.case;
    const FINEST: f64 = 1e-13;
    /// Estimates are not bounds: one state in some ten thousand errs by more.
    const CAUTION: f64 = 3.0;
    let width = trial.draw.one_of(&[-1.0, 1.0]) * trial.draw.decades(-2.0, 2.0);
    let end_m = separation_m + width * case.sigma_s_m;
    let share = trial.draw.between(0.0, 1.0);
    let within_m = (1.0 - share) * separation_m + share * end_m;
    let ends = [separation_m, end_m].map(Question::Separation);
    let table = contact.table(ends, case.tolerance).expect("finite separations");
    let [tabulated, single] = [table.at_separation(within_m), contact.at_separation(within_m, FINEST)];
    let (tabulated, single) = (tabulated.expect("finite"), single.expect("finite"));
    let off = |a: &ContactState, b: &ContactState| {
        let pressures = (a.ln_pressure_pa - b.ln_pressure_pa).abs();
        pressures.max((a.ln_area_fraction - b.ln_area_fraction).abs())
    };
    let u = within_m / case.sigma_s_m;
    let rounding = ROUNDING + 8.0 * f64::EPSILON * (single.ln_pressure_pa.abs() + u * u.max(0.0) + u.abs());
    let allowed = CAUTION * (tabulated.error_estimate + single.error_estimate) + rounding;
    trial.bound("a table's state", off(&tabulated, &single), allowed);
    if !single.pressure_pa.is_normal() {
        return;
    }
    let carried = table.at_pressure(single.pressure_pa).expect("a positive pressure");
    let Some(carried_m) = carried.separation_m else { return };
    let back = contact.at_separation(carried_m, FINEST).expect("finite");
    let missed = (back.ln_pressure_pa - single.ln_pressure_pa).abs();
    trial.bound("a table's state at a pressure", missed, allowed + CAUTION * carried.error_estimate);
}

/// Compares the error estimate with the error against the finest tolerance.
fn error_bar(contact: &StatisticalContact, separation_m: f64, trial: &mut Trial<StatisticalCase>) {
    let case = trial.case;
    const COARSEST: f64 = 1e-2;
    const FINEST: f64 = 1e-13;
    /// Tolerance against which the error of the finest is negligible.
    const COMPARABLE: f64 = 1e-11;
    if case.tolerance < COMPARABLE {
        return;
    }
    let [coarse, fine] = [case.tolerance, FINEST]
        .map(|tolerance| contact.at_separation(separation_m, tolerance).expect("finite"));
    let error = (coarse.ln_pressure_pa - fine.ln_pressure_pa)
        .abs()
        .max((coarse.ln_area_fraction - fine.ln_area_fraction).abs());
    let rounding = f64::EPSILON * (1.0 + 2.0 * fine.ln_pressure_pa.abs());
    trial.note("error over its estimate", error / (coarse.error_estimate + rounding));
    trial.bound(
        "error within a hundred tolerances",
        error,
        100.0 * case.tolerance.min(COARSEST) + 10.0 * rounding,
    );
}

/// Checks agreement with an adaptive quadrature that shares no code.
fn other_quadrature(separation_m: f64, trial: &mut Trial<StatisticalCase>) {
    let case = trial.case;
    /// Number of standard deviations below which the integral depends on the digits of u.
    const DEEPEST: f64 = -1e4;
    /// Largest error of the other quadrature for a meaningful comparison.
    const MEANINGFUL: f64 = 1e-9;
    let u = separation_m / case.sigma_s_m;
    if u < DEEPEST {
        return;
    }
    let finest = StatisticalCase { question: Question::Separation(separation_m), tolerance: 1e-12, ..*case };
    let (Ok(response), Ok(state)) = (case.response(), finest.state()) else { return };
    let Some(other) = integrals(&response, separation_m, case.sigma_s_m) else { return };
    let rounding = 1e-11 + 8.0 * f64::EPSILON * state.ln_pressure_pa.abs();
    for (promise, ours, theirs, error) in [
        ("another quadrature agrees on p", state.ln_pressure_pa, other.ln_pressure_pa, other.errors[0]),
        (
            "another quadrature agrees on A",
            state.ln_area_fraction,
            other.ln_area_fraction.min(0.0),
            other.errors[1],
        ),
    ] {
        // Otherwise the comparison means nothing.
        if error < MEANINGFUL {
            trial.bound(promise, (ours - theirs).abs(), state.error_estimate + 2.0 * error + rounding);
        }
    }
}
