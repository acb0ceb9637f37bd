//! Flow factors with a closed form, their symmetries, and both methods on one field.

use elements::half_space::Grid;
use numerics::parallel::{Progress, Unobserved};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use transport::GapField;
use transport::flow::{
    Ends, FlowDirection, FlowError, Method, PROGRESS_STEPS, SolvedFlow, solve, solve_by, spacing_error,
};

const BOTH: [FlowDirection; 2] = [FlowDirection::X, FlowDirection::Y];
const ALL_ENDS: [Ends; 2] = [Ends::Periodic, Ends::Reservoirs];
const METHODS: [Method; 2] = [Method::Direct, Method::Iterative];

fn grid(rows: usize, columns: usize) -> Grid {
    Grid::new(rows, columns, 3e-5, 2e-5).unwrap()
}

fn flow_by(method: Method, grid: Grid, gaps_m: &[f64], direction: FlowDirection, ends: Ends) -> SolvedFlow {
    solve_by(method, &GapField::new(grid, gaps_m).unwrap(), direction, ends, &Unobserved).unwrap()
}

fn factor_by(method: Method, grid: Grid, gaps_m: &[f64], direction: FlowDirection, ends: Ends) -> f64 {
    let flow = flow_by(method, grid, gaps_m, direction, ends);
    assert!(flow.residual <= 1e-8, "{method:?}: {}", flow.residual);
    flow.flow_factor
}

/// Factor by the iteration, after a comparison with that of the direct solution.
fn factor(grid: Grid, gaps_m: &[f64], direction: FlowDirection, ends: Ends) -> f64 {
    let [direct, iterative] = METHODS.map(|method| factor_by(method, grid, gaps_m, direction, ends));
    let case = format!("{grid:?} {direction:?} {ends:?}");
    assert!((iterative - direct).abs() <= 1e-8 * direct, "{case}: {iterative} {direct}");
    assert_eq!(iterative == 0.0, direct == 0.0, "{case}");
    iterative
}

/// Heights of a Gaussian surface with an rms of 1.
fn heights(points: usize, longest: f64, shortest: f64, seed: u64) -> Vec<f64> {
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: longest,
        rolloff_m: longest,
        shortest_m: shortest,
        size: Size::RmsHeightM(1.0),
    });
    let synthesis = Synthesis::square(points, 1.0, seed, Phases::FixedModulus);
    spectrum.unwrap().surface(&synthesis, 0).unwrap().heights_m
}

/// Gaps like those of a pressed surface: a share is closed, and the others rise with distance^1.5 from the edge of contact.
fn pressed_like(rows: usize, columns: usize, closed: f64, seed: u64) -> Vec<f64> {
    let points = rows.max(columns).next_power_of_two().max(32);
    let heights = heights(points, 0.25, 4.0 / points as f64, seed);
    let mut field: Vec<f64> =
        (0..rows * columns).map(|at| heights[at / columns * points + at % columns]).collect();
    let mut sorted = field.clone();
    sorted.sort_by(f64::total_cmp);
    let cut = sorted[((rows * columns) as f64 * closed) as usize];
    field.iter_mut().for_each(|height| *height = (*height - cut).max(0.0).powf(1.5));
    field
}

#[test]
fn points_without_a_gap_and_with_next_to_none_are_closed() {
    let gaps_m = [1e-6, 1e-12, f64::INFINITY, f64::NAN, -1e-6, 1e-10];
    let gap = GapField::new(grid(2, 3), &gaps_m[..]).unwrap();
    let found: Vec<f64> = (0..6).map(|point| gap.gap_m(point)).collect();
    assert_eq!(found, [1e-6, 0.0, 0.0, 0.0, 0.0, 1e-10]);
    assert_eq!(gap.closed_share(), 4.0 / 6.0);
    assert!((gap.mean_gap_m() / (1e-6 / 6.0) - 1.0).abs() < 1e-3);
}

