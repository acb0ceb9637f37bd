//! Boundary elements under small maps: their numbers, and the promises of every result.

use std::f64::consts::{PI, TAU};

use elements::half_space::{Approach, Closing, Contact, Elements, Ending, HalfSpaceError, Loading};
use numerics::parallel::Unobserved;

use crate::drawn_map::SmallMap;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Rms height \[m\] below which a map is flat.
const FLAT_M: f64 = 1e-30;

/// Map, body, load and tolerance; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementsCase {
    /// The map.
    pub map: SmallMap,
    /// True if it repeats itself.
    pub periodic: bool,
    /// Ratio of displacements and length \[m\] of a body that is softer or stiffer under long waves, if it is not a half-space.
    pub layer: Option<(f64, f64)>,
    /// Contact modulus \[Pa\].
    pub contact_modulus_pa: f64,
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Largest pressure of a point \[Pa\].
    pub saturation_pa: Option<f64>,
    /// Tolerance of the solve.
    pub tolerance: f64,
}

impl ElementsCase {
    fn elements(&self) -> Result<Elements, HalfSpaceError> {
        let (grid, heights_m) = (self.map.grid()?, &self.map.heights_m);
        match (self.periodic, self.layer) {
            (true, None) => Elements::periodic(grid, heights_m),
            (true, Some(layer)) => Elements::periodic_on(grid, heights_m, relative_displacement(layer)),
            (false, _) => Elements::free(grid, heights_m),
        }
    }

    fn loading(&self) -> Loading {
        Loading {
            contact_modulus_pa: self.contact_modulus_pa,
            nominal_pressure_pa: self.pressure_pa,
            saturation_pa: self.saturation_pa,
            tolerance: self.tolerance,
        }
    }

    fn press(&self) -> Result<Contact, HalfSpaceError> {
        self.elements()?.press(&self.loading(), &Unobserved)
    }
}

/// Displacement over that of the half-space: `ratio` under long waves, 1 under waves shorter than a length \[m\].
fn relative_displacement((ratio, length_m): (f64, f64)) -> impl Fn(f64) -> f64 {
    move |wave_number_per_m| {
        let k = wave_number_per_m * length_m;
        (ratio + k) / (1.0 + k)
    }
}

impl Case for ElementsCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let map = SmallMap::draw(draw, reach);
        let contact_modulus_pa = reach.modulus_pa(draw);
        let periodic = draw.chance(0.75);
        let layer_m = map.length_x_m * draw.decades(-2.0, 1.0);
        let layer = (periodic && draw.chance(0.15)).then_some((draw.decades(-2.0, 2.0), layer_m));
        let mut case = ElementsCase {
            map,
            periodic,
            layer,
            contact_modulus_pa,
            pressure_pa: 1.0,
            saturation_pa: None,
            tolerance: draw.decades(-11.0, -2.0),
        };
        let unit_pa = case.map.wave_pa(case.contact_modulus_pa);
        let unit_pa = if unit_pa.is_normal() { unit_pa } else { contact_modulus_pa };
        case.pressure_pa = match reach {
            Reach::Usual => unit_pa * draw.decades(-4.0, 2.0),
            _ => unit_pa * reach.number(draw, -20.0, 8.0),
        };
        let above = case.pressure_pa * draw.decades(0.0, 3.0);
        let beside = draw.near(case.pressure_pa);
        let a_unit_above = case.pressure_pa.next_up();
        let a_little_above = case.pressure_pa * (1.0 + draw.decades(-15.0, -1.0));
        case.saturation_pa = draw
            .chance(0.35)
            .then(|| draw.one_of(&[above, above, above, beside, a_unit_above, a_little_above]));
        (case, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let contact = match case.press() {
            Ok(contact) => contact,
            Err(HalfSpaceError::CannotBeCarried { .. }) => {
                let refused =
                    case.saturation_pa.is_some_and(|saturation_pa| saturation_pa <= case.pressure_pa);
                trial.hold("a load below the saturation is carried", refused);
                return Err(Refused);
            }
            Err(error) => {
                let is_light =
                    matches!(error, HalfSpaceError::TooLight { least_pa, .. } if case.pressure_pa < least_pa);
                trial.hold(
                    "bad numbers are named",
                    is_light || matches!(error, HalfSpaceError::OutOfBounds(_)),
                );
                return Err(Refused);
            }
        };
        sound(&contact, trial);
        if trial.reach == Reach::Edge {
            return Ok(());
        }
        balanced(&contact, trial);
        if trial.draw.chance(0.05) {
            plain_sums(&contact, trial);
        }
        for test in [symmetric, scaled, rises_with_load, there_and_back, stiffness] {
            if trial.draw.chance(0.3) {
                test(&contact, trial);
            }
        }
        Ok(())
    }
}

