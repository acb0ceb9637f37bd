//! Linear response of a contact to a little more load, while the same points touch.

use crate::half_space::problem::{Operators, State};
use crate::half_space::sums;

/// Relative error of the stiffness, as estimated by the preconditioner.
const ACCURACY: f64 = 1e-8;

/// Steps after which the solution is taken as it is: conjugate gradients need some tens.
const MOST_STEPS: usize = 2000;

/// Approach of the bodies per unit of mean pressure. The points in `touching` stay together and no other joins.
/// `None` if `goes_on` ends the work.
///
/// Among all changes of pressure in contact whose mean is 1, the solution has the least energy (1/2) p.Kp, and the
/// approach is twice that over the number of points: its error is the square of that of the pressures. Conjugate
/// gradients, preconditioned with |q| as in the solve itself.
pub(crate) fn approach_per_pressure(
    points: usize,
    touching: &[u32],
    operators: &mut Operators,
    state: &mut State,
    goes_on: impl Fn() -> bool,
) -> Option<f64> {
    let [pressures, displacements, direction, response] = state.maps();
    pressures.fill(0.0);
    direction.fill(0.0);
    let share = points as f64 / touching.len() as f64;
    touching.iter().for_each(|&point| pressures[point as usize] = share);
    operators.compliance.apply(pressures, displacements);
    let mut gradient = vec![0.0f32; points];
    let (mut energy, mut steepness) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..MOST_STEPS {
        if !goes_on() {
            return None;
        }
        let [sum, work] = sums::over(touching.len(), |at| {
            let point = touching[at] as usize;
            [displacements[point], pressures[point] * displacements[point]]
        });
        energy = work;
        let mean = sum / touching.len() as f64;
        gradient.fill(0.0);
        touching
            .iter()
            .for_each(|&point| gradient[point as usize] = (displacements[point as usize] - mean) as f32);
        operators.preconditioner.apply_in_place(&mut gradient);
        let [sum, steep] = sums::over(touching.len(), |at| {
            let point = touching[at] as usize;
            let z = f64::from(gradient[point]);
            [z, z * (displacements[point] - mean)]
        });
        if steep <= ACCURACY * energy {
            break;
        }
        // The first step keeps no old direction: it is 0.
        let keep = steep / steepness;
        steepness = steep;
        let mean_z = sum / touching.len() as f64;
        touching.iter().for_each(|&point| {
            let point = point as usize;
            direction[point] = keep * direction[point] - (f64::from(gradient[point]) - mean_z);
        });
        operators.compliance.apply(direction, response);
        let [slope, curvature] = sums::over(touching.len(), |at| {
            let point = touching[at] as usize;
            [direction[point] * displacements[point], direction[point] * response[point]]
        });
        if curvature <= 0.0 || slope >= 0.0 {
            break;
        }
        let length = -slope / curvature;
        touching.iter().for_each(|&point| {
            let point = point as usize;
            pressures[point] += length * direction[point];
            displacements[point] += length * response[point];
        });
    }
    Some(energy / points as f64)
}
