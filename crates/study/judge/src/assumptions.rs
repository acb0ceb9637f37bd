//! A curve against its own assumptions, before anything else is held against it.

use scene::Scene;
use serde::Serialize;
use study::plan::{CurveResult, Results};

use crate::body::Body;
use crate::hardness_of_scales::{AboveHardness, HardnessOfScales};

/// The share of the load outside the range of a fitted law from which on the law does not speak for the area.
pub const LARGEST_SHARE_OUT_OF_RANGE: f64 = 0.05;

/// An assumption of a curve that does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Broken {
    /// Nothing is to yield, and the real pressure is above the hardness.
    Yields(AboveHardness),
    /// The law was fitted in a range that too much of the load is outside of.
    Unfitted {
        /// The cutoff \[m\] at which that begins.
        wavelength_m: f64,
        /// Share of the load there.
        load_share: f64,
    },
}

impl Broken {
    /// The wavelength \[m\] at which it begins.
    #[must_use]
    pub fn wavelength_m(self) -> f64 {
        match self {
            Broken::Yields(above) => above.wavelength_m,
            Broken::Unfitted { wavelength_m, .. } => wavelength_m,
        }
    }
}

/// The assumption of a curve that breaks first under a load, from long wavelengths on. `hardness` is that which the
/// material has at each scale, where it has one.
pub(crate) fn first_broken(
    scene: &Scene,
    results: &Results,
    curve: usize,
    load: usize,
    hardness: Option<&HardnessOfScales>,
) -> Option<Broken> {
    let elastic = Body::of(&scene.needs.curves[curve].model) == Body::Elastic;
    let yields = hardness
        .filter(|_| elastic)
        .and_then(|hardness| hardness.first_above(real_pressures(scene, results, curve, load)))
        .map(Broken::Yields);
    let unfitted = unfitted(&results.curves[curve], load);
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
    curve: usize,
    load: usize,
) -> impl Iterator<Item = (f64, f64)> + use<> {
    let nominal_pa = scene.needs.loads[load].nominal_pressure_pa();
    let points = results.curves[curve].area_fractions(load);
    points.into_iter().map(move |(wavelength_m, area)| (wavelength_m, nominal_pa / area))
}

fn unfitted(result: &CurveResult, load: usize) -> Option<Broken> {
    result.statistical()?[load].iter().find_map(|row| {
        let load_share = row.contact?.1.out_of_range_load_share;
        (load_share > LARGEST_SHARE_OUT_OF_RANGE)
            .then_some(Broken::Unfitted { wavelength_m: row.wavelength_m, load_share })
    })
}