/// Checks the numbers of a contact.
fn sound(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let areas = [
        contact.numbers.area_fraction,
        contact.numbers.area_fraction_corrected,
        contact.numbers.plastic_area_fraction_corrected,
        contact.numbers.plastic_area_fraction,
    ];
    trial.hold("areas in [0, 1]", areas.iter().all(|area| (0.0..=1.0).contains(area)));
    trial.hold("corrected area within the counted one", areas[1] <= areas[0] && areas[2] <= areas[0]);
    let numbers = [
        contact.numbers.mean_gap_m,
        contact.numbers.mean_plastic_depth_m,
        contact.numbers.largest_pressure_pa,
        contact.energy_j_per_m2,
        contact.offset_m,
        contact.numbers.residual,
    ];
    trial.hold("numbers finite", numbers.iter().all(|number| number.is_finite()));
    trial.hold("gap, depth and residual at least 0", numbers[..3].iter().all(|number| *number >= 0.0));
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    trial.hold("maps finite", finite(&contact.pressures_pa) && finite(&contact.gaps_m));
    trial.hold("pressures at least 0", contact.pressures_pa.iter().all(|pressure_pa| *pressure_pa >= 0.0));
    if let Some(saturation_pa) = case.saturation_pa {
        let allowed_pa = saturation_pa * (1.0 + 1e-9);
        trial.bound("pressures within the saturation", contact.numbers.largest_pressure_pa, allowed_pa);
    }
    let mean_pa = mean(&contact.pressures_pa);
    trial.bound("the mean pressure is the load", (mean_pa / case.pressure_pa - 1.0).abs(), 1e-12);
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Checks equilibrium, from pressures and gaps.
fn balanced(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let residual = contact.numbers.residual;
    if contact.numbers.ending == Ending::Converged {
        trial.bound("residual within the tolerance", residual, case.tolerance);
    } else {
        let heavy = 1e-14 * case.pressure_pa / case.map.wave_pa(case.contact_modulus_pa);
        trial.bound(
            "rounding ends a solve near the tolerance",
            residual,
            1e-7f64.max(case.tolerance).max(heavy),
        );
    }
    let rms_m = case.map.rms_m();
    if rms_m < FLAT_M {
        return;
    }
    let cap_pa = case.saturation_pa.unwrap_or(f64::INFINITY);
    let rounding_pa = case.pressure_pa * 1e-12;
    let (mut overlap_m, mut opening_m, mut free) = (0.0f64, 0.0f64, 0.0);
    for (&pressure_pa, &gap_m) in contact.pressures_pa.iter().zip(&contact.gaps_m) {
        if pressure_pa <= 0.0 {
            overlap_m = overlap_m.max(-gap_m);
        } else if pressure_pa >= cap_pa * (1.0 - 1e-15) {
            opening_m = opening_m.max(gap_m);
        } else if pressure_pa > rounding_pa && pressure_pa < cap_pa * (1.0 - 1e-9) {
            free += pressure_pa * gap_m.abs();
        }
    }
    let count = contact.pressures_pa.len() as f64;
    let allowed_m = 10.0 * rms_m * residual * (1.0 + 1e-6) + 1e-13 * case.map.rms_m();
    let largest_m = case.map.heights_m.iter().fold(0.0f64, |most, height_m| most.max(height_m.abs()));
    let allowed_m = allowed_m + 1e-14 * largest_m;
    trial.bound("no overlap where nothing carries", overlap_m, allowed_m);
    trial.bound("no gap at the saturation", opening_m, allowed_m);
    let balance = free / (count * case.pressure_pa) / rms_m;
    trial.bound("no pressure at a gap", balance, residual * (1.0 + 1e-6) + 1e-13 + 1e-14 * largest_m / rms_m);
}

/// Compares gaps with plain sums over waves or over Love's coefficients.
fn plain_sums(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let SmallMap { rows, columns, length_x_m, length_y_m, ref heights_m } = case.map;
    let [dx_m, dy_m] = [length_x_m / columns as f64, length_y_m / rows as f64];
    let count = rows * columns;
    let signed = |at: usize, of: usize| if 2 * at > of { at as f64 - of as f64 } else { at as f64 };
    // Displacement under a unit of pressure at a distance of so many rows and columns.
    let response = |row: usize, column: usize| -> f64 {
        if !case.periodic {
            return rectangle(column as f64 * dx_m, row as f64 * dy_m, dx_m, dy_m)
                / (PI * case.contact_modulus_pa);
        }
        let mut sum = 0.0;
        for wave in 1..count {
            let (along_y, along_x) = (wave / columns, wave % columns);
            let q =
                (TAU * signed(along_y, rows) / length_y_m).hypot(TAU * signed(along_x, columns) / length_x_m);
            let body = case.layer.map_or(1.0, |layer| relative_displacement(layer)(q));
            let phase = TAU
                * ((along_y * row % rows) as f64 / rows as f64
                    + (along_x * column % columns) as f64 / columns as f64);
            sum += 2.0 * body / (case.contact_modulus_pa * q) * phase.cos();
        }
        sum / count as f64
    };
    let responses: Vec<f64> = (0..count).map(|at| response(at / columns, at % columns)).collect();
    let (mut worst_m, mut size_m) = (0.0f64, 0.0f64);
    for (point, height_m) in heights_m.iter().enumerate() {
        let (row, column) = (point / columns, point % columns);
        let displacement_m: f64 = (0..count)
            .map(|other| {
                let (from_row, from_column) = (other / columns, other % columns);
                let (rows_apart, columns_apart) = if case.periodic {
                    ((row + rows - from_row) % rows, (column + columns - from_column) % columns)
                } else {
                    (row.abs_diff(from_row), column.abs_diff(from_column))
                };
                responses[rows_apart * columns + columns_apart] * contact.pressures_pa[other]
            })
            .sum();
        let gap_m = displacement_m - height_m - contact.offset_m;
        worst_m = worst_m.max((gap_m - contact.gaps_m[point]).abs());
        let uniform_m = contact.numbers.largest_pressure_pa
            * responses.iter().map(|response| response.abs()).sum::<f64>();
        size_m = size_m.max(uniform_m).max(height_m.abs()).max(contact.offset_m.abs());
    }
    trial.bound("plain sums agree on the gaps", worst_m, 1e-11 * size_m);
}

/// Integral of 1/r over a rectangle around a point at a distance (Love 1929).
fn rectangle(x_m: f64, y_m: f64, dx_m: f64, dy_m: f64) -> f64 {
    let corner = |x: f64, y: f64| {
        let r = x.hypot(y);
        let part =
            |along: f64, across: f64| if along == 0.0 { 0.0 } else { along * (across / along.abs()).asinh() };
        if r == 0.0 { 0.0 } else { part(x, y) + part(y, x) }
    };
    let (x, y) = ([x_m - 0.5 * dx_m, x_m + 0.5 * dx_m], [y_m - 0.5 * dy_m, y_m + 0.5 * dy_m]);
    corner(x[1], y[1]) - corner(x[0], y[1]) - corner(x[1], y[0]) + corner(x[0], y[0])
}

/// Effect of a residual on mean quantities of a solution: the energy is off by its square, gaps by itself. Gaps also have the
/// rounding of heights and of displacements, whose difference they are: displacements are of the size of the offset, and of what the
/// largest pressure moves as a wave.
fn slack(case: &ElementsCase, contact: &Contact) -> f64 {
    let larger_m = |most: f64, height_m: &f64| most.max(height_m.abs());
    let largest_m = case.map.heights_m.iter().fold(contact.offset_m.abs(), larger_m);
    let rounding = largest_m / case.map.rms_m().max(f64::MIN_POSITIVE)
        + contact.numbers.largest_pressure_pa
            / case.map.wave_pa(case.contact_modulus_pa).max(f64::MIN_POSITIVE);
    (contact.numbers.residual.max(case.tolerance) * (case.map.heights_m.len() as f64).max(10.0) * 10.0
        + 1e-13 * rounding)
        .min(1e3)
}

/// Checks that transposing, mirroring and shifting do not matter.
fn symmetric(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let rms_m = case.map.rms_m();
    if rms_m < FLAT_M {
        return;
    }
    let (rows, columns) = (case.map.rows as f64, case.map.columns as f64);
    let by = [trial.draw.between(0.0, rows) as usize, trial.draw.between(0.0, columns) as usize];
    let turned = [
        ("transposed map", Some(case.map.transposed())),
        ("mirrored map", Some(case.map.mirrored())),
        ("shifted map", case.periodic.then(|| case.map.shifted(by[0], by[1]))),
    ];
    for (promise, map) in turned {
        let Some(map) = map else { continue };
        let other = ElementsCase { map, ..case.clone() };
        let Ok(there) = other.press() else {
            trial.hold(promise, false);
            continue;
        };
        let off_m = (there.numbers.mean_gap_m - contact.numbers.mean_gap_m).abs();
        trial.bound(promise, off_m / rms_m, slack(case, contact));
    }
}

/// Checks that powers of two in lengths, heights and pressures change no digit.
fn scaled(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let [height, length, pressure] = [0, 1, 2].map(|_| 2f64.powi(trial.draw.between(-10.0, 10.0) as i32));
    let of_pressure = pressure * height / length;
    let other = ElementsCase {
        map: case.map.scaled(height, length),
        layer: case.layer.map(|(ratio, length_m)| (ratio, length * length_m)),
        contact_modulus_pa: pressure * case.contact_modulus_pa,
        pressure_pa: of_pressure * case.pressure_pa,
        saturation_pa: case.saturation_pa.map(|saturation_pa| of_pressure * saturation_pa),
        ..case.clone()
    };
    // A flat map has the length as its unit; heights near the smallest double lose digits.
    let exact = case.map.heights_m.iter().all(|height_m| *height_m == 0.0 || height_m.abs() > 1e-290);
    if !exact || case.map.rms_m() < 1e-26 {
        return;
    }
    let Ok(there) = other.press() else { return };
    let same = contact
        .pressures_pa
        .iter()
        .zip(&there.pressures_pa)
        .all(|(here, there)| of_pressure * here == *there);
    trial.hold(
        "powers of two change no digit",
        same && there.numbers.area_fraction == contact.numbers.area_fraction,
    );
}

/// Checks that a larger load closes the gap.
fn rises_with_load(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let factor = 1.0 + trial.draw.decades(-3.0, 1.0);
    let more = ElementsCase { pressure_pa: factor * case.pressure_pa, saturation_pa: None, ..case.clone() };
    let rms_m = case.map.rms_m();
    if case.saturation_pa.is_some() || rms_m < FLAT_M {
        return;
    }
    let Ok(there) = more.press() else { return };
    let slack = slack(case, contact);
    trial.bound("the planes approach with the load", contact.offset_m - there.offset_m, slack * rms_m);
    trial.bound(
        "the mean gap falls with the load",
        there.numbers.mean_gap_m - contact.numbers.mean_gap_m,
        slack * rms_m,
    );
}

/// Checks that the distance of a contact gives back its load.
fn there_and_back(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let heights_m = &case.map.heights_m;
    let rms_m = case.map.rms_m();
    let highest_m = heights_m.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let depth_m = contact.offset_m + highest_m;
    let full = contact.numbers.area_fraction == 1.0;
    // Within a loose tolerance surfaces overlap by more than light loads press them.
    let loose = case.tolerance > 1e-8;
    if rms_m < FLAT_M || (full && case.periodic) || case.saturation_pa.is_some() || loose {
        return;
    }
    let approach = Approach::IndentationM(depth_m);
    let closing = Closing {
        contact_modulus_pa: case.contact_modulus_pa,
        approach,
        saturation_pa: case.saturation_pa,
        tolerance: case.tolerance,
    };
    let Ok(mut elements) = case.elements() else { return };
    match elements.press_to(&closing, &Unobserved) {
        Ok(back) => {
            // The load is off by what the slack in the distance carries: at most by the stiffness under the larger load, since
            // the stiffness rises with it. A full contact has none.
            let mut stiffest_pa_per_m = 0.0f64;
            for state in [contact, &back] {
                let stiffness = elements.stiffness_pa_per_m(state, case.contact_modulus_pa, &Unobserved);
                let Ok(Some(stiffness_pa_per_m)) = stiffness else { return };
                stiffest_pa_per_m = stiffest_pa_per_m.max(stiffness_pa_per_m);
            }
            let off_pa = (back.numbers.nominal_pressure_pa - case.pressure_pa).abs();
            let allowed_pa = slack(case, contact) * (rms_m * stiffest_pa_per_m + case.pressure_pa);
            trial.bound("load -> distance -> load", off_pa, allowed_pa);
        }
        Err(HalfSpaceError::Closed { .. } | HalfSpaceError::OutOfBounds(_)) => (),
        Err(_) => trial.hold("a distance that was reached can be held", false),
    }
}

/// Checks the stiffness.
fn stiffness(contact: &Contact, trial: &mut Trial<ElementsCase>) {
    let case = trial.case;
    let Ok(mut elements) = case.elements() else { return };
    match elements.stiffness_pa_per_m(contact, case.contact_modulus_pa, &Unobserved) {
        Ok(Some(stiffness)) => trial.hold("stiffness positive", stiffness > 0.0 && stiffness.is_finite()),
        Ok(None) => trial.hold(
            "no stiffness at full contact alone",
            case.periodic && contact.numbers.area_fraction == 1.0,
        ),
        Err(_) => trial.hold("a contact has a stiffness", false),
    }
}
