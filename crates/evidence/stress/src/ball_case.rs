//! Balls on small maps: their numbers, and the promises of every result.

use elements::half_space::HalfSpaceError;
use elements::{Boundary, Indenter, IndenterError, IndenterPressing, IndenterShape, IndenterState, Relief};
use numerics::parallel::Unobserved;

use crate::drawn_map::SmallMap;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Map, ball and load; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct BallCase {
    /// The map.
    pub map: SmallMap,
    /// Contact modulus \[Pa\].
    pub contact_modulus_pa: f64,
    /// Radius of the ball \[m\].
    pub radius_m: f64,
    /// Force \[N\].
    pub force_n: f64,
    /// Tolerance of the solve.
    pub tolerance: f64,
}

impl BallCase {
    fn relief(&self) -> Relief {
        let SmallMap { rows, columns, length_x_m, length_y_m, ref heights_m } = self.map;
        let heights_m = heights_m.clone();
        Relief {
            rows,
            columns,
            length_x_m,
            length_y_m,
            heights_m,
            boundary: Boundary::Free,
            is_missing: Vec::new(),
        }
    }

    fn press(&self) -> Result<IndenterState, IndenterError> {
        let ball = Indenter { shape: IndenterShape::Ball, radius_m: self.radius_m, force: self.force_n };
        let pressing =
            IndenterPressing { contact_modulus_pa: self.contact_modulus_pa, tolerance: self.tolerance };
        ball.press(&self.relief(), &pressing, &Unobserved).map(|(state, _)| state)
    }

    fn scaled(&self, length: f64, pressure: f64) -> Self {
        BallCase {
            map: self.map.scaled(length, length),
            contact_modulus_pa: pressure * self.contact_modulus_pa,
            radius_m: length * self.radius_m,
            force_n: pressure * length * length * self.force_n,
            ..*self
        }
    }
}

impl Case for BallCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let mut map = SmallMap::draw(draw, reach);
        if draw.chance(0.3) {
            map.heights_m.fill(0.0);
        }
        let contact_modulus_pa = reach.modulus_pa(draw);
        let side_m = map.length_x_m.min(map.length_y_m);
        let contact_m = side_m * draw.decades(-1.5, -0.3);
        let radius_m = contact_m * reach.number(draw, 0.5, 5.0);
        // a^3 = 3 F R/(4 E*).
        let force_n = 4.0 / 3.0 * contact_modulus_pa * contact_m * contact_m * (contact_m / radius_m);
        (BallCase { map, contact_modulus_pa, radius_m, force_n, tolerance: draw.decades(-10.0, -4.0) }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let state = match case.press() {
            Ok(state) => state,
            Err(IndenterError::BeyondMap { reach_m, half_side_m, least_side_m, .. }) => {
                let is_named = reach_m > 0.0 && half_side_m > 0.0 && least_side_m.is_finite();
                trial.hold("a map too small is named", is_named || trial.reach == Reach::Edge);
                return Err(Refused);
            }
            Err(error) => {
                let is_bound = matches!(
                    error,
                    IndenterError::OutOfBounds { .. }
                        | IndenterError::HalfSpace(
                            HalfSpaceError::OutOfBounds(_) | HalfSpaceError::TooLight { .. }
                        )
                );
                trial.hold("bad numbers are named", is_bound);
                return Err(Refused);
            }
        };
        let numbers = [
            state.real_area,
            state.effective_radius_m,
            state.hertz_radius_m,
            state.peak_mean_pressure_pa,
            state.hertz_pressure_pa,
            state.force_share,
            state.outermost_contact_m,
            state.real_area_corrected,
            state.roughness_number,
            state.points_per_radius,
            state.residual,
        ];
        trial.hold(
            "numbers finite, at least 0",
            numbers.iter().all(|number| number.is_finite() && *number >= 0.0),
        );
        let area_m2 = case.map.length_x_m * case.map.length_y_m;
        trial.bound("real area within the map", state.real_area, area_m2 * (1.0 + 1e-12));
        trial.bound(
            "corrected area within the counted one",
            state.real_area_corrected,
            state.real_area * (1.0 + 1e-12),
        );
        trial.hold("share of the force in [0, 1]", (0.0..=1.0 + 1e-12).contains(&state.force_share));
        let half_m = 0.5 * case.map.length_x_m.min(case.map.length_y_m);
        trial.bound("contact inside the map", state.outermost_contact_m, half_m);
        // 16/(3 pi) of the mean distance of the force from the axis.
        trial.bound(
            "effective radius within the contact",
            state.effective_radius_m,
            1.698 * state.outermost_contact_m,
        );
        if trial.reach == Reach::Edge {
            return Ok(());
        }
        if case.map.rms_m() == 0.0 && state.points_per_radius >= 8.0 {
            let off = (state.effective_radius_m / state.hertz_radius_m - 1.0).abs();
            trial.bound("a smooth flat has Hertz's radius", off, 0.02);
        }
        let [length, pressure] = [0, 1].map(|_| 2f64.powi(trial.draw.between(-8.0, 8.0) as i32));
        if let Ok(there) = case.scaled(length, pressure).press() {
            let off =
                (there.effective_radius_m / length - state.effective_radius_m).abs() / state.hertz_radius_m;
            trial.bound("units do not matter", off, 1e-12);
        }
        Ok(())
    }
}