#[test]
fn a_slot_has_a_flow_factor_of_1() {
    for (rows, columns) in [(1, 1), (1, 5), (5, 1), (2, 2), (7, 12), (64, 81)] {
        for direction in BOTH {
            for ends in ALL_ENDS {
                let found = factor(grid(rows, columns), &vec![2e-7; rows * columns], direction, ends);
                assert!((found - 1.0).abs() < 1e-12, "{rows} {columns} {direction:?} {ends:?}: {found}");
            }
        }
    }
}

#[test]
fn a_gap_that_varies_along_one_direction_has_its_closed_forms() {
    for (rows, columns) in [(9, 16), (61, 97)] {
        let profile = |column: usize| 1e-6 * (1.2 + (0.9 * column as f64).sin());
        let gaps_m: Vec<f64> = (0..rows * columns).map(|point| profile(point % columns)).collect();
        let mean =
            |of: &dyn Fn(f64) -> f64| (0..columns).map(|at| of(profile(at))).sum::<f64>() / columns as f64;
        let mean_m = mean(&|gap_m| gap_m);
        let in_series = 1.0 / (mean(&|gap_m| gap_m.powi(-3)) * mean_m.powi(3));
        let side_by_side = mean(&|gap_m| gap_m.powi(3)) / mean_m.powi(3);
        for ends in ALL_ENDS {
            let [along, across] = BOTH.map(|direction| factor(grid(rows, columns), &gaps_m, direction, ends));
            assert!((along / in_series - 1.0).abs() < 1e-12, "{along} {in_series}");
            assert!((across / side_by_side - 1.0).abs() < 1e-12, "{across} {side_by_side}");
        }
    }
}

#[test]
fn both_methods_agree_on_fields_of_any_shape_and_a_turned_field_exchanges_the_directions() {
    let mut open = 0;
    for (seed, (rows, columns)) in
        [(97, 101), (1, 64), (2, 33), (3, 3), (128, 128), (211, 64), (150, 75)].into_iter().enumerate()
    {
        for closed in [0.02, 0.2, 0.36, 0.41] {
            let gaps_m = pressed_like(rows, columns, closed, seed as u64);
            let turned: Vec<f64> =
                (0..rows * columns).map(|at| gaps_m[at % rows * columns + at / rows]).collect();
            let (grid, turned_grid) = (
                Grid::new(rows, columns, 3e-5, 2e-5).unwrap(),
                Grid::new(columns, rows, 2e-5, 3e-5).unwrap(),
            );
            for ends in ALL_ENDS {
                let [x, y] = BOTH.map(|direction| factor(grid, &gaps_m, direction, ends));
                let [turned_x, turned_y] =
                    BOTH.map(|direction| factor(turned_grid, &turned, direction, ends));
                assert!((x - turned_y).abs() <= 1e-10 * x, "{rows} {columns} {closed}: {x} {turned_y}");
                assert!((y - turned_x).abs() <= 1e-10 * y, "{rows} {columns} {closed}: {y} {turned_x}");
                open += usize::from(x > 0.0) + usize::from(y > 0.0);
            }
        }
    }
    assert!(open > 50, "{open}");
}

#[test]
fn a_large_field_is_solved_by_iteration_with_a_flux_that_is_conserved() {
    let points = 384;
    let gaps_m = pressed_like(points, points, 0.2, 5);
    let grid = grid(points, points);
    let flow =
        solve(&GapField::new(grid, &gaps_m).unwrap(), FlowDirection::X, Ends::Periodic, &Unobserved).unwrap();
    assert!((1..=30).contains(&flow.iterations), "{}", flow.iterations);
    let direct = flow_by(Method::Direct, grid, &gaps_m, FlowDirection::X, Ends::Periodic);
    assert_eq!(direct.iterations, 0);
    assert!((flow.flow_factor / direct.flow_factor - 1.0).abs() < 1e-9);
    for column in [0, 100, 383] {
        let flow: f64 = (0..points).map(|row| flow.flux[row * points + column][0]).sum();
        assert!((flow / points as f64 - 1.0).abs() < 1e-4, "{column}: {flow}");
    }
    let off = flow.flux.iter().zip(&direct.flux).map(|(one, other)| (one[0] - other[0]).abs());
    assert!(off.fold(0.0, f64::max) < 1e-3);
}

