//! The assumptions of a curve, and the scales at which they fail.

use scene::Scene;
use serde::Serialize;
use study::plan::{CurveResult, Results};

use crate::body::BodyKind;
use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};

/// The largest share of the load that may rest outside the fitted range of a law.
pub const LARGEST_SHARE_OUT_OF_RANGE: f64 = 0.05;

/// A curve of the scene under one of its loads, both by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CurveAtLoad {
    pub curve: usize,
    pub load: usize,
}

/// An assumption of a curve that does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum BrokenAssumption {
    /// The curve assumes that nothing yields, but the real pressure exceeds the hardness.
    Yields(AboveHardness),
    /// Too much of the load rests outside the fitted range of the law.
    Unfitted {
        /// The longest cutoff \[m\] at which this holds.
        wavelength_m: f64,
        /// The share of the load outside the range, at that cutoff.
        load_share: f64,
    },
}

impl BrokenAssumption {
    /// The longest wavelength \[m\] at which the assumption is broken.
    #[must_use]
    pub fn wavelength_m(self) -> f64 {
        match self {
            BrokenAssumption::Yields(above) => above.wavelength_m,
            BrokenAssumption::Unfitted { wavelength_m, .. } => wavelength_m,
        }
    }
}

/// Finds the assumption of a curve that fails at the longest wavelength. `hardness` is that of the material at each
/// scale, if it yields.
pub(crate) fn first_broken(
    scene: &Scene,
    results: &Results,
    at: CurveAtLoad,
    hardness: Option<&HardnessOfScales>,
) -> Option<BrokenAssumption> {
    let elastic = BodyKind::from_model(&scene.needs.curves[at.curve].model) == BodyKind::Elastic;
    let yields = hardness
        .filter(|_| elastic)
        .and_then(|hardness| hardness.first_above(real_pressures(scene, results, at)))
        .map(BrokenAssumption::Yields);
    let unfitted = unfitted(&results.curves[at.curve], at.load);
    match (yields, unfitted) {
        (Some(yields), Some(unfitted)) if unfitted.wavelength_m() > yields.wavelength_m() => Some(unfitted),
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

fn unfitted(result: &CurveResult, load: usize) -> Option<BrokenAssumption> {
    result.statistical()?[load].iter().find_map(|row| {
        let load_share = row.contact?.1.out_of_range_load_share;
        (load_share > LARGEST_SHARE_OUT_OF_RANGE)
            .then_some(BrokenAssumption::Unfitted { wavelength_m: row.wavelength_m, load_share })
    })
}
