//! Linear laws of the area beside elastic models, in words.

use scene::Scene;
use stat_contact::LinearLaw;
use study::linear_laws::{linear_areas, rms_gradients};
use study::plan::{Curve, Load, Results};
use units::display::three_digits;

/// The areas of the linear laws under every load, for a curve with an elastic model; `None` if no load is light enough for
/// them.
pub(crate) fn yardsticks(scene: &Scene, results: &Results, curve: &Curve) -> Option<String> {
    let (_, gradient) = *rms_gradients(&results.psd).last()?;
    let areas = |load: &Load| {
        let [least, most] = linear_areas(&curve.model, load.nominal_pressure_pa(), gradient)?;
        Some(format!("{} to {} at {}", three_digits(least), three_digits(most), load.label))
    };
    let areas: Vec<String> = scene.needs.loads.iter().filter_map(areas).collect();
    let [least, most] = LinearLaw::ALL.map(|law| three_digits(law.kappa()));
    (!areas.is_empty()).then(|| {
        format!(
            "linear laws, {least} (Persson) to {most} (Bush, Gibson & Thomas) times p/(E* h') with the rms gradient h' = {}: {}",
            three_digits(gradient),
            areas.join(", ")
        )
    })
}
