//! Seconds for maps of many spots, on one thread: 10,000 on a periodic map take 2.4 s of processor time and 200 MB.

use std::time::Instant;

use elements::Boundary;
use elements::half_space::Grid;
use interface::conductance::Resistivities;
use transport::spots::{SpotConduction, Spots};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for per_side in [20, 40, 70, 100] {
            let points = per_side * 10;
            let grid = Grid::new(points, points, 1.0, 1.0)?;
            let mut is_contact = vec![false; points * points];
            // One spot of 1 to 9 points in each cell of 10 by 10, at a place that looks random.
            for cell in 0..per_side * per_side {
                let (row, column) = (cell / per_side * 10, cell % per_side * 10);
                let turn = (cell as f64 * 0.618_033_988_75).fract();
                let size = 1 + cell % 3;
                let (below, beside) = ((turn * 7.0) as usize, ((turn * 1e4).fract() * 7.0) as usize);
                for point in 0..size * size {
                    is_contact[(row + below + point / size) * points + column + beside + point % size] = true;
                }
            }
            let conduction = SpotConduction::new(Resistivities::new(1e-8, 1e-8)?);
            let start = Instant::now();
            let found = Spots::solve(&grid, boundary, &is_contact, 1.0, &conduction)?;
            println!(
                "{boundary}: {} spots, {} discs, {:.2} s, {:.6e} ohm",
                found.spots.len(),
                found.discs,
                start.elapsed().as_secs_f64(),
                found.resistance_ohm
            );
        }
    }
    Ok(())
}
