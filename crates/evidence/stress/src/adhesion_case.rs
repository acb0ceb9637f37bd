//! Adhesive boundary elements under small maps: their numbers, and the promises of every result.

use elements::half_space::{
    Adhesion, AdhesionError, AdhesiveContact, AdhesiveElements, Control, LEAST_RESOLUTION, Start,
};
use numerics::parallel::Unobserved;

use crate::drawn_map::SmallMap;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Map, body, attraction and load; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct AdhesionCase {
    /// The map.
    pub map: SmallMap,
    /// Contact modulus \[Pa\].
    pub contact_modulus_pa: f64,
    /// Work of adhesion \[J/m^2\].
    pub work_j_per_m2: f64,
    /// Range \[m\].
    pub range_m: f64,
    /// Quantity that is held.
    pub control: Control,
    /// True if the solve starts in full contact.
    pub from_contact: bool,
    /// Tolerance of the solve.
    pub tolerance: f64,
}

impl AdhesionCase {
    fn elements(&self) -> Result<AdhesiveElements, AdhesionError> {
        let adhesion = Adhesion { work_j_per_m2: self.work_j_per_m2, range_m: self.range_m };
        AdhesiveElements::new(self.map.grid()?, &self.map.heights_m, self.contact_modulus_pa, adhesion)
    }

    fn start(&self) -> Start {
        if self.from_contact { Start::Contact } else { Start::Apart }
    }

    fn solve(&self, control: Control, start: Start) -> Result<AdhesiveContact, AdhesionError> {
        self.elements()?.solve(control, start, self.tolerance, &Unobserved)
    }
}

impl Case for AdhesionCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let map = SmallMap::draw(draw, reach);
        let contact_modulus_pa = reach.modulus_pa(draw);
        let spacing_m = (map.length_x_m / map.columns as f64).max(map.length_y_m / map.rows as f64);
        let range_m = map.rms_m().max(f64::MIN_POSITIVE) * reach.number(draw, -2.0, 2.0);
        // E* rho^2/w over the spacing.
        let resolution = draw.decades(-0.3, 3.0);
        let work_j_per_m2 = contact_modulus_pa * range_m * (range_m / (resolution * spacing_m));
        let mut case = AdhesionCase {
            map,
            contact_modulus_pa,
            work_j_per_m2,
            range_m,
            control: Control::PressurePa(0.0),
            from_contact: draw.chance(0.5),
            tolerance: draw.decades(-9.0, -3.0),
        };
        let unit_pa = case.map.wave_pa(case.contact_modulus_pa) + work_j_per_m2 / range_m;
        let load_pa = unit_pa * draw.decades(-4.0, 1.0);
        let pull_pa = -unit_pa * draw.decades(-6.0, 0.0);
        let gap_m = case.map.rms_m() * draw.decades(-2.0, 0.7);
        case.control = draw.one_of(&[
            Control::PressurePa(load_pa),
            Control::PressurePa(load_pa),
            Control::PressurePa(pull_pa),
            Control::PressurePa(0.0),
            Control::MeanGapM(gap_m),
        ]);
        (case, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let contact = match case.solve(case.control, case.start()) {
            Ok(contact) => contact,
            Err(AdhesionError::Unresolved { process_zone_m, spacing_m, points }) => {
                trial.hold(
                    "refused below the least resolution",
                    process_zone_m < LEAST_RESOLUTION * spacing_m,
                );
                let longer_m = case.map.length_x_m.max(case.map.length_y_m);
                let resolved = points as f64 * process_zone_m >= longer_m * (1.0 - 1e-12);
                trial.hold("a number of points that would do", resolved || points == usize::MAX);
                return Err(Refused);
            }
            Err(AdhesionError::PulledOff { nominal_pressure_pa }) => {
                trial.hold("no load tears off", nominal_pressure_pa <= 0.0);
                return Ok(());
            }
            Err(AdhesionError::NotConverged { .. }) => {
                // Whether such a state exists is not promised at the edge.
                let is_pressed = matches!(case.control, Control::PressurePa(load_pa) if load_pa > 0.0);
                if trial.reach == Reach::Usual && is_pressed && !case.from_contact {
                    trial.hold("usual loads converge from apart", false);
                }
                return Err(Refused);
            }
            Err(_) => return Err(Refused),
        };
        sound(&contact, trial);
        if trial.reach == Reach::Edge {
            return Ok(());
        }
        balanced(&contact, trial);
        if trial.draw.chance(0.3) {
            full_contact(trial);
        }
        Ok(())
    }
}

