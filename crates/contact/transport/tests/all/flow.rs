//! Flow factors with a closed form, and their symmetries.

use elements::half_space::Grid;
use numerics::parallel::Unobserved;
use transport::GapField;
use transport::flow::{Direction, Ends, solve};

const BOTH: [Direction; 2] = [Direction::X, Direction::Y];

fn grid(rows: usize, columns: usize) -> Grid {
    Grid::new(rows, columns, 3e-5, 2e-5).unwrap()
}

fn factor(grid: Grid, gaps_m: &[f64], direction: Direction, ends: Ends) -> f64 {
    let flow = solve(&GapField::new(grid, gaps_m).unwrap(), direction, ends, &Unobserved).unwrap();
    assert!(flow.residual < 1e-10, "{}", flow.residual);
    flow.flow_factor
}

#[test]
fn a_slot_has_a_flow_factor_of_1() {
    for (rows, columns) in [(1, 1), (1, 5), (2, 2), (7, 12)] {
        for direction in BOTH {
            for ends in [Ends::Periodic, Ends::Reservoirs] {
                let found = factor(grid(rows, columns), &vec![2e-7; rows * columns], direction, ends);
                assert!((found - 1.0).abs() < 1e-12, "{rows} {columns} {direction:?} {ends:?}: {found}");
            }
        }
    }
}

#[test]
fn a_gap_that_varies_along_one_direction_has_its_closed_forms() {
    let (rows, columns) = (9, 16);
    let profile = |column: usize| 1e-6 * (1.2 + (0.9 * column as f64).sin());
    let gaps_m: Vec<f64> = (0..rows * columns).map(|point| profile(point % columns)).collect();
    let mean = |of: &dyn Fn(f64) -> f64| (0..columns).map(|at| of(profile(at))).sum::<f64>() / columns as f64;
    let mean_m = mean(&|gap_m| gap_m);
    let in_series = 1.0 / (mean(&|gap_m| gap_m.powi(-3)) * mean_m.powi(3));
    let side_by_side = mean(&|gap_m| gap_m.powi(3)) / mean_m.powi(3);
    for ends in [Ends::Periodic, Ends::Reservoirs] {
        let [along, across] = BOTH.map(|direction| factor(grid(rows, columns), &gaps_m, direction, ends));
        assert!((along / in_series - 1.0).abs() < 1e-12, "{along} {in_series}");
        assert!((across / side_by_side - 1.0).abs() < 1e-12, "{across} {side_by_side}");
    }
}
