//! The models of a scene on a window of its spectrum.

use scene::Scene;
use spectrum::ProfilePsd;
use study::plan::{Curve, Cutoffs, Load, Needs, NominalPressure, Plan, Sampling, scales_per_decade};

use crate::JudgeError;
use crate::window::Window;

/// Scales per decade of stacks on a spectrum with too few samples to set them.
const SCALES_PER_DECADE: f64 = 10.0;

/// The area fractions of the `wanted` curves of a scene on a window, curve by curve and pressure \[Pa\] by pressure; `None`
/// for a curve without an area there. Choices and tolerances are the scene's; `psd` is its spectrum as sampled.
pub(crate) fn area_fractions(
    scene: &Scene,
    psd: &ProfilePsd,
    window: &Window,
    wanted: &[usize],
    pressures_pa: &[f64],
) -> Result<Vec<Vec<Option<f64>>>, JudgeError> {
    let curves = &scene.needs.curves;
    let stacked = |curve: &Curve| curve.model.stacked().is_some();
    let per_decade = scales_per_decade(psd).unwrap_or(SCALES_PER_DECADE);
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
        let profile = if stacks { window.stacked_profile(per_decade)? } else { window.fine_profile()? };
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
            ..Needs::default()
        };
        let results = Plan { psd: &profile, sampling: Sampling::default(), needs }.compute()?;
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