/// Checks the numbers of a contact.
fn sound(contact: &AdhesiveContact, trial: &mut Trial<AdhesionCase>) {
    let case = trial.case;
    let areas = [
        contact.numbers.area_fraction,
        contact.numbers.area_fraction_corrected,
        contact.numbers.repulsive_area_fraction,
    ];
    trial.hold("areas in [0, 1]", areas.iter().all(|area| (0.0..=1.0).contains(area)));
    trial.hold("the repulsive area is part of the area", areas[2] <= areas[0] && areas[1] <= areas[0]);
    let numbers = [
        contact.numbers.nominal_pressure_pa,
        contact.numbers.mean_gap_m,
        contact.numbers.mean_attraction_pa,
        contact.numbers.largest_contact_pressure_pa,
        contact.numbers.residual,
    ];
    trial.hold("numbers finite", numbers.iter().all(|number| number.is_finite()));
    trial.hold(
        "gaps finite, at least 0",
        contact.gaps_m.iter().all(|gap_m| *gap_m >= 0.0 && gap_m.is_finite()),
    );
    trial.hold("pressures finite", contact.pressures_pa.iter().all(|pressure_pa| pressure_pa.is_finite()));
    if let Control::MeanGapM(gap_m) = case.control {
        trial.bound("the mean gap is held", (contact.numbers.mean_gap_m / gap_m - 1.0).abs(), 1e-9);
    }
}

/// Checks equilibrium, from gaps and pressures.
fn balanced(contact: &AdhesiveContact, trial: &mut Trial<AdhesionCase>) {
    let case = trial.case;
    let largest_pa = case.work_j_per_m2 / case.range_m;
    let attraction_pa = |gap_m: f64| largest_pa * (-gap_m / case.range_m).exp();
    let count = contact.gaps_m.len() as f64;
    let mean_attraction_pa = contact.gaps_m.iter().map(|gap_m| attraction_pa(*gap_m)).sum::<f64>() / count;
    // Pressure of the shortest waves: the residual is relative to that of full contact.
    let SmallMap { rows, columns, length_x_m, length_y_m, .. } = case.map;
    let spacing_m = (length_x_m / columns as f64).min(length_y_m / rows as f64);
    let full_pa = case.contact_modulus_pa * (case.map.rms_m() / spacing_m);
    let unit_pa = full_pa.max(contact.numbers.nominal_pressure_pa.abs()).max(largest_pa);
    let off_pa = (mean_attraction_pa - contact.numbers.mean_attraction_pa).abs();
    trial.bound("mean attraction", off_pa, 1e-10 * unit_pa);
    let mean_pa = contact.pressures_pa.iter().sum::<f64>() / count;
    let off_pa = (mean_pa - contact.numbers.nominal_pressure_pa).abs();
    let slack = if contact.is_rounded { 1e-6 } else { case.tolerance };
    trial.bound("the mean pressure is the load", off_pa / unit_pa, slack * 100.0 + 1e-10);
    let (mut at_gap_pa, mut pulled_pa) = (0.0f64, 0.0f64);
    for (&gap_m, &pressure_pa) in contact.gaps_m.iter().zip(&contact.pressures_pa) {
        let contact_pa = pressure_pa + attraction_pa(gap_m);
        if gap_m > 0.0 {
            at_gap_pa = at_gap_pa.max(contact_pa.abs());
        } else {
            pulled_pa = pulled_pa.max(-contact_pa);
        }
    }
    trial.bound("no contact pressure at a gap", at_gap_pa / unit_pa, slack * 100.0 + 1e-10);
    trial.bound("no pull in contact beyond the attraction", pulled_pa / unit_pa, slack * 100.0 + 1e-10);
}

/// Checks that full contact holds above its pressure.
fn full_contact(trial: &mut Trial<AdhesionCase>) {
    let case = trial.case;
    let Ok(elements) = case.elements() else { return };
    let full_pa = elements.full_contact_pressure_pa();
    trial.hold("pressure of full contact finite", full_pa.is_finite());
    let unit_pa = case.map.wave_pa(case.contact_modulus_pa) + case.work_j_per_m2 / case.range_m;
    let above_pa = full_pa + unit_pa * (trial.draw.decades(-3.0, 1.0) + 1e2 * case.tolerance);
    match case.solve(Control::PressurePa(above_pa), Start::Contact) {
        Ok(contact) => {
            trial.hold("full contact stays above its pressure", contact.numbers.area_fraction == 1.0)
        }
        Err(_) => trial.hold("full contact stays above its pressure", false),
    }
}
