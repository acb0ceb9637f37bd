//! Channels through which a fluid crosses a contact.

use crate::half_space::{Grid, HalfSpaceError};

/// Directions in which the open part of a map connects its opposite edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenPaths {
    /// True if a path leads from the first column to the last.
    pub along_x: bool,
    /// True if a path leads from the first row to the last.
    pub along_y: bool,
}

/// Boundary at the sides of a channel, the edges that a path does not connect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The opposite side of the map, which repeats itself.
    Periodic,
    /// Walls, which no fluid passes.
    Walls,
}

/// Finds the paths across a map of contact, row by row. A fluid goes from a point to the next in its row or column,
/// not across corners: two points of contact that meet at a corner are tight. Paths begin at one edge and end at the
/// opposite one without wrapping around; every point is visited once in each direction.
///
/// # Errors
/// [`HalfSpaceError`] for a map of another size than the grid.
pub fn open_paths(grid: &Grid, sides: Sides, is_contact: &[bool]) -> Result<OpenPaths, HalfSpaceError> {
    grid.check_size(is_contact.len())?;
    let (rows, columns) = (grid.rows(), grid.columns());
    let is_open = |row: usize, column: usize| !is_contact[row * columns + column];
    Ok(OpenPaths {
        along_x: crosses(columns, rows, sides, |along, across| is_open(across, along)),
        along_y: crosses(rows, columns, sides, is_open),
    })
}

/// Returns true if open points connect the first of `length` places along a channel, `breadth` places wide, with the
/// last.
fn crosses(length: usize, breadth: usize, sides: Sides, is_open: impl Fn(usize, usize) -> bool) -> bool {
    let mut is_reached = vec![false; length * breadth];
    // Points whose neighbours have not been visited.
    let mut front: Vec<(usize, usize)> = Vec::new();
    let mut reach = |along: usize, across: usize, front: &mut Vec<(usize, usize)>| {
        let reached = &mut is_reached[along * breadth + across];
        if !*reached && is_open(along, across) {
            *reached = true;
            front.push((along, across));
        }
    };
    (0..breadth).for_each(|across| reach(0, across, &mut front));
    while let Some((along, across)) = front.pop() {
        if along + 1 == length {
            return true;
        }
        reach(along + 1, across, &mut front);
        if along > 0 {
            reach(along - 1, across, &mut front);
        }
        match sides {
            Sides::Periodic => {
                reach(along, (across + 1) % breadth, &mut front);
                reach(along, (across + breadth - 1) % breadth, &mut front);
            }
            Sides::Walls => {
                if across + 1 < breadth {
                    reach(along, across + 1, &mut front);
                }
                if across > 0 {
                    reach(along, across - 1, &mut front);
                }
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paths across a map in which contact is `#`.
    fn paths(rows: &[&str], sides: Sides) -> OpenPaths {
        let grid = Grid::new(rows.len(), rows[0].len(), 1.0, 1.0).unwrap();
        let is_contact: Vec<bool> = rows.iter().flat_map(|row| row.bytes().map(|c| c == b'#')).collect();
        open_paths(&grid, sides, &is_contact).unwrap()
    }

    fn both(rows: &[&str]) -> [(bool, bool); 2] {
        [Sides::Periodic, Sides::Walls].map(|sides| {
            let paths = paths(rows, sides);
            (paths.along_x, paths.along_y)
        })
    }

    #[test]
    fn stripes_are_open_along_themselves() {
        assert_eq!(both(&["####", "....", "####", "...."]), [(true, false); 2]);
        assert_eq!(both(&["#.#.", "#.#.", "#.#."]), [(false, true); 2]);
        assert_eq!(both(&["....", "....", "...."]), [(true, true); 2]);
        assert_eq!(both(&["####", "####", "####"]), [(false, false); 2]);
        assert_eq!(both(&["#.#"]), [(false, true); 2]);
    }

    #[test]
    fn corners_are_shut() {
        assert_eq!(both(&[".#.#", "#.#.", ".#.#", "#.#."]), [(false, false); 2]);
        // A diagonal of contact separates two corners; a fluid gets past it only around the sides.
        assert_eq!(both(&["#...", ".#..", "..#.", "...#"]), [(true, true), (false, false)]);
        // Two points wide, a diagonal channel is open.
        assert_eq!(both(&["..##", "#..#", "##..", ".##."]), [(true, true); 2]);
    }

    #[test]
    fn a_path_may_turn_back_and_around_the_sides_but_not_around_its_ends() {
        assert_eq!(both(&["..#...", "#.#.#.", "#...#."])[1], (true, true));
        let winding = ["...###", "##.#..", "#..#.#", "#.##.#", "#....#", "######"];
        assert_eq!(both(&winding), [(true, false); 2]);
        // Across the seam between the last row and the first.
        assert_eq!(both(&["##..", "####", "..##"]), [(false, false); 2]);
        assert_eq!(both(&["##..", "####", "...#"]), [(true, false), (false, false)]);
    }

    #[test]
    fn turning_a_map_turns_its_paths() {
        // A third of the points of this multiplicative sequence are in contact.
        let side = 41;
        for seed in 1..40usize {
            let is_contact =
                |row: usize, column: usize| ((row * side + column + 1) * seed * 2_654_435_761) % 4093 < 1500;
            let grid = Grid::new(side, side, 1.0, 1.0).unwrap();
            let points = |turned: bool| -> Vec<bool> {
                let at = |k: usize| (k / side, k % side);
                (0..side * side)
                    .map(at)
                    .map(|(i, j)| if turned { is_contact(j, i) } else { is_contact(i, j) })
                    .collect()
            };
            for sides in [Sides::Periodic, Sides::Walls] {
                let [one, other] =
                    [false, true].map(|turned| open_paths(&grid, sides, &points(turned)).unwrap());
                assert_eq!((one.along_x, one.along_y), (other.along_y, other.along_x));
            }
        }
    }

    #[test]
    fn a_map_of_another_size_is_refused() {
        let grid = Grid::new(2, 3, 1.0, 1.0).unwrap();
        let error = open_paths(&grid, Sides::Walls, &[true; 5]).unwrap_err();
        assert_eq!(error, HalfSpaceError::Size { given: 5, expected: 6 });
    }
}
