//! The models of a scene on a window of its spectrum.

use std::cell::OnceCell;

use scene::Scene;
use spectrum::ProfilePsd;
use study::plan::{Curve, Cutoffs, Load, Needs, NominalPressure, Plan, Sampling, scales_per_decade};

use crate::JudgeError;
use crate::window::Window;

/// Scales per decade of stacks on a spectrum with too few samples to set them.
const SCALES_PER_DECADE: f64 = 10.0;

/// The spectra of a window's profiles that models take, each made when a model first needs it.
pub(crate) struct WindowProfiles<'w> {
    window: &'w Window,
    scales_per_decade: f64,
    stacked: OnceCell<ProfilePsd>,
    fine: OnceCell<ProfilePsd>,
}

impl<'w> WindowProfiles<'w> {
    /// Profiles of a window; stacks take as many scales per decade as `psd`, the spectrum of the scene as sampled.
    pub fn new(window: &'w Window, psd: &ProfilePsd) -> Self {
        WindowProfiles {
            window,
            scales_per_decade: scales_per_decade(psd).unwrap_or(SCALES_PER_DECADE),
            stacked: OnceCell::new(),
            fine: OnceCell::new(),
        }
    }

    fn of(&self, stacks: bool) -> Result<&ProfilePsd, JudgeError> {
        let profile = if stacks { &self.stacked } else { &self.fine };
        if let Some(known) = profile.get() {
            return Ok(known);
        }
        let made = match stacks {
            true => self.window.stacked_profile(self.scales_per_decade)?,
            false => self.window.fine_profile()?,
        };
        Ok(profile.get_or_init(|| made))
    }
}

/// The area fractions of the `wanted` curves of a scene on a window, curve by curve and pressure \[Pa\] by pressure; `None`
/// for a curve without an area there. Choices and tolerances are the scene's.
pub(crate) fn area_fractions(
    scene: &Scene,
    profiles: &WindowProfiles<'_>,
    wanted: &[usize],
    pressures_pa: &[f64],
) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
    let curves = &scene.needs.curves;
    let stacked = |curve: &Curve| curve.model.stacked().is_some();
    let mut areas = vec![Vec::new(); wanted.len()];
    if pressures_pa.is_empty() {
        return Ok(areas);
    }
    for stacks in [true, false] {
        let places: Vec<usize> =
            (0..wanted.len()).filter(|at| stacked(&curves[wanted[*at]]) == stacks).collect();
        if places.is_empty() {
            continue;
        }
        let profile = profiles.of(stacks)?;
        let chosen: Vec<Curve> = places
            .iter()
            .map(|&at| Curve { cutoffs: Cutoffs::Shortest, ..curves[wanted[at]].clone() })
            .collect();
        let needs = Needs {
            moments: (!stacks).then(|| scene.needs.moments.unwrap_or_default()),
            amplitudes: Some(scene.needs.amplitudes.unwrap_or_default()),
            curves: chosen,
            loads: loads(pressures_pa)?,
            tolerance: scene.needs.tolerance,
            areas_alone: true,
            ..Needs::default()
        };
        let results = Plan { psd: profile, sampling: Sampling::default(), needs }.compute()?;
        for (&at, result) in places.iter().zip(&results.curves) {
            let final_area = |load| result.area_fractions(load).last().map(|(_, area)| *area);
            areas[at] = (0..pressures_pa.len()).map(final_area).collect();
        }
    }
    Ok(areas)
}

fn loads(pressures_pa: &[f64]) -> Result<Vec<Load>, JudgeError> {
    let load = |pressure_pa: &f64| {
        Ok(Load { nominal_pressure: NominalPressure::new(*pressure_pa)?, label: String::new() })
    };
    pressures_pa.iter().map(load).collect()
}