#[test]
fn channels_count_only_where_they_lead_around_the_field_along_the_flow() {
    let picture = |lines: &[&str]| -> (Grid, Vec<f64>) {
        let gaps_m = lines.iter().flat_map(|line| line.bytes().map(|b| f64::from(u8::from(b == b'o'))));
        (Grid::new(lines.len(), lines[0].len(), 1.0, 1.0).unwrap(), gaps_m.collect())
    };
    // An island, a dead end, and a wall that closes x.
    let (grid, gaps_m) = picture(&["o.....", "o..o..", "ooo...", "o....."]);
    for ends in ALL_ENDS {
        assert_eq!(factor(grid, &gaps_m, FlowDirection::X, ends), 0.0);
        let flow = flow_by(Method::Iterative, grid, &gaps_m, FlowDirection::X, ends);
        assert!(!flow.is_open() && flow.flux.is_empty());
        // Without island and dead end the flow is that of the channel, 1 point of 6 wide.
        let mean_gap: f64 = gaps_m.iter().sum::<f64>() / 24.0;
        let found = factor(grid, &gaps_m, FlowDirection::Y, ends);
        assert!((found * mean_gap.powi(3) - 1.0 / 6.0).abs() < 1e-12, "{found}");
    }
    // A staircase that winds around both directions: closed between reservoirs at opposite sides where it does not wrap.
    let (grid, gaps_m) = picture(&["oo....", ".oo...", "..oo..", "...oo.", "....oo", "o....o"]);
    let [x, y] = BOTH.map(|direction| factor(grid, &gaps_m, direction, Ends::Periodic));
    // Twelve ties in series fall by 6, on 6 lines of flow.
    let mean_gap: f64 = gaps_m.iter().sum::<f64>() / 36.0;
    assert!((x * mean_gap.powi(3) - 1.0 / 12.0).abs() < 1e-12, "{x}");
    assert!((x - y).abs() < 1e-12 * x);
    // One that is cut at the seam.
    let (grid, mut gaps_m) = picture(&["oo....", ".oo...", "..oo..", "...oo.", "....oo", "o....o"]);
    gaps_m[30] = 0.0;
    for direction in BOTH {
        assert_eq!(factor(grid, &gaps_m, direction, Ends::Periodic), 0.0);
    }
    assert_eq!(factor(grid, &[0.0; 36], FlowDirection::X, Ends::Periodic), 0.0);
}

#[test]
fn more_gap_lets_more_through_and_the_scale_of_gaps_does_not_count() {
    let (rows, columns) = (67, 90);
    let gaps_m = pressed_like(rows, columns, 0.3, 8);
    let mean_m = |gaps_m: &[f64]| gaps_m.iter().sum::<f64>() / (rows * columns) as f64;
    let through = |gaps_m: &[f64]| {
        factor(grid(rows, columns), gaps_m, FlowDirection::X, Ends::Periodic) * mean_m(gaps_m).powi(3)
    };
    let mut before = through(&gaps_m);
    let mut wider = gaps_m.clone();
    for first in [0, 1, 2] {
        wider.iter_mut().skip(first).step_by(17).for_each(|gap_m| *gap_m = *gap_m * 1.5 + 0.01);
        let after = through(&wider);
        assert!(after > before, "{after} {before}");
        before = after;
    }
    let one = factor(grid(rows, columns), &gaps_m, FlowDirection::X, Ends::Periodic);
    for scale in [1e-9, 1e9] {
        let scaled: Vec<f64> = gaps_m.iter().map(|gap_m| scale * gap_m).collect();
        let found = factor(grid(rows, columns), &scaled, FlowDirection::X, Ends::Periodic);
        assert!((found / one - 1.0).abs() < 1e-10, "{scale}: {found} {one}");
    }
}

