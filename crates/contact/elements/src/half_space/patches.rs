//! Contact patches: connected regions of a map of contact.

use crate::half_space::area::PERIMETER_SHARE;
use crate::half_space::{Grid, HalfSpaceError};

/// Connected region of points in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Number of points.
    pub points: usize,
    /// Area of these points \[m^2\].
    pub area_m2: f64,
    /// Area less the contribution of the staircase at its outline, as the corrected area fraction leaves it out \[m^2\].
    pub area_corrected_m2: f64,
    /// Length of their sides that face open points, or a free edge of the map \[m\]. An outline without preferred
    /// direction is shorter by pi/4, since sides run along rows and columns.
    pub perimeter_m: f64,
}

/// Column and row of each point of a patch.
pub type Places = Vec<[i32; 2]>;

/// Finds the patches of a map of contact, row by row, the largest first. Points belong together if one is beside the
/// other in a row or a column; points that meet at a corner are apart. With `is_periodic` edges a patch goes on at the
/// opposite edge.
///
/// # Errors
/// [`HalfSpaceError`] for a map of another size than the grid.
pub fn patches(grid: &Grid, is_periodic: bool, is_contact: &[bool]) -> Result<Vec<Patch>, HalfSpaceError> {
    Ok(patches_with_places(grid, is_periodic, is_contact)?.into_iter().map(|(patch, _)| patch).collect())
}

/// Finds the patches of [`patches`] with the places of their points, each a column and a row. The places of a patch that goes on at
/// the opposite edge of a periodic map run on beyond the edge.
///
/// # Errors
/// [`HalfSpaceError`] for a map of another size than the grid.
pub fn patches_with_places(
    grid: &Grid,
    is_periodic: bool,
    is_contact: &[bool],
) -> Result<Vec<(Patch, Places)>, HalfSpaceError> {
    grid.check_size(is_contact.len())?;
    let (rows, columns) = (grid.rows(), grid.columns());
    let (step_x_m, step_y_m) = (grid.length_x_m() / columns as f64, grid.length_y_m() / rows as f64);
    let mut is_counted = vec![false; is_contact.len()];
    let mut found = Vec::new();
    // Points of the patch whose neighbours have not been visited.
    let mut front = Vec::new();
    for first in (0..is_contact.len()).filter(|&at| is_contact[at]) {
        if std::mem::replace(&mut is_counted[first], true) {
            continue;
        }
        front.push((first, [(first % columns) as i32, (first / columns) as i32]));
        let (mut places, mut sides_x, mut sides_y) = (Vec::new(), 0usize, 0usize);
        while let Some((at, place)) = front.pop() {
            places.push(place);
            let (row, column) = (at / columns, at % columns);
            let beside = neighbours(column, columns, is_periodic)
                .map(|side| side.map(|column| row * columns + column));
            let above = neighbours(row, rows, is_periodic).map(|side| side.map(|row| row * columns + column));
            let steps = [[-1, 0], [1, 0], [0, -1], [0, 1]];
            for (next, step) in beside.into_iter().chain(above).zip(steps) {
                match next.filter(|&next| is_contact[next]) {
                    Some(next) if is_counted[next] => {}
                    Some(next) => {
                        is_counted[next] = true;
                        front.push((next, [place[0] + step[0], place[1] + step[1]]));
                    }
                    // A side towards a neighbour in the row runs along y.
                    None => *(if step[1] == 0 { &mut sides_y } else { &mut sides_x }) += 1,
                }
            }
        }
        let (points, sides) = (places.len() as f64, (sides_x + sides_y) as f64);
        let staircase = if grid.is_line() { 0.0 } else { PERIMETER_SHARE * sides };
        let patch = Patch {
            points: places.len(),
            area_m2: points * step_x_m * step_y_m,
            area_corrected_m2: (points - staircase) * step_x_m * step_y_m,
            perimeter_m: sides_x as f64 * step_x_m + sides_y as f64 * step_y_m,
        };
        found.push((patch, places));
    }
    found.sort_by_key(|(patch, _)| std::cmp::Reverse(patch.points));
    Ok(found)
}

/// Both neighbours of a place in a row of `count`; `None` beyond an edge that does not close.
fn neighbours(at: usize, count: usize, is_periodic: bool) -> [Option<usize>; 2] {
    let before = at.checked_sub(1).or(is_periodic.then_some(count - 1));
    let after = if at + 1 < count { Some(at + 1) } else { is_periodic.then_some(0) };
    [before, after]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Patches of a map drawn with `#` for contact, on points of 2 m along x and 3 m along y: points and perimeter.
    fn found(map: &[&str], is_periodic: bool) -> Vec<(usize, f64)> {
        let grid =
            Grid::new(map.len(), map[0].len(), 2.0 * map[0].len() as f64, 3.0 * map.len() as f64).unwrap();
        let is_contact: Vec<bool> = map.concat().chars().map(|point| point == '#').collect();
        let found = patches(&grid, is_periodic, &is_contact).unwrap();
        assert!(found.iter().all(|patch| (patch.area_m2 - 6.0 * patch.points as f64).abs() < 1e-12));
        found.iter().map(|patch| (patch.points, patch.perimeter_m)).collect()
    }

    #[test]
    fn a_point_has_four_sides_and_corners_do_not_connect() {
        assert_eq!(found(&["....", ".#..", "..#."], true), [(1, 10.0), (1, 10.0)]);
        assert_eq!(found(&["....", ".##.", "...."], true), [(2, 14.0)]);
        assert_eq!(found(&["....", "....", "...."], true), []);
    }

    #[test]
    fn the_largest_comes_first_and_holes_have_a_perimeter() {
        let map = ["#......", "..###..", "..#.#..", "..###..", "......."];
        // The ring: outline 2 (3 x 2 + 3 x 3) m, hole 2 (2 + 3) m.
        assert_eq!(found(&map, true), [(8, 40.0), (1, 10.0)]);
    }

    #[test]
    fn patches_go_on_at_the_opposite_edge_of_a_periodic_map_alone() {
        let map = ["#..#", "....", "#..#"];
        assert_eq!(found(&map, true), [(4, 20.0)]);
        assert_eq!(found(&map, false), [(1, 10.0); 4]);
        // A stripe around the map has two sides, and complete contact none; free edges are sides.
        assert_eq!(found(&["....", "####", "...."], true), [(4, 16.0)]);
        assert_eq!(found(&["....", "####", "...."], false), [(4, 22.0)]);
        assert_eq!(found(&["##", "##"], true), [(4, 0.0)]);
        assert_eq!(found(&["##", "##"], false), [(4, 20.0)]);
    }

    #[test]
    fn a_spiral_is_one_patch() {
        let map = ["#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"];
        assert_eq!(found(&map, false).len(), 1);
        // Its first row and its first column meet their opposites in a periodic map, and remain one patch.
        assert_eq!(found(&map, true).len(), 1);
    }

    #[test]
    fn a_map_of_another_size_is_refused() {
        let grid = Grid::new(2, 2, 1.0, 1.0).unwrap();
        let refused = patches(&grid, true, &[true]).unwrap_err();
        assert!(matches!(refused, HalfSpaceError::Size { given: 1, expected: 4 }));
    }
}
