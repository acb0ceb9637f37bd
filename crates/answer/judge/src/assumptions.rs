//! The assumptions of a curve, and the scales at which they fail.

use scene::Scene;
use study::plan::{CurveResult, Results};
use units::{Remark, RemarkCode};

use crate::body::BodyKind;
use crate::hardness_of_scales::HardnessOfScales;

/// The largest share of the load that may rest outside the fitted range of a law.
pub const LARGEST_SHARE_OUT_OF_RANGE: f64 = 0.05;

/// A curve of the scene under one of its loads, both by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CurveAtLoad {
    pub curve: usize,
    pub load: usize,
}

/// Finds the assumption of a curve that fails at the longest wavelength, and that wavelength \[m\]. `hardness` is that of the
/// material at each scale, if it yields.
pub(crate) fn first_broken(
    scene: &Scene,
    results: &Results,
    at: CurveAtLoad,
    hardness: Option<&HardnessOfScales>,
) -> Option<(f64, Remark)> {
    let elastic = BodyKind::from_model(&scene.needs.curves[at.curve].model) == BodyKind::Elastic;
    let yields = hardness
        .filter(|_| elastic)
        .and_then(|hardness| hardness.first_above(real_pressures(scene, results, at)))
        .map(|above| {
            let remark = Remark::new(RemarkCode::AssumesNoYielding)
                .with("wavelength_m", above.wavelength_m)
                .with("pressure_pa", above.pressure_pa)
                .with("hardness_pa", above.hardness_pa);
            (above.wavelength_m, remark)
        });
    let unfitted = unfitted(&results.curves[at.curve], at.load);
    match (yields, unfitted) {
        (Some(yields), Some(unfitted)) if unfitted.0 > yields.0 => Some(unfitted),
        (Some(yields), _) => Some(yields),
        (None, unfitted) => unfitted,
    }
}

/// The real pressures \[Pa\] of a curve against its cutoffs \[m\].
pub(crate) fn real_pressures(
    scene: &Scene,
    results: &Results,
    at: CurveAtLoad,
) -> impl Iterator<Item = (f64, f64)> + use<> {
    let nominal_pa = scene.needs.loads[at.load].nominal_pressure_pa();
    let points = results.curves[at.curve].area_fractions(at.load);
    points.into_iter().map(move |(wavelength_m, area)| (wavelength_m, nominal_pa / area))
}

fn unfitted(result: &CurveResult, load: usize) -> Option<(f64, Remark)> {
    result.statistical()?[load].iter().find_map(|row| {
        let load_share = row.contact?.1.out_of_range_load_share;
        let remark = Remark::new(RemarkCode::UnfittedLaw).with("wavelength_m", row.wavelength_m);
        (load_share > LARGEST_SHARE_OUT_OF_RANGE)
            .then(|| (row.wavelength_m, remark.with("load_share", load_share)))
    })
}