#[test]
fn narrow_gaps_between_pools_decide_though_a_million_million_times_tighter() {
    let (rows, columns) = (96, 128);
    let mut gaps_m = pressed_like(rows, columns, 0.05, 9);
    for (at, gap_m) in gaps_m.iter_mut().enumerate() {
        // Two bars across the flow; contact but for one point.
        *gap_m = match (at / columns, at % columns) {
            (17, 40 | 100) => 1e-4,
            (_, 40 | 100) => 0.0,
            _ => gap_m.max(0.5),
        };
    }
    let mean_m = gaps_m.iter().sum::<f64>() / (rows * columns) as f64;
    let gap = GapField::new(grid(rows, columns), &gaps_m).unwrap();
    // Rounding leaves the direct solution 7 % off, and its corrections may not end: no factor is better than a wrong one.
    let direct = solve_by(Method::Direct, &gap, FlowDirection::X, Ends::Periodic, &Unobserved);
    let iterative =
        factor_by(Method::Iterative, grid(rows, columns), &gaps_m, FlowDirection::X, Ends::Periodic);
    let is_right = direct.as_ref().is_ok_and(|flow| (flow.flow_factor / iterative - 1.0).abs() < 1e-8);
    assert!(is_right || direct == Err(FlowError::Stalled));
    let found =
        solve(&gap, FlowDirection::X, Ends::Periodic, &Unobserved).unwrap().flow_factor * mean_m.powi(3);
    // Two ties of twice the conductance of a narrow point lead through each; the pools have no resistance.
    let expected = 1e-12 / 2.0 * columns as f64 / rows as f64;
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
}

#[test]
fn fields_without_any_smoothness_converge() {
    let mut state = 1u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for (rows, columns) in [(1, 200), (200, 1), (2, 150), (31, 37), (64, 64), (150, 97)] {
        for decades in [0.0, 1.0, 2.0, 4.0] {
            for closed in [0.0, 0.1, 0.3] {
                let gaps_m: Vec<f64> = (0..rows * columns)
                    .map(|_| if random() < closed { 0.0 } else { 10f64.powf(-decades * random()) })
                    .collect();
                let gap = GapField::new(grid(rows, columns), &gaps_m).unwrap();
                for (direction, ends) in BOTH.into_iter().zip(ALL_ENDS) {
                    let flow = solve(&gap, direction, ends, &Unobserved).unwrap();
                    let other = factor_by(Method::Iterative, grid(rows, columns), &gaps_m, direction, ends);
                    let case = format!("{rows} {columns} {decades} {closed} {direction:?}");
                    assert!((flow.flow_factor - other).abs() <= 1e-8 * other, "{case}: {flow:?} {other}");
                }
            }
        }
    }
}

#[test]
fn points_far_closer_along_one_side_leave_the_factor_exact() {
    let gaps_m = pressed_like(90, 90, 0.2, 3);
    for ratio in [1e-4, 1e-2, 1e2, 1e4] {
        let grid = Grid::new(90, 90, 1.0, ratio).unwrap();
        for (direction, ends) in BOTH.into_iter().zip(ALL_ENDS) {
            let [direct, iterative] =
                METHODS.map(|method| flow_by(method, grid, &gaps_m, direction, ends).flow_factor);
            assert!((iterative / direct - 1.0).abs() < 1e-9, "{ratio} {direction:?}: {iterative} {direct}");
        }
    }
}

