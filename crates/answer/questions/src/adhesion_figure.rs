//! Figures of surfaces that attract each other: the pull-off curve, and the area on both branches.

use elements::{AdhesiveState, Branch};
use study::figure::{Axis, FigureData, Mark, Series, Shows};
use units::display::{length, pressure};

const GAP: Axis = Axis { column: "mean_gap_m", label: "mean gap (m)" };
const PRESSURE: Axis = Axis { column: "nominal_pressure_pa", label: "nominal pressure (Pa)" };
const MEAN_PRESSURE: &str = "mean pressure (Pa)";
const AREA: &str = "contact area / nominal area";

/// Draws the mean pressure over the mean gap, a line for each surface, with the largest pull of each marked.
pub(crate) fn pull_off_curve(states: &[AdhesiveState], strongest: &[AdhesiveState]) -> FigureData {
    let point = |state: &AdhesiveState| (state.numbers.mean_gap_m, state.numbers.nominal_pressure_pa);
    let surfaces: Vec<Vec<(f64, f64)>> = states
        .chunk_by(|one, other| one.surface == other.surface)
        .map(|of_surface| of_surface.iter().map(point).collect())
        .collect();
    let is_one = surfaces.len() == 1;
    let line = |(at, points): (usize, Vec<(f64, f64)>)| match is_one {
        true => Series::alone("nominal_pressure_pa", points),
        false => Series::under(&format!("surface {}", at + 1), at, points),
    };
    let series = surfaces.into_iter().enumerate().map(line).collect();
    let mark = |(at, state): (usize, &AdhesiveState)| {
        let (x, y) = point(state);
        let (label, condition_index) = ("pull-off".to_owned(), (!is_one).then_some(at));
        Mark { column: label.clone(), label, is_ring: true, condition_index, x, y, low: y, high: y }
    };
    let figure = FigureData::new("pull-off", Shows::Response, GAP, MEAN_PRESSURE, series).with_linear_axes();
    FigureData {
        title: pull_off_title(strongest),
        marks: strongest.iter().enumerate().map(mark).collect(),
        ..figure
    }
}

/// The largest pull and its gap, or their means over the surfaces.
fn pull_off_title(strongest: &[AdhesiveState]) -> String {
    let count = strongest.len();
    let mean = |of: fn(&AdhesiveState) -> f64| strongest.iter().map(of).sum::<f64>() / count as f64;
    let pull = pressure(-mean(|state| state.numbers.nominal_pressure_pa));
    let gap = length(mean(|state| state.numbers.mean_gap_m));
    match count {
        0 | 1 => format!("Pull-off at a pull of {pull}, mean gap {gap}"),
        _ => format!("Pull-off at a pull of {pull}, mean gap {gap} (means of {count} surfaces)"),
    }
}

/// Draws the share in contact over the nominal pressure, a line for each branch. Axes are linear if a load pulls.
pub(crate) fn area_on_branches(means: &[AdhesiveState]) -> FigureData {
    let line = |(index, branch, name): (usize, Branch, &str)| {
        let of_branch = means.iter().filter(|state| state.branch == branch);
        let mut points: Vec<(f64, f64)> =
            of_branch.map(|state| (state.numbers.nominal_pressure_pa, state.numbers.area_fraction)).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        Series::under(name, index, points)
    };
    let branches = [(0, Branch::Apart, "from first touch"), (1, Branch::Contact, "from full contact")];
    let lines = branches.map(line).into_iter().filter(|line| !line.points.is_empty()).collect();
    let figure = FigureData::new("area-with-adhesion", Shows::AreaAgainstLoad, PRESSURE, AREA, lines);
    let figure = FigureData { title: "Contact area with adhesion".to_owned(), ..figure };
    let pulls = means.iter().any(|state| state.numbers.nominal_pressure_pa <= 0.0);
    if pulls { figure.with_linear_axes() } else { figure }
}