#[test]
fn isotropic_log_normal_conductances_have_their_geometric_mean() {
    // Dykhne (1971), by duality; the mean of eight fields.
    for deviation in [0.5, 1.0] {
        let points = 256;
        let mut sum = 0.0;
        for seed in 0..8 {
            let heights = heights(points, 0.25, 8.0 / points as f64, 100 + seed);
            let gaps_m: Vec<f64> = heights.iter().map(|height| (deviation / 3.0 * height).exp()).collect();
            let mean_m = gaps_m.iter().sum::<f64>() / gaps_m.len() as f64;
            let grid = Grid::new(points, points, 1.0, 1.0).unwrap();
            sum += factor(grid, &gaps_m, FlowDirection::X, Ends::Periodic) * mean_m.powi(3) / 8.0;
        }
        assert!((sum - 1.0).abs() < 0.03, "{deviation}: {sum}");
    }
}

#[test]
fn the_error_of_the_spacing_is_that_to_a_finer_field() {
    let points = 256;
    let heights = heights(points, 0.25, 1.0 / 16.0, 3);
    let gaps_m: Vec<f64> = heights.iter().map(|height| (height + 0.8).max(0.0).powf(1.5)).collect();
    let on = |step: usize| -> (f64, f64) {
        let side = points / step;
        let coarse: Vec<f64> =
            (0..side * side).map(|at| gaps_m[at / side * step * points + at % side * step]).collect();
        let gap = GapField::new(Grid::new(side, side, 1.0, 1.0).unwrap(), &coarse).unwrap();
        let flow = solve(&gap, FlowDirection::X, Ends::Periodic, &Unobserved).unwrap();
        let error = spacing_error(flow.flow_factor, &gap, FlowDirection::X, Ends::Periodic, &Unobserved);
        let through = gap.mean_gap_m().powi(3);
        (flow.flow_factor * through, error.unwrap().unwrap() * through)
    };
    let (fine, _) = on(1);
    let (coarse, error) = on(4);
    assert!((coarse - fine).abs() < error && error < 4.0 * (coarse - fine).abs(), "{fine} {coarse} {error}");
    // No error without contact or variation; none known of three points.
    let slot = GapField::new(grid(8, 9), vec![1e-6; 72]).unwrap();
    let error = spacing_error(1.0, &slot, FlowDirection::Y, Ends::Reservoirs, &Unobserved).unwrap().unwrap();
    assert!(error < 1e-12);
    let line = GapField::new(grid(3, 9), vec![1e-6; 27]).unwrap();
    assert_eq!(spacing_error(1.0, &line, FlowDirection::Y, Ends::Reservoirs, &Unobserved).unwrap(), None);
}

#[test]
fn an_observer_sees_all_steps_and_may_cancel() {
    struct Observer {
        seen: std::sync::atomic::AtomicUsize,
        most: usize,
    }
    impl Progress for Observer {
        fn advance(&self, steps: usize) {
            self.seen.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
        }
        fn is_cancelled(&self) -> bool {
            self.seen.load(std::sync::atomic::Ordering::Relaxed) >= self.most
        }
    }
    let gaps_m = pressed_like(80, 80, 0.2, 1);
    let gap = GapField::new(grid(80, 80), &gaps_m).unwrap();
    for method in METHODS {
        let observer = Observer { seen: 0.into(), most: usize::MAX };
        solve_by(method, &gap, FlowDirection::X, Ends::Periodic, &observer).unwrap();
        assert_eq!(observer.seen.into_inner(), PROGRESS_STEPS);
        let observer = Observer { seen: 0.into(), most: 0 };
        let ended = solve_by(method, &gap, FlowDirection::X, Ends::Periodic, &observer);
        assert_eq!(ended.unwrap_err(), FlowError::Cancelled);
    }
    let observer = Observer { seen: 0.into(), most: 40 };
    let ended = solve_by(Method::Iterative, &gap, FlowDirection::X, Ends::Periodic, &observer);
    assert_eq!(ended.unwrap_err(), FlowError::Cancelled);
}
